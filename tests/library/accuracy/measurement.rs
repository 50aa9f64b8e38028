//! What the measurement says of a regular, a hard and an irregular scene.

use std::sync::atomic::AtomicBool;

use crate::integrate::Method;
use crate::scenario::{Scenario, methods};
use crate::simulate::{Monitor, SimulateError};
use crate::study::Fidelity;
use crate::study::accuracy::{Accuracy, AccuracyError, Question};

use super::{read, text};

fn measure(scenario: &Scenario, methods: &[Method], tolerances: &[f64]) -> Accuracy {
    try_measure(scenario, methods, tolerances, false).unwrap()
}

fn try_measure(
    scenario: &Scenario,
    chosen: &[Method],
    tolerances: &[f64],
    stopped: bool,
) -> Result<Accuracy, AccuracyError> {
    let question = Question {
        model: scenario.model.as_ref().unwrap(),
        oils: &scenario.oils,
        methods: chosen,
        tolerances,
        longest: 60.0,
    };
    question.measure(&mut Monitor {
        stop: &AtomicBool::new(stopped),
        progress: &mut |_| {},
    })
}

fn one(name: &str) -> Vec<Method> {
    vec![crate::scenario::method(name).unwrap()]
}

#[test]
fn errors_of_methods_fall_with_the_tolerance_and_work_grows() {
    let scenario = read(&text("500 rad/s", "contact = \"hertz\"", ""));
    let tolerances = [1e-4, 1e-6, 1e-8];
    let accuracy = measure(&scenario, methods(), &tolerances);
    let agreement = &accuracy.agreement;
    assert!(!agreement.irregular);
    assert!(agreement.uncertainty.displacement_relative < 1e-8);
    assert_eq!(accuracy.rows.len(), methods().len() * tolerances.len());
    for rows in accuracy.rows.chunks(tolerances.len()) {
        let measured: Vec<_> = rows.iter().map(|row| row.result.clone().unwrap()).collect();
        for pair in measured.windows(2) {
            let [loose, tight] = [&pair[0].errors, &pair[1].errors];
            println!("{}: {loose:?}", rows[0].method);
            // no error is seen that is below that of the reference itself
            let seen = &agreement.uncertainty;
            let displacement = (0.2 * loose.displacement_relative).max(seen.displacement_relative);
            let force = (0.2 * loose.force_relative).max(seen.force_relative);
            assert!(
                tight.displacement_relative < displacement,
                "{tight:?} {seen:?}"
            );
            assert!(tight.force_relative < force, "{tight:?} {seen:?}");
            // the method left open may go over to one of fewer and dearer evaluations
            let more = pair[1].cost.counters.evaluations > pair[0].cost.counters.evaluations;
            assert!(more || rows[0].method == "auto", "{}", rows[0].method);
        }
        for (row, measured) in rows.iter().zip(&measured) {
            assert!(measured.cost.seconds > 0.0 && measured.cost.repeats >= 1);
            let relative = measured.errors.displacement_relative;
            assert!(
                relative < 10.0 * row.tolerance,
                "{}: {relative}",
                row.method
            );
        }
    }
}

/// the scene as it is written is the highest level here: it differs from itself by nothing.
#[test]
fn lower_rungs_differ_and_a_rung_not_from_itself() {
    let stiffness = "[bearing.geometry]\nballs = 9\nball_diameter = \"7.94 mm\"\npitch_diameter = \"38.5 mm\"\n\
                     radial_clearance = \"0 um\"\ncontact_stiffness = \"8e9 N/m^1.5\"\n";
    let scene = format!(
        "[shaft]\nmass = \"5 kg\"\neccentricity = \"1 um\"\nfreedoms = \"radial\"\n\
         [speed]\nconstant = \"500 rad/s\"\n[[bearing]]\n{stiffness}[damping]\nratio = 0.05\n\
         [[load]]\nconstant = {{ y = \"-300 N\" }}\n[time]\nduration = \"0.05 s\"\n"
    );
    let accuracy = measure(&read(&scene), &one("dop853"), &[1e-6]);
    let rows = &accuracy.ladder.rows;
    let top = rows
        .iter()
        .find(|row| Some(row.configuration) == accuracy.ladder.top);
    let top = top.unwrap();
    let (_, errors) = top.result.as_ref().unwrap();
    assert_eq!(top.configuration.fidelity, Fidelity::Hertz);
    assert_eq!(errors.displacement, 0.0);
    assert_eq!(errors.lines.unwrap_or(0.0), 0.0);
    let linear = rows
        .iter()
        .find(|row| row.configuration.fidelity == Fidelity::Linear);
    let (_, errors) = linear.unwrap().result.as_ref().unwrap();
    assert!(errors.displacement_relative > 1e-2, "{errors:?}");
    let reason = |rung| {
        let row = rows.iter().find(|row| row.configuration.fidelity == rung);
        row.unwrap().result.clone().unwrap_err()
    };
    assert!(reason(Fidelity::HertzFilm).contains("[bearing.oil]"));
    assert!(reason(Fidelity::Jones).contains("both races together"));
}

#[test]
fn the_top_rung_has_all_that_the_file_gives() {
    let oil = "[[bearing]]\ncatalogue = \"7205C\"\n[bearing.oil]\nviscosity = \"0.04 Pa s\"\n\
               pressure_viscosity = \"22 1/GPa\"\n";
    let scene = text("500 rad/s", "contact = \"hertz\"", "");
    let scene = scene.replace("[[bearing]]\ncatalogue = \"7205C\"\n", oil);
    let scene = scene.replace("0.03 s", "0.024 s");
    let accuracy = measure(&read(&scene), &one("dopri5"), &[1e-4]);
    let top = accuracy.ladder.top.unwrap();
    assert_eq!(top.to_string(), "jones + film, operating, translational");
    let written: Vec<_> = accuracy
        .ladder
        .rows
        .iter()
        .filter(|row| row.as_written)
        .collect();
    assert_eq!(written.len(), 1);
    assert_eq!(written[0].configuration.fidelity, Fidelity::Hertz);
    // films part the surfaces: the shaft stands elsewhere, by more than it vibrates
    let (cost, errors) = written[0].result.as_ref().unwrap();
    let (top_cost, _) = accuracy.ladder.rows[0].result.as_ref().unwrap();
    assert!(errors.statistics.mean > 0.1, "{errors:?}");
    assert!(cost.seconds < top_cost.seconds);
}

/// JIS 6306 with 20 µm of radial clearance at 120 rad/s, as in the tests of irregular motion.
#[test]
fn of_an_irregular_motion_statistics_are_compared() {
    let scene = "[shaft]\nmass = \"20 kg\"\nfreedoms = \"radial\"\n[speed]\nconstant = \"120 rad/s\"\n\
                 [[bearing]]\nfirst_ball = \"-90 deg\"\n[bearing.geometry]\nballs = 8\n\
                 ball_diameter = \"11.9062 mm\"\npitch_diameter = \"52 mm\"\nradial_clearance = \"20 um\"\n\
                 contact_stiffness = \"1.334e10 N/m^1.5\"\n[damping]\n\
                 coefficients = { x = \"200 N s/m\", y = \"200 N s/m\" }\n\
                 [[load]]\nconstant = { y = \"-196 N\" }\n[time]\nduration = \"6 s\"\nsettle = \"1 s\"\n";
    let accuracy = measure(&read(scene), &one("dop853"), &[1e-4, 1e-8]);
    let agreement = &accuracy.agreement;
    println!("{agreement:?}");
    assert!(agreement.irregular);
    assert!(agreement.growth > 1e3);
    assert!(agreement.runs >= 4 && agreement.scatter.statistics.rms > 0.0);
    for row in &accuracy.rows {
        let errors = row.result.as_ref().unwrap().errors;
        println!("{:e}: {errors:?}", row.tolerance);
        assert!(errors.displacement_relative > 1e-2, "traces part");
        assert!(errors.statistics.rms < 0.1, "statistics stay");
    }
}

#[test]
fn a_measurement_that_is_stopped_says_so() {
    let scenario = read(&text("500 rad/s", "contact = \"hertz\"", ""));
    let stopped = try_measure(&scenario, methods(), &[1e-6], true);
    assert!(matches!(
        stopped,
        Err(AccuracyError::Simulate(SimulateError::Integrate(_)))
    ));
}

#[test]
fn what_would_take_too_long_is_left_out_with_the_reason() {
    let scenario = read(&text("500 rad/s", "contact = \"hertz\"", ""));
    let question = Question {
        model: scenario.model.as_ref().unwrap(),
        oils: &scenario.oils,
        methods: &one("dop853"),
        tolerances: &[1e-4, 1e-8],
        longest: 1e-9,
    };
    let accuracy = question
        .measure(&mut Monitor {
            stop: &AtomicBool::new(false),
            progress: &mut |_| {},
        })
        .unwrap();
    assert!(accuracy.rows[0].result.is_ok());
    let reason = accuracy.rows[1].result.as_ref().unwrap_err();
    assert!(reason.starts_with("left out: would take about"), "{reason}");
}
