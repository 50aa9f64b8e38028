//! Time of one ball, one ring and one right-hand side, rung by rung.

use std::hint::black_box;
use std::path::Path;

use criterion::{Criterion, criterion_group, criterion_main};
use jeffcott::bearing::{BallLaw, CageAngle, HertzLaw, Ring, catalogue};
use jeffcott::integrate::System;
use jeffcott::rotor::{Freedoms, Rotor};
use jeffcott::scenario;
use jeffcott::simulate::Model;

/// A shipped scenario.
fn model(name: &str) -> Model {
    let file = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("scenarios")
        .join(name);
    scenario::load(&file)
        .expect("a shipped scenario")
        .model
        .expect("a motion")
}

fn ball_and_ring(criterion: &mut Criterion) {
    let bearing = catalogue::find("7205C")
        .expect("in the catalogue")
        .bearing()
        .expect("a bearing");
    let law = HertzLaw {
        load_deflection_constant: bearing.load_deflection_constant().expect("a Hertz contact"),
        distance: bearing.geometry.groove_centre_distance(),
    };
    let (axial, radial) = (1.35e-4, 3.83e-4);
    criterion.bench_function("ball, hertz: force", |bencher| {
        bencher.iter(|| law.force(black_box(axial), black_box(radial), 0.0));
    });
    criterion.bench_function("ball, hertz: force and tangent", |bencher| {
        bencher.iter(|| law.force_and_tangent(black_box(axial), black_box(radial), 0.0));
    });
    let ring = Ring::new(&bearing.geometry, 0.0, law);
    let (place, cage) = ([1e-7, -2e-7, 32e-6, 1e-6, 2e-6], CageAngle::new(0.3));
    criterion.bench_function("ring of 12, hertz: force", |bencher| {
        bencher.iter(|| ring.force(black_box(&place), black_box(cage), 0.0));
    });
    criterion.bench_function("ring of 12, hertz: force and stiffness", |bencher| {
        bencher.iter(|| ring.force_and_stiffness(black_box(&place), black_box(cage), 0.0));
    });
}

/// Benches one right-hand side at a state near equilibrium, at a new time in every call.
fn right_hand_side<const N: usize>(criterion: &mut Criterion, name: &str, model: &Model) {
    let rotor = Rotor::assemble(&model.rotor).expect("a rotor");
    let place = rotor.equilibrium().displacement;
    let state: [f64; N] = std::array::from_fn(|i| if i < N / 2 { place[i] } else { 1e-4 });
    let mut time = 0.0;
    criterion.bench_function(name, |bencher| {
        let mut rate = [0.0; N];
        bencher.iter(|| {
            time += 1e-5;
            System::<N>::derivative(&rotor, black_box(time), black_box(&state), &mut rate);
            rate
        });
    });
}

fn right_hand_sides(criterion: &mut Criterion) {
    let three = model("steady-7205c.toml");
    right_hand_side::<6>(
        criterion,
        "right-hand side: 12 balls, hertz, 3 freedoms",
        &three,
    );
    right_hand_side::<6>(
        criterion,
        "right-hand side: linear, 3 freedoms",
        &model("linear-7205c.toml"),
    );
    let mut radial = three.clone();
    radial.rotor.shaft.freedoms = Freedoms::Radial;
    right_hand_side::<4>(
        criterion,
        "right-hand side: 12 balls, hertz, 2 freedoms",
        &radial,
    );
    let mut all = three;
    all.rotor.shaft.freedoms = Freedoms::All;
    all.rotor.shaft.inertia_transverse = 0.01;
    all.rotor.shaft.inertia_polar = 0.004;
    right_hand_side::<10>(
        criterion,
        "right-hand side: 12 balls, hertz, 5 freedoms",
        &all,
    );
    let pair = model("back-to-back-7205c.toml");
    right_hand_side::<10>(
        criterion,
        "right-hand side: pair of 12 balls, hertz, 5 freedoms",
        &pair,
    );
}

criterion_group!(benches, ball_and_ring, right_hand_sides);
criterion_main!(benches);
