//! Why a set of dimensions is not a bearing.

use super::{Geometry, Rollers};

/// A length in mm to a nanometre.
fn millimetres(length: f64) -> f64 {
    (1e9 * length).round() / 1e6
}

/// Why a set of dimensions is not a bearing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GeometryError {
    /// Too few or too many balls to be a bearing.
    #[error("{balls} rolling elements: a row has {min} to {max}", min = Geometry::FEWEST_BALLS, max = Geometry::MOST_BALLS)]
    Balls {
        /// Number of balls as given.
        balls: usize,
    },
    /// A dimension is no length of a bearing.
    #[error(
        "{name} is {value} m; it must be from {} m to {} m",
        Geometry::LENGTHS.start(), Geometry::LENGTHS.end()
    )]
    Length {
        /// What the dimension is called.
        name: &'static str,
        /// Value as given, m.
        value: f64,
    },
    /// The groove is not wider than the ball.
    #[error(
        "groove factor of the {race} race is {value}; the groove radius must exceed half the ball \
         diameter and stay below it: 0.5 < f ≤ 1"
    )]
    GrooveFactor {
        /// Which race.
        race: &'static str,
        /// Groove factor f = r/D as given.
        value: f64,
    },
    /// The contact angle is outside 0° … 60°.
    #[error("the contact angle is {degrees}°; it must be in 0° … 60°")]
    ContactAngle {
        /// Angle as given, degrees.
        degrees: f64,
    },
    /// The clearance asks for a contact angle above 60°, or squeezes the balls too much.
    #[error(
        "a diametral clearance of {clearance} m does not fit the grooves: it must be in {smallest} … \
         {largest} m, where the balls are squeezed by a tenth of the distance of the groove centres and where the free \
         contact angle reaches 60°"
    )]
    Clearance {
        /// Diametral clearance as given, m.
        clearance: f64,
        /// Smallest clearance that is taken for one, m; negative.
        smallest: f64,
        /// Largest clearance that the grooves allow, m.
        largest: f64,
    },
    /// A change of clearance leads to a contact angle above 60°, or squeezes the balls too much.
    #[error(
        "a change of the diametral clearance by {change} m does not fit: it must be in {smallest} … \
         {largest} m, where the balls are squeezed by a tenth of the distance of the groove centres and where the free \
         contact angle reaches 60°"
    )]
    ClearanceChange {
        /// Change as given, m.
        change: f64,
        /// Smallest change that fits, m.
        smallest: f64,
        /// Largest change that fits, m.
        largest: f64,
    },
    /// Rollers lie at an angle that their kind does not have.
    #[error("the contact angle of {kind} rollers: {rule}")]
    RollerAngle {
        /// Kind of the bearing.
        kind: &'static str,
        /// Angle as given, degrees.
        degrees: f64,
        /// What it must be.
        rule: &'static str,
    },
    /// A barrel does not fit into its races.
    #[error(
        "barrels with a radius of {roller_radius} m along {length} m in races of {race_radius} m: half the length must be less \
         than the radius, and that no more than the radius of the races"
    )]
    Barrel {
        /// Radius of the roller along its length, m.
        roller_radius: f64,
        /// That of both races, m.
        race_radius: f64,
        /// Length of the roller, m.
        length: f64,
    },
    /// A roller is cut into too few or too many slices.
    #[error("{laminae} laminae: a roller is cut into {min} to {max}", min = Rollers::FEWEST_LAMINAE, max = Rollers::MOST_LAMINAE)]
    Laminae {
        /// Number as given.
        laminae: usize,
    },
    /// The clearance of rollers is out of all proportion.
    #[error(
        "a diametral clearance of {clearance} m does not fit rollers of {diameter} m: its size must stay below a twentieth \
         of them"
    )]
    RollerClearance {
        /// Diametral clearance as given, m.
        clearance: f64,
        /// Diameter of the rollers, m.
        diameter: f64,
    },
    /// Balls or rollers reach beyond the bearing.
    #[error(
        "{element}s of {} mm on a pitch circle of {} mm reach from {} to {} mm, and the rings around them lie between a bore of {} mm \
         and an outside diameter of {} mm",
        millimetres(*diameter), millimetres(*pitch_diameter), millimetres(pitch_diameter - diameter),
        millimetres(pitch_diameter + diameter), millimetres(boundary[0]), millimetres(boundary[1])
    )]
    Section {
        /// `ball` or `roller`.
        element: &'static str,
        /// Their diameter, m.
        diameter: f64,
        /// Pitch diameter, m.
        pitch_diameter: f64,
        /// Bore and outside diameter, m.
        boundary: [f64; 2],
    },
    /// The balls overlap on the pitch circle.
    #[error(
        "{balls} rolling elements of {ball_diameter} m overlap on a pitch circle of {pitch_diameter} m: at \
         most {largest} fit"
    )]
    Overlap {
        /// Number of balls.
        balls: usize,
        /// Ball diameter, m.
        ball_diameter: f64,
        /// Pitch diameter, m.
        pitch_diameter: f64,
        /// How many balls fit.
        largest: usize,
    },
}

impl GeometryError {
    /// Whether rings of a bore and an outside diameter have room beside balls or rollers of a diameter on a pitch circle, m.
    pub(super) fn check_section(
        element: &'static str,
        [diameter, pitch_diameter]: [f64; 2],
        boundary: [f64; 2],
    ) -> Result<(), Self> {
        let [bore, outside] = boundary;
        if bore < pitch_diameter - diameter && pitch_diameter + diameter < outside {
            return Ok(());
        }
        Err(Self::Section {
            element,
            diameter,
            pitch_diameter,
            boundary,
        })
    }
}
