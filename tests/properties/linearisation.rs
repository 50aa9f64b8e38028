//! The slopes that implicit methods use are those of the equations of motion.

use jeffcott::bearing::{ContactLaw, MountedBearing, Oil};
use jeffcott::integrate::{Linearised, System};
use jeffcott::physics::RaceControl;
use jeffcott::rotor::{Damping, Freedoms, Rotor, RotorDefinition};

use crate::support::{back_to_back_pair, rotor, shaft};

const N: usize = 10;

/// An unbalanced, damped shaft with all freedoms on a pair of bearings of one law.
fn unbalanced_pair(law: ContactLaw, oil: Option<Oil>) -> Rotor {
    let mut unbalanced = shaft(Freedoms::All);
    unbalanced.eccentricity = 20e-6;
    unbalanced.gravity = true;
    let with_law = |bearing: MountedBearing| MountedBearing {
        law,
        oil,
        ..bearing
    };
    let bearings = back_to_back_pair().into_iter().map(with_law).collect();
    let definition = RotorDefinition {
        speed: 800.0,
        damping: Damping::StiffnessTime(1e-5),
        load: [100.0, -200.0, 50.0, 0.2, -0.1],
        ..rotor(unbalanced, bearings)
    };
    Rotor::assemble(&definition).expect("a rotor")
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

#[test]
fn linearisation_is_the_derivative_of_the_right_hand_side() {
    let oil = Oil {
        viscosity: 0.04,
        pressure_viscosity: 2.2e-8,
    };
    let outer = ContactLaw::Jones(RaceControl::Outer);
    let laws = [
        (ContactLaw::Linear, None),
        (ContactLaw::Hertz, None),
        (ContactLaw::Hertz, Some(oil)),
        (outer, None),
        (outer, Some(oil)),
    ];
    for (law, oil) in laws {
        let rotor = unbalanced_pair(law, oil);
        let place = rotor.equilibrium().displacement;
        let state: [f64; N] = std::array::from_fn(|i| {
            if i < 5 {
                place[i] + 1e-7 * i as f64
            } else {
                1e-3 * i as f64
            }
        });
        let time = 0.0123;
        let (jacobian, by_time) = rotor.linearisation(time, &state);
        for index in 0..=N {
            // steps well inside the contacts, and large against round-off
            let step = [
                1e-8, 1e-8, 1e-8, 1e-6, 1e-6, 1e-3, 1e-3, 1e-3, 1e-2, 1e-2, 1e-6,
            ][index];
            let expected = difference(&rotor, time, &state, index, step);
            for row in 0..N {
                let slope = if index < N {
                    jacobian[(row, index)]
                } else {
                    by_time[row]
                };
                let scale: f64 = expected
                    .iter()
                    .fold(1.0, |scale, value| scale.max(value.abs()));
                let error = (slope - expected[row]).abs() / scale;
                assert!(
                    error < 1e-6,
                    "{law:?} {row} {index}: {slope:e} {:e}",
                    expected[row]
                );
            }
        }
    }
}
