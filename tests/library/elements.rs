//! Elements besides the bearings: against closed forms, and in scenes.

use std::f64::consts::TAU;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64};

use nalgebra::Complex;

use crate::analysis::Channel;
use crate::integrate::Method;
use crate::rotor::{Coupling, ElementLaw, Rotor, Works};
use crate::scenario::{Scenario, ScenarioError, load};
use crate::simulate::RecordedRun;
use crate::steady::{Steady, SteadyQuestion, steady};
use crate::study::campbell::{CampbellQuestion, NEVER};
use crate::tests::support::{assert_near, scenario};

const SPRING: &str = "[[element]]\nlinear = { stiffness = { x = \"1 N/um\", y = \"1 N/um\" }, damping = { x = \"40 N s/m\", y = \
                      \"40 N s/m\" } }\n";
const RUB: &str = "[[element]]\n[element.rub]\nclearance = \"50 um\"\nstiffness = \"2 N/um\"\nfriction = 0.1\nshaft_diameter = \"40 mm\"\n";
const FILM: &str = "[[element]]\n[element.squeeze_film]\ndiameter = \"100 mm\"\nlength = \"20 mm\"\nclearance = \"0.1 mm\"\nviscosity = \
                    \"5 mPa s\"\n";

const COUPLING: &str = "[[element]]\n[element.coupling]\nbending_stiffness = \"800 N m/rad\"\nbending_damping = \"0.02 N m s/rad\"\nlength = \"80 \
                        mm\"\ntorque = \"40 N m\"\noffset = \"0.1 mm\"\nangle = \"0.3 deg\"\ndirection = \"30 deg\"\ntowards = \"-z\"\n";

/// A mass of 5 kg without weight, so far beside the axis, at a speed in rad/s.
fn laval(eccentricity: &str, speed: f64, parts: &[&str]) -> String {
    format!(
        "[shaft]\nmass = \"5 kg\"\neccentricity = \"{eccentricity}\"\nfreedoms = \"radial\"\n{}[speed]\nconstant = \"{speed} rad/s\"\n\
         [time]\nduration = \"0.5 s\"\nsettle = \"0.3 s\"\n[integrator]\ntolerance = 1e-11\nverify = false\n",
        parts.concat()
    )
}

/// A scenario in a folder, whose files it names.
fn loaded(folder: &Path, text: &str) -> Result<Scenario, ScenarioError> {
    let path = folder.join("scene.toml");
    std::fs::write(&path, text).expect("a file");
    load(&path)
}

#[track_caller]
fn settled(text: &str) -> Steady {
    let model = scenario(text).model.expect("a motion");
    let (stop, integrated) = (AtomicBool::new(false), AtomicU64::new(0));
    let question = SteadyQuestion {
        model: &model,
        multiple: None,
        stop: &stop,
        integrated: &integrated,
    };
    steady(&question).unwrap_or_else(|error| panic!("{error}"))
}

/// A circle of that radius.
#[track_caller]
fn assert_whirls(found: &Steady, speed: f64, radius: f64) {
    for axis in 0..2 {
        assert_near(
            "whirl",
            amplitude(found, axis, speed),
            radius,
            1e-8 * radius,
        );
    }
}

fn amplitude(found: &Steady, axis: usize, speed: f64) -> f64 {
    let channel = Channel::Displacement(axis);
    found
        .lines
        .amplitude(channel, speed / TAU)
        .expect("a channel")
}

/// The root of a rising function.
fn bisect(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Forward whirl all along the ring: `|K r + k (1 − δ/r) r (1 + iμ) − m ω² r + i c ω r| = m e ω²`.
#[test]
fn a_full_forward_rub_whirls_with_the_closed_form_amplitude() {
    let (mass, stiffness, damping, e) = (5.0, 1e6, 40.0, 20e-6);
    for speed in [430.0, 480.0, 520.0] {
        let dynamic = |r: f64| {
            let sliding = speed * (0.02 + r);
            let friction = 0.1 * sliding / sliding.hypot(1e-3);
            let pressed = 2e6 * (1.0 - 5e-5 / r);
            let own = Complex::new(stiffness - mass * speed * speed, damping * speed);
            r * (own + pressed * Complex::new(1.0, friction)).norm() - mass * e * speed * speed
        };
        let expected = bisect(5e-5, 1e-3, dynamic);
        assert!(expected > 5.5e-5, "{expected}");
        let found = settled(&laval("20 um", speed, &[SPRING, RUB]));
        assert_whirls(&found, speed, expected);
    }
}

/// A circle about the centre with the film's forces of the closed form, from small to far out.
#[test]
fn a_squeeze_film_whirls_with_the_closed_form_amplitude() {
    let (mass, stiffness, damping, c) = (5.0, 1e6, 40.0, 1e-4);
    let size = 0.005 * 0.05 * 0.02_f64.powi(3) / (c * c * c);
    for (eccentricity, e) in [("1 um", 1e-6), ("20 um", 20e-6), ("90 um", 90e-6)] {
        for speed in [300.0, 447.0, 900.0] {
            let dynamic = |r: f64| {
                let ratio: f64 = r / c;
                let rest = 1.0 - ratio * ratio;
                let along = size * speed * std::f64::consts::FRAC_PI_2 / rest.powf(1.5);
                let across = size * speed * 2.0 * ratio / (rest * rest);
                let own = Complex::new(stiffness - mass * speed * speed, damping * speed);
                r * (own + Complex::new(across, along)).norm() - mass * e * speed * speed
            };
            let expected = bisect(0.0, (1.0 - 1e-12) * c, dynamic);
            let found = settled(&laval(eccentricity, speed, &[SPRING, FILM]));
            println!(
                "ε {:.3}: {:e}",
                expected / c,
                amplitude(&found, 0, speed) / expected - 1.0
            );
            assert_whirls(&found, speed, expected);
        }
    }
}

/// Springs and reaction are the slopes of the energy of both joints, torque that of a turned vector.
#[test]
fn a_coupling_acts_as_its_joints_store_energy() {
    for side in [1.0, -1.0] {
        let coupling = Coupling {
            bending_stiffness: 800.0,
            bending_damping: 0.4,
            length: 0.08,
            torque: 0.0,
            offset: 2e-4,
            angle: 3e-3,
            direction: 0.7,
            side,
        };
        let (sin, cos) = coupling.direction.sin_cos();
        // of displacements x, y and slopes dx/dz = θy, dy/dz = −θx
        let energy = |q: [f64; 5]| {
            let plane = |u: f64, slope: f64, part: f64| {
                let spacer = side * (part * coupling.offset - u) / coupling.length;
                400.0 * ((spacer - slope).powi(2) + (part * coupling.angle - spacer).powi(2))
            };
            plane(q[0], q[4], cos) + plane(q[1], -q[3], sin)
        };
        let (at, law) = ([3e-5, -2e-5, 0.0, 1e-3, 4e-4], coupling.law());
        let held = law.stiffness * nalgebra::SVector::from(at);
        for axis in [0, 1, 3, 4] {
            let step = 1e-5;
            let moved = |step: f64| {
                let mut moved = at;
                moved[axis] += step;
                energy(moved)
            };
            let slope = (moved(step) - moved(-step)) / (2.0 * step);
            let force = held[axis] - coupling.reaction()[axis];
            assert_near("force", force, slope, 1e-9 * slope.abs() + 1e-9);
        }
        assert!((law.damping - law.stiffness * 5e-4).amax() < 1e-12 * law.stiffness.amax());
        let turned = Coupling {
            torque: 40.0,
            ..coupling
        };
        let more = turned.reaction();
        let still = coupling.reaction();
        let more: Vec<f64> = more.iter().zip(still).map(|(a, b)| a - b).collect();
        let (across, about) = (40.0 * 3e-3 / 0.08, 40.0 * 2e-4 / 0.08);
        for (found, expected) in
            more.iter()
                .zip([-across * sin, across * cos, 0.0, about * cos, about * sin])
        {
            assert_near("torque", *found, expected, 1e-12);
        }
    }
}

/// The lines at 1× and 2× on a round spring: reaction over dynamic stiffness; with the unbalance on the same side.
#[test]
fn a_misaligned_coupling_shakes_at_1x_and_2x() {
    let (mass, speed) = (5.0, 200.0);
    let found = settled(&laval("0 um", speed, &[SPRING, COUPLING]));
    let (joint, length): (f64, f64) = (800.0, 0.08);
    let angle = 0.3_f64.to_radians();
    let along = 2.0 * joint * 1e-4 / (length * length) + joint * angle / length;
    let across = 40.0 * angle / length;
    let (sin, cos) = 30.0_f64.to_radians().sin_cos();
    let reaction = [along * cos - across * sin, along * sin + across * cos];
    for order in [1.0, 2.0] {
        let omega = order * speed;
        let own = Complex::new(
            1e6 + 2.0 * joint / (length * length) - mass * omega * omega,
            omega * (40.0 + 2.0 * 0.02 / (length * length)),
        );
        for (axis, reaction) in reaction.iter().enumerate() {
            let expected = reaction.abs() / own.norm();
            assert_near(
                "line",
                amplitude(&found, axis, omega),
                expected,
                1e-8 * expected,
            );
        }
    }
}

/// What goes in by unbalance and rotation is stored or dissipated: film, rub with friction, and coefficients that change.
#[test]
fn energy_closes_with_every_element() {
    let dir = tempfile::tempdir().expect("a folder");
    std::fs::write(
        dir.path().join("seal.csv"),
        "speed_rpm,kxx_N_m,kxy_N_m,kyx_N_m,kyy_N_m,cxx_N_s_m,cyy_N_s_m\n0,1e5,1e4,-1e4,1e5,50,50\n9000,4e5,9e4,-9e4,3e5,90,80\n",
    )
    .expect("a table");
    let seal = "[[element]]\ncoefficients = \"seal.csv\"\n";
    let run_up = "from = \"2000 rpm\"\nto = \"6000 rpm\"\nover = \"0.5 s\"";
    let drive = "drive = { torque = \"12 N m\" }";
    for (parts, speed) in [
        (vec![SPRING, FILM], "constant = \"4200 rpm\""),
        (vec![SPRING, RUB], "constant = \"4200 rpm\""),
        (vec![SPRING, RUB, FILM], run_up),
        (vec![SPRING, seal], run_up),
        (vec![SPRING, RUB, seal], drive),
        (vec![SPRING, FILM, COUPLING], run_up),
    ] {
        let text = laval("60 um", 440.0, &parts);
        let text = text
            .replace("constant = \"440 rad/s\"", speed)
            .replace("freedoms", "inertia_polar = \"0.01 kg m^2\"\nfreedoms");
        let text = format!(
            "{text}[output]\nenergy = true\nmotion = false\nspectrum = false\nsample_rate = \"10 kHz\"\n"
        );
        let scene =
            loaded(dir.path(), &text).unwrap_or_else(|error| panic!("{}", error.render(false)));
        let energy = scene
            .simulate()
            .expect("a run")
            .run
            .energy
            .expect("an account");
        let Works { contact, .. } = energy.works;
        println!("{speed}: {:e}, {contact:e} J", energy.relative_residual);
        assert!(contact > 0.0, "{energy:?}");
        assert!(energy.relative_residual < 1e-7, "{speed}: {energy:?}");
    }
}

/// A shaft that knocks between the sides of a ring, pulled down by its weight: at a thousandth of the tolerance by another method
/// the trace is the same within ten tolerances.
#[test]
fn a_rub_that_chatters_keeps_to_ten_tolerances() {
    let text = laval("30 um", 300.0, &[SPRING, RUB])
        .replace("clearance = \"50 um\"", "clearance = \"20 um\"")
        .replace("freedoms", "gravity = true\nfreedoms")
        .replace("0.5 s", "0.1 s")
        .replace("0.3 s", "0 s");
    let mut model = scenario(&text).model.expect("a motion");
    let traces = [(Method::Auto, 1e-8), (Method::Dopri5, 1e-12)].map(|(method, tolerance)| {
        (model.integrator.method, model.integrator.tolerance) = (method, tolerance);
        RecordedRun::from_model(&model).expect("a run").samples
    });
    let [found, exact] = &traces;
    let (mut apart, mut size) = (0.0_f64, 0.0_f64);
    for (found, exact) in found.iter().zip(exact) {
        for axis in 0..2 {
            apart = apart.max((found.displacement[axis] - exact.displacement[axis]).abs());
            size = size.max(exact.displacement[axis].abs());
        }
    }
    println!("{:e} of {size:e} m", apart / size);
    assert!(apart < 1e-7 * size, "{apart:e} of {size:e}");
}

/// Between rows a monotone cubic, beyond the last row that row, which is said.
#[test]
fn coefficients_follow_the_speed() {
    let dir = tempfile::tempdir().expect("a folder");
    let table = "speed_rad_s,kxx_N_m,kyy_N_m,cxx_N_s_m,cyy_N_s_m\n100,1e6,1e6,100,100\n200,2e6,2e6,100,100\n300,3e6,3e6,100,100\n";
    std::fs::write(dir.path().join("journal.csv"), table).expect("a table");
    let at = |speed: f64| {
        let text = laval(
            "1 um",
            speed,
            &["[[element]]\ncoefficients = \"journal.csv\"\n"],
        );
        loaded(dir.path(), &text).unwrap_or_else(|error| panic!("{}", error.render(false)))
    };
    for (speed, stiffness) in [(100.0, 1e6), (150.0, 1.5e6), (300.0, 3e6), (900.0, 3e6)] {
        let scene = at(speed);
        let rotor = Rotor::assemble(&scene.question.rotor).expect("a rotor");
        let found = rotor.natural_frequencies()[0].frequency * TAU;
        assert_near("frequency", found, f64::sqrt(stiffness / 5.0), 1e-9 * found);
        let said = scene
            .warnings
            .iter()
            .any(|text| text.contains("beyond the table"));
        assert_eq!(said, speed > 300.0, "{:?}", scene.warnings);
    }
}

/// A diagram that begins below a table and ends above it says both, and that of a single row is known at its speed only.
#[test]
fn speeds_on_either_side_of_a_table_are_told() {
    let dir = tempfile::tempdir().expect("a folder");
    let said = |rows: &str, [from, to]: [f64; 2]| -> Vec<String> {
        let table = format!("speed_rad_s,kxx_N_m,kyy_N_m,cxx_N_s_m,cyy_N_s_m\n{rows}");
        std::fs::write(dir.path().join("journal.csv"), table).expect("a table");
        let elements = ["[[element]]\ncoefficients = \"journal.csv\"\n"];
        let scene = loaded(dir.path(), &laval("1 um", 150.0, &elements));
        let scene = scene.unwrap_or_else(|error| panic!("{}", error.render(false)));
        let question = CampbellQuestion {
            rotor: scene.question.rotor,
            from,
            to,
            count: 5,
            orders: vec![1.0],
            highest_frequency: None,
        };
        let found = question
            .solve(&NEVER)
            .unwrap_or_else(|error| panic!("{error}"));
        let beyond = |text: &String| text.contains("beyond the table");
        found.warnings.into_iter().filter(beyond).collect()
    };
    let rows = "100,1e6,1e6,100,100\n200,2e6,2e6,100,100\n";
    for (range, ends) in [
        ([100.0, 200.0], &[][..]),
        ([50.0, 200.0], &["goes to 477 rpm"]),
        ([50.0, 300.0], &["goes to 477 rpm", "goes to 2865 rpm"]),
    ] {
        let told = said(rows, range);
        assert_eq!(told.len(), ends.len(), "{told:?}");
        for (text, end) in told.iter().zip(ends) {
            assert!(
                text.contains("from 955 to 1910 rpm") && text.contains(end),
                "{text}"
            );
        }
    }
    let told = said("150,1e6,1e6,100,100\n", [150.0, 300.0]);
    let [only] = &told[..] else {
        panic!("{told:?}");
    };
    assert!(only.contains("known at 1432 rpm only"), "{only}");
}

/// What `bearing.save` of ROSS writes, in versions before 3 and from 3 on, with its defaults.
#[test]
fn bearings_of_ross_are_read() {
    let dir = tempfile::tempdir().expect("a folder");
    let read = |name: &str, text: &str| {
        std::fs::write(dir.path().join(name), text).expect("a file");
        let text = laval(
            "1 um",
            150.0,
            &[&format!("[[element]]\ncoefficients = \"{name}\"\n")],
        );
        loaded(dir.path(), &text)
    };
    let columns = "n = 3\ntag = \"left\"\nkxx = [1e6, 2e6]\nkxy = [1e4, 3e4]\nkyx = [-1e4, -3e4]\ncxx = [10.0, 30.0]\nmxx = [0.0, 0.0]\n";
    for speeds in ["frequency", "speed"] {
        let file = format!("[BearingElement_left]\n{speeds} = [100.0, 200.0]\n{columns}");
        let scene =
            read("left.toml", &file).unwrap_or_else(|error| panic!("{}", error.render(false)));
        let ElementLaw::OverSpeed(table) = &scene.question.rotor.elements[0].law else {
            panic!("a table");
        };
        let law = table.at(150.0);
        let k = law.stiffness;
        let found = [
            k[(0, 0)],
            k[(0, 1)],
            k[(1, 0)],
            k[(1, 1)],
            law.damping[(1, 1)],
        ];
        for (found, expected) in found.into_iter().zip([1.5e6, 2e4, -2e4, 1.5e6, 20.0]) {
            assert_near("coefficient", found, expected, 1e-12 * expected.abs());
        }
    }
    let json = "{ \"BearingElement_right\": { \"n\": 0, \"kxx\": 1e6, \"kyy\": 2e6, \"cxx\": 10.0, \"frequency\": null } }";
    let scene = read("right.json", json).unwrap_or_else(|error| panic!("{}", error.render(false)));
    let ElementLaw::Linear(law) = &scene.question.rotor.elements[0].law else {
        panic!("constant coefficients");
    };
    assert_eq!((law.stiffness[(1, 1)], law.damping[(1, 1)]), (2e6, 10.0));
    let both =
        format!("[BearingElement_left]\nspeed = [100.0, 200.0]\nfrequency = [1.0]\n{columns}");
    let heavy = "[SealElement_a]\nkxx = 1e6\ncxx = 1.0\nmxx = 2.0\n";
    let backward = format!("[BearingElement_left]\nspeed = [200.0, 100.0]\n{columns}");
    for (text, said) in [
        (both.as_str(), "frequency of the whirl"),
        (heavy, "mass mxx"),
        (&backward, "speeds must rise"),
        ("[DiskElement_a]\nm = 1.0\n", "no table with `kxx`"),
    ] {
        let error = read("wrong.toml", text)
            .expect_err("a refusal")
            .render(false);
        assert!(error.contains(said), "{error}");
    }
}

/// A damper between the housing of a ball bearing and the ground: mass on springs, all of it round the same circle.
#[test]
fn a_damper_sits_under_a_housing() {
    let parts = [
        "[[bearing]]\ncatalogue = \"6205\"\n[bearing.housing]\nmass = \"1 kg\"\nstiffness = { x = \"5 N/um\", y = \"5 N/um\" }\n",
        &FILM.replace("[[element]]", "[[element]]\nhousing_of = 1"),
    ];
    let text = laval("20 um", 900.0, &parts).replace("1e-11", "1e-8");
    let text = text.replace("0.5 s", "0.03 s").replace("0.3 s", "0 s");
    let model = scenario(&text).model.expect("a motion");
    let run = RecordedRun::from_model(&model).expect("a run");
    let last = run.samples.last().expect("samples");
    // the bearing alone presses on the shaft
    let total = last.force_on_shaft.expect("observed");
    for (total, own) in total.iter().zip(last.bearing_forces[0]).take(2) {
        assert_near("force", *total, own, 1e-9);
    }
    assert!(last.bearing_forces[1][0].hypot(last.bearing_forces[1][1]) > 1.0);
    let refused = Scenario::from_toml(&text.replace("housing_of = 1", "housing_of = 2"));
    assert!(
        refused
            .expect_err("no housing")
            .render(false)
            .contains("in no housing")
    );
}

/// 200 N on a spring of 1 N/µm: 0.2 mm, and the film has a clearance of 0.1 mm.
#[test]
fn a_film_that_the_shaft_leaves_at_rest_is_refused() {
    let load = "[[load]]\nconstant = { y = \"-200 N\" }\n";
    let text = laval("1 um", 300.0, &[SPRING, FILM, load]);
    let refused = match Scenario::from_toml(&text) {
        Err(error) => error.render(false),
        Ok(scenario) => {
            let model = scenario.model.expect("a motion");
            let refused = Rotor::assemble(&model.rotor).expect_err("no room");
            refused.to_string()
        }
    };
    assert!(
        refused.contains("200.0 µm off its middle, and its clearance is 100.0 µm"),
        "{refused}"
    );
}
