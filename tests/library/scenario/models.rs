//! What the keys of a scenario become in the model.

use std::f64::consts::PI;

use crate::bearing::{ContactLaw, Facing, FreePosition, Geometry, MountedBearing, Preload};
use crate::integrate::Method;
use crate::physics::RaceControl;
use crate::quasi_static::{StaticQuestion, TorsionCause, quasi_static};
use crate::rotor::{Damping, Freedoms, InitialPosition, Load, LoadKind, SpeedPoint};
use crate::scenario::{self, Format, Scenario};
use crate::simulate::{Model, Sampling};

const SMALLEST: &str = "
[shaft]
mass = \"5 kg\"
freedoms = \"translational\"
[speed]
constant = \"3000 rpm\"
[time]
duration = \"100 ms\"
";

fn read(text: &str) -> Scenario {
    scenario::parse(text, "folder/test.toml", Format::Toml).unwrap_or_else(|e| panic!("{e}"))
}

fn model(tables: &str) -> Model {
    read(&format!("{SMALLEST}{tables}")).model.unwrap()
}

const BEARING: &str = "[[bearing]]\ncatalogue = \"7205C\"\n";

#[test]
fn the_smallest_scenario_has_the_documented_defaults() {
    let scenario = read(&format!("{SMALLEST}{BEARING}"));
    assert_eq!(scenario.title, "test");
    assert_eq!(
        scenario.warnings.len(),
        3,
        "undamped, no axial load, no settle time: {:?}",
        scenario.warnings
    );
    let model = scenario.model.unwrap();
    assert_eq!(model.rotor.shaft.freedoms, Freedoms::Translational);
    assert_eq!(model.rotor.shaft.eccentricity, 0.0);
    assert!(!model.rotor.shaft.gravity);
    assert_eq!(model.rotor.speed, 3000.0 * PI / 30.0);
    assert_eq!(model.rotor.damping, Damping::Undamped);
    assert_eq!(model.rotor.initial.from, InitialPosition::Equilibrium);
    assert_eq!((model.duration, model.settle), (0.1, 0.0));
    assert_eq!(model.sampling, Sampling::PerRevolution(128));
    assert_eq!(model.integrator.method, Method::Auto);
    assert_eq!(model.integrator.step_limit, 100_000_000);
    assert!(model.verify && model.spectrum.is_some());
    let bearing = &model.rotor.bearings[0];
    assert_eq!(bearing.law, ContactLaw::Hertz);
    assert_eq!(bearing.facing, Facing::PlusZ);
    assert_eq!(bearing.preload, Preload::AxialOffset(0.0));
}

#[test]
fn single_catalogue_values_can_be_overridden() {
    let geometry = "[bearing.geometry]\ncontact_angle = \"60 deg\"\nballs = 11\n";
    let material = "[bearing.ball_material]\nyoungs_modulus = \"310 GPa\"\n";
    let model = model(&format!("{BEARING}{geometry}{material}"));
    let bearing = &model.rotor.bearings[0].bearing;
    assert_eq!(bearing.geometry.balls(), 11);
    let angle = bearing.geometry.contact_angle();
    assert!((angle - Geometry::LARGEST_CONTACT_ANGLE).abs() < 1e-15);
    assert_eq!(bearing.geometry.ball_diameter(), 7.938 / 1e3);
    assert_eq!(bearing.ball_material.youngs_modulus, 310e9);
    assert_eq!(bearing.ball_material.density, bearing.ring_material.density);
    assert_eq!(bearing.ring_material.youngs_modulus, 207e9);
}

#[test]
fn a_literature_model_needs_no_grooves() {
    let scenario = include_str!("../../../scenarios/varying-compliance-6306.toml");
    let bearing = read(scenario).question.rotor.bearings[0].bearing;
    assert_eq!(bearing.contact_stiffness, Some(1.334e10));
    let clearance = FreePosition::RadialClearance(3e-6);
    let expected = Geometry::new(8, 11.9062 / 1e3, 52.0 / 1e3, clearance, 0.52, 0.52).unwrap();
    assert_eq!(bearing.geometry, expected);
}

#[test]
fn constant_loads_are_taken_as_given() {
    let loads = "[[load]]\nconstant = { y = \"-1 kN\", z = \"5 N\" }\n[[load]]\nconstant = { y = \"1 N\" }\n";
    let expected = [[0.0, -1000.0, 5.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0]];
    assert_eq!(
        model(&format!("{BEARING}{loads}")).rotor.loads,
        expected.map(|parts| Load::constant(parts, 0.0))
    );
}

#[test]
fn a_pair_of_bearings_keeps_its_places() {
    let pair = read(include_str!("../../../scenarios/back-to-back-7205c.toml"))
        .question
        .rotor;
    let places = pair
        .bearings
        .iter()
        .map(|bearing| (bearing.position, bearing.facing));
    assert_eq!(
        places.collect::<Vec<_>>(),
        [(-0.03, Facing::PlusZ), (0.03, Facing::MinusZ)]
    );
    assert!(
        pair.bearings
            .iter()
            .all(|b| b.preload == Preload::Force(200.0))
    );
}

#[test]
fn a_spectrum_that_is_not_wanted_is_not_planned() {
    let scenario = read(&format!(
        "{SMALLEST}{BEARING}[output]\nspectrum = false\nfigures = false\n"
    ));
    assert!(scenario.model.unwrap().spectrum.is_none());
    assert!(
        scenario.output.trace
            && scenario.output.spectrum == Some(false)
            && !scenario.output.figures
    );
}

#[test]
fn whole_numbers_may_be_written_with_an_exponent() {
    let model = model(&format!("{BEARING}[integrator]\nstep_limit = 1e6\n"));
    assert_eq!(model.integrator.step_limit, 1_000_000);
}

/// The first bearing of a scenario without motion.
fn first_bearing(keys: &str, tables: &str) -> MountedBearing {
    static_question(&format!("{BEARING}{keys}{tables}"))
        .rotor
        .bearings[0]
        .clone()
}

fn static_question(tables: &str) -> StaticQuestion {
    let text = format!("{STANDING}{tables}");
    let scenario = read(&text);
    assert!(scenario.model.is_none() && scenario.warnings.is_empty());
    scenario.question
}

/// A shaft that nobody asks to move; no inertia is needed then.
const STANDING: &str = "
[shaft]
mass = \"5 kg\"
freedoms = \"all\"
[speed]
constant = \"500 rad/s\"
";

#[test]
fn without_time_there_is_a_static_question_only() {
    let question = static_question(BEARING);
    assert_eq!(question.displacement, [None; 5]);
    assert!(!question.unbalance && question.torsion.is_none());
}

#[test]
fn a_static_question_and_a_motion_share_the_rotor() {
    let scenario = read(&format!("{SMALLEST}{BEARING}"));
    assert_eq!(scenario.question.rotor, scenario.model.unwrap().rotor);
}

#[test]
fn displacements_and_unbalance_belong_to_the_static_question() {
    let tables =
        "[static]\nunbalance = true\ndisplacement = { z = \"2 um\", tilt_y = \"1 mrad\" }\n";
    let question = static_question(&format!("{BEARING}{tables}"));
    assert!(question.unbalance);
    assert_eq!(
        question.displacement,
        [None, None, Some(2e-6), None, Some(1e-3)]
    );
}

#[test]
fn torsion_has_a_section_and_a_cause() {
    let torsion = |keys: &str| {
        let table = format!("[shaft.torsion]\nlength = \"0.2 m\"\n{keys}");
        static_question(&format!("{BEARING}{table}"))
            .torsion
            .unwrap()
    };
    let round = torsion("diameter = \"20 mm\"\n");
    assert_eq!(round.cause, TorsionCause::Friction);
    assert_eq!((round.length, round.shear_modulus), (0.2, 79.4e9));
    let expected = PI * 0.02f64.powi(4) / 32.0;
    assert!((round.polar_second_moment / expected - 1.0).abs() < 1e-15);
    let moment = torsion("polar_second_moment = \"5 mm^4\"\nmoment = \"2 N m\"\n");
    assert_eq!(moment.cause, TorsionCause::Moment(2.0));
    assert_eq!(moment.polar_second_moment, 5e-12);
    let angle = torsion("diameter = \"20 mm\"\nshear_modulus = \"80 GPa\"\nangle = \"1 mrad\"\n");
    assert_eq!(angle.cause, TorsionCause::Angle(1e-3));
    assert_eq!(angle.shear_modulus, 80e9);
}

#[test]
fn a_bearing_overrides_law_film_and_race_control() {
    let oil = "[bearing.oil]\nviscosity = \"40 mPa s\"\npressure_viscosity = \"22 1/GPa\"\n";
    let jones = "[model]\ncontact = \"jones\"\nfilm = true\nrace_control = \"inner\"\n";
    let bearing = first_bearing("", &format!("{oil}{jones}"));
    assert_eq!(bearing.law, ContactLaw::Jones(RaceControl::Inner));
    let known = bearing.oil.unwrap();
    assert_eq!((known.viscosity, known.pressure_viscosity), (0.04, 22e-9));
    let kinematic = oil.replace("40 mPa s", "20 mm^2/s");
    let known = first_bearing("", &format!("{kinematic}{jones}"))
        .oil
        .unwrap();
    assert!((known.viscosity - 17.4e-3).abs() < 1e-12, "with 870 kg/m^3");

    let keys = "race_control = \"even\"\nfilm = false\n";
    let bearing = first_bearing(keys, &format!("{oil}{jones}"));
    assert_eq!(bearing.law, ContactLaw::Jones(RaceControl::Even));
    assert_eq!(
        bearing.oil, None,
        "oil without film is known but parts nothing"
    );

    let bearing = first_bearing("contact = \"jones\"\n", "");
    assert_eq!(bearing.law, ContactLaw::Jones(RaceControl::Outer));
}

#[test]
fn a_bearing_has_surfaces_shoulders_and_ratings() {
    let bearing = first_bearing("", "").bearing;
    assert_eq!(bearing.dynamic_rating, Some(16_600.0));
    assert_eq!((bearing.roughness, bearing.shoulder_angle), (None, None));
    let keys = "film = true\nroughness = \"0.1 um\"\nshoulder_angle = \"36 deg\"\ndynamic_rating = \"20 kN\"\n";
    let bearing = first_bearing(keys, "[bearing.oil]\nviscosity = \"0.04 Pa s\"\n").bearing;
    assert_eq!(bearing.dynamic_rating, Some(20_000.0));
    assert_eq!(bearing.roughness, Some(0.1 / 1e6));
    assert!((bearing.shoulder_angle.unwrap() - PI / 5.0).abs() < 1e-15);
}

#[test]
fn fits_and_temperature_change_the_clearance() {
    let free = first_bearing("", "").bearing.geometry;
    let tight = first_bearing("clearance_change = \"-5 um\"\n", "")
        .bearing
        .geometry;
    assert_eq!(tight, free.with_clearance_change(-5e-6).unwrap());
    assert!(tight.contact_angle() < free.contact_angle());
}

#[test]
fn a_preload_is_an_offset_a_force_or_a_spring() {
    let preload = |key: &str| first_bearing(key, "").preload;
    assert_eq!(
        preload("axial_offset = \"5 um\"\n"),
        Preload::AxialOffset(5e-6)
    );
    assert_eq!(preload("preload = \"5 N\"\n"), Preload::Force(5.0));
    assert_eq!(preload("spring_preload = \"5 N\"\n"), Preload::Spring(5.0));
}

/// Position and facing of both bearings of a set 20 mm apart about 5 mm.
fn set(keys: &str) -> Vec<(f64, Facing)> {
    let keys = format!("{BEARING}position = \"5 mm\"\nspacing = \"20 mm\"\n{keys}");
    let bearings = static_question(&keys).rotor.bearings;
    bearings.iter().map(|b| (b.position, b.facing)).collect()
}

#[test]
fn a_set_is_two_bearings_about_its_position() {
    let (low, high) = (-0.005, 0.015);
    let (plus, minus) = (Facing::PlusZ, Facing::MinusZ);
    assert_eq!(
        set("arrangement = \"back-to-back\"\n"),
        [(low, plus), (high, minus)]
    );
    assert_eq!(
        set("arrangement = \"face-to-face\"\n"),
        [(low, minus), (high, plus)]
    );
    assert_eq!(
        set("arrangement = \"tandem\"\n"),
        [(low, plus), (high, plus)]
    );
    let tandem = set("arrangement = \"tandem\"\nfacing = \"-z\"\n");
    assert_eq!(tandem, [(low, minus), (high, minus)]);
}

#[test]
fn a_set_back_to_back_resists_tilting_more_than_face_to_face() {
    let tilt = |arrangement: &str| {
        let keys =
            format!("arrangement = \"{arrangement}\"\nspacing = \"20 mm\"\npreload = \"200 N\"\n");
        let question = static_question(&format!("{BEARING}{keys}"));
        quasi_static(&question).unwrap().stiffness[(3, 3)]
    };
    // moment arms of the contact lines about the middle: d_m/2 tan α ± spacing/2
    let (back, face) = (tilt("back-to-back"), tilt("face-to-face"));
    assert!(back > 5.0 * face, "{back} against {face}");
}

fn with_speed(speed: &str) -> Model {
    let text = SMALLEST.replace("constant = \"3000 rpm\"", speed);
    read(&format!("{text}{BEARING}")).model.unwrap()
}

#[test]
fn a_ramp_and_a_profile_of_the_same_speeds_are_the_same() {
    let ramp = "from = \"10 rad/s\"\nto = \"50 rad/s\"\nover = \"2 s\"";
    let profile = "profile = [{ at = \"0 s\", speed = \"10 rad/s\" }, \
                   { at = \"2 s\", speed = \"50 rad/s\" }]";
    let [ramp, profile] = [ramp, profile].map(with_speed);
    assert_eq!(ramp.rotor.speed, 10.0);
    let end = SpeedPoint {
        time: 2.0,
        speed: 50.0,
    };
    assert_eq!(ramp.rotor.speed_points, [end]);
    assert_eq!(ramp, profile);
}

#[test]
fn a_force_at_a_place_is_a_moment_where_the_tilts_move() {
    let text = SMALLEST.replace(
        "\"translational\"",
        "\"all\"\ninertia_transverse = \"1 g m^2\"\ninertia_polar = \"1 g m^2\"",
    );
    let loads = "[[load]]\nconstant = { x = \"10 N\", y = \"20 N\" }\nposition = \"50 mm\"\n\
                 [[load]]\nshock = { peak = { y = \"1 kN\" }, duration = \"1 ms\" }\nposition = \"-1 m\"\n";
    let rotor = read(&format!("{text}{BEARING}{loads}"))
        .model
        .unwrap()
        .rotor;
    let [constant, shock] = &rotor.loads[..] else {
        panic!("{:?}", rotor.loads);
    };
    assert_eq!(
        *constant,
        Load::constant([10.0, 20.0, 0.0, 0.0, 0.0], 50.0 / 1e3)
    );
    assert_eq!(shock.position, -1.0);
    assert!(matches!(shock.kind, LoadKind::Shock(_)));
}

#[test]
fn a_misaligned_shaft_is_held_at_its_tilt() {
    let text = SMALLEST.replace("[speed]", "tilt_y = \"1 mrad\"\n[speed]");
    let rotor = read(&format!("{text}{BEARING}")).model.unwrap().rotor;
    assert_eq!(rotor.shaft.held_tilt, [0.0, 1e-3]);
}

/// SKF's general catalogue, example 1: 6309, C 55.3 kN, 10 kN at 3000 rpm in oil of 20 mm²/s: 169 million revolutions, 940 h;
/// κ by ISO 281 is 20/9.65.
#[test]
fn an_oil_by_its_kinematic_viscosity() {
    let answer = |oil: &str| {
        let text = format!(
            "[shaft]\nmass = \"1 kg\"\n[speed]\nconstant = \"3000 rpm\"\n[[bearing]]\ncatalogue = \"6309\"\n\
             dynamic_rating = \"55.3 kN\"\noil = {{ {oil}, contamination = \"high\" }}\n[[load]]\nconstant = {{ y = \"-10 kN\" }}\n"
        );
        let scenario = read(&text);
        let oil = scenario.oils[0].expect("an oil");
        let answer = quasi_static(&scenario.question).expect("an equilibrium");
        (oil, answer.bearings[0].rating_lives.expect("lives"))
    };
    for text in ["\"20 mm^2/s\"", "\"20 cSt\""] {
        let (oil, lives) = answer(&format!("viscosity = {text}"));
        assert!((oil.viscosity - 0.0174).abs() < 1e-12, "{}", oil.viscosity);
        assert!((lives.basic.expect("L10") - 169.1).abs() < 0.1);
        assert!((lives.basic_hours.expect("hours") - 939.5).abs() < 0.5);
        let ratio = lives.modified.expect("a life").viscosity_ratio.expect("κ");
        assert!((ratio - 2.073).abs() < 5e-4, "{ratio}");
    }
    let (same, dynamic) = answer("viscosity = \"17.4 mPa s\"");
    assert!((same.viscosity - 0.0174).abs() < 1e-12);
    let (dense, kinematic) = answer("viscosity = \"20 mm^2/s\", density = \"950 kg/m^3\"");
    assert!((dense.viscosity - 0.019).abs() < 1e-12);
    let ratio =
        |lives: crate::bearing::RatingLives| lives.modified.expect("a life").viscosity_ratio;
    let [dynamic, kinematic] = [dynamic, kinematic].map(|lives| ratio(lives).expect("κ"));
    assert!((dynamic - kinematic).abs() < 1e-12);
}

/// A data set that gives n, d, D and the angle: at 29 Hz 103.594, 157.41, 11.511 and 67.34 Hz.
#[test]
fn four_numbers_are_a_geometry() {
    let four = "balls = 9\nball_diameter = \"7.9375 mm\"\npitch_diameter = \"38.50 mm\"\n";
    let angle = "contact_angle = \"0 deg\"\n";
    let scene = |geometry: &str| {
        read(&format!(
            "{SMALLEST}[[bearing]]\n[bearing.geometry]\n{geometry}[damping]\nratio = 0.03\n"
        ))
    };
    let told = |scenario: &Scenario| {
        let assumed = scenario
            .warnings
            .iter()
            .filter(|warning| warning.contains("assumed"));
        assumed.cloned().collect::<Vec<_>>()
    };
    let scenario = scene(&format!("{four}{angle}"));
    let geometry = &scenario.question.rotor.bearings[0].bearing.geometry;
    assert_eq!(geometry.groove_factors()[0], 0.52);
    assert_eq!(geometry.groove_factors()[1], 0.53);
    let pass = geometry.ball_pass(29.0 * 2.0 * PI);
    for (found, known) in [
        (pass.outer, 103.594),
        (pass.inner, 157.41),
        (pass.cage, 11.511),
        (pass.spin, 67.34),
    ] {
        assert!((found - known).abs() < 6e-3, "{} {known}", found);
    }
    let warnings = told(&scenario);
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    assert!(warnings[0].contains("groove_factor_inner = 0.52, groove_factor_outer = 0.53"));
    let one = told(&scene(&format!(
        "{four}diametral_clearance = \"10 um\"\ngroove_factor_inner = 0.515\n"
    )));
    assert!(
        one[0].contains("groove_factor_outer = 0.53") && !one[0].contains("inner"),
        "{one:?}"
    );
    let both = "groove_factor_inner = 0.515\ngroove_factor_outer = 0.525\n";
    assert!(told(&scene(&format!("{four}{angle}{both}"))).is_empty());
}

/// Statically, the ratings are those of the nominal angle: C0 7871.6 N, C_u 410.2 N of any 6205.
#[test]
fn a_mounted_bearing_is_rated_at_its_nominal_angle() {
    for tables in [
        "catalogue = \"6205/C2\"",
        "catalogue = \"6205\"\nclearance_class = \"C5\"",
    ] {
        let scenario = read(&format!(
            "{SMALLEST}[[bearing]]\n{tables}\n[[load]]\nconstant = {{ y = \"-500 N\" }}\n"
        ));
        let answer = quasi_static(&scenario.question).expect("an equilibrium");
        let geometry = &answer.bearings[0].geometry;
        let rating = crate::tests::support::inside(&answer.bearings[0]).static_rating;
        assert!((rating - 7871.6).abs() < 0.1);
        assert!((geometry.fatigue_load_limit - 410.2).abs() < 0.1);
    }
}

/// C of a catalogue bearing whose balls are changed keeps the maker's factor over ISO 281.
#[test]
fn the_rating_of_a_catalogue_follows_its_balls() {
    let read = |bearing: &str| {
        let scenario = read(&format!(
            "{SMALLEST}[[bearing]]\n{bearing}[damping]\nratio = 0.03\n"
        ));
        let rating = scenario.question.rotor.bearings[0].bearing.dynamic_rating;
        let is_warned = scenario
            .warnings
            .iter()
            .any(|text| text.contains("ISO 281"));
        (rating.expect("a rating"), is_warned)
    };
    // Z^(2/3) D^1.8 at the same f_c; 7205C knows its balls, of 6203 they are estimated, 8 of 6.747 mm
    let few = read("catalogue = \"7205C\"\n[bearing.geometry]\nballs = 3\n");
    assert!((few.0 / (16_600.0 * (3.0_f64 / 12.0).powf(2.0 / 3.0)) - 1.0).abs() < 1e-12);
    assert!(few.1);
    let given = "catalogue = \"7205C\"\ndynamic_rating = \"7 kN\"\n[bearing.geometry]\nballs = 3\n";
    assert_eq!(read(given), (7000.0, false));
    let own = "[bearing.geometry]\ndiametral_clearance = \"20 um\"\n";
    assert!(!read(&format!("catalogue = \"6205\"\n{own}")).1);
    let line = |balls: &str| format!("catalogue = \"6203\"\n[bearing.geometry]\nballs = {balls}\n");
    let plain = read("catalogue = \"6203\"\n").0;
    let same = read(&line("8\nball_diameter = \"6.747 mm\""));
    assert!((same.0 / plain - 1.0).abs() < 1e-3 && !same.1, "{same:?}");
    let grooves = "groove_factor_inner = 0.52\ngroove_factor_outer = 0.53";
    let few = read(&line(&format!(
        "4\nball_diameter = \"6.747 mm\"\n{grooves}"
    )));
    let expected = plain * 0.5_f64.powf(2.0 / 3.0);
    assert!(
        (few.0 / expected - 1.0).abs() < 1e-3 && few.1,
        "{few:?} {expected}"
    );
    // what a maker prints beside the balls is theirs
    let rated = "[bearing.ratings]\nbore = \"17 mm\"\noutside_diameter = \"40 mm\"\ncontact_angle = \"0 deg\"\n\
                 dynamic = \"9.6 kN\"\nstatic = \"4.6 kN\"\n[bearing.geometry]\npitch_diameter = \"28.6 mm\"\n";
    assert_eq!(read(rated).0, 9600.0);
}

/// A housing of another metal that would expand as steel is warned of.
#[test]
fn the_expansion_of_another_metal_is_asked_for() {
    let warns = |fit: &str| {
        let scenario = read(&format!(
            "{SMALLEST}[[bearing]]\ncatalogue = \"7208C\"\n[bearing.fit]\n{fit}[damping]\nratio = 0.03\n"
        ));
        let warnings = scenario.warnings.iter();
        let named = |key: &str| warnings.clone().any(|warning| warning.contains(key));
        ["shaft_expansion", "housing_expansion"].map(named)
    };
    let warm = "inner_temperature = \"60 degC\"\nouter_temperature = \"60 degC\"\n";
    let of = |place: &str, modulus: &str| {
        format!("{warm}{place}_material = {{ youngs_modulus = \"{modulus}\" }}\n")
    };
    assert_eq!(warns(&of("housing", "70 GPa")), [false, true]);
    assert_eq!(warns(&of("shaft", "70 GPa")), [true, false]);
    assert_eq!(warns(&of("housing", "210 GPa")), [false; 2]);
    let given = of("housing", "70 GPa") + "housing_expansion = \"23.8e-6 1/K\"\n";
    assert_eq!(warns(&given), [false; 2]);
    let cold = of("housing", "70 GPa").replace(warm, "");
    assert_eq!(warns(&cold), [false; 2]);
}

/// Ceramic balls that would expand as steel are told, with what they would change.
#[test]
fn the_expansion_of_ceramic_balls_is_asked_for() {
    let told = |fit: &str| {
        let scenario = read(&format!(
            "{SMALLEST}[[bearing]]\ncatalogue = \"7208C\"\n[bearing.ball_material]\nyoungs_modulus = \"310 GPa\"\n\
             density = \"3200 kg/m^3\"\n[bearing.fit]\n{fit}[damping]\nratio = 0.03\n"
        ));
        let mut warnings = scenario.warnings.into_iter();
        warnings.find(|warning| warning.contains("ball_expansion"))
    };
    let warm = "inner_temperature = \"60 degC\"\nouter_temperature = \"60 degC\"\n";
    let warning = told(warm).expect("a warning");
    assert!(
        warning.contains("\"3.2e-6 1/K\", would change the clearance by 8.86 um more"),
        "{warning}"
    );
    assert_eq!(
        told(&format!("{warm}ball_expansion = \"3.2e-6 1/K\"\n")),
        None
    );
    assert_eq!(told("inner_interference = \"5 um\"\n"), None);
}

/// Of thin oils the viscosity index is extended, and they thin with the temperature all the same.
#[test]
fn thin_oils_thin() {
    let oil = |keys: &str| {
        let scenario = read(&format!(
            "{SMALLEST}[[bearing]]\ncatalogue = \"6205\"\n[bearing.oil]\n{keys}\n[damping]\nratio = 0.03\n"
        ));
        let lubrication = scenario.question.rotor.bearings[0].bearing.lubrication;
        let extended = |warning: &String| warning.contains("extended");
        let told = scenario.warnings.iter().any(extended);
        (1e6 * lubrication.expect("oil").viscosity, told)
    };
    let [cold, warm] = ["40", "100"].map(|celsius| {
        let (viscosity, told) = oil(&format!("iso_vg = 2\ntemperature = \"{celsius} degC\""));
        assert!(told);
        viscosity
    });
    assert!(
        (cold - 2.0).abs() < 1e-9 && (warm - 0.893).abs() < 1e-3,
        "{cold} {warm}"
    );
    assert!(!oil("iso_vg = 10\ntemperature = \"100 degC\"").1);
    let measured =
        "viscosity_40 = \"1.2 mm^2/s\"\nviscosity_100 = \"0.6 mm^2/s\"\ntemperature = \"100 degC\"";
    let (viscosity, told) = oil(measured);
    assert!((viscosity - 0.6).abs() < 1e-9 && !told);
}

/// A bearing whose balls or rollers reach beyond its bore or outside diameter does not exist.
#[test]
fn rings_need_room_beside_balls_and_rollers() {
    let told = |bearing: &str| {
        let text = format!("{SMALLEST}[[bearing]]\n{bearing}[damping]\nratio = 0.03\n");
        Scenario::from_toml(&text)
            .expect_err("no such bearing")
            .to_string()
    };
    for bearing in [
        "[bearing.ratings]\nbore = \"30 mm\"\noutside_diameter = \"62 mm\"\ncontact_angle = \"0 deg\"\ndynamic = \"19.5 kN\"\n\
         static = \"11.3 kN\"\npitch_diameter = \"60 mm\"\n",
        "catalogue = \"6206\"\n[bearing.geometry]\npitch_diameter = \"34 mm\"\n",
        "catalogue = \"NU206\"\n[bearing.roller]\npitch_diameter = \"60 mm\"\n",
        "[bearing.geometry]\nballs = 9\nball_diameter = \"9.525 mm\"\npitch_diameter = \"46 mm\"\ncontact_angle = \"0 deg\"\n\
         [bearing.fit]\nbore = \"30 mm\"\noutside_diameter = \"55 mm\"\n",
        "[bearing.roller]\nkind = \"cylindrical\"\nrollers = 13\ndiameter = \"7.5 mm\"\nlength = \"9 mm\"\npitch_diameter = \"46 mm\"\n\
         bore = \"40 mm\"\noutside_diameter = \"62 mm\"\n",
    ] {
        let message = told(bearing);
        assert!(message.contains("mm reach from"), "{bearing}{message}");
    }
    let wide = told("catalogue = \"6206\"\n[bearing.geometry]\npitch_diameter = \"60 mm\"\n");
    assert!(wide.contains("an outside diameter of 62 mm"), "{wide}");
}

/// A drop all along a roller is clearance, and no profile.
#[test]
fn a_profile_begins_without_a_drop() {
    let told = |drop: &str| {
        let text = format!(
            "{SMALLEST}[[bearing]]\ncatalogue = \"NU206\"\n[bearing.roller]\ndrop = [{drop}]\n[damping]\nratio = 0.03\n"
        );
        Scenario::from_toml(&text).map_err(|error| error.to_string())
    };
    let end = "{ at = \"4 mm\", drop = \"5 um\" }";
    let refused = told(end).expect_err("a clearance");
    assert!(
        refused.contains("the first point of a profile has a drop of 5 um"),
        "{refused}"
    );
    assert!(told(&format!("{{ at = \"0 mm\", drop = \"0 um\" }}, {end}")).is_ok());
}

/// Seals that rub are told, with the speed that they permit where none is given.
#[test]
fn seals_that_rub_are_told() {
    let told = |keys: &str| {
        let scenario = read(&format!(
            "{SMALLEST}[[bearing]]\n{keys}[damping]\nratio = 0.03\n"
        ));
        scenario.warnings.join("\n")
    };
    let both = told("catalogue = \"6205-2RS1\"\n");
    assert!(
        both.contains("seals that rub") && both.contains("`limiting_speed`"),
        "{both}"
    );
    let one = told("catalogue = \"6205-2RS1\"\nlimiting_speed = \"8500 rpm\"\n");
    assert!(
        one.contains("seals that rub") && !one.contains("0.6"),
        "{one}"
    );
    assert!(!told("catalogue = \"6205-2Z\"\n").contains("seals"));
}

/// Keys of a life and a film that are not told have no effect, and that is said.
#[test]
fn keys_of_a_life_that_is_not_told_are_told() {
    let told = |keys: &str, more: &str| {
        let scenario = read(&format!(
            "{SMALLEST}[[bearing]]\n{keys}[bearing.geometry]\nballs = 9\nball_diameter = \"9.525 mm\"\npitch_diameter = \"46 mm\"\n\
             diametral_clearance = \"10 um\"\ngroove_factor_inner = 0.52\ngroove_factor_outer = 0.53\n{more}\
             [damping]\nratio = 0.03\n"
        ));
        let idle = |warning: &&String| warning.contains("has no effect");
        scenario
            .warnings
            .iter()
            .filter(idle)
            .cloned()
            .collect::<Vec<_>>()
    };
    let keys = "reliability = 95.0\nroughness = \"0.2 um\"\n";
    let oil =
        "[bearing.oil]\niso_vg = 68.0\ntemperature = \"70 degC\"\ncontamination = \"normal\"\n";
    let warnings = told(keys, oil);
    let expected = [
        "bearing[1].reliability",
        "bearing[1].oil.contamination",
        "bearing[1].roughness",
    ];
    assert_eq!(warnings.len(), 3, "{warnings:?}");
    for (warning, key) in warnings.iter().zip(expected) {
        assert!(warning.contains(key), "{warning}");
    }
    assert!(
        warnings[0].contains("ISO 281 gives 19456 N by the balls"),
        "{warnings:?}"
    );
    assert_eq!(
        told(
            &format!("dynamic_rating = \"19.5 kN\"\nfilm = true\n{keys}"),
            oil
        ),
        [""; 0]
    );
}

/// A shaft that moves across its axis only is judged by what holds it there.
#[test]
fn freedoms_that_are_held_leave_the_stiffness_regular() {
    let text = "[shaft]\nmass = \"5 kg\"\nfreedoms = \"radial\"\n[[element]]\nlinear = { stiffness = { x = \"1 N/um\", y = \"4 N/um\" } }\n\
                [speed]\nconstant = \"500 rad/s\"\n";
    let found = quasi_static(&read(text).question).expect("an answer");
    assert!((found.condition - 4.0).abs() < 1e-12, "{}", found.condition);
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
}
