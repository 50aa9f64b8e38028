//! A steady motion in a few lines.

use super::super::terminal::Lines;
use crate::analysis::{Channel, Kind, LONGEST_PERIOD, Motion, SectionKind};
use crate::report::units::{MICRO, MILLI};

/// Kind, settling, vibration and velocity.
pub(in super::super) fn put_motion(out: &mut Lines, motion: &Motion) {
    out.line("motion", kind(&motion.recognition.kind));
    if let Some(drift) = &motion.drift {
        let word = match (&motion.recognition.kind, drift.is_settled()) {
            (Kind::Irregular { .. }, _) => "wanders",
            (_, true) => "settled",
            (_, false) => "not settled",
        };
        let channel = Channel::Displacement(drift.freedom);
        let [mean, rms] = [drift.mean, drift.rms].map(|part| 100.0 * part.abs());
        out.more(format_args!(
            "{word}: between thirds mean and RMS of {channel} move by {mean:.2} % and {rms:.2} %"
        ));
    }
    let all = motion.statistics.iter();
    for each in all.filter(|each| each.channel.unit() == "m") {
        let moments = &each.moments;
        let (Some(crest), Some(kurtosis)) = (moments.crest_factor(), moments.kurtosis()) else {
            continue;
        };
        let [rms, peak] = [moments.rms(), moments.peak()].map(|part| short(MICRO * part));
        let text =
            format!("{rms} µm RMS, peak {peak}, crest factor {crest:.2}, kurtosis {kurtosis:.2}");
        out.line(&format!("vibration {}", each.channel), text);
        out.more(velocity(motion, each.channel));
    }
}

fn kind(kind: &Kind) -> String {
    match kind {
        Kind::Rest => "none".to_owned(),
        Kind::Periodic {
            section,
            cycles,
            distance,
        } => format!(
            "repeats every {}: points come back within {distance:.1e} of the motion",
            counted(*section, *cycles)
        ),
        Kind::QuasiPeriodic { section, curve } => format!(
            "two frequencies: each {} turns by {:.4} on a closed curve, missed by {:.1e}",
            counted(*section, 1),
            curve.rotation,
            curve.residual
        ),
        Kind::Irregular { test } => format!("irregular: 0–1 test {test:.3}"),
        Kind::Unknown { points, test: None } => {
            format!(
                "neither repeats nor has two frequencies; {points} points are too few to tell more"
            )
        }
        Kind::Unknown {
            points,
            test: Some(test),
        } => format!(
            "regular (0–1 test {test:.3}), but repeats neither within {LONGEST_PERIOD} cycles nor on a \
             closed curve, in {points} points"
        ),
    }
}

/// `revolution`, `2 ball passes`.
fn counted(section: SectionKind, cycles: usize) -> String {
    let (one, many) = match section {
        SectionKind::Revolution => ("revolution", "revolutions"),
        SectionKind::BallPass => ("ball pass", "ball passes"),
    };
    match cycles {
        1 => one.to_owned(),
        _ => format!("{cycles} {many}"),
    }
}

/// `0.123 mm/s RMS from 10 to 1000 Hz`.
fn velocity(motion: &Motion, channel: Channel) -> String {
    let Channel::Displacement(axis) = channel else {
        return String::new();
    };
    let level = motion.velocity.get(axis).copied().flatten();
    level.map_or_else(String::new, |level| {
        let [low, high] = level.band;
        format!(
            "{} mm/s RMS from {low:.0} to {high:.0} Hz",
            short(MILLI * level.rms)
        )
    })
}

/// Four digits.
fn short(value: f64) -> String {
    if (1e-2..1e4).contains(&value.abs()) {
        format!("{value:.4}")
    } else {
        format!("{value:.3e}")
    }
}
