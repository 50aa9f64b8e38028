//! A bearing from a catalogue line: what is printed, what was found, and how far both agree.

use serde_json::{Value, json};

use crate::bearing::catalogue::CatalogueEntry;
use crate::bearing::{Bearing, CatalogueLine, Estimate};
use crate::report::findings::versioned;
use crate::report::terminal::{Lines, mark_estimated, rounded};

/// The estimate for people.
pub fn estimate_text(title: &str, line: &CatalogueLine, estimate: &Estimate) -> Lines {
    let mut out = Lines::titled(title);
    add_estimate(&mut out, line, estimate);
    out
}

/// The estimate as JSON: the geometry with the ratings that it has, with what is printed.
pub fn estimate_json(line: &CatalogueLine, estimate: &Estimate) -> Value {
    let mut value = versioned(estimate);
    value["printed"] = json!({
        "bore_m": line.bore,
        "outside_diameter_m": line.outside_diameter,
        "contact_angle_rad": line.contact_angle,
        "dynamic_rating_N": line.dynamic_rating,
        "static_rating_N": line.static_rating,
        "f0": line.static_factor,
    });
    value
}

/// A page on one bearing of the catalogue.
pub fn entry_text(entry: &CatalogueEntry, bearing: &Bearing, estimate: &Estimate) -> Lines {
    let line = &entry.line;
    let mut out = Lines::titled(&entry.designation);
    let [bore, outside] = [line.bore, line.outside_diameter].map(|size| rounded(1e3 * size, 6));
    let width = line.width.map(|width| format!(" × {}", 1e3 * width));
    let width = width.unwrap_or_default();
    out.line("size", format!("{bore} × {outside}{width} mm"));
    add_estimate(&mut out, line, estimate);
    if let Ok(limit) = bearing.fatigue_load_limit() {
        let text = format!("{limit:.0} N by the contact pressure of 1500 MPa");
        out.line("fatigue C_u", text);
    }
    if let Some(class) = bearing.clearance_class
        && let Some(range) = class.range(line.bore)
    {
        let [least, most] = range.map(|clearance| rounded(1e6 * clearance, 6));
        let text = format!("{least} to {most} µm (class {})", class.name());
        out.line("clearance", text);
    }
    let pass = bearing.geometry.ball_pass(std::f64::consts::TAU);
    let pass = format!(
        "per revolution: outer race {:.4}, inner race {:.4}, ball spin {:.4}, cage {:.4}",
        pass.outer, pass.inner, pass.spin, pass.cage
    );
    out.line("ball pass", pass);
    let maker = match entry.maker.as_str() {
        "" => "",
        _ => "another maker's bearing of this name may differ inside",
    };
    out.line("source", &entry.source);
    out.line("note", maker);
    out
}

fn add_estimate(out: &mut Lines, line: &CatalogueLine, estimate: &Estimate) {
    let ratings = [
        Some(format!("C {:.0} N", line.dynamic_rating)),
        line.static_rating.map(|rating| format!("C0 {rating:.0} N")),
        line.static_factor.map(|factor| format!("f0 {factor}")),
    ];
    let ratings: Vec<_> = ratings.into_iter().flatten().collect();
    out.line("printed", ratings.join(", "));
    let mark =
        |names: &[&str]| mark_estimated(estimate.estimated.iter().any(|name| names.contains(name)));
    let found = &estimate.internal;
    let balls = format!(
        "{} of {:.3} mm{}",
        found.balls,
        1e3 * found.ball_diameter,
        mark(&["balls", "ball_diameter"])
    );
    out.line("balls", balls);
    let pitch = rounded(1e3 * found.pitch_diameter, 6);
    out.line("pitch", format!("{pitch} mm{}", mark(&["pitch_diameter"])));
    let angle = rounded(found.contact_angle.to_degrees(), 6);
    out.line("contact angle", format!("{angle}°"));
    let (inner, outer) = (found.groove_factor_inner, found.groove_factor_outer);
    let mark = mark(&["groove_factor_inner"]);
    out.line(
        "groove factor",
        format!("inner {inner:.4}, outer {outer:.4}{mark}"),
    );
    let off = |found: f64, printed: f64| format!("{:+.1} %", 1e2 * (found / printed - 1.0));
    let statical = line
        .static_rating
        .map(|printed| off(found.static_rating, printed));
    let factor = estimate
        .static_factor
        .map(|factor| format!(", f0 {factor:.2}"));
    let ratings = format!(
        "C {:.0} N ({}) by ISO 281, C0 {:.0} N{} by ISO 76{}",
        found.dynamic_rating,
        off(found.dynamic_rating, line.dynamic_rating),
        found.static_rating,
        statical.map_or(String::new(), |off| format!(" ({off})")),
        factor.unwrap_or_default()
    );
    out.line("these have", ratings);
    out.line("filling angle", format!("{:.0}°", estimate.filling_angle));
    out.each("next best", estimate.runner_up);
    out.each("note", &estimate.notes);
}

/// An entry of the catalogue as JSON.
pub fn entry_json(entry: &CatalogueEntry, bearing: &Bearing, estimate: &Estimate) -> Value {
    let line = &entry.line;
    let millimetres = |length: f64| rounded(1e3 * length, 6);
    let angle = rounded(line.contact_angle.to_degrees(), 6);
    json!({
        "designation": entry.designation,
        "maker": entry.maker,
        "balls": estimate.internal.balls,
        "ball_diameter_mm": millimetres(estimate.internal.ball_diameter),
        "pitch_diameter_mm": millimetres(estimate.internal.pitch_diameter),
        "contact_angle_deg": (angle > 0.0).then_some(angle),
        "groove_factor_inner": estimate.internal.groove_factor_inner,
        "groove_factor_outer": estimate.internal.groove_factor_outer,
        "bore_mm": millimetres(line.bore),
        "outside_diameter_mm": millimetres(line.outside_diameter),
        "width_mm": line.width.map(millimetres),
        "dynamic_rating_N": line.dynamic_rating,
        "static_rating_N": line.static_rating,
        "fatigue_load_limit_N": bearing.fatigue_load_limit().ok(),
        "estimate": estimate,
        "source": entry.source,
    })
}
