//! Speed against error as JSON.

use serde_json::{Value, json};

use crate::study::accuracy::{Accuracy, Agreement, Cost, Errors, LadderRow, Row, Statistics};

/// Everything that was measured, every number with its unit in its name.
pub fn accuracy_json(title: &str, scenario: &Value, accuracy: &Accuracy) -> Value {
    let duration = accuracy.duration;
    json!({
        "jeffcott": env!("CARGO_PKG_VERSION"),
        "title": title,
        "scenario": scenario,
        "reference": agreement(&accuracy.agreement),
        "methods": accuracy.rows.iter().map(method).collect::<Value>(),
        "ladder": {
            "top": accuracy.ladder.top.map(|top| top.to_string()),
            "meaning": "differences from the top rung after the settle time, relative to the root mean \
                        square of its vibration: of traces the root mean square about the mean; the \
                        mean, by which the shaft vibrates about another place, is that of the \
                        statistics",
            "rungs": accuracy.ladder.rows.iter().map(|row| rung(row, duration)).collect::<Value>(),
        },
    })
}

fn agreement(agreement: &Agreement) -> Value {
    let run =
        |(method, tolerance): &(String, f64)| json!({ "method": method, "tolerance": tolerance });
    json!({
        "run": run(&agreement.reference),
        "compared_with": run(&agreement.other),
        "uncertainty": errors(&agreement.uncertainty),
        "exact_runs": agreement.runs,
        "scatter_of_statistics": {
            "displacement_relative": statistics(&agreement.scatter.statistics),
            "force_relative": statistics(&agreement.scatter.force_statistics),
        },
        "growth_of_differences": agreement.growth,
        "irregular": agreement.irregular,
        "motion_m": agreement.scale.displacement,
        "force_in_motion_N": agreement.scale.force,
    })
}

fn method(row: &Row) -> Value {
    let measured = row.result.as_ref().ok();
    json!({
        "method": row.method,
        "tolerance": row.tolerance,
        "cost": measured.map(|measured| cost(&measured.cost)),
        "error": measured.map(|measured| errors(&measured.errors)),
        "within_uncertainty": measured.map(|measured| measured.within_uncertainty),
        "note": row.result.as_ref().err(),
    })
}

fn rung(row: &LadderRow, duration: f64) -> Value {
    let measured = row.result.as_ref().ok();
    json!({
        "model": row.configuration.to_string(),
        "as_written": row.as_written,
        "available": measured.is_some(),
        "wall_time_per_simulated_s": measured.map(|(cost, _)| cost.seconds / duration),
        "cost": measured.map(|(own, _)| cost(own)),
        "difference": measured.map(|(_, own)| errors(own)),
        "note": row.result.as_ref().err(),
    })
}

fn cost(cost: &Cost) -> Value {
    json!({
        "wall_time_s": cost.seconds,
        "repeats": cost.repeats,
        "steps": cost.counters.steps,
        "rejected": cost.counters.rejected,
        "evaluations": cost.counters.evaluations,
    })
}

fn errors(errors: &Errors) -> Value {
    json!({
        "displacement_m": errors.displacement,
        "displacement_relative": errors.displacement_relative,
        "force_N": errors.force,
        "force_relative": errors.force_relative,
        "lines_relative": errors.lines,
        "displacement_statistics_relative": statistics(&errors.statistics),
        "force_statistics_relative": statistics(&errors.force_statistics),
    })
}

fn statistics(statistics: &Statistics) -> Value {
    json!({
        "mean": statistics.mean,
        "rms": statistics.rms,
        "peak": statistics.peak,
    })
}
