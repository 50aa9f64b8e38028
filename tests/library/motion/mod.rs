//! The whole bearing in motion: where it settles, what repeats, what no choice of method, of frame or
//! of first ball may change.

mod bearing_forces;
mod frame;
mod methods;
mod periodicity;
mod settling;

use crate::bearing::{ContactLaw, MountedBearing, Oil};
use crate::physics::RaceControl;
use crate::rotor::{RotorDefinition, Sample};

const OIL: Oil = Oil {
    viscosity: 0.04,
    pressure_viscosity: 2.2e-8,
};

/// Every law of the fidelity ladder, with or without film.
const LAWS: [(ContactLaw, Option<Oil>); 7] = [
    (ContactLaw::Linear, None),
    (ContactLaw::Hertz, None),
    (ContactLaw::Hertz, Some(OIL)),
    (ContactLaw::Jones(RaceControl::Outer), None),
    (ContactLaw::Jones(RaceControl::Inner), None),
    (ContactLaw::Jones(RaceControl::Even), None),
    (ContactLaw::Jones(RaceControl::Outer), Some(OIL)),
];

/// The rotor with all of its bearings under a law.
fn with_law(definition: RotorDefinition, (law, oil): (ContactLaw, Option<Oil>)) -> RotorDefinition {
    let bearings = definition.bearings.iter();
    let bearings = bearings.map(|bearing| MountedBearing {
        law,
        oil,
        ..bearing.clone()
    });
    RotorDefinition {
        bearings: bearings.collect(),
        ..definition
    }
}

/// Length that turns a tilt into a displacement, m.
const ARM: f64 = 0.0194;

/// Displacement in m, tilts by their arm.
fn in_metres([x, y, z, tilt_x, tilt_y]: [f64; 5]) -> [f64; 5] {
    [x, y, z, ARM * tilt_x, ARM * tilt_y]
}

/// Largest difference of two displacements, m.
fn apart(left: [f64; 5], right: [f64; 5]) -> f64 {
    let pairs = in_metres(left).into_iter().zip(in_metres(right));
    pairs.fold(0.0, |largest, (a, b)| f64::max(largest, (a - b).abs()))
}

/// Largest difference of two traces, m.
fn traces_apart(left: &[Sample], right: &[Sample]) -> f64 {
    assert_eq!(left.len(), right.len());
    let pairs = left.iter().zip(right);
    pairs.fold(0.0, |largest, (a, b)| {
        f64::max(largest, apart(a.displacement, b.displacement))
    })
}
