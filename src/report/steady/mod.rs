//! Steady motions: files of a single one, and of their branches along a parameter.

mod response;

use std::f64::consts::TAU;
use std::path::PathBuf;

use nalgebra::Complex;
use serde::Serialize;
use serde_json::Value;

use super::figure::{Axis, Curve, Figure, Name, Panel, Point, distinct};
use super::run_tables::trace_table;
use super::spectrum::{AMPLITUDE, FREQUENCY, HEIGHT, amplitude_column, phase_column};
use super::study::shown;
use super::table::Table;
use super::terminal::{Lines, MICRO, digits, listed, measured_text};
use super::{Answer, Destination, FileSet, TraceFigure};
use crate::shooting::Multipliers;
use crate::simulate::Model;
use crate::steady::{Base, Measured, Response, Steady, SteadyLine, SteadyLines};
use crate::study::Variable;

/// `steady_trace.csv`, `steady_spectrum.csv`, two figures and `steady.json`.
pub fn steady_answer(destination: &Destination<'_>, model: &Model, steady: &Steady) -> Answer {
    let title = destination.title;
    let mut figure = TraceFigure::new(model.rotor.shaft.freedoms.count());
    steady.trace.iter().for_each(|sample| figure.sample(sample));
    Answer {
        set: FileSet::STEADY,
        document: steady_json(destination, model, steady),
        tables: vec![
            ("steady_trace", trace_table(&steady.trace)),
            ("steady_spectrum", line_table(steady, model.rotor.speed)),
        ],
        figures: vec![
            figure.figure("steady_trace.svg", title),
            spectrum(title, &steady.lines),
        ],
    }
}

/// `response.csv`, `response_specials.csv`, `response.svg` and `response.json`.
pub fn response_answer(
    destination: &Destination<'_>,
    variable: &Variable,
    branches: &[Response],
) -> Answer {
    Answer {
        set: FileSet::RESPONSE,
        document: response_json(destination, variable, branches),
        tables: vec![
            ("response", response::points(variable, branches)),
            ("response_specials", response::specials(variable, branches)),
        ],
        figures: vec![response::figure(destination.title, variable, branches)],
    }
}

/// Frequency, order of the shaft (where it turns), both multiples, then amplitude and phase of every
/// channel.
fn line_table(steady: &Steady, speed: f64) -> Table {
    let lines = || steady.lines.lines.iter();
    let mut table = Table::default();
    table.numbers("f_Hz", lines().map(|line| line.frequency));
    if speed > 0.0 {
        table.numbers("order", lines().map(|line| line.frequency * TAU / speed));
    }
    for (place, name) in ["multiple_of_first", "multiple_of_second"]
        .into_iter()
        .enumerate()
    {
        table.counts(name, lines().map(|line| f64::from(line.multiples[place])));
    }
    for (index, channel) in steady.lines.channels.iter().enumerate() {
        table.numbers(
            amplitude_column(*channel),
            lines().map(|line| line.amplitude[index]),
        );
        table.numbers(
            phase_column(*channel),
            lines().map(|line| line.phase[index]),
        );
    }
    table
}

/// Amplitudes of x, y and z (those that move) over frequency.
fn spectrum(title: &str, lines: &SteadyLines) -> Figure {
    let channels = lines.channels.iter().enumerate();
    let lengths: Vec<_> = channels
        .filter(|(_, channel)| channel.unit() == "m")
        .collect();
    let all = || lengths.iter().flat_map(|(index, _)| tips(lines, *index));
    let strongest = all().map(|(_, amplitude)| amplitude).fold(0.0, f64::max);
    let amplitudes = Axis::below(AMPLITUDE, strongest);
    let floor = amplitudes.least();
    let shown = all().filter(|(_, amplitude)| *amplitude > floor);
    let highest = shown.map(|(frequency, _)| frequency).fold(0.0, f64::max);
    let limit = if highest > 0.0 { 1.05 * highest } else { 1.0 };
    let strokes = lengths.iter().enumerate().flat_map(|(place, (index, _))| {
        // strokes of the same frequency stand side by side
        let beside = limit * 1.5e-3 * place as f64;
        let shown = tips(lines, *index).filter(|(_, amplitude)| *amplitude > floor);
        shown.map(move |(frequency, amplitude)| {
            let ends = [floor, amplitude].map(|end| (frequency + beside, end));
            Curve::line(distinct(place), ends.to_vec())
        })
    });
    let panel = Panel {
        curves: strokes.collect(),
        ..Panel::new(Axis::over(FREQUENCY, 0.0..limit), amplitudes, HEIGHT)
    };
    let names = Name::each(lengths.iter().map(|(_, channel)| channel.name()));
    Figure::new("steady_spectrum.svg", title, 1, vec![panel]).with_names(names)
}

/// Frequency and amplitude in µm of a channel's lines but the mean.
fn tips(lines: &SteadyLines, index: usize) -> impl Iterator<Item = Point> {
    let moving = lines.lines.iter().filter(|line| line.multiples != [0, 0]);
    moving.map(move |line| (line.frequency, MICRO * line.amplitude[index]))
}

/// A steady motion, whether it is stable, and its error.
#[derive(Serialize)]
struct SteadySummary<'a> {
    #[serde(flatten)]
    steady: &'a Steady,
    stable: bool,
    lines: usize,
    measured_error: Option<ErrorSummary<'a>>,
}

/// The measured error beside what was asked for.
#[derive(Serialize)]
struct ErrorSummary<'a> {
    #[serde(flatten)]
    error: &'a Measured,
    tolerance: f64,
}

/// The branches of a response: their ends and where they turn.
#[derive(Serialize)]
struct ResponseSummary<'a> {
    over: &'a str,
    unit: &'a str,
    branches: &'a [Response],
}

/// Everything about a steady motion except its trace and its spectrum. The same question gives the same
/// bytes.
fn steady_json(destination: &Destination<'_>, model: &Model, steady: &Steady) -> Value {
    let measured = |error| ErrorSummary {
        error,
        tolerance: model.integrator.tolerance,
    };
    let summary = SteadySummary {
        steady,
        stable: steady.is_stable(),
        lines: steady.lines.lines.len(),
        measured_error: steady.measured.as_ref().map(measured),
    };
    destination.document(summary)
}

/// The branches of a response; the motions stand in `response.csv`.
fn response_json(
    destination: &Destination<'_>,
    variable: &Variable,
    branches: &[Response],
) -> Value {
    let summary = ResponseSummary {
        over: &variable.key,
        unit: variable.unit,
        branches,
    };
    destination.document(summary)
}

/// Lines and multipliers shown.
const LINES: usize = 8;
const MULTIPLIERS: usize = 4;

/// Period, stability and the strongest lines of a steady motion, and the files written.
pub fn steady_text(title: &str, model: &Model, steady: &Steady, files: &[PathBuf]) -> String {
    let mut out = Lines::titled(title);
    for base in &steady.bases {
        out.line("forcing", forcing(base));
    }
    out.line("motion", motion(steady));
    out.line("multipliers", multipliers(steady));
    out.line("stability", stability(steady));
    out.line("search", search(steady));
    if let Some(error) = &steady.measured {
        let sizes = [error.displacement, error.relative];
        let tolerances = [model.integrator.tolerance, error.reference_tolerance];
        out.line("error", measured_text(sizes, tolerances));
    }
    put_swings(&mut out, steady);
    put_lines(&mut out, steady, model.rotor.speed);
    out.wrote(files)
}

/// Branches, where they turn and where their motions change their kind, and the files written.
pub fn response_text(
    title: &str,
    variable: &Variable,
    branches: &[Response],
    files: &[PathBuf],
) -> String {
    let mut out = Lines::titled(title);
    for (number, branch) in branches.iter().enumerate() {
        let stable = branch.points.iter().filter(|point| point.stable).count();
        let text = format!(
            "{} × the period, {} motions, {stable} of them stable; {}",
            branch.multiple,
            branch.points.len(),
            branch.end
        );
        out.line(&format!("branch {}", number + 1), text);
        for special in &branch.specials {
            let multiplier = special.point.multipliers.first();
            let size = multiplier.map_or(f64::NAN, |value| value.norm());
            let text = format!(
                "{} at {}, largest multiplier {size:.6}",
                special.kind,
                shown(variable, special.point.value)
            );
            out.more(text);
        }
        for unrefined in &branch.unrefined {
            let [from, to] = unrefined.between.map(|value| shown(variable, value));
            let text = format!(
                "{} between {from} and {to}, not found any nearer: a jump, {:.1e} are left",
                unrefined.kind, unrefined.left
            );
            out.more(text);
        }
    }
    out.wrote(files)
}

fn forcing(base: &Base) -> String {
    let parts = base.parts.iter().map(|(cause, multiple)| match multiple {
        1 => cause.to_string(),
        many => format!("{many} × for {cause}"),
    });
    format!("{:.6} Hz: {}", base.frequency / TAU, listed(parts))
}

fn motion(steady: &Steady) -> String {
    if steady.is_torus() {
        return format!(
            "two frequencies without a common period; {} harmonics of the second",
            steady.harmonics
        );
    }
    let period = digits(1e3 * steady.period);
    match steady.multiple {
        1 => format!("repeats every {period} ms, with the forcing"),
        many => format!("repeats every {period} ms, {many} periods of the forcing"),
    }
}

fn multipliers(steady: &Steady) -> String {
    let torus = matches!(steady.multipliers, Multipliers::Torus(_));
    let errors = steady.measured.iter().flat_map(|error| &error.multipliers);
    let errors = errors.map(|error| format!(" (error {error:.0e})"));
    let errors = errors.chain(std::iter::repeat(String::new()));
    let values = steady.multipliers.values();
    let upper = values
        .iter()
        .zip(errors)
        .filter(|(value, _)| value.im >= 0.0);
    let text = |(value, error): (&Complex<f64>, String)| match value.im {
        _ if torus => format!("|{:.6}|{error}", value.re),
        0.0 => format!("{:.6}{error}", value.re),
        im => format!("{:.6} ± {im:.6} i{error}", value.re),
    };
    listed(upper.take(MULTIPLIERS).map(text))
}

fn stability(steady: &Steady) -> String {
    if let Some(kind) = steady.instability {
        return format!("not stable: {kind}");
    }
    let single = steady.single_period.as_ref();
    match single.filter(|single| !single.is_stable()) {
        None => "stable".to_owned(),
        Some(single) => format!(
            "stable; the motion of a single period is not: largest multiplier {:.6}",
            single.largest()
        ),
    }
}

fn search(steady: &Steady) -> String {
    let waited = match steady.waited {
        0 => "from rest".to_owned(),
        waited => format!("after {waited} periods"),
    };
    format!(
        "{} corrections {waited}, misses its start by {:.1e} of its size, {} evaluations",
        steady.history.len(),
        steady.missing,
        steady.counters.evaluations
    )
}

fn put_swings(out: &mut Lines, steady: &Steady) {
    let header = ["swing", "mean", "peak to peak", "rms", "unit"];
    let rows = steady.swings.iter().map(|swing| {
        let (scale, unit) = match swing.channel.unit() {
            "m" => (MICRO, "µm"),
            "rad" => (MICRO, "µrad"),
            unit => (1.0, unit),
        };
        let numbers =
            [swing.mean, swing.peak_to_peak, swing.rms].map(|value| digits(scale * value));
        std::iter::once(swing.channel.name().to_owned())
            .chain(numbers)
            .chain([unit.to_owned()])
            .collect()
    });
    out.table(header, rows);
}

/// The strongest lines of the displacements that are lengths.
fn put_lines(out: &mut Lines, steady: &Steady, speed: f64) {
    let lines = &steady.lines;
    let lengths: Vec<usize> = (0..lines.channels.len())
        .filter(|index| lines.channels[*index].unit() == "m")
        .collect();
    let mut strongest: Vec<(usize, &SteadyLine)> = lines
        .lines
        .iter()
        .filter(|line| line.multiples != [0, 0])
        .flat_map(|line| lengths.iter().map(move |index| (*index, line)))
        .collect();
    strongest.sort_by(|a, b| b.1.amplitude[b.0].total_cmp(&a.1.amplitude[a.0]));
    let rows = strongest.into_iter().take(LINES).map(|(index, line)| {
        let order = if speed > 0.0 {
            format!("{:.4}", line.frequency * TAU / speed)
        } else {
            String::new()
        };
        vec![
            lines.channels[index].name().to_owned(),
            format!("{:.4}", line.frequency),
            order,
            digits(MICRO * line.amplitude[index]),
            format!("{}, {}", line.multiples[0], line.multiples[1]),
        ]
    });
    out.table(["line", "Hz", "order", "µm", "multiples"], rows);
}
