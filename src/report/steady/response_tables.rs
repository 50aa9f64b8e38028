//! `response.csv`: one row a motion of a branch; `response_specials.csv`: one row a place where it turns
//! or changes its kind.

use super::super::study::column_name;
use super::super::table::Table;
use crate::shooting::SpecialKind;
use crate::steady::{Response, ResponsePoint, Swing};
use crate::study::Variable;

/// A motion, the branch that it is on with its number, and what happens there.
type Row<'a> = (usize, &'a Response, Option<SpecialKind>, &'a ResponsePoint);

/// A column of a displacement or force, and its value.
type Measure = (&'static str, fn(&Swing) -> f64);

/// Every motion of every branch, in their order along it.
pub(super) fn points(variable: &Variable, branches: &[Response]) -> Table {
    let rows = numbered(branches).flat_map(|(number, branch)| {
        let points = branch.points.iter();
        points.map(move |point| (number, branch, None, point))
    });
    table(variable, branches, &rows.collect::<Vec<_>>(), false)
}

/// Where branches turn or their motions change their kind.
pub(super) fn specials(variable: &Variable, branches: &[Response]) -> Table {
    let rows = numbered(branches).flat_map(|(number, branch)| {
        let specials = branch.specials.iter();
        specials.map(move |special| (number, branch, Some(special.kind), &special.point))
    });
    table(variable, branches, &rows.collect::<Vec<_>>(), true)
}

fn numbered(branches: &[Response]) -> impl Iterator<Item = (usize, &Response)> {
    (1..).zip(branches)
}

fn table(variable: &Variable, branches: &[Response], rows: &[Row<'_>], kinds: bool) -> Table {
    let points = || rows.iter().map(|(.., point)| *point);
    let mut table = Table::default();
    table.counts("branch", rows.iter().map(|(number, ..)| *number as f64));
    let multiples = rows
        .iter()
        .map(|(_, branch, ..)| f64::from(branch.multiple));
    table.counts("multiple", multiples);
    if kinds {
        let kinds = rows.iter().filter_map(|(_, _, kind, _)| *kind);
        table.words("kind", kinds);
    }
    table.numbers(column_name(variable), points().map(|point| point.value));
    table.numbers("period_s", points().map(|point| point.period));
    table.counts("stable", points().map(|point| f64::from(point.stable)));
    // every motion has the columns of the first
    let Some(first) = branches.first().and_then(|branch| branch.points.first()) else {
        return table;
    };
    let measures: [Measure; 3] = [
        ("mean", |swing| swing.mean),
        ("peak_to_peak", |swing| swing.peak_to_peak),
        ("rms", |swing| swing.rms),
    ];
    for (index, swing) in first.swings.iter().enumerate() {
        let column = swing.channel.column();
        let (name, unit) = column.split_at(swing.channel.name().len());
        for (what, measure) in measures {
            let values = points().map(|point| point.swings.get(index).map(measure));
            table.numbers(format!("{name}_{what}{unit}"), values);
        }
    }
    for index in 0..first.multipliers.len() {
        let values = || points().map(|point| point.multipliers.get(index));
        let [re, im] = ["re", "im"].map(|part| format!("multiplier_{}_{part}", index + 1));
        table.numbers(re, values().map(|value| Some(value?.re)));
        table.numbers(im, values().map(|value| Some(value?.im)));
    }
    table
}
