//! The few lines that a person reads about steady motions.

use std::f64::consts::TAU;
use std::fmt::Write;
use std::path::PathBuf;

use comfy_table::Table;

use super::super::statics::{digits, table};
use super::super::study::shown;
use crate::report::units::MICRO;
use crate::shooting::Multipliers;
use crate::simulate::Model;
use crate::steady::{Base, Response, Steady, SteadyLine};
use crate::study::Variable;

/// Lines and multipliers shown.
const LINES: usize = 8;
const MULTIPLIERS: usize = 4;

/// Period, stability and the strongest lines of a steady motion, and the files written.
pub fn steady_text(title: &str, model: &Model, steady: &Steady, files: &[PathBuf]) -> String {
    let mut out = format!("{title}\n");
    for base in &steady.bases {
        line(&mut out, "forcing", &forcing(base));
    }
    line(&mut out, "motion", &motion(steady));
    line(&mut out, "multipliers", &multipliers(&steady.multipliers));
    line(&mut out, "stability", &stability(steady));
    line(&mut out, "search", &search(steady));
    if let Some(error) = &steady.measured {
        let text = format!(
            "{:.2e} µm, {:.1e} of the motion (tolerance {:e}, measured against {:e})",
            MICRO * error.displacement,
            error.relative,
            model.integrator.tolerance,
            error.reference_tolerance
        );
        line(&mut out, "error", &text);
    }
    block(&mut out, &swing_table(steady));
    block(&mut out, &line_table(steady, model.rotor.speed));
    wrote(&mut out, files);
    out
}

/// Branches, where they turn and where their motions change their kind, and the files written.
pub fn response_text(
    title: &str,
    variable: &Variable,
    branches: &[Response],
    files: &[PathBuf],
) -> String {
    let mut out = format!("{title}\n");
    for (number, branch) in branches.iter().enumerate() {
        let stable = branch.points.iter().filter(|point| point.stable).count();
        let text = format!(
            "{} × the period, {} motions, {stable} of them stable; {}",
            branch.multiple,
            branch.points.len(),
            branch.end
        );
        line(&mut out, &format!("branch {}", number + 1), &text);
        for special in &branch.specials {
            let multiplier = special.point.multipliers.first();
            let size = multiplier.map_or(f64::NAN, |value| value.norm());
            let text = format!(
                "{} at {}, largest multiplier {size:.6}",
                special.kind,
                shown(variable, special.point.value)
            );
            line(&mut out, "", &text);
        }
        for unrefined in &branch.unrefined {
            let [from, to] = unrefined.between.map(|value| shown(variable, value));
            let text = format!(
                "{} between {from} and {to}, not found any nearer: a jump, {:.1e} are left",
                unrefined.kind, unrefined.left
            );
            line(&mut out, "", &text);
        }
    }
    wrote(&mut out, files);
    out
}

fn line(out: &mut String, name: &str, text: &str) {
    if !text.is_empty() {
        writeln!(out, "  {name:<13} {text}").expect("a String takes everything");
    }
}

fn block(out: &mut String, table: &Table) {
    writeln!(out, "\n{}\n", table.trim_fmt()).expect("a String takes everything");
}

fn wrote(out: &mut String, files: &[PathBuf]) {
    for file in files {
        line(out, "wrote", &file.display().to_string());
    }
}

fn forcing(base: &Base) -> String {
    let parts = base.parts.iter().map(|(cause, multiple)| match multiple {
        1 => cause.to_string(),
        many => format!("{many} × for {cause}"),
    });
    let parts: Vec<_> = parts.collect();
    format!("{:.6} Hz: {}", base.frequency / TAU, parts.join(", "))
}

fn motion(steady: &Steady) -> String {
    if steady.is_torus() {
        return format!(
            "two frequencies without a common period; {} harmonics of the second",
            steady.harmonics
        );
    }
    let period = digits(1e3 * steady.period);
    match steady.multiple {
        1 => format!("repeats every {period} ms, with the forcing"),
        many => format!("repeats every {period} ms, {many} periods of the forcing"),
    }
}

fn multipliers(multipliers: &Multipliers) -> String {
    let shown: Vec<String> = match multipliers {
        Multipliers::Periodic(all) => all
            .iter()
            .filter(|value| value.im >= 0.0)
            .take(MULTIPLIERS)
            .map(|value| match value.im {
                0.0 => format!("{:.6}", value.re),
                im => format!("{:.6} ± {im:.6} i", value.re),
            })
            .collect(),
        Multipliers::Torus(all) => {
            let some = all.iter().take(MULTIPLIERS);
            some.map(|size| format!("|{size:.6}|")).collect()
        }
    };
    shown.join(", ")
}

fn stability(steady: &Steady) -> String {
    match steady.instability {
        None => {
            let single = steady
                .single_period
                .as_ref()
                .filter(|single| !single.is_stable());
            let other = single.map_or_else(String::new, |single| {
                format!(
                    "; the motion of a single period is not: largest multiplier {:.6}",
                    single.largest()
                )
            });
            format!("stable{other}")
        }
        Some(kind) => format!("not stable: {kind}"),
    }
}

fn search(steady: &Steady) -> String {
    let waited = match steady.waited {
        0 => "from rest".to_owned(),
        waited => format!("after {waited} periods"),
    };
    format!(
        "{} corrections {waited}, misses its start by {:.1e} of its size, {} evaluations",
        steady.history.len(),
        steady.missing,
        steady.counters.evaluations
    )
}

fn swing_table(steady: &Steady) -> Table {
    let header = ["swing", "mean", "peak to peak", "rms", "unit"];
    let rows = steady.swings.iter().map(|swing| {
        let (scale, unit) = match swing.channel.unit() {
            "m" => (MICRO, "µm"),
            "rad" => (MICRO, "µrad"),
            unit => (1.0, unit),
        };
        let numbers =
            [swing.mean, swing.peak_to_peak, swing.rms].map(|value| digits(scale * value));
        std::iter::once(swing.channel.name().to_owned())
            .chain(numbers)
            .chain([unit.to_owned()])
            .collect()
    });
    table(header.into_iter(), rows)
}

/// The strongest lines of the displacements that are lengths.
fn line_table(steady: &Steady, speed: f64) -> Table {
    let lines = &steady.lines;
    let lengths: Vec<usize> = (0..lines.channels.len())
        .filter(|index| lines.channels[*index].unit() == "m")
        .collect();
    let mut strongest: Vec<(usize, &SteadyLine)> = lines
        .lines
        .iter()
        .filter(|line| line.multiples != [0, 0])
        .flat_map(|line| lengths.iter().map(move |index| (*index, line)))
        .collect();
    strongest.sort_by(|a, b| b.1.amplitude[b.0].total_cmp(&a.1.amplitude[a.0]));
    let rows = strongest.into_iter().take(LINES).map(|(index, line)| {
        let order = if speed > 0.0 {
            format!("{:.4}", line.frequency * TAU / speed)
        } else {
            String::new()
        };
        vec![
            lines.channels[index].name().to_owned(),
            format!("{:.4}", line.frequency),
            order,
            digits(MICRO * line.amplitude[index]),
            format!("{}, {}", line.multiples[0], line.multiples[1]),
        ]
    });
    table(["line", "Hz", "order", "µm", "multiples"].into_iter(), rows)
}
