//! The list of the bearings of the catalogue.

pub(super) mod balls;
pub(super) mod rollers;

use crate::bearing::Estimate;
use crate::bearing::catalogue::CatalogueEntry;
use crate::report::terminal::{Lines, or_dash, rounded};

/// A row a bearing, and the sources of their numbers.
pub fn catalogue_text<'a>(
    bearings: impl Iterator<Item = (&'a CatalogueEntry, &'a Estimate)> + Clone,
) -> Lines {
    let header = [
        "name",
        "balls",
        "ball\nmm",
        "pitch\nmm",
        "angle\ndeg",
        "grooves\nin, out",
        "bore × outside\nmm",
        "C\nN",
        "C0\nN",
        "inside",
    ];
    let length = |length: f64| rounded(1e3 * length, 3).to_string();
    let rows = bearings.clone().map(|(entry, estimate)| {
        let (line, inside) = (&entry.line, &estimate.internal);
        let angle = line.contact_angle.to_degrees().round();
        let [inner, outer] = [inside.groove_factor_inner, inside.groove_factor_outer];
        let origin = match estimate.is_estimated() {
            true => "estimated",
            false => "given",
        };
        vec![
            entry.designation.clone(),
            inside.balls.to_string(),
            length(inside.ball_diameter),
            length(inside.pitch_diameter),
            or_dash((angle > 0.0).then(|| angle.to_string())),
            format!("{inner}, {outer}"),
            format!("{} × {}", length(line.bore), length(line.outside_diameter)),
            line.dynamic_rating.to_string(),
            or_dash(line.static_rating.map(|rating| rating.to_string())),
            origin.to_owned(),
        ]
    });
    let mut out = Lines::titled("Catalogue");
    out.table(header, rows);
    let mut sources: Vec<(&str, Vec<&str>)> = Vec::new();
    for (entry, _) in bearings {
        let mut known = sources.iter_mut();
        match known.find(|(source, _)| *source == entry.source) {
            Some((_, names)) => names.push(&entry.designation),
            None => sources.push((&entry.source, vec![&entry.designation])),
        }
    }
    out.put("Sources");
    for (source, names) in sources {
        let names = match names[..] {
            [first, .., last] if names.len() > 2 => format!("{first} … {last}"),
            _ => names.join(", "),
        };
        out.line(&names, source);
    }
    out
}
