//! What is known of a loaded bearing: plain data, ball by ball and as a whole.

use serde::{Serialize, Serializer};

use super::{BallContact, Clearance, Matrix5, RatingLives, RollerKind, Vector5};
use crate::keys;
use crate::physics::{BallPass, Race};

/// One contact of one ball.
///
/// Ellipse, pressure, approach and stiffness are those of the geometry's own Hertz contact under the
/// load, for a bearing whose `contact_stiffness` is given for both races together, too.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct RaceContact {
    /// Normal load Q, N.
    #[serde(rename = "load_N")]
    pub load: f64,
    /// Contact angle α, rad.
    #[serde(rename = "angle_rad")]
    pub angle: f64,
    /// Elastic approach δ of ball and race, m.
    #[serde(rename = "approach_m")]
    pub approach: f64,
    /// Semi-axis of the contact ellipse across the rolling direction, m; of a roller, half of its effective length.
    #[serde(rename = "semi_major_m")]
    pub semi_major: f64,
    /// Semi-axis along the rolling direction, m; of a roller, that of the slice which is pressed most.
    #[serde(rename = "semi_minor_m")]
    pub semi_minor: f64,
    /// Largest contact pressure, Pa.
    #[serde(rename = "peak_pressure_Pa")]
    pub peak_pressure: f64,
    /// Stiffness of the elastic contact along its normal, `3/2 K^(2/3) Q^(1/3)`, N/m.
    #[serde(rename = "contact_stiffness_N_m")]
    pub contact_stiffness: f64,
    /// Oil film, where the bearing has oil, turns, and the ball is loaded.
    pub film: Option<FilmState>,
    /// Spin-to-roll ratio, dimensionless; zero at standstill and without load. A law without inertia
    /// has no race control of its own: there the ball rolls as under outer control, without spin at
    /// the outer race.
    pub spin_to_roll: f64,
    /// Angle from the contact's centre line to the shoulder less the half-angle of the ellipse, rad;
    /// negative where the ellipse is cut off: `α_s − |α| − asin(a/(f D))`. Known where a shoulder
    /// angle is given and the ball is loaded.
    #[serde(rename = "shoulder_margin_rad")]
    pub shoulder_margin: Option<f64>,
}

/// Oil film of one contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FilmState {
    /// Central thickness h_c, m.
    #[serde(rename = "central_m")]
    pub central: f64,
    /// Minimum thickness h_min, m.
    #[serde(rename = "minimum_m")]
    pub minimum: f64,
    /// Stiffness of the film along the contact normal, N/m.
    #[serde(rename = "stiffness_N_m")]
    pub stiffness: f64,
    /// h_min over the roughness of the surfaces, where that is given.
    pub lambda: Option<f64>,
}

/// What a ball at some azimuth bears.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Around {
    /// Number of its row, from 1 on.
    pub row: usize,
    /// Number of the azimuth in its row, from 1 on.
    pub position: usize,
    /// Azimuth φ, rad, from +X towards +Y.
    #[serde(rename = "azimuth_rad")]
    pub azimuth: f64,
    /// Change of the distance of the groove centres from the unloaded one, m.
    #[serde(rename = "deformation_m")]
    pub deformation: f64,
    /// Loads and contact angles.
    #[serde(flatten)]
    pub contact: BallContact,
}

/// One ball or roller in its place.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BallLine {
    /// Number of its row, from 1 on.
    pub row: usize,
    /// Azimuth φ, rad, from +X towards +Y.
    #[serde(rename = "azimuth_rad")]
    pub azimuth: f64,
    /// Change of the distance of the groove centres from the unloaded one, d − A, m: the total
    /// deformation of both contacts less the oil films between them; a gap of dry races where it is
    /// negative.
    #[serde(rename = "deformation_m")]
    pub deformation: f64,
    /// Contact with the inner race.
    pub inner: RaceContact,
    /// Contact with the outer race.
    pub outer: RaceContact,
    /// Centrifugal force F_c, N; zero where the law neglects inertia.
    #[serde(rename = "centrifugal_force_N")]
    pub centrifugal_force: f64,
    /// Gyroscopic moment M_g, N m; zero where the law neglects inertia.
    #[serde(rename = "gyroscopic_moment_N_m")]
    pub gyroscopic_moment: f64,
    /// Race that would control the ball's spin by Jones's criterion, whatever `race_control` takes; none for an unloaded
    /// ball or a law without inertia.
    pub controlling_race: Option<Race>,
    /// Slices of a roller; none of a ball.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub laminae: Vec<LaminaLine>,
}

impl BallLine {
    /// Loads that the life goes by, N: of the ball at both races, or of each slice of a roller.
    pub(super) fn rated_loads(&self) -> Vec<[f64; 2]> {
        match self.laminae.as_slice() {
            [] => vec![[self.inner.load, self.outer.load]],
            slices => slices.iter().map(|slice| [slice.load; 2]).collect(),
        }
    }
}

/// One slice of a roller.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct LaminaLine {
    /// Middle of the slice from that of the roller, m; towards +Z at a contact angle of zero and facing +Z.
    #[serde(rename = "position_m")]
    pub position: f64,
    /// Approach of both races together, m; a gap where it is negative.
    #[serde(rename = "approach_m")]
    pub approach: f64,
    /// Load, N.
    #[serde(rename = "load_N")]
    pub load: f64,
    /// Largest pressure at the inner and the outer race, Pa.
    #[serde(rename = "peak_pressure_Pa")]
    pub peak_pressure: [f64; 2],
}

/// Internal geometry of a bearing, and the ratings that it has by the standards' formulas.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct InternalGeometry {
    /// Number of balls.
    pub balls: usize,
    /// Ball diameter, m.
    #[serde(rename = "ball_diameter_m")]
    pub ball_diameter: f64,
    /// Pitch diameter, m.
    #[serde(rename = "pitch_diameter_m")]
    pub pitch_diameter: f64,
    /// Contact angle, rad: nominal of a catalogue line, free as mounted of a bearing.
    #[serde(rename = "contact_angle_rad")]
    pub contact_angle: f64,
    /// Groove factor of the inner race.
    pub groove_factor_inner: f64,
    /// Groove factor of the outer race.
    pub groove_factor_outer: f64,
    /// C of ISO 281, N, [`crate::physics::dynamic_rating`].
    #[serde(rename = "dynamic_rating_N")]
    pub dynamic_rating: f64,
    /// C_0 at the contact pressure of ISO 76, N, [`super::Bearing::static_rating`].
    #[serde(rename = "static_rating_N")]
    pub static_rating: f64,
}

/// Rollers of a bearing, and the rating that they have by the standards' formulas.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RollerGeometry {
    /// Kind of the bearing.
    pub kind: RollerKind,
    /// Number of rollers a row.
    pub rollers: usize,
    /// Number of rows.
    pub rows: usize,
    /// Roller diameter in its middle, m.
    #[serde(rename = "roller_diameter_m")]
    pub diameter: f64,
    /// Effective length, m.
    #[serde(rename = "roller_length_m")]
    pub length: f64,
    /// Pitch diameter, m.
    #[serde(rename = "pitch_diameter_m")]
    pub pitch_diameter: f64,
    /// Contact angle, rad.
    #[serde(rename = "contact_angle_rad")]
    pub contact_angle: f64,
    /// Number of slices of a roller.
    pub laminae: usize,
    /// C of ISO 281, N, [`crate::physics::roller_dynamic_rating`].
    #[serde(rename = "dynamic_rating_N")]
    pub dynamic_rating: f64,
    /// C_0 of ISO 76, N, [`crate::physics::roller_static_rating`].
    #[serde(rename = "static_rating_N")]
    pub static_rating: f64,
}

/// What rolls in a bearing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Elements {
    /// Balls.
    Balls(InternalGeometry),
    /// Rollers.
    Rollers(RollerGeometry),
}

impl Elements {
    /// What one of them is called.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Balls(_) => "ball",
            Self::Rollers(_) => "roller",
        }
    }
}

/// Internal geometry of a bearing as it is mounted, and whether it is known.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct GeometryState {
    /// Balls or rollers, races and ratings.
    #[serde(flatten)]
    pub elements: Elements,
    /// C_u of ISO 281, N, [`super::Bearing::fatigue_load_limit`].
    #[serde(rename = "fatigue_load_limit_N")]
    pub fatigue_load_limit: f64,
    /// Whether balls, pitch diameter or grooves were estimated from a catalogue's ratings, and with them every number that
    /// rests on them.
    pub estimated: bool,
}

/// A bearing under load.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BearingState {
    /// Its internal geometry.
    pub(crate) geometry: GeometryState,
    /// Clearance of a deep-groove bearing; none of an angular contact bearing.
    pub clearance: Option<Clearance>,
    /// Displacement of the inner from the outer ring, in the bearing's own orientation, m and rad.
    #[serde(serialize_with = "keys::displacement")]
    pub displacement: Vector5,
    /// Force of the inner ring onto the bearing, in the bearing's own orientation, N and N m.
    #[serde(serialize_with = "keys::force")]
    pub force: Vector5,
    /// ∂F/∂q in the bearing's own orientation.
    #[serde(serialize_with = "keys::stiffness")]
    pub stiffness: Matrix5,
    /// Stiffness of the elastic contacts alone and of the oil films alone at the same ball loads;
    /// none without oil or at rest.
    pub(crate) shares: Option<StiffnessShares>,
    /// Ball by ball, ball 0 first.
    pub balls: Vec<BallLine>,
    /// Number of balls loaded at the inner race: by more than a millionth of the largest load there,
    /// for behind oil films no load quite vanishes.
    pub balls_loaded: usize,
    /// Basic reference rating life L10r, [`super::reference_rating_life`], 10⁶ revolutions; none without a dynamic load rating or load.
    #[serde(rename = "life_Mrev")]
    pub life: Option<f64>,
    /// Permissible static ball load of ISO 76, [`super::permissible_static_load`], over the largest
    /// one, at the race where that is less; none without load.
    pub static_safety: Option<f64>,
    /// Rating lives in revolutions and hours, L10 and P only where a radial or axial force acts; none without a dynamic load
    /// rating or load.
    pub rating_lives: Option<RatingLives>,
    /// What fits and temperatures have done to it; none without them.
    pub(crate) fit: Option<FitState>,
    /// Axial force that the inner ring carries at standstill without load, N: the preload in operation. A shaft that is free
    /// is axially where the axial forces of its bearings balance, and is otherwise not displaced.
    #[serde(rename = "preload_N")]
    pub preload: f64,
    /// Friction moment after SKF, [`crate::physics::SkfFriction`]; known of deep-groove bearings of a catalogue with
    /// oil, in motion.
    pub friction_moment_skf: Option<SkfMoment>,
    /// Friction moment after Palmgren, [`crate::physics::FrictionFactors`], of an oil of
    /// [`crate::physics::MINERAL_OIL_DENSITY`].
    pub friction_moment: FrictionMoment,
    /// Whether its oil is known.
    #[serde(skip)]
    pub(crate) has_oil: bool,
    /// Ball-pass frequencies with the cage as the scene lets it turn, `model.cage`, Hz.
    pub ball_pass: BallPass,
    /// Ball-pass frequencies at the nominal contact angle without slip, as handbooks print them, Hz.
    pub nominal_ball_pass: BallPass,
    /// What the reader should know, each with its numbers.
    pub warnings: Vec<String>,
}

/// Series springs that a bearing with oil is made of, both at the present loads and contact angles.
///
/// Ball by ball the spring along the contact normal is replaced: by the elastic contacts of both
/// races, `3/2 K^(2/3) Q^(1/3)`, or by both films, `1/k = 0.067 (h_i/Q_i + h_o/Q_o)` along the
/// normal of the inner race. What stiffness comes from the turning of loaded contacts (Q/d) and, under
/// Jones's law, what yields by the ball's own balance, is part of `contacts` only. So along its normal
/// the compliances of a ball without inertia add up: `1/k = 1/k_contacts + 1/k_films`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StiffnessShares {
    /// K of the elastic contacts alone, films taken as rigid.
    #[serde(serialize_with = "keys::diagonal")]
    pub contacts: Matrix5,
    /// K of the oil films alone, contacts taken as rigid.
    #[serde(serialize_with = "keys::diagonal")]
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

/// Friction moment after SKF and its parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkfMoment {
    /// Rolling part, N m.
    pub rolling: f64,
    /// Sliding part, N m.
    pub sliding: f64,
}

impl Serialize for SkfMoment {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map([
            ("rolling_N_m", self.rolling),
            ("sliding_N_m", self.sliding),
            ("total_N_m", self.rolling + self.sliding),
        ])
    }
}

impl Serialize for FrictionMoment {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map([
            ("load_N_m", self.load),
            ("viscous_N_m", self.viscous),
            ("total_N_m", self.total()),
        ])
    }
}

impl FrictionMoment {
    /// Sum of the parts, N m.
    pub fn total(&self) -> f64 {
        self.load + self.viscous
    }
}

/// What fits and temperatures have done to a bearing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FitState {
    /// Interference in operation of inner and outer ring; negative where the ring is loose, m.
    #[serde(rename = "interference_m")]
    pub interference: [f64; 2],
    /// Pressure in the seats of inner and outer ring, Pa.
    #[serde(rename = "pressure_Pa")]
    pub pressure: [f64; 2],
    /// Clearance taken by the fits of inner and outer ring, m, diametral.
    #[serde(rename = "clearance_loss_m")]
    pub clearance_loss: [f64; 2],
    /// Change of the clearance by the temperatures of rings and balls, m, diametral.
    #[serde(rename = "thermal_change_m")]
    pub thermal_change: f64,
    /// Change of the clearance altogether, m, diametral.
    #[serde(rename = "clearance_change_m")]
    pub clearance_change: f64,
    /// Free contact angle as made, rad.
    #[serde(rename = "contact_angle_before_rad")]
    pub angle_before: f64,
    /// Free contact angle in operation, rad.
    #[serde(rename = "contact_angle_rad")]
    pub angle: f64,
    /// Axial preset of the inner ring before and in operation, m; none of a spring preload.
    #[serde(rename = "axial_offset_m")]
    pub axial_offset: Option<[f64; 2]>,
}
