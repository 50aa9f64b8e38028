//! The friction moment of a mounted bearing.

use super::static_rating::static_rating;
use super::{
    Bearing, FrictionMoment, Geometry, MountedBearing, Oil, RaceContacts, RollerKind, SkfMoment,
    Vector5,
};
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
            factors: friction_factors(&bearing.geometry),
            pitch_diameter: bearing.geometry.pitch_diameter(),
            static_rating: static_rating(&bearing.geometry, contacts),
            viscosity: lubricant.or(definition.oil.map(kinematic)),
        }
    }

    /// Whether the viscosity of its oil is known.
    pub fn has_oil(&self) -> bool {
        self.viscosity.is_some()
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

/// Coefficients of a kind of bearing in an oil bath; of rollers the middle of the ranges in the source.
fn friction_factors(geometry: &Geometry) -> FrictionFactors {
    let angle = geometry.nominal_angle();
    let Some(rollers) = geometry.rollers() else {
        return FrictionFactors::from_contact_angle(angle);
    };
    let [load, viscous] = match rollers.kind {
        RollerKind::Cylindrical => [3e-4, 3.0],
        RollerKind::Needle => [5.5e-4, 12.0],
        RollerKind::Tapered => [4e-4, 6.0],
        RollerKind::Spherical => [4.5e-4, 5.0],
    };
    FrictionFactors::of_rollers(load, viscous, angle)
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
        static_rating: static_rating(&bearing.geometry, contacts),
        loads: [force[0].hypot(force[1]), force[2]],
        viscosity: lubrication.viscosity,
        speed,
        grease: lubrication.grease,
    };
    let [rolling, sliding] = bearing.skf_friction?.moment(&operation);
    (speed != 0.0).then_some(SkfMoment { rolling, sliding })
}
