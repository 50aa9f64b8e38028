//! What makes a bearing differ from a perfect one: `[[bearing.defect]]`, `[[bearing.waviness]]`, `[bearing.ball_sizes]`,
//! `[bearing.roller_sizes]` and `[bearing.cage_jitter]`.

use std::f64::consts::TAU;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::number;
use crate::bearing::{
    Defect, DefectProfile, Geometry, ImperfectionError, Imperfections, Surface, Wave, check_ball,
};
use crate::rotor::load::SplitMix64;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, Length, Quantity, si};

/// Where an imperfection is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SurfaceInput {
    /// The outer race.
    Outer,
    /// The inner race.
    Inner,
    /// A ball.
    Ball,
    /// A roller.
    Roller,
}

/// A slot across a race, or a dent of a ball or, along its whole length, of a roller. The ball or roller sinks as deep as the edges let it, or to the floor.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DefectInput {
    /// Where it is: "outer", "inner", "ball" or "roller"; on a race of two rows under the first, which
    /// bears loads along +z, or with facing "-z" those along −z.
    pub on: SurfaceInput,
    /// Number of the ball that it is on, from 1: ball 1 starts at `first_ball`.
    #[schemars(range(min = 1, max = 200))]
    pub ball: Option<u32>,
    /// Number of the roller that it is on, from 1: roller 1 starts at `first_ball`; those of a second row come after the first.
    #[schemars(range(min = 1, max = 400))]
    pub roller: Option<u32>,
    /// Angle of its middle: on the outer race from +X towards +Y, on the inner race from the mark of the unbalance, which
    /// points along +X at the start; on a ball from where it meets the outer race at the start. Default: "0 rad".
    #[serde(default)]
    #[schemars(extend("examples" = ["-90 deg"]))]
    pub angle: Quantity<Angle>,
    /// Length along the race, for instance "0.5334 mm".
    #[schemars(extend("examples" = ["0.5334 mm"], "x-above" = 0.0))]
    pub length: Quantity<Length>,
    /// Depth of its floor, for instance "0.2794 mm". Few balls ever reach it.
    #[schemars(extend("examples" = ["0.2794 mm"], "x-above" = 0.0))]
    pub depth: Quantity<Length>,
    /// How the drop of a ball follows: "edges", the exact one of sharp edges; "half_sine" and "rectangular" of the whole
    /// depth are found in literature. Default: "edges".
    #[serde(default)]
    pub profile: DefectProfile,
}

impl DefectInput {
    /// The defect, if it fits the bearing.
    pub fn build(&self, geometry: &Geometry) -> Result<Defect, Issue> {
        let missing = || {
            let element = geometry.element();
            Issue::new(
                key(geometry),
                format!("a defect of a {element} needs its number"),
            )
            .help(format!(
                "for instance: {element} = 1, the one that starts at `first_ball`"
            ))
            .against(".on")
        };
        let defect = Defect {
            on: surface(self.on, [self.ball, self.roller], geometry)?.ok_or_else(missing)?,
            angle: self.angle.si(),
            length: self.length.si(),
            depth: self.depth.si(),
            profile: self.profile,
        };
        defect.check(geometry).map_err(|error| {
            let key = match error {
                ImperfectionError::Ball { .. } => key(geometry),
                _ => ".length",
            };
            Issue::new(key, error.to_string())
        })?;
        Ok(defect)
    }
}

/// The key of the number of a ball or roller.
fn key(geometry: &Geometry) -> &'static str {
    match geometry.rollers() {
        Some(_) => ".roller",
        None => ".ball",
    }
}

/// The surface that is meant by the numbers of a ball and of a roller, `None` where all of them are; a race has no number.
fn surface(
    on: SurfaceInput,
    [ball, roller]: [Option<u32>; 2],
    geometry: &Geometry,
) -> Result<Option<Surface>, Issue> {
    let element = geometry.element();
    let (number, other, other_key, wrong) = match geometry.rollers() {
        Some(_) => (roller, ball, ".ball", SurfaceInput::Ball),
        None => (ball, roller, ".roller", SurfaceInput::Roller),
    };
    if on == wrong || other.is_some() {
        let at = if on == wrong { ".on" } else { other_key };
        let issue = Issue::new(at, format!("this bearing has {element}s"));
        return Err(issue.help(format!(
            "set on = \"{element}\" and {element} = 1, for instance"
        )));
    }
    let race = match on {
        SurfaceInput::Outer => Surface::Outer,
        SurfaceInput::Inner => Surface::Inner,
        SurfaceInput::Ball | SurfaceInput::Roller => {
            return Ok(number.map(|number| Surface::Ball(number as usize - 1)));
        }
    };
    if number.is_some() {
        let message = format!("`{element}` is the number of a {element}, and this is on a race");
        let issue = Issue::new(key(geometry), message);
        let help = format!("remove it, or set on = \"{element}\"");
        return Err(issue.help(help).against(".on"));
    }
    Ok(Some(race))
}

/// Waves around a race or the balls: one order, or a spectrum of them with random phases.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["order", "spectrum"]))]
pub struct WavinessInput {
    /// Where they are: "outer", "inner", "ball" or "roller".
    pub on: SurfaceInput,
    /// Number of the ball that they are on, from 1. Default: all balls, a spectrum with phases of its own on each.
    #[schemars(range(min = 1, max = 200))]
    pub ball: Option<u32>,
    /// Number of the roller that they are on, from 1. Default: all, as of balls.
    #[schemars(range(min = 1, max = 400))]
    pub roller: Option<u32>,
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
    #[serde(default = "number::<2>")]
    #[schemars(range(min = 1, max = 10_000))]
    pub first: u32,
    /// Highest order, for instance 60.
    #[schemars(range(min = 1, max = 10_000), extend("examples" = [60]))]
    pub last: u32,
    /// Seed of the phases, a whole number. Default: 1.
    #[serde(default = "number::<1>")]
    #[schemars(range(min = 0, max = 4_294_967_295_u32))]
    pub seed: u32,
}

fn one() -> f64 {
    1.0
}

impl WavinessInput {
    /// The waves with their surfaces, as far as nothing contradicts them.
    pub fn build(
        &self,
        geometry: &Geometry,
        problems: &mut Problems<'_>,
    ) -> Option<Vec<(Surface, Wave)>> {
        let numbers = [self.ball, self.roller];
        let surfaces = match problems.take(surface(self.on, numbers, geometry))? {
            Some(surface) => {
                let wrong = |error: ImperfectionError| Issue::new(key(geometry), error.to_string());
                problems.take(check_ball(surface, geometry).map_err(wrong))?;
                vec![surface]
            }
            None => (0..geometry.all_balls()).map(Surface::Ball).collect(),
        };
        match (&self.spectrum, self.order) {
            (Some(spectrum), _) => {
                let amplitude = self.amplitude.as_ref().map(|_| ".amplitude");
                let phase = self.phase.as_ref().map(|_| ".phase");
                for key in amplitude.into_iter().chain(phase) {
                    let message = "a `spectrum` has amplitudes and phases of its own";
                    let issue = Issue::new(key, message).help("remove it");
                    problems.refuse(issue.against(".spectrum"));
                }
                let all = surfaces.into_iter();
                Some(all.flat_map(|on| spectrum.waves(on)).collect())
            }
            (None, Some(order)) => {
                let missing = || {
                    Issue::new(".amplitude", "a wave needs an `amplitude`")
                        .help("for instance: amplitude = \"0.1 um\"")
                        .against(".order")
                };
                let wave = Wave {
                    order,
                    amplitude: problems.take(si(&self.amplitude).ok_or_else(missing))?,
                    phase: si(&self.phase).unwrap_or(0.0),
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
                phase: TAU * phases.uniform(order.into()),
            };
            (on, wave)
        })
    }
}

/// Ball passes after which the steps come again.
const STEPS: u64 = 16_384;

/// Uniform numbers whose sum, less its mean, stands for a normal number of deviation 1 and at most half as many in size.
const SUMMED: u64 = 12;

/// A cage that wanders at random: with every ball pass it gains or loses an angle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CageJitterInput {
    /// Standard deviation of the angle gained with one ball pass, for instance "0.2 deg"; at most a twelfth of the spacing of
    /// the balls.
    #[schemars(extend("examples" = ["0.2 deg"], "x-minimum" = 0.0))]
    pub amplitude: Quantity<Angle>,
    /// Seed of the angles, a whole number. Default: 1.
    #[schemars(range(min = 0, max = 4_294_967_295_u32))]
    pub seed: Option<u32>,
}

impl CageJitterInput {
    /// Angles that the cage gains, rad.
    pub fn build(&self, geometry: &Geometry) -> Result<Vec<f64>, Issue> {
        let amplitude = self.amplitude.si();
        let spacing = TAU / geometry.balls() as f64;
        let largest = 2.0 * Imperfections::LARGEST_STEP * spacing / SUMMED as f64;
        if amplitude > largest {
            let message = format!(
                "the cage would wander by {:.3} deg with a ball pass, and might turn backwards",
                amplitude.to_degrees()
            );
            let help = format!(
                "at most {:.3} deg with these {}s",
                largest.to_degrees(),
                geometry.element()
            );
            return Err(Issue::new(".amplitude", message).help(help));
        }
        if amplitude == 0.0 {
            return Ok(Vec::new());
        }
        let chance = SplitMix64::new(self.seed.unwrap_or(1).into());
        let normal = |pass: u64| {
            let numbers = (0..SUMMED).map(|number| chance.uniform(SUMMED * pass + number));
            numbers.sum::<f64>() - 0.5 * SUMMED as f64
        };
        Ok((0..STEPS).map(|pass| amplitude * normal(pass)).collect())
    }
}
