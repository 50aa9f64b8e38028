//! What is known of a loaded bearing: plain data, ball by ball and as a whole.

use super::ring::{Matrix5, Vector5};
use crate::physics::{BallPass, Race};

/// One contact of one ball.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RaceContact {
    /// Normal load Q, N.
    pub load: f64,
    /// Contact angle α, rad.
    pub angle: f64,
    /// Elastic approach δ of ball and race, m.
    pub approach: f64,
    /// Semi-axis of the contact ellipse across the rolling direction, m.
    pub semi_major: f64,
    /// Semi-axis along the rolling direction, m.
    pub semi_minor: f64,
    /// Largest contact pressure, Pa.
    pub peak_pressure: f64,
    /// Stiffness of the elastic contact along its normal, N/m.
    pub contact_stiffness: f64,
    /// Oil film, where the bearing has oil and the ball is loaded.
    pub film: Option<FilmState>,
    /// Spin-to-roll ratio, dimensionless; zero at standstill.
    pub spin_to_roll: f64,
    /// Angle from the contact's centre line to the shoulder less the half-angle of the ellipse, rad;
    /// negative where the ellipse is cut off. Known where a shoulder angle is given.
    pub shoulder_margin: Option<f64>,
}

/// Oil film of one contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmState {
    /// Central thickness h_c, m.
    pub central: f64,
    /// Minimum thickness h_min, m.
    pub minimum: f64,
    /// Stiffness of the film along the contact normal, N/m.
    pub stiffness: f64,
    /// h_min over the roughness of the surfaces, where that is given.
    pub lambda: Option<f64>,
}

/// One ball in its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallLine {
    /// Azimuth φ, rad, from +X towards +Y.
    pub azimuth: f64,
    /// Change of the distance of the groove centres from the unloaded one, m: the total deformation
    /// of both contacts where it is positive, a gap where it is negative.
    pub deformation: f64,
    /// Contact with the inner race.
    pub inner: RaceContact,
    /// Contact with the outer race.
    pub outer: RaceContact,
    /// Centrifugal force F_c, N; zero where the law neglects inertia.
    pub centrifugal_force: f64,
    /// Gyroscopic moment M_g, N m; zero where the law neglects inertia.
    pub gyroscopic_moment: f64,
    /// Race that controls the ball's spin by Jones's criterion; none for an unloaded ball or a law
    /// without inertia.
    pub controlling_race: Option<Race>,
}

/// A bearing under load.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingState {
    /// Displacement of the inner from the outer ring, in the bearing's own orientation, m and rad.
    pub displacement: Vector5,
    /// Force of the inner ring onto the bearing, in the bearing's own orientation, N and N m.
    pub force: Vector5,
    /// ∂F/∂q in the bearing's own orientation.
    pub stiffness: Matrix5,
    /// Stiffness of the elastic contacts alone and of the oil films alone at the same ball loads;
    /// none without oil.
    pub shares: Option<StiffnessShares>,
    /// Ball by ball, ball 0 first.
    pub balls: Vec<BallLine>,
    /// Number of balls loaded at the inner race.
    pub balls_loaded: usize,
    /// Basic reference rating life L10r, 10⁶ revolutions; none without a dynamic load rating or load.
    pub life: Option<f64>,
    /// Permissible static ball load of ISO 76 over the largest one; none without load.
    pub static_safety: Option<f64>,
    /// Friction moment, N m.
    pub friction_moment: FrictionMoment,
    /// Ball-pass frequencies at the mean operating contact angle, Hz.
    pub ball_pass: BallPass,
    /// What the reader should know, each with its numbers.
    pub warnings: Vec<String>,
}

/// Series springs that a bearing with oil is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct StiffnessShares {
    /// K of the elastic contacts alone, films taken as rigid.
    pub contacts: Matrix5,
    /// K of the oil films alone, contacts taken as rigid.
    pub films: Matrix5,
}

/// Friction moment of a bearing and its parts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrictionMoment {
    /// Part that grows with the load, N m.
    pub load: f64,
    /// Viscous part, N m; zero without oil.
    pub viscous: f64,
}

impl FrictionMoment {
    /// Sum of the parts, N m.
    pub fn total(&self) -> f64 {
        self.load + self.viscous
    }
}
