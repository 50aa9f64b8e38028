//! Ball bearing 6204 of Tiwari, Gupta & Prakash (2000), inputs as used in the literature: Z = 8,
//! ball-pass factor 3.05 × shaft, K_n = 7.055e9 N/m^1.5, m = 0.6 kg, c = 200 N s/m, W = 6 N.
//! Clearance 1 µm, no unbalance: period 1 from 500 to 13 250 rpm, period 2 from 13 500 to
//! 15 250 rpm, period 1 to 20 000 rpm.
//!
//! The clearance is the radial one: with 1 µm on the diameter the doubling is gone from this range
//! of speeds and stands near 18 000 rpm.

use std::f64::consts::{PI, TAU};

use crate::rotor::RotorDefinition;

use crate::tests::support::{
    literature_bearing, model, peak_to_peak, samples, settings, varying_compliance,
};

/// Ball passes of the shaft at 1 rad/s, in rad.
const BALL_PASS_FACTOR: f64 = 3.05;
/// Ball passes that are looked at after the motion has settled.
const OBSERVED: f64 = 64.0;
/// Time to settle, s: free motion decays like exp(−c t/2m) = exp(−167 t), more slowly near a
/// doubling.
const SETTLE: f64 = 1.0;

fn definition(speed: f64, radial_clearance: f64) -> RotorDefinition {
    // the ratio of ball to pitch diameter that gives the factor: (Z/2)(1 − D/d_m)
    let ratio = 1.0 - 2.0 * BALL_PASS_FACTOR / 8.0;
    let diameters = [7.938e-3, 7.938e-3 / ratio];
    let bearing = literature_bearing(8, diameters, radial_clearance, 7.055e9);
    varying_compliance(speed, 0.6, 6.0, bearing)
}

/// Ball passes, up to 8, after which x and y return to where they were, seen once a ball pass.
fn period(revolutions_per_minute: f64, radial_clearance: f64) -> Option<usize> {
    let speed = revolutions_per_minute * PI / 30.0;
    let pass = TAU / (BALL_PASS_FACTOR * speed);
    let settle = (SETTLE / pass).ceil();
    let mut model = model(
        definition(speed, radial_clearance),
        (settle + OBSERVED + 0.5) * pass,
        1.0 / pass,
    );
    model.integrator = settings(1e-9);
    let seen: Vec<[f64; 5]> = samples(&model, (settle - 0.5) * pass)
        .iter()
        .map(|sample| sample.displacement)
        .collect();
    let swing = peak_to_peak(seen.iter().map(|place| place[1]));
    // what repeats does so to 1e-12 m here; what does not changes by 1e-7 m
    let repeats = |passes: usize| {
        let pairs = seen.iter().zip(seen.iter().skip(passes));
        pairs.fold(0.0_f64, |largest, (a, b)| {
            largest.max((a[0] - b[0]).abs()).max((a[1] - b[1]).abs())
        }) < f64::max(1e-3 * swing, 1e-11)
    };
    (1..=8).find(|&passes| repeats(passes))
}

#[test]
fn period_one_below_the_doubling() {
    for speed in [500.0, 5000.0, 13_000.0, 13_250.0] {
        assert_eq!(period(speed, 1e-6), Some(1), "{speed} rpm");
    }
}

#[test]
fn period_two_from_13_500_to_15_250_rpm() {
    for speed in [13_500.0, 14_500.0, 15_250.0] {
        assert_eq!(period(speed, 1e-6), Some(2), "{speed} rpm");
    }
}

#[test]
fn period_one_above_the_doubling() {
    for speed in [15_500.0, 17_000.0, 20_000.0] {
        assert_eq!(period(speed, 1e-6), Some(1), "{speed} rpm");
    }
}

#[test]
fn half_the_clearance_moves_the_doubling_to_higher_speed() {
    assert_eq!(period(14_500.0, 0.5e-6), Some(1));
    assert_eq!(period(18_000.0, 0.5e-6), Some(2));
}
