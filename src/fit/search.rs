//! The values that explain what was measured: least squares by Levenberg and Marquardt between bounds, from several starts.

use nalgebra::{DMatrix, DVector};

use super::problem::{Place, Problem};
use super::{Effort, NoAnswer, Point};
use crate::study::plan::sobol;

/// Steps of a search before it is given up.
const MOST_STEPS: usize = 60;
/// Trials of a step that lead no lower before the place is taken for the lowest.
const MOST_TRIALS: usize = 8;
/// Damping of the first step, relative to the diagonal of JᵀJ.
const FIRST_DAMPING: f64 = 1e-3;
/// Factor by which the damping grows where a step leads up, and falls where it leads down.
const GROWTH: f64 = 8.0;
/// A step below this part of the ranges is the last.
const LEAST_STEP: f64 = 1e-10;
/// A step that is to lower χ² by less than this is the last.
const LEAST_GAIN: f64 = 1e-16;
/// A step of the search for the lowest place that is to lower χ² by less than this part of it is the last.
const FINE: f64 = 1e-8;
/// A step of a search that only finds which place is the lowest, and that is to lower χ² by less than this part, is the last.
const ROUGH: f64 = 1e-3;
/// Step of the differences of a search, in parts of the ranges.
const DIFFERENCE: f64 = 1e-4;

/// What a step of a search comes to.
enum Step {
    /// A place that is lower.
    Lower(Box<Place>),
    /// It is too small to count.
    Small,
    /// However short, it does not lead lower.
    Blocked,
}

impl Problem<'_> {
    /// The lowest place around another one, or with little effort one near it, with one of the unknowns held where one is named.
    /// Slopes that are known there are kept as long as they lead down.
    ///
    /// ```text
    /// (JᵀJ + λ diag JᵀJ) δ = −Jᵀr,   p ← p + δ, no further than to the bounds
    /// J ← J + (r' − r − Jδ) δᵀ/δᵀδ
    /// ```
    ///
    /// An unknown at a bound that the sum of squares falls beyond stays there. λ falls where a step leads down, and grows where
    /// it leads up or to no answer.
    ///
    /// Source: D. Marquardt, *SIAM J. Appl. Math.* 11 (1963) 431–441; C. Broyden, *Math. Comp.* 19 (1965) 577–593.
    ///
    /// # Errors
    /// [`NoAnswer::Failed`] where nothing around it has an answer.
    pub(super) fn descend(
        &self,
        mut here: Place,
        held: Option<usize>,
        effort: Effort,
    ) -> Result<Place, NoAnswer> {
        let (mut damping, mut known) = (FIRST_DAMPING, here.slopes.clone());
        // steps since the slopes were found by differences
        let mut steps = usize::MAX;
        for _ in 0..MOST_STEPS {
            let jacobian = match known.take() {
                Some(known) => known,
                None => match self.differences(&here, held, effort) {
                    Err(NoAnswer::Stopped) => return Ok(here),
                    found => {
                        steps = 0;
                        found?
                    }
                },
            };
            here.slopes = Some(jacobian.clone());
            let is_fresh = steps == 0;
            let next = match self.lower(&here, &jacobian, held, &mut damping, (is_fresh, effort)) {
                Err(NoAnswer::Stopped) => return Ok(here),
                next => next?,
            };
            match next {
                Step::Lower(next) => {
                    // Broyden's update: the least change by which the slopes explain the step
                    let step = self.apart(&next.shares, &here.shares);
                    let missed = &next.residuals - &here.residuals - &jacobian * &step;
                    known = Some(jacobian + missed * step.transpose() / step.norm_squared());
                    damping /= GROWTH;
                    steps = steps.saturating_add(1);
                    here = *next;
                    here.slopes.clone_from(&known);
                }
                // slopes of an earlier place may be at fault
                Step::Blocked if !is_fresh => {}
                Step::Small if steps > 1 && effort != Effort::Coarse => {}
                Step::Small | Step::Blocked => {
                    here.is_lowest = true;
                    return Ok(here);
                }
            }
        }
        Ok(here)
    }

    /// A step that leads lower by the slopes; a single trial where these are not fresh.
    fn lower(
        &self,
        here: &Place,
        jacobian: &DMatrix<f64>,
        held: Option<usize>,
        damping: &mut f64,
        (is_fresh, effort): (bool, Effort),
    ) -> Result<Step, NoAnswer> {
        let gradient = jacobian.tr_mul(&here.residuals);
        let free = self.free(&here.shares, &gradient, held);
        let jacobian = jacobian.select_columns(&free);
        let gradient = gradient.select_rows(&free);
        let normal = jacobian.tr_mul(&jacobian);
        for _ in 0..if is_fresh { MOST_TRIALS } else { 1 } {
            let mut damped = normal.clone();
            for k in 0..free.len() {
                damped[(k, k)] += *damping * normal[(k, k)] + f64::MIN_POSITIVE;
            }
            let step = damped.cholesky().map(|factors| -factors.solve(&gradient));
            let Some(step) = step else {
                *damping *= GROWTH;
                continue;
            };
            let foreseen = -step.dot(&(&gradient * 2.0 + &normal * &step));
            let least = self.least_gain(here.chi_square(), effort);
            if step.amax() < LEAST_STEP || foreseen < least {
                return Ok(Step::Small);
            }
            let mut shares = here.shares.clone();
            for (k, part) in free.iter().zip(step.iter()) {
                shares[*k] = self.unknowns[*k].inside(shares[*k] + part);
            }
            match self.place(shares, Some(&here.point), effort) {
                Err(NoAnswer::Stopped) => return Err(NoAnswer::Stopped),
                Ok(next) if next.chi_square() < here.chi_square() => {
                    return Ok(Step::Lower(Box::new(next)));
                }
                _ => *damping *= GROWTH,
            }
        }
        Ok(Step::Blocked)
    }

    /// What a step has to lower χ² by.
    fn least_gain(&self, chi_square: f64, effort: Effort) -> f64 {
        match effort {
            Effort::Coarse if self.has_deviations() => (ROUGH * chi_square).max(ROUGH),
            Effort::Coarse => (ROUGH * chi_square).max(LEAST_GAIN),
            _ => (FINE * chi_square).max(LEAST_GAIN),
        }
    }

    /// Unknowns that are not held, and not at a bound beyond which the sum of squares falls.
    fn free(
        &self,
        shares: &DVector<f64>,
        gradient: &DVector<f64>,
        held: Option<usize>,
    ) -> Vec<usize> {
        let is_free = |k: &usize| {
            let outwards = match shares[*k] {
                0.0 => gradient[*k] > 0.0,
                1.0 => gradient[*k] < 0.0,
                _ => false,
            };
            Some(*k) != held && (self.unknowns[*k].wraps || !outwards)
        };
        (0..self.unknowns.len()).filter(is_free).collect()
    }

    /// Slopes of the residuals by the shares: differences to one side, zero of what is held or has no answer on either side.
    fn differences(
        &self,
        here: &Place,
        held: Option<usize>,
        effort: Effort,
    ) -> Result<DMatrix<f64>, NoAnswer> {
        let mut jacobian = DMatrix::zeros(self.observations.len(), self.unknowns.len());
        for (k, unknown) in self.unknowns.iter().enumerate() {
            let there = |step: f64| {
                let mut shares = here.shares.clone();
                shares[k] += step;
                match unknown.wraps || (0.0..=1.0).contains(&shares[k]) {
                    true => self
                        .place(shares, Some(&here.point), effort)
                        .map(|place| (step, place)),
                    false => Err(NoAnswer::Failed(String::new())),
                }
            };
            if held == Some(k) {
                continue;
            }
            let found = match there(DIFFERENCE) {
                Err(NoAnswer::Failed(_)) => there(-DIFFERENCE),
                found => found,
            };
            match found {
                Ok((step, place)) => {
                    jacobian.set_column(k, &((place.residuals - &here.residuals) / step));
                }
                Err(NoAnswer::Stopped) => return Err(NoAnswer::Stopped),
                Err(NoAnswer::Failed(_)) => {}
            }
        }
        Ok(jacobian)
    }

    /// The lowest places around all starts, the lowest first: the first start is the given one, the others are spread evenly.
    ///
    /// # Errors
    /// [`NoAnswer`] of the first start, where no start has an answer.
    pub(super) fn lowest(&self) -> Result<Vec<Place>, NoAnswer> {
        let unknowns = self.unknowns.iter();
        let first = unknowns.map(|unknown| (unknown.start - unknown.range[0]) / unknown.length());
        let first = DVector::from_vec(first.collect());
        let from = |start: usize, near: Option<&Point>| {
            let shares = match start {
                0 => first.clone(),
                // the first two points of the sequence are 0 and the middle
                start => DVector::from_fn(first.len(), |axis, _| sobol(start as u64 + 1, axis)),
            };
            self.place(shares, near, Effort::Coarse)
        };
        // the others begin with motions near that of the first
        let first = from(0, None);
        let near = first.as_ref().ok().map(|place| &place.point);
        let found = self.work.all(self.starts.max(1), |start| {
            let start = match start {
                0 => first.clone(),
                start => from(start, near),
            };
            self.descend(start?, None, Effort::Coarse)
        });
        let mut places = Vec::new();
        let mut why = first.as_ref().err().cloned();
        for one in found.into_iter().flatten() {
            match one {
                Ok(place) => places.push(place),
                Err(error) => why = why.or(Some(error)),
            }
        }
        if places.is_empty() {
            places.extend(first.clone());
        }
        places.sort_by(|a, b| a.chi_square().total_cmp(&b.chi_square()));
        let Some(best) = places.first_mut() else {
            return Err(why.unwrap_or(NoAnswer::Stopped));
        };
        let exact = self.place(best.shares.clone(), Some(&best.point), Effort::Full);
        let exact = exact.and_then(|mut place| {
            place.slopes.clone_from(&best.slopes);
            self.descend(place, None, Effort::Full)
        });
        match exact {
            Ok(lowest) => *best = lowest,
            // stopped: the best so far
            Err(_) => best.is_lowest = false,
        }
        Ok(places)
    }
}
