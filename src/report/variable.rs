//! The number that varies, as the name of a column and of an axis.

use super::figure::Label;
use crate::numerics::digits::to_digits;
use crate::study::Variable;
use crate::table::Column;

/// The column of the variable: `load_1_constant_z_N`.
pub(super) fn variable_column(variable: &Variable) -> Column {
    let column = key_column(&variable.key, &variable.unit);
    match variable.words.is_empty() {
        true => column,
        false => Column::words(column.quantity, variable.words.clone()),
    }
}

fn key_column(key: &str, unit: &str) -> Column {
    let words = key.split(['.', '[', ']']);
    let words: Vec<_> = words.filter(|word| !matches!(*word, "" | "*")).collect();
    Column::number(words.join("_"), unit.to_owned())
}

/// The variable as the name of an axis: `load 1, z in N`, `catalogue of bearing 1 (0: 6205, 1: 6305)`.
pub(super) fn axis_label(variable: &Variable) -> Label {
    let words = (0..).zip(&variable.words);
    let words: Vec<_> = words
        .map(|(place, word): (u32, _)| format!("{place}: {word}"))
        .collect();
    let key = in_words(&variable.key);
    match words.is_empty() {
        true => (key, variable.shown_unit.as_str()).into(),
        false => format!("{key} ({})", words.join(", ")).into(),
    }
}

/// The key of the variable in words: `speed`, `radial clearance of bearing 1`.
pub(super) fn key_in_words(variable: &Variable) -> String {
    in_words(&variable.key)
}

fn in_words(key: &str) -> String {
    let (table, rest) = key.split_once('.').unwrap_or((key, "constant"));
    let table = match table.trim_end_matches(']').split_once('[') {
        Some((table, "*")) => format!("every {table}"),
        Some((table, number)) => format!("{table} {number}"),
        None => table.to_owned(),
    };
    let last = rest.rsplit('.').next().unwrap_or(rest).replace('_', " ");
    let words = match (rest, last.as_str()) {
        ("constant", _) => table,
        (_, "x" | "y" | "z" | "tilt x" | "tilt y") => format!("{table}, {last}"),
        _ => format!("{last} of {table}"),
    };
    words.replace('_', " ")
}

/// A value of the variable in the unit that it was written in: `200 N`.
pub(super) fn shown(variable: &Variable, value: f64) -> String {
    if let Some(word) = variable.word(value) {
        return word.to_owned();
    }
    let number = to_digits(variable.shown(value), 6);
    let text = format!("{number} {}", variable.shown_unit);
    text.trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::{in_words, key_column};

    #[test]
    fn a_key_is_told_in_words() {
        let labels = [
            ("speed.constant", "speed"),
            ("load[1].constant.z", "load 1, z"),
            ("shaft.mass", "mass of shaft"),
            (
                "bearing[2].geometry.radial_clearance",
                "radial clearance of bearing 2",
            ),
            ("damping.ratio", "ratio of damping"),
            ("bearing[*].catalogue", "catalogue of every bearing"),
        ];
        for (key, words) in labels {
            assert_eq!(in_words(key), words);
        }
        let column = key_column("bearing[2].clearance_change", "m");
        assert_eq!(column.name(), "bearing_2_clearance_change_m");
    }
}
