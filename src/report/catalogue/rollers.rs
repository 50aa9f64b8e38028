//! Roller bearings of the catalogue: the list, and one of them.

use serde_json::{Value, json};

use crate::bearing::{RollerEntry, RollerEstimate, RollerLine};
use crate::report::findings::versioned;
use crate::report::terminal::{Lines, mark_estimated, or_dash, rounded};

fn millimetres(length: f64) -> f64 {
    rounded(1e3 * length, 6)
}

/// A row a bearing.
pub fn add_roller_table<'a>(
    out: &mut Lines,
    bearings: impl Iterator<Item = (&'a RollerEntry, RollerEstimate)>,
) {
    let header = [
        "name",
        "kind",
        "rollers",
        "roller\nmm",
        "pitch\nmm",
        "angle\ndeg",
        "boundary\nmm",
        "C\nN",
        "C0\nN",
        "maker",
    ];
    let rows = bearings.map(|(entry, estimate)| {
        let (line, best) = (&entry.line, &estimate.best);
        let angle = rounded(line.contact_angle.to_degrees(), 4);
        let [bore, outside, width] = line.boundary.map(millimetres);
        vec![
            entry.designation.clone(),
            line.kind.name().to_owned(),
            best.rollers.to_string(),
            format!(
                "{} × {}",
                millimetres(best.diameter),
                millimetres(best.length)
            ),
            millimetres(estimate.pitch_diameter).to_string(),
            or_dash((angle > 0.0).then(|| angle.to_string())),
            format!("{bore} × {outside} × {width}"),
            line.dynamic_rating.to_string(),
            line.static_rating.to_string(),
            entry.maker.clone(),
        ]
    });
    out.put("Roller bearings; the rollers are estimated from the ratings");
    out.table(header, rows);
}

/// A page on one roller bearing.
pub fn roller_entry_text(entry: &RollerEntry, estimate: &RollerEstimate) -> Lines {
    let mut out = roller_estimate_text(&entry.designation, &entry.line, estimate);
    out.line("source", &entry.source);
    out
}

/// The rollers of a catalogue line for people.
pub fn roller_estimate_text(title: &str, line: &RollerLine, estimate: &RollerEstimate) -> Lines {
    let best = &estimate.best;
    let mut out = Lines::titled(title);
    let [bore, outside, width] = line.boundary.map(millimetres);
    out.line("size", format!("{bore} × {outside} × {width} mm"));
    let rows = if line.kind.rows() > 1 {
        " a row, two rows"
    } else {
        ""
    };
    let [diameter, length, pitch] =
        [best.diameter, best.length, estimate.pitch_diameter].map(millimetres);
    let rollers = format!(
        "{}, {} of {diameter} × {length} mm on {pitch} mm{}{rows}",
        line.kind.name(),
        best.rollers,
        mark_estimated(estimate.estimated)
    );
    out.line("rollers", rollers);
    for (name, found, printed) in [
        ("C", best.dynamic_rating, line.dynamic_rating),
        ("C0", best.static_rating, line.static_rating),
    ] {
        out.line(
            name,
            format!("{found:.0} N of these rollers, {printed} N printed"),
        );
    }
    out.each("next best", estimate.runner_up);
    out.each("note", &estimate.notes);
    out
}

/// The rollers of a catalogue line as JSON, with what is printed.
pub fn roller_estimate_json(line: &RollerLine, estimate: &RollerEstimate) -> Value {
    let mut value = versioned(estimate);
    let [bore, outside, width] = line.boundary;
    value["printed"] = json!({
        "bore_m": bore,
        "outside_diameter_m": outside,
        "width_m": width,
        "contact_angle_rad": line.contact_angle,
        "dynamic_rating_N": line.dynamic_rating,
        "static_rating_N": line.static_rating,
    });
    value
}

/// A roller bearing as JSON.
pub fn roller_entry_json(entry: &RollerEntry, estimate: &RollerEstimate) -> Value {
    let line = &entry.line;
    let [bore, outside, width] = line.boundary.map(millimetres);
    let angle = rounded(line.contact_angle.to_degrees(), 6);
    json!({
        "designation": entry.designation,
        "maker": entry.maker,
        "kind": line.kind,
        "contact_angle_deg": (angle > 0.0).then_some(angle),
        "bore_mm": bore,
        "outside_diameter_mm": outside,
        "width_mm": width,
        "dynamic_rating_N": line.dynamic_rating,
        "static_rating_N": line.static_rating,
        "estimate": estimate,
        "source": entry.source,
    })
}
