//! A [`StaticQuestion`] goes in, a [`QuasiStatic`] answer comes out. No time passes.

use nalgebra::DMatrix;
use serde::Serialize;

use crate::bearing::{BearingState, Geometry, Matrix5, Support, Vector5};
use crate::keys;
use crate::rotor::{
    FREEDOM_NAMES, FREEDOMS, RotorDefinition, RotorError, axial_hold_warning, build_supports,
    static_place,
};

/// Twist of the shaft's middle segment, `θz = M_z L/(G I_p)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torsion {
    /// Length L of the segment, m.
    pub length: f64,
    /// Shear modulus G, Pa.
    pub shear_modulus: f64,
    /// Polar second moment of area I_p, m⁴.
    pub polar_second_moment: f64,
    /// What is given of moment and twist.
    pub cause: TorsionCause,
}

/// What is given of moment and twist.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TorsionCause {
    /// The moment is the friction moment of all bearings.
    Friction,
    /// The moment M_z, N m.
    Moment(f64),
    /// The twist θz, rad.
    Angle(f64),
}

/// A static question about a shaft on its bearings.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct StaticQuestion {
    /// Shaft, bearings, loads and speed; the active freedoms find their equilibrium, the others are held.
    #[doc(hidden)]
    pub rotor: RotorDefinition,
    /// Displacements that are given instead of loads: those freedoms are held there.
    pub(crate) displacement: [Option<f64>; FREEDOMS],
    /// Whether the unbalance, m e ω² along +X and what planes add to it, acts as a static load.
    pub(crate) unbalance: bool,
    /// Torsion of the shaft, the sixth freedom.
    pub(crate) torsion: Option<Torsion>,
}

impl StaticQuestion {
    /// Asks about shaft and cages at other angles in rad than at the start; cages are where they roll to, unless an angle is
    /// given. Loads and unbalance stay as they are.
    pub(crate) fn turn(&mut self, shaft: f64, cage: Option<f64>) {
        // what cannot be built is refused by the answer
        let supports = self.rotor.rolling_supports().unwrap_or_default();
        for (bearing, support) in self.rotor.bearings.iter_mut().zip(supports) {
            *bearing = support.turned(shaft, cage.unwrap_or(support.cage_ratio() * shaft));
        }
    }
}

/// Moment and twist of the shaft about its axis.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Twist {
    /// Moment M_z, N m.
    #[serde(rename = "moment_N_m")]
    pub moment: f64,
    /// Twist θz, rad.
    #[serde(rename = "angle_rad")]
    pub angle: f64,
}

/// The answer to a [`StaticQuestion`].
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct QuasiStatic {
    /// Displacement x, y, z in m and θx, θy in rad.
    #[serde(rename = "equilibrium", serialize_with = "keys::displacement")]
    pub displacement: Vector5,
    /// Force of the shaft onto the bearings, N and N m: the load of the free freedoms, and what it
    /// takes to hold the others.
    #[serde(serialize_with = "keys::force")]
    pub force: Vector5,
    /// Which freedoms are free.
    #[serde(serialize_with = "keys::marked")]
    pub free: [bool; FREEDOMS],
    /// K = ∂F/∂q, rows and columns x, y, z, θx, θy.
    #[serde(serialize_with = "keys::stiffness")]
    pub stiffness: Matrix5,
    /// Condition of K of the free freedoms, tilts taken by their arm; infinite where it is singular.
    pub condition: f64,
    /// Largest unbalanced force relative to the forces in play.
    pub residual: f64,
    /// Length of the Newton step that is left, m, tilts by their arm: the error of the displacement.
    #[serde(rename = "displacement_error_m")]
    pub displacement_error: f64,
    /// Newton steps taken.
    pub newton_steps: usize,
    /// Moment and twist about the shaft's axis, where torsion was asked for.
    pub(crate) twist: Option<Twist>,
    /// Every bearing, in the order given.
    pub bearings: Vec<BearingState>,
    /// What the reader should know, each with its numbers.
    pub warnings: Vec<String>,
}

/// Answers a static question.
///
/// # Errors
/// [`RotorError`] where a bearing cannot be built, a number is outside its range, or nothing carries
/// the load.
pub fn quasi_static(question: &StaticQuestion) -> Result<QuasiStatic, RotorError> {
    answer_on(question, &build_supports(&question.rotor)?)
}

/// Answers a static question about bearings that are built already.
pub(crate) fn answer_on(
    question: &StaticQuestion,
    supports: &[Support],
) -> Result<QuasiStatic, RotorError> {
    let rotor = &question.rotor;
    let found = static_place(rotor, supports, question.unbalance, &question.displacement)?;
    let bearings = found.bearing_states(rotor, supports);
    let (free, equilibrium) = (found.free, found.equilibrium);
    let moments = bearings
        .iter()
        .map(|bearing| bearing.friction_moment.total());
    let friction = moments.sum();
    let arm = Support::largest(supports, Geometry::lever);
    // a freedom that the shaft lacks is judged only where something holds it
    let judged = std::array::from_fn(|axis| {
        let resisted = equilibrium.stiffness[(axis, axis)] != 0.0;
        free[axis] && (resisted || rotor.shaft.freedoms.moves(axis))
    });
    Ok(QuasiStatic {
        displacement: equilibrium.displacement,
        force: equilibrium.force,
        free,
        stiffness: equilibrium.stiffness,
        condition: condition(&equilibrium.stiffness, &judged, arm),
        residual: equilibrium.residual,
        displacement_error: equilibrium.displacement_error,
        newton_steps: equilibrium.newton_steps,
        twist: question.torsion.map(|torsion| torsion.twist(friction)),
        warnings: rotor.warnings_with(
            unconstrained(&equilibrium.stiffness, &judged)
                .into_iter()
                .chain(found.axial_hold.map(axial_hold_warning))
                .chain(warnings(supports, &bearings)),
        ),
        bearings,
    })
}

/// Largest over smallest singular value of K of the freedoms that are judged; 1 where there are none.
fn condition(stiffness: &Matrix5, judged: &[bool; FREEDOMS], arm: f64) -> f64 {
    let lengths = [1.0, 1.0, 1.0, arm, arm];
    let axes: Vec<usize> = (0..FREEDOMS).filter(|&axis| judged[axis]).collect();
    if axes.is_empty() {
        // held all around: nothing is solved for
        return 1.0;
    }
    let scaled = DMatrix::from_fn(axes.len(), axes.len(), |row, column| {
        let (row, column) = (axes[row], axes[column]);
        stiffness[(row, column)] / (lengths[row] * lengths[column])
    });
    let values = scaled.singular_values();
    let extreme = |of: fn(f64, f64) -> f64| values.iter().copied().fold(values[0], of);
    match extreme(f64::min) {
        0.0 => f64::INFINITY,
        smallest => extreme(f64::max) / smallest,
    }
}

/// Freedoms that are judged and meet no resistance.
fn unconstrained(stiffness: &Matrix5, judged: &[bool; FREEDOMS]) -> Option<String> {
    let names: Vec<&str> = (0..FREEDOMS)
        .filter(|&axis| judged[axis] && stiffness[(axis, axis)] == 0.0)
        .map(|axis| FREEDOM_NAMES[axis])
        .collect();
    (!names.is_empty()).then(|| {
        format!(
            "nothing resists the shaft along {}: no ball or roller bears there, and its position is one of many; \
             add a load or a preload, or hold it",
            names.join(", ")
        )
    })
}

fn warnings(supports: &[Support], bearings: &[BearingState]) -> Vec<String> {
    let mut warnings = Vec::new();
    for (index, (support, bearing)) in supports.iter().zip(bearings).enumerate() {
        let number = index + 1;
        let geometry = &support.definition().bearing.geometry;
        let balls = geometry.all_balls();
        if support.is_preloaded() && bearing.balls_loaded < balls {
            warnings.push(format!(
                "bearing {number}: the preload is lost on {} of {balls} {}s",
                balls - bearing.balls_loaded,
                geometry.element()
            ));
        }
        let own = bearing.warnings.iter();
        warnings.extend(own.map(|text| format!("bearing {number}: {text}")));
    }
    warnings
}

impl Torsion {
    /// Twist per moment `L/(G I_p)`, rad/(N m).
    pub fn compliance(&self) -> f64 {
        self.length / (self.shear_modulus * self.polar_second_moment)
    }

    /// Moment and twist, with the friction moment of all bearings in N m where that is the cause.
    ///
    /// `θz = M_z L/(G I_p)`
    fn twist(&self, friction: f64) -> Twist {
        let compliance = self.compliance();
        let (moment, angle) = match self.cause {
            TorsionCause::Friction => (friction, friction * compliance),
            TorsionCause::Moment(moment) => (moment, moment * compliance),
            TorsionCause::Angle(angle) => (angle / compliance, angle),
        };
        Twist { moment, angle }
    }
}
