//! The friction moment of a mounted bearing.

use super::static_rating::static_rating;
use super::{Bearing, FrictionMoment, MountedBearing, Oil, RaceContacts, SkfMoment, Vector5};
use crate::physics::{FrictionFactors, MINERAL_OIL_DENSITY, SkfOperation};

/// What the friction moment of a bearing rests on besides load and speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BearingFriction {
    factors: FrictionFactors,
    pitch_diameter: f64,
    /// C_0, N.
    static_rating: f64,
    /// Kinematic viscosity, m²/s; none without oil.
    viscosity: Option<f64>,
}

impl BearingFriction {
    /// Friction of a bearing with `contacts` at its nominal contact angle.
    pub fn new(definition: &MountedBearing, contacts: &RaceContacts) -> Self {
        let bearing = &definition.bearing;
        let lubricant = bearing.lubrication.map(|lubricant| lubricant.viscosity);
        // ν = η0/ρ
        let kinematic = |oil: Oil| oil.viscosity / MINERAL_OIL_DENSITY;
        Self {
            factors: FrictionFactors::from_contact_angle(bearing.geometry.nominal_angle()),
            pitch_diameter: bearing.geometry.pitch_diameter(),
            static_rating: static_rating(&bearing.geometry, contacts),
            viscosity: lubricant.or(definition.oil.map(kinematic)),
        }
    }

    /// Moment under a force of the ring in N at a shaft speed in rad/s.
    pub fn moment(&self, force: &Vector5, speed: f64) -> FrictionMoment {
        let (factors, pitch) = (&self.factors, self.pitch_diameter);
        let radial = force[0].hypot(force[1]);
        let viscous = |viscosity| factors.viscous_moment(viscosity, speed, pitch);
        FrictionMoment {
            load: factors.load_moment(radial, force[2], self.static_rating, pitch),
            viscous: self.viscosity.map_or(0.0, viscous),
        }
    }
}

/// Moment after SKF under a force of the ring in N at a shaft speed in rad/s, where series, boundary dimensions and
/// lubricant of a bearing are known.
pub(super) fn skf_moment(
    bearing: &Bearing,
    contacts: &RaceContacts,
    force: &Vector5,
    speed: f64,
) -> Option<SkfMoment> {
    let lubrication = bearing.lubrication?;
    let operation = SkfOperation {
        boundary: bearing.boundary?,
        pitch_diameter: bearing.geometry.pitch_diameter(),
        static_rating: static_rating(&bearing.geometry, contacts),
        loads: [force[0].hypot(force[1]), force[2]],
        viscosity: lubrication.viscosity,
        speed,
        grease: lubrication.grease,
    };
    let [rolling, sliding] = bearing.skf_friction?.moment(&operation);
    (speed != 0.0).then_some(SkfMoment { rolling, sliding })
}
