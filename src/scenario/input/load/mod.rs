//! `[[load]]`.

mod base;
mod harmonic;
mod noise;
mod random_shocks;
mod series;
mod shock;
mod sprocket;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::{self, Components};
use crate::bearing::Vector5;
use crate::rotor::{self, FREEDOMS, Freedoms, LoadKind};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Force, Length, Moment, Quantity};

/// Forces along the axes and moments about them.
type Loads = Components<Force, Moment>;

/// An external load on the shaft: exactly one kind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = [
    "constant", "harmonic", "shock", "random_shocks", "sprocket", "noise", "series", "base",
]))]
pub struct LoadInput {
    /// Forces x, y, z (for instance z = "1000 N") and moments tilt_x, tilt_y (for instance
    /// tilt_x = "2 N m") that act from the start on. With freedoms = "radial" the force z does
    /// not move the shaft but sets the axial position that it is held at.
    #[schemars(extend("examples" = [{ "z": "1000 N" }]))]
    pub constant: Option<Loads>,
    /// A cosine of time or of the shaft's angle.
    pub harmonic: Option<harmonic::HarmonicInput<Loads>>,
    /// A half-sine shock, once or at a fixed interval.
    pub shock: Option<shock::ShockInput<Loads>>,
    /// Half-sine shocks at random times, fixed by a seed.
    pub random_shocks: Option<random_shocks::RandomShocksInput>,
    /// The pull of a chain on a sprocket, with its polygon effect.
    pub sprocket: Option<sprocket::SprocketInput>,
    /// Band-limited noise, fixed by a seed.
    pub noise: Option<noise::NoiseInput>,
    /// A series of values from a CSV file.
    pub series: Option<series::SeriesInput>,
    /// Acceleration of the housing: −m a acts at the centre of mass.
    pub base: Option<base::BaseInput>,
    /// Where the load acts along the shaft, from the centre of mass towards +Z. A force there is
    /// a moment as well where the tilts move. Default: "0 m".
    #[schemars(extend("examples" = ["20 mm"]))]
    pub position: Option<Quantity<Length>>,
}

/// What the tables of the loads need to know of the rest.
#[derive(Clone, Copy)]
pub struct Surroundings {
    /// Freedoms that move.
    pub freedoms: Freedoms,
    /// Simulated time, s.
    pub duration: f64,
}

/// The sum of the constant loads, N and N m, and the varying ones.
pub fn build(
    loads: &[LoadInput],
    around: Surroundings,
    problems: &mut Problems<'_>,
) -> (Vector5, Vec<rotor::Load>) {
    let mut total = [0.0; FREEDOMS];
    let mut varying = Vec::new();
    for (index, load) in loads.iter().enumerate() {
        let (position, constant, kind) = problems.inside(format!("load[{index}]"), |problems| {
            let position = load.position(around.freedoms, problems);
            let constant = load.constant(around.freedoms, problems);
            (position, constant, load.kind(around, problems))
        });
        total[3] -= position * constant[1];
        total[4] += position * constant[0];
        for (sum, part) in total.iter_mut().zip(constant) {
            *sum += part;
        }
        varying.extend(kind.map(|kind| rotor::Load { kind, position }));
    }
    (total, varying)
}

impl LoadInput {
    /// The place of the load; zero where no tilt moves, with a warning.
    fn position(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> f64 {
        let Some(position) = &self.position else {
            return 0.0;
        };
        if self.base.is_some() {
            let message = "a `base` acceleration acts at the centre of mass, not at a `position`";
            let issue = Issue::new(".position", message);
            problems.refuse(issue.against(".base"));
        }
        if freedoms != Freedoms::All {
            let path = problems.path(".position");
            problems.warn(format!("`{path}` has no effect: the tilts are held"));
            return 0.0;
        }
        position.si()
    }

    /// The constant load; zero where it is of another kind.
    fn constant(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Vector5 {
        let Some(constant) = &self.constant else {
            return [0.0; FREEDOMS];
        };
        // An axial load acts on a held z too, moments on held tilts do not.
        let first_held = freedoms.count().max(3);
        constant.refuse_held(".constant", first_held, freedoms, problems);
        constant.values().map(|value| value.unwrap_or(0.0))
    }

    /// The varying load of whichever kind is given.
    fn kind(&self, around: Surroundings, problems: &mut Problems<'_>) -> Option<LoadKind> {
        let freedoms = around.freedoms;
        if let Some(input) = &self.harmonic {
            let harmonic = problems.inside("harmonic", |p| input.build(freedoms, p));
            Some(LoadKind::Harmonic(harmonic))
        } else if let Some(input) = &self.shock {
            let shock = problems.inside("shock", |p| input.build(freedoms, p));
            Some(LoadKind::Shock(shock))
        } else if let Some(input) = &self.random_shocks {
            let shocks = problems.inside("random_shocks", |p| input.build(around, p));
            shocks.map(LoadKind::RandomShocks)
        } else if let Some(input) = &self.sprocket {
            Some(LoadKind::Sprocket(input.build()))
        } else if let Some(input) = &self.noise {
            let noise = problems.inside("noise", |p| input.build(freedoms, p));
            noise.map(LoadKind::Noise)
        } else if let Some(input) = &self.series {
            let series = problems.inside("series", |p| input.build(around, p));
            series.map(LoadKind::Series)
        } else if let Some(input) = &self.base {
            let base = problems.inside("base", |p| input.build(freedoms, p));
            base.map(LoadKind::Base)
        } else {
            None
        }
    }
}

/// A value for each freedom, in an inline table.
pub trait PerFreedom {
    /// The given values in SI units.
    fn given(&self) -> [Option<f64>; FREEDOMS];
}

impl PerFreedom for Loads {
    fn given(&self) -> [Option<f64>; FREEDOMS] {
        self.values()
    }
}

/// The values of the freedoms that move; those of the others are refused.
fn moving(
    given: &impl PerFreedom,
    path: &str,
    freedoms: Freedoms,
    problems: &mut Problems<'_>,
) -> Vector5 {
    let given = given.given();
    for (axis, value) in given.iter().enumerate().skip(freedoms.count()) {
        if value.is_some() {
            let key = format!("{path}.{}", components::KEYS[axis]);
            components::refuse_held_key(&key, freedoms, problems);
        }
    }
    given.map(|value| value.unwrap_or(0.0))
}
