//! A bearing whose outer ring turns while the shaft stands: cage, ball passes, life, and what lies on its races.

use std::f64::consts::TAU;

use crate::bearing::{
    Angle, BearingRotation, CageMotion, Defect, DefectProfile, MountedBearing, Support, Surface,
};
use crate::physics::Race;
use crate::quasi_static::quasi_static;
use crate::rotor::{Damping, Freedoms, Rotor};
use crate::scenario::{self, Format, Scenario, ScenarioError};

use super::support::{assert_near, bearing, constant, mounted, rotor, shaft};

const SCENE: &str = r#"
title = "6207, Fr 1820, Fa 1365, 1200 rpm, outer ring turns"
[shaft]
mass = "1 kg"
freedoms = "translational"
[[bearing]]
catalogue = "6207"
rotating_ring = "outer"
[[load]]
constant = { y = "-1820 N", z = "1365 N" }
[speed]
constant = "1200 rpm"
"#;

fn parsed(text: &str) -> Result<Scenario, ScenarioError> {
    scenario::parse(text, "outer.toml", Format::Toml)
}

/// n_c = (n/2)(1 + γ), BPFO = Z (n/2)(1 − γ), BPFI = Z n_c: Harris & Kotzalas, eq. 10.12 with a standing inner ring.
#[test]
fn the_cage_follows_the_outer_ring() {
    let question = parsed(SCENE).expect("it is good").question;
    let state = quasi_static(&question)
        .expect("an answer")
        .bearings
        .remove(0);
    let geometry = question.rotor.bearings[0].bearing.geometry;
    let (mut moment, mut load) = (0.0, 0.0);
    for ball in &state.balls {
        moment += ball.inner.load * ball.inner.angle.cos();
        load += ball.inner.load;
    }
    let (balls, ratio) = (
        geometry.balls() as f64,
        geometry.ball_diameter() / geometry.pitch_diameter(),
    );
    for (pass, gamma) in [
        (state.ball_pass, ratio * moment / load),
        (state.nominal_ball_pass, ratio),
    ] {
        assert_near("cage", pass.cage, 10.0 * (1.0 + gamma), 1e-9);
        assert_near("BPFO", pass.outer, balls * 10.0 * (1.0 - gamma), 1e-8);
        assert_near("BPFI", pass.inner, balls * 10.0 * (1.0 + gamma), 1e-8);
        let spin = 10.0 * (1.0 - gamma * gamma) / ratio;
        assert_near("BSF", pass.spin, spin, 1e-8);
    }
}

/// P = X V F_r + Y F_a with V = 1.2; in L10r the exponents 3 and 10/3 of the races change places.
#[test]
fn lives_are_those_of_a_turning_outer_ring() {
    let question = parsed(SCENE).expect("it is good").question;
    let state = quasi_static(&question)
        .expect("an answer")
        .bearings
        .remove(0);
    let lives = state.rating_lives.expect("lives");
    let own = &question.rotor.bearings[0].bearing;
    let geometry = &own.geometry;
    let balls = geometry.balls() as f64;
    // Y of ISO 281 between its rows F_a/(Z D²) = 1.38 and 2.07 N/mm²: 1.45 and 1.31
    let relative = 1365.0 / (balls * (1e3 * geometry.ball_diameter()).powi(2));
    assert!((1.03..1.38).contains(&relative), "{relative}");
    let y = 1.55 + (relative - 1.03) / 0.35 * (1.45 - 1.55);
    let load = 0.56 * 1.2 * 1820.0 + y * 1365.0;
    assert_near("P", lives.equivalent_load.expect("P"), load, 1e-6 * load);
    let mean = |of: fn(&crate::bearing::BallLine) -> f64, power: f64| {
        let powers = state.balls.iter().map(|ball| of(ball).powf(power));
        (powers.sum::<f64>() / balls).powf(1.0 / power)
    };
    // the same balls under a turning inner ring
    let rating = own.dynamic_rating.expect("a rating");
    let ratio = geometry.ball_diameter() / geometry.pitch_diameter();
    let [f_i, f_o] = [geometry.groove_factors()[0], geometry.groove_factors()[1]];
    let g = 1.044
        * ((1.0 - ratio) / (1.0 + ratio)).powf(1.72)
        * (f_i * (2.0 * f_o - 1.0) / (f_o * (2.0 * f_i - 1.0))).powf(0.41);
    let ring = |factor: f64, sign: f64| {
        rating / (factor * balls) * (1.0 + g.powf(sign * 10.0 / 3.0)).powf(0.3)
    };
    let inner = mean(|ball| ball.inner.load, 10.0 / 3.0) / ring(0.407, 1.0);
    let outer = mean(|ball| ball.outer.load, 3.0) / ring(0.389, -1.0);
    let life = (inner.powf(10.0 / 3.0) + outer.powf(10.0 / 3.0)).powf(-0.9);
    assert_near("L10r", state.life.expect("a life"), life, 1e-9 * life);
}

/// A slot of the outer race turns with its ring: a ball meets it (1 − γ)/2 times a revolution.
#[test]
fn what_lies_on_the_outer_race_turns() {
    let mut own: MountedBearing = mounted(bearing("6207"));
    own.bearing.rotating_ring = Race::Outer;
    own.imperfections.defects = vec![Defect {
        on: Surface::Outer,
        angle: 0.3,
        length: 5e-4,
        depth: 2e-4,
        profile: DefectProfile::Edges,
    }];
    own.first_ball = 0.3;
    let support = Support::new(&own, 0.0).expect("a bearing");
    let pass = support.ball_pass(TAU);
    let rate = support.passings()[0].rate(support.cage_ratio());
    assert_near("BPFO", rate.abs() * 9.0, pass.outer, 1e-12);
    // turned as a whole, with ring and cage, it answers with the turned force
    let turn = 1.1_f64;
    let turned = |[x, y]: [f64; 2]| {
        let (sin, cos) = turn.sin_cos();
        [x * cos - y * sin, x * sin + y * cos]
    };
    let place = [20e-6, 8e-6];
    let force = |[x, y]: [f64; 2], angle: f64| {
        let rotation = BearingRotation {
            shaft: Angle::new(angle),
            ..BearingRotation::at_start(0.0).with_cage_at(angle)
        };
        let [x, y, ..] = support.force(&[x, y, 0.0, 0.0, 0.0], &rotation);
        [x, y]
    };
    let expected = turned(force(place, 0.0));
    let found = force(turned(place), turn);
    for axis in 0..2 {
        assert_near(
            "force",
            found[axis],
            expected[axis],
            1e-6 * expected[0].abs(),
        );
    }
    let elsewhere = support.force(
        &[20e-6, 8e-6, 0.0, 0.0, 0.0],
        &BearingRotation {
            shaft: Angle::new(0.5),
            ..BearingRotation::at_start(0.0)
        },
    );
    assert!((elsewhere[0] - force(place, 0.0)[0]).abs() > 1.0);
}

/// A shaft that stands has no gyroscopic moments, and its balls pass the inner race at (n/2)(1 + γ).
#[test]
fn a_standing_shaft_is_not_a_gyroscope() {
    let mut own = mounted(bearing("7205C"));
    own.bearing.rotating_ring = Race::Outer;
    let mut definition = rotor(shaft(Freedoms::All), vec![own]);
    definition.speed = 500.0;
    definition.damping = Damping::Ratio(0.02);
    definition.cage = CageMotion::Operating;
    definition.loads = constant([0.0, 0.0, 1000.0, 0.0, 0.0]);
    let turning = Rotor::assemble(&definition).expect("a rotor");
    definition.bearings[0].bearing.rotating_ring = Race::Inner;
    definition.shaft.inertia_polar = 0.0;
    let standing = Rotor::assemble(&definition).expect("a rotor");
    let frequencies = |rotor: &Rotor| -> Vec<f64> {
        let modes = rotor.natural_frequencies();
        modes.iter().map(|mode| mode.frequency).collect()
    };
    assert_eq!(frequencies(&turning), frequencies(&standing));
    let [turning, standing] =
        [turning, standing].map(|rotor| rotor.supports().next().expect("a bearing").cage_ratio());
    assert_near("both cages", turning + standing, 1.0, 1e-12);
}

#[test]
fn what_turns_with_a_shaft_that_stands_is_refused() {
    for (old, new, reason) in [
        (
            "mass = \"1 kg\"",
            "mass = \"1 kg\"\neccentricity = \"1 um\"",
            "an unbalance",
        ),
        (
            "[speed]",
            "[model]\ncontact = \"jones\"\n[speed]",
            "contact = \"hertz\"",
        ),
        (
            "[speed]",
            "[model]\ncontact = \"auto\"\n[speed]",
            "contact = \"hertz\"",
        ),
        (
            "[[load]]",
            "[[bearing]]\ncatalogue = \"6207\"\nposition = \"90 mm\"\n[[load]]",
            "whose inner ring turns",
        ),
    ] {
        let error = parsed(&SCENE.replacen(old, new, 1)).expect_err(reason);
        assert!(error.to_string().contains(reason), "{reason}: {error}");
    }
}
