//! Key numbers of runs side by side.

use serde_json::Value;

use super::page::Folder;
use crate::analysis::{Rate, velocity_rate};
use crate::report::terminal::{Lines, MICRO, MILLI, digits, or_dash};
use crate::table::{Column, ColumnKind};

/// Numbers of a summary besides the velocities: their names with the unit that they are shown in, where they are found, and what
/// makes one in SI units one in that unit.
pub(super) const KEY_NUMBERS: [(&str, &str, f64); 5] = [
    (
        "stiffness x\nN/µm",
        "/stiffness/named/stiffness_x_N_m",
        1.0 / MICRO,
    ),
    (
        "stiffness y\nN/µm",
        "/stiffness/named/stiffness_y_N_m",
        1.0 / MICRO,
    ),
    ("largest ball\nload, N", "/largest_ball_load_N", 1.0),
    (
        "lowest natural\nfrequency, Hz",
        "/natural_frequencies/0/undamped_frequency_Hz",
        1.0,
    ),
    (
        "measured error\nof the motion",
        "/measured_error/relative",
        1.0,
    ),
];

/// A number of every entry of a list, as far as it has one.
pub(super) fn values<'a>(
    summary: &'a Value,
    list: &str,
    pointer: &'a str,
) -> impl Iterator<Item = f64> + use<'a> {
    let entries = summary.pointer(list).and_then(Value::as_array);
    let entries = entries.into_iter().flatten();
    entries.filter_map(move |entry| entry.pointer(pointer)?.as_f64())
}

/// What makes an amplitude of a column that of a velocity, of displacements of the shaft and of accelerations.
pub(super) fn rate_of(column: &Column) -> Option<Rate> {
    match column.kind {
        ColumnKind::Measure("amplitude") => velocity_rate(&column.unit),
        _ => None,
    }
}

/// A row a run.
pub(super) fn tell_key_numbers(runs: &[Folder], names: &[String], out: &mut Lines) {
    let velocities = AXES.map(|axis| format!("velocity {axis}\nmm/s RMS"));
    let header = ["run", "kind of motion"];
    let header = header
        .into_iter()
        .chain(velocities.iter().map(String::as_str));
    let header = header.chain(["housings\nmm/s RMS", "shortest life\nh"]);
    let header = header.chain(KEY_NUMBERS.map(|(name, ..)| name));
    let rows = runs.iter().zip(names).map(|(run, name)| {
        let kind = run.summary.pointer("/motion/kind/name");
        let kind = kind.and_then(Value::as_str).map(str::to_owned);
        let number = |pointer: &str, factor: f64| {
            let value = run.summary.pointer(pointer).and_then(Value::as_f64);
            or_dash(value.map(|value| digits(factor * value)))
        };
        let velocities =
            AXES.map(|axis| number(&format!("/motion/velocity_rms/{axis}/rms_m_s"), MILLI));
        let shown = |value: Option<f64>| or_dash(value.map(digits));
        let summary = &run.summary;
        let housings = values(summary, "/motion/housing_velocity_rms", "/rms_m_s");
        let housings = shown(housings.map(|rms| MILLI * rms).reduce(f64::max));
        let lives = values(summary, "/bearings", "/life/after_settle/life_h");
        let all = [housings, shown(lives.reduce(f64::min))];
        let others = KEY_NUMBERS.map(|(_, pointer, factor)| number(pointer, factor));
        let others = all.into_iter().chain(others);
        let cells = [name.clone(), or_dash(kind)];
        cells.into_iter().chain(velocities).chain(others).collect()
    });
    out.table(header, rows);
    for (run, name) in runs.iter().zip(names) {
        let title = run.summary["title"].as_str().unwrap_or_default();
        out.line(name, title);
    }
}

/// Axes whose velocities are shown.
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];
