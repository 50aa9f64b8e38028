//! Varying loads: each by its formula, their sum, and what the shaft does under them.

use std::f64::consts::{PI, TAU};

use crate::integrate::System;
use crate::rotor::load::{
    ChainDrive, Harmonic, HarmonicRate, Interpolation, Noise, NoiseBand, RandomShocks, Series,
    SeriesComponent, SeriesError, Shock, ShockStatistics, Sprocket,
};
use crate::rotor::{Damping, Load, LoadKind, Rotor, RotorDefinition, Sample};

use super::linear_rotor::{linear, natural_speed};
use crate::tests::support::{
    assert_near, constant, model, peak_to_peak, samples, thrust_rotor, under,
};

fn at_centre(kind: LoadKind) -> Load {
    Load {
        kind,
        position: 0.0,
    }
}

fn harmonic(rate: HarmonicRate) -> Harmonic {
    Harmonic {
        amplitude: [3.0, 0.0, -2.0, 0.0, 1.0],
        rate,
        phase: 0.4,
    }
}

fn shock(every: Option<f64>) -> Shock {
    Shock {
        peak: [100.0, -50.0, 0.0, 0.0, 0.0],
        duration: 2e-3,
        start: 5e-3,
        every,
    }
}

#[test]
fn a_harmonic_load_is_a_cosine_of_time_or_of_the_angle() {
    let of_time = harmonic(HarmonicRate::Frequency(50.0)).at(0.013, 7.0);
    assert_near("x", of_time[0], 3.0 * (TAU * 0.65 + 0.4).cos(), 1e-14);
    let of_angle = harmonic(HarmonicRate::Order(2.5)).at(0.013, 7.0);
    assert_near("z", of_angle[2], -2.0 * (17.5_f64 + 0.4).cos(), 1e-14);
}

/// Midpoint sum over the shocks of 20 ms; it is exact to (h/T)².
#[test]
fn a_shock_has_the_impulse_of_its_half_sine_each_time_it_comes() {
    for (every, shocks) in [(None, 1.0), (Some(5e-3), 3.0), (Some(2e-3), 7.5)] {
        let shock = shock(every);
        let step = 1e-6;
        let impulse: f64 = (0..20_000)
            .map(|k| step * shock.at((f64::from(k) + 0.5) * step)[0])
            .sum();
        let expected = shocks * 2.0 * 100.0 * 2e-3 / PI;
        assert_near("impulse", impulse, expected, 1e-6 * expected);
    }
}

#[test]
fn begins_and_ends_of_shocks_are_breaks() {
    let repeated = shock(Some(10e-3));
    let mut breaks = vec![repeated.next_break(0.0)];
    for _ in 0..3 {
        breaks.push(repeated.next_break(breaks[breaks.len() - 1]));
    }
    for (found, expected) in breaks.into_iter().zip([5e-3, 7e-3, 15e-3, 17e-3]) {
        assert_near("break", found, expected, 1e-15);
    }
    assert_eq!(shock(None).next_break(8e-3), f64::INFINITY);
}

const STATISTICS: ShockStatistics = ShockStatistics {
    peak: [0.0, -1000.0, 0.0, 0.0, 0.0],
    least: 0.25,
    duration: 3e-3,
    rate: 100.0,
    seed: 7,
};

#[test]
fn random_shocks_come_as_asked_and_by_their_seed() {
    let shocks = RandomShocks::new(&STATISTICS, 100.0);
    assert_eq!(shocks, RandomShocks::new(&STATISTICS, 100.0));
    let other = ShockStatistics {
        seed: 8,
        ..STATISTICS
    };
    assert_ne!(shocks, RandomShocks::new(&other, 100.0));
    let count = shocks.shocks.len() as f64;
    // a Poisson number of mean 10 000 has the deviation 100
    assert_near("number", count, 10_000.0, 400.0);
    let parts = shocks.shocks.iter().map(|(_, part)| *part);
    assert!(parts.clone().all(|part| (0.25..=1.0).contains(&part)));
    // uniform: deviation 0.75/√12/√count
    assert_near("mean part", parts.sum::<f64>() / count, 0.625, 0.01);
}

#[test]
fn random_shocks_are_the_sum_of_half_sines() {
    let shocks = RandomShocks::new(&STATISTICS, 1.0);
    for step in 0..1000 {
        let time = f64::from(step) * 1e-3;
        let sum: f64 = shocks
            .shocks
            .iter()
            .map(|(begin, part)| (part, (time - begin) / 3e-3))
            .filter(|(_, since)| (0.0..=1.0).contains(since))
            .map(|(part, since)| -1000.0 * part * (PI * since).sin())
            .sum();
        assert_near("y", shocks.at(time)[1], sum, 1e-9);
    }
}

fn chain(teeth: u32, harmonics: u32) -> ChainDrive {
    ChainDrive {
        teeth,
        pitch: 0.05,
        span: 0.5,
        force: 1000.0,
        direction: 0.0,
        harmonics,
    }
}

/// F ∝ 1/cos θ along the strand and F (mean(r) − r)/L across it, θ from the middle of a pitch.
#[test]
fn the_pull_of_a_chain_is_inverse_to_its_lever() {
    for teeth in [5, 8, 17] {
        let sprocket = Sprocket::new(&chain(teeth, 2000));
        let half = PI / f64::from(teeth);
        let radius = 0.025 / half.sin();
        let mean_lever = radius * half.sin() / half;
        // ∫ dθ/cos θ = ln tan(π/4 + θ/2)
        let mean = 1000.0 * half / (PI / 4.0 + half / 2.0).tan().ln();
        for step in -40..40 {
            let angle = 0.3 * f64::from(step);
            let theta = angle - 2.0 * half * (angle / (2.0 * half)).round();
            let along = mean / theta.cos();
            let across = along * (mean_lever - radius * theta.cos()) / 0.5;
            let [x, y, ..] = sprocket.at(angle);
            // what 2000 harmonics leave of the corner: the slope there over π² z N
            assert_near("along", x, along, 0.2);
            assert_near("across", y, across, 0.2);
        }
    }
}

#[test]
fn the_mean_pull_of_a_chain_is_the_mean_over_a_revolution() {
    let sprocket = Sprocket::new(&chain(8, 8));
    let mut mean = [0.0; 2];
    for step in 0..1000 {
        let [x, y, ..] = sprocket.at(TAU * f64::from(step) / 1000.0);
        mean = [mean[0] + x / 1000.0, mean[1] + y / 1000.0];
    }
    assert_near("along", mean[0], 1000.0, 1e-9);
    assert_near("along", sprocket.mean()[0], 1000.0, 1e-9);
    assert_near("across", mean[1], sprocket.mean()[1], 1e-9);
}

#[test]
fn noise_has_its_root_mean_square_and_comes_by_its_seed() {
    let band = NoiseBand {
        rms: [10.0, 0.0, 5.0, 0.0, 0.0],
        low: 100.0,
        high: 300.0,
        lines: 64,
        seed: 3,
    };
    let noise = Noise::new(&band);
    let count = 200_000;
    let mut squares = [0.0; 5];
    let mut outside = [0.0; 2];
    for step in 0..count {
        let time = f64::from(step) * 1e-4;
        let value = noise.at(time);
        for axis in 0..5 {
            squares[axis] += value[axis] * value[axis] / f64::from(count);
        }
        // a line at 400 Hz would show here
        let (sin, cos) = (TAU * 400.0 * time).sin_cos();
        outside[0] += value[0] * cos / f64::from(count);
        outside[1] += value[0] * sin / f64::from(count);
    }
    assert_near("rms x", squares[0].sqrt(), 10.0, 0.1);
    assert_near("rms z", squares[2].sqrt(), 5.0, 0.05);
    assert_eq!(squares[1], 0.0);
    // the lines leak by 1/(2π Δf T) with Δf ≥ 100 Hz and T = 20 s
    assert!(outside[0].hypot(outside[1]) < 1e-2, "{outside:?}");
    assert_eq!(noise.at(0.5), Noise::new(&band).at(0.5));
    let other = Noise::new(&NoiseBand { seed: 4, ..band });
    assert_ne!(noise.at(0.5), other.at(0.5));
}

fn series(values: &[f64], interpolation: Interpolation) -> Series {
    let times = vec![0.0, 1.0, 1.5, 3.0, 4.0];
    let column = SeriesComponent {
        axis: 1,
        values: values.to_vec(),
    };
    Series::new(times, vec![column], interpolation).expect("a series")
}

const RISING: [f64; 5] = [2.0, 3.0, 3.0, 10.0, 10.5];

#[test]
fn a_series_passes_its_rows_and_holds_its_ends() {
    for interpolation in [Interpolation::Linear, Interpolation::MonotoneCubic] {
        let series = series(&RISING, interpolation);
        for (time, value) in [0.0, 1.0, 1.5, 3.0, 4.0].into_iter().zip(RISING) {
            assert_near("row", series.at(time)[1], value, 1e-14);
        }
        assert_eq!(series.at(-1.0)[1], 2.0);
        assert_eq!(series.at(9.0)[1], 10.5);
        assert_eq!(series.next_break(1.0), 1.5);
    }
}

#[test]
fn a_series_does_not_overshoot_between_its_rows() {
    let straight = series(&RISING, Interpolation::Linear);
    assert_near("straight", straight.at(2.0)[1], 3.0 + 7.0 / 3.0, 1e-14);
    let cubic = series(&RISING, Interpolation::MonotoneCubic);
    let curve: Vec<f64> = (0..=4000)
        .map(|step| cubic.at(f64::from(step) * 1e-3)[1])
        .collect();
    assert!(curve.windows(2).all(|pair| pair[1] >= pair[0] - 1e-14));
    // between 1.5 s and 3 s: slopes 0 and S1 S2/(α S2 + (1 − α) S1), α = (h1 + 2 h2)/3(h1 + h2)
    let (before, after, alpha) = (7.0 / 1.5, 0.5, 3.5 / 7.5);
    let slope: f64 = before * after / (alpha * after + (1.0 - alpha) * before);
    let expected = 0.5 * 3.0 + 0.5 * 10.0 - 0.125 * 1.5 * slope;
    assert_near("cubic", cubic.at(2.25)[1], expected, 1e-13);
}

#[test]
fn rows_that_make_no_series_are_errors() {
    let make = |times: &[f64], values: &[f64]| {
        let column = SeriesComponent {
            axis: 0,
            values: values.to_vec(),
        };
        Series::new(times.to_vec(), vec![column], Interpolation::Linear).unwrap_err()
    };
    assert_eq!(make(&[0.0], &[1.0]), SeriesError::TooFew { rows: 1 });
    assert_eq!(
        make(&[0.0, 1.0], &[1.0]),
        SeriesError::Length { values: 1, rows: 2 }
    );
    let infinite = make(&[0.0, 1.0], &[1.0, f64::INFINITY]);
    assert!(matches!(infinite, SeriesError::NotFinite { row: 2, .. }));
    let repeated = make(&[0.0, 1.0, 1.0], &[1.0; 3]);
    assert!(matches!(repeated, SeriesError::Time { row: 3, .. }));
}

#[test]
fn loads_add_up() {
    let kind = LoadKind::Harmonic(harmonic(HarmonicRate::Frequency(0.0)));
    let load = Load {
        kind,
        position: 0.5,
    };
    let force = harmonic(HarmonicRate::Frequency(0.0)).at(0.0, 0.0);
    let rotor = Rotor::assemble(&at_rest(vec![load.clone(), load]));
    let rotor = rotor.expect("a rotor");
    let unloaded = Rotor::assemble(&at_rest(Vec::new())).expect("a rotor");
    let accelerations = [&rotor, &unloaded].map(|rotor| {
        let mut rate = vec![0.0; rotor.states()];
        rotor.derivative(0.0, &rotor.start_state(), &mut rate);
        rate.split_off(rotor.states() / 2)
    });
    for axis in [0, 1, 2] {
        let added = accelerations[0][axis] - accelerations[1][axis];
        assert_near("a", added, 2.0 * force[axis] / 5.0, 1e-9);
    }
}

#[test]
fn a_shaken_housing_pushes_with_mass_times_acceleration() {
    let kind = LoadKind::Base(Box::new(LoadKind::Shock(shock(None))));
    let acceleration = |loads| {
        let rotor = Rotor::assemble(&at_rest(loads)).expect("a rotor");
        let mut rate = vec![0.0; rotor.states()];
        rotor.derivative(6e-3, &rotor.start_state(), &mut rate);
        rate.split_off(rotor.states() / 2)
    };
    let [shaken, still] = [vec![at_centre(kind)], Vec::new()].map(acceleration);
    assert_near("x", shaken[0] - still[0], -100.0, 1e-9);
    assert_near("y", shaken[1] - still[1], 50.0, 1e-9);
}

/// A linear rotor at rest under some loads, its cage standing still: only they move it.
fn at_rest(loads: Vec<Load>) -> RotorDefinition {
    let definition = RotorDefinition {
        speed: 0.0,
        damping: Damping::Ratio(0.03),
        ..linear(thrust_rotor())
    };
    under(definition, loads)
}

fn x(samples: &[Sample]) -> Vec<f64> {
    samples
        .iter()
        .map(|sample| sample.displacement[0])
        .collect()
}

#[test]
fn the_motions_under_loads_superpose_on_linear_bearings() {
    let one = at_centre(LoadKind::Shock(shock(Some(4e-3))));
    let other = at_centre(LoadKind::Noise(Noise::new(&NoiseBand {
        rms: [20.0, 0.0, 0.0, 0.0, 0.0],
        low: 50.0,
        high: 500.0,
        lines: 16,
        seed: 1,
    })));
    let run = |loads| x(&samples(&model(at_rest(loads), 0.05, 10_000.0), 0.0));
    let parts = [run(vec![one.clone()]), run(vec![other.clone()])];
    let both = run(vec![one, other]);
    let size = peak_to_peak(both.iter().copied());
    for (index, both) in both.iter().enumerate() {
        let sum = parts[0][index] + parts[1][index];
        // tolerance 1e-10 of the motion, over some hundred steps
        assert_near("x", *both, sum, 1e-7 * size);
    }
}

/// From rest the steps grow long; a break keeps them from stepping over 20 µs. The response is that
/// to an impulse J = 2 P T/π in the middle of the shock, to (Ω T)².
#[test]
fn a_short_shock_on_a_resting_shaft_is_not_missed() {
    let (start, duration) = (0.0502_f64, 20e-6);
    let shock = Shock {
        peak: [1e5, 0.0, 0.0, 0.0, 0.0],
        duration,
        start,
        every: None,
    };
    let definition = at_rest(vec![at_centre(LoadKind::Shock(shock))]);
    let (natural, mass) = (natural_speed(&definition), definition.shaft.mass);
    let damped = natural * (1.0_f64 - 0.03 * 0.03).sqrt();
    let impulse = 2.0 * 1e5 * duration / PI;
    let amplitude = impulse / (mass * damped);
    for sample in samples(&model(definition, 0.06, 2000.0), 0.0) {
        let since = sample.time - start - 0.5 * duration;
        let expected = if since > 0.0 {
            amplitude * (-0.03 * natural * since).exp() * (damped * since).sin()
        } else {
            0.0
        };
        // the width of the shock: (Ω T)²/20 with Ω T = 0.13
        assert_near("x", sample.displacement[0], expected, 2e-3 * amplitude);
    }
}

#[test]
fn the_equilibrium_carries_mean_pulls_but_no_vibration() {
    let place = |loads| {
        let definition = at_rest(loads);
        let rotor = Rotor::assemble(&definition).expect("a rotor");
        rotor.equilibrium().displacement
    };
    let still = place(Vec::new());
    let vibration = vec![
        at_centre(LoadKind::Harmonic(harmonic(HarmonicRate::Frequency(10.0)))),
        at_centre(LoadKind::Shock(shock(None))),
    ];
    assert_eq!(place(vibration), still);
    let drive = ChainDrive {
        force: 100.0,
        span: 1e9,
        ..chain(8, 8)
    };
    let pulled = place(vec![at_centre(LoadKind::Sprocket(Sprocket::new(&drive)))]);
    let constant = RotorDefinition {
        loads: constant([100.0, 0.0, 1000.0, 0.0, 0.0]),
        ..at_rest(Vec::new())
    };
    let expected = Rotor::assemble(&constant).expect("a rotor");
    let expected = expected.equilibrium().displacement;
    assert_near("x", pulled[0], expected[0], 1e-12);
    assert!(expected[0] > 1e-7);
    let recorded = series(&[50.0, 0.0, 0.0, 0.0, 0.0], Interpolation::Linear);
    let recorded = place(vec![at_centre(LoadKind::Series(recorded))]);
    assert!(recorded[1] > 1e-7, "{recorded:?}");
}
