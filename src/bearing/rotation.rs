//! Angles and speeds of shaft and cage, as a bearing sees them.

/// Cosine and sine of an angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Angle {
    /// Cosine.
    pub cos: f64,
    /// Sine.
    pub sin: f64,
}

impl Angle {
    /// No angle.
    pub const ZERO: Self = Self { cos: 1.0, sin: 0.0 };

    /// An angle in rad.
    #[inline]
    pub fn new(angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { cos, sin }
    }
}

/// Where shaft and cage of a bearing point at an instant, and how fast they turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingRotation {
    /// Angle ψ_c of the cage from its start.
    pub cage: Angle,
    /// Angle ψ of the shaft from its start.
    pub shaft: Angle,
    /// ψ_c itself, rad: balls turn by multiples of it that are not whole.
    pub cage_angle: f64,
    /// Angular speed of the cage, rad/s.
    pub cage_speed: f64,
    /// Angular speed of the shaft, rad/s.
    pub speed: f64,
}

impl BearingRotation {
    /// A shaft of this speed in rad/s with its cage, both where they start; the cage is taken not to turn.
    pub fn at_start(speed: f64) -> Self {
        Self {
            cage: Angle::ZERO,
            shaft: Angle::ZERO,
            cage_angle: 0.0,
            cage_speed: 0.0,
            speed,
        }
    }

    /// The rotation with the cage at another angle in rad.
    pub fn with_cage_at(self, angle: f64) -> Self {
        Self {
            cage: Angle::new(angle),
            cage_angle: angle,
            ..self
        }
    }
}
