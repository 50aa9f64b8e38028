//! `method = "auto"`, the default: the method that costs least, chosen and chosen again during the run.

use std::path::Path;

use jeffcott::integrate::{Method, MethodUse};
use jeffcott::scenario::{self, methods};
use jeffcott::simulate::{Model, Run};

use super::{read, text};
use crate::support::try_run;

/// A scene without a second pass.
fn model(scene: &str) -> Model {
    let mut model = read(scene).model.unwrap();
    model.verify = false;
    model
}

/// A scene of half a second that names no method.
fn open(speed: &str, changes: &[(&str, &str)]) -> Model {
    let mut scene = text(speed, "contact = \"hertz\"", "").replace("0.03 s", "0.5 s");
    for (from, to) in changes {
        assert!(scene.contains(from), "{from}");
        scene = scene.replace(from, to);
    }
    model(&scene)
}

fn run(model: &Model) -> (Run, MethodUse) {
    let run = try_run(model, 0.0).0.unwrap();
    let used = run.method_use.clone().unwrap();
    println!("{:?} {used:?}", run.counters);
    (run, used)
}

/// Evaluations by a method of a model that names none.
fn evaluations(model: &Model, method: Method) -> u64 {
    let mut model = model.clone();
    model.integrator.method = method;
    try_run(&model, 0.0).0.unwrap().counters.evaluations
}

fn main_method(used: &MethodUse) -> Method {
    used.main().unwrap().method
}

#[test]
fn a_shaft_that_turns_slowly_under_load_steps_with_its_forcing() {
    let model = open("100 rad/s", &[]);
    assert_eq!(model.integrator.method, Method::Auto);
    let (chosen, used) = run(&model);
    assert_eq!(main_method(&used), Method::Exponential);
    let [explicit, exponential] =
        [Method::Verner76, Method::Exponential].map(|method| evaluations(&model, method));
    let all = chosen.counters.evaluations;
    assert!(5 * all < explicit, "{all} against {explicit}");
    // an evaluation of an explicit pair costs less than half of one of the exponential method
    let own = used.main().unwrap().counters.evaluations;
    let cost = own + (all - own) / 2;
    assert!(5 * cost < 6 * exponential, "{cost} against {exponential}");
}

#[test]
fn balls_that_unload_at_every_turn_are_left_to_the_explicit_methods() {
    let model = open("1000 rad/s", &[("5 um", "50 um"), ("1000 N", "50 N")]);
    let (chosen, used) = run(&model);
    assert_ne!(main_method(&used), Method::Exponential);
    let explicit = evaluations(&model, Method::Verner76);
    let chosen = chosen.counters.evaluations;
    assert!(10 * chosen < 11 * explicit, "{chosen} against {explicit}");
}

#[test]
fn stiff_contact_damping_is_not_left_to_an_explicit_method() {
    let damping = "ratio = 0.02\ncontact = { inner = \"5000 s/m\", outer = \"5000 s/m\" }\n";
    let changes = [("ratio = 0.02\n", damping), ("0.5 s", "0.05 s")];
    let (_, used) = run(&open("1000 rad/s", &changes));
    assert_eq!(main_method(&used), Method::Exponential);
}

/// A hard scene of the benches at a tolerance of 1e-6.
fn hard(name: &str) -> Model {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/scenes/hard");
    let file = folder.join(name).with_extension("toml");
    let mut model = scenario::load(&file).unwrap().model.unwrap();
    (model.verify, model.integrator.tolerance) = (false, 1e-6);
    model
}

/// Where modes decay fast an explicit pair pays for them however exact it is, and without damping the start
/// never dies: both are known before the first step, and no trial of a pair spoils the run.
#[test]
fn strong_damping_and_none_are_left_to_the_exponential_method_from_the_first_step_on() {
    for name in [
        "overdamped",
        "stiff-damper",
        "stiff-contact-damping",
        "undamped",
    ] {
        let model = hard(name);
        let (run, used) = run(&model);
        assert_eq!(used.changes.len(), 1, "{name}: {:?}", used.changes);
        assert_eq!(
            run.counters.evaluations,
            evaluations(&model, Method::Exponential),
            "{name}"
        );
    }
}

/// What a blow does is known before the first step: the exponential method, cheap before it and after, does not go
/// through it.
#[test]
fn blows_that_lift_balls_off_are_left_to_the_nystrom_pair_from_the_first_step_on() {
    for name in ["impact-short", "impact-slow"] {
        let model = hard(name);
        let (run, used) = run(&model);
        assert_eq!(used.changes[0].method, Method::Dprkn8, "{name}");
        let all = run.counters.evaluations;
        let pair = evaluations(&model, Method::Dprkn8);
        assert!(20 * all < 21 * pair, "{name}: {all} against {pair}");
    }
}

/// The first turns of a start are unlike all that follows: a method that is dear there is tried again.
#[test]
fn a_start_by_a_motor_ends_with_the_exponential_method() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/drive-start-7205c.toml");
    let mut model = scenario::load(&file).unwrap().model.unwrap();
    (model.verify, model.integrator.tolerance) = (false, 1e-6);
    let (run, used) = run(&model);
    assert_eq!(used.changes.last().unwrap().method, Method::Exponential);
    let [all, exponential] = [
        run.counters.evaluations,
        evaluations(&model, Method::Exponential),
    ];
    assert!(4 * all < 5 * exponential, "{all} against {exponential}");
}

/// A start through all speeds under a light load.
#[test]
fn stretches_of_the_methods_make_up_the_run() {
    let start = "from = \"0 rad/s\"\nto = \"1500 rad/s\"\nover = \"0.5 s\"";
    let changes = [
        ("constant = \"1 rad/s\"", start),
        ("5 um", "50 um"),
        ("1000 N", "100 N"),
    ];
    let (run, used) = run(&open("1 rad/s", &changes));
    let stretches = &used.stretches;
    let covered: f64 = stretches.iter().map(|stretch| stretch.covered).sum();
    // the last step may reach beyond the last sample
    assert!((covered - 0.5).abs() < 0.01, "{covered}");
    let work = stretches.iter().map(|stretch| stretch.counters.evaluations);
    assert_eq!(work.sum::<u64>(), run.counters.evaluations);
    assert!(used.changes.len() > 1, "{:?}", used.changes);
    assert!(
        used.changes
            .windows(2)
            .all(|pair| pair[1].time > pair[0].time)
    );
    let known = |method: Method| stretches.iter().any(|one| one.method == method);
    assert!(used.changes.iter().all(|change| known(change.method)));
}

#[test]
fn the_same_scene_takes_the_same_steps_and_a_named_method_is_kept() {
    let scene = open("300 rad/s", &[]);
    let [first, second] = [0, 1].map(|_| try_run(&scene, 0.0));
    assert_eq!(first.0.unwrap(), second.0.unwrap());
    assert_eq!(first.1, second.1);
    let named = "[integrator]\nmethod = \"dop853\"\n";
    let named = model(&text("1000 rad/s", "contact = \"hertz\"", named));
    assert_eq!(named.integrator.method, Method::Dop853);
    assert!(try_run(&named, 0.0).0.unwrap().method_use.is_none());
    assert!(methods().iter().any(|known| known.method == Method::Auto));
}
