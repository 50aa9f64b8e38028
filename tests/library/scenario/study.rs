//! A study answers the same question as the scenario with each value written into it.

use crate::quasi_static::quasi_static;
use crate::scenario::{self, Format, Scenario};

fn read(thrust: &str, tables: &str) -> Scenario {
    let text = format!(
        "[shaft]\nmass = \"5 kg\"\neccentricity = \"0.01 mm\"\nfreedoms = \"translational\"\n\
         [speed]\nconstant = \"500 rad/s\"\n[[bearing]]\ncatalogue = \"7205C\"\n\
         [model]\ncontact = \"jones\"\n[[load]]\nconstant = {{ y = \"-100 N\", z = \"{thrust}\" }}\n\
         {tables}"
    );
    scenario::parse(&text, "study.toml", Format::Toml).unwrap_or_else(|e| panic!("{e}"))
}

fn values(tables: &str) -> Vec<f64> {
    let study = read("1 kN", tables).study.unwrap();
    study.points.iter().map(|point| point.value).collect()
}

#[test]
fn each_row_is_the_answer_to_the_scenario_with_its_value() {
    let list = "[study]\nvary = \"load[1].constant.z\"\nvalues = [\"200 N\", \"1 kN\"]\n";
    let rows = read("400 N", list).study.unwrap().run().unwrap();
    for (row, thrust) in rows.iter().zip(["200 N", "1 kN"]) {
        let alone = quasi_static(&read(thrust, "").question).unwrap();
        assert_eq!(row.answer, alone);
    }
}

#[test]
fn evenly_spaced_values_have_the_given_ends() {
    let range =
        "[study]\nvary = \"load[1].constant.z\"\nfrom = \"0.2 kN\"\nto = \"1 kN\"\ncount = 5\n";
    assert_eq!(values(range), [200.0, 400.0, 600.0, 800.0, 1000.0]);
    let down =
        "[study]\nvary = \"speed.constant\"\nfrom = \"60 rpm\"\nto = \"0 rad/s\"\ncount = 2\n";
    assert_eq!(values(down), [2.0 * std::f64::consts::PI, 0.0]);
}

#[test]
fn any_number_varies_also_one_that_is_not_written() {
    for (key, list) in [
        ("shaft.eccentricity", "[\"1 um\", \"10 um\"]"),
        ("bearing[1].preload", "[\"100 N\"]"),
        ("bearing[1].geometry.balls", "[10, 12]"),
        ("bearing[1].geometry.groove_factor_inner", "[0.515, 0.53]"),
        ("static.displacement.x", "[\"1 um\"]"),
    ] {
        let table = format!("[study]\nvary = \"{key}\"\nvalues = {list}\n");
        let study = read("1 kN", &table).study.unwrap();
        assert_eq!(study.variable.key, key);
        assert!(study.run().is_ok(), "{key}");
    }
}

#[test]
fn by_default_a_bearing_is_looked_at_where_its_balls_are() {
    let list = "[study]\nvary = \"speed.constant\"\nvalues = [\"1000 rad/s\"]\n";
    let rows = read("1 kN", list).study.unwrap().run().unwrap();
    let (around, state) = (&rows[0].around[0], &rows[0].answer.bearings[0]);
    assert_eq!(around.len(), 12);
    for (place, ball) in around.iter().zip(&state.balls) {
        assert_eq!(place.azimuth, ball.azimuth);
        assert!((place.deformation - ball.deformation).abs() < 1e-15);
        assert_eq!(place.contact.load_inner, ball.inner.load);
        assert_eq!(place.contact.angle_outer, ball.outer.angle);
    }
}

#[test]
fn positions_are_even_and_start_on_x() {
    let list = "[study]\nvary = \"speed.constant\"\nvalues = [\"0 rad/s\"]\npositions = 16\n";
    let rows = read("1 kN", list).study.unwrap().run().unwrap();
    let around = &rows[0].around[0];
    assert_eq!(around.len(), 16);
    let step = std::f64::consts::PI / 8.0;
    for (index, place) in around.iter().enumerate() {
        assert!((place.azimuth - step * index as f64).abs() < 1e-14);
    }
    // the load pulls along -y: the ball at the bottom bears most, its mirror image alike
    let load = |index: usize| around[index].contact.load_inner;
    assert!(load(12) > load(4));
    assert!((load(11) / load(13) - 1.0).abs() < 1e-12);
}

#[test]
fn the_echo_of_a_study_is_the_same_study() {
    let list = "[study]\nvary = \"bearing[1].preload\"\nvalues = [\"10 N\", \"20 N\"]\n";
    let original = read("1 kN", list);
    let echo = original.echo.to_string();
    let again = scenario::parse(&echo, "study.json", Format::Json).unwrap();
    assert_eq!(again.study, original.study);
}

#[test]
fn a_value_without_an_answer_is_named() {
    let list = "[study]\nvary = \"load[1].constant.z\"\nvalues = [\"1 kN\", \"500 MN\"]\n";
    let error = read("1 kN", list).study.unwrap().run().unwrap_err();
    let message = error.to_string();
    assert!(
        message.starts_with("load[1].constant.z = 500000 kN: no static equilibrium"),
        "{message}"
    );
}
