//! Which methods of integration were used, and why.

use serde_json::{Value, json};

use crate::integrate::{ChangeReason, Method, MethodUse};
use crate::report::terminal::Lines;
use crate::simulate::{BearingHistory, EventKind, TableUse};

/// A line or more for every bearing that was to have a table.
pub(super) fn add_table_use(out: &mut Lines, tables: &[Option<TableUse>]) {
    for (index, used) in tables.iter().enumerate() {
        let Some(used) = used else { continue };
        let says = match &used.table {
            Ok(report) => format!(
                "{} cells, off by {:.1e} N, {:.1e} of the largest ball load; {} samples outside it, by the exact law",
                report.cells, report.error, report.relative_error, used.samples_outside
            ),
            Err(error) => format!("none, the exact law instead: {error}"),
        };
        out.line("table", format!("bearing {}: {says}", index + 1));
    }
}

/// Why the exponential method began a run, or kept it; `parted` where contacts were lost.
pub(super) fn why_exponential(used: &MethodUse, parted: bool) -> &'static str {
    match (used.change, parted) {
        (Some(_), _) => "every run begins with it",
        (None, false) => "no contact was lost",
        (None, true) => "contacts were lost, but did not keep its steps short",
    }
}

/// Whether a contact of any bearing was lost.
pub(super) fn parted(bearings: &[BearingHistory]) -> bool {
    let lost = |bearing: &BearingHistory| bearing.events(EventKind::ContactLost).count > 0;
    bearings.iter().any(lost)
}

pub(super) fn why_changed(reason: ChangeReason) -> &'static str {
    match reason {
        ChangeReason::Crossings => "contacts are lost again and again, which keeps steps short",
        ChangeReason::NoStep => "exponential can take no further step",
    }
}

/// `exponential: every run begins with it; verner76 from 1.234 ms on: …`
pub(super) fn method_use_text(used: &MethodUse, parted: bool) -> String {
    let mut line = format!("{}: {}", Method::Exponential, why_exponential(used, parted));
    if let Some((reason, time)) = used.change {
        let (latest, why) = (used.latest(), why_changed(reason));
        line.push_str(&format!("; {latest} from {:.3} ms on: {why}", 1e3 * time));
    }
    line
}

/// Which method carried a run, in which balls did or did not part from a race, and why; where another one went on from
/// it, which and why.
pub(super) fn method_use_json(used: &MethodUse, parted: bool) -> Value {
    let change = used.change.map(|(reason, time)| {
        json!({
            "time_s": time,
            "method": used.latest(),
            "why": why_changed(reason),
        })
    });
    json!({
        "method": Method::Exponential,
        "why": why_exponential(used, parted),
        "change": change,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::{TableError, TableReport};

    #[test]
    fn a_table_tells_its_error_and_one_that_is_missing_why() {
        let report = TableReport {
            error: 2e-8,
            relative_error: 1.7e-10,
            cells: 1234,
            evaluations: 9876,
        };
        let of = |table| {
            Some(TableUse {
                table,
                samples_outside: 5,
            })
        };
        let mut out = Lines::default();
        let tables = [of(Ok(report)), None, of(Err(TableError::NoRegion))];
        add_table_use(&mut out, &tables);
        let text = out.text(false);
        let reported = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            reported.contains("bearing 1: 1234 cells, off by 2.0e-8 N, 1.7e-10 of"),
            "{reported}"
        );
        assert!(reported.contains("5 samples outside it"), "{reported}");
        assert!(reported.contains("bearing 3: none"), "{reported}");
        assert!(!reported.contains("bearing 2"), "{reported}");
    }
}
