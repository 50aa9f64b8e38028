//! Time of one ball, one ring and one right-hand side, rung by rung: what a scene asks for, and what
//! one that does not ask for it pays.
//!
//! Rungs are a 7205C of 12 balls under thrust, three freedoms and a rolling cage unless they say else.

use std::hint::black_box;
use std::path::Path;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use jeffcott::bearing::{
    Ball, BearingRotation, ContactLaw, Facing, ForceLaw, HertzLaw, MountedBearing, Oil, Preload,
    Ring, catalogue,
};
use jeffcott::integrate::System;
use jeffcott::physics::RaceControl;
use jeffcott::rotor::load::{Harmonic, Pace};
use jeffcott::rotor::{CageMotion, Freedoms, Load, LoadKind, Rotor, RotorDefinition, SpeedPoint};
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
    let law = HertzLaw::new(
        bearing.load_deflection_constant().expect("a Hertz contact"),
        bearing.geometry.groove_centre_distance(),
    );
    let (axial, radial) = (1.35e-4, 3.83e-4);
    criterion.bench_function("ball, hertz: force", |bencher| {
        bencher.iter(|| law.force(&Ball::at(black_box(axial), black_box(radial)), 0.0));
    });
    criterion.bench_function("ball, hertz: force and tangent", |bencher| {
        bencher.iter(|| law.force_and_tangent(black_box(axial), black_box(radial), 0.0));
    });
    let ring = Ring::new(&bearing.geometry, 0.0);
    let place = [1e-7, -2e-7, 32e-6, 1e-6, 2e-6];
    let rotation = BearingRotation::at_start(0.0).with_cage_at(0.3);
    criterion.bench_function("ring of 12, hertz: force", |bencher| {
        bencher.iter(|| ring.force(&law, black_box(&place), black_box(&rotation)));
    });
    criterion.bench_function("ring of 12, hertz: force and stiffness", |bencher| {
        bencher.iter(|| ring.force_and_stiffness(&law, black_box(&place), black_box(&rotation)));
    });
}

/// What a scene may ask for beyond its plainest form.
struct Rung {
    name: &'static str,
    law: ContactLaw,
    film: bool,
    freedoms: Freedoms,
    /// Changes a scene of one bearing, rolling, under constant load at constant speed.
    ask: fn(&mut RotorDefinition),
}

impl Rung {
    fn definition(&self) -> RotorDefinition {
        let mut rotor = model("steady-7205c.toml").rotor;
        rotor.shaft.freedoms = self.freedoms;
        rotor.shaft.inertia_transverse = 0.01;
        rotor.shaft.inertia_polar = 0.004;
        for bearing in &mut rotor.bearings {
            bearing.law = self.law;
            bearing.oil = self.film.then_some(OIL);
        }
        (self.ask)(&mut rotor);
        rotor
    }
}

const OIL: Oil = Oil {
    viscosity: 0.04,
    pressure_viscosity: 2.2e-8,
};
const JONES: ContactLaw = ContactLaw::Jones(RaceControl::Outer);

fn nothing(_: &mut RotorDefinition) {}

fn frozen_cage(rotor: &mut RotorDefinition) {
    rotor.cage = CageMotion::Frozen;
}

fn varying_load(rotor: &mut RotorDefinition) {
    let mut amplitude = [0.0; 5];
    amplitude[0] = 100.0;
    let harmonic = Harmonic {
        amplitude,
        pace: Pace::Frequency(50.0),
        phase: 0.0,
    };
    rotor.loads.push(Load {
        kind: LoadKind::Harmonic(harmonic),
        position: 0.0,
    });
}

/// Changes the speed for longer than any bench runs, and hardly: the balls bear what they bore.
fn run_up(rotor: &mut RotorDefinition) {
    rotor.speed_points.push(SpeedPoint {
        time: 1e6,
        speed: 1.001 * rotor.speed,
    });
}

fn pair(rotor: &mut RotorDefinition) {
    let one = rotor.bearings[0];
    rotor.bearings = [(-0.03, Facing::PlusZ), (0.03, Facing::MinusZ)]
        .map(|(position, facing)| MountedBearing {
            position,
            facing,
            preload: Preload::Force(200.0),
            ..one
        })
        .to_vec();
}

/// The ladder of laws; then, from the Hertz law with three freedoms on, one wish at a time.
const RUNGS: [Rung; 15] = {
    use ContactLaw::{Hertz, Linear};
    use Freedoms::{All, Radial, Translational};
    const fn rung(
        name: &'static str,
        law: ContactLaw,
        film: bool,
        freedoms: Freedoms,
        ask: fn(&mut RotorDefinition),
    ) -> Rung {
        Rung {
            name,
            law,
            film,
            freedoms,
            ask,
        }
    }
    [
        rung("linear", Linear, false, Translational, nothing),
        rung("hertz", Hertz, false, Translational, nothing),
        rung("hertz, film", Hertz, true, Translational, nothing),
        rung("jones", JONES, false, Translational, nothing),
        rung("jones, film", JONES, true, Translational, nothing),
        rung("hertz, 2 freedoms", Hertz, false, Radial, nothing),
        rung("hertz, 5 freedoms", Hertz, false, All, nothing),
        rung("jones, film, 5 freedoms", JONES, true, All, nothing),
        rung(
            "hertz, frozen cage",
            Hertz,
            false,
            Translational,
            frozen_cage,
        ),
        rung(
            "hertz, one varying load",
            Hertz,
            false,
            Translational,
            varying_load,
        ),
        rung("hertz, run-up", Hertz, false, Translational, run_up),
        rung("hertz, film, run-up", Hertz, true, Translational, run_up),
        rung("jones, film, run-up", JONES, true, Translational, run_up),
        rung("hertz, 5 freedoms, pair", Hertz, false, All, pair),
        rung("jones, film, 5 freedoms, pair", JONES, true, All, pair),
    ]
};

/// Benches one right-hand side at a state near equilibrium, at a new time in every call.
fn right_hand_side(criterion: &mut Criterion, name: &str, rotor: &Rotor) {
    let active = rotor.active_freedoms();
    let mut state = rotor.equilibrium().displacement[..active].to_vec();
    state.resize(2 * active, 1e-4);
    let (mut time, mut rate) = (0.0, state.clone());
    criterion.bench_function(&format!("right-hand side: {name}"), |bencher| {
        bencher.iter(|| {
            time += 1e-5;
            rotor.derivative(black_box(time), black_box(&state), &mut rate);
            // where it stands: handing it on would wait for all that was just written
            black_box(&rate);
        });
    });
}

/// Costly laws as tables: the rungs whose names they bear.
fn tabulated(criterion: &mut Criterion) {
    for rung in RUNGS {
        let mut rotor = Rotor::assemble(&rung.definition()).expect("a rotor");
        let tables = rotor.tabulate();
        if tables.iter().flatten().all(Result::is_err) {
            continue;
        }
        let name = format!("{}, table", rung.name);
        right_hand_side(criterion, &name, &rotor);
        criterion.bench_function(&format!("compile: {}", rung.name), |bencher| {
            bencher.iter_batched(
                || Rotor::assemble(&rung.definition()).expect("a rotor"),
                |mut rotor| rotor.tabulate(),
                BatchSize::PerIteration,
            );
        });
    }
}

fn right_hand_sides(criterion: &mut Criterion) {
    for rung in RUNGS {
        let rotor = Rotor::assemble(&rung.definition()).expect("a rotor");
        right_hand_side(criterion, rung.name, &rotor);
    }
}

criterion_group!(benches, ball_and_ring, right_hand_sides, tabulated);
criterion_main!(benches);
