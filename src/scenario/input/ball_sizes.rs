//! Sizes of balls that differ.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::bearing::Geometry;
use crate::rotor::load::SplitMix64;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Length, Quantity, si};

/// How the diameters of the balls or rollers differ.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["oversizes", "grade", "variation"]))]
pub struct BallSizesInput {
    /// How much larger than nominal the diameter of each ball is, ball 1 first.
    #[schemars(extend("examples" = [["1 um", "0 um", "-0.5 um"]]))]
    pub oversizes: Option<Vec<Quantity<Length>>>,
    /// Grade of balls of ISO 3290-1, whose variation of lot diameter the diameters fill evenly by chance. Rollers have grades of
    /// their own, ISO 12297: give the width of theirs as `variation`.
    pub grade: Option<BallGrade>,
    /// Width of the range that the diameters fill evenly by chance, for instance "0.5 um".
    #[schemars(extend("examples" = ["0.5 um"], "x-minimum" = 0.0))]
    pub variation: Option<Quantity<Length>>,
    /// Seed of the diameters, a whole number. Default: 1.
    #[schemars(range(min = 0, max = 4_294_967_295_u32))]
    pub seed: Option<u32>,
}

/// Grades of steel balls.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum BallGrade {
    G3,
    G5,
    G10,
    G16,
    G20,
    G24,
    G28,
    G40,
    G60,
    G100,
    G200,
}

impl BallGrade {
    /// Variation of lot diameter V_DwL, m (ISO 3290-1:2014, table 2).
    fn variation(self) -> f64 {
        let micrometres = match self {
            Self::G3 => 0.13,
            Self::G5 => 0.25,
            Self::G10 => 0.5,
            Self::G16 => 0.8,
            Self::G20 => 1.0,
            Self::G24 => 1.2,
            Self::G28 => 1.4,
            Self::G40 => 2.0,
            Self::G60 => 3.0,
            Self::G100 => 5.0,
            Self::G200 => 10.0,
        };
        1e-6 * micrometres
    }
}

impl BallSizesInput {
    /// How much larger than nominal each ball is, m.
    pub fn build(&self, geometry: &Geometry, problems: &mut Problems<'_>) -> Option<Vec<f64>> {
        let (balls, element) = (geometry.all_balls(), geometry.element());
        if self.grade.is_some() && geometry.rollers().is_some() {
            let issue = Issue::new(".grade", "the grades of ISO 3290-1 are those of balls");
            problems.refuse(issue.help("give `variation`, for instance \"1 um\""));
        }
        if let Some(oversizes) = &self.oversizes {
            if self.seed.is_some() {
                let issue = Issue::new(".seed", "nothing here is left to chance");
                problems.refuse(issue.help("remove it").against(".oversizes"));
            }
            if oversizes.len() != balls {
                let message = format!(
                    "{} diameters are given for {balls} {element}s: give one for each",
                    oversizes.len()
                );
                problems.refuse(Issue::new(".oversizes", message).against("geometry.balls"));
                return None;
            }
            return Some(oversizes.iter().map(Quantity::si).collect());
        }
        let variation = si(&self.variation).or(self.grade.map(BallGrade::variation))?;
        let chance = SplitMix64::new(self.seed.unwrap_or(1).into());
        let oversize = |ball| variation * (chance.uniform(ball) - 0.5);
        Some((0..balls as u64).map(oversize).collect())
    }
}
