//! What the keys of a scenario become in the model.

use std::f64::consts::PI;

use jeffcott::bearing::{ContactLaw, Facing, FreePosition, Geometry, Preload};
use jeffcott::integrate::Method;
use jeffcott::rotor::{Damping, Freedoms, InitialPosition, LoadKind, SpeedPoint};
use jeffcott::scenario::{self, Format, Scenario};
use jeffcott::simulate::{Model, Sampling};

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
    read(&format!("{SMALLEST}{tables}")).model
}

const BEARING: &str = "[[bearing]]\ncatalogue = \"7205C\"\n";

#[test]
fn the_smallest_scenario_has_the_documented_defaults() {
    let scenario = read(&format!("{SMALLEST}{BEARING}"));
    assert_eq!(scenario.title, "test");
    assert_eq!(
        scenario.warnings.len(),
        1,
        "undamped: {:?}",
        scenario.warnings
    );
    let model = scenario.model;
    assert_eq!(model.rotor.shaft.freedoms, Freedoms::Translational);
    assert_eq!(model.rotor.shaft.eccentricity, 0.0);
    assert!(!model.rotor.shaft.gravity);
    assert_eq!(model.rotor.speed, 3000.0 * PI / 30.0);
    assert_eq!(model.rotor.damping, Damping::Undamped);
    assert_eq!(model.rotor.initial.from, InitialPosition::Equilibrium);
    assert_eq!((model.duration, model.settle), (0.1, 0.0));
    assert_eq!(model.sampling, Sampling::PerRevolution(128));
    assert_eq!(model.integrator.method, Method::Dop853);
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
    let scenario = include_str!("../scenarios/varying-compliance-6306.toml");
    let bearing = read(scenario).model.rotor.bearings[0].bearing;
    assert_eq!(bearing.contact_stiffness, Some(1.334e10));
    let clearance = FreePosition::RadialClearance(3e-6);
    let expected = Geometry::new(8, 11.9062 / 1e3, 52.0 / 1e3, clearance, 0.52, 0.52).unwrap();
    assert_eq!(bearing.geometry, expected);
}

#[test]
fn loads_add_up() {
    let loads = "[[load]]\nconstant = { y = \"-1 kN\", z = \"5 N\" }\n[[load]]\nconstant = { y = \"1 N\" }\n";
    assert_eq!(
        model(&format!("{BEARING}{loads}")).rotor.load,
        [0.0, -999.0, 5.0, 0.0, 0.0]
    );
}

#[test]
fn a_pair_of_bearings_keeps_its_places() {
    let pair = read(include_str!("../scenarios/back-to-back-7205c.toml"))
        .model
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
    assert!(scenario.model.spectrum.is_none());
    assert!(scenario.output.trace && !scenario.output.spectrum && !scenario.output.figures);
}

#[test]
fn whole_numbers_may_be_written_with_an_exponent() {
    let model = model(&format!("{BEARING}[integrator]\nstep_limit = 1e6\n"));
    assert_eq!(model.integrator.step_limit, 1_000_000);
}

fn with_speed(speed: &str) -> Model {
    let text = SMALLEST.replace("constant = \"3000 rpm\"", speed);
    read(&format!("{text}{BEARING}")).model
}

#[test]
fn a_ramp_and_a_profile_of_the_same_speeds_are_the_same() {
    let ramp = "ramp = { from = \"10 rad/s\", to = \"50 rad/s\", over = \"2 s\" }";
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
    let rotor = read(&format!("{text}{BEARING}{loads}")).model.rotor;
    assert_eq!(rotor.load, [10.0, 20.0, 0.0, -1.0, 0.5]);
    assert_eq!(rotor.loads.len(), 1);
    assert_eq!(rotor.loads[0].position, -1.0);
    assert!(matches!(rotor.loads[0].kind, LoadKind::Shock(_)));
}

#[test]
fn a_misaligned_shaft_is_held_at_its_tilt() {
    let text = SMALLEST.replace("[speed]", "tilt_y = \"1 mrad\"\n[speed]");
    let rotor = read(&format!("{text}{BEARING}")).model.rotor;
    assert_eq!(rotor.shaft.held_tilt, [0.0, 1e-3]);
}
