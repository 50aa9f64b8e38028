//! `[[bearing.waviness]]` and `[bearing.ball_sizes]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::defect::{SurfaceInput, surface};
use crate::bearing::{Geometry, Surface, Wave};
use crate::rotor::load::SplitMix64;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, Length, Quantity};

/// Waves around a race or the balls: one order, or a spectrum of them with random phases.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["order", "spectrum"]))]
pub struct WavinessInput {
    /// Where they are: "outer", "inner" or "ball".
    pub on: SurfaceInput,
    /// Number of the ball that they are on, from 1. Default: all balls, a spectrum with phases of its own on each.
    #[schemars(range(min = 1, max = 200))]
    pub ball: Option<u32>,
    /// Waves around the circumference.
    #[schemars(range(min = 1, max = 10_000))]
    pub order: Option<u32>,
    /// Amplitude normal to the surface, for instance "0.1 um": half the height from trough to crest.
    #[schemars(extend("examples" = ["0.1 um"], "x-minimum" = 0.0))]
    pub amplitude: Option<Quantity<Length>>,
    /// Phase: the surface lies lower by amplitude × cos(order × angle + phase). The angle counts as that of a defect.
    /// Default: "0 rad".
    pub phase: Option<Quantity<Angle>>,
    /// Amplitudes that fall with the order, their phases fixed by a seed.
    pub spectrum: Option<WaveSpectrumInput>,
}

/// Amplitudes A₁ n^(−s) of the orders n.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WaveSpectrumInput {
    /// A₁: what order 1 would have by the law, for instance "1 um".
    #[schemars(extend("examples" = ["1 um"], "x-minimum" = 0.0))]
    pub amplitude: Quantity<Length>,
    /// s, how fast amplitudes fall with the order. Default: 1.
    #[serde(default = "one")]
    #[schemars(range(min = 0.0, max = 10.0))]
    pub exponent: f64,
    /// Lowest order. Default: 2.
    #[serde(default = "two")]
    #[schemars(range(min = 1, max = 10_000))]
    pub first: u32,
    /// Highest order, for instance 60.
    #[schemars(range(min = 1, max = 10_000), extend("examples" = [60]))]
    pub last: u32,
    /// Seed of the phases, a whole number. Default: 1.
    #[serde(default = "first_seed")]
    #[schemars(range(min = 0, max = 4_294_967_295_u32))]
    pub seed: u32,
}

fn one() -> f64 {
    1.0
}

fn two() -> u32 {
    2
}

fn first_seed() -> u32 {
    1
}

impl WavinessInput {
    /// The waves with their surfaces, as far as nothing contradicts them.
    pub fn build(
        &self,
        geometry: &Geometry,
        problems: &mut Problems<'_>,
    ) -> Option<Vec<(Surface, Wave)>> {
        let surfaces = match surface(self.on, self.ball, problems)? {
            Some(Surface::Ball(number)) if number >= geometry.balls() => {
                let message = format!(
                    "there is no ball {}: the balls count from 1 to {}",
                    number + 1,
                    geometry.balls()
                );
                problems.refuse(Issue::new(".ball", message));
                return None;
            }
            Some(surface) => vec![surface],
            None => (0..geometry.balls()).map(Surface::Ball).collect(),
        };
        match (&self.spectrum, self.order) {
            (Some(spectrum), _) => {
                for (key, given) in [
                    (".amplitude", self.amplitude.is_some()),
                    (".phase", self.phase.is_some()),
                ] {
                    if given {
                        let message = "a `spectrum` has amplitudes and phases of its own";
                        let issue = Issue::new(key, message).help("remove it");
                        problems.refuse(issue.against(".spectrum"));
                    }
                }
                let all = surfaces.into_iter();
                Some(all.flat_map(|on| spectrum.waves(on)).collect())
            }
            (None, Some(order)) => {
                let Some(amplitude) = &self.amplitude else {
                    let issue = Issue::new(".amplitude", "a wave needs an `amplitude`")
                        .help("for instance: amplitude = \"0.1 um\"");
                    problems.refuse(issue.against(".order"));
                    return None;
                };
                let wave = Wave {
                    order,
                    amplitude: amplitude.si(),
                    phase: self.phase.as_ref().map_or(0.0, Quantity::si),
                };
                Some(surfaces.into_iter().map(|on| (on, wave)).collect())
            }
            (None, None) => None,
        }
    }
}

impl WaveSpectrumInput {
    /// Its waves on a surface; each surface has phases of its own.
    fn waves(&self, on: Surface) -> impl Iterator<Item = (Surface, Wave)> {
        let stream = match on {
            Surface::Outer => 0,
            Surface::Inner => 1,
            Surface::Ball(number) => 2 + number as u64,
        };
        let (amplitude, exponent) = (self.amplitude.si(), self.exponent);
        let phases = SplitMix64::new(self.seed.into()).stream(stream);
        (self.first..=self.last).map(move |order| {
            let wave = Wave {
                order,
                amplitude: amplitude * f64::from(order).powf(-exponent),
                phase: std::f64::consts::TAU * phases.uniform(order.into()),
            };
            (on, wave)
        })
    }
}

/// How the diameters of the balls differ.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["oversizes", "grade", "variation"]))]
pub struct BallSizesInput {
    /// How much larger than nominal the diameter of each ball is, ball 1 first.
    #[schemars(extend("examples" = [["1 um", "0 um", "-0.5 um"]]))]
    pub oversizes: Option<Vec<Quantity<Length>>>,
    /// Grade of ISO 3290-1, whose variation of lot diameter the diameters fill evenly by chance.
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
        let balls = geometry.balls();
        if let Some(oversizes) = &self.oversizes {
            if self.seed.is_some() {
                let issue = Issue::new(".seed", "nothing here is left to chance");
                problems.refuse(issue.help("remove it").against(".oversizes"));
            }
            if oversizes.len() != balls {
                let message = format!(
                    "{} diameters are given for {balls} balls: give one for each",
                    oversizes.len()
                );
                problems.refuse(Issue::new(".oversizes", message).against("geometry.balls"));
                return None;
            }
            return Some(oversizes.iter().map(Quantity::si).collect());
        }
        let given = self.variation.as_ref().map(Quantity::si);
        let variation = given.or(self.grade.map(BallGrade::variation))?;
        let chance = SplitMix64::new(self.seed.unwrap_or(1).into());
        let oversize = |ball| variation * (chance.uniform(ball) - 0.5);
        Some((0..balls as u64).map(oversize).collect())
    }
}
