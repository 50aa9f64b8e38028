//! The tolerance is a promise: the true error of a run stays within ten tolerances of its motion, or the
//! run warns.
//!
//! True is what another method says at a tolerance that is tighter by far, not what the run's own second
//! pass says.

use std::fs;
use std::path::{Path, PathBuf};

use crate::integrate::Method;
use crate::rotor::Sample;
use crate::scenario;
use crate::simulate::{Model, Run};

use super::{read, text};
use crate::tests::support::try_run;

/// Simulated time that every method is looked at over, s.
const DURATION: f64 = 0.1;
/// Tolerance of what counts as true beside a file's own tolerance.
const TRUTH: f64 = 1e-13;

fn shipped() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios");
    let entries = fs::read_dir(folder).unwrap();
    let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| {
        path.extension()
            .is_some_and(|extension| extension == "toml")
    });
    files.sort();
    files
}

/// Largest distance of two traces over the active freedoms, tilts by an arm of 20 mm, m.
pub(super) fn apart(model: &Model, left: &[Sample], right: &[Sample]) -> f64 {
    assert_eq!(left.len(), right.len());
    let active = model.rotor.shaft.freedoms.axes();
    let distance = |(a, b): (&Sample, &Sample)| {
        let of = |axis: usize| {
            let arm = if axis < 3 { 1.0 } else { 0.02 };
            arm * (a.displacement[axis] - b.displacement[axis]).abs()
        };
        active.iter().copied().map(of).fold(0.0, f64::max)
    };
    left.iter().zip(right).map(distance).fold(0.0, f64::max)
}

/// The truth by Dormand–Prince 5(4), and what every method makes of it.
fn check(name: &str, model: &Model) {
    let mut model = model.clone();
    model.duration = model.duration.min(DURATION);
    model.settle = 0.0;
    model.spectrum = None;
    let run = |method: Method, tolerance: f64, verify: bool| {
        let mut model = model.clone();
        model.integrator.method = method;
        model.integrator.tolerance = tolerance;
        model.verify = verify;
        let (run, samples) = try_run(&model, 0.0);
        (run.unwrap(), samples)
    };
    let (_, truth) = run(Method::Dopri5, 1e-11, false);
    for method in scenario::methods() {
        for tolerance in [1e-4, 1e-6] {
            let (run, samples) = run(*method, tolerance, true);
            let error = run.measured_error.unwrap();
            let motion = error.displacement / error.relative;
            let relative = apart(&model, &samples, &truth) / motion;
            let warned = run
                .warnings
                .iter()
                .any(|warning| warning.contains("measured error"));
            println!(
                "{name}, {method} at {tolerance:e}: {relative:.1e}, measured {:.1e}{}",
                error.relative,
                if warned { ", warned" } else { "" }
            );
            // the warning speaks of the distance from a second pass, which has about a tenth of the error itself
            assert!(
                warned || relative <= 11.0 * tolerance,
                "{name}, {method} at {tolerance:e}: {relative:e} and no word of it"
            );
        }
    }
}

/// The beginning of a scene whose shaft bends, whose fast modes cost explicit methods many steps; any other whole.
fn affordable(model: Model) -> Model {
    if model.rotor.flexible.is_none() {
        return model;
    }
    Model {
        duration: model.duration.min(0.05),
        settle: 0.0,
        spectrum: None,
        ..model
    }
}

#[test]
fn shipped_scenarios_keep_to_ten_tolerances_or_warn() {
    let mut checked = 0;
    for file in shipped() {
        let scenario = scenario::load(&file).unwrap_or_else(|error| panic!("{error}"));
        let Some(model) = scenario.model else {
            continue;
        };
        check(
            &file.file_stem().unwrap().to_string_lossy(),
            &affordable(model),
        );
        checked += 1;
    }
    assert!(checked >= 9);
}

fn has_rollers(model: &Model) -> bool {
    let mut bearings = model.rotor.bearings.iter();
    bearings.any(|mounted| mounted.bearing.geometry.rollers().is_some())
}

/// What the file itself asks for, by its own method: no warning helps.
fn keeps_its_own_tolerance(name: &str, model: &Model) {
    let (run, relative) = true_error(name, model);
    let measured = run.measured_error.unwrap().relative;
    let tolerance = model.integrator.tolerance;
    assert!(
        relative <= 10.0 * tolerance && measured <= 10.0 * tolerance,
        "{name}: {relative:e}, measured {measured:e}, asked {tolerance:e}"
    );
}

/// Laminae of rollers leave and meet the races all the time: ten tolerances are not always kept, but thirty are, and the
/// run says by how much.
fn states_its_error(name: &str, model: &Model) {
    let (run, relative) = true_error(name, model);
    let measured = run.measured_error.unwrap().relative;
    let tolerance = model.integrator.tolerance;
    assert!(
        relative <= 2.0 * measured && measured < 30.0 * tolerance,
        "{name}: {relative:e}, measured {measured:e}, asked {tolerance:e}"
    );
    let mut warnings = run.warnings.iter();
    let warned = warnings.any(|warning| warning.contains("measured error"));
    assert_eq!(warned, measured > 10.0 * tolerance, "{name}");
}

/// A run by its own method, and its error relative to the motion. True is what the library's Dormand–Prince 8(5,3) says,
/// which knows nothing of contacts.
fn true_error(name: &str, model: &Model) -> (Run, f64) {
    let mut own = model.clone();
    own.spectrum = None;
    let mut exact = own.clone();
    exact.verify = false;
    exact.integrator.method = Method::Dop853;
    exact.integrator.tolerance = TRUTH;
    let started = std::time::Instant::now();
    let (run, samples) = try_run(&own, 0.0);
    let run = run.unwrap();
    let (truth_run, truth) = try_run(&exact, 0.0);
    truth_run.unwrap();
    let error = run.measured_error.unwrap();
    let motion = error.displacement / error.relative;
    let relative = apart(&own, &samples, &truth) / motion;
    let tolerance = own.integrator.tolerance;
    println!(
        "{name}: {relative:.1e}, measured {:.1e}, asked {tolerance:.0e}, {:.1} s",
        error.relative,
        started.elapsed().as_secs_f64()
    );
    (run, relative)
}

#[test]
fn shipped_scenarios_keep_their_own_tolerance_to_their_end() {
    for file in shipped() {
        let scenario = scenario::load(&file).unwrap_or_else(|error| panic!("{error}"));
        if let Some(model) = scenario.model {
            let name = file.file_stem().unwrap().to_string_lossy();
            let model = affordable(model);
            if has_rollers(&model) {
                states_its_error(&name, &model);
            } else {
                keeps_its_own_tolerance(&name, &model);
            }
        }
    }
}

/// The scene of the benches in which balls lift off at every turn, at tolerances from loose to tight.
#[test]
fn balls_that_lift_off_at_every_turn_keep_to_ten_tolerances() {
    let file =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/scenes/thirteen-balls-unloading.toml");
    let model = scenario::load(&file).unwrap().model.unwrap();
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-9] {
        let mut model = model.clone();
        model.integrator.tolerance = tolerance;
        keeps_its_own_tolerance(&format!("unloading at {tolerance:e}"), &model);
        model.energy = true;
        keeps_its_own_tolerance(&format!("with energy at {tolerance:e}"), &model);
    }
}

/// Thrust so small and unbalance so large that balls unload at every turn.
#[test]
fn balls_that_unload_every_turn_keep_to_ten_tolerances_or_warn() {
    let scene = text("1000 rad/s", "contact = \"hertz\"", "");
    let scene = scene.replace("5 um", "50 um").replace("1000 N", "50 N");
    check("unloading balls", &read(&scene).model.unwrap());
}

#[test]
fn blows_in_a_clearance_keep_to_ten_tolerances_or_warn() {
    let scene = "[shaft]\nmass = \"2 kg\"\neccentricity = \"5 um\"\nfreedoms = \"radial\"\ngravity = true\n\
                 [speed]\nconstant = \"400 rad/s\"\n[[bearing]]\n[bearing.geometry]\nballs = 9\n\
                 ball_diameter = \"7.94 mm\"\npitch_diameter = \"39 mm\"\nradial_clearance = \"10 um\"\n\
                 contact_stiffness = \"8e9 N/m^1.5\"\n[damping]\n\
                 coefficients = { x = \"300 N s/m\", y = \"300 N s/m\" }\n\
                 [[load]]\nshock = { peak = { y = \"500 N\" }, duration = \"1 ms\", at = \"20 ms\" }\n\
                 [time]\nduration = \"0.1 s\"\n[output]\nsample_rate = \"20 kHz\"\n";
    check("clearance", &read(scene).model.unwrap());
}

#[test]
fn a_fast_bearing_keeps_to_ten_tolerances_or_warns() {
    let oil = "catalogue = \"7205C\"\nfilm = true\n[bearing.oil]\nviscosity = \"0.04 Pa s\"\n\
               pressure_viscosity = \"22 1/GPa\"\n";
    let scene = text("2500 rad/s", "contact = \"jones\"", "");
    let scene = scene
        .replace("catalogue = \"7205C\"\n", oil)
        .replace("0.03 s", "0.02 s");
    check("jones + film", &read(&scene).model.unwrap());
}

/// Where the difference of two passes is round-off, they share most of it, and another method shows it.
#[test]
fn the_stated_error_holds_round_off() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/balanced-7205c.toml");
    let model = read(&fs::read_to_string(file).unwrap()).model.unwrap();
    let run = |method: Method, tolerance: f64| {
        let mut model = model.clone();
        model.integrator.method = method;
        model.integrator.tolerance = tolerance;
        model.verify = true;
        let (run, samples) = try_run(&model, 0.0);
        (run.unwrap().measured_error.unwrap().displacement, samples)
    };
    let (stated, samples) = run(Method::Exponential, 1e-10);
    let (_, others) = run(Method::Verner76, 1e-12);
    let apart = apart(&model, &samples, &others);
    assert!(apart <= stated, "{apart:e} is more than {stated:e}");
    assert!(
        stated < 4.0 * apart,
        "{stated:e} says too much of {apart:e}"
    );
}
