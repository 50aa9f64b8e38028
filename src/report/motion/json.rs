//! A steady motion in the summary.

use serde_json::{Value, json};

use crate::analysis::{
    Channel, ChannelStatistics, ClosedCurve, Drift, Kind, Motion, Recognition, Section,
    VelocityLevel,
};

/// Everything about a steady motion but its points.
pub(in super::super) fn motion_json(motion: &Motion) -> Value {
    json!({
        "start_s": motion.start,
        "end_s": motion.end,
        "kind": kind(&motion.recognition.kind),
        "distances": distances(&motion.recognition),
        "closed_curves": motion
            .recognition
            .curves
            .iter()
            .map(|(section, curve)| (section.to_string(), closed_curve(curve)))
            .collect::<serde_json::Map<_, _>>(),
        "settling": motion.drift.as_ref().map(|known| drift(known, motion)),
        "statistics": motion.statistics.iter().map(statistics).collect::<Value>(),
        "velocity_rms": motion
            .velocity
            .iter()
            .zip(["x", "y", "z"])
            .map(|(level, name)| (name.to_owned(), level.as_ref().map(velocity).into()))
            .collect::<serde_json::Map<_, _>>(),
        "sections": motion.sections.iter().map(section).collect::<Value>(),
    })
}

fn kind(kind: &Kind) -> Value {
    match kind {
        Kind::Rest => json!({ "name": "rest" }),
        Kind::Periodic {
            section,
            cycles,
            distance,
        } => json!({
            "name": "periodic",
            "section": section.to_string(),
            "cycles": cycles,
            "distance": distance,
        }),
        Kind::QuasiPeriodic { section, curve } => json!({
            "name": "quasi-periodic",
            "section": section.to_string(),
            "closed_curve": closed_curve(curve),
        }),
        Kind::Irregular { test } => json!({ "name": "irregular", "zero_one_test": test }),
        Kind::Unknown { points, test } => json!({
            "name": "unknown",
            "points": points,
            "zero_one_test": test,
        }),
    }
}

fn distances(recognition: &Recognition) -> Value {
    let sections = recognition.distances.iter();
    let values: serde_json::Map<String, Value> = sections
        .map(|(section, values)| (section.to_string(), values.iter().copied().collect()))
        .collect();
    json!({
        "meaning": "RMS distance of points any multiple of 1, 2, … cycles apart, in parts of the RMS of the \
                    motion, over the last half of the points",
        "sections": values,
    })
}

fn closed_curve(curve: &ClosedCurve) -> Value {
    json!({
        "rotation": curve.rotation,
        "harmonics": curve.harmonics,
        "residual": curve.residual,
    })
}

/// Statistics of an irregular motion move by themselves: they do not tell whether it has settled.
fn drift(drift: &Drift, motion: &Motion) -> Value {
    let irregular = matches!(motion.recognition.kind, Kind::Irregular { .. });
    json!({
        "meaning": "change of mean and RMS from the second to the last third, in parts of the RMS of the \
                    motion, of the freedom that changes most",
        "channel": Channel::Displacement(drift.freedom).name(),
        "mean": drift.mean,
        "rms": drift.rms,
        "settled": (!irregular).then(|| drift.is_settled()),
    })
}

fn statistics(each: &ChannelStatistics) -> Value {
    let moments = &each.moments;
    json!({
        "channel": each.channel.column(),
        "mean": moments.mean(),
        "rms": moments.rms(),
        "peak": moments.peak(),
        "peak_to_peak": moments.peak_to_peak(),
        "crest_factor": moments.crest_factor(),
        "kurtosis": moments.kurtosis(),
    })
}

fn velocity(level: &VelocityLevel) -> Value {
    json!({ "rms_m_s": level.rms, "band_Hz": level.band })
}

fn section(section: &Section) -> Value {
    json!({
        "section": section.kind.to_string(),
        "cycles_per_revolution": section.order,
        "points": section.points.len(),
        "interpolation_error": section.interpolation,
    })
}
