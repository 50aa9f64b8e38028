//! What carries the shaft: freedoms that nothing holds, bearings of constant stiffness, shafts without mass.

use std::f64::consts::{PI, TAU};

use crate::analysis::{Channel, Peak};
use crate::rotor::{Freedoms, Rotor};
use crate::scenario::Scenario;
use crate::simulate::Run;

/// A shaft of 0.4 m with a disc at two thirds on bearings of constant stiffness along x and y alone.
const WITHOUT_Z: &str = r#"
[shaft]
material = { youngs_modulus = "2e11 Pa", poisson_ratio = 0.3, density = "7800 kg/m^3" }
[[shaft.section]]
length = "0.4 m"
outer_diameter = "0.05 m"
[[disc]]
position = "0.2666667 m"
outer_diameter = "0.3 m"
width = "0.03 m"
material = { density = "7800 kg/m^3" }
[[unbalance]]
amount = "1000 g mm"
position = "0.2666667 m"
[[bearing]]
position = "0 m"
linear = { stiffness = { x = "5e7 N/m", y = "7e7 N/m" }, damping = { x = "500 N s/m", y = "700 N s/m" } }
[[bearing]]
position = "0.4 m"
linear = { stiffness = { x = "5e7 N/m", y = "7e7 N/m" }, damping = { x = "500 N s/m", y = "700 N s/m" } }
[speed]
constant = "6000 rpm"
[integrator]
verify = false
[output]
motion = false
[time]
duration = "0.6 s"
settle = "0.4 s"
"#;

#[track_caller]
fn scenario(text: &str) -> Scenario {
    Scenario::from_toml(text).unwrap_or_else(|error| panic!("{}", error.render(false)))
}

#[track_caller]
fn run(scenario: &Scenario) -> Run {
    scenario.simulate().expect("a run").run
}

/// Natural frequencies of a scenario, lowest first, Hz.
#[track_caller]
fn frequencies(text: &str) -> Vec<f64> {
    let rotor = Rotor::assemble(&scenario(text).question.rotor).expect("a rotor");
    let modes = rotor.natural_frequencies();
    modes.iter().map(|mode| mode.frequency).collect()
}

#[track_caller]
fn close(found: f64, expected: f64, relative: f64) {
    let apart = (found / expected - 1.0).abs();
    assert!(apart < relative, "{found:e}, not {expected:e}: {apart:.1e}");
}

/// 14.7429 and 12.6969 µm: the same shaft with freedoms = "radial", and elements of an independent program.
#[test]
fn z_that_nothing_holds_or_loads_is_held_and_said() {
    let scene = scenario(WITHOUT_Z);
    let said = scene
        .warnings
        .iter()
        .find(|text| text.contains("z is held"));
    assert!(
        said.is_some_and(|text| text.contains("\"lateral\"")),
        "{:?}",
        scene.warnings
    );
    assert_eq!(scene.question.rotor.shaft.freedoms, Freedoms::Lateral);
    let peaks = run(&scene).peaks;
    for (axis, expected) in [14.7429e-6, 12.6969e-6].into_iter().enumerate() {
        let of_unbalance = |peak: &&Peak| {
            peak.channel == Channel::Displacement(axis) && (peak.frequency - 100.0).abs() < 0.1
        };
        let peak = peaks
            .iter()
            .find(of_unbalance)
            .expect("a line of the unbalance");
        close(peak.amplitude, expected, 1e-4);
    }
}

#[test]
fn z_that_is_loaded_and_not_held_is_an_error_that_names_it() {
    let loaded = format!("{WITHOUT_Z}[[load]]\nconstant = {{ z = \"5 N\" }}\n");
    let scene = scenario(&loaded);
    assert_eq!(scene.question.rotor.shaft.freedoms, Freedoms::All);
    let error = scene.simulate().expect_err("no equilibrium").to_string();
    assert!(error.contains("gives way along z"), "{error}");
}

#[test]
fn z_that_is_written_as_free_is_held_too_where_nothing_acts_on_it() {
    for (written, left) in [
        ("all", Freedoms::Lateral),
        ("translational", Freedoms::Radial),
    ] {
        let scene = scenario(&two_springs(written, ""));
        assert_eq!(scene.question.rotor.shaft.freedoms, left);
        assert!(scene.warnings.iter().any(|text| text.contains("z is held")));
        let held = scenario(&two_springs(written, ", z = \"1e6 N/m\""));
        assert_eq!(held.question.rotor.shaft.freedoms.name(), written);
    }
}

/// A rigid shaft of 4 kg, 0.02 and 0.03 kg m², on springs 100 mm either side of its middle.
fn two_springs(freedoms: &str, along_z: &str) -> String {
    let bearing = |position: &str| {
        format!(
            "[[bearing]]\nposition = \"{position}\"\nlinear = {{ stiffness = {{ x = \"1e6 N/m\", y = \"4e6 N/m\"{along_z} \
             }} }}\n"
        )
    };
    format!(
        "[shaft]\nmass = \"4 kg\"\ninertia_transverse = \"0.02 kg m^2\"\ninertia_polar = \"0.03 kg m^2\"\nfreedoms = \
         \"{freedoms}\"\n{}{}[speed]\nconstant = \"0 rpm\"\n",
        bearing("-100 mm"),
        bearing("100 mm")
    )
}

/// ω² = 2k/m of x and y, 2ka²/I of the tilts.
#[test]
fn lateral_moves_along_x_and_y_and_tilts() {
    let found = frequencies(&two_springs("lateral", ", z = \"1e6 N/m\""));
    let expected = [2e6 / 4.0, 2e4 / 0.02, 8e6 / 4.0, 8e4 / 0.02];
    assert_eq!(found.len(), 4);
    for (found, square) in found.iter().zip(expected) {
        close(*found, f64::sqrt(square) / TAU, 1e-12);
    }
}

/// z is a constant of its columns; the tilts are those of all five freedoms.
#[test]
fn lateral_records_the_tilts_and_no_axial_motion() {
    let moving = |freedoms: &str| {
        let text = two_springs(freedoms, ", z = \"1e6 N/m\"").replace("0 rpm", "3000 rpm");
        let text = format!(
            "{text}[[unbalance]]\namount = \"20 g mm\"\nposition = \"30 mm\"\n[damping]\nratio = 0.05\n[integrator]\nverify = \
             false\n[time]\nduration = \"0.06 s\"\nsettle = \"0.02 s\"\n"
        );
        scenario(&text).simulate().expect("a run")
    };
    let (lateral, all) = (moving("lateral"), moving("all"));
    for name in ["x", "y", "tilt_x", "tilt_y", "tilt_y_velocity", "moment_x"] {
        let [own, whole] = [&lateral, &all].map(|run| run.column(name).expect("a column"));
        let largest = whole
            .iter()
            .fold(0.0, |most: f64, value| most.max(value.abs()));
        let apart = own.iter().zip(&whole).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f64::max) <= 1e-5 * largest, "{name}");
    }
    let recorded = lateral
        .run
        .motion
        .as_ref()
        .expect("a motion")
        .statistics
        .iter();
    let recorded: Vec<_> = recorded.map(|own| own.channel.name()).collect();
    let axes = ["x", "y", "tilt_x", "tilt_y"];
    let forces = ["force_x", "force_y", "moment_x", "moment_y"];
    assert_eq!(recorded, [axes, forces].concat());
    assert!(
        lateral
            .column("z")
            .expect("a column")
            .iter()
            .all(|z| *z == 0.0)
    );
}

/// The error of a scene that has no equilibrium.
#[track_caller]
fn refusal(text: &str) -> String {
    let rotor = Rotor::assemble(&scenario(text).question.rotor);
    rotor.expect_err("no equilibrium").to_string()
}

/// A spring presses with the same force wherever the shaft is: with no bearing that faces the other way z gives way, not y.
#[test]
fn a_spring_without_a_counterpart_gives_way_along_z() {
    let single = "[shaft]\nmass = \"2 kg\"\nfreedoms = \"translational\"\n[[bearing]]\ncatalogue = \"6205\"\nspring_preload = \
                  \"200 N\"\n[[load]]\nconstant = { y = \"-500 N\" }\n[speed]\nconstant = \"1800 rpm\"\n";
    let error = refusal(single);
    assert!(error.contains("gives way along z by -"), "{error}");
    assert!(
        error.contains("2.000e2 (N or N m) stay unbalanced; no load acts there"),
        "{error}"
    );
    // pressed beyond the spring, with a larger load across on a shaft that bends
    let bends = "[shaft]\ngravity = true\n[[shaft.section]]\nlength = \"125 mm\"\nouter_diameter = \"15 mm\"\n[[bearing]]\n\
                 position = \"69 mm\"\ncatalogue = \"6008\"\nfacing = \"-z\"\nspring_preload = \"55 N\"\n[[load]]\nposition = \
                 \"110 mm\"\nconstant = { y = \"-3842 N\", z = \"-2727 N\" }\n[speed]\nconstant = \"1200 rpm\"\n";
    let error = refusal(bends);
    assert!(error.contains("gives way along z by"), "{error}");
}

fn warned(text: &str, part: &str) -> bool {
    scenario(text).warnings.iter().any(|own| own.contains(part))
}

/// ζ = 0.14 by the bearing: nothing to warn of. Damped along x alone it is.
#[test]
fn undamped_is_warned_of_where_a_mode_is_undamped() {
    let text = |damping: &str| {
        format!(
            "[shaft]\nmass = \"5 kg\"\n[[bearing]]\nlinear = {{ stiffness = {{ x = \"1e7 N/m\", y = \"1e7 N/m\" }}{damping} \
             }}\n[speed]\nconstant = \"1500 rpm\"\n[time]\nduration = \"0.4 s\"\nsettle = \"0.2 s\"\n"
        )
    };
    let both = text(", damping = { x = \"2000 N s/m\", y = \"2000 N s/m\" }");
    assert!(!warned(&both, "does not decay"));
    let one = text(", damping = { x = \"2000 N s/m\" }");
    assert!(warned(&one, "nothing else damps the mode at 225.1 Hz"));
    assert!(warned(
        &text(""),
        "no `[damping]`: a free vibration does not decay"
    ));
    assert!(!warned(WITHOUT_Z, "does not decay"));
}

/// Two 6308 that are pressed the same way move off by 140.6 µm until nothing presses.
#[test]
fn a_preload_of_all_bearings_the_same_way_is_warned_of() {
    let text = |facing: &str| {
        format!(
            "[shaft]\nmass = \"12 kg\"\nfreedoms = \"translational\"\n[[bearing]]\ncatalogue = \"6308\"\npreload = \"300 \
             N\"\nposition = \"-100 mm\"\n[[bearing]]\ncatalogue = \"6308\"\npreload = \"300 N\"\nposition = \"100 mm\"\n{facing}\
             [speed]\nconstant = \"1480 rpm\"\n[damping]\nratio = 0.03\n[[load]]\nconstant = {{ x = \"900 N\" }}\n[time]\n\
             duration = \"0.5 s\"\n"
        )
    };
    let line = "all 2 bearings face or are preloaded the same way, +z: none holds the shaft against the others, and a preload \
                of theirs is not borne; write facing = \"-z\" in `bearing[1]`";
    assert!(
        warned(&text(""), line),
        "{:?}",
        scenario(&text("")).warnings
    );
    assert!(!warned(&text("facing = \"-z\"\n"), "not borne"));
    let single = text("").replacen("preload = \"300 N\"\n", "", 1);
    assert!(!warned(&single, "not borne"));
}

/// 0.1 kg in the middle of a massless shaft of 200 mm × 5 mm, on springs of 5 kN/m at its ends.
fn jeffcott(at_bearings: &str, more: &str) -> String {
    let bearing = |position: &str| {
        format!(
            "[[bearing]]\nposition = \"{position}\"\nlinear = {{ stiffness = {{ x = \"5e3 N/m\", y = \"5e3 N/m\" }}{at_bearings} \
             }}\n"
        )
    };
    format!(
        "[shaft]\nmassless = true\nfreedoms = \"radial\"\ngravity = true\n[[shaft.section]]\nlength = \"200 mm\"\n\
         outer_diameter = \"5 mm\"\n[[disc]]\nposition = \"100 mm\"\nmass = \"0.1 kg\"\n{}{}[speed]\nconstant = \"600 rpm\"\n\
         [integrator]\nverify = false\n{more}",
        bearing("0 mm"),
        bearing("200 mm")
    )
}

/// 1/k = L³/(48 E I) + L/(4 κ G A) + 1/(2 k_b), N/m.
fn jeffcott_stiffness() -> f64 {
    let (length, diameter, young, poisson) = (0.2_f64, 5e-3_f64, 210e9, 0.3);
    let (second, area) = (PI * diameter.powi(4) / 64.0, PI * diameter.powi(2) / 4.0);
    // Cowper's κ of a solid round section
    let shear = 6.0 * (1.0 + poisson) / (7.0 + 6.0 * poisson);
    let shear = length * 2.0 * (1.0 + poisson) / (4.0 * shear * young * area);
    let bending = length.powi(3) / (48.0 * young * second);
    1.0 / (bending + shear + 1.0 / 1e4)
}

/// x, y of the disc are all that has mass: two modes of √(k/m), and no others.
#[test]
fn a_point_mass_on_a_massless_shaft_is_a_laval_rotor() {
    let found = frequencies(&jeffcott("", ""));
    assert_eq!(found.len(), 2);
    for found in found {
        close(found, (jeffcott_stiffness() / 0.1).sqrt() / TAU, 1e-9);
    }
    let scene = scenario(&jeffcott("", ""));
    let place = Rotor::assemble(&scene.question.rotor)
        .expect("a rotor")
        .equilibrium()
        .displacement;
    close(place[1], -0.1 * 9.80665 / jeffcott_stiffness(), 1e-9);
}

/// The forced amplitude U ω²/(k − m ω²) under 1 g mm and what stays of a load of 3 N between disc and bearing.
#[test]
fn a_massless_shaft_turns_under_unbalance_and_constant_loads() {
    let more = "[[unbalance]]\namount = \"1 g mm\"\nposition = \"100 mm\"\n[[load]]\nposition = \"50 mm\"\nconstant = { x = \"3 \
                N\" }\n[damping]\nratio = 0.5\n[output]\nenergy = true\n[time]\nduration = \"0.4 s\"\nsettle = \"0.2 s\"\n";
    let recorded = scenario(&jeffcott("", more)).simulate().expect("a run");
    let speed: f64 = 600.0 * TAU / 60.0;
    let natural = (jeffcott_stiffness() / 0.1).sqrt();
    let ratio = speed / natural;
    let gain = ratio.powi(2) / (1.0 - ratio.powi(2)).hypot(2.0 * 0.5 * ratio);
    let motion = recorded.run.motion.as_ref().expect("a motion");
    let x = &motion.statistics[0].moments;
    close(x.rms(), 1e-6 / 0.1 * gain / 2.0_f64.sqrt(), 1e-6);
    let rotor = Rotor::assemble(&scenario(&jeffcott("", more)).question.rotor).expect("a rotor");
    close(x.mean(), rotor.equilibrium().displacement[0], 1e-9);
    // the disc has no moment of inertia, and tilts by the load beside it all the same
    let tilt = recorded.column("tilt_y").expect("a column");
    assert!(
        tilt.iter().all(|tilt| tilt.abs() > 1e-5),
        "{:?}",
        tilt.first()
    );
    let energy = recorded.run.energy.as_ref().expect("an audit");
    assert!(energy.relative_residual < 1e-6, "{energy:?}");
}

#[test]
fn what_moves_a_massless_place_by_itself_is_refused_all_at_once() {
    let more = "[[unbalance]]\namount = \"1 g mm\"\nposition = \"50 mm\"\n";
    let damped = jeffcott(", damping = { x = \"10 N s/m\", y = \"10 N s/m\" }", more);
    let error = refusal(&damped);
    for place in [
        "x of the shaft at 0.0 mm",
        "y of the shaft at 200.0 mm",
        "x of the shaft at 50.0 mm",
    ] {
        assert!(error.contains(place), "{error}");
    }
}
