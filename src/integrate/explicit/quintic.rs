//! Motion within a step from place, velocity and acceleration at its ends: no evaluation is needed.

/// Largest value of θ³(1−θ)³ and of the magnitude of its slope on 0 … 1.
const PLACE_PEAK: f64 = 1.0 / 64.0;
const VELOCITY_PEAK: f64 = 0.053_665_631_459_994_95;

/// The polynomial of degree five, in parts θ of the step of size h, that meets both ends:
///
/// ```text
/// q(θ) = q₀ + θ h v₀ + θ² h² a₀/2 + θ³ (c₃ + c₄ θ + c₅ θ²)
/// ```
#[derive(Debug, Clone, Copy)]
pub(super) struct Quintic {
    cubic: f64,
    quartic: f64,
    quintic: f64,
}

/// Place, velocity and acceleration.
pub(super) type Motion = [f64; 3];

impl Quintic {
    #[inline(always)]
    pub fn new(size: f64, [q0, v0, a0]: Motion, [q1, v1, a1]: Motion) -> Self {
        let place = q1 - q0 - size * (v0 + 0.5 * size * a0);
        let velocity = size * (v1 - v0 - size * a0);
        let acceleration = 0.5 * size * size * (a1 - a0);
        Self {
            cubic: 10.0 * place - 4.0 * velocity + acceleration,
            quartic: -15.0 * place + 7.0 * velocity - 2.0 * acceleration,
            quintic: 6.0 * place - 3.0 * velocity + acceleration,
        }
    }

    /// Place and velocity at a part of the step.
    #[inline(always)]
    pub fn at(&self, part: f64, size: f64, [q0, v0, a0]: Motion) -> [f64; 2] {
        let Self {
            cubic,
            quartic,
            quintic,
        } = *self;
        let square = part * part;
        let place = cubic + part * (quartic + part * quintic);
        let velocity = 3.0 * cubic + part * (4.0 * quartic + part * 5.0 * quintic);
        [
            q0 + size * part * (v0 + 0.5 * size * part * a0) + square * part * place,
            v0 + size * part * a0 + square * velocity / size,
        ]
    }

    /// h³ q‴ at the start and at the end of the step.
    #[inline(always)]
    pub fn jerks(&self) -> [f64; 2] {
        let start = 6.0 * self.cubic;
        [start, start + 24.0 * self.quartic + 60.0 * self.quintic]
    }
}

/// Largest errors of place and velocity within a step of size h, from the jump of q‴ at its start
/// after a step of size h′:
///
/// ```text
/// q − p = q⁽⁶⁾/720 (t−t₀)³(t−t₁)³   so   jump = q⁽⁶⁾/120 (h³ + h′³)
/// ```
#[inline(always)]
pub(super) fn errors(jump: f64, size: f64, before: f64) -> [f64; 2] {
    let sixth = 120.0 * jump.abs() / (size.powi(3) + before.powi(3));
    let fifth_power = size.powi(5) / 720.0;
    [
        sixth * fifth_power * size * PLACE_PEAK,
        sixth * fifth_power * VELOCITY_PEAK,
    ]
}
