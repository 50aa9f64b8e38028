//! Fits: twins whose values are known, pulls of noisy ones, what cannot be told, balancing in closed form.

use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use nalgebra::{Complex, Matrix2, Vector2};

use crate::ask::FitQuestion;
use crate::fit::{
    Effort, Fit, NoAnswer, Number, Observation, Point, Problem, Unknown, Wanted, Work,
};
use crate::rotor::load::SplitMix64;
use crate::scenario::fit_file::{FitFile, parse_fit};
use crate::scenario::{Format, Scenario};
use crate::study::Variable;

/// A fit of a scene, whose texts are TOML.
fn file(scene: &str, fit: &str) -> FitFile {
    let scenario = Scenario::from_toml(scene).expect("a scenario");
    let text = format!("base = \"-\"\n{fit}");
    let read = parse_fit(&text, Format::Toml, &scenario, Path::new(""));
    read.unwrap_or_else(|error| panic!("{}", error.render(false)))
}

/// What is computed at values of the unknowns.
fn computed(file: &FitFile, values: &[f64]) -> Vec<f64> {
    let stop = AtomicBool::new(false);
    let answers = (0..file.questions()).map(|place| {
        let question = file.question(place, values, Effort::Full).expect("a scene");
        question.answer(None, &stop).expect("an answer")
    });
    let answers: Vec<_> = answers.collect();
    let number =
        |(place, wanted): &(usize, Wanted)| answers[*place].number(wanted).expect("a number").value;
    file.readings.iter().map(number).collect()
}

/// The file with what is computed at values as what was measured, to a per cent.
fn twin(mut file: FitFile, truth: &[f64]) -> FitFile {
    let numbers = computed(&file, truth);
    for (observation, number) in file.observations.iter_mut().zip(numbers) {
        observation.measured = number;
        observation.sigma = Some(if observation.wraps {
            0.01
        } else {
            0.01 * number.abs()
        });
    }
    file
}

/// Errors of the fitted values, in parts of their ranges.
fn errors(file: &FitFile, truth: &[f64]) -> Vec<f64> {
    let question = FitQuestion::new(file, Some(2));
    let found = question.answer(&AtomicBool::new(false), &AtomicU64::new(0));
    let document = found.expect("a fit").document;
    let values = document["unknowns"].as_array().expect("values");
    let pairs = values.iter().zip(truth).zip(&file.unknowns);
    let error = |((value, truth), unknown): ((&serde_json::Value, &f64), &Unknown)| {
        (value["value"].as_f64().expect("a value") - truth) / unknown.length()
    };
    pairs.map(error).collect()
}

#[track_caller]
fn check_twin(scene: &str, fit: &str, truth: &[f64], allowed: f64) {
    let file = twin(file(scene, fit), truth);
    let errors = errors(&file, truth);
    assert!(
        errors.iter().all(|error| error.abs() < allowed),
        "{errors:?}"
    );
}

/// A shaft on two deep groove bearings under a belt.
const FAN: &str = "[shaft]\nmass = \"8 kg\"\neccentricity = \"8 um\"\nfreedoms = \"radial\"\ngravity = true\n\
    [speed]\nconstant = \"1500 rpm\"\n\
    [[bearing]]\ncatalogue = \"6205\"\n[bearing.geometry]\ndiametral_clearance = \"10 um\"\n\
    [damping]\nratio = 0.03\n[[load]]\nconstant = { x = \"400 N\" }\n\
    [model]\ncage = \"rolling\"\n[time]\nduration = \"1 s\"\n";

#[test]
fn a_clearance_is_found_from_static_stiffness() {
    let fit = "[[unknown]]\nkey = \"bearing[1].geometry.diametral_clearance\"\nfrom = \"2 um\"\nto = \"30 um\"\nstart = \"25 um\"\n\
        [[observation]]\nnumber = \"stiffness_x_N_m\"\nvalue = \"1 N/m\"\nsigma = \"1 N/m\"\n\
        [[observation]]\nnumber = \"x_m\"\nvalue = \"1 m\"\nsigma = \"1 m\"\n";
    check_twin(FAN, fit, &[13e-6], 1e-9);
}

#[test]
fn clearance_and_damping_are_found_from_lines() {
    let line = |channel: &str, line: &str| {
        format!(
            "[[observation]]\nchannel = \"{channel}\"\nline = \"{line}\"\namplitude = \"1 um\"\nsigma = \"1 um\"\n"
        )
    };
    let lines = [("x", "1x"), ("y", "1x"), ("x", "BPFO"), ("y", "BPFO")];
    let lines: String = lines
        .iter()
        .map(|(channel, name)| line(channel, name))
        .collect();
    let fit = format!(
        "starts = 1\n[[unknown]]\nkey = \"bearing[1].geometry.diametral_clearance\"\nfrom = \"6 um\"\nto = \"20 um\"\nstart = \"14 um\"\n\
         [[unknown]]\nkey = \"damping.ratio\"\nfrom = 0.01\nto = 0.1\n{lines}"
    );
    check_twin(FAN, &fit, &[11e-6, 0.025], 1e-4);
}

#[test]
fn observations_that_cannot_be_weighed_are_refused() {
    let scenario = Scenario::from_toml(FAN).expect("a scenario");
    let read = |amplitude: &str, others: &str| {
        let text = format!(
            "base = \"-\"\n[[unknown]]\nkey = \"damping.ratio\"\nfrom = 0.01\nto = 0.1\n\
             [[observation]]\nchannel = \"y\"\nline = \"1x\"\namplitude = \"{amplitude}\"\n{others}\n"
        );
        let read = parse_fit(&text, Format::Toml, &scenario, Path::new(""));
        read.map(|file| file.observations[0].clone())
    };
    for (amplitude, others, sigma) in [
        ("1 mm/s", "sigma = \"50 %\"", 0.5e-3),
        ("1 mm/s", "sigma = \"0.1 mm/s\"", 1e-4),
        ("0 um", "sigma = \"2 um\"", 2e-6),
    ] {
        let found = read(amplitude, others).map(|own| own.sigma);
        let found = found.unwrap_or_else(|error| panic!("{}", error.render(false)));
        assert!((found.unwrap() / sigma - 1.0).abs() < 1e-12, "{found:?}");
    }
    for (amplitude, others) in [
        ("-1 um", "sigma = \"50 %\""),
        ("0 um", "phase = \"10 deg\""),
        ("1 um", "sigma = 0.1"),
        ("1 um", "sigma = \"0 %\""),
        ("1 um", "sigma = \"-1 %\""),
        ("1 um", "sigma = \"1 mm/s\""),
    ] {
        assert!(read(amplitude, others).is_err(), "{amplitude} {others}");
    }
    let set = "sigma = \"50 %\"\nset = [{ key = \"speed.constant\", value = \"900 rpm\" }]";
    let name = |others: &str| read("1 um", others).expect("a fit").name;
    assert_ne!(name("sigma = \"50 %\""), name(set));
}

/// A pair with a preload, on a shaft that tilts.
const PAIR: &str = "[shaft]\nmass = \"5 kg\"\nfreedoms = \"all\"\neccentricity = \"0.5 um\"\ninertia_transverse = \"0.02 kg m^2\"\n\
    inertia_polar = \"0.01 kg m^2\"\n[speed]\nconstant = \"500 rad/s\"\n\
    [[bearing]]\ncatalogue = \"7205C\"\nposition = \"-20 mm\"\npreload = \"200 N\"\n\
    [[bearing]]\ncatalogue = \"7205C\"\nposition = \"20 mm\"\nfacing = \"-z\"\n\
    [damping]\nratio = 0.02\n[time]\nduration = \"0.1 s\"\n";

#[test]
fn a_preload_is_found_from_natural_frequencies() {
    let fit = "[[unknown]]\nkey = \"bearing[1].preload\"\nfrom = \"50 N\"\nto = \"800 N\"\nstart = \"700 N\"\n\
        [[observation]]\nnumber = \"natural_frequency_1_Hz\"\nvalue = \"1 Hz\"\nsigma = \"1 Hz\"\n\
        [[observation]]\nnumber = \"natural_frequency_5_Hz\"\nvalue = \"1 Hz\"\nsigma = \"1 Hz\"\n";
    check_twin(PAIR, fit, &[230.0], 1e-9);
}

/// A bearing of constant stiffness in a housing on springs.
const HOUSED: &str = "[shaft]\nmass = \"6 kg\"\nfreedoms = \"radial\"\n[speed]\nconstant = \"3000 rpm\"\n\
    [[unbalance]]\namount = \"60 g mm\"\nangle = \"40 deg\"\n\
    [[bearing]]\ncatalogue = \"7205C\"\npreload = \"300 N\"\nposition = \"0 mm\"\n\
    [bearing.housing]\nmass = \"10 kg\"\nstiffness = { x = \"40 N/um\", y = \"60 N/um\" }\ndamping = { x = \"400 N s/m\", y = \"400 N s/m\" }\n\
    [damping]\nratio = 0.02\n[model]\ncage = \"rolling\"\n[time]\nduration = \"1 s\"\n";

#[test]
fn balancing_finds_amount_and_angle_and_the_mass_against_them() {
    let (amount, angle) = (85e-6, 250f64.to_radians());
    let fit = "[[unknown]]\nkey = \"unbalance[1].amount\"\nfrom = \"0 g mm\"\nto = \"200 g mm\"\n\
        [[unknown]]\nkey = \"unbalance[1].angle\"\nfrom = \"0 deg\"\nto = \"360 deg\"\n\
        [[correction]]\nunbalance = 1\nradius = \"50 mm\"\n\
        [[observation]]\nchannel = \"x\"\nline = \"1x\"\namplitude = \"1 um\"\nphase = \"0 deg\"\nsigma = \"1 um\"\nphase_sigma = \"1 deg\"\n";
    let file = twin(file(LINEAR, fit), &[amount, angle]);
    let errors = errors(&file, &[amount, angle]);
    assert!(errors.iter().all(|error| error.abs() < 1e-9), "{errors:?}");
    let balance = file.balance(&[amount, angle])[0];
    assert!((balance.mass / 1.7e-3 - 1.0).abs() < 1e-12);
    assert!((balance.angle.to_degrees() - 70.0).abs() < 1e-9);
}

/// A shaft on two bearings of constant stiffness, with unbalances in two planes.
const LINEAR: &str = "[shaft]\nmass = \"10 kg\"\nfreedoms = \"all\"\ninertia_transverse = \"0.2 kg m^2\"\n\
    inertia_polar = \"0.05 kg m^2\"\n[speed]\nconstant = \"1500 rpm\"\n\
    [[unbalance]]\namount = \"50 g mm\"\nangle = \"30 deg\"\nposition = \"-100 mm\"\n\
    [[unbalance]]\namount = \"50 g mm\"\nangle = \"0 deg\"\nposition = \"150 mm\"\n\
    [[element]]\nposition = \"-200 mm\"\n[element.linear]\nstiffness = { x = \"2 N/um\", y = \"3 N/um\", z = \"1 N/um\" }\ndamping = { x = \"300 N s/m\", y = \"300 N s/m\", z = \"100 N s/m\" }\n\
    [[element]]\nposition = \"220 mm\"\n[element.linear]\nstiffness = { x = \"2.5 N/um\", y = \"2 N/um\" }\ndamping = { x = \"200 N s/m\", y = \"400 N s/m\" }\n\
    [time]\nduration = \"1 s\"\n";

#[test]
fn balancing_in_two_planes_agrees_with_influence_coefficients() {
    let keys = (1..=2).map(|plane| {
        format!(
            "[[unknown]]\nkey = \"unbalance[{plane}].amount\"\nfrom = \"0 g mm\"\nto = \"200 g mm\"\n\
             [[unknown]]\nkey = \"unbalance[{plane}].angle\"\nfrom = \"0 deg\"\nto = \"360 deg\"\n"
        )
    });
    let seen = ["x", "tilt_y"].map(|channel| {
        let unit = if channel == "x" { "um" } else { "urad" };
        format!(
            "[[observation]]\nchannel = \"{channel}\"\nline = \"1x\"\namplitude = \"1 {unit}\"\nphase = \"0 deg\"\n\
             sigma = \"1 {unit}\"\nphase_sigma = \"1 deg\"\n"
        )
    });
    let fit = format!("starts = 6\n{}{}", keys.collect::<String>(), seen.concat());
    let mut file = file(LINEAR, &fit);
    let response = |values: &[f64]| {
        let found = computed(&file, values);
        Vector2::new(
            Complex::from_polar(found[0], found[1]),
            Complex::from_polar(found[2], found[3]),
        )
    };
    // what one unbalance in each plane makes, per kg m
    let unit = 1e-5;
    let influence = Matrix2::from_columns(&[
        response(&[unit, 0.0, 0.0, 0.0]) / Complex::from(unit),
        response(&[0.0, 0.0, unit, 0.0]) / Complex::from(unit),
    ]);
    // measured amplitudes and phases that no truth is known of
    let measured = [(0.7e-6, 0.7), (1.5e-6, -2.1)];
    for (place, (amplitude, phase)) in measured.iter().enumerate() {
        for (observation, value) in file.observations[2 * place..]
            .iter_mut()
            .zip([amplitude, phase])
        {
            observation.measured = *value;
            observation.sigma = Some(if observation.wraps {
                0.02
            } else {
                0.02 * value
            });
        }
    }
    let seen = Vector2::from_iterator(
        measured.map(|(amplitude, phase)| Complex::from_polar(amplitude, phase)),
    );
    let closed = influence.lu().solve(&seen).expect("planes that differ");
    let truth = closed
        .iter()
        .flat_map(|own| [own.norm(), own.arg().rem_euclid(std::f64::consts::TAU)]);
    let truth: Vec<f64> = truth.collect();
    assert!(truth[0] < 2e-4 && truth[2] < 2e-4, "{truth:?}");
    let errors = errors(&file, &truth);
    assert!(errors.iter().all(|error| error.abs() < 1e-9), "{errors:?}");
}

#[test]
fn the_stiffness_of_a_housing_is_found_from_lines() {
    let fit = "starts = 1\n[[unknown]]\nkey = \"bearing[1].housing.stiffness.x\"\nfrom = \"20 N/um\"\nto = \"100 N/um\"\n\
        [[observation]]\nchannel = \"housing1_x\"\nline = \"1x\"\namplitude = \"1 mm/s\"\nsigma = \"1 mm/s\"\n\
        [[observation]]\nnumber = \"housing1_x_velocity_rms_m_s\"\nvalue = \"1 mm/s\"\nsigma = \"1 mm/s\"\n";
    check_twin(HOUSED, fit, &[52e6], 1e-5);
}

#[test]
fn what_a_frequency_alone_cannot_tell_is_named() {
    let scene = LINEAR.replace("freedoms = \"all\"", "freedoms = \"radial\"");
    let fit = "[[unknown]]\nkey = \"shaft.mass\"\nfrom = \"5 kg\"\nto = \"15 kg\"\nstart = \"9 kg\"\n\
        [[unknown]]\nkey = [\"element[1].linear.stiffness.x\", \"element[2].linear.stiffness.x\"]\nfrom = \"1 N/um\"\nto = \"4 N/um\"\n\
        [[observation]]\nnumber = \"natural_frequency_1_Hz\"\nvalue = \"100 Hz\"\nsigma = \"1 Hz\"\n\
        [[observation]]\nnumber = \"natural_frequency_1_Hz\"\nvalue = \"100 Hz\"\nsigma = \"1 Hz\"\nset = [{ key = \"speed.constant\", value = \"900 rpm\" }]\n";
    let file = twin(file(&scene, fit), &[10.0, 2e6]);
    let question = FitQuestion::new(&file, Some(2));
    let found = question
        .answer(&AtomicBool::new(false), &AtomicU64::new(0))
        .expect("a fit");
    let combination = &found.document["not_identified"][0];
    let change = |part: usize| combination[part]["change"].as_f64().expect("a change");
    // k/m stays as it is: both grow together, by equal parts
    let (mass, stiffness) = match combination[0]["key"] == "shaft.mass" {
        true => (change(0), change(1)),
        false => (change(1), change(0)),
    };
    let values = &found.document["unknowns"];
    let value = |place: usize| values[place]["value"].as_f64().expect("a value");
    let parts = [mass / value(0), stiffness / value(1)];
    assert!((parts[0] / parts[1] - 1.0).abs() < 1e-3, "{parts:?}");
    assert!(
        found
            .warnings()
            .any(|warning| warning.starts_with("not identified: "))
    );
}

/// A bearing under a load with a spall on its outer race, whose only forcing is that of the balls that pass.
const SPALLED: &str = "[shaft]\nmass = \"6 kg\"\nfreedoms = \"radial\"\ngravity = true\n[speed]\nconstant = \"1797 rpm\"\n\
    [[bearing]]\ncatalogue = \"6205\"\n[[bearing.defect]]\non = \"outer\"\nangle = \"-90 deg\"\nlength = \"0.4 mm\"\n\
    depth = \"0.28 mm\"\n[damping]\ncoefficients = { x = \"500 N s/m\", y = \"500 N s/m\" }\n\
    [[load]]\nconstant = { y = \"-300 N\" }\n[model]\ncage = \"rolling\"\n\
    [time]\nduration = \"0.15 s\"\nsettle = \"0.05 s\"\n";

/// The length of a spall as the unknown of a single search.
const LENGTH: &str = "starts = 1\n[[unknown]]\nkey = \"bearing[1].defect[1].length\"\nfrom = \"0.2 mm\"\nto = \"1 mm\"\n";

#[test]
fn the_length_of_a_spall_is_found_from_lines() {
    let lines = ["BPFO", "2xBPFO", "3xBPFO"].map(|line| {
        format!(
            "[[observation]]\nchannel = \"y\"\nline = \"{line}\"\namplitude = \"1 um\"\nsigma = \"1 um\"\n"
        )
    });
    check_twin(
        SPALLED,
        &format!("{LENGTH}{}", lines.concat()),
        &[0.42e-3],
        1e-5,
    );
}

#[test]
fn the_length_of_a_spall_is_found_from_runs_that_do_not_repeat() {
    // an unbalance beside the passing balls, and a start that dies out
    let scene = SPALLED.replace("gravity", "eccentricity = \"4 um\"\ngravity");
    let numbers = ["y_rms_m", "x_peak_to_peak_m"].map(|number| {
        format!(
            "[[observation]]\nask = \"run\"\nnumber = \"{number}\"\nvalue = \"1 um\"\nsigma = \"1 um\"\n"
        )
    });
    check_twin(
        &scene,
        &format!("{LENGTH}{}", numbers.concat()),
        &[0.42e-3],
        1e-5,
    );
}

/// Numbers of a normal distribution.
fn normal(seed: u64) -> impl Fn(usize) -> f64 {
    let random = SplitMix64::new(seed);
    move |k| {
        let [radius, angle] = [0, 1].map(|part| random.uniform(2 * k as u64 + part));
        (-2.0 * (1.0 - radius).ln()).sqrt() * (std::f64::consts::TAU * angle).cos()
    }
}

/// Mean within 0.15 of 0, and spread from 0.9 to 1.1.
#[track_caller]
fn check_pulls(pulls: &[f64]) {
    let count = pulls.len() as f64;
    let mean = pulls.iter().sum::<f64>() / count;
    let square: f64 = pulls.iter().map(|pull| (pull - mean).powi(2)).sum();
    let spread = (square / count).sqrt();
    assert!(
        mean.abs() < 0.15 && (0.9..1.1).contains(&spread),
        "{mean} {spread}"
    );
}

#[test]
fn pulls_of_noisy_machines_are_those_of_a_normal_distribution() {
    const SEEDS: u64 = 200;
    let truth = [13e-6, 430.0];
    let numbers = ["x_m", "y_m", "stiffness_x_N_m", "stiffness_y_N_m"].map(|number| {
        let unit = if number.starts_with('s') { "N/m" } else { "m" };
        format!(
            "[[observation]]\nnumber = \"{number}\"\nvalue = \"1 {unit}\"\nsigma = \"1 {unit}\"\n"
        )
    });
    let fit = format!(
        "starts = 1\n[[unknown]]\nkey = \"bearing[1].geometry.diametral_clearance\"\nfrom = \"2 um\"\nto = \"30 um\"\n\
         [[unknown]]\nkey = \"load[1].constant.x\"\nfrom = \"200 N\"\nto = \"800 N\"\n{}",
        numbers.concat()
    );
    let exact = twin(file(FAN, &fit), &truth);
    let pulls = (0..SEEDS).map(|seed| {
        let (mut noisy, noise) = (exact.clone(), normal(seed));
        for (k, observation) in noisy.observations.iter_mut().enumerate() {
            observation.measured += observation.sigma.expect("a deviation") * noise(k);
        }
        let found = FitQuestion::new(&noisy, Some(2))
            .answer(&AtomicBool::new(false), &AtomicU64::new(0))
            .expect("a fit");
        let number = |place: usize, key: &str| {
            let found = &found.document["unknowns"][place][key];
            found.as_f64().expect("a number")
        };
        [0, 1]
            .map(|place| (number(place, "value") - truth[place]) / number(place, "standard_error"))
    });
    let pulls: Vec<[f64; 2]> = pulls.collect();
    for place in [0, 1] {
        check_pulls(&pulls.iter().map(|pull| pull[place]).collect::<Vec<_>>());
    }
}

/// A decay `a e^(−b t)` seen at eight times, with noise of a known size, as a problem without a machine, which is stopped after so
/// many answers.
fn decay(seed: u64, most: u64) -> Fit {
    const TRUTH: [f64; 2] = [3.0, 0.8];
    let times: Vec<f64> = (0..8).map(|k| 0.4 * f64::from(k)).collect();
    let value = |values: &[f64], time: f64| values[0] * (-values[1] * time).exp();
    let normal = normal(seed);
    let (stop, answered) = (AtomicBool::new(false), AtomicU64::new(0));
    let observations: Vec<Observation> = times
        .iter()
        .enumerate()
        .map(|(k, time)| Observation {
            name: String::new(),
            unit: String::new(),
            measured: value(&TRUTH, *time) + 0.05 * normal(k),
            sigma: Some(0.05),
            wraps: false,
        })
        .collect();
    let variable = |key: &str| Variable {
        key: key.to_owned(),
        unit: String::new(),
        shown_unit: String::new(),
        shown_size: 1.0,
        words: Vec::new(),
    };
    let unknowns = [("a", [1.0, 6.0]), ("b", [0.1, 3.0])].map(|(key, range)| Unknown {
        variable: variable(key),
        range,
        start: 0.5 * (range[0] + range[1]),
        wraps: false,
    });
    let scene = |values: &[f64], _: Option<&Point>, _: Effort| -> Result<Point, NoAnswer> {
        if answered.fetch_add(1, Ordering::Relaxed) >= most {
            stop.store(true, Ordering::Relaxed);
            return Err(NoAnswer::Stopped);
        }
        let number = |time: &f64| Number {
            name: String::new(),
            unit: String::new(),
            value: value(values, *time),
            error: 0.0,
        };
        Ok(Point {
            numbers: times.iter().map(number).collect(),
            orbits: Vec::new(),
        })
    };
    let problem = Problem {
        unknowns: &unknowns,
        observations: &observations,
        scene: &scene,
        starts: 1,
        work: Work {
            threads: 1,
            stop: &stop,
        },
    };
    problem.fit().expect("a fit")
}

#[test]
fn pulls_of_noisy_twins_are_those_of_a_normal_distribution() {
    for (unknown, truth) in [3.0, 0.8].into_iter().enumerate() {
        let pulls = (0..200).map(|seed| {
            let fit = decay(seed, u64::MAX);
            (fit.values[unknown] - truth) / fit.errors[unknown]
        });
        check_pulls(&pulls.collect::<Vec<_>>());
    }
    // nearly a parabola, a standard error from the minimum one above it
    let profile = &decay(0, u64::MAX).profiles[0];
    let ones = profile
        .points
        .iter()
        .filter(|point| (0.8..1.25).contains(&point[1]));
    assert_eq!(ones.count(), 2, "{profile:?}");
}

#[test]
fn a_search_that_is_stopped_tells_the_errors_that_it_knows() {
    let whole = decay(0, u64::MAX);
    let stopped = decay(0, 8);
    assert!(!stopped.is_complete);
    for (error, known) in stopped.errors.iter().zip(&whole.errors) {
        assert!((error / known - 1.0).abs() < 0.5, "{error} {known}");
    }
    assert_eq!(stopped.minima[0].values, stopped.values);
    // before any slope is known there are none
    assert!(decay(0, 1).errors.iter().all(|error| error.is_nan()));
}
