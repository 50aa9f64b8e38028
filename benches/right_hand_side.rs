//! Time of one ball, one ring and one right-hand side, rung by rung: what a scene asks for, and what
//! one that does not ask for it pays.
//!
//! Rungs are a 7205C of 12 balls under thrust, three freedoms and a rolling cage unless they say else.

use std::hint::black_box;
use std::path::Path;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use jeffcott::bearing::Bearing;
use jeffcott::internals::{
    Ball, BareRun, BearingRotation, ForceLaw, HertzLaw, Ring, Rotor, System,
};
use jeffcott::scenario::{self, Format};
use serde_json::{Value, json};

fn ball_and_ring(criterion: &mut Criterion) {
    let bearing = Bearing::catalogue("7205C").expect("in the catalogue");
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
    contact: &'static str,
    film: bool,
    freedoms: &'static str,
    /// Changes a scene of one bearing, rolling, under constant load at constant speed.
    ask: fn(&mut Value),
}

impl Rung {
    fn scene(&self) -> Value {
        let scenarios = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios");
        let steady = scenario::load(&scenarios.join("steady-7205c.toml"));
        let mut scene = steady.expect("a shipped scenario").echo;
        scene["shaft"]["freedoms"] = self.freedoms.into();
        if self.freedoms == "all" {
            scene["shaft"]["inertia_transverse"] = "0.01 kg m^2".into();
            scene["shaft"]["inertia_polar"] = "0.004 kg m^2".into();
        }
        scene["model"]["contact"] = self.contact.into();
        if self.film {
            scene["model"]["film"] = true.into();
            scene["bearing"][0]["oil"] = json!({
                "viscosity": "0.04 Pa s",
                "pressure_viscosity": "2.2e-8 1/Pa",
            });
        }
        (self.ask)(&mut scene);
        scene
    }

    fn rotor(&self) -> Rotor {
        let scene = scenario::parse(&self.scene().to_string(), self.name, Format::Json);
        let model = scene.expect("a scenario").model.expect("a motion");
        BareRun::new(&model).expect("a rotor").rotor().clone()
    }
}

fn nothing(_: &mut Value) {}

fn frozen_cage(scene: &mut Value) {
    scene["model"]["cage"] = "frozen".into();
}

fn varying_load(scene: &mut Value) {
    let harmonic = json!({ "amplitude": { "x": "100 N" }, "frequency": "50 Hz" });
    if let Value::Array(loads) = &mut scene["load"] {
        loads.push(json!({ "harmonic": harmonic }));
    }
}

/// Changes the speed for longer than any bench runs, and hardly: the balls bear what they bore.
fn run_up(scene: &mut Value) {
    scene["speed"] = json!({ "from": "500 rad/s", "to": "500.5 rad/s", "over": "1e6 s" });
}

fn pair(scene: &mut Value) {
    let one = scene["bearing"][0].clone();
    scene["bearing"] = [("-30 mm", "+z"), ("30 mm", "-z")]
        .map(|(position, facing)| {
            let mut bearing = one.clone();
            bearing["position"] = position.into();
            bearing["facing"] = facing.into();
            bearing["preload"] = "200 N".into();
            bearing
        })
        .to_vec()
        .into();
}

/// The ladder of laws; then, from the Hertz law with three freedoms on, one wish at a time.
const RUNGS: [Rung; 15] = {
    const fn rung(
        name: &'static str,
        contact: &'static str,
        film: bool,
        freedoms: &'static str,
        ask: fn(&mut Value),
    ) -> Rung {
        Rung {
            name,
            contact,
            film,
            freedoms,
            ask,
        }
    }
    [
        rung("linear", "linear", false, "translational", nothing),
        rung("hertz", "hertz", false, "translational", nothing),
        rung("hertz, film", "hertz", true, "translational", nothing),
        rung("jones", "jones", false, "translational", nothing),
        rung("jones, film", "jones", true, "translational", nothing),
        rung("hertz, 2 freedoms", "hertz", false, "radial", nothing),
        rung("hertz, 5 freedoms", "hertz", false, "all", nothing),
        rung("jones, film, 5 freedoms", "jones", true, "all", nothing),
        rung(
            "hertz, frozen cage",
            "hertz",
            false,
            "translational",
            frozen_cage,
        ),
        rung(
            "hertz, one varying load",
            "hertz",
            false,
            "translational",
            varying_load,
        ),
        rung("hertz, run-up", "hertz", false, "translational", run_up),
        rung(
            "hertz, film, run-up",
            "hertz",
            true,
            "translational",
            run_up,
        ),
        rung(
            "jones, film, run-up",
            "jones",
            true,
            "translational",
            run_up,
        ),
        rung("hertz, 5 freedoms, pair", "hertz", false, "all", pair),
        rung("jones, film, 5 freedoms, pair", "jones", true, "all", pair),
    ]
};

/// Benches one right-hand side at a state near equilibrium, at a new time in every call.
fn right_hand_side(criterion: &mut Criterion, name: &str, rotor: &Rotor) {
    let active = rotor.freedoms().axes().len();
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
        let mut rotor = rung.rotor();
        let tables = rotor.tabulate();
        if tables.iter().flatten().all(Result::is_err) {
            continue;
        }
        let name = format!("{}, table", rung.name);
        right_hand_side(criterion, &name, &rotor);
        criterion.bench_function(&format!("compile: {}", rung.name), |bencher| {
            bencher.iter_batched(
                || rung.rotor(),
                |mut rotor| rotor.tabulate(),
                BatchSize::PerIteration,
            );
        });
    }
}

fn right_hand_sides(criterion: &mut Criterion) {
    for rung in RUNGS {
        let rotor = rung.rotor();
        right_hand_side(criterion, rung.name, &rotor);
    }
}

criterion_group!(benches, ball_and_ring, right_hand_sides, tabulated);
criterion_main!(benches);
