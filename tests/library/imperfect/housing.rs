//! Bearings in housings that move.

use std::f64::consts::TAU;

use nalgebra::{Complex, Matrix2, Vector2};

use crate::bearing::{ContactLaw, Housing, MountedBearing, Resonator, Surface};
use crate::integrate::{Method, Settings};
use crate::rotor::load::{Harmonic, HarmonicRate, Load, LoadKind};
use crate::rotor::{Damping, Freedoms, Rotor, RotorDefinition, Sample};
use crate::simulate::Model;

use super::{fault, golden};
use crate::tests::support::{
    AT_EQUILIBRIUM, Collector, assert_near, back_to_back_pair, bearing, linearisation, model,
    mounted, rotor, settings, shaft, simulate_into, try_run,
};

const HOUSING: Housing = Housing {
    mass: 3.0,
    stiffness: [3e7, 2e7, 5e7],
    damping: [400.0, 300.0, 500.0],
    resonator: None,
};
/// Acceleration of the base, m/s², and its frequency, Hz.
const SHAKEN: [f64; 2] = [2.0, 180.0];

fn base() -> Load {
    Load {
        kind: LoadKind::Base(Box::new(LoadKind::Harmonic(Harmonic {
            amplitude: [SHAKEN[0], 0.0, 0.0, 0.0, 0.0],
            rate: HarmonicRate::Frequency(SHAKEN[1]),
            phase: 0.0,
        }))),
        position: 0.0,
    }
}

/// A shaft on one linear bearing in that housing, shaken along x.
fn two_masses() -> RotorDefinition {
    RotorDefinition {
        damping: Damping::Coefficients([150.0, 150.0, 150.0, 0.0, 0.0]),
        loads: vec![Load::constant([0.0, 0.0, 500.0, 0.0, 0.0], 0.0), base()],
        ..rotor(
            shaft(Freedoms::Translational),
            vec![MountedBearing {
                law: ContactLaw::Linear,
                housing: Some(HOUSING),
                ..mounted(bearing("7205C"))
            }],
        )
    }
}

/// ω² of masses in a row, from the first spring, to the ground, outwards.
fn in_a_row(masses: [f64; 3], springs: [f64; 3]) -> Vec<f64> {
    let [outer, middle, inner] = springs;
    let stiffness = nalgebra::Matrix3::new(
        outer + middle + inner,
        -middle,
        -inner,
        -middle,
        middle,
        0.0,
        -inner,
        0.0,
        inner,
    );
    let scaled = nalgebra::Matrix3::from_fn(|row, column| {
        stiffness[(row, column)] / (masses[row] * masses[column]).sqrt()
    });
    let mut squares: Vec<f64> = scaled.symmetric_eigenvalues().iter().copied().collect();
    squares.sort_by(f64::total_cmp);
    squares
}

/// A housing with a sensor of 0.4 kg on a spring of 6e8 N/m: the frequencies along each axis are those of three masses, of
/// which the housing carries the other two.
#[test]
fn a_resonator_on_a_housing_is_a_third_mass() {
    let mut definition = two_masses();
    definition.damping = Damping::Undamped;
    definition.bearings[0].housing = Some(Housing {
        damping: [0.0; 3],
        resonator: Some(Resonator {
            mass: 0.4,
            stiffness: 6e8,
            damping: 0.0,
        }),
        ..HOUSING
    });
    let built = Rotor::assemble(&definition).expect("a rotor");
    let stiffness = *built.equilibrium().stiffness();
    let mut due: Vec<f64> = (0..3)
        .flat_map(|axis| {
            let masses = [HOUSING.mass, definition.shaft.mass, 0.4];
            in_a_row(
                masses,
                [HOUSING.stiffness[axis], stiffness[(axis, axis)], 6e8],
            )
        })
        .map(f64::sqrt)
        .collect();
    due.sort_by(f64::total_cmp);
    let found = built.natural_frequencies();
    assert_eq!(found.len(), due.len());
    for (found, due) in found.iter().zip(due) {
        assert_near("frequency", TAU * found.frequency, due, 1e-8);
    }
}

#[test]
fn a_shaken_housing_and_its_shaft_answer_as_two_masses_in_a_row() {
    let definition = two_masses();
    let built = Rotor::assemble(&definition).expect("a rotor");
    let k = built.equilibrium().stiffness()[(0, 0)];
    let omega = TAU * SHAKEN[1];
    let (m, big_m, c) = (definition.shaft.mass, HOUSING.mass, 150.0);
    let (big_k, big_c) = (HOUSING.stiffness[0], HOUSING.damping[0]);
    // the damping of the shaft is one to the ground
    let complex = |re: f64, im: f64| Complex::new(re, omega * im);
    let dynamic = Matrix2::new(
        complex(k - omega * omega * m, c),
        complex(-k, 0.0),
        complex(-k, 0.0),
        complex(k + big_k - omega * omega * big_m, big_c),
    );
    let force = Vector2::new(
        Complex::from(-m * SHAKEN[0]),
        Complex::from(-big_m * SHAKEN[0]),
    );
    let expected = dynamic
        .lu()
        .solve(&force)
        .expect("no resonance without damping");
    // the last of many periods
    let rate = 64.0 * SHAKEN[1];
    let model = Model {
        integrator: Settings {
            method: Method::Verner76,
            ..settings(1e-11)
        },
        ..model(definition, 0.6, rate)
    };
    let samples = try_run(&model, 0.6 - 1.0 / SHAKEN[1]).1;
    let housed = |sample: &Sample| sample.bodies[0].displacement[0];
    for sample in samples {
        let turned = Complex::from_polar(1.0, omega * sample.time);
        let [shaft, housing] = [expected[0], expected[1]].map(|part| (part * turned).re);
        assert_near(
            "shaft",
            sample.displacement[0],
            shaft,
            1e-6 * expected[0].norm(),
        );
        assert_near(
            "housing",
            housed(&sample),
            housing,
            1e-6 * expected[1].norm(),
        );
    }
}

/// A pair of bearings in housings of their own, shaken, with a load of every kind.
fn shaken_pair(law: ContactLaw, freedoms: Freedoms) -> RotorDefinition {
    let mut unbalanced = shaft(freedoms);
    (unbalanced.eccentricity, unbalanced.gravity) = (5e-6, true);
    let in_housing = |bearing: MountedBearing| MountedBearing {
        law,
        housing: Some(HOUSING),
        ..bearing
    };
    RotorDefinition {
        speed: 700.0,
        damping: Damping::Ratio(0.01),
        loads: vec![Load::constant([0.0, -100.0, 0.0, 0.0, 0.0], 0.0), base()],
        ..rotor(
            unbalanced,
            back_to_back_pair().into_iter().map(in_housing).collect(),
        )
    }
}

#[test]
fn the_energy_of_shaken_housings_is_accounted_for() {
    for freedoms in [Freedoms::Radial, Freedoms::All] {
        let model = Model {
            energy: true,
            verify: true,
            integrator: Settings {
                method: Method::Verner76,
                ..settings(1e-10)
            },
            ..model(shaken_pair(ContactLaw::Hertz, freedoms), 0.03, 10_000.0)
        };
        let run = simulate_into(&model, &mut Collector::default()).expect("a run");
        let energy = run.energy.expect("an account");
        assert!(
            energy.relative_residual < 1e-8,
            "{:e}",
            energy.relative_residual
        );
        let error = run.measured_error.expect("a measured error");
        assert!(error.relative < 3e-10, "{:e}", error.relative);
    }
}

#[test]
fn slopes_by_time_know_the_base_under_housings_and_the_surfaces() {
    let mut definition = shaken_pair(ContactLaw::Hertz, Freedoms::Translational);
    let defects = vec![
        fault(Surface::Outer, -1.2, 300.0),
        fault(Surface::Inner, 0.3, 300.0),
    ];
    definition.bearings[0] = super::with_defects(definition.bearings[0].clone(), defects);
    let built = Rotor::assemble(&definition).expect("a rotor");
    let mut state = built.start_state();
    for (index, state) in state.iter_mut().enumerate() {
        *state += 1e-7 * (1.3 * index as f64).sin();
    }
    use crate::integrate::System;
    for time in [0.003, 0.0101, 0.0277] {
        let (_, by_time) = linearisation(&built, time, &state);
        let rate = |step: f64| {
            let mut rate = vec![0.0; state.len()];
            built.derivative(time + step, &state, &mut rate);
            rate
        };
        let (up, down) = (rate(1e-8), rate(-1e-8));
        let largest = by_time
            .iter()
            .fold(0.0_f64, |most, value| most.max(value.abs()));
        for (row, found) in by_time.iter().enumerate() {
            let expected = (up[row] - down[row]) / 2e-8;
            assert_near("∂f/∂t", *found, expected, 1e-5 * largest);
        }
    }
}

#[test]
fn a_spall_shakes_the_housing_that_its_bearing_stands_in() {
    let run = |defects| {
        let mut definition = golden(defects);
        definition.bearings[0].housing = Some(HOUSING);
        definition.initial = AT_EQUILIBRIUM;
        let model = Model {
            integrator: Settings {
                method: Method::Auto,
                ..settings(1e-8)
            },
            verify: true,
            ..model(definition, 0.1, 12_000.0)
        };
        let (run, samples) = try_run(&model, 0.05);
        let error = run.expect("a run").measured_error.expect("an error");
        assert!(error.relative < 3e-8, "{:e}", error.relative);
        let velocity = |sample: &Sample| sample.bodies[0].velocity[1];
        samples
            .iter()
            .map(|sample| velocity(sample).abs())
            .fold(0.0, f64::max)
    };
    let slot = fault(Surface::Outer, -std::f64::consts::FRAC_PI_2, 21.0);
    let [healthy, spalled] = [Vec::new(), vec![slot]].map(run);
    assert!(spalled > 5.0 * healthy, "{spalled:e} {healthy:e}");
}
