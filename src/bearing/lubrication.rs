//! What lubrication and cleanliness make of the rating life.

use serde::Serialize;

use super::{Bearing, Vector5};
use crate::physics::{
    Contamination, equivalent_load, life_modification_factor, reference_viscosity,
    reliability_factor,
};

/// Hours of 10⁶ revolutions at 1 rad/s.
const HOURS_PER_MREV: f64 = 1e6 * std::f64::consts::TAU / 3600.0;

/// The lubricant at the temperature of the bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lubrication {
    /// Kinematic viscosity of the oil, or of the base oil of a grease, m²/s.
    pub viscosity: f64,
    /// Whether it is a grease.
    pub grease: bool,
    /// How clean it is; the modified life needs it.
    pub contamination: Option<Contamination>,
}

/// Rating lives of a bearing under a load that stands still.
///
/// ```text
/// L10  = (C/P)³                ISO 281, P by [`equivalent_load`]
/// L10r                         ISO/TS 16281, by the loads of the balls
/// L_nm = a_1 a_ISO L10r        P of e_C C_u/P: C/L10r^(1/3)
/// ```
///
/// Source: ISO 281:2007; ISO/TS 16281:2008.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RatingLives {
    /// P of ISO 281, N; none without load.
    #[serde(rename = "equivalent_load_N")]
    pub equivalent_load: Option<f64>,
    /// L10 of ISO 281, 10⁶ revolutions.
    #[serde(rename = "basic_Mrev")]
    pub basic: Option<f64>,
    /// L10 in hours at the speed; none at rest.
    #[serde(rename = "basic_h")]
    pub basic_hours: Option<f64>,
    /// L10r of ISO/TS 16281, 10⁶ revolutions.
    #[serde(rename = "reference_Mrev")]
    pub reference: f64,
    /// L10r in hours at the speed; none at rest.
    #[serde(rename = "reference_h")]
    pub reference_hours: Option<f64>,
    /// The life with lubrication, cleanliness and reliability; none where none of them is given.
    pub modified: Option<ModifiedLife>,
}

/// A rating life with lubrication, cleanliness and reliability, and what it rests on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ModifiedLife {
    /// κ = ν/ν1; none without lubricant, or at rest.
    pub viscosity_ratio: Option<f64>,
    /// e_C.
    pub contamination_factor: Option<f64>,
    /// C_u, N.
    #[serde(rename = "fatigue_load_limit_N")]
    pub fatigue_load_limit: f64,
    /// a_ISO; none without contamination class: then the life is that of a_ISO = 1.
    pub life_modification_factor: Option<f64>,
    /// a_1.
    pub reliability_factor: f64,
    /// Reliability, per cent.
    #[serde(rename = "reliability_percent")]
    pub reliability: f64,
    /// L_nm, 10⁶ revolutions.
    #[serde(rename = "life_Mrev")]
    pub life: f64,
    /// L_nm in hours at the speed; none at rest.
    #[serde(rename = "life_h")]
    pub hours: Option<f64>,
}

/// Hours of a life in 10⁶ revolutions at a speed in rad/s; none at rest.
fn hours(life: f64, speed: f64) -> Option<f64> {
    (speed != 0.0).then(|| life * HOURS_PER_MREV / speed.abs())
}

impl Bearing {
    /// All rating lives: L10r in 10⁶ revolutions, the force of the ring in N, the speed in rad/s. None without a dynamic
    /// load rating.
    pub(super) fn rating_lives(
        &self,
        reference: f64,
        force: &Vector5,
        speed: f64,
    ) -> Option<RatingLives> {
        let rating = self.dynamic_rating?;
        let (radial, axial) = (force[0].hypot(force[1]), force[2].abs());
        let geometry = &self.geometry;
        let diameter = 1e3 * geometry.ball_diameter();
        let angle = geometry.nominal_angle();
        let area = geometry.balls() as f64 * diameter * diameter;
        let load = equivalent_load(radial, axial, angle, axial / area);
        let loaded = load > 0.0;
        let basic = loaded.then(|| (rating / load).powi(3));
        Some(RatingLives {
            equivalent_load: loaded.then_some(load),
            basic,
            basic_hours: basic.and_then(|life| hours(life, speed)),
            reference,
            reference_hours: hours(reference, speed),
            modified: self.modified_life(reference, speed),
        })
    }

    /// L_nm of a bearing whose life L10r in 10⁶ revolutions is known, at a speed in rad/s; none where neither
    /// lubricant nor reliability is given.
    pub(crate) fn modified_life(&self, reference: f64, speed: f64) -> Option<ModifiedLife> {
        let rating = self.dynamic_rating?;
        if self.lubrication.is_none() && self.reliability.is_none() {
            return None;
        }
        let pitch = self.geometry.pitch_diameter();
        let lubrication = self.lubrication.as_ref().filter(|_| speed != 0.0);
        let ratio = lubrication.map(|oil| oil.viscosity / reference_viscosity(speed, pitch));
        let contamination = lubrication
            .and_then(|oil| oil.contamination)
            .map(|class| class.factor(pitch));
        let limit = self.fatigue_load_limit().ok()?;
        // P = C/L^(1/3)
        let load = rating / reference.cbrt();
        let factor = ratio
            .zip(contamination)
            .map(|(ratio, factor)| life_modification_factor(ratio, factor * limit / load));
        let reliability = self.reliability.unwrap_or(90.0);
        let reliability_factor = reliability_factor(reliability);
        let life = reliability_factor * factor.unwrap_or(1.0) * reference;
        Some(ModifiedLife {
            viscosity_ratio: ratio,
            contamination_factor: contamination,
            fatigue_load_limit: limit,
            life_modification_factor: factor,
            reliability_factor,
            reliability,
            life,
            hours: hours(life, speed),
        })
    }
}
