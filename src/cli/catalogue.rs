//! `jeffcott catalogue`.

use std::io;

use comfy_table::{Table, presets};
use serde_json::{Value, json};

use super::{Outcome, terminal};
use crate::bearing::catalogue::{CATALOGUE, CatalogueEntry};
use crate::report::wrapped;

/// Lists the bearings that a scenario can name, with the source of every number.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  jeffcott catalogue --json")]
pub struct Arguments {
    /// Print the list as JSON
    #[arg(long)]
    json: bool,
}

/// Prints the catalogue.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let text = if arguments.json {
        let entries = CATALOGUE.iter().map(record).collect();
        format!("{:#}\n", Value::Array(entries))
    } else {
        format!("{}\n\nSources\n{}", table().trim_fmt(), sources())
    };
    terminal::print(&text)?;
    Ok(Outcome::Done)
}

fn table() -> Table {
    let mut table = Table::new();
    table.load_style(presets::UTF8_HORIZONTAL_ONLY).set_header([
        "name",
        "balls",
        "ball\nmm",
        "pitch\nmm",
        "angle\ndeg",
        "groove factor\ninner, outer",
        "bore × outside × width\nmm",
        "C\nN",
    ]);
    for entry in CATALOGUE {
        let [bore, outside, width] = entry.boundary_mm;
        let angle = entry.contact_angle_deg.map(|angle| angle.to_string());
        table.add_row([
            entry.designation.to_owned(),
            entry.balls.to_string(),
            entry.ball_diameter_mm.to_string(),
            entry.pitch_diameter_mm.to_string(),
            angle.unwrap_or_else(|| "–".to_owned()),
            format!(
                "{}, {}",
                entry.groove_factor_inner, entry.groove_factor_outer
            ),
            format!("{bore} × {outside} × {width}"),
            entry.dynamic_rating.to_string(),
        ]);
    }
    table
}

fn sources() -> String {
    let line = |entry: &CatalogueEntry| {
        let line = format!("  {}: {}", entry.designation, entry.source);
        wrapped(&line, 4) + "\n"
    };
    CATALOGUE.iter().map(line).collect()
}

fn record(entry: &CatalogueEntry) -> Value {
    json!({
        "designation": entry.designation,
        "balls": entry.balls,
        "ball_diameter_mm": entry.ball_diameter_mm,
        "pitch_diameter_mm": entry.pitch_diameter_mm,
        "contact_angle_deg": entry.contact_angle_deg,
        "groove_factor_inner": entry.groove_factor_inner,
        "groove_factor_outer": entry.groove_factor_outer,
        "bore_mm": entry.boundary_mm[0],
        "outside_diameter_mm": entry.boundary_mm[1],
        "width_mm": entry.boundary_mm[2],
        "dynamic_rating_N": entry.dynamic_rating,
        "source": entry.source,
    })
}
