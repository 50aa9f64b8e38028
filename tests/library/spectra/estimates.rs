//! What scalings, whirls and cross spectra say of motions known in closed form.

use std::f64::consts::{PI, TAU};

use crate::analysis::{
    Detrend, EstimateError, Scaling, Segment, SpectrumKind, SpectrumQuantity, Window,
};

use super::record::{Motion, RATE, X, Y, estimated, plain, request, values};
use super::signal::noise;

/// 2 at 64 Hz about a mean of 3: a line on bin 64 of a second.
fn tone(time: f64) -> Motion {
    Motion::places([3.0 + 2.0 * (TAU * 64.0 * time + 0.4).cos(), 0.0])
}

#[test]
fn a_tone_is_as_high_as_its_scaling_says() {
    let expected = [
        (Scaling::Peak, 2.0),
        (Scaling::Rms, 2.0 / 2.0_f64.sqrt()),
        (Scaling::PeakToPeak, 4.0),
        (Scaling::Power, 2.0),
        (Scaling::Density, 2.0), // in bins of 1 Hz
    ];
    for (scaling, height) in expected {
        for window in [Window::Rectangular, Window::FlatTop] {
            let mut request = plain(scaling);
            request.window = window;
            let found = estimated(&request, 1024, tone).unwrap();
            let bandwidth = match scaling {
                Scaling::Density => window.equivalent_noise_bandwidth(),
                _ => 1.0,
            };
            let found = values(&found, SpectrumQuantity::Value(X))[64];
            assert!(
                (found - height / bandwidth).abs() < 1e-12,
                "{scaling:?} {window:?}"
            );
        }
    }
}

#[test]
fn the_density_of_noise_adds_up_to_its_power() {
    let noise = noise(7, 2048);
    let power = noise.iter().map(|x| x * x).sum::<f64>() / 2048.0;
    let of = |time: f64| Motion::places([noise[(time * RATE).round() as usize], 0.0]);
    let found = estimated(&plain(Scaling::Density), 2048, of).unwrap();
    let density = values(&found, SpectrumQuantity::Value(X));
    assert!((density.iter().sum::<f64>() * found.resolution / power - 1.0).abs() < 1e-12);
}

#[test]
fn the_phase_is_that_of_the_cosine_and_only_of_one_segment() {
    let found = estimated(&plain(Scaling::Peak), 1024, tone).unwrap();
    assert!((values(&found, SpectrumQuantity::Phase(X))[64] - 0.4).abs() < 1e-12);
    let mut averaged = plain(Scaling::Peak);
    averaged.segment = Segment::Seconds(0.25);
    let found = estimated(&averaged, 1024, tone).unwrap();
    assert_eq!(
        (found.segment, found.overlap, found.averages),
        (256, 128, 7)
    );
    assert_eq!(found.columns.len(), 1);
}

#[test]
fn a_whirl_against_the_shaft_stands_at_a_negative_frequency() {
    // a circle of radius 3 with the shaft at 20 Hz, and one of radius 1 against it at 50 Hz
    let motion = |time: f64| {
        let (with, against) = (TAU * 20.0 * time, -TAU * 50.0 * time);
        Motion::places([
            3.0 * with.cos() + against.cos(),
            3.0 * with.sin() + against.sin(),
        ])
    };
    for (scaling, factor) in [(Scaling::Peak, 1.0), (Scaling::PeakToPeak, 2.0)] {
        let request = request(SpectrumKind::Whirl, &[X, Y], scaling);
        for count in [1024, 1023] {
            let found = estimated(&request, count, motion).unwrap();
            let radii = values(&found, SpectrumQuantity::Rotary(X, Y));
            let at = |frequency: f64| {
                let row = (0..found.bins()).min_by(|a, b| {
                    let far = |row: &usize| (found.place(*row) - frequency).abs();
                    far(a).total_cmp(&far(b))
                });
                radii[row.unwrap()] / factor
            };
            // of 1023 samples the lines stand 0.02 and 0.05 bins beside theirs
            let near = if count == 1024 { 1e-12 } else { 0.05 };
            assert!((at(20.0) - 3.0).abs() < near && (at(-50.0) - 1.0).abs() < near);
            assert!(
                at(-20.0) < near && at(50.0) < near,
                "{} {}",
                at(-20.0),
                at(50.0)
            );
        }
    }
}

#[test]
fn a_cross_spectrum_tells_who_leads_and_by_how_much() {
    let mut request = request(SpectrumKind::Cross, &[X, Y], Scaling::Power);
    request.segment = Segment::Samples(256);
    request.window = Window::Hann;
    // y leads x by a quarter of a turn and half as much again
    let motion = |time: f64| {
        let angle = TAU * 64.0 * time;
        Motion::places([2.0 * angle.cos(), 3.0 * (angle + PI / 2.0).cos()])
    };
    let found = estimated(&request, 1024, motion).unwrap();
    let row = 16; // 4 Hz a bin
    assert!((values(&found, SpectrumQuantity::Cross(X, Y))[row] - 3.0).abs() < 1e-12);
    assert!((values(&found, SpectrumQuantity::CrossPhase(X, Y))[row] - PI / 2.0).abs() < 1e-12);
    assert!((values(&found, SpectrumQuantity::Coherence(X, Y))[row] - 1.0).abs() < 1e-12);
}

#[test]
fn noises_that_know_nothing_of_each_other_are_not_coherent() {
    let noises = [noise(3, 16_384), noise(4, 16_384)];
    let mut request = request(SpectrumKind::Cross, &[X, Y], Scaling::Density);
    request.segment = Segment::Samples(128);
    request.overlap = 0.0;
    let of = |time: f64| {
        let n = (time * RATE).round() as usize;
        Motion::places([noises[0][n], noises[1][n]])
    };
    let found = estimated(&request, 16_384, of).unwrap();
    let coherence = values(&found, SpectrumQuantity::Coherence(X, Y));
    // expected 1/128 of 128 averages
    let mean = coherence.iter().sum::<f64>() / coherence.len() as f64;
    assert!((mean - 1.0 / 128.0).abs() < 4e-3, "{mean}");
}

#[test]
fn an_envelope_shows_how_often_it_knocks() {
    // a ring at 300 Hz that swells 16 times a second, beside a stronger slow swing
    let motion = |time: f64| {
        let swell = 1.0 + 0.6 * (TAU * 16.0 * time).cos();
        Motion::places([
            5.0 * (TAU * 20.0 * time).cos() + swell * (TAU * 300.0 * time).cos(),
            0.0,
        ])
    };
    let kind = SpectrumKind::Envelope {
        band: [250.0, 350.0],
    };
    let mut request = request(kind, &[X], Scaling::Peak);
    request.detrend = Detrend::Constant;
    let found = estimated(&request, 1024, motion).unwrap();
    for (k, peak) in values(&found, SpectrumQuantity::Value(X))
        .iter()
        .enumerate()
    {
        let expected = if k == 16 { 0.6 } else { 0.0 };
        assert!((peak - expected).abs() < 1e-12, "bin {k}: {peak}");
    }
}

#[test]
fn a_line_of_an_envelope_between_bins_has_its_full_height() {
    let motion = |time: f64| {
        let swell = 1.0 + 0.6 * (TAU * 40.3 * time).cos();
        Motion::places([swell * (TAU * 300.0 * time).cos(), 0.0])
    };
    let kind = SpectrumKind::Envelope {
        band: [200.0, 400.0],
    };
    for window in [Window::Hann, Window::Hamming, Window::FlatTop] {
        for (scaling, expected) in [(Scaling::Peak, 0.6), (Scaling::Power, 0.5 * 0.6 * 0.6)] {
            let mut request = request(kind, &[X], scaling);
            (request.window, request.detrend) = (window, Detrend::Constant);
            let found = estimated(&request, 4096, motion).unwrap();
            let lines = found.lines_above_noise(0).into_iter();
            let (place, value) = lines.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
            let name = format!("{window:?} {scaling:?}");
            assert!((place - 40.3).abs() < 0.01, "{name}: {place} Hz");
            assert!((value / expected - 1.0).abs() < 0.01, "{name}: {value}");
        }
    }
}

#[test]
fn what_is_too_short_says_by_how_much() {
    let mut request = plain(Scaling::Peak);
    let of = |count| estimated(&request, count, tone).map(|found| found.samples);
    assert_eq!(
        of(15),
        Err(EstimateError::TooShort {
            samples: 15,
            needed: 16
        })
    );
    assert_eq!(of(16), Ok(16));
    request.segment = Segment::Seconds(2.0);
    let error = estimated(&request, 1024, tone).unwrap_err().to_string();
    assert!(
        error.contains("1024 samples") && error.contains("a segment 2048"),
        "{error}"
    );
    request.segment = Segment::Revolutions(3);
    let error = estimated(&request, 1024, tone).unwrap_err();
    assert_eq!(error, EstimateError::UnevenRevolutions);
}

#[test]
fn a_line_between_bins_leaks_and_one_on_a_bin_does_not() {
    let of = |frequency: f64, window| {
        let mut request = plain(Scaling::Rms);
        request.window = window;
        let motion = |time: f64| Motion::places([1e-6 * (TAU * frequency * time).cos(), 0.0]);
        let found = estimated(&request, 1024, motion).unwrap();
        found.checks[0].leak
    };
    assert_eq!(of(100.0, Window::Rectangular), None);
    assert_eq!(of(100.4, Window::Hann), None);
    let leak = of(100.4, Window::Rectangular).unwrap();
    assert_eq!(leak.bin, 100);
    assert!((leak.offset - 0.4).abs() < 0.01, "{leak:?}");
    assert!((leak.amplitude - 1e-6).abs() < 1e-8, "{leak:?}");
    // noise has hills, but no lines
    let noise = noise(5, 1024);
    let of_noise = |time: f64| Motion::places([noise[(time * RATE).round() as usize], 0.0]);
    let found = estimated(&plain(Scaling::Peak), 1024, of_noise).unwrap();
    assert_eq!(found.checks[0].leak, None);
}

#[test]
fn what_folds_shows_in_the_top_tenth() {
    let share = |frequency: f64| {
        let motion = |time: f64| Motion::places([(TAU * frequency * time).cos(), 0.0]);
        let found = estimated(&plain(Scaling::Density), 1024, motion).unwrap();
        let power = found.checks[0].top_power.unwrap();
        assert!((power.total - 0.75).abs() < 1e-12, "1.5 bins of Hann's");
        power.top / power.total
    };
    assert!(share(400.0) < 1e-20);
    assert!(share(400.5) < 1e-8, "skirts do not count");
    assert!(share(490.0) > 0.999_999);
    assert!(share(1024.0 - 480.0) > 0.999_999, "folded to 480 Hz");
}
