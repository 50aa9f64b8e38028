//! Branches and critical speeds as a person reads them.

use std::path::PathBuf;

use super::super::terminal::{Lines, or_dash};
use crate::report::units::PER_MINUTE;
use crate::rotor::Mode;
use crate::study::campbell::{Branch, Campbell};

/// A table of branches, one of critical speeds, then the files written.
pub fn campbell_text(title: &str, campbell: &Campbell, files: &[PathBuf]) -> String {
    let mut out = Lines::titled(title);
    put_branches(&mut out, campbell);
    if campbell.critical_speeds.is_empty() {
        out.put("no critical speed in the range\n");
    } else {
        put_critical(&mut out, campbell);
    }
    out.wrote(files)
}

fn put_branches(out: &mut Lines, campbell: &Campbell) {
    let ends = [campbell.speeds.first(), campbell.speeds.last()];
    let at = ends.map(|speed| speed.map_or(0.0, |speed| PER_MINUTE * speed));
    let [first, last] = at.map(|speed| format!("Hz at\n{speed:.0} 1/min"));
    let header = ["branch", "whirl", &first, &last, "damping ratio\nthere"];
    let frequency =
        |mode: Option<&Mode>| or_dash(mode.map(|mode| format!("{:.2}", mode.damped_frequency())));
    let rows = campbell.branches.iter().enumerate().map(|(index, branch)| {
        let last = branch.modes.last().and_then(Option::as_ref);
        vec![
            (index + 1).to_string(),
            branch.whirl().to_string(),
            frequency(branch.modes.first().and_then(Option::as_ref)),
            frequency(last),
            last.map_or_else(String::new, |mode| format!("{:.4}", mode.damping_ratio())),
        ]
    });
    out.table(header, rows);
}

/// An order with up to four decimals.
fn rounded(order: f64) -> String {
    format!("{}", (1e4 * order).round() / 1e4)
}

fn put_critical(out: &mut Lines, campbell: &Campbell) {
    let header = [
        "order",
        "branch",
        "whirl",
        "critical speed\n1/min",
        "rad/s",
        "Hz",
        "damping ratio",
    ];
    let of = |branch: usize| campbell.branches.get(branch).map(Branch::whirl);
    let rows = campbell.critical_speeds.iter().map(|found| {
        let whirl = of(found.branch).unwrap_or(found.whirl);
        vec![
            rounded(found.order),
            (found.branch + 1).to_string(),
            whirl.to_string(),
            format!("{:.1}", PER_MINUTE * found.speed),
            format!("{:.3}", found.speed),
            format!("{:.3}", found.frequency),
            format!("{:.4}", found.damping_ratio),
        ]
    });
    out.table(header, rows);
}
