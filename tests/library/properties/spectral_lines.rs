//! Where the lines of a steady spectrum stand.

use std::f64::consts::TAU;

use crate::analysis::{Transform, Window};
use crate::bearing::{Bearing, FreePosition, Geometry};
use crate::rotor::{Damping, RotorDefinition};

use crate::tests::support::{bearing, constant, model, mounted, samples, thrust_rotor};

/// Ball passes in a hundred revolutions: few enough lines coincide by chance.
const PASSES: usize = 483;
const REVOLUTIONS: usize = 100;
/// Samples in the hundred revolutions: a multiple of neither, 128 a revolution.
const LENGTH: usize = 12_800;

/// A 7205C whose pitch diameter gives exactly 4.83 ball passes a revolution.
fn commensurate_bearing() -> Bearing {
    let angle = 15f64.to_radians();
    let gamma = 1.0 - 2.0 * PASSES as f64 / (12.0 * REVOLUTIONS as f64);
    let (ball, free) = (7.938e-3, FreePosition::ContactAngle(angle));
    let pitch = ball * angle.cos() / gamma;
    Bearing {
        geometry: Geometry::new(12, ball, pitch, free, 0.52, 0.53).expect("a bearing"),
        ..bearing("7205C")
    }
}

/// Amplitudes of y, µm, bin k at k/100 of the shaft's frequency; balls loaded unevenly.
fn amplitudes(eccentricity: f64) -> Vec<f64> {
    let mut definition = RotorDefinition {
        bearings: vec![mounted(commensurate_bearing())],
        damping: Damping::Ratio(0.1),
        loads: constant([0.0, -1600.0, 1000.0, 0.0, 0.0]),
        ..thrust_rotor()
    };
    definition.shaft.eccentricity = eccentricity;
    let revolution = TAU / definition.speed;
    let interval = REVOLUTIONS as f64 * revolution / LENGTH as f64;
    // free motion, at 360 Hz or more, decays as e^(-0.1·2260 t): to e^(-57) in 20 revolutions
    let settle = 20.0 * revolution;
    let window = settle + (LENGTH as f64 - 0.5) * interval;
    let mut values: Vec<f64> = samples(&model(definition, window, 1.0 / interval), 0.0)
        .iter()
        .map(|sample| 1e6 * sample.displacement[1])
        .collect();
    values.drain(..values.len() - LENGTH);
    let transform = Transform::new(values).without_mean();
    (0..transform.bins())
        .map(|bin| transform.amplitude(bin, Window::Rectangular))
        .collect()
}

/// Largest amplitude on the named bins and elsewhere.
fn on_and_off(amplitudes: &[f64], on: impl Fn(usize) -> bool) -> (f64, f64) {
    let mut largest = (0.0_f64, 0.0_f64);
    for (bin, amplitude) in amplitudes.iter().enumerate() {
        if on(bin) {
            largest.0 = largest.0.max(*amplitude);
        } else {
            largest.1 = largest.1.max(*amplitude);
        }
    }
    largest
}

#[test]
fn a_balanced_shaft_has_lines_of_the_ball_pass_only() {
    let amplitudes = amplitudes(0.0);
    let (on, off) = on_and_off(&amplitudes, |bin| bin % PASSES == 0);
    println!("balanced: {on:e} µm on the lines, {off:e} µm elsewhere");
    // twelve balls hide their passing well: tens of picometres
    assert!(
        amplitudes[PASSES] > 1e-5,
        "{} µm at the ball pass",
        amplitudes[PASSES]
    );
    assert!(off < 1e-6 * on, "{off:e} of {on:e}");
}

#[test]
fn unbalance_adds_shaft_orders_and_sums_with_the_ball_pass_only() {
    let amplitudes = amplitudes(1e-6);
    let combination = |bin: usize| {
        let bin = bin as i64;
        (0..=12i64).any(|multiple| {
            (-12..=12i64)
                .any(|order| (multiple * PASSES as i64 + order * REVOLUTIONS as i64).abs() == bin)
        })
    };
    let (on, off) = on_and_off(&amplitudes, combination);
    println!("unbalanced: {on:e} µm on the lines, {off:e} µm elsewhere");
    for line in [
        REVOLUTIONS,
        PASSES,
        PASSES - REVOLUTIONS,
        PASSES + REVOLUTIONS,
    ] {
        assert!(
            amplitudes[line] > 1e3 * off,
            "bin {line}: {:e}",
            amplitudes[line]
        );
    }
    assert!(off < 1e-6 * on, "{off:e} of {on:e}");
}
