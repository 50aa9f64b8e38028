//! The studies of the seed paper: every file answers, and every number that their page states is the
//! number that the file gives.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use crate::support::{done, scenarios, told, toml_files, verb};

/// The folder of the studies.
fn seed() -> PathBuf {
    scenarios().join("seed")
}

/// All studies, sorted.
fn files() -> Vec<PathBuf> {
    let mut files = toml_files(&seed());
    files.retain(|file| !file.ends_with(BASE));
    files
}

/// The scenario that they start from.
const BASE: &str = "shaft.toml";

/// A table by the names of its columns.
type Table = Vec<HashMap<String, f64>>;

fn table(path: &Path) -> Table {
    let mut reader = csv::Reader::from_path(path).expect("a readable table");
    let names = reader.headers().expect("a header").clone();
    reader
        .records()
        .map(|record| {
            let record = record.expect("a row");
            names
                .iter()
                .zip(&record)
                .filter_map(|(name, cell)| Some((name.to_owned(), cell.parse().ok()?)))
                .collect()
        })
        .collect()
}

fn answer(files: &[PathBuf], folder: &Path) {
    for file in files {
        let output = verb("study", &[file], folder, &[]).output();
        let output = done(output.expect("the command starts"));
        let text = told(&output);
        let warnings = text.lines().filter(|line| line.starts_with("warning"));
        // what is changed to leave out the inertia is warned of
        let mut others = warnings.filter(|line| !line.contains("leaves out the inertia"));
        assert_eq!(others.next(), None, "{text}");
    }
}

/// One study, answered.
struct Study {
    varied: String,
    rows: Table,
    around: Table,
}

/// What is at one of the 16 positions.
struct Place {
    azimuth: i64,
    deformation: f64,
    inner: f64,
    outer: f64,
}

impl Place {
    /// Mean of the angles at the two races, degrees.
    fn angle(&self) -> f64 {
        (self.inner + self.outer) / 2.0
    }
}

impl Study {
    fn read(folder: &Path) -> Self {
        let path = folder.join("runs.csv");
        let head = fs::read_to_string(&path).expect("a study");
        // behind the number of the run and its direction
        let varied = head.split(',').nth(2).unwrap_or_default().to_owned();
        Self {
            varied,
            rows: table(&path),
            around: table(&folder.join("around.csv")),
        }
    }

    fn is(&self, row: &HashMap<String, f64>, value: f64) -> bool {
        (row[&self.varied] - value).abs() <= 1e-9 * value.abs()
    }

    /// A column of `runs.csv` at a value of the variable.
    fn at(&self, value: f64, column: &str) -> f64 {
        let mut rows = self.rows.iter();
        rows.find(|row| self.is(row, value)).expect("a row")[column]
    }

    fn column(&self, column: &str) -> Vec<f64> {
        self.rows.iter().map(|row| row[column]).collect()
    }

    /// Growth of K_x, K_y, K_θx and K_θy, percent.
    fn growth(&self, from: f64, to: f64) -> [f64; 4] {
        STIFFNESSES.map(|column| 100.0 * (self.at(to, column) / self.at(from, column) - 1.0))
    }

    /// The 16 positions at a value of the variable.
    fn around(&self, value: f64) -> Vec<Place> {
        let mut runs = self.rows.iter();
        let run = runs.find(|row| self.is(row, value)).expect("a row")["run"];
        let rows = self.around.iter().filter(|row| row["run"] == run);
        let places: Vec<_> = rows
            .map(|row| Place {
                azimuth: (10.0 * row["azimuth_rad"].to_degrees()).round() as i64,
                deformation: 1e6 * row["deformation_m"],
                inner: row["angle_inner_rad"].to_degrees(),
                outer: row["angle_outer_rad"].to_degrees(),
            })
            .collect();
        assert_eq!(places.len(), 16);
        places
    }

    /// What is at an azimuth in degrees.
    fn place(&self, value: f64, azimuth: i64) -> Place {
        self.around(value)
            .into_iter()
            .find(|place| place.azimuth == 10 * azimuth)
            .expect("one of the 16 positions")
    }

    /// Deformation at 0°, 90° and 180°, µm.
    fn deformations(&self, value: f64) -> [f64; 3] {
        [0, 90, 180].map(|azimuth| self.place(value, azimuth).deformation)
    }

    fn swing_of(&self, value: f64, angle: fn(&Place) -> f64) -> f64 {
        let angles: Vec<_> = self.around(value).iter().map(angle).collect();
        let high = angles.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        high - angles.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Swing of the mean of both races, degrees.
    fn swing(&self, value: f64) -> f64 {
        self.swing_of(value, Place::angle)
    }

    /// Where the variable has to be for a column to have a value, between rows on a line.
    fn reaches(&self, column: &str, wanted: f64) -> f64 {
        let values = self.column(column);
        let at = self.column(&self.varied);
        let step = values
            .windows(2)
            .position(|pair| pair[0] <= wanted && wanted <= pair[1])
            .expect("a value on the way");
        let part = (wanted - values[step]) / (values[step + 1] - values[step]);
        at[step] + part * (at[step + 1] - at[step])
    }
}

const STIFFNESSES: [&str; 4] = [
    "stiffness_x_N_m",
    "stiffness_y_N_m",
    "stiffness_tilt_x_N_m_rad",
    "stiffness_tilt_y_N_m_rad",
];

/// A study with the tilts held and with the tilts free.
struct Pair {
    held: Study,
    free: Study,
}

struct Answers {
    axial_force: Pair,
    eccentricity: Pair,
    speed: Pair,
}

static ANSWERS: LazyLock<Answers> = LazyLock::new(|| {
    let folder = tempfile::tempdir().expect("a temporary folder");
    answer(&files(), folder.path());
    let pair = |name: &str| Pair {
        held: Study::read(&folder.path().join(format!("{name}-tilts-held"))),
        free: Study::read(&folder.path().join(format!("{name}-tilts-free"))),
    };
    Answers {
        axial_force: pair("axial-force"),
        eccentricity: pair("eccentricity"),
        speed: pair("speed"),
    }
});

/// A study with some words of the scenario that it starts from changed.
fn changed(name: &str, changes: &[(&str, &str)]) -> Study {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut text = fs::read_to_string(seed().join(BASE)).expect("a scenario");
    for (from, to) in changes {
        assert!(text.contains(from), "{from} in {BASE}");
        text = text.replace(from, to);
    }
    fs::write(folder.path().join(BASE), text).expect("a writable folder");
    let file = folder.path().join("changed.toml");
    fs::copy(seed().join(name), &file).expect("a writable folder");
    answer(&[file], folder.path());
    Study::read(&folder.path().join("changed"))
}

/// Equal as printed: to half of the last of `digits` decimals.
#[track_caller]
fn printed<const N: usize>(found: [f64; N], stated: [f64; N], digits: i32) {
    let half = 0.500_001 * 10f64.powi(-digits);
    for (value, stated) in found.iter().zip(stated) {
        assert!((value - stated).abs() <= half, "{found:?}: not {stated}");
    }
}

#[test]
fn every_study_gives_its_tables_and_figures() {
    let files = files();
    assert_eq!(files.len(), 6);
    let folder = tempfile::tempdir().expect("a temporary folder");
    answer(&files, folder.path());
    for file in files {
        let study = folder.path().join(file.file_stem().expect("a stem"));
        for name in [
            "runs.csv",
            "around.csv",
            "stiffness.svg",
            "deformation.svg",
            "contact_angle.svg",
            "runs.json",
        ] {
            let size = fs::metadata(study.join(name)).map_or(0, |data| data.len());
            assert!(size > 1000, "{name} of {} has {size} bytes", file.display());
        }
    }
}

#[test]
fn every_study_names_its_schema() {
    for file in files() {
        let text = fs::read_to_string(&file).expect("a study");
        assert!(text.starts_with("#:schema ../study.schema.json\n"));
    }
}

#[test]
fn symmetry_holds() {
    let pairs = [&ANSWERS.axial_force, &ANSWERS.eccentricity, &ANSWERS.speed];
    for study in pairs.into_iter().flat_map(|pair| [&pair.held, &pair.free]) {
        for value in study.column(&study.varied) {
            let places = study.around(value);
            for index in 1..16 {
                let (one, other) = (&places[index], &places[16 - index]);
                assert!((one.deformation - other.deformation).abs() < 1e-6);
                assert!((one.angle() - other.angle()).abs() < 1e-6);
            }
            // α has its extremes on the line of the load
            let angles = places[..9].windows(2);
            let mut steps = angles.map(|pair| pair[1].angle() - pair[0].angle());
            assert!(steps.all(|step| step > -1e-9), "{value}");
        }
    }
    for study in [&ANSWERS.speed.held, &ANSWERS.speed.free] {
        let [x, y, tilt_x, tilt_y] = STIFFNESSES.map(|name| study.at(0.0, name));
        assert!((x / y - 1.0).abs() < 1e-9 && (tilt_x / tilt_y - 1.0).abs() < 1e-9);
    }
}

#[test]
fn figure_7_deformation_under_axial_force() {
    let Pair { held, free } = &ANSWERS.axial_force;
    printed([held.place(200.0, 90).deformation], [2.30], 2);
    printed([free.place(200.0, 90).deformation], [2.29], 2);
    printed(held.deformations(1000.0), [8.45, 8.40, 8.34], 2);
    printed(free.deformations(1000.0), [8.45, 8.40, 8.35], 2);
    let ends = |study: &Study| [200.0, 1000.0].map(|force| 1e6 * study.at(force, "x_m"));
    printed(ends(held), [0.095, 0.059], 3);
    printed(ends(free), [1.158, 0.393], 3);
    for study in [held, free] {
        let swings = [200.0, 1000.0].map(|force| study.swing_of(force, |place| place.deformation));
        assert!(swings[1] < swings[0], "{swings:?}");
        for forces in study.column(&study.varied).windows(2) {
            let pairs = study.around(forces[0]).into_iter();
            let mut pairs = pairs.zip(study.around(forces[1]));
            assert!(pairs.all(|(less, more)| more.deformation > less.deformation));
        }
    }
}

#[test]
fn figure_8_stiffness_under_axial_force() {
    let Pair { held, free } = &ANSWERS.axial_force;
    printed(held.growth(200.0, 1000.0), [62.7, 62.7, 139.4, 139.4], 1);
    printed(free.growth(200.0, 1000.0), [62.5, 62.7, 139.6, 139.3], 1);
    for study in [held, free] {
        printed(study.growth(400.0, 1000.0), [30.4, 30.4, 66.5, 66.5], 1);
        let growth = [27.9, 47.5, 78.6, 84.6];
        let baselines = std::array::from_fn(|index| {
            let column = STIFFNESSES[index];
            let wanted = study.at(1000.0, column) / (1.0 + growth[index] / 100.0);
            study.reaches(column, wanted)
        });
        printed(baselines, [427.0, 271.0, 351.0, 330.0], 0);
        for force in study.column(&study.varied) {
            let ratio = study.at(force, STIFFNESSES[0]) / study.at(force, STIFFNESSES[1]);
            assert!((ratio - 1.0).abs() < 0.0014, "{force}: {ratio}");
        }
    }
    let steps = [200.0, 400.0, 600.0, 800.0].map(|force| {
        (held.at(force + 200.0, STIFFNESSES[0]) - held.at(force, STIFFNESSES[0])) / 1e6
    });
    printed(steps, [32.4, 21.0, 15.9, 12.9], 1);
    let factors = held
        .growth(200.0, 1000.0)
        .map(|percent| 1.0 + percent / 100.0);
    printed([factors[0], factors[2]], [1.63, 2.39], 2);
}

#[test]
fn figure_9_contact_angle_under_axial_force() {
    let Pair { held, free } = &ANSWERS.axial_force;
    let forces = [200.0, 800.0];
    let ratio = |[few, many]: [f64; 2]| [few / many];
    let mean = forces.map(|force| held.swing(force));
    printed(mean, [0.0120, 0.0060], 4);
    printed(ratio(mean), [2.0], 1);
    let inner = forces.map(|force| held.swing_of(force, |place| place.inner));
    printed(inner, [0.0340, 0.0080], 4);
    printed(ratio(inner), [4.2], 1);
    for force in held.column(&held.varied) {
        let [loaded, other] = [0, 180].map(|azimuth| held.place(force, azimuth));
        assert_eq!(loaded.outer > other.outer, force <= 300.0, "{force}");
        assert!(loaded.inner < other.inner, "{force}");
    }
    let mean = forces.map(|force| free.swing(force));
    printed(mean, [1.117, 0.358], 3);
    printed(ratio(mean), [3.1], 1);
}

#[test]
fn figure_10_deformation_by_eccentricity() {
    let Pair { held, free } = &ANSWERS.eccentricity;
    printed(held.deformations(0.0), [7.75; 3], 2);
    printed(held.deformations(1e-4), [9.93, 7.69, 5.46], 2);
    printed(free.deformations(1e-4), [10.81, 7.22, 6.93], 2);
    printed([held.at(1e-4, "force_x_N")], [500.0], 6);
}

#[test]
fn figure_11_stiffness_by_eccentricity() {
    let Pair { held, free } = &ANSWERS.eccentricity;
    printed(held.growth(0.0, 1e-4), [-0.82, -0.45, -0.68, -0.95], 2);
    printed(free.growth(0.0, 1e-4), [3.46, -0.57, -2.51, 3.46], 2);
    printed([held.growth(0.0, 5e-5)[0]], [-0.20], 2);
    for study in [held, free] {
        for column in STIFFNESSES {
            let values = study.column(column);
            let whole = values[values.len() - 1] - values[0];
            assert!(
                values
                    .windows(2)
                    .all(|pair| (pair[1] - pair[0]) * whole > 0.0)
            );
        }
    }
}

#[test]
fn figure_12_contact_angle_by_eccentricity() {
    let Pair { held, free } = &ANSWERS.eccentricity;
    let angles = |study: &Study| [0.0, 1e-4].map(|value| study.place(value, 90).angle());
    printed(angles(held), [18.72, 18.70], 2);
    printed(angles(free), [18.72, 18.50], 2);
    printed([held.swing(1e-5)], [0.0257], 4);
    printed([held.swing(1e-4)], [0.261], 3);
    printed([free.swing(1e-5)], [1.178], 3);
    printed([free.swing(1e-4)], [10.41], 2);
    let dry = [("film = true", "film = false")];
    let dry = changed("eccentricity-tilts-held.toml", &dry);
    printed([dry.place(0.0, 90).angle()], [19.4], 1);
}

#[test]
fn figure_13_stiffness_by_speed() {
    let Pair { held, free } = &ANSWERS.speed;
    printed(held.growth(0.0, 2500.0), [-7.3, -6.9, -16.3, -16.5], 1);
    printed(free.growth(0.0, 2500.0), [-5.4, -7.0, -17.2, -15.8], 1);
    for study in [held, free] {
        for column in STIFFNESSES {
            let values = study.column(column);
            assert!(values.windows(2).all(|pair| pair[1] < pair[0]), "{column}");
        }
    }
    let place = held.place(2500.0, 90);
    printed([place.inner, place.outer], [20.2, 16.4], 1);

    let name = "speed-tilts-held.toml";
    let no_inertia = [
        ("contact = \"jones\"", "contact = \"hertz\""),
        ("race_control = \"outer\"", ""),
    ];
    let film = changed(name, &no_inertia);
    printed(film.growth(0.0, 2500.0), [-0.1, 0.1, -11.1, -11.1], 1);
    let inertia = changed(name, &[("film = true", "film = false")]);
    printed(inertia.growth(0.0, 2500.0), [-10.2, -9.6, -8.3, -8.7], 1);

    let heavy = changed(name, &[("mass = \"5 kg\"", "mass = \"50 kg\"")]);
    let values = heavy.column(STIFFNESSES[0]);
    let least = values.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
    let speed = heavy.column(&heavy.varied)[least.expect("rows").0];
    assert!((1900.0..=2100.0).contains(&speed), "{speed}");
    printed([heavy.swing(500.0)], [0.06], 2);
}

#[test]
fn figure_14_contact_angle_by_speed() {
    let Pair { held, free } = &ANSWERS.speed;
    let speeds = [500.0, 2500.0];
    let held = speeds.map(|speed| held.swing(speed));
    let free = speeds.map(|speed| free.swing(speed));
    printed([held[0]], [0.0057], 4);
    printed([held[1], free[0]], [0.304, 0.302], 3);
    printed([free[1]], [6.71], 2);
    printed([held[1] / held[0], free[1] / free[0]], [54.0, 22.0], 0);
}

#[test]
fn no_mass_gives_all_amplitudes() {
    let Answers {
        axial_force,
        eccentricity,
        speed,
    } = &*ANSWERS;
    let masses = |tilts: fn(&Pair) -> &Study| {
        let force = tilts(axial_force);
        [
            (0.02, force.swing(200.0)),
            (0.0055, force.swing(800.0)),
            (0.005, force.swing(1000.0)),
            (0.09, tilts(speed).swing(2500.0)),
            (2.3, tilts(eccentricity).swing(1e-4)),
        ]
        .map(|(paper, ours)| 5.0 * paper / ours)
    };
    let [a, b, c, d, e] = masses(|pair| &pair.held);
    printed([a, b, c, d], [8.3, 4.6, 4.4, 1.5], 1);
    printed([e], [44.0], 0);
    let [a, b, c, d, e] = masses(|pair| &pair.free);
    printed([a, b, c, d], [0.090, 0.077, 0.083, 0.067], 3);
    printed([e], [1.1], 1);
}

#[test]
fn friction_twists_the_shaft() {
    let study = &ANSWERS.axial_force.held;
    let ends = |column| [200.0, 1000.0].map(|force| study.at(force, column));
    printed(ends("moment_z_N_m"), [0.074, 0.115], 3);
    printed(ends("twist_rad").map(|angle| 1e6 * angle), [4.9, 7.6], 1);
}
