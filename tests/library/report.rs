//! The files of a run: their form, and that a folder never looks whole when it is not.

use std::f64::consts::TAU;
use std::fs;
use std::path::{Path, PathBuf};

use crate::analysis::{
    Analysis, BearingFrequencies, Channel, Recording, SampleGrid, Sources, Spectrum, Window, causes,
};
use crate::bearing::{ContactLaw, MountedBearing, catalogue};
use crate::integrate::{Counters, Method, Settings};
use crate::physics::ball_pass_frequencies;
use crate::report::{
    CsvTable, Decimator, FileAction, FileSet, Histories, ReportError, RunFolder, RunReport,
    TraceCsv, ball_columns, ball_row, event_columns, event_row, spectrum_figure, trace_columns,
    write_spectrum,
};
use crate::rotor::{
    Damping, Freedoms, NaturalFrequency, PlaneUnbalance, Rotor, RotorDefinition, Sample, Shaft,
    Whirl,
};
use crate::scenario::{Output, load};
use crate::simulate::{
    Analyses, BearingHistory, ConsumedLife, Event, EventCount, EventKind, LifeHistory, LoadZone,
    MeasuredError, Model, Run, Sampling, Spread, StaticState, TraceSink,
};
use crate::tests::support::{bearing, constant, mounted, without_clearance};
use tempfile::TempDir;

const SPEED: f64 = 500.0;
const PER_REVOLUTION: u32 = 32;
/// A title that a figure must escape.
const TITLE: &str = "7205C & <1000 N>\u{1}";

const SHAFT: Shaft = Shaft {
    mass: 5.0,
    inertia_transverse: 0.0,
    inertia_polar: 0.0,
    eccentricity: 1e-5,
    unbalance: PlaneUnbalance {
        moment: [0.0; 2],
        couple: [0.0; 2],
    },
    freedoms: Freedoms::Translational,
    gravity: true,
    held_tilt: [0.0; 2],
};

fn model() -> Model {
    Model {
        rotor: RotorDefinition {
            speed: SPEED,
            damping: Damping::Ratio(0.02),
            loads: constant([0.0, 0.0, 1000.0, 0.0, 0.0]),
            ..RotorDefinition::new(SHAFT, Vec::new())
        },
        duration: 0.1,
        settle: 0.0,
        sampling: Sampling::PerRevolution(PER_REVOLUTION),
        integrator: Settings {
            method: Method::Dop853,
            tolerance: 1e-8,
            step_limit: 1_000_000,
        },
        verify: true,
        energy: false,
        table: false,
        spectrum: Some(Window::Rectangular),
        analyses: Analyses::default(),
        spectra: Vec::new(),
    }
}

/// Made-up motion: unbalance in x and y, rest in z.
fn samples() -> Vec<Sample> {
    let sample = |n| {
        let angle = TAU * f64::from(n) / f64::from(PER_REVOLUTION);
        Sample {
            time: angle / SPEED,
            angle,
            speed: SPEED,
            displacement: [1e-6 * angle.cos(), 1e-6 * angle.sin(), 1.7e-5, 0.0, 0.0],
            force_on_shaft: Some([angle.cos(), 49.0, -1000.0, 0.0, 0.0]),
            largest_ball_load: Some(180.0),
            balls_loaded: Some(12),
            ..Sample::default()
        }
    };
    (0..=8 * PER_REVOLUTION).map(sample).collect()
}

fn history() -> BearingHistory {
    let spread = |smallest: f64, largest: f64| Spread {
        smallest,
        mean: 0.5 * (smallest + largest),
        largest,
    };
    let life = ConsumedLife {
        time: 0.1,
        revolutions: 8.0,
        share: 4e-9,
    };
    let count = |count, span| EventCount { count, span };
    BearingHistory {
        element: "ball",
        clearance: None,
        balls: 12,
        events: vec![
            (EventKind::ContactLost, count(7, Some([0.01, 0.09]))),
            (EventKind::ContactRegained, count(7, Some([0.02, 0.1]))),
            (EventKind::PreloadLost, count(1, Some([0.05, 0.05]))),
            (EventKind::PreloadRegained, count(0, None)),
        ],
        load_zone: Some(LoadZone {
            balls: spread(5.0, 12.0),
            extent: spread(2.5, TAU),
        }),
        life: Some(LifeHistory {
            whole_run: life,
            after_settle: life,
            modified: None,
        }),
        estimated: false,
    }
}

fn run() -> Run {
    let geometry = catalogue::find("7205C")
        .unwrap()
        .bearing()
        .unwrap()
        .geometry;
    let pass = ball_pass_frequencies(
        SPEED,
        geometry.balls(),
        geometry.ball_diameter(),
        geometry.pitch_diameter(),
        geometry.gamma(),
    );
    let channels = Channel::of_freedoms(Freedoms::Translational);
    let grid = SampleGrid::of_angle(SPEED / TAU, PER_REVOLUTION);
    let mut recording = Recording::new(grid, 0.0).with(channels.iter().copied());
    samples().iter().for_each(|sample| recording.record(sample));
    let natural = NaturalFrequency {
        frequency: 431.0,
        damped_frequency: 430.9,
        damping_ratio: 0.02,
        whirl: Whirl::Forward,
    };
    let lines = causes(&Sources {
        shaft: SPEED / TAU,
        bearings: vec![BearingFrequencies {
            simulated: pass,
            nominal: pass,
        }],
        natural: vec![natural],
        unbalanced: true,
        ..Sources::default()
    });
    let Analysis { spectrum, peaks } = recording
        .spectrum(&channels, Window::Rectangular, &lines)
        .unwrap();
    Run {
        equilibrium: StaticState {
            displacement: [0.0, -3.3e-6, 1.7e-5, 0.0, 0.0],
            stiffness: [[1.0; 5]; 5],
            damping: [[0.0; 5]; 5],
            residual: 1e-15,
            newton_steps: 4,
            natural_frequencies: vec![natural],
            natural_up_to: None,
            bearings: vec![None],
        },
        ball_pass: vec![pass],
        nominal_ball_pass: vec![pass],
        counters: Counters {
            steps: 1000,
            rejected: 20,
            evaluations: 14_000,
        },
        method_use: None,
        corrected_scale: None,
        samples: 257,
        bearings: vec![history()],
        reduction: None,
        finer_counters: None,
        largest_ball_load: Some(310.0),
        tables: Vec::new(),
        spalls: Vec::new(),
        measured_error: Some(MeasuredError {
            displacement: 1e-14,
            relative: 1e-8,
            reference_tolerance: 1e-9,
            counters: Counters::default(),
        }),
        energy: None,
        spectrum: Some(spectrum),
        peaks,
        vibration_severity: None,
        run_up: None,
        motion: None,
        maps: None,
        spectra: Vec::new(),
        warnings: vec!["a warning".to_owned()],
    }
}

fn open(folder: &Path, output: Output) -> RunReport {
    let mut scenario = load("scenarios/linear-7205c.toml".as_ref()).unwrap();
    (scenario.title, scenario.output) = (TITLE.to_owned(), output);
    let mut report = RunReport::new(&scenario, &model(), folder).unwrap();
    for sample in samples() {
        report.sample(&sample).unwrap();
    }
    report
}

/// Writes a whole run into `folder`.
fn write(folder: &Path, output: Output) -> Vec<PathBuf> {
    let written = open(folder, output).finish(&model(), run());
    written.unwrap().files
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let name = |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name();
    let mut names: Vec<String> = entries
        .map(|entry| name(entry).into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn a_finished_run_leaves_its_files_and_nothing_else() {
    let folder = TempDir::new().unwrap();
    let run = folder.path().join("deep").join("run");
    let paths = write(&run, Output::default());
    let all = [
        "events.csv",
        "peaks.csv",
        "report.html",
        "spectrum.csv",
        "spectrum.svg",
        "summary.json",
        "trace.csv",
        "trace.svg",
    ];
    assert_eq!(names(&run), all);
    assert_eq!(paths.len(), all.len());
    assert_eq!(paths.last(), Some(&run.join("summary.json")));
}

#[test]
fn an_unfinished_run_leaves_an_earlier_one_as_it_was() {
    let folder = TempDir::new().unwrap();
    drop(open(folder.path(), Output::default()));
    assert!(names(folder.path()).is_empty());
    write(folder.path(), Output::default());
    let before = fs::read(folder.path().join("trace.csv")).unwrap();
    let report = open(folder.path(), Output::default());
    assert!(names(folder.path()).contains(&".trace.csv.partial".to_owned()));
    drop(report);
    assert_eq!(names(folder.path()).len(), 8);
    assert_eq!(fs::read(folder.path().join("trace.csv")).unwrap(), before);
}

#[test]
fn a_run_killed_while_it_renames_has_no_summary() {
    let folder = TempDir::new().unwrap();
    write(folder.path(), Output::default());
    let run = RunFolder::open(folder.path(), FileSet::MOTION).unwrap();
    let file = run.write("trace.csv", b"new").unwrap();
    // The rename fails: a folder with something in it stands in the way.
    fs::remove_file(folder.path().join("trace.csv")).unwrap();
    let blocked = RunFolder::open(
        &folder.path().join("blocked.csv").join("x"),
        FileSet::MOTION,
    )
    .unwrap();
    let other = run.write("blocked.csv", b"new").unwrap();
    drop(blocked);
    let error = run
        .commit(vec![file, other], serde_json::json!({}))
        .unwrap_err();
    assert!(matches!(
        error,
        ReportError::File {
            action: FileAction::Rename,
            ..
        }
    ));
    // the earlier seal tells the next run what is left
    let left = [".summary.json.replaced", "blocked.csv", "trace.csv"];
    assert_eq!(names(folder.path()), left);
}

#[test]
fn outputs_of_an_earlier_run_do_not_stand_beside_a_later_one() {
    let folder = TempDir::new().unwrap();
    write(folder.path(), Output::default());
    let mut trace = Output::default();
    [trace.events, trace.figures, trace.report] = [false; 3];
    let run = Run {
        spectrum: None,
        ..run()
    };
    let report = open(folder.path(), trace);
    report.finish(&model(), run).unwrap();
    assert_eq!(names(folder.path()), ["summary.json", "trace.csv"]);
}

#[test]
fn a_folder_that_cannot_be_made_is_named_with_its_cause() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    let error = RunFolder::open(&file.join("run"), FileSet::MOTION).unwrap_err();
    assert!(error.to_string().starts_with("cannot create "));
    assert!(std::error::Error::source(&error).is_some());
}

#[test]
fn the_same_run_gives_the_same_bytes() {
    let folder = TempDir::new().unwrap();
    let runs = ["a", "b"].map(|name| folder.path().join(name));
    let [first, second] = runs.each_ref().map(|run| write(run, Output::default()));
    for (a, b) in first.iter().zip(&second) {
        assert_eq!(
            fs::read(a).unwrap(),
            fs::read(b).unwrap(),
            "{}",
            a.display()
        );
    }
}

#[test]
fn the_trace_has_its_columns_and_reads_back_bit_by_bit() {
    let mut csv = TraceCsv::new(Vec::new(), Channel::of_trace().collect()).unwrap();
    let mut sample = samples()[1].clone();
    sample.displacement[0] = 0.1 + 0.2;
    csv.sample(&sample).unwrap();
    let text = String::from_utf8(csv.finish().unwrap()).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let columns = trace_columns();
    let names: Vec<String> = columns.iter().map(|column| column.name()).collect();
    assert_eq!(lines[0], names.join(","));
    assert_eq!(
        names[3..8],
        ["x_m", "y_m", "z_m", "tilt_x_rad", "tilt_y_rad"]
    );
    let row: Vec<f64> = lines[1]
        .split(',')
        .map(|field| field.parse().unwrap())
        .collect();
    assert_eq!(row.len(), columns.len());
    assert_eq!(row[0], sample.time);
    assert_eq!(row[3..8], sample.displacement);
    assert_eq!(row[13..18], sample.force_on_shaft.unwrap());
    assert_eq!(row[18..], [180.0, 12.0]);
}

/// Names are those of variables in Matlab and pandas.
fn is_a_name(column: &str) -> bool {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    column.starts_with(|first: char| first.is_ascii_alphabetic()) && column.bytes().all(plain)
}

#[test]
fn the_trace_of_balls_reads_back_bit_by_bit() {
    let mut definition = model().rotor;
    let linear = MountedBearing {
        law: ContactLaw::Linear,
        ..mounted(bearing("7205C"))
    };
    definition.bearings = vec![linear, mounted(without_clearance("6305"))];
    let rotor = Rotor::assemble(&definition).unwrap();
    let mut contacts = rotor.ball_contacts();
    let mut state = rotor.start_state();
    state[rotor.freedoms().axes().len()..].fill(0.0);
    let sample = rotor.sample(0.0, &state, &mut contacts);
    let mut csv = CsvTable::new(Vec::new(), &ball_columns(&contacts)).unwrap();
    for _ in 0..2 {
        csv.row(&ball_row(&sample, &contacts)).unwrap();
    }
    let text = String::from_utf8(csv.finish().unwrap()).unwrap();
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    // the linear bearing knows no balls, the 6305 has seven
    let columns = &lines[0];
    assert_eq!((lines.len(), columns.len()), (3, 2 + 4 * 7));
    assert_eq!(
        columns[..3],
        ["t_s", "angle_rad", "bearing2_ball1_inner_load_N"]
    );
    assert_eq!(columns[29], "bearing2_ball7_outer_angle_rad");
    assert!(columns.iter().all(|column| is_a_name(column)));
    let row: Vec<f64> = lines[1].iter().map(|cell| cell.parse().unwrap()).collect();
    for (ball, cells) in contacts.bearings()[1].contacts().zip(row[2..].chunks(4)) {
        assert!(ball.load_inner > 0.0);
        let written = [
            ball.load_inner,
            ball.angle_inner,
            ball.load_outer,
            ball.angle_outer,
        ];
        assert_eq!(cells, written);
    }
}

#[test]
fn events_count_bearings_and_balls_from_one() {
    let mut csv = CsvTable::new(Vec::new(), &event_columns()).unwrap();
    for (kind, ball) in [
        (EventKind::ContactLost, Some(0)),
        (EventKind::PreloadLost, None),
    ] {
        let event = Event {
            time: 0.25,
            kind,
            bearing: 1,
            ball,
        };
        csv.row(&event_row(&event)).unwrap();
    }
    let text = String::from_utf8(csv.finish().unwrap()).unwrap();
    let expected = "t_s,event,bearing,ball\n0.25,contact_lost,2,1\n0.25,preload_lost,2,\n";
    assert_eq!(text, expected);
}

fn header(spectrum: &Spectrum) -> String {
    let mut bytes = Vec::new();
    write_spectrum(spectrum, &mut bytes).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    text.lines().next().unwrap().to_owned()
}

#[test]
fn the_spectrum_has_an_order_only_where_the_shaft_turns() {
    let mut spectrum = run().spectrum.unwrap();
    assert_eq!(
        header(&spectrum),
        "f_Hz,order,x_amplitude_m,x_phase_rad,y_amplitude_m,y_phase_rad,z_amplitude_m,z_phase_rad,\
         force_x_amplitude_N,force_x_phase_rad,force_y_amplitude_N,force_y_phase_rad,\
         force_z_amplitude_N,force_z_phase_rad"
    );
    spectrum.shaft_frequency = 0.0;
    assert!(header(&spectrum).starts_with("f_Hz,x_amplitude_m,"));
}

#[test]
fn the_summary_names_units_and_causes() {
    let folder = TempDir::new().unwrap();
    write(folder.path(), Output::default());
    let text = fs::read_to_string(folder.path().join("summary.json")).unwrap();
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(value["jeffcott"], env!("CARGO_PKG_VERSION"));
    assert_eq!(value["scenario"]["speed"]["constant"], "500 rad/s");
    assert_eq!(value["equilibrium"]["y_m"], -3.3e-6);
    assert_eq!(value["stiffness"]["rows"][3], "moment_x_N_m");
    assert_eq!(
        value["natural_frequencies"][0]["undamped_frequency_Hz"],
        431.0
    );
    assert_eq!(value["spectrum"]["length"], 256);
    assert_eq!(value["peaks"][0]["name"], "1×");
    assert_eq!(value["peaks"][0]["unit"], "m");
    assert_eq!(value["measured_error"]["tolerance"], 1e-8);
    assert_eq!(value["warnings"][0], "a warning");
    let bearing = &value["bearings"][0];
    assert_eq!(bearing["events"]["contact_lost"]["count"], 7);
    assert_eq!(bearing["events"]["contact_lost"]["last_s"], 0.09);
    assert!(bearing["events"]["preload_regained"]["first_s"].is_null());
    assert_eq!(bearing["load_zone"]["extent_rad"]["smallest"], 2.5);
    let life = &bearing["life"]["after_settle"];
    assert_eq!(life["life_Mrev"], 8e-6 / 4e-9);
    assert_eq!(life["life_h"], 0.1 / 4e-9 / 3600.0);
}

#[test]
fn figures_are_well_formed_and_say_what_they_show() {
    let mut histories = Histories::new(Freedoms::Translational);
    samples().iter().for_each(|sample| histories.sample(sample));
    let run = run();
    let trace = histories.displacements("trace", TITLE).svg();
    let spectrum = spectrum_figure(TITLE, run.spectrum.as_ref().unwrap(), &run.peaks).svg();
    for svg in [&trace, &spectrum] {
        assert!(svg.starts_with("<svg ") && svg.contains(" width=\"680\""));
        assert!(svg.contains("7205C &amp; &lt;1000 N&gt;"));
        assert!(!svg.contains('\u{1}') && !svg.contains("NaN"));
        assert!(svg.trim_end().ends_with("</svg>"));
    }
    assert!(trace.contains("time in s") && trace.contains("z in µm"));
    assert!(spectrum.contains("displacement amplitude in µm") && spectrum.contains("1×"));
}

#[test]
fn figures_of_nothing_are_drawn_empty() {
    let drawn = |figure: String| figure.ends_with("</svg>\n") && !figure.contains("NaN");
    let mut histories = Histories::new(Freedoms::All);
    assert!(drawn(histories.displacements("trace", "").svg()));
    histories.sample(&samples()[0]);
    assert!(drawn(histories.displacements("trace", "").svg()));
    let mut spectrum = run().spectrum.unwrap();
    for entry in &mut spectrum.channels {
        entry.amplitude.fill(0.0);
    }
    assert!(drawn(spectrum_figure("rest", &spectrum, &[]).svg()));
    spectrum.channels.clear();
    assert!(drawn(spectrum_figure("no channels", &spectrum, &[]).svg()));
}

#[test]
fn an_envelope_keeps_every_extreme_in_bounded_memory() {
    for length in [1u32, 9, 10, 11, 1000, 99_991] {
        let mut envelope = Decimator::new(10);
        for n in 0..length {
            let spike = if n == length / 3 { 7.0 } else { 0.0 };
            envelope.push(f64::from(n), spike + f64::from(n % 2));
        }
        assert!(envelope.buckets().count() <= 10);
        let high = envelope
            .buckets()
            .map(|bucket| bucket.high())
            .fold(0.0, f64::max);
        assert!(high >= 7.0);
        let points: Vec<f64> = envelope
            .buckets()
            .flat_map(|bucket| [bucket.first.0, bucket.last.0])
            .collect();
        assert!(points.is_sorted());
    }
}

#[test]
fn the_text_shows_key_numbers_and_peaks() {
    let folder = TempDir::new().unwrap();
    let report = open(folder.path(), Output::default());
    let shown = report.finish(&model(), run()).unwrap().text(false);
    let flat: Vec<&str> = shown.split_whitespace().collect();
    let flat = flat.join(" ");
    for expected in [
        "7205C & <1000 N>",
        "z 17.0000 µm",
        "431.00 Hz (ζ 0.020)",
        "5 to 12 of 12 balls loaded, mean 8.50; contact lost 7 times, 0.0100 s to 0.0900 s; \
         preload lost once, at 0.0500 s",
        "2.0000e3 million revolutions, 6.944e3 h",
        "1×",
    ] {
        // lines are broken where they would be wider than a terminal
        let found = shown.contains(expected) || flat.contains(expected);
        assert!(found, "{expected} in\n{shown}");
    }
}
