//! How well values are known that were fitted: standard errors, what the data cannot tell, other minima, profiles.

use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ChiSquared, ContinuousCDF};

use super::problem::{Place, Problem};
use super::{Effort, NoAnswer, Number, Point};
use crate::steady::Orbit;

/// Minima nearer than this part of the ranges in every unknown are one, as are those nearer than this part of the standard errors.
const SAME: f64 = 1e-3;
const WITHIN: f64 = 0.3;
/// Places of a profile, in standard errors from the minimum.
const PROFILE: [f64; 4] = [-2.0, -1.0, 1.0, 2.0];
/// What a standard error counts as that is beyond the range: the range.
const WIDEST: f64 = 1.0;
/// Part of a direction from which on an unknown is named as a part of it.
const NAMED: f64 = 0.05;

/// Values that explain what was measured, and how well they are known.
#[derive(Debug, Clone)]
pub struct Fit {
    /// The values.
    pub values: Vec<f64>,
    /// Their standard errors, at most the range.
    pub errors: Vec<f64>,
    /// Whether each is at a bound.
    pub at_bound: Vec<bool>,
    /// Correlations of the values.
    pub correlations: DMatrix<f64>,
    /// Combinations of unknowns that the observations do not tell.
    pub unidentified: Vec<Unidentified>,
    /// Numbers at the values, one an observation.
    pub computed: Vec<Number>,
    /// The motion of every question that has one.
    pub orbits: Vec<Option<Orbit>>,
    /// Differences from what was measured, in standard deviations.
    pub residuals: Vec<f64>,
    /// Sum of their squares.
    pub chi_square: f64,
    /// Observations less unknowns.
    pub freedoms: usize,
    /// How likely chance alone makes χ² as large as that; none where no standard deviations are given or nothing is left over.
    pub probability: Option<f64>,
    /// Standard deviation of all observations, in parts of what was measured, where none are given: from the residuals.
    pub estimated_sigma: Option<f64>,
    /// Minima that were found, the lowest first.
    pub minima: Vec<Minimum>,
    /// χ² around the minimum.
    pub profiles: Vec<Profile>,
    /// Whether it came to its end.
    pub is_complete: bool,
}

/// A place where χ² is least around.
#[derive(Debug, Clone, PartialEq)]
pub struct Minimum {
    /// The values.
    pub values: Vec<f64>,
    /// χ² there.
    pub chi_square: f64,
    /// Starts that lead there.
    pub starts: usize,
}

/// A combination of unknowns that the observations do not tell.
#[derive(Debug, Clone, PartialEq)]
pub struct Unidentified {
    /// Its unknowns, and by how much they change together, in their units; the first by its whole range.
    pub parts: Vec<(usize, f64)>,
}

/// The least χ² at values of one unknown.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// Which unknown.
    pub unknown: usize,
    /// Its values, and how much larger χ² is there.
    pub points: Vec<[f64; 2]>,
}

/// What is found around a minimum.
enum Around {
    /// The numbers there with their errors.
    Exact(Point),
    /// A point of the profile of an unknown.
    Profile(usize, [f64; 2]),
}

impl Problem<'_> {
    /// The values that explain what was measured, and how well they are known.
    ///
    /// # Errors
    /// [`NoAnswer`] where no start has an answer.
    pub fn fit(&self) -> Result<Fit, NoAnswer> {
        let places = self.lowest()?;
        let best = &places[0];
        let values = self.values(&best.shares);
        let mut fit = Fit {
            computed: best.point.numbers.clone(),
            orbits: best.point.orbits.clone(),
            residuals: best.residuals.iter().copied().collect(),
            chi_square: best.chi_square(),
            freedoms: self.observations.len().saturating_sub(self.unknowns.len()),
            probability: None,
            estimated_sigma: None,
            errors: vec![f64::NAN; values.len()],
            at_bound: self.at_bound(best),
            correlations: DMatrix::zeros(0, 0),
            unidentified: Vec::new(),
            minima: self.minima(&places),
            profiles: Vec::new(),
            is_complete: best.is_lowest,
            values,
        };
        if self.judge(&mut fit, best) == Err(NoAnswer::Stopped) {
            fit.is_complete = false;
        }
        Ok(fit)
    }

    fn judge(&self, fit: &mut Fit, best: &Place) -> Result<(), NoAnswer> {
        let scale = self.deviation(fit.chi_square);
        match self.has_deviations() {
            true => fit.probability = probability(fit.chi_square, fit.freedoms),
            false => fit.estimated_sigma = Some(scale),
        }
        let jacobian = best.slopes.clone().ok_or(NoAnswer::Stopped)?;
        let covariance = self.covariance(fit, &(&jacobian / scale));
        let errors = covariance.diagonal().map(f64::sqrt);
        fit.correlations = DMatrix::from_fn(errors.len(), errors.len(), |row, column| {
            covariance[(row, column)] / (errors[row] * errors[column])
        });
        let unknowns = self.unknowns.iter().zip(errors.iter());
        fit.errors = unknowns
            .map(|(unknown, error)| error.min(WIDEST) * unknown.length())
            .collect();
        self.look_around(fit, best, (&jacobian, &covariance))
    }

    /// Standard deviation of the residuals: 1 where those of the observations are known, else what their squares leave.
    fn deviation(&self, chi_square: f64) -> f64 {
        let freedoms = self.observations.len().saturating_sub(self.unknowns.len());
        match self.has_deviations() {
            true => 1.0,
            // what fits to round-off has no errors of its own
            false => (chi_square / freedoms.max(1) as f64)
                .sqrt()
                .max(f64::EPSILON),
        }
    }

    /// Which unknowns are at a bound.
    fn at_bound(&self, best: &Place) -> Vec<bool> {
        let pairs = self.unknowns.iter().zip(best.shares.iter());
        pairs
            .map(|(unknown, share)| !unknown.wraps && (*share == 0.0 || *share == 1.0))
            .collect()
    }

    /// Covariance of the shares, `(JᵀJ)⁻¹ = V Σ⁻² Vᵀ` by the singular values of J; where one is so small that its direction is not
    /// known within the ranges, or is round-off, the direction is noted and counts as known to its range.
    fn covariance(&self, fit: &mut Fit, jacobian: &DMatrix<f64>) -> DMatrix<f64> {
        let count = self.unknowns.len();
        let rows = jacobian.nrows().max(count);
        // as many singular values as unknowns
        let decomposed = jacobian
            .clone()
            .resize_vertically(rows, 0.0)
            .svd(false, true);
        let round_off = f64::EPSILON * rows as f64 * decomposed.singular_values.max();
        let mut covariance = DMatrix::zeros(count, count);
        let Some(directions) = decomposed.v_t else {
            return covariance;
        };
        for (size, direction) in decomposed.singular_values.iter().zip(directions.row_iter()) {
            let direction = direction.transpose();
            let deviation = match *size > round_off {
                true => size.recip().min(WIDEST),
                false => WIDEST,
            };
            if deviation == WIDEST {
                fit.unidentified.push(self.unidentified(&direction));
            }
            covariance += deviation.powi(2) * &direction * direction.transpose();
        }
        covariance
    }

    fn unidentified(&self, direction: &DVector<f64>) -> Unidentified {
        let mut parts: Vec<(usize, f64)> = direction.iter().copied().enumerate().collect();
        parts.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        let largest = parts[0].1;
        parts.retain(|(_, part)| (part / largest).abs() >= NAMED);
        for (k, part) in &mut parts {
            *part *= self.unknowns[*k].length() / largest;
        }
        Unidentified { parts }
    }

    /// Places that are not the same, each with the number of starts that lead there.
    fn minima(&self, places: &[Place]) -> Vec<Minimum> {
        let mut found: Vec<(&Place, usize)> = Vec::new();
        let deviation = self.deviation(places[0].chi_square());
        // the values that are reported are the first, even of a search that was stopped
        let reported = places.iter().enumerate();
        let reported = reported.filter(|(index, place)| *index == 0 || place.is_lowest);
        for (_, place) in reported {
            let same = |(other, _): &&mut (&Place, usize)| {
                let apart = self.apart(&place.shares, &other.shares);
                let slopes = other.slopes.as_ref();
                let foreseen = slopes.map_or(f64::INFINITY, |slopes| (slopes * &apart).norm());
                apart.amax() < SAME || foreseen < WITHIN * deviation
            };
            match found.iter_mut().find(same) {
                Some((_, starts)) => *starts += 1,
                None => found.push((place, 1)),
            }
        }
        let reported = |(place, starts): (&Place, usize)| Minimum {
            values: self.values(&place.shares),
            chi_square: place.chi_square(),
            starts,
        };
        found.into_iter().map(reported).collect()
    }

    /// The least χ² at values of every unknown around the minimum, each searched from where the covariance expects it; beside it
    /// the numbers there with their errors.
    fn look_around(
        &self,
        fit: &mut Fit,
        best: &Place,
        (jacobian, covariance): (&DMatrix<f64>, &DMatrix<f64>),
    ) -> Result<(), NoAnswer> {
        let scale = self.deviation(best.chi_square());
        let count = PROFILE.len();
        let profile_point = |task: usize| {
            let (k, distance) = (task / count, PROFILE[task % count]);
            let along = covariance.column(k) / covariance[(k, k)].sqrt();
            let mut shares = &best.shares + along * distance;
            for (share, unknown) in shares.iter_mut().zip(self.unknowns) {
                *share = if unknown.wraps {
                    *share
                } else {
                    share.clamp(0.0, 1.0)
                };
            }
            let mut place = self.place(shares, Some(&best.point), Effort::Coarse)?;
            place.slopes = Some(jacobian.clone());
            let place = self.descend(place, Some(k), Effort::Coarse)?;
            let above = (place.chi_square() - best.chi_square()) / (scale * scale);
            Ok(Around::Profile(k, [self.values(&place.shares)[k], above]))
        };
        let tasks = 1 + count * self.unknowns.len();
        let found = self.work.all(tasks, |task| match task.checked_sub(1) {
            None => {
                let near = Some(&best.point);
                (self.scene)(&fit.values, near, Effort::Verified).map(Around::Exact)
            }
            Some(task) => profile_point(task),
        });
        let here = fit.values.iter().enumerate();
        let mut profiles: Vec<Profile> = here
            .map(|(unknown, value)| Profile {
                unknown,
                points: vec![[*value, 0.0]],
            })
            .collect();
        for one in found {
            match one {
                Some(Ok(Around::Exact(point))) => fit.computed = point.numbers,
                Some(Ok(Around::Profile(k, point))) => profiles[k].points.push(point),
                Some(Err(NoAnswer::Failed(_))) => {}
                None | Some(Err(NoAnswer::Stopped)) => return Err(NoAnswer::Stopped),
            }
        }
        for profile in &mut profiles {
            profile.points.sort_by(|a, b| a[0].total_cmp(&b[0]));
            profile.points.dedup_by(|a, b| a[0] == b[0]);
        }
        fit.profiles = profiles;
        Ok(())
    }
}

/// How likely chance makes χ² of so many freedoms at least as large.
fn probability(chi_square: f64, freedoms: usize) -> Option<f64> {
    let distribution = ChiSquared::new(freedoms as f64).ok()?;
    Some(distribution.sf(chi_square))
}
