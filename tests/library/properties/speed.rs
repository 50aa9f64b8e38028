//! The shaft at varying speed.

use crate::analysis::Window;
use crate::integrate::System;
use crate::rotor::{
    Damping, Freedoms, Rotor, RotorDefinition, RotorError, SpeedPoint, SpeedProfile,
};
use crate::simulate::Sampling;

use super::linear_rotor::{linear, natural_speed};
use crate::tests::support::{
    assert_near, back_to_back_pair, model, peak_to_peak, rotor, samples, shaft, thrust_rotor,
    try_run,
};

fn points(points: &[(f64, f64)]) -> Vec<SpeedPoint> {
    let point = |&(time, speed)| SpeedPoint { time, speed };
    points.iter().map(point).collect()
}

/// Run-up, hold, coast-down, hold.
fn up_and_down() -> Vec<SpeedPoint> {
    points(&[(0.1, 600.0), (0.15, 600.0), (0.3, 200.0)])
}

/// Simpson's rule is exact for the linear pieces: 0.05 s divides them all.
#[test]
fn the_angle_is_the_integral_of_the_speed() {
    let profile = SpeedProfile::new(50.0, &up_and_down()).expect("a profile");
    let mut angle = 0.0;
    for step in 0..10 {
        let [from, middle, to] = [0.0, 0.5, 1.0].map(|part| 0.05 * (f64::from(step) + part));
        let [left, centre, right] = [from, middle, to].map(|time| profile.at(time.min(to)).speed);
        angle += 0.05 * (left + 4.0 * centre + right) / 6.0;
        assert_near("ψ", profile.at(to).angle, angle, 1e-12 * angle);
    }
    assert_eq!(profile.highest(), 600.0);
    assert_eq!(profile.at(1.0).acceleration, 0.0);
    assert_eq!(profile.steady_from(0.12), None);
    assert_eq!(profile.steady_from(0.3), Some(200.0));
    assert_eq!(profile.next_break(0.1), 0.15);
}

#[test]
fn times_that_do_not_rise_and_negative_speeds_are_errors() {
    let refused = |list: &[(f64, f64)]| SpeedProfile::new(0.0, &points(list)).unwrap_err();
    assert!(matches!(
        refused(&[(0.0, 1.0)]),
        RotorError::SpeedTimes { number: 1, .. }
    ));
    assert!(matches!(
        refused(&[(1.0, 1.0), (f64::NAN, 1.0)]),
        RotorError::SpeedTimes { number: 2, .. }
    ));
    assert!(matches!(
        refused(&[(1.0, -1.0)]),
        RotorError::Range { value: -1.0, .. }
    ));
}

#[test]
fn a_profile_of_one_speed_is_the_constant_speed_bit_by_bit() {
    let mut definition = thrust_rotor();
    definition.shaft.eccentricity = 1e-6;
    let constant = samples(&model(definition.clone(), 0.02, 10_000.0), 0.0);
    definition.speed_points = points(&[(0.01, definition.speed), (0.015, definition.speed)]);
    assert_eq!(samples(&model(definition, 0.02, 10_000.0), 0.0), constant);
}

/// Right-hand side of five freedoms at the static equilibrium.
fn rate(definition: &RotorDefinition, time: f64) -> [f64; 10] {
    let rotor = Rotor::assemble(definition).expect("a rotor");
    let place = rotor.equilibrium().displacement;
    let state: [f64; 10] = std::array::from_fn(|i| if i < 5 { place[i] + 1e-6 } else { 1e-3 });
    let mut rate = [0.0; 10];
    rotor.derivative(time, &state, &mut rate);
    rate
}

fn tilting() -> RotorDefinition {
    rotor(shaft(Freedoms::All), back_to_back_pair())
}

/// m e (ω² cos ψ + ω̇ sin ψ) along x, m e (ω² sin ψ − ω̇ cos ψ) along y.
#[test]
fn unbalance_has_a_tangential_part_while_the_speed_changes() {
    let mut balanced = tilting();
    balanced.speed_points = up_and_down();
    let mut heavy = balanced.clone();
    heavy.shaft.eccentricity = 1e-3;
    for (time, speed, acceleration, angle) in [
        (0.05_f64, 300.0_f64, 6000.0_f64, 7.5_f64),
        (0.12, 600.0, 0.0, 42.0),
        (0.3 - 0.075, 400.0, -4e3 / 1.5, 30.0 + 30.0 + 500.0 * 0.075),
    ] {
        let (with, without) = (rate(&heavy, time), rate(&balanced, time));
        let (sin, cos) = angle.sin_cos();
        let expected = [
            1e-3 * (speed * speed * cos + acceleration * sin),
            1e-3 * (speed * speed * sin - acceleration * cos),
        ];
        for axis in 0..2 {
            let difference = with[5 + axis] - without[5 + axis];
            assert_near("acceleration", difference, expected[axis], 1e-9);
        }
    }
}

/// Cage and gyroscopic moments know angle and speed of the moment alone.
#[test]
fn a_slow_ramp_has_what_constant_speeds_have() {
    let mut ramp = tilting();
    ramp.speed_points = points(&[(1.0, 800.0)]);
    let constant = RotorDefinition {
        speed: 400.0,
        ..tilting()
    };
    // at 0.5 s: 400 rad/s and ψ = 100 rad, which the constant speed has at 0.25 s
    for (passing, standing) in rate(&ramp, 0.5).into_iter().zip(rate(&constant, 0.25)) {
        assert_near("rate", passing, standing, 1e-9 * standing.abs());
    }
}

/// x of `ẍ + 2ζΩ ẋ + Ω² x = e (ω² cos ψ + ω̇ sin ψ)`, ω = αt, by the classic Runge–Kutta method.
fn reference_run_up(ratio: f64, natural: f64, eccentricity: f64, rise: f64, end: f64) -> Vec<f64> {
    let pull = |time: f64, [place, velocity]: [f64; 2]| {
        let (speed, (sin, cos)) = (rise * time, (0.5 * rise * time * time).sin_cos());
        let force = eccentricity * (speed * speed * cos + rise * sin);
        [
            velocity,
            force - 2.0 * ratio * natural * velocity - natural * natural * place,
        ]
    };
    let along = |state: [f64; 2], slope: [f64; 2], h: f64| {
        [state[0] + h * slope[0], state[1] + h * slope[1]]
    };
    let h = 1e-6;
    let mut state = [0.0; 2];
    let mut trace = Vec::new();
    for step in 0..=(end / h).round() as u64 {
        if step % 100 == 0 {
            trace.push(state[0]);
        }
        let time = step as f64 * h;
        let first = pull(time, state);
        let second = pull(time + 0.5 * h, along(state, first, 0.5 * h));
        let third = pull(time + 0.5 * h, along(state, second, 0.5 * h));
        let fourth = pull(time + h, along(state, third, h));
        let mean = [0, 1].map(|i| (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]) / 6.0);
        state = along(state, mean, h);
    }
    trace
}

#[test]
fn a_run_up_is_that_of_an_independent_integration() {
    let (ratio, eccentricity, end) = (0.03, 1e-7, 0.1);
    let mut definition = RotorDefinition {
        damping: Damping::Ratio(ratio),
        speed: 0.0,
        ..linear(thrust_rotor())
    };
    definition.shaft.eccentricity = eccentricity;
    let natural = natural_speed(&definition);
    definition.speed_points = points(&[(end, 1.5 * natural)]);
    let expected = reference_run_up(ratio, natural, eccentricity, 1.5 * natural / end, end);
    let samples = samples(&model(definition, end, 10_000.0), 0.0);
    let largest = peak_to_peak(expected.iter().copied());
    assert!(largest > 10.0 * eccentricity, "it passes the resonance");
    assert_eq!(samples.len(), expected.len());
    for (sample, x) in samples.iter().zip(expected) {
        // a reference step turns by 0.015 rad at most: its error is 1e-10 of the motion a second
        assert_near("x", sample.displacement[0], x, 1e-7 * largest);
    }
}

#[test]
fn spectra_have_orders_at_a_steady_speed_and_else_a_warning() {
    let mut definition = thrust_rotor();
    definition.shaft.eccentricity = 1e-6;
    definition.speed_points = points(&[(0.02, 800.0)]);
    let mut model = model(definition, 0.1, 10_000.0);
    model.spectrum = Some(Window::Rectangular);
    model.sampling = Sampling::PerRevolution(64);
    for (settle, order, warnings) in [(0.02, true, 0), (0.01, false, 1)] {
        model.settle = settle;
        let run = try_run(&model, 0.0).0.expect("it runs");
        let spectrum = run.spectrum.expect("a spectrum");
        assert_eq!(spectrum.order(1).is_some(), order);
        assert_eq!(run.warnings.len(), warnings, "{:?}", run.warnings);
        if order {
            assert_eq!(spectrum.length % 64, 0);
            assert_near(
                "f",
                spectrum.shaft_frequency,
                800.0 / std::f64::consts::TAU,
                1e-12,
            );
        }
    }
}

#[test]
fn a_shaft_that_never_turns_has_no_revolutions() {
    let mut definition = RotorDefinition {
        speed: 0.0,
        ..thrust_rotor()
    };
    definition.speed_points = points(&[(1.0, 0.0)]);
    let mut model = model(definition, 0.01, 1000.0);
    model.sampling = Sampling::PerRevolution(64);
    assert!(try_run(&model, 0.0).0.is_err());
}

#[test]
fn a_held_tilt_misaligns_the_bearing() {
    let mut definition = rotor(shaft(Freedoms::Translational), back_to_back_pair());
    definition.shaft.held_tilt = [2e-4, -1e-4];
    let place = Rotor::assemble(&definition)
        .expect("a rotor")
        .equilibrium()
        .displacement;
    assert_eq!(place[3..], [2e-4, -1e-4]);
}
