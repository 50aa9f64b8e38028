//! A study of static questions answers what the scenario with each value written into it does.

use crate::quasi_static::quasi_static;
use crate::scenario::study_file::{StudyFile, parse_study};
use crate::scenario::{self, Format, Scenario};
use crate::study::many::Outcome;
use crate::tests::published::rollers::spherical;
use crate::tests::support::{assert_near, supports};

fn read(thrust: &str) -> Scenario {
    let text = format!(
        "[shaft]\nmass = \"5 kg\"\neccentricity = \"0.01 mm\"\nfreedoms = \"translational\"\n\
         [speed]\nconstant = \"500 rad/s\"\n[[bearing]]\ncatalogue = \"7205C\"\n\
         [model]\ncontact = \"jones\"\n[[load]]\nconstant = {{ y = \"-100 N\", z = \"{thrust}\" }}\n"
    );
    scenario::parse(&text, "standing.toml", Format::Toml).unwrap_or_else(|e| panic!("{e}"))
}

fn study(axis: &str, keep: &str) -> StudyFile {
    let text = format!("base = \"\"\nask = \"bearing\"\n[[axis]]\n{axis}\n{keep}");
    parse_study(&text, Format::Toml, &read("1 kN"), "".as_ref()).unwrap_or_else(|e| panic!("{e}"))
}

/// The answers at all values.
fn answers(study: &StudyFile) -> Vec<Result<Outcome, String>> {
    let points = 0..study.plan.runs().expect("few values");
    points
        .map(|point| study.static_outcome(&study.plan.values(point)))
        .collect()
}

#[test]
fn each_row_is_the_answer_to_the_scenario_with_its_value() {
    let study = study(
        "key = \"load[1].constant.z\"\nvalues = [\"200 N\", \"1 kN\"]",
        "",
    );
    let names: Vec<_> = study.columns.iter().map(|own| own.column.name()).collect();
    for (row, thrust) in answers(&study).into_iter().zip(["200 N", "1 kN"]) {
        let row = row.unwrap();
        let number = |name: &str| {
            let place = names.iter().position(|known| known == name);
            row.numbers[place.expect("a column")]
        };
        let alone = quasi_static(&read(thrust).question).unwrap();
        assert_eq!(number("z_m"), alone.displacement[2]);
        assert_eq!(number("stiffness_tilt_y_N_m_rad"), alone.stiffness[(4, 4)]);
        assert_eq!(number("force_y_N"), alone.force[1]);
        let state = &alone.bearings[0];
        assert_eq!(number("bearing_1_balls_loaded"), state.balls_loaded as f64);
        assert_eq!(number("bearing_1_life_Mrev"), state.life.unwrap());
        let loads = state.balls.iter().map(|ball| ball.inner.load);
        let largest = loads.fold(0.0, f64::max);
        assert_eq!(number("bearing_1_largest_load_inner_N"), largest);
        assert_eq!(row.warnings, alone.warnings);
    }
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
        let study = study(&format!("key = \"{key}\"\nvalues = {list}"), "");
        assert_eq!(study.variables[0].key, key);
        assert!(answers(&study).iter().all(Result::is_ok), "{key}");
    }
}

#[test]
fn by_default_a_bearing_is_looked_at_where_its_balls_are() {
    let study = study("key = \"speed.constant\"\nvalues = [\"500 rad/s\"]", "");
    let row = answers(&study).remove(0).unwrap();
    let alone = quasi_static(&read("1 kN").question).unwrap();
    let balls = &alone.bearings[0].balls;
    assert_eq!((row.around.len(), balls.len()), (12, 12));
    for (place, ball) in row.around.iter().zip(balls) {
        assert_eq!(place.number("azimuth"), ball.azimuth);
        assert!((place.number("deformation") - ball.deformation).abs() < 1e-15);
        assert_eq!(place.number("load_inner"), ball.inner.load);
        assert_eq!(place.number("angle_outer"), ball.outer.angle);
    }
}

#[test]
fn positions_are_even_and_start_on_x() {
    let keep = "[keep]\npositions = 16\n";
    let study = study("key = \"speed.constant\"\nvalues = [\"0 rad/s\"]", keep);
    let around = answers(&study).remove(0).unwrap().around;
    assert_eq!(around.len(), 16);
    let step = std::f64::consts::PI / 8.0;
    for (index, place) in around.iter().enumerate() {
        assert!((place.number("azimuth") - step * index as f64).abs() < 1e-14);
    }
    // the load pulls along -y: the ball at the bottom bears most, its mirror image alike
    let load = |index: usize| around[index].number("load_inner");
    assert!(load(12) > load(4));
    assert!((load(11) / load(13) - 1.0).abs() < 1e-12);
}

/// A radial load bears alike on both rows of a spherical roller bearing; thrust goes through one of them.
#[test]
fn both_rows_are_looked_at_where_nobody_looks_at_rollers() {
    let support = &supports(&[spherical()])[0];
    let thrust = [0.0, -60e-6, 400e-6, 0.0, 0.0];
    for (place, share) in [([0.0, -60e-6, 0.0, 0.0, 0.0], 1.0), (thrust, 0.0)] {
        let rollers = support.around(&place, 0.0, None);
        let positions = support.around(&place, 0.0, Some(15));
        assert_eq!((rollers.len(), positions.len()), (30, 30));
        // the first roller starts on +X, as the positions do
        for (roller, position) in rollers.iter().zip(&positions) {
            assert_eq!(
                (roller.row, roller.position),
                (position.row, position.position)
            );
            assert_near(
                "load",
                position.contact.load_inner,
                roller.contact.load_inner,
                1e-6,
            );
            assert_eq!(position.contact.angle_inner, roller.contact.angle_inner);
        }
        let row = |row: usize| positions.iter().filter(move |place| place.row == row);
        let load = |of| row(of).map(|place| place.contact.load_inner).sum::<f64>();
        assert!(load(1) > 1e3);
        assert_near("second row", load(2), share * load(1), 1e-9 * load(1));
        assert!(row(1).all(|place| place.contact.angle_inner > 0.0));
        assert!(row(2).all(|place| place.contact.angle_inner < 0.0));
    }
}

#[test]
fn a_value_without_an_answer_has_its_error() {
    let study = study(
        "key = \"load[1].constant.z\"\nvalues = [\"1 kN\", \"500 MN\"]",
        "",
    );
    let rows = answers(&study);
    assert!(rows[0].is_ok());
    let error = rows[1].as_ref().unwrap_err();
    assert!(error.contains("no static equilibrium"), "{error}");
}
