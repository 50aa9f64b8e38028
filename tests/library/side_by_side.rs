//! Runs side by side: each is what it is by itself.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::AtomicBool;

use tempfile::TempDir;

use jeffcott::bearing::{ContactDamping, ContactLaw, MountedBearing, Preload};
use jeffcott::integrate::Method;
use jeffcott::rotor::load::{Harmonic, Pace, Shock};
use jeffcott::rotor::{Damping, Freedoms, Load, LoadKind, RotorDefinition, Sample, SpeedPoint};
use jeffcott::simulate::{
    Analyses, Model, Monitor, Run, SIDE_BY_SIDE, Sampling, TraceSink, simulate_side_by_side,
};

use crate::support::{
    Collector, MICROMETRE, back_to_back_pair, bearing, model, mounted, rotor, samples, shaft,
    thrust_rotor,
};

/// Tolerance of the runs side by side.
const TOLERANCE: f64 = 1e-7;

/// The runs and their samples, where the models go side by side.
fn side_by_side(models: &[Model; SIDE_BY_SIDE]) -> Option<([Run; SIDE_BY_SIDE], Vec<Vec<Sample>>)> {
    let mut sinks: [Collector; SIDE_BY_SIDE] = Default::default();
    let stop = AtomicBool::new(false);
    let mut monitor = Monitor {
        stop: &stop,
        progress: &mut |_| {},
    };
    let taken = sinks.each_mut().map(|sink| sink as &mut dyn TraceSink);
    let runs = simulate_side_by_side(models, taken, &mut monitor)?;
    Some((runs, sinks.map(|sink| sink.samples).to_vec()))
}

/// A model whose method is open, 40 samples a revolution.
fn open(rotor: RotorDefinition, duration: f64) -> Model {
    let mut model = model(rotor, duration, 1.0);
    model.sampling = Sampling::PerRevolution(40);
    model.integrator.method = Method::Auto;
    model.integrator.tolerance = TOLERANCE;
    model
}

/// A load at the centre of mass.
fn at_centre(kind: LoadKind) -> Load {
    Load {
        kind,
        position: 0.0,
    }
}

/// Four shafts of some freedoms that have no number in common but their mass.
fn four(freedoms: Freedoms) -> [Model; SIDE_BY_SIDE] {
    std::array::from_fn(|lane| {
        let part = lane as f64;
        let mut bearings = match freedoms {
            Freedoms::All => back_to_back_pair(),
            _ => vec![mounted(bearing("7205C"))],
        };
        for bearing in &mut bearings {
            bearing.first_ball = 0.07 * part;
            bearing.preload = Preload::AxialOffset((10.0 + 2.0 * part) * MICROMETRE);
        }
        let mut rotor = RotorDefinition {
            speed: 480.0 + 25.0 * part,
            damping: Damping::Ratio(0.02 + 0.005 * part),
            load: [10.0 * part, -40.0, 300.0, 0.0, 0.0],
            ..rotor(shaft(freedoms), bearings)
        };
        rotor.shaft.eccentricity = (1.0 + part) * MICROMETRE;
        if lane == 1 {
            rotor.loads = vec![at_centre(LoadKind::Harmonic(Harmonic {
                amplitude: [5.0, 0.0, 0.0, 0.0, 0.0],
                pace: Pace::Frequency(90.0),
                phase: 0.3,
            }))];
        }
        open(rotor, 0.05)
    })
}

#[test]
fn each_of_four_different_shafts_moves_as_by_itself() {
    for freedoms in [Freedoms::Radial, Freedoms::Translational, Freedoms::All] {
        let models = four(freedoms);
        let (runs, found) = side_by_side(&models).expect("they go side by side");
        for (lane, model) in models.iter().enumerate() {
            let mut exact = model.clone();
            exact.integrator = crate::support::settings(1e-12);
            let exact = samples(&exact, 0.0);
            assert_eq!(found[lane].len(), exact.len());
            let place = runs[lane].equilibrium.displacement;
            let [mut error, mut motion] = [0.0_f64; 2];
            for (sample, exact) in found[lane].iter().zip(&exact) {
                assert_eq!(sample.time, exact.time);
                for (axis, place) in place.iter().enumerate().take(3) {
                    let truth = exact.displacement[axis];
                    error = error.max((sample.displacement[axis] - truth).abs());
                    motion = motion.max((truth - place).abs());
                }
            }
            println!("{freedoms:?} {lane}: {:.2e}", error / motion);
            assert!(
                error < 3.0 * TOLERANCE * motion,
                "{freedoms:?} {lane}: {error:e}"
            );
        }
    }
}

/// The second pass of a run side by side is a run by itself.
#[test]
fn its_measured_error_is_kept_to_the_tolerance() {
    let mut models = four(Freedoms::All);
    models[1].verify = true;
    let (runs, _) = side_by_side(&models).expect("they go side by side");
    assert!(runs[0].measured_error.is_none());
    let error = runs[1].measured_error.expect("measured").relative;
    assert!(
        (1e-3 * TOLERANCE..3.0 * TOLERANCE).contains(&error),
        "{error:e}"
    );
}

/// Steps side by side do not end where balls come and go: they are held to a smaller error instead.
#[test]
fn balls_that_come_and_go_leave_an_error_of_some_tolerances() {
    let scene = scenarios().join("varying-compliance-6306.toml");
    let scene = jeffcott::scenario::load(&scene).expect("a shipped scenario");
    let shipped = scene.model.expect("a motion");
    let models = std::array::from_fn(|lane| {
        let mut model = shipped.clone();
        model.rotor.speed = 110.0 + 20.0 * lane as f64;
        (model.duration, model.settle) = (1.0, 0.5);
        model.integrator.tolerance = TOLERANCE;
        (model.verify, model.spectrum) = (true, None);
        model.analyses = Analyses::default();
        model
    });
    let (runs, _) = side_by_side(&models).expect("they go side by side");
    for run in runs {
        let error = run.measured_error.expect("measured").relative;
        println!("{error:.2e}");
        assert!(error < 10.0 * TOLERANCE, "{error:e}");
    }
}

#[test]
fn shafts_of_another_kind_go_by_themselves() {
    type Change = (&'static str, fn(&mut Model));
    fn first(model: &mut Model) -> &mut MountedBearing {
        &mut model.rotor.bearings[0]
    }
    let changes: [Change; 13] = [
        ("frozen stiffness", |model| {
            first(model).law = ContactLaw::Linear
        }),
        ("other balls", |model| {
            first(model).bearing = bearing("6306")
        }),
        ("a bearing more", |model| {
            model.rotor.bearings.push(mounted(bearing("7205C")));
        }),
        ("damped contacts", |model| {
            first(model).contact_damping = ContactDamping {
                inner: 100.0,
                outer: 100.0,
            };
        }),
        ("a spring", |model| {
            first(model).preload = Preload::Spring(100.0)
        }),
        ("damping by stiffness", |model| {
            model.rotor.damping = Damping::StiffnessTime(1e-5);
        }),
        ("a speed that changes", |model| {
            let speed = SpeedPoint {
                time: 0.01,
                speed: 400.0,
            };
            model.rotor.speed_points = vec![speed];
        }),
        ("a shock", |model| {
            let shock = Shock {
                peak: [0.0, 30.0, 0.0, 0.0, 0.0],
                duration: 1e-3,
                start: 5e-3,
                every: None,
            };
            model.rotor.loads = vec![at_centre(LoadKind::Shock(shock))];
        }),
        ("other freedoms", |model| {
            model.rotor.shaft.freedoms = Freedoms::Radial;
        }),
        ("a named method", |model| {
            model.integrator.method = Method::Verner76
        }),
        ("another tolerance", |model| {
            model.integrator.tolerance = 1e-6
        }),
        ("energies", |model| model.energy = true),
        ("a shorter run", |model| model.duration = 1e-3),
    ];
    let models = || std::array::from_fn(|_| open(thrust_rotor(), 0.01));
    assert!(side_by_side(&models()).is_some());
    for (name, change) in changes {
        let mut models: [Model; SIDE_BY_SIDE] = models();
        change(&mut models[3]);
        let alone = match name {
            // three short ones: most of the time nothing is asked of them
            "a shorter run" => {
                change(&mut models[1]);
                change(&mut models[2]);
                side_by_side(&models).is_none()
            }
            _ => side_by_side(&models).is_none(),
        };
        assert!(alone, "{name}");
    }
}

#[test]
fn where_one_fails_none_is_answered() {
    let mut models: [Model; SIDE_BY_SIDE] = std::array::from_fn(|_| open(thrust_rotor(), 0.01));
    for model in &mut models {
        model.integrator.step_limit = 10;
    }
    assert!(side_by_side(&models).is_none());
}

fn scenarios() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios")
}

/// 70 runs that differ in their preload, with more keys.
fn preloads(folder: &Path, name: &str, more: &str) -> PathBuf {
    let text = format!(
        "base = '{}'\nverify_every = 9\n{more}\n[[set]]\nkey = 'time.duration'\nvalue = '0.1 s'\n\
         [[set]]\nkey = 'time.settle'\nvalue = '0.05 s'\n\
         [[axis]]\nkey = 'speed.constant'\nfrom = '480 rad/s'\nto = '520 rad/s'\ncount = 70\n",
        scenarios().join("balanced-7205c.toml").display()
    );
    let file = folder.join(name);
    fs::write(&file, text).expect("a file");
    file
}

/// A study that must come to its end.
fn study(file: &Path, out: &Path, more: &[&str]) {
    let status = Command::new(env!("CARGO_BIN_EXE_jeffcott"))
        .args([
            "study".as_ref(),
            file.as_os_str(),
            "--out".as_ref(),
            out.as_os_str(),
        ])
        .args(more)
        .status();
    assert!(status.expect("the command starts").success());
}

fn column(table: &Path, name: &str) -> Vec<f64> {
    let mut reader = csv::Reader::from_path(table).expect("a table");
    let names = reader.headers().expect("names").clone();
    let index = names.iter().position(|known| known == name);
    let index = index.expect("a column");
    let rows = reader.records().map(|row| row.expect("a row"));
    rows.map(|row| row[index].parse().unwrap_or(f64::NAN))
        .collect()
}

#[test]
fn a_study_side_by_side_has_the_numbers_of_its_runs_by_themselves() {
    let folder = TempDir::new().expect("a folder");
    let file = preloads(folder.path(), "beside.toml", "");
    let alone = preloads(folder.path(), "alone.toml", "side_by_side = false");
    let out = |name: &str| folder.path().join(name);
    study(&file, &out("one"), &["--threads", "1"]);
    study(&alone, &out("one"), &[]);
    let table = |name: &str| out("one").join(name).join("runs.csv");
    let columns = |column_name: &str| {
        [table("beside"), table("alone")].map(|table| column(&table, column_name))
    };
    // four by four, and the last two by themselves
    let [beside, by_itself] = columns("evaluations");
    assert_eq!(beside.len(), 70);
    for group in beside[..68].chunks(4) {
        assert!(group.iter().all(|evaluations| *evaluations == group[0]));
    }
    assert_eq!(beside[68..], by_itself[68..]);
    assert_ne!(beside[..68], by_itself[..68]);
    for name in ["x_rms_m", "z_peak_to_peak_m", "largest_ball_load_N"] {
        let [beside, by_itself] = columns(name);
        for (run, (beside, alone)) in beside.iter().zip(&by_itself).enumerate() {
            let apart = (beside - alone).abs() / alone.abs();
            assert!(
                apart < 1e-5,
                "{name} of run {run}: {beside:e} and {alone:e}"
            );
        }
    }
    let errors = columns("measured_error")[0].clone();
    let measured = || errors.iter().filter(|error| error.is_finite());
    assert_eq!(measured().count(), 8);
    assert!(measured().all(|error| *error < 1e-7), "{errors:?}");
}

#[test]
fn threads_and_parts_do_not_change_a_study_side_by_side() {
    let folder = TempDir::new().expect("a folder");
    let file = preloads(folder.path(), "beside.toml", "");
    let out = |name: &str| folder.path().join(name);
    study(&file, &out("one"), &["--threads", "1"]);
    study(&file, &out("three"), &["--threads", "3"]);
    for part in ["3/3", "1/3", "2/3"] {
        study(&file, &out("parts"), &["--shard", part]);
    }
    let merged = Command::new(env!("CARGO_BIN_EXE_jeffcott"))
        .args(["study", "merge"])
        .arg(out("parts").join("beside"))
        .status();
    assert!(merged.expect("the command starts").success());
    for name in ["runs.csv", "runs.json"] {
        let bytes = |run: &str| fs::read(out(run).join("beside").join(name)).expect("a file");
        assert!(bytes("one") == bytes("three"), "{name}");
        assert!(bytes("one") == bytes("parts"), "{name}");
    }
}
