//! The slopes that implicit methods use are those of the equations of motion.

use crate::bearing::{ContactDamping, ContactLaw, MountedBearing, Oil};
use crate::integrate::System;
use crate::physics::RaceControl;
use crate::rotor::load::{Harmonic, HarmonicRate, Load, LoadKind};
use crate::rotor::{Damping, Freedoms, Rotor, RotorDefinition, SpeedPoint};

use crate::tests::support::{back_to_back_pair, constant, linearisation, rotor, shaft, under};

const N: usize = 10;

/// An unbalanced, damped shaft with all freedoms on a pair of bearings of one law.
fn unbalanced_pair(law: ContactLaw, oil: Option<Oil>) -> RotorDefinition {
    let mut unbalanced = shaft(Freedoms::All);
    unbalanced.eccentricity = 20e-6;
    unbalanced.gravity = true;
    let with_law = |bearing: MountedBearing| MountedBearing {
        law,
        oil,
        ..bearing
    };
    let bearings = back_to_back_pair().into_iter().map(with_law).collect();
    RotorDefinition {
        speed: 800.0,
        damping: Damping::StiffnessTime(1e-5),
        loads: constant([100.0, -200.0, 50.0, 0.2, -0.1]),
        ..rotor(unbalanced, bearings)
    }
}

/// Central difference of the derivative by component `index` of (state…, time), in fourth order.
fn difference(rotor: &Rotor, time: f64, state: &[f64; N], index: usize, step: f64) -> [f64; N] {
    let at = |part: f64| {
        let (mut time, mut state, mut rate) = (time, *state, [0.0; N]);
        match state.get_mut(index) {
            Some(component) => *component += part * step,
            None => time += part * step,
        }
        rotor.derivative(time, &state, &mut rate);
        rate
    };
    let (far_back, back, ahead, far_ahead) = (at(-2.0), at(-1.0), at(1.0), at(2.0));
    std::array::from_fn(|row| {
        (8.0 * (ahead[row] - back[row]) - (far_ahead[row] - far_back[row])) / (12.0 * step)
    })
}

/// Asserts that the slopes at one state and time are those of the right-hand side.
fn check(rotor: &Rotor, words: &str) {
    let place = rotor.equilibrium().displacement;
    let state: [f64; N] = std::array::from_fn(|i| {
        if i < 5 {
            place[i] + 1e-7 * i as f64
        } else {
            1e-3 * i as f64
        }
    });
    let time = 0.0123;
    let (jacobian, by_time) = linearisation(rotor, time, &state);
    for index in 0..=N {
        // steps well inside the contacts, and large against round-off
        let step = [
            1e-8, 1e-8, 1e-8, 1e-6, 1e-6, 1e-3, 1e-3, 1e-3, 1e-2, 1e-2, 1e-6,
        ][index];
        let expected = difference(rotor, time, &state, index, step);
        let scale = expected
            .iter()
            .fold(1.0, |scale: f64, value| scale.max(value.abs()));
        for row in 0..N {
            let slope = if index < N {
                jacobian[(row, index)]
            } else {
                by_time[row]
            };
            let error = (slope - expected[row]).abs() / scale;
            assert!(
                error < 1e-6,
                "{words}, {row} {index}: {slope:e} {:e}",
                expected[row]
            );
        }
    }
}

#[test]
fn linearisation_knows_a_run_up_and_varying_loads() {
    let harmonic = Harmonic {
        amplitude: [50.0, -20.0, 10.0, 0.1, 0.2],
        rate: HarmonicRate::Frequency(130.0),
        phase: 0.3,
    };
    let definition = RotorDefinition {
        speed_points: vec![SpeedPoint {
            time: 0.5,
            speed: 1200.0,
        }],
        ..unbalanced_pair(ContactLaw::Hertz, None)
    };
    let shaken = Load {
        kind: LoadKind::Harmonic(harmonic),
        position: 0.02,
    };
    let definition = under(definition, [shaken]);
    check(&Rotor::assemble(&definition).expect("a rotor"), "run-up");
}

#[test]
fn linearisation_knows_damped_contacts() {
    let damped = |bearing| MountedBearing {
        contact_damping: ContactDamping {
            inner: 0.5,
            outer: 2.0,
        },
        ..bearing
    };
    // under a film only differences know it
    for (law, oil) in &laws()[..3] {
        let mut definition = unbalanced_pair(*law, *oil);
        definition.bearings = definition.bearings.into_iter().map(damped).collect();
        check(&Rotor::assemble(&definition).expect("a rotor"), "damped");
        // the cage of a run-up turns ever faster; a film grows with the speed, which slopes leave out
        if oil.is_some() {
            continue;
        }
        definition.speed_points = vec![SpeedPoint {
            time: 0.5,
            speed: 9000.0,
        }];
        check(&Rotor::assemble(&definition).expect("a rotor"), "run-up");
    }
}

/// The laws of the contacts, with a film and without.
fn laws() -> [(ContactLaw, Option<Oil>); 5] {
    let oil = Oil {
        viscosity: 0.04,
        pressure_viscosity: 2.2e-8,
    };
    let outer = ContactLaw::Jones(RaceControl::Outer);
    [
        (ContactLaw::Linear, None),
        (ContactLaw::Hertz, None),
        (ContactLaw::Hertz, Some(oil)),
        (outer, None),
        (outer, Some(oil)),
    ]
}

#[test]
fn linearisation_is_the_derivative_of_the_right_hand_side() {
    for (law, oil) in laws() {
        let rotor = Rotor::assemble(&unbalanced_pair(law, oil)).expect("a rotor");
        check(&rotor, &format!("{law:?}"));
    }
}
