//! Cost of the law of one ball from a cold start, over positions from light to deep contact.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use jeffcott::bearing::{Bearing, Oil};
use jeffcott::internals::{Ball, BallLaw, HertzFilmLaw, JonesFilmLaw, JonesLaw};
use jeffcott::physics::RaceControl;

const SPEED: f64 = 1000.0;

fn ball_laws(criterion: &mut Criterion) {
    let bearing = Bearing::catalogue("7205C").unwrap();
    let oil = Oil {
        viscosity: 0.04,
        pressure_viscosity: 2.2e-8,
    };
    let geometry = &bearing.geometry;
    let positions: Vec<(f64, f64)> = (0..64)
        .map(|step| {
            let part = f64::from(step) / 63.0;
            let axial = geometry.free_axial() + 40e-6 * part;
            // golden-section scatter of the radial displacement in ±10 µm
            let radial = geometry.free_radial() + 20e-6 * ((f64::from(step) * 0.618).fract() - 0.5);
            (axial, radial)
        })
        .collect();
    let hertz_film = HertzFilmLaw::with_film(&bearing, oil, SPEED).unwrap();
    let jones = JonesLaw::new(&bearing, RaceControl::Outer).unwrap();
    let jones_film = JonesFilmLaw::with_film(&bearing, RaceControl::Outer, oil, SPEED).unwrap();
    bench(criterion, "hertz film", &hertz_film, &positions);
    bench(criterion, "jones", &jones, &positions);
    bench(criterion, "jones film", &jones_film, &positions);
}

/// Time for all 64 positions: divide by 64 for one ball.
fn bench(criterion: &mut Criterion, name: &str, law: &impl BallLaw, positions: &[(f64, f64)]) {
    let mut group = criterion.benchmark_group(name);
    group.throughput(criterion::Throughput::Elements(positions.len() as u64));
    group.bench_function("force", |bencher| {
        bencher.iter(|| {
            for &(axial, radial) in positions {
                black_box(law.force(&Ball::at(black_box(axial), radial), SPEED));
            }
        });
    });
    group.bench_function("force and tangent", |bencher| {
        bencher.iter(|| {
            for &(axial, radial) in positions {
                black_box(law.force_and_tangent(black_box(axial), radial, SPEED));
            }
        });
    });
    group.finish();
}

criterion_group!(benches, ball_laws);
criterion_main!(benches);
