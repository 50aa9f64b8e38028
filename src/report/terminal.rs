//! What a verb tells the terminal: named lines and tables of at most 100 columns.

use std::fmt::Display;
use std::path::PathBuf;

use comfy_table::{CellAlignment, Table, presets};
use serde::{Serialize, Serializer};

pub(super) use super::digits::{decimal, digits, in_digits, significant, without_negative_zeros};
use crate::bearing::Clearance;
use crate::keys::AXES;
use crate::physics::PER_MINUTE;
use crate::rotor::FREEDOMS;
use crate::table::{Column, ColumnKind, Table as NumberTable};

/// Most characters of a line.
const WIDTH: usize = 100;

/// Breaks a text between words so that no line has more than 100 characters; lines after the first
/// begin with `indent` blanks. A word that is longer has a line of its own.
pub fn wrapped(text: &str, indent: usize) -> String {
    let mut out = String::new();
    let mut column = 0;
    for word in text.split_inclusive(' ') {
        let width = word.trim_end().chars().count();
        if column > indent && column + width > WIDTH {
            out.truncate(out.trim_end().len());
            out.push('\n');
            out.extend(std::iter::repeat_n(' ', indent));
            column = indent;
        }
        out.push_str(word);
        column += word.chars().count();
    }
    out
}

/// Where the text of a named line begins.
const INDENT: usize = 16;

/// Lines for people, one below the other.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lines {
    title: String,
    parts: Vec<LinePart>,
}

/// A part of what people are told, as a page shows it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum LinePart {
    /// A line of its own.
    Text(String),
    /// A text behind its name, which is empty where it continues the line before.
    Line(String, String),
    /// A line on how the answer was computed.
    Detail(String, String),
    /// A table: its heads and its rows.
    Table(
        #[serde(serialize_with = "in_one_line")] Vec<String>,
        Vec<Vec<String>>,
    ),
}

/// Heads without their breaks.
fn in_one_line<S: Serializer>(heads: &[String], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(heads.iter().map(|head| head.trim().replace('\n', " ")))
}

impl Lines {
    /// A title above the lines that follow.
    pub fn titled(title: &str) -> Self {
        let title = format!("{title}\n");
        let parts = Vec::new();
        Self { title, parts }
    }

    /// What was put below the title, part by part, without the details.
    pub(super) fn parts(&self) -> impl Iterator<Item = &LinePart> {
        let parts = self.parts.iter();
        parts.filter(|part| !matches!(part, LinePart::Detail(..)))
    }

    /// A line of its own.
    pub fn put(&mut self, text: impl Display) {
        let text = without_negative_zeros(&text.to_string());
        self.parts.push(LinePart::Text(text));
    }

    /// A line behind its name, broken where it is too long; none where there is nothing to say.
    pub fn line(&mut self, name: &str, text: impl Display) {
        self.named(name, &text, LinePart::Line);
    }

    /// A line on how the answer was computed: methods, steps, evaluations.
    pub fn detail(&mut self, name: &str, text: impl Display) {
        self.named(name, &text, LinePart::Detail);
    }

    fn named(&mut self, name: &str, text: &dyn Display, part: fn(String, String) -> LinePart) {
        let text = without_negative_zeros(&text.to_string());
        if !text.is_empty() {
            self.parts.push(part(name.to_owned(), text));
        }
    }

    /// A line for each of some texts behind the same name, none where there are none.
    pub fn each(&mut self, name: &str, texts: impl IntoIterator<Item = impl Display>) {
        texts.into_iter().for_each(|text| self.line(name, text));
    }

    /// More of the line before.
    pub fn more(&mut self, text: impl Display) {
        self.line("", text);
    }

    /// A table between blank lines.
    pub fn table<'a>(
        &mut self,
        header: impl IntoIterator<Item = &'a str>,
        rows: impl IntoIterator<Item = Vec<String>>,
    ) {
        let positive = |row: Vec<String>| {
            row.iter()
                .map(|cell| without_negative_zeros(cell))
                .collect()
        };
        let header = header.into_iter().map(str::to_owned).collect();
        let rows = rows.into_iter().map(positive).collect();
        self.parts.push(LinePart::Table(header, rows));
    }

    /// Some columns of a table by their quantities, each below a head, in the units that they are shown in, with so many digits;
    /// those that say nothing but zero are left out.
    pub fn show(&mut self, table: &NumberTable<'_>, shown: &[(&str, &str)], count: usize) {
        let columns = shown.iter().filter_map(|(head, quantity)| {
            let (column, values) = table.column(quantity)?;
            let ((_, unit), factor) = shown_column(column);
            let cell = |value: &f64| match &column.kind {
                ColumnKind::Word(_) => column.kind.word(*value).to_owned(),
                _ if value.is_nan() => String::new(),
                ColumnKind::Count => value.to_string(),
                _ => in_digits(factor * value, count),
            };
            let cells: Vec<_> = values.iter().map(cell).collect();
            let has_value = cells.iter().any(|cell| !matches!(cell.as_str(), "" | "0"));
            has_value.then(|| (format!("{head}\n{unit}"), cells))
        });
        let (heads, columns): (Vec<_>, Vec<_>) = columns.unzip();
        let length = columns.first().map_or(0, Vec::len);
        let reported = |cell: &String| match cell.as_str() {
            "" => "–".to_owned(),
            cell => cell.to_owned(),
        };
        let rows =
            (0..length).map(|row| columns.iter().map(|cells| reported(&cells[row])).collect());
        self.table(heads.iter().map(String::as_str), rows);
    }

    /// All as one text, with or without the details.
    pub fn text(&self, details: bool) -> String {
        let mut out = self.title.clone();
        for part in &self.parts {
            match part {
                LinePart::Detail(..) if !details => {}
                LinePart::Text(text) => out += &format!("{text}\n"),
                LinePart::Line(name, text) | LinePart::Detail(name, text) => {
                    out += &wrapped(&format!("  {name:<13} {text}"), INDENT);
                    out.push('\n');
                }
                LinePart::Table(header, rows) => {
                    let header = header.iter().map(String::as_str);
                    out += &format!("\n{}\n\n", table(header, rows.iter().cloned()));
                }
            }
        }
        out
    }
}

/// The files that were written, in one line: their folder, then their names.
pub fn wrote(files: &[PathBuf]) -> String {
    let Some(folder) = files.first().and_then(|file| file.parent()) else {
        return String::new();
    };
    let inside = |file: &PathBuf| {
        let name = file.strip_prefix(folder).unwrap_or(file);
        name.display().to_string()
    };
    let names: Vec<_> = files.iter().map(inside).collect();
    let mut out = Lines::default();
    let folder = folder.join("");
    out.line(
        "wrote",
        format!("{} {}", folder.display(), names.join(", ")),
    );
    out.text(false)
}

/// A table without rules, everything but its first column to the right.
fn table<'a>(
    header: impl IntoIterator<Item = &'a str>,
    rows: impl IntoIterator<Item = Vec<String>>,
) -> String {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_header(header);
    for row in rows {
        table.add_row(row);
    }
    for (index, column) in table.column_iter_mut().enumerate() {
        if index == 0 {
            column.set_padding((1, 0));
        } else {
            column.set_padding((2, 0));
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table.trim_fmt()
}

/// Parts of a line, with commas between them.
pub(super) fn listed(parts: impl IntoIterator<Item = String>) -> String {
    parts.into_iter().collect::<Vec<_>>().join(", ")
}

/// A value, or a dash where there is none.
pub(super) fn or_dash(value: Option<String>) -> String {
    value.unwrap_or_else(|| "–".to_owned())
}

/// `bearing 2: ` before what is said of a bearing; one alone needs no number.
pub(super) fn of_bearing(index: usize, count: usize) -> String {
    match count {
        1 => String::new(),
        _ => format!("bearing {}: ", index + 1),
    }
}

/// A mark behind what is estimated.
pub(super) fn mark_estimated(estimated: bool) -> &'static str {
    if estimated { " (estimated)" } else { "" }
}

/// A value with at most some decimals.
pub(super) fn rounded(value: f64, decimals: i32) -> f64 {
    let scale = 10f64.powi(decimals);
    (scale * value).round() / scale
}

/// Names of the freedoms.
pub(super) const NAMES: [&str; FREEDOMS] = ["x", "y", "z", "θx", "θy"];

/// `x 0.1 µm, y −3.2 µm, …` of some freedoms.
pub(super) fn displacement_text(axes: &[usize], displacement: &[f64; FREEDOMS]) -> String {
    let unit = |axis| if axis < 3 { "µm" } else { "µrad" };
    let named = axes.iter().map(|&axis| {
        let value = decimal(MICRO * displacement[axis]);
        format!("{} {value} {}", NAMES[axis], unit(axis))
    });
    listed(named)
}

/// `12.5000 µm diametral, the middle of class CN`.
pub(super) fn clearance_text(clearance: &Clearance) -> String {
    let size = decimal(MICRO * clearance.diametral);
    match clearance.class {
        Some(class) => format!(
            "{size} µm diametral, from the middle of class {}",
            class.name()
        ),
        None => format!("{size} µm diametral"),
    }
}

/// A measured error, in m and of the motion, beside the tolerances of the motion and of its reference.
pub(super) fn measured_text(
    [displacement, relative]: [f64; 2],
    [tolerance, reference]: [f64; 2],
) -> String {
    format!(
        "{:.2e} µm, {relative:.1e} of the motion (tolerance {}, measured against {})",
        MICRO * displacement,
        digits(tolerance),
        digits(reference)
    )
}

/// The unit that values are shown in, and how many of it make one of theirs.
pub(super) fn shown_unit(unit: &str) -> (String, f64) {
    match unit {
        "m" => ("µm".to_owned(), MICRO),
        "rad" => ("µrad".to_owned(), MICRO),
        "Pa" => ("MPa".to_owned(), 1.0 / MICRO),
        "N/m" => ("N/µm".to_owned(), 1.0 / MICRO),
        "N m/rad" => ("N m/mrad".to_owned(), 1.0 / MILLI),
        _ => (unit.replace("^2", "²"), 1.0),
    }
}

/// Words of angles that are small rotations of a shaft or a housing; every other angle is shown in degrees.
const ROTATIONS: [&str; 2] = ["tilt", "twist"];

/// What a column is called in figures, with the unit that it is drawn in, and how many of that make one of its own:
/// `θx`, `force x`, `amplitude of x`, `x, order 1`.
pub(super) fn shown_column(column: &Column) -> ((String, String), f64) {
    let quantity = shown_quantity(&column.quantity);
    let mut words = column.quantity.split('_');
    let is_rotation =
        column.kind != ColumnKind::Phase && words.any(|word| ROTATIONS.contains(&word));
    let (unit, factor) = match (&*column.quantity, &*column.unit) {
        ("speed", "rad/s") => ("1/min".to_owned(), PER_MINUTE),
        (_, "rad") if !is_rotation => ("deg".to_owned(), 1f64.to_degrees()),
        (_, unit) => shown_unit(unit),
    };
    let name = match column.kind {
        ColumnKind::Phase => format!("phase of {quantity}"),
        ColumnKind::Measure("amplitude") => format!("amplitude of {quantity}"),
        ColumnKind::Measure("rms") => format!("{quantity}, RMS"),
        ColumnKind::Measure(what) => format!("{quantity}, {}", what.replace('_', " ")),
        _ => quantity,
    };
    ((name, unit), factor)
}

/// What a quantity is called in figures: `θx`, `force x`, `frequency`.
pub(super) fn shown_quantity(quantity: &str) -> String {
    let freedom = AXES.iter().position(|axis| *axis == quantity);
    match (freedom, quantity) {
        (Some(freedom), _) => NAMES[freedom].to_owned(),
        (_, "t") => "time".to_owned(),
        (_, "f") => "frequency".to_owned(),
        _ => quantity.replace('_', " "),
    }
}

/// m → µm, rad → µrad.
pub(super) const MICRO: f64 = 1e6;

/// s → ms, rad → mrad, m/s → mm/s, N m → N mm.
pub(super) const MILLI: f64 = 1e3;

/// rad/s → Hz.
pub(super) const PER_SECOND: f64 = 0.5 / std::f64::consts::PI;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rounds_to_zero_has_no_minus_sign() {
        let text = "-0.0000, -0 N; (-0.0) -0.0e0 |-0.00| x -0.";
        assert_eq!(
            without_negative_zeros(text),
            "0.0000, 0 N; (0.0) 0.0e0 |0.00| x 0."
        );
        for kept in [
            "-0.5",
            "1e-0",
            "2-0",
            "-0x",
            "a -0.001 b",
            "- 0",
            "6205-0.toml",
            "-0.toml",
            "−",
            "-1.0e-3",
        ] {
            assert_eq!(without_negative_zeros(kept), kept);
        }
        let mut out = Lines::default();
        out.table(["a"], [vec![format!("{:.4}", -1e-9)]]);
        out.line("b", format!("{:.1}", -0.01));
        let text = out.text(false);
        assert!(!text.contains('-'), "{text}");
    }

    #[test]
    fn angles_are_shown_in_degrees_and_tilts_in_microradians() {
        let unit = |column: Column| shown_column(&column).0.1;
        for column in [
            Column::phase("x"),
            Column::phase("tilt_x"),
            Column::number("phase", "rad"),
            Column::number("shoulder_margin", "rad"),
            Column::number("bearing_1_largest_angle_inner", "rad"),
        ] {
            assert_eq!(unit(column.clone()), "deg", "{column:?}");
        }
        for column in [
            Column::number("twist", "rad"),
            Column::measure("tilt_x", "rms", "rad"),
            Column::number("housing1_tilt_y", "rad"),
        ] {
            assert_eq!(unit(column.clone()), "µrad", "{column:?}");
        }
    }

    #[test]
    fn lines_are_short_and_indented() {
        let text = format!("natural {}", ["540.29 Hz"; 12].join(", "));
        let lines = wrapped(&text, 8);
        assert!(lines.lines().all(|line| line.chars().count() <= 100));
        assert!(
            lines
                .lines()
                .skip(1)
                .all(|line| line.starts_with("        540.29 Hz"))
        );
    }
}
