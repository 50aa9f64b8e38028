//! Columns of words, as of how a run of a study came to its value: equal or not, row by row.

use super::table::Source;
use super::{CompareError, Difference};
use crate::numerics::distinct::each_once;

/// A column whose first cell with anything in it is no number.
pub(super) struct Words {
    /// Name of the column.
    pub name: String,
    /// Line of the first word, from 1.
    pub line: u64,
    /// What each row has; nothing where it is empty.
    pub cells: Vec<String>,
}

/// Refuses words in a column of one table that has numbers in the other.
///
/// # Errors
/// [`CompareError::Number`] names the first word.
pub(super) fn check_words([first, second]: &[Source<'_>; 2]) -> Result<(), CompareError> {
    for (own, other) in [(first, second), (second, first)] {
        let are_numbers = |words: &&Words| {
            let numbers = other.columns().find(|column| column.name() == words.name);
            let values = numbers.and_then(|column| other.values(column));
            values.is_some_and(|values| values.iter().any(|value| !value.is_nan()))
        };
        if let Some(words) = own.words.iter().find(are_numbers) {
            let text = words.cells.iter().find(|cell| !cell.is_empty());
            return Err(CompareError::Number {
                path: own.path.clone(),
                line: words.line,
                column: words.name.clone(),
                text: text.cloned().unwrap_or_default(),
            });
        }
    }
    Ok(())
}

/// Where the words of columns that both tables have differ, of each table in the first of every so many of its rows.
pub(super) fn different_words(
    tables: &[Source<'_>; 2],
    [own, other]: [usize; 2],
) -> Vec<Difference> {
    let words = tables.iter().flat_map(|table| &table.words);
    let names = each_once(words.map(|words| &*words.name)).into_iter();
    let names = names.filter(|name| tables.iter().all(|table| table.knows(name)));
    let [first, second] = tables.each_ref().map(|table| table.axis().1.len());
    let rows = first.div_ceil(own).min(second.div_ceil(other));
    let differences = names.filter_map(|name| {
        let words = |row: usize| {
            [
                tables[0].word(name, row * own),
                tables[1].word(name, row * other),
            ]
        };
        let mut differing = (0..rows).filter(|row| words(*row)[0] != words(*row)[1]);
        let row = differing.next()?;
        let ([a, b], rest) = (words(row), differing.count());
        let rows = match rest {
            0 => "1 row".to_owned(),
            _ => format!("{} rows", rest + 1),
        };
        Some(Difference::new(format!(
            "the words of {name} differ in {rows}, first in row {}: {a:?} and {b:?}",
            row + 1
        )))
    });
    differences.collect()
}
