//! Damped motion ends where the quasi-static bearing stands.

use crate::bearing::{ContactLaw, Oil};
use crate::rotor::{CageMotion, Damping, Freedoms, InitialState, Rotor, RotorDefinition};

use super::{LAWS, apart, with_law};
use crate::tests::support::{
    AT_EQUILIBRIUM, back_to_back_pair, bearing, constant, model, mounted, rotor, samples, shaft,
};

/// Where the motion starts: so far beside the equilibrium, m and rad.
const BESIDE: [f64; 5] = [3e-6, -2e-6, 4e-6, 1e-4, -2e-4];

/// Distance of the end of a damped motion from the equilibrium, relative to that of its start.
fn miss(mut definition: RotorDefinition) -> f64 {
    let resting = Rotor::assemble(&definition).expect("a rotor");
    let place = resting.equilibrium().displacement;
    let freedoms = resting.freedoms();
    let start = std::array::from_fn(|axis| {
        place[axis]
            + if freedoms.moves(axis) {
                BESIDE[axis]
            } else {
                0.0
            }
    });
    definition.initial = InitialState {
        displacement: std::array::from_fn(|axis| freedoms.moves(axis).then_some(start[axis])),
        ..AT_EQUILIBRIUM
    };
    let modes = resting.natural_frequencies();
    let decay = |mode: &crate::rotor::NaturalFrequency| {
        std::f64::consts::TAU * mode.frequency * mode.damping_ratio
    };
    let slowest = modes.iter().map(decay).fold(f64::INFINITY, f64::min);
    // to e^(−25) = 1e-11 of the start
    let duration = 25.0 / slowest;
    let samples = samples(&model(definition, duration, 1.0 / duration), 0.5 * duration);
    let last = samples.last().expect("the end").displacement;
    apart(last, place) / apart(start, place)
}

fn check(law: (ContactLaw, Option<Oil>), definition: RotorDefinition, words: &str) {
    let miss = miss(with_law(definition, law));
    println!("{law:?}, {words}: {miss:e}");
    // ten tolerances of 1e-10: errors of steps add up over a decay
    assert!(miss < 1e-9, "{law:?}, {words}: {miss:e}");
}

/// At 800 rad/s under an uneven load, the cage standing.
fn loaded(freedoms: Freedoms) -> RotorDefinition {
    RotorDefinition {
        speed: 800.0,
        cage: CageMotion::Frozen,
        damping: Damping::Ratio(0.2),
        loads: constant([50.0, -200.0, 1000.0, 0.0, 0.0]),
        ..rotor(shaft(freedoms), vec![mounted(bearing("7205C"))])
    }
}

const FREEDOMS: [Freedoms; 4] = [
    Freedoms::Radial,
    Freedoms::Translational,
    Freedoms::Lateral,
    Freedoms::All,
];

#[test]
fn a_bearing_of_every_law_settles_on_its_equilibrium() {
    for law in LAWS {
        for freedoms in FREEDOMS {
            check(law, loaded(freedoms), &format!("one bearing, {freedoms:?}"));
        }
    }
}

#[test]
fn a_preloaded_pair_of_every_law_settles_on_its_equilibrium() {
    for law in LAWS {
        for freedoms in FREEDOMS {
            let pair = RotorDefinition {
                bearings: back_to_back_pair(),
                loads: constant([50.0, -200.0, 100.0, 0.5, 1.0]),
                ..loaded(freedoms)
            };
            check(law, pair, &format!("a pair, {freedoms:?}"));
        }
    }
}

/// Under thrust alone all balls bear alike: the bearing does not notice that they go round.
#[test]
fn under_thrust_alone_it_settles_though_the_balls_go_round() {
    for law in LAWS {
        let centred = RotorDefinition {
            cage: CageMotion::Rolling,
            loads: constant([0.0, 0.0, 1000.0, 0.0, 0.0]),
            ..loaded(Freedoms::All)
        };
        check(law, centred, "rolling");
    }
}
