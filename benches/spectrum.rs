//! Time from a recorded trace to spectra and named peaks.

use std::f64::consts::TAU;
use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use jeffcott::analysis::{Channel, Window};
use jeffcott::internals::{
    Axis, BearingFrequencies, Detrend, Freedoms, Scaling, Segment, Sources, SpectrumKind,
    SpectrumRequest, causes,
};
use jeffcott::internals::{Recording, SampleGrid, estimate};
use jeffcott::physics::ball_pass_frequencies;
use jeffcott::simulate::Sample;

/// Samples a revolution, and revolutions: about 1e5 samples of six channels.
const PER_REVOLUTION: u32 = 128;
const REVOLUTIONS: u32 = 781;

fn sample(n: u32) -> Sample {
    let angle = TAU * f64::from(n) / f64::from(PER_REVOLUTION);
    let motion = angle.cos() + 0.03 * (4.8 * angle).cos();
    Sample {
        time: angle / TAU,
        angle,
        speed: TAU,
        displacement: [motion; 5],
        acceleration: Some([0.0; 5]),
        force_on_shaft: Some([motion; 5]),
        ..Sample::default()
    }
}

fn recorded(freedoms: Freedoms, revolutions: u32) -> Recording {
    let mut recording = Recording::new(SampleGrid::of_angle(1.0, PER_REVOLUTION), 0.0)
        .with(Channel::of_freedoms(freedoms));
    for n in 0..PER_REVOLUTION * revolutions {
        recording.record(&sample(n));
    }
    recording
}

fn spectrum(criterion: &mut Criterion) {
    let recording = recorded(Freedoms::Translational, REVOLUTIONS);
    let channels = Channel::of_freedoms(Freedoms::Translational);
    let pass = ball_pass_frequencies(TAU, 12, 1.0, 5.0, 0.2);
    let lines = causes(&Sources {
        shaft: 1.0,
        bearings: vec![BearingFrequencies {
            simulated: pass,
            nominal: pass,
        }],
        ..Sources::default()
    });
    criterion.bench_function("spectra and peaks, 1e5 samples, 6 channels", |bencher| {
        bencher.iter(|| black_box(recording.spectrum(&channels, Window::Rectangular, &lines)));
    });
}

/// Spectra of a long run of five freedoms: 1e6 samples of ten channels.
fn long_spectrum(criterion: &mut Criterion) {
    let recording = recorded(Freedoms::All, 10 * REVOLUTIONS);
    let channels = Channel::of_freedoms(Freedoms::All);
    let pass = ball_pass_frequencies(TAU, 12, 1.0, 5.0, 0.2);
    let lines = causes(&Sources {
        shaft: 1.0,
        bearings: vec![BearingFrequencies {
            simulated: pass,
            nominal: pass,
        }],
        ..Sources::default()
    });
    let mut group = criterion.benchmark_group("1e6 samples, 10 channels");
    group.sample_size(10);
    group.bench_function("spectra and peaks", |bencher| {
        bencher.iter(|| black_box(recording.spectrum(&channels, Window::Rectangular, &lines)));
    });
    for (name, segment, scaling) in [
        ("one segment, peak", Segment::Whole, Scaling::Peak),
        (
            "Welch, 64 revolutions",
            Segment::Revolutions(64),
            Scaling::Density,
        ),
    ] {
        let request = request(segment, scaling, Axis::Frequency);
        let recording = recorded_for(&request, Some(PER_REVOLUTION));
        group.bench_function(name, |bencher| {
            bencher.iter(|| black_box(estimate(&recording, &request)));
        });
    }
    let request = request(Segment::Revolutions(64), Scaling::Peak, Axis::Order);
    let recording = recorded_for(&request, None);
    group.bench_function("resampled to angles, Welch", |bencher| {
        bencher.iter(|| black_box(estimate(&recording, &request)));
    });
    group.finish();
}

fn request(segment: Segment, scaling: Scaling, axis: Axis) -> SpectrumRequest {
    SpectrumRequest {
        name: "bench".to_owned(),
        kind: SpectrumKind::Plain,
        channels: Channel::of_freedoms(Freedoms::All),
        scaling,
        window: Window::Hann,
        segment,
        overlap: 0.5,
        detrend: Detrend::Constant,
        axis,
    }
}

fn recorded_for(request: &SpectrumRequest, per_revolution: Option<u32>) -> Recording {
    let grid = SampleGrid {
        rate: f64::from(PER_REVOLUTION),
        shaft_frequency: 1.0,
        per_revolution,
    };
    let mut recording = Recording::new(grid, 0.0).with_requests(std::slice::from_ref(request));
    for n in 0..10 * PER_REVOLUTION * REVOLUTIONS {
        recording.record(&sample(n));
    }
    recording
}

criterion_group!(benches, spectrum, long_spectrum);
criterion_main!(benches);
