//! The balls whose ratings come closest to the printed ones.

use super::checks::{is_usual_filling, is_usual_size};
use super::rating::REFERENCE_GROOVES;
use super::{Candidate, CatalogueLine, EstimateError};
use crate::bearing::Geometry;

/// Largest ball over the height of the section (D_o − d)/2.
const LARGEST_BALL: f64 = 0.8;

/// Largest share of the pitch circle, Z asin(D/d_m)/π, of balls that are looked for: it leaves a cage webs of a twelfth of a
/// ball. GMN prints spindle bearings with up to 0.863; deep-groove bearings that are filled by eccentric rings have up to 0.63.
const LARGEST_FILLING: f64 = 0.92;

/// C as makers print it over C by ISO 281: some rate their newer bearings higher.
const DYNAMIC_RATIO: [f64; 2] = [0.98, 1.10];

/// A C within this of ISO 281 speaks for the balls; any other within [`DYNAMIC_RATIO`] only says that its maker rates higher.
pub(super) const BY_ISO: f64 = 0.01;

/// Largest deviation of C_0 of balls or rollers that are taken for those of the bearing.
pub(super) const LARGEST_STATIC: f64 = 0.04;

/// Largest difference from a printed f0 beyond its rounding.
pub(super) const FACTOR_TOLERANCE: f64 = 0.2;

/// What balls too large or too many or too few for bearings as they are made, and rollers unlike theirs, have on top of
/// their deviation.
pub(super) const UNUSUAL: f64 = 0.05;

/// What balls of a rare size have on top of their deviation.
const RARE: f64 = 0.01;

/// Balls in inches that deviate by more may be metric ones.
const POOR: f64 = 0.03;

impl CatalogueLine {
    /// The balls that fit best, and all others that were looked at, the nearest first.
    pub(super) fn search(&self, pitch: f64) -> Result<(Candidate, Vec<Candidate>), EstimateError> {
        let statical = self.static_rating.ok_or(EstimateError::NoStaticRating)?;
        let agreeing = |found: &Vec<Candidate>| {
            let mut places = 0..found.len();
            places.find(|place| self.fits(&found[*place]) && self.agrees(&found[*place]))
        };
        let mut found = self.candidates(inch_sizes(), pitch);
        let is_poor = |place: Option<usize>, found: &[Candidate]| {
            place.is_none_or(|place| found[place].deviation > POOR)
        };
        if is_poor(agreeing(&found), &found) && self.ball_diameter.is_none() {
            found = self.candidates(inch_sizes().chain(metric_sizes()), pitch);
        }
        if let Some(place) = agreeing(&found) {
            return Ok((found.remove(place), found));
        }
        let closest = found.first().copied();
        let factor = found.iter().find(|found| self.fits(found));
        Err(match (factor, self.static_factor) {
            (Some(closest), Some(printed)) => EstimateError::Factor {
                closest: *closest,
                found: self
                    .static_factor_of(closest.balls, closest.ball_diameter)
                    .unwrap_or(f64::NAN),
                printed,
            },
            _ => EstimateError::Impossible {
                dynamic: self.dynamic_rating,
                statical,
                closest,
            },
        })
    }

    /// Balls of given sizes, the nearest first.
    fn candidates(&self, sizes: impl Iterator<Item = f64>, pitch: f64) -> Vec<Candidate> {
        let largest = LARGEST_BALL * self.section();
        let sizes = || sizes.filter(|size| *size <= largest).collect();
        let diameters: Vec<f64> = self.ball_diameter.map_or_else(sizes, |given| vec![given]);
        let mut found: Vec<Candidate> = Vec::new();
        for diameter in diameters {
            let most = Geometry::most_balls(diameter, pitch);
            let caged = Geometry::most_balls_filling(LARGEST_FILLING, diameter, pitch);
            let numbers = self.balls.map_or(Geometry::FEWEST_BALLS..=caged, |n| n..=n);
            for balls in numbers.filter(|balls| *balls <= most.min(Geometry::MOST_BALLS)) {
                let rating = self.dynamic_rating_of(balls, diameter, pitch, self.grooves());
                // the contacts of balls that are far off are not worth their time
                if (rating / self.dynamic_rating - 1.0).abs() <= 0.25 {
                    found.push(self.candidate(balls, diameter, pitch));
                }
            }
        }
        found.sort_by(|a, b| a.deviation.total_cmp(&b.deviation));
        found
    }

    /// Grooves that are given, or else those of reference.
    fn grooves(&self) -> [f64; 2] {
        self.groove_factors.unwrap_or(REFERENCE_GROOVES)
    }

    /// C_0 that a maker may print, N: of the grooves that are given, or, where these are narrower, of those of reference, as
    /// ISO 76 rates them; the one nearer to the print.
    fn rated_statically(&self, balls: usize, ball_diameter: f64, pitch: f64) -> f64 {
        let of = |grooves| self.static_rating_of(balls, ball_diameter, pitch, grooves);
        let grooves = self.grooves();
        let own = of(grooves);
        let rated = [0, 1].map(|race| grooves[race].max(REFERENCE_GROOVES[race]));
        if rated == grooves {
            return own;
        }
        let by_standard = of(rated);
        match self.static_deviation(own) < self.static_deviation(by_standard) {
            true => own,
            false => by_standard,
        }
    }

    /// How far a C_0 in N is from the print, where there is one.
    fn static_deviation(&self, rating: f64) -> f64 {
        self.static_rating
            .map_or(0.0, |printed| (rating / printed - 1.0).abs())
    }

    /// Height of the section, (D_o − d)/2, m.
    pub(super) fn section(&self) -> f64 {
        0.5 * (self.outside_diameter - self.bore)
    }

    /// Whether the ratings of the balls are those of the print.
    pub(super) fn fits(&self, candidate: &Candidate) -> bool {
        let statical = self.static_deviation(candidate.static_rating);
        statical <= LARGEST_STATIC && self.is_rated_usually(candidate.dynamic_rating)
    }

    /// Whether the printed C lies about an ISO 281 rating as those of makers do.
    pub(crate) fn is_rated_usually(&self, rating: f64) -> bool {
        is_rated_within([rating, self.dynamic_rating], DYNAMIC_RATIO)
    }

    /// How far the f0 of balls is from the print beyond what rounding explains: f0 is printed whole or with one decimal.
    pub(super) fn factor_excess(&self, balls: usize, ball_diameter: f64) -> Option<f64> {
        let found = self.static_factor_of(balls, ball_diameter)?;
        let printed = self.static_factor?;
        let rounding = if printed.fract() == 0.0 { 0.5 } else { 0.05 };
        Some(((found - printed).abs() - rounding).max(0.0))
    }

    /// Whether the f0 of the balls is that of the print, where there is one.
    pub(super) fn agrees(&self, candidate: &Candidate) -> bool {
        self.factor_excess(candidate.balls, candidate.ball_diameter)
            .is_none_or(|excess| excess <= FACTOR_TOLERANCE)
    }

    pub(super) fn candidate(&self, balls: usize, ball_diameter: f64, pitch: f64) -> Candidate {
        let dynamic_rating = self.dynamic_rating_of(balls, ball_diameter, pitch, self.grooves());
        let static_rating = self.rated_statically(balls, ball_diameter, pitch);
        let statical = self.static_deviation(static_rating);
        let dynamic = dynamic_deviation([dynamic_rating, self.dynamic_rating], DYNAMIC_RATIO);
        let factor = self.factor_excess(balls, ball_diameter);
        let factor = factor
            .zip(self.static_factor)
            .map_or(0.0, |(excess, f0)| excess / f0);
        let unusual = [
            is_usual_size(ball_diameter, self.section()),
            self.contact_angle > 0.0 || is_usual_filling(balls, ball_diameter, pitch),
        ];
        let unusual = unusual.into_iter().filter(|usual| !usual).count() as f64;
        let rare = if is_rare_size(ball_diameter) {
            RARE
        } else {
            0.0
        };
        Candidate {
            balls,
            ball_diameter,
            dynamic_rating,
            static_rating,
            deviation: statical + dynamic + factor + UNUSUAL * unusual + rare,
        }
    }
}

/// Whether the printed C over that of ISO 281 lies within limits of makers.
pub(super) fn is_rated_within([found, printed]: [f64; 2], [least, largest]: [f64; 2]) -> bool {
    (least..=largest).contains(&(printed / found))
}

/// How far C by ISO 281 is from the print, which within limits of makers says no more than that a maker rates higher.
pub(super) fn dynamic_deviation(ratings: [f64; 2], limits: [f64; 2]) -> f64 {
    let [found, printed] = ratings;
    let deviation = (found / printed - 1.0).abs();
    match is_rated_within(ratings, limits) {
        true => deviation.min(BY_ISO),
        false => deviation,
    }
}

const INCH: f64 = 0.0254;

/// Diameters in inches that balls are made in, m: steps of 1/32 in to 4 in, and of 1/64 in from 15/64 to 35/64 in.
fn inch_sizes() -> impl Iterator<Item = f64> {
    let steps = (1..=128).map(|step| 2 * step);
    let others = (15..=35).step_by(2);
    steps
        .chain(others)
        .map(|step| f64::from(step) / 64.0 * INCH)
}

/// Diameters of metric balls, m: steps of half a millimetre.
fn metric_sizes() -> impl Iterator<Item = f64> {
    (2..=200).map(|half| f64::from(half) / 2e3)
}

/// Whether balls are neither steps of 1/32 in nor of 15/64 or 17/64 in.
pub(super) fn is_rare_size(ball_diameter: f64) -> bool {
    let step = 64.0 * ball_diameter / INCH;
    let is = |whole: f64| (step - whole).abs() < 0.01;
    !(is(2.0 * (step / 2.0).round()) || is(15.0) || is(17.0))
}
