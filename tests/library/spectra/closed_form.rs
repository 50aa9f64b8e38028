//! Spectra against signals whose Fourier series is known in closed form.

use std::f64::consts::{PI, TAU};

use crate::analysis::{
    Analysis, BearingFrequencies, Channel, Line, LineSurfaces, MOST_PEAKS, Peak, Precision,
    Recording, SampleGrid, Sources, Transform, Window, causes, nearest_cause, other_causes,
};
use crate::physics::BallPass;
use crate::rotor::{Freedoms, NaturalFrequency, Sample, Whirl};
use proptest::prelude::*;

const LENGTHS: [usize; 6] = [64, 100, 97, 101, 1000, 4099];

/// A cosine of `bin` periods in `length` samples.
fn cosine(length: usize, bin: f64, amplitude: f64, phase: f64) -> Vec<f64> {
    let angle = |n: usize| TAU * bin * n as f64 / length as f64 + phase;
    (0..length).map(|n| amplitude * angle(n).cos()).collect()
}

/// Spectrum and peaks of a signal in x, at a resolution of 1 Hz.
fn analyse(signal: &[f64], window: Window) -> Analysis {
    let rate = signal.len() as f64;
    let channels = [Channel::Displacement(0), Channel::Force(0)];
    let grid = SampleGrid {
        rate,
        shaft_frequency: 0.0,
        per_revolution: None,
    };
    let mut recording = Recording::new(grid, 0.0).with(channels.iter().copied());
    for (n, x) in signal.iter().enumerate() {
        recording.record(&sample(n as f64 / rate, *x));
    }
    let analysis = recording.spectrum(&channels, window, &[]);
    analysis.expect("enough samples")
}

fn sample(time: f64, x: f64) -> Sample {
    Sample {
        time,
        displacement: [x, 0.0, 0.0, 0.0, 0.0],
        force_on_shaft: Some([0.0; 5]),
        ..Sample::default()
    }
}

fn peaks_of(signal: &[f64]) -> Vec<Peak> {
    let mut peaks = analyse(signal, Window::Rectangular).peaks;
    peaks.retain(|peak| peak.channel == Channel::Displacement(0));
    peaks
}

#[test]
fn a_sine_on_a_bin_is_exact_to_round_off_under_every_window() {
    for length in LENGTHS {
        let transform = Transform::new(cosine(length, 11.0, 2.0, 0.7));
        for window in [Window::Rectangular, Window::Hann, Window::FlatTop] {
            assert!((transform.amplitude(11, window) - 2.0).abs() < 1e-13);
            assert!((transform.line(11, window).arg() - 0.7).abs() < 1e-12);
        }
        for k in (0..transform.bins()).filter(|k| *k != 11) {
            assert!(transform.amplitude(k, Window::Rectangular) < 1e-13);
        }
    }
    let transform = Transform::new(cosine(1000, 11.0, 1.0, 0.0));
    assert!((transform.amplitude(11, Window::Rectangular) - 1.0).abs() < 1e-14);
}

#[test]
fn mean_and_half_sampling_rate_are_not_doubled() {
    let signal = (0..64).map(|n| 5.0 + 3.0 * (PI * f64::from(n)).cos());
    let transform = Transform::new(signal.collect());
    assert!((transform.amplitude(0, Window::Rectangular) - 5.0).abs() < 1e-14);
    assert!((transform.amplitude(32, Window::Rectangular) - 3.0).abs() < 1e-14);
}

#[test]
fn a_window_is_alike_in_frequency_and_in_time() {
    for (length, window) in [(64, Window::Hann), (97, Window::FlatTop)] {
        let signal = cosine(length, 7.3, 1.5, 0.4);
        let weighted = signal.iter().enumerate();
        let weighted = weighted.map(|(n, x)| x * window.weight(n, length) / window.coherent_gain());
        let (direct, mixed) = (
            Transform::new(weighted.collect()),
            Transform::new(signal.clone()),
        );
        for k in 0..direct.bins() {
            let expected = direct.amplitude(k, Window::Rectangular);
            assert!((mixed.amplitude(k, window) - expected).abs() < 1e-14);
        }
    }
}

#[test]
fn flat_top_is_within_one_percent_anywhere_between_bins() {
    let largest = |bin: f64| {
        let transform = Transform::new(cosine(1024, bin, 1.0, 0.3));
        let amplitudes = (0..transform.bins()).map(|k| transform.amplitude(k, Window::FlatTop));
        amplitudes.fold(0.0, f64::max)
    };
    for step in 0..=50 {
        let bin = 100.0 + f64::from(step) / 50.0;
        assert!((largest(bin) - 1.0).abs() < 0.01, "bin {bin}");
    }
}

#[test]
fn a_line_between_bins_is_refined_in_frequency_and_amplitude() {
    for length in [4096, 4095, 4093] {
        for step in 0..20 {
            let bin = 700.0 + f64::from(step) / 20.0;
            let peaks = peaks_of(&cosine(length, bin, 2.5e-6, 1.1));
            assert_eq!(peaks.len(), 1, "bin {bin}");
            assert!((peaks[0].frequency - bin).abs() < 1e-6, "bin {bin}");
            assert!((peaks[0].amplitude / 2.5e-6 - 1.0).abs() < 1e-6);
        }
    }
}

#[test]
fn a_weak_line_eight_bins_from_a_strong_one_is_found() {
    let strong = cosine(2000, 300.0, 1.0, 0.0);
    let weak = cosine(2000, 308.0, 1e-3, 0.5);
    let sum: Vec<f64> = strong.iter().zip(&weak).map(|(a, b)| a + b).collect();
    let peaks = peaks_of(&sum);
    assert_eq!(peaks.len(), 2);
    assert!((peaks[1].frequency - 308.0).abs() < 1e-9);
    assert!((peaks[1].amplitude - 1e-3).abs() < 1e-12);
}

#[test]
fn one_period_in_the_window_is_still_a_peak() {
    for phase in [0.0, 0.9, PI / 2.0] {
        let peaks = peaks_of(&cosine(128, 1.0, 1.0, phase));
        assert_eq!(peaks.len(), 1);
        assert!((peaks[0].frequency - 1.0).abs() < 1e-12);
        assert!((peaks[0].amplitude - 1.0).abs() < 1e-12);
    }
}

#[test]
fn rest_has_no_peaks_and_no_nan() {
    for value in [0.0, 3.0e-5, -1e3] {
        let analysis = analyse(&[value; 500], Window::FlatTop);
        assert!(analysis.peaks.is_empty(), "{:?}", analysis.peaks);
        for channel in &analysis.spectrum.channels {
            assert!(channel.amplitude.iter().all(|a| a.is_finite()));
            assert!(channel.phase.iter().all(|phase| phase.is_finite()));
        }
    }
}

#[test]
fn at_most_twelve_peaks_strongest_first() {
    let signal: Vec<f64> = (0..4000)
        .map(|n| {
            let lines = 1..=30;
            let angle = TAU * f64::from(n) / 4000.0;
            lines
                .map(|j| (f64::from(j * 50) * angle).cos() / f64::from(j))
                .sum()
        })
        .collect();
    let peaks = peaks_of(&signal);
    assert_eq!(peaks.len(), MOST_PEAKS);
    for (j, peak) in (1..).zip(&peaks) {
        assert!((peak.frequency - f64::from(j * 50)).abs() < 1e-6);
    }
}

#[test]
fn the_window_holds_the_last_whole_revolutions() {
    let channels = Channel::of_freedoms(Freedoms::Translational);
    let grid = SampleGrid::of_angle(10.0, 32);
    let mut recording = Recording::new(grid, 0.105).with(channels.iter().copied());
    for n in 0..=100 {
        recording.record(&sample(f64::from(n) / 320.0, 0.0));
    }
    let analysis = recording.spectrum(&channels, Window::Rectangular, &[]);
    let spectrum = analysis.unwrap().spectrum;
    // Samples 34 … 100 are recorded: two revolutions of 32, samples 37 … 100.
    assert_eq!(spectrum.length, 64);
    assert!((spectrum.start - 37.0 / 320.0).abs() < 1e-15);
    assert_eq!(spectrum.resolution, 5.0);
    assert_eq!(spectrum.channels.len(), 6);
    assert_eq!(spectrum.order(2), Some(1.0));
}

#[test]
fn less_than_a_revolution_makes_no_spectrum() {
    let channels = Channel::of_freedoms(Freedoms::Radial);
    let grid = SampleGrid::of_angle(10.0, 32);
    let mut recording = Recording::new(grid, 0.0).with(channels.iter().copied());
    for n in 0..31 {
        recording.record(&sample(f64::from(n) / 320.0, 0.0));
    }
    assert_eq!(recording.spectrum(&channels, Window::Hann, &[]), None);
}

/// Lines of an unbalanced shaft, of bearings whose balls differ and have dents, and of natural frequencies.
fn lines_of(shaft: f64, bearings: &[BallPass], natural: &[f64]) -> Vec<Line> {
    causes(&Sources {
        shaft,
        bearings: bearings.iter().map(|pass| same(*pass)).collect(),
        natural: natural
            .iter()
            .map(|frequency| undamped(*frequency))
            .collect(),
        surfaces: bearings.iter().map(|_| dented_ball()).collect(),
        unbalanced: true,
        ..Sources::default()
    })
}

fn dented_ball() -> LineSurfaces {
    LineSurfaces {
        balls_show_spin: true,
        balls_differ: true,
        ..LineSurfaces::default()
    }
}

fn same(pass: BallPass) -> BearingFrequencies {
    BearingFrequencies {
        simulated: pass,
        nominal: pass,
    }
}

fn undamped(frequency: f64) -> NaturalFrequency {
    NaturalFrequency {
        frequency,
        damped_frequency: frequency,
        damping_ratio: 0.0,
        whirl: Whirl::Straight,
    }
}

fn cause(frequency: f64, resolution: f64, lines: &[Line]) -> Option<String> {
    nearest_cause(frequency, resolution, lines).map(|line| line.kind.to_string())
}

#[test]
fn the_simplest_of_equally_near_causes_names_a_line() {
    let pass = BallPass {
        outer: 400.0,
        inner: 600.0,
        spin: 200.0,
        cage: 40.0,
    };
    let lines = lines_of(100.0, &[pass], &[600.0]);
    // 4× = BPFO, 6× = BPFI = natural frequency, 5× = BPFO + 1×.
    for (frequency, name) in [(400.0, "4×"), (600.0, "6×"), (500.0, "5×"), (40.0, "cage")] {
        assert_eq!(cause(frequency, 1.0, &lines).as_deref(), Some(name));
    }
    for (frequency, name) in [(250.0, "5/2×"), (325.0, "none")] {
        assert_eq!(
            cause(frequency, 1.0, &lines).as_deref().unwrap_or("none"),
            name
        );
    }
    assert_eq!(cause(400.8, 1.0, &lines), None);
}

#[test]
fn bearings_are_told_apart_only_where_their_frequencies_differ() {
    let bearing = |scale| BallPass {
        outer: 358.5 * scale,
        inner: 541.5 * scale,
        spin: 235.7 * scale,
        cage: 39.8 * scale,
    };
    let mut lines = lines_of(100.0, &[bearing(1.0), bearing(1.0), bearing(1.1)], &[]);
    lines.retain(|line| !line.kind.to_string().contains("BSF"));
    let name = |frequency| cause(frequency, 0.1, &lines);
    assert_eq!(name(717.0).as_deref(), Some("2×BPFO"));
    assert_eq!(name(441.5).as_deref(), Some("BPFI − 1×"));
    assert_eq!(name(537.75).as_deref(), Some("3/2×BPFO"));
    assert_eq!(name(788.7).as_deref(), Some("2×BPFO of bearing 3"));
}

#[test]
fn a_shaft_that_stands_has_natural_frequencies_only() {
    let pass = BallPass {
        outer: 0.0,
        inner: 0.0,
        spin: 0.0,
        cage: 0.0,
    };
    let lines = lines_of(0.0, &[pass], &[50.0, 80.0]);
    assert_eq!(lines.len(), 2);
    assert_eq!(
        cause(80.0, 1.0, &lines).as_deref(),
        Some("natural frequency 2")
    );
}

#[test]
fn a_spot_on_a_ball_shows_at_its_spin_beside_the_cage() {
    let pass = |scale: f64| BallPass {
        outer: 358.5 * scale,
        inner: 541.5 / scale,
        spin: 235.7 * scale,
        cage: 39.83 * scale,
    };
    let lines = causes(&Sources {
        shaft: 100.0,
        bearings: vec![BearingFrequencies {
            simulated: pass(1.0),
            nominal: pass(0.99),
        }],
        surfaces: vec![dented_ball()],
        ..Sources::default()
    });
    let name = |frequency| cause(frequency, 0.1, &lines);
    assert_eq!(name(2.0 * 235.7 - 39.83).as_deref(), Some("2×BSF − 1×cage"));
    // the outer race's line stands where the simulated cage puts it
    assert_eq!(name(358.5).as_deref(), Some("BPFO"));
    // what a spall rings is far above the frequency at which balls pass
    assert_eq!(name(22.0 * 358.5).as_deref(), Some("22×BPFO"));
    let line = nearest_cause(358.5, 0.1, &lines).unwrap();
    assert!((line.nominal.unwrap() - 354.915).abs() < 1e-9);
}

/// Perfect bearings of a balanced shaft: neither spin nor cage nor orders of the shaft, whose place a load takes.
#[test]
fn only_what_the_scene_has_names_a_line() {
    let pass = BallPass {
        outer: 358.5,
        inner: 541.5,
        spin: 235.7,
        cage: 39.83,
    };
    let mut sources = Sources {
        shaft: 100.0,
        bearings: vec![same(pass)],
        meshing: vec![800.0],
        loads: vec![(1, 300.0)],
        ..Sources::default()
    };
    let names = [
        (358.5, "BPFO"),
        (717.0, "2×BPFO"),
        (800.0, "meshing"),
        (600.0, "2×varying load 2"),
        (39.83, ""),
        (2.0 * 235.7, ""),
        (541.5, ""),
        (458.5, ""),
        (100.0, ""),
    ];
    let name = |frequency, lines: &[Line]| cause(frequency, 0.1, lines).unwrap_or_default();
    let lines = causes(&sources);
    for (frequency, expected) in names {
        assert_eq!(name(frequency, &lines), expected, "{frequency} Hz");
    }
    sources.unbalanced = true;
    let lines = causes(&sources);
    for (frequency, expected) in [(100.0, "1×"), (458.5, "BPFO + 1×"), (541.5, "BPFI")] {
        assert_eq!(name(frequency, &lines), expected, "{frequency} Hz");
    }
    assert_eq!(name(800.0, &lines), "meshing");
}

#[test]
fn what_else_is_within_the_tolerance_is_listed_nearest_first() {
    let pass = BallPass {
        outer: 400.0,
        inner: 600.0,
        spin: 200.2,
        cage: 40.0,
    };
    let lines = lines_of(100.0, &[pass], &[400.5]);
    let named = nearest_cause(400.1, 1.0, &lines);
    assert_eq!(
        named.map(|line| line.kind.to_string()).as_deref(),
        Some("4×")
    );
    let others = other_causes(400.1, 1.0, &lines, named);
    let names: Vec<String> = others.iter().map(|line| line.kind.to_string()).collect();
    assert_eq!(names[0], "BPFO");
    assert!(names.contains(&"2×BSF".to_owned()), "{names:?}");
    assert!(
        names.contains(&"natural frequency 1".to_owned()),
        "{names:?}"
    );
    let distances = others.iter().map(|line| (line.frequency - 400.1).abs());
    assert!(distances.is_sorted());
}

#[test]
fn the_phase_of_a_line_between_bins_is_that_of_its_cosine() {
    for length in [4096, 4095] {
        for (step, phase) in (0..12).zip((-6..6).map(|j| 0.5 * f64::from(j))) {
            let bin = 700.0 + f64::from(step) / 12.0;
            let peaks = peaks_of(&cosine(length, bin, 2.5e-6, phase));
            assert!(
                (peaks[0].phase - phase).abs() < 1e-6,
                "bin {bin}: {}",
                peaks[0].phase
            );
        }
    }
}

proptest! {
    #[test]
    fn parseval(signal in prop::collection::vec(-1.0..1.0f64, 1..400)) {
        let length = signal.len();
        let mean_square = signal.iter().map(|x| x * x).sum::<f64>() / length as f64;
        let transform = Transform::new(signal);
        let power: f64 = (0..transform.bins())
            .map(|k| {
                let square = transform.amplitude(k, Window::Rectangular).powi(2);
                if k == 0 || 2 * k == length { square } else { square / 2.0 }
            })
            .sum();
        prop_assert!((power - mean_square).abs() < 1e-13);
    }

    #[test]
    fn a_line_anywhere_is_found_where_it_is(
        bin in 60.0..400.0f64, phase in -PI..PI, length in 1000..1100usize,
    ) {
        let peaks = peaks_of(&cosine(length, bin, 1.0, phase));
        prop_assert!((peaks[0].frequency - bin).abs() < 1e-4);
        prop_assert!((peaks[0].amplitude - 1.0).abs() < 1e-4);
    }
}

/// A pure line is known far better than to a bin: half a bin beside an order of the shaft it is not that order.
/// Where half orders stand closer than lines are told apart, none is named.
#[test]
fn a_name_asks_for_no_more_than_the_uncertainty_of_a_peak() {
    let lines = lines_of(100.0, &[], &[]);
    let known = Precision {
        resolution: 20.0,
        uncertainty: 1.0,
    };
    let name =
        |frequency| nearest_cause(frequency, known, &lines).map(|line| line.kind.to_string());
    assert_eq!(name(1400.9).as_deref(), Some("14×"));
    assert_eq!(name(1413.0), None);
    assert_eq!(name(1650.0), None);
    assert_eq!(cause(1650.0, 1.0, &lines).as_deref(), Some("33/2×"));
}
