//! The few lines that a person reads about steady motions.

use std::f64::consts::TAU;
use std::path::PathBuf;

use nalgebra::Complex;

use super::super::study::shown;
use super::super::terminal::{Lines, digits, listed, measured_text};
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
    let mut out = Lines::titled(title);
    for base in &steady.bases {
        out.line("forcing", forcing(base));
    }
    out.line("motion", motion(steady));
    out.line("multipliers", multipliers(&steady.multipliers));
    out.line("stability", stability(steady));
    out.line("search", search(steady));
    if let Some(error) = &steady.measured {
        let sizes = [error.displacement, error.relative];
        let tolerances = [model.integrator.tolerance, error.reference_tolerance];
        out.line("error", measured_text(sizes, tolerances));
    }
    put_swings(&mut out, steady);
    put_lines(&mut out, steady, model.rotor.speed);
    out.wrote(files)
}

/// Branches, where they turn and where their motions change their kind, and the files written.
pub fn response_text(
    title: &str,
    variable: &Variable,
    branches: &[Response],
    files: &[PathBuf],
) -> String {
    let mut out = Lines::titled(title);
    for (number, branch) in branches.iter().enumerate() {
        let stable = branch.points.iter().filter(|point| point.stable).count();
        let text = format!(
            "{} × the period, {} motions, {stable} of them stable; {}",
            branch.multiple,
            branch.points.len(),
            branch.end
        );
        out.line(&format!("branch {}", number + 1), text);
        for special in &branch.specials {
            let multiplier = special.point.multipliers.first();
            let size = multiplier.map_or(f64::NAN, |value| value.norm());
            let text = format!(
                "{} at {}, largest multiplier {size:.6}",
                special.kind,
                shown(variable, special.point.value)
            );
            out.more(text);
        }
        for unrefined in &branch.unrefined {
            let [from, to] = unrefined.between.map(|value| shown(variable, value));
            let text = format!(
                "{} between {from} and {to}, not found any nearer: a jump, {:.1e} are left",
                unrefined.kind, unrefined.left
            );
            out.more(text);
        }
    }
    out.wrote(files)
}

fn forcing(base: &Base) -> String {
    let parts = base.parts.iter().map(|(cause, multiple)| match multiple {
        1 => cause.to_string(),
        many => format!("{many} × for {cause}"),
    });
    format!("{:.6} Hz: {}", base.frequency / TAU, listed(parts))
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
    match multipliers {
        Multipliers::Periodic(all) => {
            let upper = all.iter().filter(|value| value.im >= 0.0);
            let text = |value: &Complex<f64>| match value.im {
                0.0 => format!("{:.6}", value.re),
                im => format!("{:.6} ± {im:.6} i", value.re),
            };
            listed(upper.take(MULTIPLIERS).map(text))
        }
        Multipliers::Torus(all) => {
            let some = all.iter().take(MULTIPLIERS);
            listed(some.map(|size| format!("|{size:.6}|")))
        }
    }
}

fn stability(steady: &Steady) -> String {
    if let Some(kind) = steady.instability {
        return format!("not stable: {kind}");
    }
    let single = steady.single_period.as_ref();
    match single.filter(|single| !single.is_stable()) {
        None => "stable".to_owned(),
        Some(single) => format!(
            "stable; the motion of a single period is not: largest multiplier {:.6}",
            single.largest()
        ),
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

fn put_swings(out: &mut Lines, steady: &Steady) {
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
    out.table(header, rows);
}

/// The strongest lines of the displacements that are lengths.
fn put_lines(out: &mut Lines, steady: &Steady, speed: f64) {
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
    out.table(["line", "Hz", "order", "µm", "multiples"], rows);
}
