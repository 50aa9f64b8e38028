//! What a shaft is and what acts on it: plain data, before any computation.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{
    Attachment, Body, Drive, ElementLaw, FlexibleShaft, ForceElement, Load, PlaneUnbalance,
    SpeedPoint,
};
use crate::bearing::{CageMotion, Housing, MountedBearing};
use crate::numerics::distinct::each_once;
use crate::physics::{PER_MINUTE, Race};

/// Standard acceleration of gravity, m/s² (ISO 80000-3).
pub const STANDARD_GRAVITY: f64 = 9.806_65;

/// Part of a speed by which round-off of its unit may take it beyond another one.
const SAME_SPEED: f64 = 1e-9;

/// Number of freedoms of the inner ring: x, y, z, θx, θy.
pub const FREEDOMS: usize = 5;

/// Which freedoms of the shaft move; the rest is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Freedoms {
    /// x and y.
    Radial,
    /// x, y and z.
    Translational,
    /// x, y and both tilts.
    Lateral,
    /// x, y, z and both tilts.
    All,
}

impl Freedoms {
    /// Indices of the components that move: 0 … 4 for x, y, z, θx, θy.
    pub fn axes(self) -> &'static [usize] {
        match self {
            Self::Radial => &[0, 1],
            Self::Translational => &[0, 1, 2],
            Self::Lateral => &[0, 1, 3, 4],
            Self::All => &[0, 1, 2, 3, 4],
        }
    }

    /// Whether one of x, y, z, θx, θy, counted from 0, moves.
    pub fn moves(self, axis: usize) -> bool {
        self.axes().contains(&axis)
    }

    /// How many of x, y, z move: z is the last.
    pub fn lengths(self) -> usize {
        2 + usize::from(self.moves(2))
    }

    /// Whether the tilts move.
    pub fn tilts(self) -> bool {
        self.moves(3)
    }

    /// The freedoms that are left with z held.
    pub fn without_z(self) -> Self {
        if self.tilts() {
            Self::Lateral
        } else {
            Self::Radial
        }
    }

    /// As in a scenario.
    pub fn name(self) -> &'static str {
        match self {
            Self::Radial => "radial",
            Self::Translational => "translational",
            Self::Lateral => "lateral",
            Self::All => "all",
        }
    }
}

/// The concentrated mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaft {
    /// Mass m, kg.
    pub mass: f64,
    /// Moment of inertia about a transverse axis I_t, kg m²; used where tilts move.
    pub inertia_transverse: f64,
    /// Moment of inertia about the shaft axis I_p, kg m²; used where tilts move or a drive turns the
    /// shaft.
    pub inertia_polar: f64,
    /// Mass eccentricity e, m. The heavy side points along +X at shaft angle 0.
    pub eccentricity: f64,
    /// Unbalances in planes, besides the eccentricity.
    pub unbalance: PlaneUnbalance,
    /// Freedoms that move.
    pub freedoms: Freedoms,
    /// Whether the weight m g acts along −Y.
    pub gravity: bool,
    /// Misalignment: θx and θy in rad that the tilts are held at where they do not move.
    pub held_tilt: [f64; 2],
}

/// How the viscous damping is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damping {
    /// None: a free vibration does not decay.
    Undamped,
    /// Coefficients for x, y, z in N s/m and for θx, θy in N m s/rad.
    Coefficients([f64; FREEDOMS]),
    /// Ratio ζ of the critical value of each diagonal of K at the static equilibrium.
    Ratio(f64),
    /// c = τ K with K at the static equilibrium, τ in s.
    StiffnessTime(f64),
}

/// Where the motion starts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct InitialState {
    /// State that the given values below replace.
    pub from: InitialPosition,
    /// Displacements in m and rad that replace those of `from`.
    pub displacement: [Option<f64>; FREEDOMS],
    /// Velocities in m/s and rad/s that replace zero.
    pub velocity: [Option<f64>; FREEDOMS],
}

/// Position at the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InitialPosition {
    /// The static equilibrium under the loads, without unbalance.
    #[default]
    Equilibrium,
    /// No displacement at all.
    #[serde(rename = "zero")]
    Origin,
}

/// A shaft, its speed, what damps it and what loads it.
#[derive(Debug, Clone, PartialEq)]
pub struct RotorDefinition {
    /// The concentrated mass.
    pub(crate) shaft: Shaft,
    /// Angular speed ω at t = 0, rad/s, zero or positive. The static equilibrium, and with it K,
    /// damping by ratio and natural frequencies, are those at this speed.
    pub(crate) speed: f64,
    /// Speeds at later times, reached linearly one after the other; the last one is held. None: the
    /// speed is constant.
    pub(crate) speed_points: Vec<SpeedPoint>,
    /// The drive that decides the speed from t = 0 on, in place of the points above.
    pub(crate) drive: Option<Drive>,
    /// Motion of the cages.
    pub(crate) cage: CageMotion,
    /// Viscous damping.
    pub(crate) damping: Damping,
    /// External loads, constant ones and those that vary with time or shaft angle; they add up.
    pub(crate) loads: Vec<Load>,
    /// State at t = 0.
    pub(crate) initial: InitialState,
    /// Ball bearings that carry the shaft.
    pub(crate) bearings: Vec<MountedBearing>,
    /// Elements that hold it besides, or instead.
    pub(crate) elements: Vec<ForceElement>,
    /// Further positions along the shaft whose motion is asked for, or where forces act, m.
    pub(crate) points: Vec<f64>,
    /// The shaft that bends, in place of the concentrated mass.
    pub(crate) flexible: Option<FlexibleShaft>,
    /// What the reader of any answer about it should know from the start; no answer depends on it.
    pub(crate) warnings: Vec<String>,
}

impl RotorDefinition {
    /// A stationary shaft on ball bearings at its static equilibrium, undamped and without loads; its cages roll.
    pub(crate) fn new(shaft: Shaft, bearings: Vec<MountedBearing>) -> Self {
        Self {
            shaft,
            speed: 0.0,
            speed_points: Vec::new(),
            drive: None,
            cage: CageMotion::Rolling,
            damping: Damping::Undamped,
            loads: Vec::new(),
            initial: InitialState::default(),
            bearings,
            elements: Vec::new(),
            points: Vec::new(),
            flexible: None,
            warnings: Vec::new(),
        }
    }

    /// Positions along the shaft at which something sits or acts, m.
    pub(crate) fn positions(&self) -> impl Iterator<Item = f64> {
        let balls = self.bearings.iter().map(|own| own.position);
        let elements = self.elements.iter().filter_map(|own| own.position);
        let loads = self.loads.iter().filter(|load| !load.acts_on_mass());
        let further = self.points.iter().copied();
        let loads = loads.map(|load| load.position);
        balls.chain(elements).chain(loads).chain(further)
    }

    /// What the reader of an answer about it should know: its own warnings first, each once.
    pub(crate) fn warnings_with(&self, further: impl IntoIterator<Item = String>) -> Vec<String> {
        each_once(self.warnings.iter().cloned().chain(further))
    }

    /// Number of bearings and elements.
    pub(crate) fn part_count(&self) -> usize {
        self.bearings.len() + self.elements.len()
    }

    /// Whether it turns at the speed of its start for good.
    pub(crate) fn keeps_its_speed(&self) -> bool {
        let mut points = self.speed_points.iter();
        self.drive.is_none() && points.all(|point| point.speed == self.speed)
    }

    /// Where the ball bearings sit on the shaft, taken as rigid: its coordinates are x, y, z, θx, θy of the observed point.
    pub(crate) fn rigid_attachments(&self) -> Vec<Attachment> {
        let observed = self.flexible.as_ref().map_or(0.0, |own| own.observed);
        let bearings = self.bearings.iter();
        let attachments =
            bearings.map(|own| Attachment::on_rigid_shaft(own.position - observed, own.facing));
        attachments.collect()
    }

    /// Housings and what vibrates on them, bearing by bearing.
    pub(crate) fn bodies(&self) -> Vec<Body> {
        let housings = self.housings().into_iter();
        let bodies = housings.flat_map(|(bearing, housing)| {
            let resonator = housing.resonator.map(|_| Body::Resonator(bearing));
            [Some(Body::Housing(bearing)), resonator]
                .into_iter()
                .flatten()
        });
        bodies.collect()
    }

    /// Highest speed that the shaft is meant for, rad/s: of its points, or the no-load speed of its
    /// drive.
    pub(crate) fn highest_speed(&self) -> f64 {
        let idle = self.drive.and_then(|drive| drive.no_load_speed);
        let points = self.speed_points.iter().map(|point| point.speed);
        points.chain(idle).fold(self.speed, f64::max)
    }

    /// Angular frequency of the highest excitation at the highest speed, rad/s: the unbalance, the balls that pass, and
    /// the main vibrations of the loads.
    pub(crate) fn highest_excitation(&self) -> f64 {
        let speed = self.highest_speed();
        let passing = |bearing: &MountedBearing| {
            let geometry = &bearing.bearing.geometry;
            geometry.ball_pass(speed).inner.abs()
        };
        let passing = self.bearings.iter().map(passing);
        let loads = self.loads.iter();
        let loads = loads.map(|load| load.kind.main_vibration().frequency_at(speed));
        passing.chain(loads).fold(speed, f64::max)
    }

    /// The housings, each with the place of its bearing, from 0, or behind the bearings of its element, in the order of the
    /// scene.
    pub(crate) fn housings(&self) -> Vec<(usize, Housing)> {
        let bearings = self.bearings.iter().map(|own| own.housing);
        let all = bearings.chain(self.elements.iter().map(|own| own.housing));
        let housings = all.enumerate();
        housings
            .filter_map(|(place, own)| Some((place, own?)))
            .collect()
    }

    /// Whether elements, housings or the shaft itself damp it.
    pub(crate) fn is_damped_by_parts(&self) -> bool {
        let mut elements = self.elements.iter();
        let housings = self.housings().into_iter().flat_map(|(_, own)| {
            let resonator = own.resonator.map(|resonator| resonator.damping);
            own.damping.into_iter().chain(resonator)
        });
        let inside = self.flexible.iter().map(|own| own.internal_damping);
        elements.any(|own| own.law.damps(self.speed))
            || housings.chain(inside).any(|damping| damping > 0.0)
    }

    /// Whether an unbalance turns with it.
    pub(crate) fn is_unbalanced(&self) -> bool {
        match &self.flexible {
            None => self.shaft.is_unbalanced(),
            Some(flexible) => !flexible.unbalances.is_empty(),
        }
    }

    /// Whether the speed changes after the start, or a drive makes it.
    pub(crate) fn changes_speed(&self) -> bool {
        self.drive.is_some() || !self.speed_points.is_empty()
    }

    /// Lowest and highest speed that the shaft is meant for, rad/s.
    pub(crate) fn speed_range(&self) -> [f64; 2] {
        let points = self.speed_points.iter().map(|point| point.speed);
        [points.fold(self.speed, f64::min), self.highest_speed()]
    }

    /// What the reader should know where speeds between two, in rad/s, leave the table of an element.
    pub(crate) fn beyond_tables(&self, [lowest, highest]: [f64; 2]) -> Vec<String> {
        let elements = (1..).zip(&self.elements);
        let tables = elements.filter_map(|(number, own)| match &own.law {
            ElementLaw::OverSpeed(table) => Some((number, table.speeds())),
            _ => None,
        });
        let beyond = tables.flat_map(|(number, [first, last])| {
            let below = (lowest < first * (1.0 - SAME_SPEED)).then_some(lowest);
            let above = (highest > last * (1.0 + SAME_SPEED)).then_some(highest);
            let speeds = below.into_iter().chain(above);
            speeds.map(move |speed| beyond_table(number, [first, last], speed))
        });
        beyond.collect()
    }

    /// Whether the shaft is stationary and the outer rings of its bearings turn.
    pub(crate) fn shaft_stands(&self) -> bool {
        let mut bearings = self.bearings.iter();
        bearings.any(|bearing| bearing.bearing.rotating_ring == Race::Outer)
    }

    /// This shaft with so many modes of bending in each plane.
    pub(crate) fn with_modes(&self, modes: usize) -> Self {
        let mut other = self.clone();
        if let Some(flexible) = &mut other.flexible {
            flexible.modes = Some(modes);
        }
        other
    }

    /// This shaft at a constant speed in rad/s.
    pub(crate) fn at_constant_speed(&self, speed: f64) -> Self {
        Self {
            speed,
            speed_points: Vec::new(),
            drive: None,
            ..self.clone()
        }
    }
}

/// That the coefficients of an element, known between two speeds, are kept at one beyond, all in rad/s.
fn beyond_table(number: usize, known: [f64; 2], speed: f64) -> String {
    let [first, last, speed] = [known[0], known[1], speed].map(|own| own * PER_MINUTE);
    let known = match first == last {
        true => format!("are known at {first:.0} rpm only"),
        false => format!("reach from {first:.0} to {last:.0} rpm"),
    };
    format!(
        "the coefficients of element {number} {known}, and the speed goes to {speed:.0} rpm: beyond the table those of its nearest \
         row are kept"
    )
}
