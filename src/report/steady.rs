//! A steady motion: its trace, its lines and what is reported of it.

use std::f64::consts::TAU;

use nalgebra::Complex;
use serde_json::json;

use super::figure::{Axis, Curve, Figure, Name, Panel, Point, distinct};
use super::findings::with_keys;
use super::run::histories::Histories;
use super::run::tables::sample_table;
use super::run::text::reduction_text;
use super::terminal::{
    Lines, MICRO, MILLI, digits, listed, measured_text, shown_column, shown_unit,
};
use super::{FileSet, Findings};
use crate::analysis::{Channel, Line};
use crate::scenario::Scenario;
use crate::shooting::Multipliers;
use crate::simulate::Model;
use crate::steady::{Base, MotionRange, Stability, Steady, SteadyLine, SteadyLines};
use crate::table::{Column, Table};

/// A steady motion: its trace, its spectrum, its stability and its error.
pub fn steady_findings(scenario: &Scenario, model: &Model, steady: &Steady) -> Findings {
    let title = &scenario.title;
    let mut histories = Histories::new(model.rotor.shaft.freedoms);
    let trace = &steady.trace;
    let channels = Channel::of_trace_in(&scenario.echo, &model.rotor);
    trace.iter().for_each(|sample| histories.sample(sample));
    let tolerance = model.integrator.tolerance;
    let measured = steady.measured.as_ref();
    let measured = measured.map(|error| with_keys(error, json!({ "tolerance": tolerance })));
    let causes = steady.lines.causes(model);
    let further = json!({
        "stable": steady.is_stable(),
        "neutral": steady.stability == Stability::Neutral,
        "instability": match steady.stability {
            Stability::Unstable(kind) => Some(kind.to_string()),
            _ => None,
        },
        "lines": steady.lines.lines.len(),
        "measured_error": measured,
    });
    Findings {
        tables: vec![
            ("steady_trace", sample_table(trace, channels)),
            (
                "steady_spectrum",
                line_table(steady, model.rotor.speed, &causes),
            ),
        ],
        figures: vec![
            spectrum(title, &steady.lines, &causes),
            histories.displacements("steady_trace", title),
        ],
        ..Findings::new(
            FileSet::sealed("steady.json"),
            scenario,
            with_keys(steady, further),
            text(title, model, steady, &causes),
        )
    }
}

/// Frequency, order of the shaft (where it turns), both multiples, then amplitude and phase of every
/// channel.
fn line_table(steady: &Steady, speed: f64, causes: &[Line]) -> Table<'static> {
    let mut table =
        Table::from_items(&steady.lines.lines).column(Column::frequency(), |line| line.frequency);
    if speed > 0.0 {
        table = table.column(Column::order(), |line| line.frequency * TAU / speed);
    }
    table = table
        .word("name", |line| name_of(line, causes))
        .count("multiple_of_first", |line| f64::from(line.multiples[0]))
        .count("multiple_of_second", |line| f64::from(line.multiples[1]));
    for (index, channel) in steady.lines.channels.iter().enumerate() {
        let [amplitude, phase] = channel.lines();
        table = table
            .column(amplitude, |line| line.amplitude[index])
            .column(phase, |line| line.phase[index]);
    }
    table.end()
}

/// What causes a line; nothing where that is not known.
fn name_of(line: &SteadyLine, causes: &[Line]) -> String {
    let cause = line.cause(causes);
    cause.map_or_else(String::new, |line| line.kind.to_string())
}

/// Height of a plot, px.
const HEIGHT: u32 = 480;

/// Amplitudes of x, y and z (those that move) over frequency.
fn spectrum(title: &str, lines: &SteadyLines, causes: &[Line]) -> Figure {
    let lengths = lengths(lines);
    let all = || lengths.iter().flat_map(|(index, _)| tips(lines, *index));
    let strongest = all().map(|(_, amplitude)| amplitude).fold(0.0, f64::max);
    let amplitudes = Axis::below(("amplitude", "µm"), strongest);
    let floor = amplitudes.least();
    let shown = all().filter(|(_, amplitude)| *amplitude > floor);
    let highest = shown.map(|(frequency, _)| frequency).fold(0.0, f64::max);
    let limit = if highest > 0.0 { 1.05 * highest } else { 1.0 };
    let strokes = lengths.iter().enumerate().flat_map(|(place, (index, _))| {
        let shown = tips(lines, *index).filter(|(_, amplitude)| *amplitude > floor);
        shown.map(move |(frequency, amplitude)| {
            let ends = [floor, amplitude].map(|end| (frequency, end));
            Curve {
                // strokes of the same frequency are side by side
                beside: 2 * place as u8,
                ..Curve::line(distinct(place), ends.to_vec())
            }
        })
    });
    let mut peaks: Vec<(Point, String)> = Vec::new();
    for line in moving(lines) {
        let (name, heights) = (name_of(line, causes), lengths.iter());
        let height = heights
            .map(|(index, _)| MICRO * line.amplitude[*index])
            .fold(0.0, f64::max);
        if !name.is_empty() && height > floor {
            peaks.push(((line.frequency, height), name));
        }
    }
    peaks.sort_by(|(a, _), (b, _)| b.1.total_cmp(&a.1));
    peaks.truncate(LINES);
    let panel = Panel {
        curves: strokes.collect(),
        peaks,
        ..Panel::new(
            Axis::over(shown_column(&Column::frequency()).0, 0.0..limit),
            amplitudes,
            HEIGHT,
        )
    };
    let names = Name::each(lengths.iter().map(|(_, channel)| channel.name()));
    Figure::new("steady_spectrum", title, 1, vec![panel]).with_names(names)
}

/// The displacements that are lengths, with their places among all channels.
fn lengths(lines: &SteadyLines) -> Vec<(usize, &Channel)> {
    let channels = lines.channels.iter().enumerate();
    channels
        .filter(|(_, channel)| matches!(channel, Channel::Displacement(_)) && channel.unit() == "m")
        .collect()
}

/// All lines but the mean.
fn moving(lines: &SteadyLines) -> impl Iterator<Item = &SteadyLine> {
    lines.lines.iter().filter(|line| line.multiples != [0, 0])
}

/// Frequency and amplitude in µm of a channel's lines but the mean.
fn tips(lines: &SteadyLines, index: usize) -> impl Iterator<Item = Point> {
    moving(lines).map(move |line| (line.frequency, MICRO * line.amplitude[index]))
}

/// Part of the strongest line below which another one is round-off, and not shown.
const ROUND_OFF: f64 = 1e-13;
/// Lines and multipliers shown.
const LINES: usize = 8;
const MULTIPLIERS: usize = 4;

/// Period, stability and the strongest lines of a steady motion.
fn text(title: &str, model: &Model, steady: &Steady, causes: &[Line]) -> Lines {
    let mut out = Lines::titled(title);
    out.each("forcing", steady.bases.iter().map(forcing));
    out.line("motion", motion(steady));
    out.line("multipliers", multipliers(steady));
    out.line("stability", stability(steady));
    out.detail("search", search(steady));
    if let Some(error) = &steady.measured {
        let sizes = [error.displacement, error.relative];
        let tolerances = [model.integrator.tolerance, error.reference_tolerance];
        out.line("error", measured_text(sizes, tolerances));
    }
    out.each("shaft", steady.reduction.as_ref().map(reduction_text));
    add_ranges(&mut out, steady);
    add_lines(&mut out, steady, model.rotor.speed, causes);
    out
}

fn forcing(base: &Base) -> String {
    let parts = base.parts.iter().map(|part| match part.multiple {
        1 => part.cause.to_string(),
        many => format!("{many} × for {}", part.cause),
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
    match steady.stability {
        Stability::Unstable(kind) => return format!("not stable: {kind}"),
        Stability::Neutral => return "neutral: free vibrations beside it last".to_owned(),
        Stability::Stable => {}
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
        steady.residual,
        steady.counters.evaluations
    )
}

fn add_ranges(out: &mut Lines, steady: &Steady) {
    let header = ["channel", "mean", "peak to peak", "rms", "unit"];
    let of_shaft = |swing: &&MotionRange| {
        matches!(swing.channel, Channel::Displacement(_) | Channel::Force(_))
    };
    let rows = steady.ranges.iter().filter(of_shaft).map(|swing| {
        let (unit, scale) = shown_unit(swing.channel.unit());
        let numbers =
            [swing.mean, swing.peak_to_peak, swing.rms].map(|value| digits(scale * value));
        std::iter::once(swing.channel.name().to_owned())
            .chain(numbers)
            .chain([unit])
            .collect()
    });
    out.table(header, rows);
}

/// The strongest lines of the displacements that are lengths.
fn add_lines(out: &mut Lines, steady: &Steady, speed: f64, causes: &[Line]) {
    let lines = &steady.lines;
    let lengths = lengths(lines);
    let moving = moving(lines).flat_map(|line| {
        let channels = lengths.iter();
        channels.map(move |(index, channel)| (*index, channel.name(), line))
    });
    let mut strongest: Vec<_> = moving.collect();
    strongest.sort_by(|a, b| b.2.amplitude[b.0].total_cmp(&a.2.amplitude[a.0]));
    let height = |(index, _, line): &(usize, &str, &SteadyLine)| line.amplitude[*index];
    let least = ROUND_OFF * strongest.first().map_or(0.0, height);
    strongest.retain(|own| height(own) > least);
    let rows = strongest
        .into_iter()
        .take(LINES)
        .map(|(index, name, line)| {
            let order = if speed > 0.0 {
                format!("{:.4}", line.frequency * TAU / speed)
            } else {
                String::new()
            };
            vec![
                name.to_owned(),
                format!("{:.4}", line.frequency),
                order,
                digits(MICRO * line.amplitude[index]),
                digits(MILLI * TAU * line.frequency * line.amplitude[index]),
                name_of(line, causes),
                format!("{}, {}", line.multiples[0], line.multiples[1]),
            ]
        });
    out.table(
        ["line", "Hz", "order", "µm", "mm/s", "name", "multiples"],
        rows,
    );
}
