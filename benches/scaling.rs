//! How the time of a run grows: with the balls, the freedoms, the duration, and with runs side by side
//! on several threads. Each figure is the best of a few.

use std::io;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use jeffcott::bearing::{FreePosition, Geometry};
use jeffcott::rotor::{Freedoms, Sample};
use jeffcott::scenario;
use jeffcott::simulate::{Model, Monitor, TraceSink, simulate};

const REPEATS: usize = 7;

/// Takes samples and forgets them.
struct Nowhere;

impl TraceSink for Nowhere {
    fn sample(&mut self, _sample: &Sample) -> io::Result<()> {
        Ok(())
    }
}

fn model() -> Model {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/steady-7205c.toml");
    let scenario = scenario::load(&file).expect("a shipped scenario");
    let mut model = scenario.model.expect("a motion");
    model.verify = false;
    model.spectrum = None;
    model.rotor.shaft.inertia_transverse = 0.01;
    model.rotor.shaft.inertia_polar = 0.004;
    model
}

fn run(model: &Model) -> u64 {
    let stop = AtomicBool::new(false);
    let mut monitor = Monitor {
        stop: &stop,
        progress: &mut |_| {},
    };
    let run = simulate(model, &mut Nowhere, &mut monitor).expect("it runs");
    run.counters.evaluations
}

/// Seconds of wall time, the best of a few, and evaluations.
fn time(model: &Model) -> (f64, u64) {
    let mut best = (f64::INFINITY, 0);
    for _ in 0..REPEATS {
        let start = Instant::now();
        let evaluations = run(model);
        best = (best.0.min(start.elapsed().as_secs_f64()), evaluations);
    }
    best
}

fn print(what: &str, model: &Model) {
    let (seconds, evaluations) = time(model);
    println!(
        "{what:<24} {:>8.3} ms a simulated second {:>9} evaluations {:>6.0} ns each",
        1e3 * seconds / model.duration,
        evaluations,
        1e9 * seconds / evaluations as f64
    );
}

fn balls() {
    for balls in [6, 9, 12, 16] {
        let mut model = model();
        let bearing = &mut model.rotor.bearings[0].bearing;
        let (ball, pitch) = (
            bearing.geometry.ball_diameter(),
            bearing.geometry.pitch_diameter(),
        );
        let free = FreePosition::ContactAngle(15f64.to_radians());
        // smaller balls where sixteen would overlap
        let ball = ball * (12.0 / balls as f64).min(1.0);
        bearing.geometry = Geometry::new(balls, ball, pitch, free, 0.52, 0.52).expect("it fits");
        print(&format!("{balls} balls"), &model);
    }
}

fn freedoms() {
    for freedoms in [Freedoms::Radial, Freedoms::Translational, Freedoms::All] {
        let mut model = model();
        model.rotor.shaft.freedoms = freedoms;
        print(&format!("{} freedoms", freedoms.count()), &model);
    }
}

fn durations() {
    for duration in [0.1, 1.0, 10.0] {
        let model = Model {
            duration,
            settle: 0.0,
            ..model()
        };
        print(&format!("{duration} s"), &model);
    }
}

/// The same run on every thread: what one thread does in a second, all of them do.
fn threads() {
    let model = model();
    let (alone, _) = time(&model);
    for threads in [1, 2, 4] {
        let side_by_side = || {
            let start = Instant::now();
            std::thread::scope(|scope| {
                for _ in 0..threads {
                    scope.spawn(|| run(&model));
                }
            });
            start.elapsed().as_secs_f64()
        };
        let best = (0..REPEATS)
            .map(|_| side_by_side())
            .fold(f64::INFINITY, f64::min);
        println!(
            "{threads} threads: {:.2} × the runs of one",
            f64::from(threads) * alone / best
        );
    }
}

fn main() {
    balls();
    freedoms();
    durations();
    threads();
}
