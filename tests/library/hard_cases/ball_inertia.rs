//! Balls that their own speed presses outwards.

use crate::physics::{ball_mass, centrifugal_force, nominal_cage_speed};

use super::{error, model, run, work};
use crate::tests::support::{assert_near, bearing, try_run};

/// A light shaft with clearance at 28 650 rpm that a blow throws up.
const SCENE: &str = r#"
    [shaft]
    mass = "5 kg"
    freedoms = "radial"
    [speed]
    constant = "3000 rad/s"
    [[bearing]]
    catalogue = "6305"
    [bearing.geometry]
    diametral_clearance = "20 um"
    [bearing.oil]
    viscosity = "0.04 Pa s"
    pressure_viscosity = "22 1/GPa"
    [model]
    contact = "jones"
    [damping]
    ratio = 0.05
    [[load]]
    constant = { y = "-50 N" }
    [[load]]
    shock = { peak = { y = "2 kN" }, duration = "1 ms", at = "0.02 s" }
    [time]
    duration = "0.1 s"
"#;

/// Every ball is pressed outwards by 164 N, three times the load of the shaft: the inner ring touches
/// the few balls beneath it, or none while it flies, and the others rest on the outer race alone. A
/// state without any inner contact is legal: what is left of the law is the centrifugal force, no
/// force on the shaft, and no place where Newton's method loses its way.
#[test]
fn the_inner_ring_leaves_all_balls_at_high_speed() {
    let definition = model(SCENE).rotor;
    let geometry = &definition.bearings[0].bearing.geometry;
    let ball = ball_mass(
        geometry.ball_diameter(),
        bearing("6305").ball_material.density,
    );
    // without inner contact a ball runs at α = 0
    let orbit = nominal_cage_speed(3000.0, geometry.ball_diameter() / geometry.pitch_diameter());
    let thrown = centrifugal_force(ball, geometry.pitch_diameter(), orbit);
    for control in ["outer", "inner", "even"] {
        let text = SCENE.replace(
            "contact = \"jones\"",
            &format!("contact = \"jones\"\nrace_control = \"{control}\""),
        );
        let (result, samples) = try_run(&model(&text), 0.0);
        let run = result.expect("a run");
        let flying: Vec<_> = samples
            .iter()
            .filter(|s| s.balls_loaded == Some(0))
            .collect();
        println!(
            "{control}: {:e}, {:?}, {} flying",
            error(&run),
            run.counters,
            flying.len()
        );
        assert!(flying.len() > 100, "{}", flying.len());
        for sample in flying {
            // no ball bears more than another, and the shaft bears nothing
            assert_near(
                "F_c",
                sample.largest_ball_load.unwrap(),
                thrown,
                1e-6 * thrown,
            );
            assert_eq!(sample.force_on_shaft, Some([0.0; 5]));
        }
        let heaviest = samples
            .iter()
            .filter_map(|s| s.largest_ball_load)
            .fold(0.0, f64::max);
        assert!((3000.0..5000.0).contains(&heaviest), "{heaviest}");
        assert!(
            error(&run) < 1e-4 && work(&run) < 4000,
            "{:e} {:?}",
            error(&run),
            run.counters
        );
    }
}

/// Behind films no load is quite zero: they catch the shaft before it meets a ball, and the contacts
/// need less work, though steps land on dry ones without a trial before.
#[test]
fn films_catch_the_inner_ring() {
    // by one method: what another choice costs is another matter
    let scene = format!("{SCENE}\n[integrator]\nmethod = \"verner76\"\n");
    let (dry, _) = run(&scene);
    let (wet, extremes) =
        run(&scene.replace("contact = \"jones\"", "contact = \"jones\"\nfilm = true"));
    println!(
        "{:e} {:?}, dry {:?}",
        error(&wet),
        wet.counters,
        dry.counters
    );
    assert!(wet.counters.evaluations < dry.counters.evaluations);
    assert!(extremes.lightest_ball_load > 164.0 && error(&wet) < 1e-4);
}
