//! `[[load]]`.

use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::{self, Components, PerFreedom};
use super::number;
use super::random_load::{NoiseInput, RandomShocksInput};
use crate::bearing::Vector5;
use crate::rotor;
use crate::rotor::load::{
    ChainDrive, Harmonic, HarmonicRate, Interpolation, Series, SeriesError, Shock, Sprocket,
};
use crate::rotor::{FREEDOMS, Freedoms, LoadKind};
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{
    Acceleration, Angle, Force, Frequency, Length, Moment, Quantity, Time, si,
};
use crate::scenario::{Issue, series_file};

/// Forces along the axes and moments about them.
pub type Loads = Components<Force, Moment>;

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
    pub harmonic: Option<HarmonicInput<Loads>>,
    /// A half-sine shock, once or at a fixed interval.
    pub shock: Option<ShockInput<Loads>>,
    /// Half-sine shocks at random times, fixed by a seed.
    pub random_shocks: Option<RandomShocksInput>,
    /// The pull of a chain on a sprocket, with its polygon effect.
    pub sprocket: Option<SprocketInput>,
    /// Band-limited noise, fixed by a seed.
    pub noise: Option<NoiseInput>,
    /// A series of values from a CSV file.
    pub series: Option<SeriesInput>,
    /// Acceleration of the base: −m a acts on all masses, and motions are given relative to the base.
    pub base: Option<BaseInput>,
    /// Where the load acts along the shaft, from the centre of mass towards +Z; a force there is
    /// a moment as well where the tilts move. Of a shaft that bends it counts from the left end. Default: "0 m", or the
    /// observed position of a shaft that bends.
    #[schemars(extend("examples" = ["20 mm"]))]
    pub position: Option<Quantity<Length>>,
}

/// What the tables of the loads need to know of the rest.
#[derive(Clone, Copy)]
pub struct LoadContext {
    /// Freedoms that move.
    pub freedoms: Freedoms,
    /// Simulated time, s.
    pub duration: f64,
    /// Where a load acts whose position is not given, where the shaft bends, m.
    pub observed: Option<f64>,
}

/// The loads.
pub fn build(
    loads: &[LoadInput],
    context: LoadContext,
    problems: &mut Problems<'_>,
) -> Vec<rotor::Load> {
    let built = problems.each("load", loads, |load, problems| {
        let position = load.position(context, problems);
        let constant = load.constant(context.freedoms, problems);
        let kinds = constant.into_iter().chain(load.kind(context, problems));
        Some(kinds.map(move |kind| rotor::Load { kind, position }))
    });
    built.into_iter().flatten().flatten().collect()
}

impl LoadInput {
    /// The place of the load; zero where no tilt moves, with a warning.
    fn position(&self, context: LoadContext, problems: &mut Problems<'_>) -> f64 {
        let Some(position) = &self.position else {
            return context.observed.unwrap_or(0.0);
        };
        if self.base.is_some() {
            let message = "a `base` acceleration acts at the centre of mass, not at a `position`";
            problems.refuse(Issue::new(".position", message).against(".base"));
        }
        if !context.freedoms.tilts() && context.observed.is_none() {
            let path = problems.path(".position");
            problems.warn(format!("`{path}` has no effect: the tilts are held"));
            return 0.0;
        }
        position.si()
    }

    /// The constant load; none where it is of another kind, or zero.
    fn constant(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Option<LoadKind> {
        let given = self.constant.as_ref()?.values();
        // An axial load acts on a held z too, moments on held tilts do not.
        let [x, y, _, tilt_x, tilt_y] = given;
        let held = [x, y, None, tilt_x, tilt_y];
        components::refuse_held(&held, ".constant", freedoms, problems);
        let parts = given.map(Option::unwrap_or_default);
        (parts != [0.0; FREEDOMS]).then_some(LoadKind::Constant(parts))
    }

    /// The varying load of whichever kind is given.
    fn kind(&self, context: LoadContext, problems: &mut Problems<'_>) -> Option<LoadKind> {
        use LoadKind as Kind;
        let freedoms = context.freedoms;
        if let Some(input) = &self.harmonic {
            problems.inside("harmonic", |p| {
                Some(Kind::Harmonic(input.build(freedoms, p)))
            })
        } else if let Some(input) = &self.shock {
            problems.inside("shock", |p| Some(Kind::Shock(input.build(freedoms, p))))
        } else if let Some(input) = &self.random_shocks {
            problems.inside("random_shocks", |p| {
                input.build(context, p).map(Kind::RandomShocks)
            })
        } else if let Some(input) = &self.sprocket {
            Some(Kind::Sprocket(input.build()))
        } else if let Some(input) = &self.noise {
            problems.inside("noise", |p| input.build(freedoms, p).map(Kind::Noise))
        } else if let Some(input) = &self.series {
            problems.inside("series", |p| input.build(context, p).map(Kind::Series))
        } else {
            let input = self.base.as_ref()?;
            problems.inside("base", |p| {
                input
                    .build(freedoms, p)
                    .map(|base| Kind::Base(Box::new(base)))
            })
        }
    }
}

/// The values of the freedoms that move; those of the others are refused.
pub fn moving(
    given: &impl PerFreedom,
    path: &str,
    freedoms: Freedoms,
    problems: &mut Problems<'_>,
) -> Vector5 {
    let given = given.values();
    components::refuse_held(&given, path, freedoms, problems);
    given.map(Option::unwrap_or_default)
}

/// Acceleration of the housing, of one of two kinds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["harmonic", "shock"]))]
pub struct BaseInput {
    /// A cosine of time or of the shaft's angle.
    pub harmonic: Option<HarmonicInput<Accelerations>>,
    /// A half-sine shock, once or at a fixed interval.
    pub shock: Option<ShockInput<Accelerations>>,
}

/// Accelerations along the axes; at least one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1))]
pub struct Accelerations {
    /// Along X.
    pub x: Option<Quantity<Acceleration>>,
    /// Along Y.
    pub y: Option<Quantity<Acceleration>>,
    /// Along Z.
    pub z: Option<Quantity<Acceleration>>,
}

impl PerFreedom for Accelerations {
    fn values(&self) -> [Option<f64>; FREEDOMS] {
        [si(&self.x), si(&self.y), si(&self.z), None, None]
    }
}

impl BaseInput {
    /// The acceleration of whichever kind is given.
    pub fn build(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Option<LoadKind> {
        if let Some(input) = &self.harmonic {
            let harmonic = problems.inside("harmonic", |p| input.build(freedoms, p));
            return Some(LoadKind::Harmonic(harmonic));
        }
        let input = self.shock.as_ref()?;
        let shock = problems.inside("shock", |p| input.build(freedoms, p));
        Some(LoadKind::Shock(shock))
    }
}

/// A cosine, either of time or of the shaft's angle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["frequency", "order"]))]
pub struct HarmonicInput<A> {
    /// Amplitude of each freedom.
    pub amplitude: A,
    /// Periods a second, for instance "50 Hz".
    #[schemars(extend("examples" = ["50 Hz"], "x-minimum" = 0.0))]
    pub frequency: Option<Quantity<Frequency>>,
    /// Periods per revolution of the shaft, 0 to 10000.
    #[schemars(range(min = 0.0, max = 10_000.0))]
    pub order: Option<f64>,
    /// Phase at the start: the load is amplitude · cos(phase) there. Default: "0 rad".
    #[serde(default)]
    pub phase: Quantity<Angle>,
}

impl<A: PerFreedom> HarmonicInput<A> {
    /// The harmonic load.
    pub fn build(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Harmonic {
        let frequency = si(&self.frequency).unwrap_or(0.0);
        Harmonic {
            amplitude: moving(&self.amplitude, ".amplitude", freedoms, problems),
            rate: self
                .order
                .map_or(HarmonicRate::Frequency(frequency), HarmonicRate::Order),
            phase: self.phase.si(),
        }
    }
}

/// A series of values from a CSV file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SeriesInput {
    /// CSV file, relative to the scenario file. Its first line names the columns: `t_s` first,
    /// then any of `x_N`, `y_N`, `z_N`, `tilt_x_N_m`, `tilt_y_N_m`. Before the first row its
    /// values hold, after the last row those of the last.
    #[schemars(extend("examples" = ["load.csv"]))]
    pub file: String,
    /// How the series is read between its rows. Default: "linear".
    #[serde(default)]
    pub interpolation: Interpolation,
}

impl SeriesInput {
    /// The series, where its file is right.
    pub fn build(&self, context: LoadContext, problems: &mut Problems<'_>) -> Option<Series> {
        let read = self.read(problems.folder).map_err(|error| {
            let message = format!("`{}` is no load series: {error}", self.file);
            Issue::new(".file", message)
        });
        let (series, axes) = problems.take(read)?;
        if let Some(axis) = axes.iter().find(|axis| !context.freedoms.moves(**axis)) {
            let message = format!(
                "`{}` has a column for `{}`, which `freedoms` holds",
                self.file,
                components::KEYS[*axis]
            );
            problems.refuse(Issue::new(".file", message).against("shaft.freedoms"));
        }
        if series.end() < context.duration {
            problems.warn(format!(
                "`{}` ends at {} s; its last row is held to the end of the run",
                self.file,
                series.end()
            ));
        }
        Some(series)
    }

    /// The series and the freedoms that it loads.
    fn read(&self, folder: &Path) -> Result<(Series, Vec<usize>), String> {
        let (times, columns) = series_file::read(&folder.join(&self.file))?;
        let axes = columns.iter().map(|column| column.axis).collect();
        let series = Series::new(times, columns, self.interpolation);
        Ok((
            series.map_err(|error: SeriesError| error.to_string())?,
            axes,
        ))
    }
}

/// Half-sine shocks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShockInput<A> {
    /// Peak of each freedom.
    pub peak: A,
    /// Duration of a shock, for instance "4 ms".
    #[schemars(extend("examples" = ["4 ms"], "x-minimum" = 1e-6))]
    pub duration: Quantity<Time>,
    /// Time at which the first one begins. Default: "0 s".
    #[serde(default)]
    #[schemars(extend("examples" = ["0.1 s"], "x-minimum" = 0.0))]
    pub at: Quantity<Time>,
    /// Time from the begin of one shock to that of the next, at least the duration. Without it
    /// there is one shock.
    #[schemars(extend("examples" = ["0.2 s"], "x-minimum" = 1e-6))]
    pub every: Option<Quantity<Time>>,
}

impl<A: PerFreedom> ShockInput<A> {
    /// The shock or shocks.
    pub fn build(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Shock {
        let (duration, every) = (self.duration.si(), si(&self.every));
        if every.is_some_and(|every| every < duration) {
            let message = format!(
                "`every` must be at least the `duration` of {duration} s: shocks do not overlap"
            );
            problems.refuse(Issue::new(".every", message).against(".duration"));
        }
        Shock {
            peak: moving(&self.peak, ".peak", freedoms, problems),
            duration,
            start: self.at.si(),
            every,
        }
    }
}

/// A chain strand that pulls at a driving sprocket on the shaft. Constant torque is assumed: the
/// pull is inverse to the lever, which falls and rises with every tooth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SprocketInput {
    /// Number of teeth that carry a joint of the chain in turn, 3 to 1000.
    #[schemars(extend("examples" = [8]), range(min = 3, max = 1000))]
    pub teeth: u32,
    /// Distance of two joints of the chain, for instance "126 mm".
    #[schemars(extend("examples" = ["126 mm"], "x-minimum" = 1e-4))]
    pub pitch: Quantity<Length>,
    /// Length of the free strand, from the sprocket to its next guide.
    #[schemars(extend("examples" = ["1 m"], "x-minimum" = 1e-3))]
    pub span: Quantity<Length>,
    /// Mean pull of the strand; counts in the static equilibrium.
    #[schemars(extend("examples" = ["2 kN"]))]
    pub force: Quantity<Force>,
    /// Direction of the pull, from +X towards +Y. Default: "0 rad", along +X.
    #[serde(default)]
    pub direction: Quantity<Angle>,
    /// Number of harmonics of the meshing frequency, 1 to 64. Default: 8.
    #[serde(default = "number::<8>")]
    #[schemars(range(min = 1, max = 64))]
    pub harmonics: u32,
}

impl SprocketInput {
    /// The pull of the chain.
    pub fn build(&self) -> Sprocket {
        Sprocket::new(&ChainDrive {
            teeth: self.teeth,
            pitch: self.pitch.si(),
            span: self.span.si(),
            force: self.force.si(),
            direction: self.direction.si(),
            harmonics: self.harmonics,
        })
    }
}
