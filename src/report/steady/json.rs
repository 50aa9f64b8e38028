//! Steady motions as JSON.

use std::f64::consts::TAU;

use serde_json::{Value, json};

use crate::integrate::Counters;
use crate::shooting::Multipliers;
use crate::simulate::Model;
use crate::steady::{Base, Measured, Response, ResponsePoint, ResponseUnrefined, Steady, Swing};
use crate::study::Variable;

/// Everything about a steady motion except its trace and its spectrum. The same question gives the same
/// bytes.
pub fn steady_json(title: &str, scenario: &Value, model: &Model, steady: &Steady) -> Value {
    json!({
        "jeffcott": env!("CARGO_PKG_VERSION"),
        "title": title,
        "scenario": scenario,
        "frequencies": steady.bases.iter().map(base).collect::<Value>(),
        "period_s": steady.period,
        "multiple": steady.multiple,
        "harmonics_of_second": steady.harmonics,
        "stable": steady.is_stable(),
        "instability": steady.instability.map(|kind| kind.to_string()),
        "multipliers": multipliers(&steady.multipliers),
        "single_period_multipliers": steady.single_period.as_ref().map(multipliers),
        "residual": steady.missing,
        "residual_history": steady.history,
        "periods_waited": steady.waited,
        "swings": steady.swings.iter().map(swing).collect::<Value>(),
        "lines": steady.lines.lines.len(),
        "samples": steady.trace.len(),
        "counters": counters(&steady.counters),
        "measured_error": steady.measured.map(|error| measured(&error, model)),
        "warnings": steady.warnings,
    })
}

/// The branches of a response: their ends and where they turn; the motions stand in `response.csv`.
pub fn response_json(
    title: &str,
    scenario: &Value,
    variable: &Variable,
    branches: &[Response],
) -> Value {
    let branch = |response: &Response| {
        json!({
            "multiple": response.multiple,
            "points": response.points.len(),
            "end": response.end,
            "lost": response.lost,
            "specials": response
                .specials
                .iter()
                .map(|special| {
                    let mut told = point(&special.point);
                    told["kind"] = special.kind.to_string().into();
                    told["after_points"] = special.after.into();
                    told
                })
                .collect::<Value>(),
            "unrefined": response.unrefined.iter().map(unrefined).collect::<Value>(),
            "counters": counters(&response.counters),
        })
    };
    json!({
        "jeffcott": env!("CARGO_PKG_VERSION"),
        "title": title,
        "scenario": scenario,
        "over": variable.key,
        "unit": variable.unit,
        "branches": branches.iter().map(branch).collect::<Value>(),
    })
}

fn unrefined(unrefined: &ResponseUnrefined) -> Value {
    json!({
        "kind": unrefined.kind.to_string(),
        "after_points": unrefined.after,
        "between": unrefined.between,
        "left": unrefined.left,
    })
}

fn point(point: &ResponsePoint) -> Value {
    let complex = point.multipliers.iter();
    json!({
        "value": point.value,
        "period_s": point.period,
        "stable": point.stable,
        "multipliers": complex.map(|value| json!([value.re, value.im])).collect::<Value>(),
        "swings": point.swings.iter().map(swing).collect::<Value>(),
    })
}

fn base(base: &Base) -> Value {
    let part = |(cause, multiple): &(crate::rotor::ForcingCause, u32)| json!({ "cause": cause.to_string(), "multiple": multiple });
    json!({
        "frequency_Hz": base.frequency / TAU,
        "period_s": base.period(),
        "causes": base.parts.iter().map(part).collect::<Value>(),
    })
}

fn multipliers(multipliers: &Multipliers) -> Value {
    match multipliers {
        Multipliers::Periodic(all) => all
            .iter()
            .map(|value| json!({ "re": value.re, "im": value.im, "magnitude": value.norm() }))
            .collect(),
        Multipliers::Torus(all) => all
            .iter()
            .map(|size| json!({ "magnitude": size }))
            .collect(),
    }
}

fn swing(swing: &Swing) -> Value {
    let unit = swing.channel.column();
    json!({
        "channel": unit,
        "mean": swing.mean,
        "peak_to_peak": swing.peak_to_peak,
        "rms": swing.rms,
    })
}

fn counters(counters: &Counters) -> Value {
    json!({
        "steps": counters.steps,
        "rejected": counters.rejected,
        "evaluations": counters.evaluations,
    })
}

fn measured(error: &Measured, model: &Model) -> Value {
    json!({
        "displacement_m": error.displacement,
        "relative": error.relative,
        "tolerance": model.integrator.tolerance,
        "reference_tolerance": error.reference_tolerance,
    })
}
