//! Scenes that break simulators, each with the story of why it is hard. Every one ends, with bounds
//! on what it says and on the work it takes, or with a typed error that names the cause.

use std::io;
use std::sync::atomic::AtomicBool;

use jeffcott::rotor::Sample;
use jeffcott::scenario::{self, Format};
use jeffcott::simulate::{Monitor, Run, SimulateError, TraceSink, simulate};

/// Extremes of a trace.
#[derive(Debug, Default)]
struct Extremes {
    /// Largest |x|, |y|, |z| in m.
    reach: [f64; 3],
    largest_ball_load: f64,
    fewest_balls: Option<u32>,
    most_balls: u32,
    contact_changes: u32,
    last_balls: Option<u32>,
    samples: u64,
}

impl TraceSink for Extremes {
    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        for (reach, value) in self.reach.iter_mut().zip(sample.displacement) {
            *reach = reach.max(value.abs());
        }
        let balls = sample.balls_loaded;
        self.largest_ball_load = self.largest_ball_load.max(sample.largest_ball_load);
        self.fewest_balls = Some(self.fewest_balls.map_or(balls, |fewest| fewest.min(balls)));
        self.most_balls = self.most_balls.max(balls);
        self.contact_changes += u32::from(self.last_balls.is_some_and(|last| last != balls));
        self.last_balls = Some(balls);
        self.samples += 1;
        Ok(())
    }
}

/// Runs a scenario given as text.
fn try_run(text: &str) -> (Result<Run, SimulateError>, Extremes) {
    let scenario = scenario::parse(text, "hard_case.toml", Format::Toml)
        .unwrap_or_else(|error| panic!("{}", error.render(false)));
    let (stop, mut extremes) = (AtomicBool::new(false), Extremes::default());
    let mut monitor = Monitor {
        stop: &stop,
        progress: &mut |_part| {},
    };
    let model = scenario.model.expect("a scene with a time");
    let result = simulate(&model, &mut extremes, &mut monitor);
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

/// Clearance zero is the edge at which the whole ring of balls is at once at the edge of contact.
#[test]
fn clearance_of_exactly_zero_and_of_a_picometre() {
    let (zero, at_zero) = run(&clearance_scene("0 um", 8));
    let (tiny, at_tiny) = run(&clearance_scene("1e-6 um", 8));
    let difference = (at_zero.reach[1] - at_tiny.reach[1]).abs();
    assert!(
        difference < 5e-12,
        "a picometre moved the shaft by {difference} m"
    );
    assert!(error(&zero) < 1e-4 && error(&tiny) < 1e-4);
    assert!(at_zero.fewest_balls >= Some(3));
}

/// Three balls: for a part of every passage the shaft hangs between two of them.
#[test]
fn three_balls_carry_a_shaft() {
    let (run, extremes) = run(&clearance_scene("3 um", 3));
    assert!(run.counters.steps < 200_000, "{:?}", run.counters);
    assert!(extremes.reach[1] < 100e-6 && extremes.fewest_balls <= Some(1));
}

/// A wide clearance under a light load: balls leave and meet the races thousands of times.
#[test]
fn contact_lost_and_regained_thousands_of_times() {
    let text = clearance_scene("20 um", 8)
        .replace("\"1 s\"", "\"40 s\"")
        .replace("-196 N", "-20 N");
    let (run, extremes) = run(&text);
    assert!(
        extremes.contact_changes > 10_000,
        "{}",
        extremes.contact_changes
    );
    assert!(extremes.reach[1] < 60e-6, "{:?}", extremes.reach);
    assert!(
        run.counters.rejected < run.counters.steps,
        "{:?}",
        run.counters
    );
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

/// Without damping the start never dies; overdamped, the film of time scales is wide.
#[test]
fn damping_ratio_of_zero_and_of_five() {
    let (undamped, swing) = run(&THRUST.replace("0.02", "0"));
    let (overdamped, crawl) = run(&THRUST.replace("0.02", "5"));
    assert!(error(&undamped) < 1e-6 && error(&overdamped) < 1e-6);
    assert!(
        swing.reach[0] > crawl.reach[0] && crawl.reach[0] < 60e-9,
        "{crawl:?}"
    );
    assert!(
        overdamped.counters.steps < 60_000,
        "{:?}",
        overdamped.counters
    );
}

/// Light and heavy shafts on one bearing: natural frequencies a thousand times apart.
#[test]
fn masses_a_million_times_apart() {
    for mass in ["5 g", "5000 kg"] {
        let text = THRUST
            .replace("5 kg", mass)
            .replace("0.1 s", "0.02 s")
            .replace("gravity = true", "");
        let (run, extremes) = run(&text);
        assert!(error(&run) < 1e-6, "{mass}: {}", error(&run));
        assert!(extremes.reach[2] < 1e-3, "{mass}: {extremes:?}");
    }
}

/// At 1e-13 the tolerance is at the round-off of the positions: the run must end and say so.
#[test]
fn a_tolerance_at_the_floor_of_round_off_ends() {
    let (run, _) = run(&THRUST.replace("1e-8", "1e-13"));
    assert!(error(&run) < 1e-10, "{}", error(&run));
    assert!(run.counters.steps < 100_000, "{:?}", run.counters);
}

/// A loose tolerance may be wrong, but must stay near the truth and say how far it is.
#[test]
fn a_loose_tolerance_stays_bounded() {
    let (loose, extremes) = run(&THRUST.replace("1e-8", "1e-2"));
    let (_, tight) = run(THRUST);
    assert!(error(&loose) < 0.1, "{}", error(&loose));
    assert!(
        (extremes.reach[2] - tight.reach[2]).abs() < 1e-8,
        "{extremes:?} {tight:?}"
    );
}

/// A radial load alone on an angular contact bearing that may move axially: it slides to the place
/// where no ball pushes it along.
#[test]
fn a_lone_radial_load_with_a_free_axial_freedom() {
    let text = THRUST.replace("z = \"1000 N\"", "y = \"-300 N\"");
    let (run, extremes) = run(&text);
    let place = run.equilibrium.displacement[2];
    // axially centred: −A sin α0 with A = 0.3969 mm, α0 = 15°
    assert!(
        (place + 0.3969e-3 * 15f64.to_radians().sin()).abs() < 1e-6,
        "{place}"
    );
    assert!(
        extremes.reach[1] < 200e-6 && error(&run) < 1e-3,
        "{extremes:?} {}",
        error(&run)
    );
}

/// A load that no bearing of this size carries.
#[test]
fn an_impossible_load_is_refused_before_the_first_step() {
    let (result, extremes) = try_run(&THRUST.replace("1000 N", "800 MN"));
    let message = result.expect_err("nothing carries 800 MN").to_string();
    assert!(
        message.contains("no static equilibrium") && message.contains(" z "),
        "{message}"
    );
    assert_eq!(extremes.samples, 0);
}

/// Steps run out: the trace up to there has been handed over.
#[test]
fn a_limit_on_steps_keeps_the_trace_so_far() {
    let text = THRUST.replace("tolerance = 1e-8", "tolerance = 1e-8\n    step_limit = 300");
    let (result, extremes) = try_run(&text);
    let message = result.expect_err("300 steps are too few").to_string();
    assert!(message.contains("300 steps are used up"), "{message}");
    assert!(extremes.samples > 100, "{}", extremes.samples);
}
