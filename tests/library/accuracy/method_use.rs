//! `method = "auto"`, the default: the exponential method, until balls that part from a race keep its steps short.

use std::path::Path;

use crate::integrate::{ChangeReason, Method, MethodUse};
use crate::scenario::{self, methods};
use crate::simulate::{BearingHistory, EventKind, Model, Run};

use super::{read, text};
use crate::tests::support::try_run;

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
    let used = run.method_use.unwrap();
    println!("{:?} {used:?}", run.counters);
    (run, used)
}

/// Evaluations by a method of a model that names none.
fn evaluations(model: &Model, method: Method) -> u64 {
    let mut model = model.clone();
    model.integrator.method = method;
    try_run(&model, 0.0).0.unwrap().counters.evaluations
}

#[test]
fn a_shaft_that_turns_slowly_under_load_steps_with_its_forcing() {
    let model = open("100 rad/s", &[]);
    assert_eq!(model.integrator.method, Method::Auto);
    let (chosen, used) = run(&model);
    assert_eq!(used.change, None);
    let [explicit, exponential] =
        [Method::Verner76, Method::Exponential].map(|method| evaluations(&model, method));
    let all = chosen.counters.evaluations;
    assert!(5 * all < explicit, "{all} against {explicit}");
    assert_eq!(all, exponential);
}

/// A shipped scene, or one of the benches, without a second pass.
fn scene(file: &str) -> Model {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let mut model = scenario::load(&file).unwrap().model.unwrap();
    model.verify = false;
    model
}

/// Times at which balls of any bearing parted from a race.
fn partings(run: &Run) -> u64 {
    let lost = |bearing: &BearingHistory| bearing.events(EventKind::ContactLost).count;
    run.bearings.iter().map(lost).sum()
}

/// One of them passes a resonance between two speeds at which the shaft hardly moves.
#[test]
fn a_motion_that_did_not_come_ends_no_exponential_method() {
    for (file, most) in [
        ("benches/scenes/thirteen-balls-preloaded.toml", 6_000),
        ("scenarios/laval-rotor.toml", 25_000),
    ] {
        let (chosen, used) = run(&scene(file));
        assert_eq!(used.change, None, "{file}");
        assert_eq!(partings(&chosen), 0, "{file}");
        assert!(chosen.counters.evaluations < most, "{file}");
    }
}

/// The elastic modes of a shaft are so fast that a pair held by its stability takes far shorter steps.
#[test]
fn balls_that_part_under_a_bent_shaft_keep_the_method() {
    let mut model = scene("scenarios/conveyor-shaft-6213.toml");
    (model.duration, model.settle) = (0.1, 0.0);
    let (chosen, used) = run(&model);
    assert!(partings(&chosen) > 0);
    assert_eq!(used.change, None);
    let explicit = evaluations(&model, Method::Verner76);
    let all = chosen.counters.evaluations;
    assert!(3 * all < explicit, "{all} against {explicit}");
}

/// The finer the tolerance, the more short steps a ball that parts takes; long ones in between make up for them.
#[test]
fn a_few_balls_that_part_do_not_end_the_long_steps() {
    let mut model = scene("scenarios/overhung-rotor-6208.toml");
    (model.duration, model.settle) = (0.1, 0.0);
    model.integrator.tolerance = 1e-9;
    let (chosen, used) = run(&model);
    assert!(partings(&chosen) > 0);
    assert_eq!(used.change, None);
}

#[test]
fn balls_that_unload_each_turn_are_left_to_the_pair_that_lands() {
    let model = open("1000 rad/s", &[("5 um", "50 um"), ("1000 N", "50 N")]);
    let (chosen, used) = run(&model);
    let (reason, time) = used.change.expect("a change");
    assert_eq!(reason, ChangeReason::Crossings);
    assert!(time < 0.02 * model.duration, "{time}");
    let (all, explicit) = (
        chosen.counters.evaluations,
        evaluations(&model, Method::Verner76),
    );
    assert!(20 * all < 21 * explicit, "{all} against {explicit}");
}

/// With ball inertia, too, in the clearance of a deep groove bearing, and at rest.
#[test]
fn the_rule_knows_every_law() {
    let light = [("5 um", "50 um"), ("1000 N", "50 N"), ("0.5 s", "0.02 s")];
    let jones = [&light[..], &[("\"hertz\"", "\"jones\"")]].concat();
    let latest = |changes: &[(&str, &str)]| run(&open("1000 rad/s", changes)).1.latest();
    assert_eq!(latest(&jones), Method::Verner76);
    assert_eq!(latest(&[jones[2], jones[3]]), Method::Exponential);
    for (name, expected) in [
        ("impact-with-clearance", Method::Verner76),
        ("clearance-zero", Method::Verner76),
        ("heavy-shaft", Method::Verner76),
        ("undamped", Method::Exponential),
        ("tilts-fast", Method::Exponential),
        ("coast-down-on-films", Method::Exponential),
    ] {
        let mut model = hard(name);
        model.duration = model.duration.min(0.1);
        assert_eq!(run(&model).1.latest(), expected, "{name}");
    }
}

/// Two deep groove bearings in their clearance, where three to four of nine balls bear.
#[test]
fn balls_that_leave_the_load_zone_part_again_and_again() {
    let bearing = |position: &str| {
        format!(
            "[[bearing]]\ncatalogue = \"6205\"\nposition = \"{position}\"\n\
             [bearing.geometry]\ndiametral_clearance = \"10 um\"\n"
        )
    };
    let pair = format!(
        "[shaft]\nmass = \"8 kg\"\neccentricity = \"2.5 um\"\nfreedoms = \"all\"\n\
         inertia_transverse = \"0.02 kg m^2\"\ninertia_polar = \"0.008 kg m^2\"\ngravity = true\n\
         [speed]\nconstant = \"1480 rpm\"\n{}{}[damping]\nratio = 0.03\n\
         [[load]]\nconstant = {{ y = \"-300 N\" }}\n[time]\nduration = \"0.042 s\"\n",
        bearing("-60 mm"),
        bearing("60 mm")
    );
    let (chosen, used) = run(&model(&pair));
    assert!(partings(&chosen) > 0);
    assert_eq!(used.latest(), Method::Verner76);
}

#[test]
fn stiff_contact_damping_is_not_left_to_an_explicit_method() {
    let damping = "ratio = 0.02\ncontact = { inner = \"5000 s/m\", outer = \"5000 s/m\" }\n";
    let changes = [("ratio = 0.02\n", damping), ("0.5 s", "0.05 s")];
    let (_, used) = run(&open("1000 rad/s", &changes));
    assert_eq!(used.change, None);
}

/// A hard scene of the benches at a tolerance of 1e-6.
fn hard(name: &str) -> Model {
    let mut model = scene(&format!("benches/scenes/hard/{name}.toml"));
    model.integrator.tolerance = 1e-6;
    model
}

/// A run-up through the resonance of a light thrust: nothing of it is known at either of its ends, where no ball is
/// expected to part.
#[test]
fn balls_that_part_often_are_left_to_the_pair_that_lands() {
    let start = "from = \"3500 rad/s\"\nto = \"7500 rad/s\"\nover = \"0.5 s\"";
    let changes = [
        ("constant = \"1 rad/s\"", start),
        ("y = \"-300 N\", z = \"1000 N\"", "z = \"200 N\""),
        ("5 um", "0.5 um"),
        ("ratio = 0.02", "ratio = 0.005"),
    ];
    let mut model = open("1 rad/s", &changes);
    model.integrator.tolerance = 1e-6;
    let (chosen, used) = run(&model);
    let (reason, time) = used.change.expect("a change");
    assert_eq!(reason, ChangeReason::Crossings);
    assert!((0.05..0.2).contains(&time), "{time}");
    assert_eq!(used.latest(), Method::Verner76);
    let exponential = evaluations(&model, Method::Exponential);
    let chosen = chosen.counters.evaluations;
    assert!(3 * chosen < 2 * exponential, "{chosen} of {exponential}");
}

#[test]
fn equal_scenes_take_equal_steps_and_a_named_method_is_kept() {
    let scene = open("300 rad/s", &[]);
    let [first, second] = [0, 1].map(|_| try_run(&scene, 0.0));
    assert_eq!(first.0.unwrap(), second.0.unwrap());
    assert_eq!(first.1, second.1);
    let named = "[integrator]\nmethod = \"dop853\"\n";
    let named = model(&text("1000 rad/s", "contact = \"hertz\"", named));
    assert_eq!(named.integrator.method, Method::Dop853);
    assert!(try_run(&named, 0.0).0.unwrap().method_use.is_none());
    assert!(methods().contains(&Method::Auto));
}
