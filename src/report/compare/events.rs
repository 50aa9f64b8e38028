//! Compares two tables of events: the n-th of a kind at a ball with the n-th of the other.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::rows::distance;
use super::rules::Allowance;
use super::table::{bad_csv, number, reader};
use super::{ColumnComparison, CompareError, Difference, Rules, TableComparison};
use crate::report::EVENT_COLUMNS;

/// Kind of an event, and the bearing and ball that it happens to, as they are written.
type Key = (String, String, String);
/// Times of the events of every kind at every ball, s.
type Events = BTreeMap<Key, Vec<f64>>;

/// Events of a kind without a partner.
#[derive(Default)]
struct Alone<'a> {
    /// In the first and in the second table.
    count: [usize; 2],
    /// The earliest, and what it happens to.
    earliest: Option<(f64, &'a Key)>,
}

/// Whether a file is a table of events.
pub(super) fn is_events(path: &Path) -> bool {
    let header = reader(path);
    header.is_ok_and(|mut csv| {
        let header = csv.headers();
        header.is_ok_and(|header| header.iter().eq(EVENT_COLUMNS))
    })
}

/// Compares the events of two files; `name` is what the result calls them.
///
/// Where a ball has as many events of a kind in both, they are compared in their order; otherwise those
/// within the tolerance of each other are partners, and the others are told of.
pub(super) fn compare_events(
    name: String,
    paths: [&Path; 2],
    rules: &Rules,
) -> Result<TableComparison, CompareError> {
    let events = [read(paths[0])?, read(paths[1])?];
    let times = events.iter().flat_map(BTreeMap::values).flatten();
    let last = times.fold(0.0, |last: f64, time| last.max(time.abs()));
    let keys: BTreeSet<&Key> = events.iter().flat_map(BTreeMap::keys).collect();
    let mut found: BTreeMap<&str, (ColumnComparison, Alone<'_>)> = BTreeMap::new();
    for key in keys {
        let new = || (ColumnComparison::new(&key.0, rules), Alone::default());
        let (column, alone) = found.entry(&key.0).or_insert_with(new);
        let allowance = Allowance {
            tolerance: rules.tolerances.of(&key.0),
            scale: last,
            more: 0.0,
        };
        let times = events.each_ref().map(|events| events.get(key));
        let times = times.map(|times| times.map_or(&[][..], Vec::as_slice));
        let mut number = 0;
        for pair in partners(times, allowance.total()) {
            match pair {
                [Some(first), Some(second)] => {
                    number += 1;
                    let apart = distance(first, second);
                    column.take(number, first, [first, second], apart, allowance);
                }
                [first, second] => alone.take([first, second], key),
            }
        }
    }
    let known = EVENT_COLUMNS.into_iter().chain(found.keys().copied());
    let known = known.map(str::to_owned).collect();
    let (columns, alone): (Vec<_>, Vec<_>) = found.into_values().unzip();
    let differences = alone.iter().filter_map(|alone| alone.difference(paths));
    let differences = differences.collect();
    Ok(TableComparison::new(
        name,
        columns,
        known,
        differences,
        rules,
    ))
}

fn read(path: &Path) -> Result<Events, CompareError> {
    let mut events = Events::new();
    for record in reader(path)?.records() {
        let record = record.map_err(|source| bad_csv(path, source))?;
        let [kind, bearing, ball] =
            [1, 2, 3].map(|place| record.get(place).unwrap_or_default().to_owned());
        let time = number(path, &record, 0, EVENT_COLUMNS[0])?;
        events.entry((kind, bearing, ball)).or_default().push(time);
    }
    Ok(events)
}

/// Times that stand for each other, and those that stand alone, in order.
fn partners([first, second]: [&[f64]; 2], allowed: f64) -> Vec<[Option<f64>; 2]> {
    let all_match = first.len() == second.len();
    let [mut first, mut second] = [first, second].map(|times| times.iter().copied().peekable());
    let mut pairs = Vec::new();
    while first.peek().is_some() || second.peek().is_some() {
        let (take_first, take_second) = match (first.peek(), second.peek()) {
            (Some(a), Some(b)) if all_match || distance(*a, *b) <= allowed => (true, true),
            (Some(a), Some(b)) => (a <= b, a > b || a.is_nan() || b.is_nan()),
            (a, b) => (a.is_some(), b.is_some()),
        };
        pairs.push([
            first.next_if(|_| take_first),
            second.next_if(|_| take_second),
        ]);
    }
    pairs
}

impl<'a> Alone<'a> {
    fn take(&mut self, pair: [Option<f64>; 2], key: &'a Key) {
        for (count, time) in self.count.iter_mut().zip(pair) {
            let Some(time) = time else { continue };
            *count += 1;
            if self.earliest.is_none_or(|(earliest, _)| time < earliest) {
                self.earliest = Some((time, key));
            }
        }
    }

    fn difference(&self, [first, second]: [&Path; 2]) -> Option<Difference> {
        let (time, (kind, bearing, ball)) = self.earliest?;
        let [ones, others] = self.count;
        let ball = match &**ball {
            "" => String::new(),
            ball => format!(", ball {ball}"),
        };
        Some(Difference::new(format!(
            "{kind}: {ones} of {} and {others} of {} have no partner, the earliest at t_s = {time} \
             (bearing {bearing}{ball})",
            first.display(),
            second.display()
        )))
    }
}
