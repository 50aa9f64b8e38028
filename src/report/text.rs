//! The few lines that a person reads after a run.

use std::path::PathBuf;

use super::histories::put_histories;
use super::method_use::method_use_text;
use super::motion::put_motion;
use super::table_use::put_table_use;
use super::terminal::{Lines, decimal, listed, measured_text, significant};
use crate::analysis::{Peak, Spectrum};
use crate::report::units::MICRO;
use crate::rotor::Freedoms;
use crate::simulate::{Model, Run, StaticState};

/// Peaks shown.
const PEAKS: usize = 8;

/// Key numbers of a run, its strongest peaks and the files written.
pub fn text(title: &str, model: &Model, run: &Run, files: &[PathBuf]) -> String {
    let mut out = Lines::titled(title);
    let freedoms = model.rotor.shaft.freedoms;
    out.line("equilibrium", equilibrium(&run.equilibrium, freedoms));
    out.line("natural", natural(&run.equilibrium));
    let counters = &run.counters;
    out.line(
        "integration",
        format_args!(
            "{} steps, {} rejected, {} evaluations, {} samples",
            counters.steps, counters.rejected, counters.evaluations, run.samples
        ),
    );
    if let Some(used) = &run.method_use {
        out.line("method", method_use_text(used));
    }
    put_table_use(&mut out, &run.tables);
    if let Some(error) = &run.measured_error {
        let sizes = [error.displacement, error.relative];
        let tolerances = [model.integrator.tolerance, error.reference_tolerance];
        out.line("error", measured_text(sizes, tolerances));
        let share = 100.0 * error.share_of_evaluations(&run.counters);
        out.more(format_args!(
            "by a second pass: {share:.0} % of all evaluations; --no-verify saves them"
        ));
    }
    if let Some(energy) = &run.energy {
        let (residual, relative) = (energy.largest_residual, energy.relative_residual);
        let text = format!("closes to {residual:.1e} J, {relative:.1e} of its largest part");
        out.line("energy", text);
    }
    put_histories(&mut out, &run.bearings);
    if let Some(motion) = &run.motion {
        put_motion(&mut out, motion);
    }
    if !run.peaks.is_empty() {
        put_peaks(&mut out, &run.peaks, run.spectrum.as_ref());
    }
    out.wrote(files)
}

/// `x 0.1 µm, y −3.2 µm, …` of the freedoms that move.
fn equilibrium(state: &StaticState, freedoms: Freedoms) -> String {
    let names = [
        ("x", "µm"),
        ("y", "µm"),
        ("z", "µm"),
        ("θx", "µrad"),
        ("θy", "µrad"),
    ];
    let kept = names.iter().zip(state.displacement).take(freedoms.count());
    listed(kept.map(|((name, unit), value)| format!("{name} {} {unit}", decimal(MICRO * value))))
}

/// `512.3 Hz (ζ 0.020), …`.
fn natural(state: &StaticState) -> String {
    let modes = state.natural_frequencies.iter();
    listed(modes.map(|mode| format!("{:.2} Hz (ζ {:.3})", mode.frequency, mode.damping_ratio)))
}

/// The strongest peaks of x, y and z, which have one unit and so one order.
fn put_peaks(out: &mut Lines, peaks: &[Peak], spectrum: Option<&Spectrum>) {
    let lengths = peaks.iter().filter(|peak| peak.channel.unit() == "m");
    let mut lengths: Vec<&Peak> = lengths.collect();
    lengths.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
    let turning = spectrum.filter(|spectrum| spectrum.shaft_frequency > 0.0);
    let rows = lengths.into_iter().take(PEAKS).map(|peak| {
        let order = |spectrum: &Spectrum| peak.frequency / spectrum.shaft_frequency;
        let order = turning.map(|spectrum| format!("{:.3}", order(spectrum)));
        vec![
            peak.channel.name().to_owned(),
            format!("{:.3} Hz", peak.frequency),
            order.unwrap_or_default(),
            format!("{} µm", significant(MICRO * peak.amplitude)),
            peak.line
                .map(|line| line.kind.to_string())
                .unwrap_or_default(),
        ]
    });
    out.table(
        ["channel", "frequency", "order", "amplitude", "cause"],
        rows,
    );
}
