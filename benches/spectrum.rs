//! Time from a recorded trace to spectra and named peaks.

use std::f64::consts::TAU;
use std::hint::black_box;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use jeffcott::analysis::{BearingFrequencies, Recorder, Sources, Window, causes};
use jeffcott::physics::ball_pass_frequencies;
use jeffcott::rotor::Sample;

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
        velocity: [0.0; 5],
        force_on_shaft: [motion; 5],
        largest_ball_load: 0.0,
        balls_loaded: 0,
        energy: None,
        drive: None,
    }
}

fn recorded() -> Recorder {
    let mut recorder = Recorder::on_angle_grid(3, 0.0, 1.0, PER_REVOLUTION);
    for n in 0..PER_REVOLUTION * REVOLUTIONS {
        recorder.record(&sample(n));
    }
    recorder
}

fn spectrum(criterion: &mut Criterion) {
    let recorder = recorded();
    let pass = ball_pass_frequencies(TAU, 12, 1.0, 5.0, 0.2);
    let lines = causes(&Sources {
        shaft: 1.0,
        bearings: vec![BearingFrequencies {
            simulated: pass,
            operating: pass,
        }],
        ..Sources::default()
    });
    criterion.bench_function("spectra and peaks, 1e5 samples, 6 channels", |bencher| {
        bencher.iter_batched(
            || recorder.clone(),
            |recorder| black_box(recorder.finish(Window::Rectangular, &lines)),
            BatchSize::LargeInput,
        );
    });
}

criterion_group!(benches, spectrum);
criterion_main!(benches);
