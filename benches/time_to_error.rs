//! What each method needs to come to an error: evaluations, steps and time of the bare integration
//! over methods and tolerances, on two scenes of 13 balls and five freedoms.
//!
//! The error is the largest distance from a reference at 200 times, relative to the largest excursion
//! from the static equilibrium; beside it stands the error of the last sample, in which the start is
//! forgotten. The reference is an eighth-order run at tolerance 1e-13; its distance from one of
//! seventh order is printed as its uncertainty. Timed runs ask for the state at the end alone.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use jeffcott::integrate::{Counters, Grid, Integration, Method, Settings};
use jeffcott::rotor::{MotionScale, Moving, Rotor};
use jeffcott::scenario;

const STATES: usize = 10;
const SAMPLES: u64 = 200;
const METHODS: [Method; 7] = [
    Method::Verner76,
    Method::Dop853,
    Method::Dprkn8,
    Method::Dprkn12,
    Method::Tsit5,
    Method::Dopri5,
    Method::OdeSolversDop853,
];
/// Logarithm of the ratio up to which an error counts as near another.
const NEAR: f64 = 3.0;
const TARGETS: [f64; 3] = [1e-5, 1e-7, 1e-9];

/// Number of points to ask for so that the integration ends with the last interval: methods that
/// integrate by blocks go on over the interval after each point.
fn points(method: Method, intervals: u64) -> usize {
    match method {
        Method::Dopri5 | Method::OdeSolversDop853 => intervals as usize,
        _ => intervals as usize + 1,
    }
}

struct Scene {
    rotor: Rotor,
    duration: f64,
}

type State = [f64; STATES];

impl Scene {
    fn load(name: &str) -> Self {
        let file = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("benches/scenes")
            .join(format!("{name}.toml"));
        let loaded = scenario::load(&file).expect("a scene");
        let model = loaded.model.expect("a motion");
        Self {
            rotor: Rotor::assemble(&model.rotor).expect("a rotor"),
            duration: model.duration,
        }
    }

    fn integrate(
        &self,
        method: Method,
        tolerance: f64,
        intervals: u64,
        states: &mut Vec<State>,
    ) -> Counters {
        let scale = self.rotor.motion_scale(tolerance);
        let scaling = Moving::<STATES>::scaling(&self.rotor, &scale);
        let grid = Grid {
            interval: self.duration / intervals as f64,
            count: intervals + 1,
        };
        let settings = Settings {
            method,
            tolerance,
            step_limit: 100_000_000,
        };
        let stop = AtomicBool::new(false);
        let start = Moving::<STATES>::start(&self.rotor);
        let mut integration = Integration::<_, STATES, { STATES + 1 }>::new(
            &self.rotor,
            scaling,
            grid,
            settings,
            &stop,
            &start,
        );
        states.clear();
        integration
            .advance(points(method, intervals), states)
            .expect("a run");
        integration.counters()
    }

    fn trace(&self, method: Method, tolerance: f64) -> Vec<State> {
        let mut states = Vec::new();
        self.integrate(method, tolerance, SAMPLES, &mut states);
        states
    }

    /// Largest distance of two traces as displacements, m.
    fn distance(&self, scale: &MotionScale, left: &[State], right: &[State]) -> f64 {
        let pairs = left.iter().zip(right);
        pairs
            .flat_map(|(a, b)| (0..STATES / 2).map(move |k| scale.lever(k) * (a[k] - b[k]).abs()))
            .fold(0.0, f64::max)
    }

    /// Shortest of some runs, s.
    fn time(&self, method: Method, tolerance: f64) -> (f64, Counters) {
        let mut states = Vec::with_capacity(2);
        let mut counters = Counters::default();
        let mut best = f64::INFINITY;
        let begin = Instant::now();
        while begin.elapsed().as_secs_f64() < 0.15 {
            let start = Instant::now();
            counters = self.integrate(method, tolerance, 1, &mut states);
            best = best.min(start.elapsed().as_secs_f64());
        }
        (best, counters)
    }
}

/// Time at an error, from a straight line through the logarithms of the pairs near it: single errors
/// scatter.
fn time_to(error: f64, measured: &[(f64, f64)]) -> Option<f64> {
    let near: Vec<(f64, f64)> = measured
        .iter()
        .map(|(at, time)| ((at / error).ln(), time.ln()))
        .filter(|(away, _)| away.abs() < NEAR)
        .collect();
    if near.len() < 2 {
        return None;
    }
    let count = near.len() as f64;
    let mean_x = near.iter().map(|(x, _)| x).sum::<f64>() / count;
    let mean_y = near.iter().map(|(_, y)| y).sum::<f64>() / count;
    let slope = near
        .iter()
        .map(|(x, y)| (x - mean_x) * (y - mean_y))
        .sum::<f64>()
        / near.iter().map(|(x, _)| (x - mean_x).powi(2)).sum::<f64>();
    Some((mean_y - slope * mean_x).exp())
}

fn report(name: &str) {
    let scene = Scene::load(name);
    let scale = scene.rotor.motion_scale(1e-13);
    let first = scene.trace(Method::Dop853, 1e-13);
    let second = scene.trace(Method::Verner76, 1e-13);
    let rest = vec![
        {
            let place = scene.rotor.equilibrium().displacement;
            std::array::from_fn(|i| if i < STATES / 2 { place[i] } else { 0.0 })
        };
        first.len()
    ];
    let motion = scene.distance(&scale, &first, &rest);
    let uncertainty = scene.distance(&scale, &first, &second) / motion;
    println!("\n{name}: motion {motion:.2e} m, reference uncertain by {uncertainty:.0e}");
    println!(
        "method            tolerance     error  last error  error/tol    steps rejected evaluations   \
         ms  ns/evaluation"
    );
    for method in METHODS {
        let mut measured = Vec::new();
        let last = points(method, SAMPLES) - 1;
        for exponent in 4..=24 {
            let tolerance = 10.0_f64.powf(-0.5 * f64::from(exponent));
            let trace = scene.trace(method, tolerance);
            let error = scene.distance(&scale, &trace, &first) / motion;
            let (time, work) = scene.time(method, tolerance);
            let last = scene.distance(&scale, &trace[last..], &first[last..]) / motion;
            measured.push((last, time));
            println!(
                "{:<17} {tolerance:9.1e} {error:9.1e} {last:11.1e} {:10.2} {:8} {:8} {:11} {:8.3} {:9.1}",
                format!("{method:?}"),
                error / tolerance,
                work.steps,
                work.rejected,
                work.evaluations,
                1e3 * time,
                1e9 * time / work.evaluations as f64
            );
        }
        let times: Vec<String> = TARGETS
            .into_iter()
            .map(|error| match time_to(error, &measured) {
                Some(time) => format!("{error:.0e} in {:.2} ms", 1e3 * time),
                None => format!("{error:.0e} not reached"),
            })
            .collect();
        println!("{method:?}: {}", times.join(", "));
    }
}

fn main() {
    for name in ["thirteen-balls-preloaded", "thirteen-balls-unloading"] {
        report(name);
    }
}
