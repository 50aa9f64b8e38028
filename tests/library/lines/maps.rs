//! Maps of run-ups: of signals with known lines, and of a rotor whose response is known.

use std::f64::consts::{PI, TAU};

use crate::analysis::{Channel, TrackRecorder, TrackedOrder, WaterfallRecorder};
use crate::bearing::{ContactLaw, MountedBearing};
use crate::rotor::{Damping, Rotor, RotorDefinition, SpeedPoint};
use crate::simulate::{Analyses, Maps, Model, MotionAnalysis, Sample};

use crate::tests::support::{assert_near, model, settings, thrust_rotor, try_run};

const X: Channel = Channel::Displacement(0);

fn orders(values: &[f64]) -> Vec<TrackedOrder> {
    let named = values.iter().map(|order| TrackedOrder {
        name: format!("{order}"),
        order: *order,
    });
    named.collect()
}

fn sample([time, angle, speed]: [f64; 3], x: f64) -> Sample {
    Sample {
        time,
        angle,
        speed,
        displacement: [x, 0.0, 0.0, 0.0, 0.0],
        ..Sample::default()
    }
}

/// The strongest line of a sweep stands at the frequency that it has in the middle of the window.
#[test]
fn the_ridge_of_a_sweep_follows_its_frequency() {
    let (rate, sweep) = (5000.0, 100.0);
    let mut recorder = WaterfallRecorder::new(vec![X], rate, 0.1, 1000.0);
    for n in 0..20_000 {
        let time = f64::from(n) / rate;
        // 50 Hz + 100 Hz/s t on a mean of 1 mm
        let angle = TAU * (50.0 * time + 0.5 * sweep * time * time);
        let x = 1e-3 + 1e-6 * angle.cos();
        recorder.record(&sample([time, 0.0, TAU * (50.0 + sweep * time)], x));
    }
    let waterfall = recorder.finish();
    assert!(waterfall.slices.len() > 150);
    for slice in &waterfall.slices {
        let amplitude = &slice.amplitude[0];
        let top = (0..amplitude.len()).max_by(|a, b| amplitude[*a].total_cmp(&amplitude[*b]));
        let frequency = top.expect("bins") as f64 * waterfall.resolution;
        let expected = 50.0 + sweep * slice.time;
        assert_near("ridge", frequency, expected, 0.51 * waterfall.resolution);
        assert_near("speed", slice.speed, TAU * expected, TAU * 0.02);
        assert_near("mean", amplitude[0], 0.0, 1e-7);
    }
}

/// Orders next to each other and a mean a thousand times as large do not leak into each other.
#[test]
fn orders_do_not_leak_into_each_other() {
    let mut recorder = TrackRecorder::new(orders(&[1.0, 2.0, 4.8, 7.2]), vec![X], 8.0, 100.0);
    let acceleration = 40.0;
    for n in 0..100_000 {
        let time = 1e-4 * f64::from(n);
        let (speed, angle) = (acceleration * time, 0.5 * acceleration * time * time);
        let x = 1e-3
            + 1e-6 * (angle + 1.0).cos()
            + 1e-8 * (2.0 * angle - 0.5).cos()
            + 1e-7 * (4.8 * angle + 2.0).cos();
        recorder.record(&sample([time, angle, speed], x));
    }
    let tracks = recorder.finish();
    assert!(tracks.points.len() > 100);
    // the first windows, at hardly any speed, hold samples enough, but few a radian at their begin
    for point in &tracks.points[1..] {
        let expected = [(1e-6, 1.0), (1e-8, -0.5), (1e-7, 2.0), (0.0, 0.0)];
        for (track, (amplitude, phase)) in point.tracks[0].iter().zip(expected) {
            assert_near("amplitude", track.amplitude, amplitude, 1e-13);
            if amplitude > 0.0 {
                assert_near("phase", track.phase, phase, 1e-13 / amplitude + 1e-9);
            }
        }
    }
}

/// A slow run-up of a linear rotor through its critical speed, damped well.
fn slow_run_up() -> (RotorDefinition, f64) {
    let duration = 8.0;
    let mut definition = thrust_rotor();
    definition.shaft.eccentricity = 1e-5;
    definition.shaft.mass = 200.0;
    definition.damping = Damping::Ratio(0.1);
    definition.speed = 0.0;
    definition.speed_points = vec![SpeedPoint {
        time: duration,
        speed: 2000.0,
    }];
    definition.bearings = vec![MountedBearing {
        law: ContactLaw::Linear,
        ..definition.bearings[0].clone()
    }];
    (definition, duration)
}

fn mapped(definition: RotorDefinition, duration: f64) -> Maps {
    let model = Model {
        integrator: settings(1e-8),
        analyses: Analyses {
            motion: MotionAnalysis::None,
            maps: true,
            ..Analyses::default()
        },
        ..model(definition, duration, 10_000.0)
    };
    let (run, _) = try_run(&model, 0.0);
    run.expect("a run").maps.expect("maps")
}

/// Order 1 of a slow run-up is the steady response to unbalance, `e r²/√((1 − r²)² + (2ζr)²)`, with the
/// phase `−atan2(2ζr, 1 − r²)`.
#[test]
fn in_a_slow_run_up_order_one_is_the_response_to_unbalance() {
    let (definition, duration) = slow_run_up();
    let rotor = Rotor::assemble(&definition).expect("a rotor");
    let natural = (rotor.equilibrium().stiffness[(0, 0)] / 200.0).sqrt();
    assert!((500.0..1500.0).contains(&natural), "{natural}");
    let tracks = mapped(definition, duration).tracks;
    let mut compared = 0;
    for point in tracks
        .points
        .iter()
        .filter(|point| point.speed > 0.3 * natural)
    {
        let ratio = point.speed / natural;
        let (stiff, damped) = (1.0 - ratio * ratio, 2.0 * 0.1 * ratio);
        let amplitude = 1e-5 * ratio * ratio / stiff.hypot(damped);
        let phase = -damped.atan2(stiff);
        let track = point.tracks[0][0];
        // natural at 1030 rad/s, half width ζω0 = 103 rad/s: a window of 16 revolutions, 0.1 s, sees 25 rad/s
        // with a standard deviation of 4.5, which takes ½ (4.5/103)² = 0.1 % of the peak; the response lags
        // by 1/(ζω0) = 10 ms, 2.4 rad/s, which is 1.2 % on the flank of 1/(2ζω0) and 0.024 rad at the peak
        assert_near("amplitude", track.amplitude, amplitude, 0.02 * amplitude);
        let apart = (track.phase - phase + PI).rem_euclid(TAU) - PI;
        assert!(apart.abs() < 0.04, "{} rad/s: {apart}", point.speed);
        compared += 1;
    }
    assert!(compared > 50, "{compared}");
}

/// The waterfall's strongest line of a run-up stands on order 1.
#[test]
fn the_waterfall_of_a_run_up_shows_the_unbalance() {
    let (definition, duration) = slow_run_up();
    let waterfall = mapped(definition, duration).waterfall;
    let late = waterfall.slices.iter().filter(|slice| slice.speed > 600.0);
    for slice in late {
        let amplitude = &slice.amplitude[0];
        let top = (0..amplitude.len()).max_by(|a, b| amplitude[*a].total_cmp(&amplitude[*b]));
        let frequency = top.expect("bins") as f64 * waterfall.resolution;
        assert_near(
            "order 1",
            frequency,
            slice.speed / TAU,
            waterfall.resolution,
        );
    }
}

/// A scene that asks for neither has neither.
#[test]
fn nothing_is_made_that_was_not_asked_for() {
    let (definition, _) = slow_run_up();
    let (run, _) = try_run(&model(definition, 0.1, 10_000.0), 0.0);
    let run = run.expect("a run");
    assert_eq!((run.motion, run.maps), (None, None));
}
