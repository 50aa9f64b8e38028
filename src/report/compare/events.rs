//! Compares two tables of events: the n-th of a kind at a ball with the n-th of the other.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::rule::{distance, judgement};
use super::table::bad_csv;
use super::{ColumnComparison, CompareError, Difference, Rules, TableComparison, Tolerance};
use crate::report::EVENT_COLUMNS;

/// Kind of an event, and the bearing and ball that it happens to, as they are written.
type Key = (String, String, String);

/// Times of the events of every kind at every ball, s.
struct Events {
    path: PathBuf,
    times: BTreeMap<Key, Vec<f64>>,
}

/// Times without a partner in the other table.
#[derive(Default)]
struct Alone {
    /// In the first and in the second table.
    count: [usize; 2],
    /// The earliest, with its bearing and ball.
    earliest: Option<(f64, String, String)>,
}

/// Whether a file is a table of events.
pub(super) fn is_events(path: &Path) -> bool {
    let header = csv::Reader::from_path(path);
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
    let events = [Events::read(paths[0])?, Events::read(paths[1])?];
    let scale = events[0].last().max(events[1].last());
    let mut columns: BTreeMap<&str, (ColumnComparison, Alone)> = BTreeMap::new();
    let keys = events.iter().flat_map(|events| events.times.keys());
    let keys: std::collections::BTreeSet<&Key> = keys.collect();
    for key in keys {
        let new = || (ColumnComparison::new(&key.0, rules.worst), Alone::default());
        let (column, alone) = columns.entry(&key.0).or_insert_with(new);
        let tolerance = rules.tolerances.of(&key.0);
        let times = events.each_ref().map(|events| events.of(key));
        let pairs = partners(times, tolerance.allowed(scale), |place, time| {
            alone.take(place, time, key);
        });
        judge(column, &pairs, tolerance, scale);
    }
    let known = EVENT_COLUMNS.iter().copied().chain(columns.keys().copied());
    let known = known.map(str::to_owned).collect();
    let (columns, alone): (Vec<_>, Vec<_>) = columns.into_values().unzip();
    let named = columns.iter().zip(alone);
    let differences = named.filter_map(|(column, alone)| alone.difference(&column.name, &events));
    let differences = differences.collect();
    let found = TableComparison::new(name, columns, known, differences, Vec::new(), rules);
    Ok(found)
}

fn judge(column: &mut ColumnComparison, pairs: &[[f64; 2]], tolerance: Tolerance, scale: f64) {
    for (number, [first, second]) in (1..).zip(pairs) {
        let judgement = judgement(distance(*first, *second), tolerance, scale, 0.0);
        column.take(number, *first, [*first, *second], judgement);
    }
}

/// Times that stand for each other; tells of the others with the table that they stand in.
fn partners(
    [first, second]: [&[f64]; 2],
    allowed: f64,
    mut alone: impl FnMut(usize, f64),
) -> Vec<[f64; 2]> {
    if first.len() == second.len() {
        let pairs = first.iter().zip(second);
        return pairs.map(|(first, second)| [*first, *second]).collect();
    }
    let mut pairs = Vec::new();
    let (mut first, mut second) = (first, second);
    loop {
        match (first.split_first(), second.split_first()) {
            (Some((a, rest)), Some((b, others))) if distance(*a, *b) <= allowed => {
                pairs.push([*a, *b]);
                (first, second) = (rest, others);
            }
            (Some((a, rest)), b) if b.is_none_or(|(b, _)| a <= b) => {
                alone(0, *a);
                first = rest;
            }
            (_, Some((b, others))) => {
                alone(1, *b);
                second = others;
            }
            // a number that is none is never reached by the other
            (Some((a, rest)), None) => {
                alone(0, *a);
                first = rest;
            }
            (None, None) => return pairs,
        }
    }
}

impl Alone {
    fn take(&mut self, place: usize, time: f64, (_, bearing, ball): &Key) {
        self.count[place] += 1;
        if self.earliest.as_ref().is_none_or(|known| time < known.0) {
            self.earliest = Some((time, bearing.clone(), ball.clone()));
        }
    }

    fn difference(self, name: &str, [first, second]: &[Events; 2]) -> Option<Difference> {
        let (time, bearing, ball) = self.earliest?;
        let ball = if ball.is_empty() {
            String::new()
        } else {
            format!(", ball {ball}")
        };
        Some(Difference::Events {
            name: name.to_owned(),
            alone: [
                (first.path.clone(), self.count[0]),
                (second.path.clone(), self.count[1]),
            ],
            earliest: format!("t_s = {time} (bearing {bearing}{ball})"),
        })
    }
}

impl Events {
    fn read(path: &Path) -> Result<Self, CompareError> {
        let bad = |source| bad_csv(path, source);
        let mut csv = csv::ReaderBuilder::new()
            .trim(csv::Trim::All)
            .from_path(path)
            .map_err(bad)?;
        let mut times: BTreeMap<Key, Vec<f64>> = BTreeMap::new();
        for record in csv.records() {
            let record = record.map_err(bad)?;
            let field = |place: usize| record.get(place).unwrap_or_default().to_owned();
            let time = field(0).parse().map_err(|_| CompareError::Number {
                path: path.to_owned(),
                line: record.position().map_or(0, csv::Position::line),
                column: EVENT_COLUMNS[0].to_owned(),
                text: field(0),
            })?;
            let key = (field(1), field(2), field(3));
            times.entry(key).or_default().push(time);
        }
        Ok(Self {
            path: path.to_owned(),
            times,
        })
    }

    fn of(&self, key: &Key) -> &[f64] {
        self.times.get(key).map_or(&[], Vec::as_slice)
    }

    /// Largest magnitude of a time, s.
    fn last(&self) -> f64 {
        let times = self.times.values().flatten();
        times.fold(0.0, |last: f64, time| last.max(time.abs()))
    }
}
