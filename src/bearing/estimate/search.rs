//! The balls whose ratings come closest to the printed ones.

use super::checks::FACTOR_TOLERANCE;
use super::rating::REFERENCE_GROOVES;
use super::{Candidate, CatalogueLine, EstimateError};
use crate::bearing::Geometry;
use crate::physics::dynamic_rating;

/// Largest ball over the height of the section (D_o − d)/2.
const LARGEST_BALL: f64 = 0.8;

/// Largest deviation of a candidate, |C/C_printed − 1| + |C0/C0_printed − 1|, that is taken for the bearing.
const LARGEST_DEVIATION: f64 = 0.04;

/// Two candidates whose deviations differ by less cannot be told apart.
const AMBIGUOUS: f64 = 0.005;

impl CatalogueLine {
    /// The balls that fit best, and those that fit next to them.
    pub(super) fn search(
        &self,
        pitch: f64,
    ) -> Result<(Candidate, Option<Candidate>), EstimateError> {
        let statical = self.static_rating.ok_or(EstimateError::NoStaticRating)?;
        let largest = LARGEST_BALL * 0.5 * (self.outside_diameter - self.bore);
        let mut best: Vec<Candidate> = Vec::new();
        let sizes = || ball_sizes().filter(|size| *size <= largest).collect();
        let diameters: Vec<f64> = self.ball_diameter.map_or_else(sizes, |given| vec![given]);
        for diameter in diameters {
            let most = Geometry::most_balls(diameter, pitch);
            let numbers = self.balls.map_or(Geometry::FEWEST_BALLS..=most, |n| n..=n);
            for balls in numbers.filter(|balls| *balls <= most.min(Geometry::MOST_BALLS)) {
                let rating = dynamic_rating(balls, diameter, pitch, self.contact_angle);
                // the contacts of balls that are far off are not worth their time
                if (rating / self.dynamic_rating - 1.0).abs() > 0.25 {
                    continue;
                }
                best.push(self.candidate(balls, diameter, pitch));
            }
        }
        best.sort_by(|a, b| a.deviation.total_cmp(&b.deviation));
        let fits = |candidate: &Candidate| candidate.deviation <= LARGEST_DEVIATION;
        let mut agreeing = best.iter().copied().filter(|balls| self.agrees(balls));
        match (agreeing.next().filter(fits), agreeing.next()) {
            (Some(best), Some(other)) if other.deviation - best.deviation < AMBIGUOUS => {
                Err(EstimateError::Ambiguous { best, other })
            }
            (Some(first), _) => Ok((first, best.iter().copied().find(|other| *other != first))),
            (None, _) => Err(
                match (best.first().copied().filter(fits), self.static_factor) {
                    (Some(closest), Some(printed)) => {
                        let found = self.static_factor_of(closest.balls, closest.ball_diameter);
                        EstimateError::Factor {
                            closest,
                            found: found.unwrap_or(f64::NAN),
                            printed,
                        }
                    }
                    _ => EstimateError::Impossible {
                        dynamic: self.dynamic_rating,
                        statical,
                        closest: best.first().copied(),
                    },
                },
            ),
        }
    }

    /// Whether the f0 of the balls is that of the print, where there is one.
    pub(super) fn agrees(&self, candidate: &Candidate) -> bool {
        let found = self.static_factor_of(candidate.balls, candidate.ball_diameter);
        let pair = found.zip(self.static_factor);
        pair.is_none_or(|(found, printed)| (found - printed).abs() <= FACTOR_TOLERANCE)
    }

    pub(super) fn candidate(&self, balls: usize, ball_diameter: f64, pitch: f64) -> Candidate {
        let dynamic_rating = dynamic_rating(balls, ball_diameter, pitch, self.contact_angle);
        let static_rating = self.static_rating_of(balls, ball_diameter, pitch, REFERENCE_GROOVES);
        let off = |found: f64, printed: f64| (found / printed - 1.0).abs();
        let statical = self.static_rating.map_or(0.0, |c0| off(static_rating, c0));
        Candidate {
            balls,
            ball_diameter,
            dynamic_rating,
            static_rating,
            deviation: off(dynamic_rating, self.dynamic_rating) + statical,
        }
    }
}

/// Diameters that balls are made in, m: steps of 1/32 in to 4 in, and 15/64 and 17/64 in.
fn ball_sizes() -> impl Iterator<Item = f64> {
    const INCH: f64 = 0.0254;
    let steps = (1..=128).map(|step| f64::from(step) / 32.0);
    let others = [15.0 / 64.0, 17.0 / 64.0];
    steps.chain(others).map(|inches| inches * INCH)
}
