//! The few lines that a person reads after a run: what was found, which method and law it rests on.

use super::method_use::{add_table_use, method_use_text, parted};
use super::motion::{add_housings, add_motion, add_severity};
use super::run_up::add_run_up;
use crate::analysis::{Axis, EnvelopeLine, EstimatedSpectrum, Peak, Spectrum};
use crate::numerics::digits::to_digits;
use crate::physics::PER_MINUTE;
use crate::report::statics::ball_pass_text;
use crate::report::terminal::{
    Lines, MICRO, clearance_text, displacement_text, listed, mark_estimated, measured_text,
    of_bearing, shown_unit, significant,
};
use crate::simulate::{
    BearingHistory, EventCount, EventKind, Model, NaturalFrequency, Reduction, Run, SpallPassage,
    Spread, StaticState,
};
use crate::study::campbell::Campbell;

/// Peaks shown.
const PEAKS: usize = 8;

/// Lines of an envelope shown.
const ENVELOPE_LINES: usize = 6;

/// Key numbers of a run and its strongest peaks.
///
/// `campbell` is what is known of critical speeds where the speed changes.
pub fn text(title: &str, model: &Model, run: &Run, campbell: Option<&Campbell>) -> Lines {
    let mut out = Lines::titled(title);
    if let Some(severity) = &run.vibration_severity {
        add_severity(&mut out, severity);
    }
    if let Some(motion) = &run.motion {
        add_housings(&mut out, motion);
    }
    if let Some(run_up) = &run.run_up {
        add_run_up(&mut out, run_up, campbell);
    }
    out.each("spall", run.spalls.iter().map(spall_text));
    add_envelope_lines(&mut out, &run.spectra);
    let moving = model.rotor.shaft.freedoms.axes();
    let place = displacement_text(moving, &run.equilibrium.displacement);
    out.line("equilibrium", place);
    let first = PER_MINUTE * model.rotor.speed;
    let natural = natural(&run.equilibrium);
    out.line(
        "natural",
        match run.run_up {
            Some(_) => format!("at {} rpm: {natural}", to_digits(first, 6)),
            None => natural,
        },
    );
    let rolling = model.rotor.bearings.iter();
    let elements = rolling.map(|mounted| mounted.bearing.geometry.element());
    for (index, (pass, element)) in run.ball_pass.iter().zip(elements).enumerate() {
        let bearing = of_bearing(index, run.ball_pass.len());
        let text = ball_pass_text(pass, element);
        out.detail("ball pass", format!("{bearing}{text}"));
    }
    let counters = &run.counters;
    let work = format!(
        "{} steps, {} rejected, {} evaluations, {} samples",
        counters.steps, counters.rejected, counters.evaluations, run.samples
    );
    out.detail("integration", work);
    if let Some([assumed, recorded]) = run.corrected_scale {
        let [assumed, recorded] = [assumed, recorded].map(|size| significant(MICRO * size));
        let text = format!(
            "begun anew for a motion of {recorded} µm, as recorded, in place of {assumed} µm"
        );
        out.detail("scale", text);
    }
    if let Some(used) = &run.method_use {
        out.detail("method", method_use_text(used, parted(&run.bearings)));
    }
    add_table_use(&mut out, &run.tables);
    let tolerance = model.integrator.tolerance;
    out.each(
        "error",
        run.measured_error.as_ref().map(|error| {
            let sizes = [error.displacement, error.relative];
            measured_text(sizes, [tolerance, error.reference_tolerance])
        }),
    );
    let reduction = run.reduction.as_ref();
    out.each("shaft", reduction.map(reduction_text));
    let sufficient = reduction.and_then(|reduction| reduction.sufficient_tolerance(tolerance));
    out.each(
        "",
        sufficient.map(|sufficient| {
            format!(
                "the tolerance of {tolerance:.0e} is finer than that: {sufficient:.0e} would do"
            )
        }),
    );
    if let Some(share) = run.share_of_verification() {
        let text = "of all evaluations measure errors; --no-verify saves them";
        out.detail("verification", format!("{:.0} % {text}", 100.0 * share));
    }
    if let Some(energy) = &run.energy {
        let (residual, relative) = (energy.largest_residual, energy.relative_residual);
        let text = format!("closes to {residual:.1e} J, {relative:.1e} of its largest part");
        out.line("energy", text);
    }
    add_histories(&mut out, &run.bearings);
    if let Some(motion) = &run.motion {
        add_motion(&mut out, motion);
    }
    if !run.peaks.is_empty() {
        add_peaks(&mut out, &run.peaks, run.spectrum.as_ref(), "m");
    }
    out
}

/// The strongest named lines of envelopes.
pub(in crate::report) fn add_envelope_lines(out: &mut Lines, spectra: &[EstimatedSpectrum]) {
    for spectrum in spectra.iter().filter(|of| !of.lines.is_empty()) {
        let lines = spectrum.lines.iter().take(ENVELOPE_LINES);
        let lines = lines.map(|line| line_text(spectrum, line));
        out.line(&spectrum.request.name, listed(lines));
    }
}

/// `6 modes of bending in each plane, 1.2e-6 µm, 3e-6 of the motion, from 10`.
pub(in crate::report) fn reduction_text(reduction: &Reduction) -> String {
    let kept = format!("{} modes of bending in each plane", reduction.modes);
    match &reduction.error {
        None => kept,
        Some(error) => format!(
            "{kept}: {} µm, {:.1e} of the motion, from {}",
            significant(MICRO * error.displacement),
            error.relative,
            error.modes
        ),
    }
}

/// Natural frequencies shown.
const FREQUENCIES: usize = 12;

/// `512.3 Hz (ζ 0.020), …`.
fn natural(state: &StaticState) -> String {
    let highest = state.natural_up_to.unwrap_or(f64::INFINITY);
    let all = state.natural_frequencies.iter();
    let reliable = all.filter(|mode| mode.frequency <= highest);
    let more = reliable.clone().count().saturating_sub(FREQUENCIES);
    let modes = reliable.take(FREQUENCIES);
    let text = |mode: &NaturalFrequency| {
        let (frequency, damping) = (mode.frequency, mode.damping_ratio);
        format!("{frequency:.2} Hz (ζ {damping:.3})")
    };
    let rest = (more > 0).then(|| format!("and {more} higher ones"));
    let beyond = state
        .natural_up_to
        .map(|highest| format!("above {} Hz more `modes` are needed", to_digits(highest, 2)));
    let rest = rest.into_iter().chain(beyond);
    listed(modes.map(text).chain(rest))
}

/// `bearing 1, the outer race: 151.3 µs from entry to impact`.
fn spall_text(spall: &SpallPassage) -> String {
    format!(
        "bearing {}, {}: {:.1} µs from entry to impact",
        spall.bearing,
        spall.on,
        MICRO * spall.entry_to_impact
    )
}

/// `BPFO 107.4 Hz 0.53 m/s²`, over orders `BPFO 3.585×`.
fn line_text(spectrum: &EstimatedSpectrum, line: &EnvelopeLine) -> String {
    let (unit, factor) = shown_unit(&spectrum.unit(spectrum.columns[line.column].quantity));
    let place = match spectrum.request.axis {
        Axis::Frequency => format!("{:.1} Hz", line.place),
        Axis::Order => format!("{:.3}×", line.place),
    };
    let value = to_digits(factor * line.value, 3);
    format!("{} {place} {value} {unit}", line.line.kind)
}

/// The strongest peaks of channels of one unit, which have one order.
pub(in crate::report) fn add_peaks(
    out: &mut Lines,
    peaks: &[Peak],
    spectrum: Option<&Spectrum>,
    unit: &str,
) {
    let alike = peaks.iter().filter(|peak| peak.channel.unit() == unit);
    let mut alike: Vec<&Peak> = alike.collect();
    alike.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
    let (shown, factor) = shown_unit(unit);
    let turning = spectrum.filter(|spectrum| spectrum.shaft_frequency > 0.0);
    let rows = alike.into_iter().take(PEAKS).map(|peak| {
        let order = |spectrum: &Spectrum| peak.frequency / spectrum.shaft_frequency;
        let order = turning.map(|spectrum| format!("{:.3}", order(spectrum)));
        let cause = peak.line.map(|line| line.kind.to_string());
        vec![
            peak.channel.name().to_owned(),
            format!("{:.3} Hz", peak.frequency),
            order.unwrap_or_default(),
            format!("{} {shown}", significant(factor * peak.amplitude)),
            cause.unwrap_or_default(),
        ]
    });
    let header = ["channel", "frequency", "order", "amplitude", "cause"];
    out.table(header, rows);
}

/// Two lines a bearing: what its balls did, and its life.
pub(super) fn add_histories(out: &mut Lines, bearings: &[BearingHistory]) {
    for (index, bearing) in bearings.iter().enumerate() {
        let name = of_bearing(index, bearings.len());
        let clearance = bearing.clearance.as_ref().map(clearance_text);
        out.each("clearance", clearance.map(|text| format!("{name}{text}")));
        let zone = bearing.load_zone.as_ref();
        let loaded = zone.map(|zone| balls_loaded(&zone.balls, bearing));
        let zone = loaded.map(|loaded| format!("{name}{loaded}{}", losses(bearing)));
        out.each("load zone", zone);
        if bearing.estimated {
            let what = match bearing.element {
                "ball" => "balls and grooves",
                _ => "rollers",
            };
            let text = "follow from a catalogue's ratings, and with them all numbers here";
            out.line("estimated", format!("{name}{what} {text}"));
        }
        // the start is left out where enough remains
        let life = bearing
            .life
            .map(|life| match life.after_settle.rating_life() {
                Some(_) => life.after_settle,
                None => life.whole_run,
            });
        if let Some((life, hours)) = life.and_then(|life| life.rating_life().zip(life.hours())) {
            let text = format!("{life:.4e} million revolutions, {hours:.3e} h of this motion");
            let mark = mark_estimated(bearing.estimated);
            out.line("life L10r", format!("{name}{text}{mark}"));
        }
        if let Some(modified) = bearing.life.and_then(|life| life.modified)
            && let Some(hours) = modified.hours
        {
            let factor = modified.life_modification_factor;
            let factor = factor.map_or(String::new(), |factor| format!(", a_ISO {factor:.3}"));
            let text = format!("{name}{hours:.3e} h at {} %{factor}", modified.reliability);
            out.line("life L_nm", text);
        }
    }
}

/// `all 12 balls loaded` or `3 to 5 of 12 balls loaded, mean 4.21`.
fn balls_loaded(loaded: &Spread, bearing: &BearingHistory) -> String {
    let (balls, element) = (bearing.balls, bearing.element);
    if loaded.smallest == balls as f64 {
        return format!("all {balls} {element}s loaded");
    }
    format!(
        "{} to {} of {balls} {element}s loaded, mean {:.2}",
        loaded.smallest, loaded.largest, loaded.mean
    )
}

/// `; contact lost 12 times, from 0.1 s to 0.4 s` and the same of a preload, where they happened.
fn losses(bearing: &BearingHistory) -> String {
    let mut text = String::new();
    for (kind, name) in [
        (EventKind::ContactLost, "contact"),
        (EventKind::PreloadLost, "preload"),
    ] {
        let EventCount { count, span } = bearing.events(kind);
        match span {
            None => {}
            Some([time, _]) if count == 1 => text += &format!("; {name} lost once, at {time:.4} s"),
            Some([first, last]) => {
                text += &format!("; {name} lost {count} times, {first:.4} s to {last:.4} s");
            }
        }
    }
    text
}
