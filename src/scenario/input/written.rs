//! What of a run is written, and in which formats.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Format of the tables of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TableFormat {
    /// Comma-separated values.
    Csv,
    /// Apache Parquet; only where `jeffcott` is built with it.
    Parquet,
    /// A MAT-file of MATLAB, level 5: one variable a column.
    Mat,
}

impl TableFormat {
    /// All formats.
    pub const ALL: [Self; 3] = [Self::Csv, Self::Parquet, Self::Mat];

    /// Name in a scenario, and the ending of its files.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Parquet => "parquet",
            Self::Mat => "mat",
        }
    }

    /// Whether this build can write it.
    pub fn is_built(self) -> bool {
        self != Self::Parquet || cfg!(feature = "parquet")
    }
}

/// A quantity of the trace, beside the time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TraceChannel {
    /// Shaft angle, rad.
    Angle,
    /// Angular speed, rad/s.
    Speed,
    /// Displacement along X, m.
    X,
    /// Displacement along Y, m.
    Y,
    /// Displacement along Z, m.
    Z,
    /// Tilt about X, rad.
    TiltX,
    /// Tilt about Y, rad.
    TiltY,
    /// Velocity along X, m/s.
    XVelocity,
    /// Velocity along Y, m/s.
    YVelocity,
    /// Velocity along Z, m/s.
    ZVelocity,
    /// Angular velocity about X, rad/s.
    TiltXVelocity,
    /// Angular velocity about Y, rad/s.
    TiltYVelocity,
    /// Force of the bearings along X, N.
    ForceX,
    /// Force of the bearings along Y, N.
    ForceY,
    /// Force of the bearings along Z, N.
    ForceZ,
    /// Moment of the bearings about X, N m.
    MomentX,
    /// Moment of the bearings about Y, N m.
    MomentY,
    /// Largest load on a ball, N.
    LargestBallLoad,
    /// Number of balls in contact.
    BallsLoaded,
}

impl TraceChannel {
    /// All quantities with their names in a scenario, in the order of the trace's columns; the name of a column
    /// is followed by the unit.
    pub const ALL: [(Self, &'static str); 19] = [
        (Self::Angle, "angle"),
        (Self::Speed, "speed"),
        (Self::X, "x"),
        (Self::Y, "y"),
        (Self::Z, "z"),
        (Self::TiltX, "tilt_x"),
        (Self::TiltY, "tilt_y"),
        (Self::XVelocity, "x_velocity"),
        (Self::YVelocity, "y_velocity"),
        (Self::ZVelocity, "z_velocity"),
        (Self::TiltXVelocity, "tilt_x_velocity"),
        (Self::TiltYVelocity, "tilt_y_velocity"),
        (Self::ForceX, "force_x"),
        (Self::ForceY, "force_y"),
        (Self::ForceZ, "force_z"),
        (Self::MomentX, "moment_x"),
        (Self::MomentY, "moment_y"),
        (Self::LargestBallLoad, "largest_ball_load"),
        (Self::BallsLoaded, "balls_loaded"),
    ];

    /// Name in a scenario.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_a_scenario() {
        for format in TableFormat::ALL {
            assert_eq!(serde_json::json!(format), format.extension());
        }
        for (place, (channel, name)) in TraceChannel::ALL.into_iter().enumerate() {
            assert_eq!(serde_json::json!(channel), name);
            assert_eq!(channel as usize, place);
        }
    }
}
