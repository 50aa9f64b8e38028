//! What is in a record of sensors.

use std::path::Path;

use serde_json::json;

use crate::record::Record;
use crate::report::{Findings, measured_findings};
use crate::scenario::{MeasuredFile, ScenarioError, describe_record, load_record};

/// What is in a record of sensors.
#[derive(Debug)]
pub struct AnalyzeQuestion {
    file: MeasuredFile,
}

impl AnalyzeQuestion {
    /// Asks about a record, of which a description as JSON says what it does not, or one that a file .toml or .json describes; with
    /// some values in place of those, each as `key=value`.
    ///
    /// # Errors
    /// [`ScenarioError`] with everything that is wrong, also with the record.
    pub fn load(
        path: &Path,
        description: &str,
        settings: &[String],
    ) -> Result<Self, ScenarioError> {
        let file = load_record(path, description, settings)?;
        Ok(Self { file })
    }

    /// Asks about a record, of which a description as JSON and the settings say what its file of this name does not.
    ///
    /// # Errors
    /// [`ScenarioError`] with everything that is wrong.
    pub fn describe(
        record: Record,
        name: &str,
        description: &str,
        settings: &[String],
    ) -> Result<Self, ScenarioError> {
        let file = describe_record(record, name, description, settings)?;
        Ok(Self { file })
    }

    /// Finds out what is in it.
    pub fn answer(self) -> Findings {
        let found = self.file.measurement.analyse();
        measured_findings(&self.file.about, &found)
    }
}

/// An option of `jeffcott analyze` as a key of a description with its value; none of one without a value, or that is none.
pub fn record_setting(option: &str, values: &[String]) -> Option<String> {
    let first = values.first()?;
    let list =
        |entry: fn(&String) -> String| values.iter().map(entry).collect::<Vec<_>>().join(", ");
    Some(match option {
        "rate" | "unit" | "start" | "duration" => format!("record.{option}={}", quoted(first)),
        "scale" => format!("record.scale={first}"),
        "window" => format!("output.window={}", quoted(first)),
        "tacho" => format!("speed.tacho={}", quoted(first)),
        "pulses" => format!("speed.pulses={first}"),
        "speed" if is_number(first) => {
            format!("speed={{ constant = {} }}", quoted(first))
        }
        "speed" => format!("speed={{ channel = {} }}", quoted(first)),
        "channel" => {
            let entry = |name: &String| format!("{{ column = {} }}", quoted(name));
            format!("record.channel=[{}]", list(entry))
        }
        "bearing" => format!("bearing=[{}]", list(|given| bearing(given))),
        _ => return None,
    })
}

/// Whether a text begins as a number does, and is no name of a channel.
fn is_number(text: &str) -> bool {
    let text = text.trim_start();
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    unsigned.starts_with(|sign: char| sign.is_ascii_digit() || sign == '.')
}

fn quoted(text: &str) -> String {
    json!(text.trim()).to_string()
}

/// A designation, or balls, their diameter, pitch diameter and contact angle, as an entry of `[[bearing]]`.
fn bearing(given: &str) -> String {
    let parts: Vec<&str> = given.split(',').collect();
    let [balls, diameter, pitch, angle @ ..] = &parts[..] else {
        return format!("{{ catalogue = {} }}", quoted(given));
    };
    let angle = match angle {
        [] => String::new(),
        angle => format!(", contact_angle = {}", quoted(&angle.join(","))),
    };
    let (balls, diameter, pitch) = (balls.trim(), quoted(diameter), quoted(pitch));
    format!(
        "{{ geometry = {{ balls = {balls}, ball_diameter = {diameter}, pitch_diameter = {pitch}{angle} }} }}"
    )
}
