//! Three methods, one motion: on every scenario that is shipped.

use std::fs;
use std::path::{Path, PathBuf};

use crate::integrate::Method;
use crate::rotor::Sample;
use crate::scenario;
use crate::simulate::{Model, Run};

use super::traces_apart;
use crate::tests::support::try_run;

/// Simulated time that is compared, s: the transient from the start, with run-up or first blows.
const DURATION: f64 = 0.12;

fn shipped() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios");
    let entries = fs::read_dir(folder).expect("scenarios");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "toml")
        })
        .collect();
    files.sort();
    files
}

/// The beginning of a scenario by a method, with its measured error.
fn begin(model: &Model, method: Method, tolerance: f64) -> (Run, Vec<Sample>) {
    let mut model = model.clone();
    model.duration = model.duration.min(DURATION);
    model.settle = 0.0;
    model.verify = true;
    model.spectrum = None;
    model.integrator.method = method;
    model.integrator.tolerance = tolerance;
    let (run, samples) = try_run(&model, 0.0);
    (run.expect("a scenario that runs"), samples)
}

/// Scenes whose balls or rollers part from the races: methods whose steps do not end there may miss ten tolerances; and a run-up, whose
/// beginning moves far less than the end that its scale is for.
const PARTING: [&str; 14] = [
    "ball-and-journal.toml",
    "conveyor-head-22212.toml",
    "spall-outer-nu206.toml",
    "run-up-7205c.toml",
    "coal-impact-7205c.toml",
    "fan-6205.toml",
    "healthy-6205.toml",
    "run-up-spall-6205.toml",
    "spall-ball-6205.toml",
    "spall-inner-6205.toml",
    "spall-outer-6205.toml",
    "varying-compliance-6306.toml",
    "motor-6206-nu206.toml",
    "tapered-pair.toml",
];

/// Each method keeps to ten of its tolerances, or the run warns that it does not; and the error that
/// it measures by itself is the one that the other methods find.
#[test]
fn methods_give_the_same_trace_of_every_scenario() {
    let files = shipped();
    assert!(files.len() >= 9, "{files:?}");
    for file in files {
        let name = file
            .file_name()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        let model = scenario::load(&file)
            .expect("a scenario")
            .model
            .expect("a motion");
        let (eighth, truth) = begin(&model, Method::Dop853, 1e-9);
        let own = eighth.measured_error.expect("a second pass");
        for (method, tolerance) in [(Method::Dopri5, 1e-7), (Method::Rodas, 1e-6)] {
            let (run, samples) = begin(&model, method, tolerance);
            let error = run.measured_error.expect("a second pass");
            let apart = traces_apart(&truth, &samples);
            let motion = error.displacement / error.relative;
            println!(
                "{name}, {method:?}: {:e} of {motion:e} m, measured {:e}",
                apart / motion,
                error.relative
            );
            // the second passes, at a tenth of the tolerance, have some of the error themselves
            let measured = error.displacement + own.displacement;
            assert!(
                apart <= 1.5 * measured,
                "{name}, {method:?}: {apart:e} {measured:e}"
            );
            if run
                .warnings
                .iter()
                .any(|warning| warning.contains("measured error"))
            {
                assert!(PARTING.contains(&name.as_str()), "{name}, {method:?} warns");
            } else {
                assert!(
                    apart <= 10.0 * tolerance * motion,
                    "{name}, {method:?}: {apart:e}"
                );
            }
        }
    }
}
