//! What a loaded bearing says of itself: contacts, films, life, friction, warnings, ball by ball.

mod contacts;
mod films;
mod forces;
mod life;
mod motion;
mod warnings;

use crate::bearing::{BearingState, CageMotion, ContactLaw, MountedBearing, Oil, Support, Vector5};
use crate::physics::RaceControl;
use crate::rotor::{Attachment, StaticProblem};

/// The oil of the reference rows: η0 = 0.04 Pa s, α_p = 22 1/GPa.
const OIL: Oil = Oil {
    viscosity: 0.04,
    pressure_viscosity: 2.2e-8,
};

/// All laws with balls.
const LAWS: [(ContactLaw, Option<Oil>); 5] = [
    (ContactLaw::Hertz, None),
    (ContactLaw::Hertz, Some(OIL)),
    (ContactLaw::Jones(RaceControl::Outer), None),
    (ContactLaw::Jones(RaceControl::Outer), Some(OIL)),
    (ContactLaw::Jones(RaceControl::Even), Some(OIL)),
];

/// State of a bearing with its shaft at a place.
fn state_at(bearing: &MountedBearing, place: Vector5, speed: f64) -> BearingState {
    let support = Support::new(bearing, speed).expect("a bearing that can be mounted");
    let attachment = Attachment::on_rigid_shaft(bearing.position, bearing.facing);
    let displacement = attachment.displacement(&place, &[]);
    support.state(&displacement, 0.0, speed, CageMotion::default())
}

/// State of a bearing under a load; held freedoms stay at zero.
fn state_under(
    bearing: &MountedBearing,
    load: Vector5,
    free: [bool; 5],
    speed: f64,
) -> BearingState {
    let supports = [Support::new(bearing, speed).expect("a bearing that can be mounted")];
    let problem = StaticProblem {
        supports: &supports,
        load,
        free,
        start: [0.0; 5],
        speed,
    };
    let equilibrium = problem.solve().expect("the load is carried");
    state_at(bearing, equilibrium.displacement, speed)
}

/// State of a bearing under a pure thrust in N, x, y and the tilts held.
fn state_under_thrust(bearing: &MountedBearing, thrust: f64, speed: f64) -> BearingState {
    let load = [0.0, 0.0, thrust, 0.0, 0.0];
    state_under(bearing, load, [false, false, true, false, false], speed)
}
