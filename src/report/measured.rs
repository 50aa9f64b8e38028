//! What was found in a record: its document, its text, its figures and its tables, as of a run.

use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::{Value, json};

use super::FileSet;
use super::figure::Figure;
use super::findings::{Findings, document, versioned};
use super::run::answer::SpectraSummary;
use super::run::histories::Histories;
use super::run::motion::{add_severity, rms_text};
use super::run::order_tracks::tracks_table;
use super::run::run_up::{maps_figures, waterfall_table};
use super::run::text::{add_envelope_lines, add_peaks};
use super::spectra::{
    estimated_figures, estimated_table, frequency_limit, measured_figures, peak_table,
    spectrum_table, table_name,
};
use super::statics::ball_pass_text;
use super::terminal::{Lines, digits, listed, of_bearing, shown_unit, significant};
use crate::analysis::{Axis, ChannelStatistics, Spectrum};
use crate::measurement::{Measured, Slip, SpeedEstimate, UnnamedLine};
use crate::numerics::distinct::each_once;
use crate::physics::{PER_MINUTE, Race, velocity_band};
use crate::record::Record;
use crate::scenario::RecordDescription;
use crate::table::Table;

/// What was found in a record that a description names.
pub fn measured_findings(file: &RecordDescription, found: &Measured) -> Findings {
    let mut text = Lines::titled(&file.title);
    tell(&mut text, found);
    let document = document(&file.title, &file.echo, RecordSummary::new(file, found));
    Findings {
        output: file.output.clone(),
        tables: peaks(found)
            .map(|table| ("peaks", table))
            .into_iter()
            .collect(),
        long_tables: long_tables(found),
        figures: figures(&file.title, found),
        ..Findings::of_document(FileSet::sealed("record.json"), document, text)
    }
}

/// Everything that is found in a record except its spectra: `record.json` is its document.
#[derive(Debug, Serialize)]
struct RecordSummary<'a> {
    channels: Value,
    samples: usize,
    start_s: f64,
    speed: Option<Value>,
    #[serde(flatten)]
    found: &'a Measured,
    #[serde(flatten)]
    spectra: SpectraSummary,
    warnings: Vec<&'a str>,
}

impl<'a> RecordSummary<'a> {
    fn new(file: &'a RecordDescription, found: &'a Measured) -> Self {
        let warnings = file.warnings.iter().chain(&found.warnings);
        let speed = found.speed.map(|[mean, lowest, highest]| {
            json!({ "mean_rad_s": mean, "lowest_rad_s": lowest, "highest_rad_s": highest })
        });
        Self {
            channels: file.channels.records(),
            samples: found.recording.length(),
            start_s: found.recording.start(),
            speed,
            found,
            spectra: SpectraSummary::new(
                found.spectrum.as_ref(),
                &found.peaks,
                found.maps.as_ref(),
                &found.spectra,
            ),
            warnings: warnings.map(String::as_str).collect(),
        }
    }
}

/// Key numbers and the strongest peaks.
fn tell(out: &mut Lines, found: &Measured) {
    let names = &found.bearings;
    let samples = found.recording.length();
    let seconds = digits(samples as f64 / found.rate);
    let rate = digits(found.rate);
    let count = found.statistics.len();
    let channels = if count == 1 { "channel" } else { "channels" };
    out.line(
        "record",
        format!("{count} {channels} of {samples} samples, {seconds} s at {rate} Hz"),
    );
    if let Some([mean, lowest, highest]) = found.speed.map(|speed| speed.map(|it| PER_MINUTE * it))
    {
        let range = match highest - lowest > 1e-9 * mean {
            true => format!(", from {lowest:.2} to {highest:.2} rpm"),
            false => String::new(),
        };
        out.line(
            "speed",
            format!("{mean:.2} rpm ({:.4} Hz){range}", mean / 60.0),
        );
        let passes = found.ball_pass.iter().zip(&found.elements);
        for (index, ((pass, element), name)) in passes.zip(names).enumerate() {
            let bearing = of_bearing(index, names.len());
            out.line(
                "ball pass",
                format!("{bearing}{name}: {}", ball_pass_text(pass, element)),
            );
        }
    }
    if let Some(severity) = &found.severity {
        add_severity(out, severity);
    }
    add_envelope_lines(out, &found.spectra);
    for (index, (slip, element)) in found.slips.iter().zip(&found.elements).enumerate() {
        if let Some(slip) = slip {
            out.line(
                "slip",
                format!(
                    "{}{}",
                    of_bearing(index, names.len()),
                    slip_text(slip, element)
                ),
            );
        }
    }
    for line in &found.unnamed_lines {
        out.line(&line.spectrum, unnamed_text(line));
    }
    for estimate in &found.speed_estimates {
        out.line("speed?", estimate_text(estimate));
    }
    for ChannelStatistics { channel, moments } in &found.statistics {
        let (unit, factor) = shown_unit(channel.unit());
        let [rms, peak] = [moments.rms(), moments.peak()].map(|value| significant(factor * value));
        let shape = moments.crest_factor().zip(moments.kurtosis());
        let shape = shape.map_or_else(String::new, |(crest, kurtosis)| {
            format!(", crest factor {crest:.2}, kurtosis {kurtosis:.2}")
        });
        out.line(
            channel.name(),
            format!("{rms} {unit} RMS, peak {peak}{shape}"),
        );
        let level = found
            .velocity
            .iter()
            .find(|level| level.channel == *channel);
        out.more(level.map_or_else(String::new, |of| rms_text(&of.level)));
    }
    out.each(
        "spectrum",
        found
            .spectrum
            .as_ref()
            .and_then(|of| part_text(of, samples, found.rate)),
    );
    for unit in each_once(found.peaks.iter().map(|peak| peak.channel.unit())) {
        add_peaks(out, &found.peaks, found.spectrum.as_ref(), unit);
    }
}

/// `peaks are those of the last 2.5600 s, from 117.44 s on`; none where the spectrum is of nearly all samples.
fn part_text(spectrum: &Spectrum, samples: usize, rate: f64) -> Option<String> {
    let is_part = (spectrum.length as f64) < NEARLY_ALL * samples as f64;
    let seconds = digits(spectrum.length as f64 / rate);
    let start = digits(spectrum.start);
    is_part.then(|| format!("peaks are those of the last {seconds} s, from {start} s on"))
}

/// `the line of the outer race is at 3.5480× (with 2×, 3×), and at 3.5848× if the cage rolled: cage_slip = 0.0103 ± 0.0002`.
fn slip_text(slip: &Slip, element: &str) -> String {
    let part = match slip.race {
        Some(Race::Inner) => "the inner race",
        Some(Race::Outer) => "the outer race",
        None => &format!("a {element} that spins"),
    };
    let further = slip.multiples.iter().filter(|multiple| **multiple > 1);
    let further = listed(further.map(|multiple| format!("{multiple}×")));
    let with = match further.is_empty() {
        true => String::new(),
        false => format!(" (with its {further})"),
    };
    let (order, rolling) = (slip.order, slip.kinematic_order);
    let (amount, known) = (slip.cage_slip, slip.uncertainty);
    let says = if amount < -known {
        "; the cage is faster than its bearing rolls: a contact angle or a speed differs"
    } else {
        ""
    };
    // two digits of what is uncertain, and the slip as far
    let decimals = (1.0 - known.log10().floor()).clamp(4.0, 9.0) as usize;
    format!(
        "the line of {part} is at {order:.4}×{with}, where the cage rolls at {rolling:.4}×: cage_slip = {amount:.decimals$} ± \
         {known:.decimals$}{says}"
    )
}

/// `140.0 Hz, the strongest line, 6000 times the noise around it, has no name: nothing known of shaft and bearings causes it`.
fn unnamed_text(line: &UnnamedLine) -> String {
    let place = match line.axis {
        Axis::Frequency => format!("{:.1} Hz", line.place),
        Axis::Order => format!("{:.3}×", line.place),
    };
    let above = digits(line.above_noise);
    format!(
        "{place}, the strongest line, {above} times the noise around it, has no name: nothing known of shaft and bearings causes it"
    )
}

/// `29.95 Hz (1797 rpm) would explain 7 of 12 lines of the envelope, the strongest as BPFO: an estimate; --speed takes it`.
fn estimate_text(estimate: &SpeedEstimate) -> String {
    let ([some, all], shaft) = (estimate.lines, estimate.shaft_frequency);
    format!(
        "{shaft:.3} Hz ({:.1} rpm) would explain {some} of {all} lines of the envelope, the strongest as {}: an estimate, which \
         --speed takes",
        60.0 * shaft,
        estimate.strongest
    )
}

fn peaks(found: &Measured) -> Option<Table<'static>> {
    let spectrum = found.spectrum.as_ref()?;
    Some(peak_table(&found.peaks, spectrum))
}

fn long_tables(found: &Measured) -> Vec<(String, Table<'static>)> {
    let mut tables = Vec::new();
    let mut add = |name: String, table: Table<'_>| tables.push((name, table.into_owned()));
    if let Some(spectrum) = &found.spectrum {
        add("spectrum".to_owned(), spectrum_table(spectrum));
    }
    for spectrum in &found.spectra {
        add(table_name(spectrum), estimated_table(spectrum));
    }
    if let Some(maps) = &found.maps {
        add("waterfall".to_owned(), waterfall_table(&maps.waterfall));
        add("order_tracks".to_owned(), tracks_table(&maps.tracks));
    }
    tables
}

/// What is drawn, in the order of the page: envelopes with names first.
fn figures(title: &str, found: &Measured) -> Vec<Figure> {
    let spectrum = found.spectrum.as_ref();
    let limit = spectrum.map_or(f64::INFINITY, |spectrum| {
        frequency_limit(spectrum, &found.peaks)
    });
    let highest = found.speed.map_or(0.0, |[_, _, highest]| highest);
    let passes = found
        .ball_pass
        .iter()
        .map(|pass| 4.5 * pass.outer.max(pass.inner));
    let lines = passes.fold(0.0, f64::max);
    let lines = if lines > 0.0 { lines } else { limit };
    let drawn = |named, limit| estimated_figures(title, &found.spectra, named, limit);
    let lowest = velocity_band(if highest > 0.0 {
        highest
    } else {
        f64::INFINITY
    })[0];
    let mut figures: Vec<Figure> = drawn(true, lines).collect();
    let spectra = spectrum.map(|spectrum| measured_figures(title, spectrum, &found.peaks, lowest));
    figures.extend(spectra.into_iter().flatten());
    let signals = found.statistics.iter();
    let signals = signals.map(|of| (of.channel, found.recording.channel(of.channel)));
    let histories = Histories::of_columns(signals, found.recording.start(), found.rate);
    figures.push(histories.all("trace", title));
    figures.extend(found.maps.iter().flat_map(|maps| maps_figures(title, maps)));
    figures.extend(drawn(false, limit));
    figures
}

/// What a file holds: its channels, the numbers and texts that go with them, and what was left out.
pub fn listed_record(name: &str, record: &Record) -> Lines {
    let mut out = Lines::titled(name);
    let shown = [
        ("channel", "channel"),
        ("samples", "samples"),
        ("rate", "rate"),
        ("duration", "duration"),
        ("measured", "quantity"),
        ("unit", "unit"),
        ("place", "place"),
    ];
    out.show(&record.list(), &shown, 6);
    for (name, number) in record.numbers.iter().take(MOST_LISTED) {
        out.put(format!("  {name} = {number}"));
    }
    for (name, text) in record.texts.iter().take(MOST_LISTED) {
        out.put(format!("  {name}: {text:.80}"));
    }
    out
}

/// Part of the samples that a spectrum of nearly all rests on.
const NEARLY_ALL: f64 = 0.9;
/// Numbers and texts that are listed of a file.
const MOST_LISTED: usize = 40;

/// What a file holds, for programs.
pub fn record_json(name: &str, record: &Record) -> Value {
    let numbers: BTreeMap<_, _> = record.numbers.iter().cloned().collect();
    let texts: BTreeMap<_, _> = record.texts.iter().cloned().collect();
    let warnings = [&record.warnings[..], &record.missing()].concat();
    versioned(json!({
        "file": name,
        "channels": record.list().records(),
        "numbers": numbers,
        "texts": texts,
        "warnings": warnings,
    }))
}
