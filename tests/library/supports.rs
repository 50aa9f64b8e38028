//! What carries the shaft: freedoms that nothing holds, bearings of constant stiffness, shafts without mass.

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;

use crate::analysis::{Channel, Peak};
use crate::rotor::{Freedoms, Rotor, Whirl};
use crate::scenario::Scenario;
use crate::simulate::{Run, speed_warnings};
use crate::study::campbell::{CampbellQuestion, NEVER};
use crate::tests::support::scenario;

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
[[element]]
position = "0 m"
linear = { stiffness = { x = "5e7 N/m", y = "7e7 N/m" }, damping = { x = "500 N s/m", y = "700 N s/m" } }
[[element]]
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
fn a_free_z_that_nothing_acts_on_is_held_too() {
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
            "[[element]]\nposition = \"{position}\"\nlinear = {{ stiffness = {{ x = \"1e6 N/m\", y = \"4e6 N/m\"{along_z} \
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
    let of_all = recorded.iter().take(8).copied();
    assert_eq!(of_all.collect::<Vec<_>>(), [axes, forces].concat());
    let of_each = |name: &&str| forces.iter().any(|force| name.ends_with(force));
    assert!(recorded[8..].iter().all(of_each), "{recorded:?}");
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
            "[shaft]\nmass = \"5 kg\"\n[[element]]\nlinear = {{ stiffness = {{ x = \"1e7 N/m\", y = \"1e7 N/m\" }}{damping} \
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

/// Bearings of constant stiffness span the shaft as ball bearings do.
#[test]
fn far_positions_are_judged_by_all_bearings() {
    let text = |position: &str| {
        let bearing = |position: &str| {
            format!(
                "[[element]]\nposition = \"{position}\"\nlinear = {{ stiffness = {{ x = \"1e7 N/m\", y = \"1e7 N/m\" }} }}\n"
            )
        };
        format!(
            "[shaft]\nmass = \"5 kg\"\nfreedoms = \"lateral\"\ninertia_transverse = \"0.1 kg m^2\"\n\
             inertia_polar = \"0.05 kg m^2\"\n{}{}[speed]\nconstant = \"1500 rpm\"\n[time]\nduration = \"0.4 s\"\n",
            bearing(position),
            bearing("100 mm"),
        )
    };
    assert!(!warned(&text("-100 mm"), "outside the bearings"));
    assert!(warned(
        &text("99 mm"),
        "99.0 mm outside the bearings, which span 1.0 mm"
    ));
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
                of theirs is not borne; write facing = \"-z\" in `bearing[2]`";
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
            "[[element]]\nposition = \"{position}\"\nlinear = {{ stiffness = {{ x = \"5e3 N/m\", y = \"5e3 N/m\" }}{at_bearings} \
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

/// ω² of [[k/m, −k/m], [−k/M, (k + K)/M]]: 168.319 and 673.011 Hz, and where the shaft's weight puts it.
#[test]
fn a_linear_bearing_stands_in_a_housing() {
    let rigid = "[shaft]\nmass = \"10 kg\"\ngravity = true\n[[element]]\nlinear = { stiffness = { x = \"50 N/um\", y = \"50 \
                 N/um\" } }\nhousing = { mass = \"5 kg\", stiffness = { x = \"20 N/um\", y = \"20 N/um\" } }\n[speed]\n\
                 constant = \"3000 rpm\"\n";
    for (found, expected) in frequencies(rigid).chunks(2).zip([168.319, 673.011]) {
        close(found[0], expected, 1e-6);
        close(found[1], expected, 1e-6);
    }
    let more = "[[unbalance]]\namount = \"50 g mm\"\n[output]\nenergy = true\n[integrator]\nverify = false\n[time]\nduration \
                = \"0.04 s\"\nsettle = \"0 s\"\n";
    let recorded = scenario(&format!("{rigid}{more}"))
        .simulate()
        .expect("a run");
    let weight = 10.0 * 9.80665;
    close(
        recorded.column("y").expect("a column")[0],
        -weight * (1.0 / 50e6 + 1.0 / 20e6),
        1e-9,
    );
    close(
        recorded.column("housing1_y").expect("a column")[0],
        -weight / 20e6,
        1e-9,
    );
    let energy = recorded.run.energy.as_ref().expect("an audit");
    assert!(energy.relative_residual < 1e-6, "{energy:?}");
    // the same halved, on a shaft that bends and has no mass
    let bearing = |position: &str| {
        format!(
            "[[element]]\nposition = \"{position}\"\nlinear = {{ stiffness = {{ x = \"25 N/um\", y = \"25 N/um\" }} }}\nhousing \
             = {{ mass = \"2.5 kg\", stiffness = {{ x = \"10 N/um\", y = \"10 N/um\" }} }}\n"
        )
    };
    let bends = format!(
        "[shaft]\nmassless = true\n[[shaft.section]]\nlength = \"100 mm\"\nouter_diameter = \"300 mm\"\n[[disc]]\nposition = \"50 \
         mm\"\nmass = \"10 kg\"\n{}{}[speed]\nconstant = \"3000 rpm\"\n",
        bearing("0 mm"),
        bearing("100 mm")
    );
    let found = frequencies(&bends);
    for expected in [168.319, 673.011] {
        let near = found
            .iter()
            .filter(|own| (*own / expected - 1.0).abs() < 5e-3);
        assert_eq!(near.count(), 2, "{found:?}");
    }
}

/// Of `xy` alone the axes are inclined by 45°: ω² = (k ± k_xy)/m.
#[test]
fn an_inclined_stiffness_has_principal_axes() {
    let text = "[shaft]\nmass = \"4 kg\"\n[[element]]\nlinear = { stiffness = { x = \"3.5e7 N/m\", y = \"3.5e7 N/m\", xy = \
                \"-9e6 N/m\" } }\n[speed]\nconstant = \"0 rpm\"\n";
    for (found, square) in frequencies(text).iter().zip([2.6e7 / 4.0, 4.4e7 / 4.0]) {
        close(*found, f64::sqrt(square) / TAU, 1e-12);
    }
}

/// `m s² + c s + k ∓ i q = 0` with k_xy = q = −k_yx: the forward whirl grows where q > c ω. Its energy comes from the rotation.
#[test]
fn a_circulatory_stiffness_drives_a_forward_whirl() {
    let text = "[shaft]\nmass = \"2 kg\"\neccentricity = \"2 um\"\n[[element]]\nlinear = { stiffness = { x = \"1e6 N/m\", y = \
                \"1e6 N/m\", xy = \"2e5 N/m\", yx = \"-2e5 N/m\" }, damping = { x = \"100 N s/m\", y = \"100 N s/m\", xy = \"30 \
                N s/m\", yx = \"-30 N s/m\" } }\n[speed]\nconstant = \"3000 rpm\"\n[output]\nenergy = true\n[integrator]\n\
                verify = false\n[time]\nduration = \"0.05 s\"\nsettle = \"0 s\"\n";
    let scene = scenario(text);
    let modes = Rotor::assemble(&scene.question.rotor)
        .expect("a rotor")
        .natural_frequencies();
    let forward = modes
        .iter()
        .find(|mode| mode.whirl == Whirl::Forward)
        .expect("a mode");
    let [mass, damping, stiffness] = [
        Complex::from(2.0),
        Complex::new(100.0, -30.0),
        Complex::new(1e6, -2e5),
    ];
    let root = (damping * damping - mass * stiffness * 4.0).sqrt();
    let root = if root.im > 0.0 { root } else { -root };
    let expected = (root - damping) / (mass * 2.0);
    close(TAU * forward.damped_frequency, expected.im, 1e-9);
    close(forward.damping_ratio, -expected.re / expected.norm(), 1e-9);
    assert!(forward.damping_ratio < -0.01);
    let run = run(&scene);
    let energy = run.energy.as_ref().expect("an audit");
    assert!(
        energy.works.rotation > 0.1 * energy.works.viscous,
        "{energy:?}"
    );
    assert!(energy.relative_residual < 1e-6, "{energy:?}");
}

/// Critical speeds by elements of independent programs, on springs inclined by 45° and on isotropic ones: Nelson's rotor of 18
/// sections (H. D. Nelson & J. M. McVaugh, *J. Eng. Ind.* 98 (1976) 593–600), with shear.
#[test]
fn critical_speeds_of_nelsons_rotor_are_those_of_other_programs() {
    let sections = [
        (1.27, 1.02, 0.0),
        (3.81, 2.04, 0.0),
        (2.54, 1.52, 0.0),
        (1.27, 4.06, 0.0),
        (1.27, 4.06, 0.0),
        (0.51, 6.60, 0.0),
        (0.76, 6.60, 3.04),
        (1.27, 5.08, 3.56),
        (0.76, 5.08, 0.0),
        (3.05, 2.54, 0.0),
        (2.54, 2.54, 0.0),
        (3.81, 3.04, 0.0),
        (3.81, 3.04, 0.0),
        (2.03, 2.54, 0.0),
        (1.78, 2.54, 0.0),
        (1.02, 7.62, 0.0),
        (3.04, 4.06, 0.0),
        (1.27, 4.06, 3.04),
    ];
    let sections = sections.map(|(length, outer, inner)| {
        format!(
            "[[shaft.section]]\nlength = \"{length} cm\"\nouter_diameter = \"{outer} cm\"\ninner_diameter = \"{inner} cm\"\n"
        )
    });
    let inclined = "x = \"3.503e7 N/m\", y = \"3.503e7 N/m\", xy = \"-8.756e6 N/m\"";
    let isotropic = "x = \"4.378e7 N/m\", y = \"4.378e7 N/m\"";
    let six = [13_841.0, 16_374.0, 39_275.0, 47_326.0, 59_131.0, 91_377.0];
    let two = [15_359.0, 17_008.0];
    for (stiffness, expected, to, count) in [
        (inclined, &six[..], 95_000.0, 20),
        (isotropic, &two, 20_000.0, 3),
    ] {
        let bearing = |position: &str| {
            format!(
                "[[element]]\nposition = \"{position}\"\nlinear = {{ stiffness = {{ {stiffness} }} }}\n"
            )
        };
        let rotor = scenario(&format!(
            "[shaft]\nmodes = 14\nfreedoms = \"radial\"\nmaterial = {{ youngs_modulus = \"207.8 GPa\", poisson_ratio = 0.3, density = \"7806 \
         kg/m^3\" }}\n{}[[disc]]\nposition = \"8.89 cm\"\nmass = \"1.401 kg\"\ninertia_transverse = \"0.00136 kg m^2\"\n\
         inertia_polar = \"0.00203 kg m^2\"\n{}{}[speed]\nconstant = \"10000 rpm\"\n",
            sections.concat(),
            bearing("16.51 cm"),
            bearing("28.7 cm")
        ));
        let rpm = TAU / 60.0;
        let question = CampbellQuestion {
            rotor: rotor.question.rotor,
            from: 0.0,
            to: to * rpm,
            count,
            orders: vec![1.0],
            highest_frequency: None,
        };
        let campbell = question.solve(&NEVER).expect("a diagram");
        let found = campbell.critical_speeds.iter().map(|own| own.speed / rpm);
        let found: Vec<_> = found.collect();
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (found, expected) in found.into_iter().zip(expected) {
            close(found, *expected, 1e-4);
        }
    }
}

/// A disc of 45 kg, 0.2 and 0.4 kg m², on a shaft of 0.4 g: x and y of the disc at √(k/m), its tilts at
/// `I_t ω² ∓ I_p Ω ω = k_θ`, and the modes of the shaft itself a thousand to a million times as high.
#[test]
fn a_very_light_shaft_leaves_the_modes_of_its_disc_their_digits() {
    let bearing = |position: &str| {
        format!(
            "[[element]]\nposition = \"{position}\"\nlinear = {{ stiffness = {{ x = \"1e10 N/m\", y = \"1e10 N/m\" }} }}\n"
        )
    };
    let scene = |inertia: &str| {
        scenario(&format!(
            "[shaft]\nfreedoms = \"radial\"\nmaterial = {{ youngs_modulus = \"210 GPa\", density = \"1 kg/m^3\" }}\n\
             [[shaft.section]]\nlength = \"762 mm\"\nouter_diameter = \"25.4 mm\"\n[[disc]]\nmass = \"45 kg\"\nposition = \
             \"381 mm\"\n{inertia}{}{}[speed]\nconstant = \"2000 rpm\"\n",
            bearing("0 mm"),
            bearing("762 mm")
        ))
    };
    let (length, diameter, young, poisson) = (0.762_f64, 25.4e-3_f64, 210e9, 0.3);
    let (second, area) = (PI * diameter.powi(4) / 64.0, PI * diameter.powi(2) / 4.0);
    let shear = 6.0 * (1.0 + poisson) / (7.0 + 6.0 * poisson) * young / (2.0 * (1.0 + poisson));
    let shear = shear * area;
    let across = length.powi(3) / (48.0 * young * second) + length / (4.0 * shear) + 0.5e-10;
    // 17/35 of the shaft moves with its middle
    let mass = 45.0 + 17.0 / 35.0 * area * length;
    let bouncing = 1.0 / (across * mass).sqrt();
    let point = Rotor::assemble(&scene("").question.rotor)
        .expect("a rotor")
        .natural_frequencies();
    for mode in &point[..2] {
        close(TAU * mode.frequency, bouncing, 1e-5);
        assert!(mode.damping_ratio.abs() < 1e-6, "{mode:?}");
    }
    let definition = scene("inertia_transverse = \"0.2 kg m^2\"\ninertia_polar = \"0.4 kg m^2\"\n");
    let definition = definition.question.rotor;
    let found = Rotor::assemble(&definition)
        .expect("a rotor")
        .natural_frequencies();
    let tilting =
        1.0 / (length / (12.0 * young * second) + 1.0 / (length * shear) + 2e-10 / length.powi(2));
    let half = 0.5 * 0.4 / 0.2 * 2000.0 * TAU / 60.0;
    let apart = (half * half + tilting / 0.2).sqrt();
    for (mode, (expected, whirl)) in found[2..].iter().zip([
        (apart - half, Whirl::Backward),
        (apart + half, Whirl::Forward),
    ]) {
        close(TAU * mode.frequency, expected, 1e-5);
        assert_eq!(mode.whirl, whirl);
    }
    let question = CampbellQuestion {
        rotor: definition,
        from: 0.0,
        to: 200.0,
        count: 5,
        orders: vec![1.0],
        highest_frequency: None,
    };
    let campbell = question.solve(&NEVER).expect("a diagram");
    let first = &campbell.critical_speeds[0];
    close(first.speed, bouncing, 1e-5);
    assert!(
        first.reduction_error.is_some_and(|error| error < 1e-3),
        "{first:?}"
    );
    // four branches of the disc from end to end
    for branch in &campbell.branches[..4] {
        assert!(branch.modes.iter().all(Option::is_some));
    }
}

/// A place on the shaft 10 mm beside another makes a mode far above all others, and is what a hint of slowness names.
#[test]
fn the_fastest_mode_is_named_by_the_places_that_move() {
    let rotor = |text: &str| Rotor::assemble(&scenario(text).question.rotor).expect("a rotor");
    let (without, places) = rotor(WITHOUT_Z).fastest().expect("a mode");
    assert!(!places.contains("276.7 mm"), "{places}");
    let plane = "[[unbalance]]\namount = \"1 g mm\"\nposition = \"0.2766667 m\"\n[[element]]";
    let (with, places) = rotor(&WITHOUT_Z.replacen("[[element]]", plane, 1))
        .fastest()
        .expect("a mode");
    assert!(
        with > 2.0 * without,
        "{with} Hz, without the plane {without} Hz"
    );
    assert_eq!(places, "tilt of the shaft at 276.7 mm");
}

/// Tables are of jones and films at constant speed; elsewhere they are not to be advised.
#[test]
fn tables_are_advised_where_they_are_compiled() {
    let gains = |contact: &str, speed: &str| {
        let text = format!(
            "[shaft]\nmass = \"5 kg\"\nfreedoms = \"radial\"\n[model]\ncontact = \"{contact}\"\n[[bearing]]\n\
             catalogue = \"6205\"\n[speed]\n{speed}\n[time]\nduration = \"0.4 s\"\nsettle = \"0.2 s\"\n"
        );
        let rotor = scenario(&text).question.rotor;
        Rotor::assemble(&rotor)
            .expect("a rotor")
            .gains_from_tables()
    };
    let constant = "constant = \"1500 rpm\"";
    let sweep = "from = \"0 rpm\"\nto = \"1500 rpm\"\nover = \"0.4 s\"";
    assert!(gains("jones", constant));
    assert!(!gains("hertz", constant));
    assert!(!gains("linear", constant));
    assert!(!gains("jones", sweep));
}

/// A damping ratio of 3 is most often 3 percent.
#[test]
fn a_damping_ratio_in_percent_is_told() {
    let told = |ratio: &str| {
        let text = format!("{WITHOUT_Z}[damping]\nratio = {ratio}\n");
        speed_warnings(&scenario(&text).question.rotor)
    };
    for ratio in ["0", "0.03", "0.999"] {
        assert_eq!(told(ratio), Vec::<String>::new());
    }
    let [warning] = &told("3")[..] else {
        panic!("a warning");
    };
    assert!(
        warning.contains("if 3 % is meant, write ratio = 0.03"),
        "{warning}"
    );
    assert!(told("1")[0].contains("ratio = 0.01"));
}
