//! Kinds of motion: of signals that are one kind, and of scenes that are known.

use std::f64::consts::TAU;

use crate::analysis::{Kind, SectionKind, Series, closed_curve, recognise};
use crate::rotor::{CageMotion, Damping, RotorDefinition};
use crate::simulate::{Analyses, Model, MotionAnalysis, Sampling};

use crate::tests::support::{
    constant, literature_bearing, model, settings, thrust_rotor, try_run, varying_compliance,
};

fn series(points: Vec<Vec<f64>>) -> Vec<Series> {
    vec![Series {
        kind: SectionKind::Revolution,
        order: 1.0,
        points,
    }]
}

fn kind(points: Vec<Vec<f64>>) -> Kind {
    recognise(&series(points)).kind
}

/// Points that come back after k cycles have the period k, and no shorter one.
#[test]
fn every_period_up_to_twelve_is_found() {
    for period in 1..=12u32 {
        let point = |n: u32| {
            let angle = TAU * f64::from(n % period) / f64::from(period);
            vec![angle.cos() + 0.3 * (2.0 * angle).sin(), angle.sin()]
        };
        let found = kind((0..60).map(point).collect());
        let Kind::Periodic {
            cycles, distance, ..
        } = found
        else {
            panic!("period {period}: {found:?}");
        };
        assert_eq!(cycles, period as usize);
        assert!(distance < 1e-12);
    }
}

/// A second frequency that is no simple part of the first moves the points along a closed curve.
#[test]
fn two_frequencies_make_a_closed_curve() {
    for rotation in [0.381_966, 0.804_6, 0.137_2] {
        let point = |n: u32| {
            let angle = TAU * rotation * f64::from(n);
            vec![
                angle.cos() + 0.4 * (2.0 * angle + 0.3).cos(),
                0.7 * angle.sin() + 0.1 * (3.0 * angle).cos(),
            ]
        };
        let points: Vec<Vec<f64>> = (0..200).map(point).collect();
        let curve = closed_curve(&points, &[]).expect("enough points");
        assert!(curve.residual < 1e-6, "{rotation}: {curve:?}");
        assert!(matches!(kind(points), Kind::QuasiPeriodic { .. }));
    }
}

/// The logistic map is chaotic at 3.97, of period 8 at 3.55, and regular noise of no kind is not called
/// periodic.
#[test]
fn chaos_is_irregular_and_no_closed_curve() {
    let logistic = |rate: f64| {
        let step = move |x: &f64| Some(rate * x * (1.0 - x));
        let values = std::iter::successors(Some(0.3), step);
        values
            .skip(1000)
            .take(400)
            .map(|x| vec![x])
            .collect::<Vec<_>>()
    };
    let chaotic = kind(logistic(3.97));
    assert!(
        matches!(chaotic, Kind::Irregular { test } if test > 0.9),
        "{chaotic:?}"
    );
    let eight = kind(logistic(3.55));
    assert!(
        matches!(eight, Kind::Periodic { cycles: 8, .. }),
        "{eight:?}"
    );
}

/// Henon's map at its classical parameters is chaotic, at a = 1.25 it has the period 7.
#[test]
fn henons_attractor_is_irregular() {
    let henon = |a: f64| {
        let mut place = [0.1, 0.1];
        let points = (0..2400).map(|_| {
            place = [1.0 - a * place[0] * place[0] + place[1], 0.3 * place[0]];
            place.to_vec()
        });
        points.skip(2000).collect::<Vec<_>>()
    };
    assert!(matches!(kind(henon(1.4)), Kind::Irregular { .. }));
    assert!(matches!(
        kind(henon(1.25)),
        Kind::Periodic { cycles: 7, .. }
    ));
}

#[test]
fn few_points_are_of_unknown_kind() {
    let point = |n: u32| vec![(f64::from(n * n) * 0.77).sin()];
    let found = kind((0..15).map(point).collect());
    assert_eq!(
        found,
        Kind::Unknown {
            points: 15,
            test: None
        }
    );
}

/// JIS 6306 of Fukata et al. (1985) and Mevel & Guyader (1993): period 1, 2 and 1 at 100, 150, 200 rad/s.
fn jis_6306(speed: f64) -> RotorDefinition {
    with_clearance(speed, 3e-6)
}

fn with_clearance(speed: f64, clearance: f64) -> RotorDefinition {
    let bearing = literature_bearing(8, [11.9062e-3, 52.0e-3], clearance, 1.334e10);
    varying_compliance(speed, 20.0, 196.0, bearing)
}

fn of_scene(rotor: RotorDefinition, settle: f64, window: f64, tolerance: f64) -> Kind {
    let model = Model {
        settle,
        sampling: Sampling::PerRevolution(128),
        integrator: settings(tolerance),
        analyses: Analyses {
            motion: MotionAnalysis::Kind,
            maps: false,
            ..Analyses::default()
        },
        ..model(rotor, settle + window, 1.0)
    };
    let (run, _) = try_run(&model, 0.0);
    let motion = run.expect("a run").motion.expect("a description");
    println!("{:?} {:?}", motion.recognition, motion.drift);
    motion.recognition.kind
}

#[test]
fn period_doubling_of_the_varying_compliance_is_recognised() {
    for (speed, period) in [(100.0, 1), (150.0, 2), (200.0, 1)] {
        let found = of_scene(jis_6306(speed), 4.0, 0.6, 1e-8);
        let Kind::Periodic {
            section,
            cycles,
            distance,
        } = found
        else {
            panic!("{speed} rad/s: {found:?}");
        };
        assert_eq!(
            (section, cycles),
            (SectionKind::BallPass, period),
            "{speed} rad/s"
        );
        assert!(distance < 1e-3);
    }
}

/// Unbalance and passing balls have no common period: two frequencies, one curve.
#[test]
fn unbalance_and_passing_balls_make_two_frequencies() {
    let mut definition = RotorDefinition {
        loads: constant([0.0, -400.0, 200.0, 0.0, 0.0]),
        damping: Damping::Ratio(0.1),
        ..thrust_rotor()
    };
    definition.shaft.eccentricity = 1e-5;
    let rolling = of_scene(definition.clone(), 0.3, 0.5, 1e-9);
    let Kind::QuasiPeriodic { curve, .. } = rolling else {
        panic!("{rolling:?}");
    };
    assert!(curve.residual < 0.02, "{curve:?}");
    definition.cage = CageMotion::Frozen;
    let frozen = of_scene(definition, 0.3, 0.5, 1e-9);
    let Kind::Periodic {
        section, cycles, ..
    } = frozen
    else {
        panic!("{frozen:?}");
    };
    assert_eq!((section, cycles), (SectionKind::Revolution, 1));
}

/// The same bearing with more clearance: passing balls alone make a second frequency of the shaft's own at
/// 280 rad/s with 12 µm, and an irregular motion at 80 rad/s with 40 µm. That one lasts: 48 runs over 600 and
/// 1800 passes, by four methods at tolerances from 1e-7 to 1e-10, are all irregular. At 100 rad/s with 30 µm it
/// is a transient of hundreds of passes, which some runs leave for a motion of four.
#[test]
fn clearance_makes_a_torus_and_an_irregular_motion() {
    let passes = |count: f64, speed: f64| count * TAU / (4.0 * speed * (1.0 - 11.9062 / 52.0));
    let torus = of_scene(
        with_clearance(280.0, 12e-6),
        passes(300.0, 280.0),
        passes(300.0, 280.0),
        1e-8,
    );
    let Kind::QuasiPeriodic { section, curve } = torus else {
        panic!("{torus:?}");
    };
    assert_eq!(section, SectionKind::BallPass);
    assert!(curve.residual < 0.01, "{curve:?}");
    let irregular = of_scene(
        with_clearance(80.0, 40e-6),
        passes(300.0, 80.0),
        passes(300.0, 80.0),
        1e-8,
    );
    assert!(
        matches!(irregular, Kind::Irregular { test } if test > 0.9),
        "{irregular:?}"
    );
}
