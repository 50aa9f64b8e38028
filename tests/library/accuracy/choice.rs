//! `contact = "auto"` takes the cheapest law that is good enough.

use crate::study::{ContactChoice, Fidelity};

use super::read;

const OIL: &str = "[bearing.oil]\nviscosity = \"0.04 Pa s\"\npressure_viscosity = \"22 1/GPa\"\n";

/// The loaded 7205C for a whole revolution and more.
fn text(speed: &str, contact: &str, tables: &str) -> String {
    super::text(speed, contact, tables).replace("duration = \"0.03 s\"", "duration = \"0.3 s\"")
}

fn chosen(text: &str) -> ContactChoice {
    let scenario = read(text);
    let choice = scenario.contact_choice.unwrap();
    println!("{choice:?}");
    let model = scenario.model.unwrap();
    for bearing in &model.rotor.bearings {
        assert_eq!(Fidelity::from(bearing), choice.chosen);
    }
    assert_eq!(model.rotor.bearings, scenario.question.rotor.bearings);
    choice
}

fn difference(choice: &ContactChoice, rung: Fidelity) -> f64 {
    let found = choice
        .cheaper
        .iter()
        .find(|other| other.fidelity == rung)
        .unwrap();
    found.result.as_ref().unwrap().largest()
}

#[test]
fn ball_inertia_is_needed_at_high_speed_only() {
    let auto = "contact = \"auto\"\nmodel_error = 1e-3";
    let slow = chosen(&text("100 rad/s", auto, ""));
    let fast = chosen(&text("3000 rad/s", auto, ""));
    assert_eq!(slow.top, Fidelity::Jones);
    assert!(slow.chosen < Fidelity::Jones && difference(&slow, slow.chosen) <= 1e-3);
    assert_eq!(fast.chosen, Fidelity::Jones);
    // the centrifugal force grows with the square of the speed
    let threefold = chosen(&text("300 rad/s", auto, ""));
    let force = |choice: &ContactChoice| {
        let hertz = choice
            .cheaper
            .iter()
            .find(|level| level.fidelity == Fidelity::Hertz);
        hertz.unwrap().result.as_ref().unwrap().force
    };
    let ratio = force(&threefold) / force(&slow);
    assert!((8.5..9.5).contains(&ratio), "{ratio}");
}

#[test]
fn a_large_motion_needs_more_than_a_frozen_stiffness() {
    let auto = "contact = \"auto\"\nmodel_error = 1e-3";
    let scene = text("300 rad/s", auto, "").replace("5 um", "200 um");
    let choice = chosen(&scene.replace("300 rad/s", "200 rad/s"));
    assert_eq!(choice.chosen, Fidelity::Hertz);
    assert!(difference(&choice, Fidelity::Linear) > 1e-3);
}

/// Four balls under a radial load and no unbalance: the passing balls are all that moves the shaft, and
/// a frozen stiffness knows none of them, however small their force is.
#[test]
fn a_motion_that_the_balls_make_needs_the_balls() {
    let auto = "contact = \"auto\"\nmodel_error = 1e-2";
    let scene = text("50 rad/s", auto, "").replace("eccentricity = \"5 um\"\n", "");
    let scene = scene.replace(
        "catalogue = \"7205C\"\n",
        "catalogue = \"7205C\"\n[bearing.geometry]\nballs = 4\n",
    );
    let choice = chosen(&scene);
    assert_eq!(choice.chosen, Fidelity::Hertz);
    assert!(difference(&choice, Fidelity::Linear) > 0.5);
}

#[test]
fn films_are_considered_where_there_is_oil() {
    let auto = "contact = \"auto\"";
    let scene = text("100 rad/s", auto, "");
    let oiled = scene.replace(
        "catalogue = \"7205C\"\n",
        &format!("catalogue = \"7205C\"\n{OIL}"),
    );
    let choice = chosen(&oiled);
    assert_eq!(
        (choice.top, choice.chosen),
        (Fidelity::JonesFilm, Fidelity::HertzFilm)
    );
    assert_eq!(choice.model_error, 1e-3);
    // where the films are of no account the cheaper laws are
    let loose = chosen(&oiled.replace("\"auto\"", "\"auto\"\nmodel_error = 0.5"));
    assert!(loose.chosen < Fidelity::HertzFilm);
    // one bearing's own word counts
    let dry = oiled.replace("[bearing.oil]", "film = false\n[bearing.oil]");
    assert_eq!(chosen(&dry).top, Fidelity::Jones);
}

#[test]
fn a_given_stiffness_is_never_taken_for_more_than_it_is() {
    let scene = "[shaft]\nmass = \"5 kg\"\nfreedoms = \"radial\"\n[speed]\nconstant = \"200 rad/s\"\n\
                 [[bearing]]\n[bearing.geometry]\nballs = 8\nball_diameter = \"11.9 mm\"\n\
                 pitch_diameter = \"52 mm\"\nradial_clearance = \"0 um\"\n\
                 contact_stiffness = \"1.3e10 N/m^1.5\"\n[model]\ncontact = \"auto\"\n[damping]\n\
                 coefficients = { x = \"200 N s/m\", y = \"200 N s/m\" }\n\
                 [[load]]\nconstant = { y = \"-196 N\" }\n[time]\nduration = \"0.1 s\"\n";
    let choice = chosen(scene);
    assert_eq!(
        (choice.top, choice.chosen),
        (Fidelity::Hertz, Fidelity::Hertz)
    );
}

#[test]
fn the_speeds_of_a_run_up_are_all_looked_at() {
    let auto = "contact = \"auto\"";
    let scene = text("X", auto, "").replace(
        "constant = \"X\"",
        "from = \"100 rad/s\"\nto = \"2500 rad/s\"\nover = \"0.02 s\"",
    );
    let choice = chosen(&scene);
    assert_eq!(choice.speeds, [100.0, 2500.0]);
    assert_eq!(choice.chosen, Fidelity::Jones);
    let worst = &choice.cheaper.last().unwrap().result;
    assert_eq!(worst.as_ref().unwrap().speed, 2500.0);
}

#[test]
fn a_trace_of_balls_rules_out_the_law_without_balls() {
    let auto = "contact = \"auto\"\nmodel_error = 1";
    let choice = chosen(&text("100 rad/s", auto, "[output]\nballs = true\n"));
    assert!(
        choice
            .cheaper
            .iter()
            .all(|level| level.fidelity != Fidelity::Linear)
    );
    assert_eq!(choice.chosen, Fidelity::Hertz);
}
