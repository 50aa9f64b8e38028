//! The few lines that a person reads after a run.

use std::fmt::{self, Write};
use std::path::PathBuf;

use comfy_table::{CellAlignment, Table, presets};

use super::histories::write_histories;
use super::method_use::method_use_text;
use super::motion::write_motion;
use super::table_use::table_use_text;
use super::wrapped;
use crate::analysis::{Peak, Spectrum};
use crate::report::units::MICRO;
use crate::rotor::Freedoms;
use crate::simulate::{Model, Run, StaticState};

/// Peaks shown.
const PEAKS: usize = 8;

/// Key numbers of a run, its strongest peaks and the files written.
pub fn text(title: &str, model: &Model, run: &Run, files: &[PathBuf]) -> String {
    let mut out = String::new();
    write_text(&mut out, title, model, run, files)
        .expect("a String takes everything that is written to it");
    out
}

fn write_text(
    out: &mut String,
    title: &str,
    model: &Model,
    run: &Run,
    files: &[PathBuf],
) -> fmt::Result {
    writeln!(out, "{title}")?;
    let freedoms = model.rotor.shaft.freedoms;
    writeln!(
        out,
        "  equilibrium   {}",
        equilibrium(&run.equilibrium, freedoms)
    )?;
    if !run.equilibrium.natural_frequencies.is_empty() {
        let line = format!("  natural       {}", natural(&run.equilibrium));
        writeln!(out, "{}", wrapped(&line, 16))?;
    }
    writeln!(
        out,
        "  integration   {} steps, {} rejected, {} evaluations, {} samples",
        run.counters.steps, run.counters.rejected, run.counters.evaluations, run.samples
    )?;
    if let Some(used) = &run.method_use {
        out.push_str(&method_use_text(used));
    }
    out.push_str(&table_use_text(&run.tables));
    if let Some(error) = &run.measured_error {
        writeln!(
            out,
            "  error         {:.2e} µm, {:.1e} of the motion (tolerance {:e}, measured against {:e})",
            MICRO * error.displacement,
            error.relative,
            model.integrator.tolerance,
            error.reference_tolerance
        )?;
        writeln!(
            out,
            "                by a second pass: {:.0} % of all evaluations; --no-verify saves them",
            100.0 * error.share_of_evaluations(&run.counters)
        )?;
    }
    if let Some(energy) = &run.energy {
        writeln!(
            out,
            "  energy        closes to {:.1e} J, {:.1e} of its largest part",
            energy.largest_residual, energy.relative_residual
        )?;
    }
    write_histories(out, &run.bearings)?;
    if let Some(motion) = &run.motion {
        write_motion(out, motion)?;
    }
    if !run.peaks.is_empty() {
        writeln!(out, "{}", peak_table(&run.peaks, run.spectrum.as_ref()))?;
    }
    for file in files {
        writeln!(out, "  wrote {}", file.display())?;
    }
    Ok(())
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
    kept.map(|((name, unit), value)| format!("{name} {} {unit}", decimal(MICRO * value)))
        .collect::<Vec<_>>()
        .join(", ")
}

/// `512.3 Hz (ζ 0.020), …`.
fn natural(state: &StaticState) -> String {
    let modes = state.natural_frequencies.iter();
    modes
        .map(|mode| format!("{:.2} Hz (ζ {:.3})", mode.frequency, mode.damping_ratio))
        .collect::<Vec<_>>()
        .join(", ")
}

/// The strongest peaks of x, y and z, which have one unit and so one order.
fn peak_table(peaks: &[Peak], spectrum: Option<&Spectrum>) -> String {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_header([
        "channel",
        "frequency",
        "order",
        "amplitude",
        "cause",
    ]);
    let mut lengths: Vec<&Peak> = peaks
        .iter()
        .filter(|peak| peak.channel.unit() == "m")
        .collect();
    lengths.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
    for peak in lengths.into_iter().take(PEAKS) {
        let order = spectrum
            .filter(|spectrum| spectrum.shaft_frequency > 0.0)
            .map(|spectrum| format!("{:.3}", peak.frequency / spectrum.shaft_frequency));
        table.add_row([
            peak.channel.name().to_owned(),
            format!("{:.3} Hz", peak.frequency),
            order.unwrap_or_default(),
            format!("{} µm", significant(MICRO * peak.amplitude)),
            peak.line
                .map(|line| line.kind.to_string())
                .unwrap_or_default(),
        ]);
    }
    for column in 1..=3 {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table.trim_fmt()
}

/// Four decimals, without a minus sign before zeros.
pub(super) fn decimal(value: f64) -> String {
    let rounded = (value * 1e4).round() / 1e4;
    format!("{:.4}", rounded + 0.0)
}

/// Four decimals, or powers of ten where they would not show the value.
fn significant(value: f64) -> String {
    if (1e-2..1e5).contains(&value) {
        format!("{value:.4}")
    } else {
        format!("{value:.3e}")
    }
}
