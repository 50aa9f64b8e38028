//! Shafts that bend, as a user writes them: book cases, limits, the stated error, and every verb.

use std::f64::consts::{PI, TAU};
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use tempfile::TempDir;

use crate::support::{done, jeffcott_in, told};

/// Of the book cases: G = 81.2 GPa.
const BOOK_STEEL: &str = "material = { youngs_modulus = \"211 GPa\", poisson_ratio = 0.29926108374384236, density = \
                          \"7810 kg/m^3\" }\n";

/// A folder with a scenario in it, and what the command makes of it there.
struct Scene(TempDir);

impl Scene {
    fn new(text: &str) -> Self {
        let folder = TempDir::new().expect("a temporary folder");
        fs::write(folder.path().join("shaft.toml"), text).expect("a written file");
        Self(folder)
    }

    #[track_caller]
    fn ask(&self, arguments: &[&str]) -> &Self {
        let named = [
            &[arguments[0], "shaft.toml"],
            &arguments[1..],
            &["--out", "out"],
        ]
        .concat();
        done(jeffcott_in(self.0.path(), &named));
        self
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.path().join("out/shaft").join(name)
    }

    fn json(&self, name: &str) -> Value {
        let text = fs::read_to_string(self.file(name)).expect("a file");
        serde_json::from_str(&text).expect("JSON")
    }

    /// A column of a table; empty cells are not numbers.
    fn column(&self, file: &str, name: &str) -> Vec<f64> {
        let text = fs::read_to_string(self.file(file)).expect("a file");
        let mut lines = text.lines();
        let header = lines.next().expect("a header");
        let index = header.split(',').position(|column| column == name);
        let index = index.unwrap_or_else(|| panic!("no {name} in {header}"));
        let cells = lines.map(|line| line.split(',').nth(index).unwrap_or_default());
        cells.map(|cell| cell.parse().unwrap_or(f64::NAN)).collect()
    }
}

/// A bearing of constant stiffness in N/m.
fn linear(position: &str, stiffness: &str) -> String {
    format!(
        "[[element]]\nposition = \"{position}\"\nlinear = {{ stiffness = {{ x = \"{stiffness} N/m\", y = \"{stiffness} \
         N/m\" }} }}\n"
    )
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64) {
    let apart = (found / expected - 1.0).abs();
    assert!(
        apart < tolerance,
        "{found} instead of {expected}: {apart:.1e} apart"
    );
}

/// Natural frequencies of all branches at an end of the diagram, lowest first, rad/s.
fn frequencies(campbell: &Value, end: &str) -> Vec<f64> {
    let branches = campbell["branches"].as_array().expect("branches").iter();
    let known = branches.filter_map(|branch| branch[end].as_f64());
    let mut known: Vec<f64> = known.map(|frequency| TAU * frequency).collect();
    known.sort_by(f64::total_cmp);
    known
}

/// Source: Friswell et al., *Dynamics of Rotating Machines* (2010), example 5.9.1, and the same with 48 elements.
#[test]
fn a_book_shaft_has_its_printed_frequencies_and_critical_speeds() {
    let disc = |position: &str, diameter: &str| {
        format!(
            "[[disc]]\nposition = \"{position}\"\nouter_diameter = \"{diameter}\"\nwidth = \"0.07 m\"\n{BOOK_STEEL}"
        )
    };
    let scene = Scene::new(&format!(
        "[shaft]\nfreedoms = \"radial\"\nmodes = 14\n{BOOK_STEEL}[[shaft.section]]\nlength = \"1.5 m\"\nouter_diameter = \
         \"50 mm\"\n{}{}{}{}[speed]\nconstant = \"1000 rpm\"\n",
        disc("0.5 m", "0.28 m"),
        disc("1 m", "0.35 m"),
        linear("0 m", "1e6"),
        linear("1.5 m", "1e6"),
    ));
    let all = ["--highest-frequency", "1 kHz"];
    scene.ask(&[&["campbell", "--to", "4000 rpm", "--count", "21"][..], &all].concat());
    let campbell = scene.json("campbell.json");
    let at_rest = frequencies(&campbell, "first_Hz");
    for (pair, expected) in at_rest.chunks(2).zip([86.658, 274.313, 716.786]) {
        // the book's six elements are 3e-4 too stiff at the third pair
        close(pair[0], expected, 4e-4);
        close(pair[1], pair[0], 1e-6);
    }
    let turning = frequencies(&campbell, "last_Hz");
    let expected = [85.389, 87.796, 251.785, 294.713, 600.082, 826.659];
    for (found, expected) in turning.iter().zip(expected) {
        close(*found, expected, 3e-5);
    }
    let critical = campbell["critical_speeds"].as_array().expect("a list");
    assert_eq!(critical.len(), 4);
    for (found, expected) in critical.iter().zip([825.13, 829.87, 2487.76, 2756.09]) {
        let speed = found["speed_rad_s"].as_f64().expect("a speed");
        close(60.0 / TAU * speed, expected, 4e-5);
    }
}

/// A steel shaft of 25 mm and 1 m between pins: 50.990, 203.50 and 456.18 Hz; of Euler's beam 51.029 Hz.
#[test]
fn a_pinned_shaft_has_the_frequencies_of_a_timoshenko_beam() {
    let scene = Scene::new(&format!(
        "[shaft]\nfreedoms = \"radial\"\nmodes = 14\n{BOOK_STEEL}[[shaft.section]]\nlength = \"1 m\"\nouter_diameter = \"25 \
         mm\"\n{}{}[speed]\nconstant = \"0 rpm\"\n",
        linear("0 m", "1e12"),
        linear("1 m", "1e12"),
    ));
    let all = ["--highest-frequency", "1 kHz"];
    scene.ask(&[&["campbell", "--to", "1 rpm", "--count", "2"][..], &all].concat());
    let found = frequencies(&scene.json("campbell.json"), "first_Hz");
    for (found, expected) in found.iter().step_by(2).zip([50.990, 203.50, 456.18]) {
        close(*found, TAU * expected, 2e-5);
    }
}

/// A Laval rotor with damping from outside on its disc and damping τ K inside its shaft.
fn internally_damped(speed: f64, more: &str) -> Scene {
    Scene::new(&format!(
        "[shaft]\nfreedoms = \"radial\"\nmodes = 2\ninternal_damping = \"200 us\"\nmaterial = {{ youngs_modulus = \"210 \
         GPa\", density = \"780 kg/m^3\" }}\n[[shaft.section]]\nlength = \"0.6 m\"\nouter_diameter = \"20 mm\"\n[[disc]]\n\
         position = \"0.3 m\"\nmass = \"8 kg\"\ninertia_transverse = \"0.02 kg m^2\"\ninertia_polar = \"0.03 kg m^2\"\n\
         {}{}[damping]\ncoefficients = {{ x = \"100 N s/m\", y = \"100 N s/m\" }}\n[speed]\nconstant = \"{speed} rad/s\"\n\
         {more}",
        linear("0 m", "1e9"),
        linear("0.6 m", "1e9"),
    ))
}

/// `ω (1 + c_outside/c_inside)` of a shaft without mass, c_inside = τ k and k = 48 E I/l³.
#[test]
fn internal_damping_drives_a_whirl_above_its_analytic_onset() {
    let stiffness = 48.0 * 210e9 * PI * 0.02_f64.powi(4) / 64.0 / 0.6_f64.powi(3);
    let scene = internally_damped(100.0, "");
    scene.ask(&["campbell", "--to", "800 rad/s", "--count", "41"]);
    let [speeds, ratios, frequencies] = ["speed_rad_s", "damping_ratio", "frequency_Hz"]
        .map(|name| scene.column("campbell.csv", name));
    let text = fs::read_to_string(scene.file("campbell.csv")).expect("a table");
    let forward = text.lines().skip(1).map(|line| line.contains(",forward,"));
    let rows = speeds.iter().zip(&ratios).zip(&frequencies).zip(forward);
    // the overdamped modes of the shaft's own mass stand far from the disc's
    let of_disc = rows.filter(|(((_, ratio), frequency), forward)| {
        *forward && (30.0..38.0).contains(*frequency) && **ratio < 0.1
    });
    let mut of_disc: Vec<_> = of_disc.map(|(((v, d), f), _)| (*v, *d, TAU * f)).collect();
    of_disc.sort_by(|a, b| a.0.total_cmp(&b.0));
    let crossing = of_disc
        .windows(2)
        .find(|pair| pair[0].1 > 0.0 && pair[1].1 <= 0.0);
    let [below, above] = crossing.expect("an onset") else {
        unreachable!("pairs");
    };
    let onset = below.0 + (above.0 - below.0) * below.1 / (below.1 - above.1);
    close(onset, below.2 * (1.0 + 100.0 / (200e-6 * stiffness)), 3e-3);
    for (speed, grows) in [(onset - 60.0, false), (onset + 60.0, true)] {
        let start = "[initial]\ndisplacement = { x = \"10 um\" }\n[time]\nduration = \"1 s\"\nsettle = \"0 s\"\n\
                     [integrator]\nmethod = \"rodas\"\ntolerance = 1e-6\n";
        let scene = internally_damped(speed, start);
        scene.ask(&["run", "--no-verify"]);
        let x = scene.column("trace.csv", "x_m");
        let largest = |part: &[f64]| part.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let (early, late) = (largest(&x[..x.len() / 4]), largest(&x[3 * x.len() / 4..]));
        assert_eq!(
            late > early,
            grows,
            "{early:e} then {late:e} at {speed} rad/s"
        );
    }
}

const BALLS: &str = "[[bearing]]\ncatalogue = \"6205\"\nposition = \"{left}\"\n[[bearing]]\ncatalogue = \"6205\"\nposition = \
                     \"{right}\"\n[[load]]\nconstant = { x = \"300 N\" }\nposition = \"{load}\"\n[damping]\ncoefficients = { \
                     x = \"200 N s/m\", y = \"200 N s/m\", z = \"200 N s/m\", tilt = \"2 N m s/rad\" }\n[speed]\nconstant = \
                     \"1500 rpm\"\n[time]\nduration = \"0.1 s\"\nsettle = \"0 s\"\n[output]\nchannels = [\"x\", \"y\", \"z\", \
                     \"tilt_x\", \"tilt_y\"]\n";

fn on_balls(shaft: &str, places: [&str; 3]) -> Scene {
    let [left, right, load] = places;
    let balls = BALLS.replace("{left}", left).replace("{right}", right);
    Scene::new(&format!("{shaft}{}", balls.replace("{load}", load)))
}

/// A shaft of 400 mm and a tube's worth of mass, so thick that it is ten thousand times stiffer than one of 40 mm.
#[test]
fn a_stiff_shaft_moves_as_a_rigid_one() {
    let (radius, length, density) = (0.2_f64, 0.4_f64, 78.5);
    let own = density * PI * radius * radius * length;
    let mass = own + 6.0;
    let transverse = own * (3.0 * radius * radius + length * length) / 12.0 + 0.02;
    let polar = own * radius * radius / 2.0 + 0.03;
    let rigid = format!(
        "[shaft]\ngravity = true\nfreedoms = \"all\"\nmass = \"{mass} kg\"\ninertia_transverse = \"{transverse} kg m^2\"\n\
         inertia_polar = \"{polar} kg m^2\"\neccentricity = \"{} m\"\n",
        60e-6 / mass
    );
    let stiff = "[shaft]\ngravity = true\nmaterial = { youngs_modulus = \"210 GPa\", density = \"78.5 kg/m^3\" }\n\
                 [[shaft.section]]\nlength = \"400 mm\"\nouter_diameter = \"400 mm\"\n[[disc]]\nposition = \"200 mm\"\nmass = \
                 \"6 kg\"\ninertia_transverse = \"0.02 kg m^2\"\ninertia_polar = \"0.03 kg m^2\"\n[[unbalance]]\nposition = \
                 \"200 mm\"\namount = \"60 g mm\"\n[integrator]\nmethod = \"rodas\"\ntolerance = 1e-6\n";
    let rigid = on_balls(&rigid, ["-150 mm", "130 mm", "180 mm"]);
    let stiff = on_balls(stiff, ["50 mm", "330 mm", "380 mm"]);
    for scene in [&rigid, &stiff] {
        scene.ask(&["run", "--no-verify"]);
    }
    for name in ["x_m", "y_m", "z_m", "tilt_x_rad", "tilt_y_rad"] {
        let [rigid, stiff] = [&rigid, &stiff].map(|scene| scene.column("trace.csv", name));
        let most = rigid.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let swing = most - rigid.iter().copied().fold(f64::INFINITY, f64::min);
        let apart = rigid.iter().zip(&stiff).map(|(a, b)| (a - b).abs());
        let apart = apart.fold(0.0, f64::max);
        // the stiffness of the bearings over that of the shaft is some thousandths
        assert!(
            apart < 5e-3 * swing,
            "{name}: {:.1e} of the motion",
            apart / swing
        );
    }
}

const ON_TWO_6205: &str = "[[shaft.section]]\nlength = \"500 mm\"\nouter_diameter = \"25 mm\"\n[[disc]]\nposition = \"250 \
                           mm\"\nmass = \"5 kg\"\ninertia_transverse = \"0.01 kg m^2\"\ninertia_polar = \"0.015 kg m^2\"\n\
                           [[unbalance]]\namount = \"50 g mm\"\nposition = \"250 mm\"\n[[bearing]]\ncatalogue = \"6205\"\n\
                           position = \"20 mm\"\n[[bearing]]\ncatalogue = \"6205\"\nposition = \"480 mm\"\n[[load]]\nconstant \
                           = { x = \"300 N\" }\nposition = \"100 mm\"\n[damping]\nratio = 0.03\n[speed]\nconstant = \"1500 \
                           rpm\"\n[time]\nduration = \"0.1 s\"\nsettle = \"0 s\"\n";

/// The largest difference of some columns of two scenes.
fn apart(scenes: [&Scene; 2], file: &str, names: &[&str]) -> f64 {
    let largest = |name: &&str| {
        let [own, exact] = scenes.map(|scene| scene.column(file, name));
        let differences = own.iter().zip(&exact).map(|(a, b)| (a - b).abs());
        differences.fold(0.0, f64::max)
    };
    names.iter().map(largest).fold(0.0, f64::max)
}

#[track_caller]
fn within_three(stated: f64, true_one: f64) {
    let ratio = stated / true_one;
    assert!(
        (1.0 / 3.0..3.0).contains(&ratio),
        "{stated:e} stated, {true_one:e}"
    );
}

/// Rows of the chapter's table of stated and true errors: modes a plane and both, nm.
fn documented_errors() -> Vec<[f64; 3]> {
    let chapter = include_str!("../../docs/flexible-shafts.md");
    let header = "| modes a plane | stated, nm | true, nm |";
    let rows = chapter.lines().skip_while(|line| *line != header);
    let rows = rows.skip(2).take_while(|line| line.starts_with('|'));
    let numbers = |row: &str| {
        let cells = row.trim_matches('|').split('|');
        let numbers: Vec<f64> = cells
            .map(|cell| cell.trim().parse().expect("a number"))
            .collect();
        numbers.try_into().expect("three numbers")
    };
    rows.map(numbers).collect()
}

/// Against a run with 24 modes a plane, and as the chapter says.
#[test]
fn the_stated_error_of_the_reduction_is_the_true_one() {
    let with = |modes: usize| {
        Scene::new(&format!(
            "[shaft]\ngravity = true\nmodes = {modes}\n{ON_TWO_6205}"
        ))
    };
    let true_one = with(24);
    true_one.ask(&["run", "--no-verify"]);
    let table = documented_errors();
    assert_eq!(table.len(), 4);
    for [modes, documented @ ..] in table {
        let scene = with(modes as usize);
        scene.ask(&["run"]);
        let reduction = &scene.json("summary.json")["reduction"];
        let stated = reduction["error"]["displacement_m"]
            .as_f64()
            .expect("an error");
        let exact = apart([&scene, &true_one], "trace.csv", &["x_m", "y_m", "z_m"]);
        within_three(stated, exact);
        for (found, documented) in [stated, exact].into_iter().zip(documented) {
            let ratio = 1e9 * found / documented;
            assert!(
                (0.97..1.03).contains(&ratio),
                "{modes} modes: {found:e} for {documented} nm"
            );
        }
    }
}

/// The same of a steady motion, an unbalance at a third of a shaft on stiff supports.
#[test]
fn the_stated_error_of_a_reduction_is_the_true_one() {
    let with = |modes: usize, more: &[&str]| {
        let scene = Scene::new(&format!(
            "[shaft]\nfreedoms = \"radial\"\nmodes = {modes}\nobserved = \"0.3 m\"\n[[shaft.section]]\nlength = \"0.8 m\"\n\
             outer_diameter = \"40 mm\"\n[[disc]]\nposition = \"0.3 m\"\nouter_diameter = \"250 mm\"\nwidth = \"40 mm\"\n\
             [[unbalance]]\namount = \"200 g mm\"\nposition = \"0.3 m\"\n{}{}[damping]\nratio = 0.02\n[speed]\nconstant = \
             \"9000 rpm\"\n[time]\nduration = \"0.1 s\"\nsettle = \"0 s\"\n",
            linear("0 m", "1e8"),
            linear("0.8 m", "1e8"),
        ));
        scene.ask(&[&["steady"], more].concat());
        scene
    };
    let true_one = with(12, &["--no-verify"]);
    for modes in [0, 2] {
        let scene = with(modes, &[]);
        let reduction = &scene.json("steady.json")["reduction"];
        let stated = reduction["error"]["displacement_m"]
            .as_f64()
            .expect("an error");
        within_three(
            stated,
            apart([&scene, &true_one], "steady_trace.csv", &["x_m", "y_m"]),
        );
    }
}

/// Unbalance planes, a moving base, a housing, a run-up and a drive on a shaft that bends.
#[test]
fn every_kind_of_scene_runs() {
    let ramp = ON_TWO_6205.replace(
        "constant = \"1500 rpm\"",
        "from = \"600 rpm\"\nto = \"1500 rpm\"\nover = \"50 ms\"",
    );
    let housed = ON_TWO_6205.replace(
        "position = \"480 mm\"\n",
        "position = \"480 mm\"\nhousing = { mass = \"8 kg\", stiffness = { x = \"100 N/um\", y = \"100 N/um\", z = \"100 \
         N/um\" }, damping = { x = \"500 N s/m\", y = \"500 N s/m\", z = \"500 N s/m\" } }\n",
    );
    let shaken = format!(
        "{ON_TWO_6205}[[load]]\nbase = {{ shock = {{ peak = {{ y = \"1 gn\" }}, duration = \"1 ms\", at = \"20 ms\" }} }}\n"
    );
    let planes = format!(
        "{ON_TWO_6205}[[unbalance]]\namount = \"20 g mm\"\nangle = \"90 deg\"\nposition = \"400 mm\"\n"
    );
    let driven = ON_TWO_6205.replace(
        "constant = \"1500 rpm\"",
        "drive = { torque = \"2 N m\", no_load_speed = \"1500 rpm\", load_torque = \"0.2 N m\" }",
    );
    for text in [ramp, housed, planes, shaken, driven] {
        let short = text.replace("duration = \"0.1 s\"", "duration = \"0.05 s\"");
        let scene = Scene::new(&format!(
            "[shaft]\ngravity = true\n{short}[output]\nspectrum = false\n"
        ));
        scene.ask(&["run", "--no-verify"]);
    }
}

/// Weight bends a shaft between its bearings down, and the first whirl of a whirling disc goes round.
#[test]
fn deflection_and_mode_shapes_are_drawn() {
    let scene = Scene::new(&format!("[shaft]\ngravity = true\n{ON_TWO_6205}"));
    scene.ask(&["bearing"]);
    scene.ask(&["campbell", "--to", "1500 rpm", "--count", "2"]);
    let drawn = |name: &str| fs::read_to_string(scene.file(name)).expect("a figure");
    let deflection = drawn("deflection.svg");
    for words in [
        "undeformed",
        "deflection along x in µm",
        "deflection along y in µm",
        "position in mm",
    ] {
        assert!(deflection.contains(words), "no {words}");
    }
    let modes = drawn("mode_shapes.svg");
    for words in ["Hz, backward", "Hz, forward", "a quarter of a period later"] {
        assert!(modes.contains(words), "no {words}");
    }
}

/// What `campbell` states of its critical speeds, against the frequencies with many modes.
#[test]
fn the_reduction_error_of_critical_speeds_is_the_true_one() {
    let critical = |modes: usize| {
        let scene = Scene::new(&format!(
            "[shaft]\nfreedoms = \"radial\"\nmodes = {modes}\n[[shaft.section]]\nlength = \"0.8 m\"\nouter_diameter = \"40 \
             mm\"\n[[disc]]\nposition = \"0.3 m\"\nouter_diameter = \"250 mm\"\nwidth = \"40 mm\"\n{}{}[speed]\nconstant = \
             \"1500 rpm\"\n",
            linear("0 m", "1e8"),
            linear("0.8 m", "1e8"),
        ));
        scene.ask(&["campbell", "--to", "40000 rpm", "--count", "9"]);
        scene.json("campbell.json")["critical_speeds"].clone()
    };
    let fine = critical(40);
    let fine = fine.as_array().expect("a list");
    for modes in [0, 2, 8, 12] {
        let coarse = critical(modes);
        let coarse = coarse.as_array().expect("a list");
        assert!(coarse.len() >= 2, "{coarse:?}");
        for (coarse, fine) in coarse.iter().zip(fine).take(2) {
            let number = |of: &Value, key: &str| of[key].as_f64().expect("a number");
            let stated = number(coarse, "reduction_error");
            let true_error = number(coarse, "frequency_Hz") / number(fine, "frequency_Hz") - 1.0;
            within_three(stated, true_error.abs());
        }
    }
}

/// √(k/m) of a disc in the middle of a massless shaft on stiff supports, with 1/k = L³/(48 E I) + L/(4 κ G A) + 1/(2 k_s).
#[test]
fn a_massless_shaft_has_the_frequency_of_a_laval_rotor() {
    let (length, diameter, mass) = (0.6_f64, 0.02_f64, 8.0_f64);
    let small = |position: &str| {
        format!(
            "[[disc]]\nposition = \"{position}\"\nmass = \"1 g\"\ninertia_transverse = \"1e-7 kg m^2\"\n{}",
            linear(position, "1e11")
        )
    };
    let text = format!(
        "[shaft]\nfreedoms = \"radial\"\nmassless = true\nmaterial = {{ youngs_modulus = \"210 GPa\", poisson_ratio = 0.3 }}\n\
         [[shaft.section]]\nlength = \"0.6 m\"\nouter_diameter = \"20 mm\"\n[[disc]]\nposition = \"0.3 m\"\nmass = \"8 kg\"\n\
         inertia_transverse = \"0.02 kg m^2\"\n{}{}[speed]\nconstant = \"1500 rpm\"\n",
        small("0 m"),
        small("0.6 m"),
    );
    let scene = Scene::new(&text);
    scene.ask(&["campbell", "--to", "1500 rpm", "--count", "3"]);
    let (modulus, poisson) = (210e9, 0.3);
    let second_moment = PI * diameter.powi(4) / 64.0;
    let area = PI * diameter * diameter / 4.0;
    let cowper = 6.0 * (1.0 + poisson) / (7.0 + 6.0 * poisson);
    let shear = cowper * modulus / (2.0 * (1.0 + poisson)) * area;
    let supports = 1.0 / (2.0 * 1e11);
    let compliance =
        length.powi(3) / (48.0 * modulus * second_moment) + length / (4.0 * shear) + supports;
    let found = frequencies(&scene.json("campbell.json"), "last_Hz");
    close(found[0], (1.0 / (compliance * mass)).sqrt(), 1e-6);
}

/// The inner rings are the mass that the shaft has at its bearings.
#[test]
fn a_massless_shaft_runs_on_ball_bearings() {
    let bearing = |position: &str, facing: &str| {
        format!(
            "[[bearing]]\ncatalogue = \"6204\"\nposition = \"{position}\"\npreload = \"100 N\"\nfacing = \"{facing}\"\n"
        )
    };
    let text = |more: &str| {
        format!(
            "[shaft]\nmassless = true\ngravity = true\n[[shaft.section]]\nlength = \"0.6 m\"\n\
             outer_diameter = \"20 mm\"\n[[disc]]\nposition = \"0.3 m\"\nouter_diameter = \"200 mm\"\nwidth = \"30 mm\"\n\
             {}{}{more}[damping]\nratio = 0.03\n[speed]\nconstant = \"1500 rpm\"\n[model]\ncage = \"frozen\"\n[time]\n\
             duration = \"0.02 s\"\nsettle = \"0.01 s\"\n[output]\nspectrum = false\n",
            bearing("20 mm", "+z"),
            bearing("580 mm", "-z"),
        )
    };
    let scene = Scene::new(&text(""));
    scene.ask(&["run"]);
    let y = scene.column("trace.csv", "y_m");
    let (stiffness, weight) = (
        48.0 * 210e9 * PI * 0.02_f64.powi(4) / 64.0 / 0.56_f64.powi(3),
        72.0,
    );
    let sag = weight / stiffness;
    let mean = -y.iter().sum::<f64>() / y.len() as f64;
    // the moments of the bearings stiffen the shaft, their clearance and contacts let it sink
    assert!(
        (0.5 * sag..2.0 * sag).contains(&mean),
        "{mean} beside {sag}"
    );

    let pushed = Scene::new(&text(
        "[[load]]\nharmonic = { amplitude = { y = \"10 N\" }, frequency = \"40 Hz\" }\nposition = \"100 mm\"\n",
    ));
    let output = jeffcott_in(pushed.0.path(), &["run", "shaft.toml", "--out", "out"]);
    assert_eq!(output.status.code(), Some(1), "{}", told(&output));
    assert!(
        told(&output).contains("of the shaft at 100.0 mm have no mass"),
        "{}",
        told(&output)
    );
}

/// A shaft of which the only bearing lets it tilt.
#[test]
fn an_unconstrained_shaft_is_refused() {
    let scene = Scene::new(&format!(
        "[shaft]\nfreedoms = \"radial\"\n[[shaft.section]]\nlength = \"0.5 m\"\nouter_diameter = \"25 mm\"\n[damping]\nratio \
         = 0.02\n{}[speed]\nconstant = \"1500 rpm\"\n[time]\nduration = \"0.1 s\"\nsettle = \"0 s\"\n",
        linear("20 mm", "1e6"),
    ));
    let output = jeffcott_in(scene.0.path(), &["run", "shaft.toml", "--out", "out"]);
    assert_eq!(output.status.code(), Some(1), "{}", told(&output));
    assert!(
        told(&output).contains("nothing holds the shaft"),
        "{}",
        told(&output)
    );
    assert!(!Path::new(&scene.file("summary.json")).exists());
}

/// What is written out with its defaults, as a study does, says no more than the scenario.
#[test]
fn a_study_of_linear_bearings_runs() {
    let scene = Scene::new(&format!(
        "[shaft]\nfreedoms = \"radial\"\nmodes = 0\n[[shaft.section]]\nlength = \"0.5 m\"\nouter_diameter = \"25 mm\"\n\
         [[unbalance]]\namount = \"50 g mm\"\nposition = \"0.25 m\"\n[damping]\nratio = 0.1\n{}{}[speed]\nconstant = \"1500 \
         rpm\"\n[time]\nduration = \"0.1 s\"\nsettle = \"0 s\"\n",
        linear("0 mm", "1e7"),
        linear("500 mm", "1e7"),
    ));
    let study = "base = \"shaft.toml\"\n[[axis]]\nkey = \"speed.constant\"\nvalues = [\"1400 rpm\", \"1500 rpm\"]\n";
    fs::write(scene.0.path().join("study.toml"), study).expect("a written file");
    let output = jeffcott_in(scene.0.path(), &["study", "study.toml", "--out", "out"]);
    assert!(output.status.success(), "{}", told(&output));
}
