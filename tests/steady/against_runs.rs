use std::sync::atomic::AtomicBool;
use std::time::Instant;

use jeffcott::scenario;
use jeffcott::simulate::BareRun;
use jeffcott::steady::{SteadyQuestion, steady};

#[test]
fn explore() {
    for (name, multiple) in [("steady-7205c", None), ("varying-compliance-6306", None), ("varying-compliance-6306", Some(1)), ("balanced-7205c", None), ("linear-7205c", None), ("back-to-back-7205c", None), ("arrangement-7205c", None), ("run-up-7205c", None), ("coal-impact-7205c", None), ("drive-start-7205c", None)] {
        let scenario = scenario::load(format!("scenarios/{name}.toml").as_ref()).expect("a scenario");
        let model = scenario.model.expect("a motion");
        let stop = AtomicBool::new(false);
        for _ in 0..2 {
        let started = Instant::now();
        let result = steady(&SteadyQuestion { model: &model, multiple, stop: &stop });
        let seconds = started.elapsed().as_secs_f64();
        let started = Instant::now();
        let run = BareRun::new(&model).expect("a run").integrate(&stop);
        let run_seconds = started.elapsed().as_secs_f64();
        match result {
            Ok(steady) => println!("{name} {multiple:?}: {seconds:.4} s run {run_seconds:.4} s {:?}, {:?}, period {} x{} harm {} missing {:e} history {:?} waited {} mult {:?} {:?} measured {:?} counters {:?} lines {}",
               run.map(|c| c.evaluations), steady.bases, steady.period, steady.multiple, steady.harmonics, steady.missing, steady.history, steady.waited, steady.multipliers, steady.instability, steady.measured, steady.counters, steady.lines.lines.len()),
            Err(error) => println!("{name}: {seconds:.4} s {error}"),
        }
        }
    }
}
