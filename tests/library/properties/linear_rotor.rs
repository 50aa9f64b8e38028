//! The shaft on linear supports against its closed-form motion.

use std::f64::consts::TAU;

use crate::bearing::{ContactLaw, MountedBearing};
use crate::rotor::{CageMotion, Damping, Freedoms, InitialState, Rotor, RotorDefinition, Shaft};

use crate::tests::support::{
    AT_EQUILIBRIUM, assert_near, back_to_back_pair, model, rotor, samples, shaft, thrust_rotor,
};

pub fn linear(definition: RotorDefinition) -> RotorDefinition {
    let bearings = definition.bearings.iter().map(|bearing| MountedBearing {
        law: ContactLaw::Linear,
        ..bearing.clone()
    });
    RotorDefinition {
        bearings: bearings.collect(),
        ..definition
    }
}

/// √(K_xx/m) at the static equilibrium, rad/s.
pub fn natural_speed(definition: &RotorDefinition) -> f64 {
    let rotor = Rotor::assemble(definition).expect("a rotor");
    (rotor.equilibrium().stiffness[(0, 0)] / definition.shaft.mass).sqrt()
}

/// Jeffcott: x = e r²/√((1 − r²)² + (2ζr)²) cos(ψ − φ), tan φ = 2ζr/(1 − r²), y a quarter later.
#[test]
fn unbalance_has_amplitude_and_phase_of_the_closed_form() {
    let (ratio, eccentricity) = (0.05, 1e-7);
    for r in [0.1, 0.5, 0.9, 1.0, 1.1, 2.0, 5.0] {
        let mut definition = linear(thrust_rotor());
        definition.damping = Damping::Ratio(ratio);
        definition.shaft.eccentricity = eccentricity;
        let natural = natural_speed(&definition);
        definition.speed = r * natural;
        // free motion has decayed to e^(-25) = 1e-11
        let settle = 25.0 / (ratio * natural);
        let (cosine, sine) = (1.0 - r * r, 2.0 * ratio * r);
        let amplitude = eccentricity * r * r / cosine.hypot(sine);
        let lag = sine.atan2(cosine);
        let model = model(definition, settle + 0.01, 20_000.0);
        for sample in samples(&model, settle) {
            let angle = sample.angle - lag;
            // the tolerance 1e-10 of the motion, times the steps of a decay time
            let tolerance = 1e-8 * amplitude;
            assert_near(
                "x",
                sample.displacement[0],
                amplitude * angle.cos(),
                tolerance,
            );
            assert_near(
                "y",
                sample.displacement[1],
                amplitude * angle.sin(),
                tolerance,
            );
        }
    }
}

#[test]
fn free_vibration_decays_by_the_logarithmic_decrement() {
    let ratio = 0.03;
    let mut definition = linear(thrust_rotor());
    definition.damping = Damping::Ratio(ratio);
    let displaced = [Some(1e-6), None, None, None, None];
    definition.initial = InitialState {
        displacement: displaced,
        ..AT_EQUILIBRIUM
    };
    let damped = natural_speed(&definition) * (1.0 - ratio * ratio).sqrt();
    let decrement = TAU * ratio / (1.0 - ratio * ratio).sqrt();
    let model = model(definition, 20.5 * TAU / damped, damped / TAU);
    let samples = samples(&model, 0.0);
    assert_eq!(samples.len(), 21);
    for pair in samples.windows(2) {
        let [before, after] = [0, 1].map(|k: usize| pair[k].displacement[0]);
        // after 20 periods the motion is e^(-4) of the one that the tolerance is relative to
        assert_near("decrement", (before / after).ln(), decrement, 1e-7);
    }
}

/// The tilts of a symmetric pair: I_t Ω² − I_p ω Ω − K = 0, one root forward, one backward.
fn tilt_speeds(definition: &RotorDefinition) -> [f64; 2] {
    let rotor = Rotor::assemble(definition).expect("a rotor");
    let Shaft {
        inertia_transverse,
        inertia_polar,
        ..
    } = definition.shaft;
    let stiffness = rotor.equilibrium().stiffness[(3, 3)];
    let gyroscopic = inertia_polar * definition.speed;
    let root = gyroscopic.hypot(2.0 * (inertia_transverse * stiffness).sqrt());
    [gyroscopic + root, gyroscopic - root].map(|sum| sum / (2.0 * inertia_transverse))
}

fn tilting_pair() -> RotorDefinition {
    RotorDefinition {
        speed: 2000.0,
        cage: CageMotion::Frozen,
        ..linear(rotor(shaft(Freedoms::All), back_to_back_pair()))
    }
}

#[test]
fn gyroscopic_moments_split_the_tilt_frequencies() {
    let definition = tilting_pair();
    let rotor = Rotor::assemble(&definition).expect("a rotor");
    let natural = rotor.natural_frequencies();
    for expected in tilt_speeds(&definition).map(|speed| speed.abs() / TAU) {
        let nearest = natural
            .iter()
            .map(|mode| (mode.frequency - expected).abs() / expected)
            .fold(f64::INFINITY, f64::min);
        // round-off of the eigenvalues of a 10×10 matrix whose entries span 1 to 1e9
        assert!(nearest < 1e-10, "{expected} Hz: {nearest:e}");
    }
}

/// From rest at a tilt θ0 the tilt θx + iθy is θ0 (Ω_f e^(iΩ_b t) − Ω_b e^(iΩ_f t))/(Ω_f − Ω_b).
#[test]
fn a_released_tilt_precesses_as_the_closed_form_says() {
    let start = 1e-5;
    let mut definition = tilting_pair();
    let tilted = [None, None, None, Some(start), None];
    definition.initial = InitialState {
        displacement: tilted,
        ..AT_EQUILIBRIUM
    };
    let [forward, backward] = tilt_speeds(&definition);
    for sample in samples(&model(definition, 0.05, 10_000.0), 0.0) {
        let part = |of: fn(f64) -> f64| {
            let sum = forward * of(backward * sample.time) - backward * of(forward * sample.time);
            start * sum / (forward - backward)
        };
        let [.., tilt_x, tilt_y] = sample.displacement;
        // a hundred periods at a tolerance of 1e-10
        assert_near("θx", tilt_x, part(f64::cos), 1e-8 * start);
        assert_near("θy", tilt_y, part(f64::sin), 1e-8 * start);
    }
}
