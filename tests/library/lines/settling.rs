//! Whether a motion has settled, and statistics of what has.

use std::f64::consts::{SQRT_2, TAU};

use crate::analysis::{Channel, Kind, SectionKind};
use crate::bearing::{ContactLaw, MountedBearing};
use crate::rotor::{Damping, ElementLaw, ForceElement, LinearLaw, RotorDefinition};
use crate::simulate::{Analyses, Model, MotionAnalysis, Run, Sampling};

use crate::tests::support::{assert_near, model, settings, thrust_rotor, try_run};

fn described(rotor: RotorDefinition, settle: f64, duration: f64) -> Run {
    let model = Model {
        settle,
        sampling: Sampling::PerRevolution(128),
        integrator: settings(1e-9),
        analyses: Analyses {
            motion: MotionAnalysis::Kind,
            maps: false,
            ..Analyses::default()
        },
        ..model(rotor, duration, 1.0)
    };
    let (run, _) = try_run(&model, 0.0);
    run.expect("a run")
}

fn unbalanced() -> RotorDefinition {
    let mut definition = thrust_rotor();
    definition.shaft.eccentricity = 1e-5;
    definition.damping = Damping::Ratio(0.02);
    definition.bearings = vec![MountedBearing {
        law: ContactLaw::Linear,
        ..definition.bearings[0].clone()
    }];
    definition
}

/// A linear rotor under unbalance goes round in a circle: crest factor √2, kurtosis 3/2, and its velocity
/// is ω times its displacement.
#[test]
fn statistics_of_a_circle_are_those_of_a_sine() {
    let run = described(unbalanced(), 0.5, 0.5 + 10.3 * TAU / 500.0);
    let motion = run.motion.expect("a description");
    let of = |channel| {
        let found = motion
            .statistics
            .iter()
            .find(|each| each.channel == channel);
        found.expect("a channel").moments
    };
    for axis in 0..2 {
        let moments = of(Channel::Displacement(axis));
        assert_near("kurtosis", moments.kurtosis().expect("motion"), 1.5, 1e-6);
        // samples stand on the peaks within 1 − cos(π/128)
        assert_near(
            "crest",
            moments.crest_factor().expect("motion"),
            SQRT_2,
            5e-4,
        );
        let level = motion.velocity[axis].expect("a level");
        let expected = 500.0 * moments.rms();
        assert_near("velocity", level.rms, expected, 1e-6 * expected);
        assert_eq!(level.band, [10.0, 1000.0]);
    }
    assert!(motion.drift.expect("a drift").is_settled());
    assert!(run.warnings.is_empty(), "{:?}", run.warnings);
    assert!(matches!(
        motion.recognition.kind,
        Kind::Periodic {
            section: SectionKind::Revolution,
            cycles: 1,
            ..
        }
    ));
}

/// A free vibration that still dies away has not settled, and the warning says by how much.
#[test]
fn a_motion_that_still_dies_away_has_not_settled() {
    let mut definition = unbalanced();
    definition.damping = Damping::Ratio(0.002);
    definition.initial.displacement[0] = Some(5e-7);
    let run = described(definition, 0.0, 0.2);
    let motion = run.motion.expect("a description");
    let drift = motion.drift.expect("a drift");
    assert!(!drift.is_settled(), "{drift:?}");
    assert!(drift.rms < -0.05, "{drift:?}");
    let told = run
        .warnings
        .iter()
        .any(|text| text.contains("has not settled"));
    assert!(told, "{:?}", run.warnings);
}

/// A shaft that rests has no motion to describe.
#[test]
fn rest_is_rest() {
    let mut definition = unbalanced();
    definition.shaft.eccentricity = 0.0;
    let motion = described(definition, 0.1, 0.3)
        .motion
        .expect("a description");
    assert_eq!(motion.recognition.kind, Kind::Rest);
    assert_eq!(motion.drift, None);
}

/// Points between samples are as exact as four samples with their rates make them: those of every second
/// sample stand where the full trace has them.
#[test]
fn points_between_samples_stand_on_the_trace() {
    let coarse = described(unbalanced(), 0.5, 0.6);
    let motion = coarse.motion.expect("a description");
    let [x, y] = [0, 1].map(|axis| motion.statistics[axis].moments);
    let amplitude = SQRT_2 * x.rms();
    for section in &motion.sections {
        assert!(section.points.len() > 5);
        for point in &section.points {
            let [dx, dy] = [
                point.displacement[0] - x.mean(),
                point.displacement[1] - y.mean(),
            ];
            // on the circle, at the angle of the unbalance: below resonance nearly its own
            assert_near("circle", dx.hypot(dy), amplitude, 1e-6 * amplitude);
            let speed = point.velocity[0].hypot(point.velocity[1]);
            assert_near("speed", speed, 500.0 * amplitude, 1e-6 * 500.0 * amplitude);
            let cycles = section.order * 500.0 * point.time / TAU;
            assert_near("cycles", cycles, cycles.round(), 1e-9 * cycles);
        }
        assert!(section.interpolation[0] < 1e-6 * amplitude);
    }
}

/// A linear rotor whose free vibration grows is warned of, and no advice makes it settle; a motion that grew beyond what a
/// shaft can do is of no other kind.
#[test]
fn a_motion_that_grows_for_ever_is_called_so() {
    let driven = |duration: f64| {
        let mut definition = unbalanced();
        definition.bearings.clear();
        let springs = ([1e6, 1e6, 1e6, 1e4, 1e4], [0.0; 2]);
        let dampers = ([-400.0, -400.0, 400.0, 1.0, 1.0], [0.0; 2]);
        definition.elements = vec![ForceElement {
            position: Some(0.0),
            housing_of: None,
            housing: None,
            law: ElementLaw::Linear(Box::new(LinearLaw::new(springs, dampers))),
        }];
        definition.damping = Damping::Undamped;
        described(definition, 0.5 * duration, duration)
    };
    let about = |run: &Run, words: &str| run.warnings.iter().any(|text| text.contains(words));
    for (duration, diverging) in [(0.1, false), (2.0, true)] {
        let run = driven(duration);
        assert!(
            about(&run, "not stable at its static equilibrium"),
            "{:?}",
            run.warnings
        );
        assert!(about(&run, "grows for ever"), "{:?}", run.warnings);
        assert!(!about(&run, "make `settle`"), "{:?}", run.warnings);
        let motion = run.motion.expect("a description");
        assert_ne!(motion.has_settled(), Some(true), "{duration}");
        assert_eq!(
            motion.recognition.kind == Kind::Diverging,
            diverging,
            "{:?}",
            motion.recognition.kind
        );
    }
}
