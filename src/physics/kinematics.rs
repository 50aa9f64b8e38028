//! Rolling kinematics: speeds of cage and balls, and the frequencies they cause.

use std::f64::consts::TAU;

use serde::Serialize;

/// Nominal cage speed for a fixed outer ring, rad/s.
///
/// `ω_c = (ω/2)(1 − γ)`, `γ = D cos α/d_m`
///
/// Pure rolling at both races with equal contact angles.
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), eq. 10.13.
///
/// ```
/// use jeffcott::physics::nominal_cage_speed;
/// // 6205-2RS of the Case Western Reserve bearing data: FTF = 0.39828 × shaft speed.
/// let gamma = 0.3126 / 1.537;
/// assert!((nominal_cage_speed(1.0, gamma) - 0.39828).abs() < 5e-5);
/// ```
pub fn nominal_cage_speed(shaft_speed: f64, gamma: f64) -> f64 {
    0.5 * shaft_speed * (1.0 - gamma)
}

/// Frequencies at which rolling elements meet a point of each part, Hz.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BallPass {
    /// Ball-pass frequency of the outer race (BPFO): also the varying-compliance frequency.
    #[serde(rename = "outer_Hz")]
    pub outer: f64,
    /// Ball-pass frequency of the inner race (BPFI).
    #[serde(rename = "inner_Hz")]
    pub inner: f64,
    /// Ball spin frequency (BSF): revolutions of a ball about its own axis.
    #[serde(rename = "spin_Hz")]
    pub spin: f64,
    /// Cage frequency, also called fundamental train frequency (FTF).
    #[serde(rename = "cage_Hz")]
    pub cage: f64,
}

impl BallPass {
    /// Frequencies of Z balls between an inner and an outer ring that turn at frequencies in Hz, as their cage does; a ball that rolls
    /// on the outer race turns by `rolling_ratio`, (1 + γ) d_m/D, of what its cage does past that race.
    ///
    /// `BPFO = Z |f_o − f_c|`, `BPFI = Z |f_i − f_c|`
    ///
    /// ```
    /// use jeffcott::physics::BallPass;
    /// // a cage that slips by 1 % of 40 Hz
    /// let slipping = BallPass::from_rings([100.0, 0.0], 39.6, 9, 6.0);
    /// assert!((slipping.outer - 356.4).abs() < 1e-9 && (slipping.inner - 543.6).abs() < 1e-9);
    /// ```
    pub fn from_rings(
        [inner, outer]: [f64; 2],
        cage: f64,
        balls: usize,
        rolling_ratio: f64,
    ) -> Self {
        let past = [inner, outer].map(|ring| (ring - cage).abs());
        Self {
            outer: balls as f64 * past[1],
            inner: balls as f64 * past[0],
            spin: rolling_ratio * past[1],
            cage,
        }
    }
}

/// Ball-pass frequencies for a fixed outer ring.
///
/// ```text
/// FTF  = (f/2)(1 − γ)          BPFO = Z FTF
/// BPFI = Z (f/2)(1 + γ)        BSF  = (f/2)(1 − γ²) d_m/D
/// ```
///
/// `f = ω/2π` shaft frequency, `Z` number of balls, `γ = D cos α/d_m`.
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), ch. 10.
///
/// ```
/// use jeffcott::physics::ball_pass_frequencies;
/// use std::f64::consts::TAU;
/// // 6205-2RS (9 balls, 0.3126 in, pitch 1.537 in, 0°), Case Western Reserve bearing data:
/// // BPFO 3.5848, BPFI 5.4152, FTF 0.39828, 2 × BSF 4.7135 times shaft speed.
/// let pass = ball_pass_frequencies(TAU, 9, 0.3126, 1.537, 0.3126 / 1.537);
/// assert!((pass.outer - 3.5848).abs() < 5e-4);
/// assert!((pass.inner - 5.4152).abs() < 5e-4);
/// assert!((pass.cage - 0.39828).abs() < 5e-5);
/// assert!((2.0 * pass.spin - 4.7135).abs() < 5e-4);
/// ```
pub fn ball_pass_frequencies(
    shaft_speed: f64,
    balls: usize,
    ball_diameter: f64,
    pitch_diameter: f64,
    gamma: f64,
) -> BallPass {
    let cage = nominal_cage_speed(shaft_speed, gamma) / TAU;
    let rolling_ratio = (1.0 + gamma) * pitch_diameter / ball_diameter;
    BallPass::from_rings([shaft_speed / TAU, 0.0], cage, balls, rolling_ratio)
}
