//! Scenes that break simulators, each with the story of why it is hard. Every one ends, with bounds
//! on what it says and on the work it takes, or with a typed error that names the cause.
//!
//! Where a story tells what another way of computing does, that way is either computed beside it and
//! asserted, or its version and settings are named and its numbers are those measured with them.

mod axial;
mod ball_inertia;
mod contact;
mod damping;
mod energy;
mod film;
mod impact;
mod irregular;
mod peers;
mod recorded_motion;
mod refusal;
mod scales;
mod speed;
mod tolerance;

use std::io;

use crate::rotor::Sample;
use crate::scenario::{self, Format};
use crate::simulate::{Model, Run, SimulateError, TraceSink};

/// Extremes of a trace.
#[derive(Debug)]
struct Extremes {
    /// Largest |x|, |y|, |z| in m and |θx|, |θy| in rad.
    reach: [f64; 5],
    largest_ball_load: f64,
    /// Smallest of the loads that the most loaded ball ever has.
    lightest_ball_load: f64,
    fewest_balls: u32,
    most_balls: u32,
    contact_changes: u32,
    samples: u64,
    last: Option<Sample>,
}

impl Default for Extremes {
    fn default() -> Self {
        Self {
            reach: [0.0; 5],
            largest_ball_load: 0.0,
            lightest_ball_load: f64::INFINITY,
            fewest_balls: u32::MAX,
            most_balls: 0,
            contact_changes: 0,
            samples: 0,
            last: None,
        }
    }
}

impl TraceSink for Extremes {
    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        for (reach, value) in self.reach.iter_mut().zip(sample.displacement) {
            *reach = reach.max(value.abs());
        }
        let balls = sample.balls_loaded.unwrap_or(0);
        let load = sample.largest_ball_load.unwrap_or(0.0);
        self.largest_ball_load = self.largest_ball_load.max(load);
        self.lightest_ball_load = self.lightest_ball_load.min(load);
        self.fewest_balls = self.fewest_balls.min(balls);
        self.most_balls = self.most_balls.max(balls);
        let changed = self
            .last
            .as_ref()
            .is_some_and(|last| last.balls_loaded != sample.balls_loaded);
        self.contact_changes += u32::from(changed);
        self.last = Some(sample.clone());
        self.samples += 1;
        Ok(())
    }
}

/// The model of a scenario given as text.
fn model(text: &str) -> Model {
    let scenario = scenario::parse(text, "hard_case.toml", Format::Toml)
        .unwrap_or_else(|error| panic!("{}", error.render(false)));
    scenario.model.expect("a scene with a time")
}

/// Runs a scenario given as text.
fn try_run(text: &str) -> (Result<Run, SimulateError>, Extremes) {
    let mut extremes = Extremes::default();
    let result = crate::tests::support::simulate_into(&model(text), &mut extremes);
    (result, extremes)
}

/// Runs a scenario that must succeed.
fn run(text: &str) -> (Run, Extremes) {
    let (result, extremes) = try_run(text);
    (result.expect("the scene can be run"), extremes)
}

fn error(run: &Run) -> f64 {
    run.measured_error.expect("a verified run").relative
}

/// Accepted and rejected steps.
fn work(run: &Run) -> u64 {
    run.counters.steps + run.counters.rejected
}

/// A radial scene on a literature bearing of 8 balls with a clearance, 1500 rpm.
fn clearance_scene(clearance: &str, balls: u32) -> String {
    format!(
        r#"
        [shaft]
        mass = "20 kg"
        freedoms = "radial"
        [speed]
        constant = "150 rad/s"
        [[bearing]]
        [bearing.geometry]
        balls = {balls}
        ball_diameter = "11.9062 mm"
        pitch_diameter = "52 mm"
        radial_clearance = "{clearance}"
        contact_stiffness = "1.334e10 N/m^1.5"
        [damping]
        coefficients = {{ x = "200 N s/m", y = "200 N s/m" }}
        [[load]]
        constant = {{ y = "-196 N" }}
        [time]
        duration = "1 s"
        "#
    )
}

/// A 7205C under thrust with keys to replace.
const THRUST: &str = r#"
    [shaft]
    mass = "5 kg"
    eccentricity = "10 um"
    freedoms = "translational"
    gravity = true
    [speed]
    constant = "500 rad/s"
    [[bearing]]
    catalogue = "7205C"
    [damping]
    ratio = 0.02
    [[load]]
    constant = { z = "1000 N" }
    [time]
    duration = "0.1 s"
    [integrator]
    tolerance = 1e-8
"#;
