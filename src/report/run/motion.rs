//! A steady motion: points of its sections, its orbit, and what it is like.

use serde_json::{Value, json};

use crate::analysis::{Channel, Kind, LONGEST_PERIOD, Motion, Section, SectionKind, VelocityLevel};
use crate::physics::MachineSupport;
use crate::report::figure::{Axis, Curve, Figure, Name, Panel, Point, distinct};
use crate::report::findings::with_keys;
use crate::report::terminal::{Lines, MICRO, MILLI, listed, significant};
use crate::rotor::FREEDOMS;
use crate::simulate::VibrationSeverity;
use crate::table::Table;

/// Everything about a steady motion but its points, and whether it has settled.
pub(super) fn motion_json(motion: &Motion) -> Value {
    let settling = motion.drift.as_ref().map(|drift| {
        let mut json = json!({
            "meaning": "change of mean and RMS from one window to another one at the end of the record, whole revolutions \
                        apart, in parts of the RMS of the motion, of the freedom that changes most",
            "channel": Channel::Displacement(drift.freedom).name(),
        });
        json = with_keys(json, json!(drift));
        // not known of an irregular motion, whose statistics move by themselves
        json["settled"] = json!(motion.has_settled());
        json
    });
    with_keys(motion, json!({ "settling": settling }))
}

/// Kind, settling, vibration and velocity.
pub(super) fn add_motion(out: &mut Lines, motion: &Motion) {
    out.line("motion", kind(&motion.recognition.kind));
    if let Some(drift) = &motion.drift {
        let word = match motion.has_settled() {
            None => "wanders",
            Some(true) => "settled",
            Some(false) => "not settled",
        };
        let channel = Channel::Displacement(drift.freedom);
        let [mean, rms] = [drift.mean, drift.rms].map(|part| 100.0 * part.abs());
        out.more(format_args!(
            "{word}: over {} s mean and RMS of {channel} move by {mean:.2} % and {rms:.2} %",
            significant(drift.apart)
        ));
    }
    let all = motion.statistics.iter();
    let of_shaft = |channel: Channel| matches!(channel, Channel::Displacement(0..3));
    for each in all.filter(|each| of_shaft(each.channel)) {
        let moments = &each.moments;
        let (Some(crest), Some(kurtosis)) = (moments.crest_factor(), moments.kurtosis()) else {
            continue;
        };
        let [rms, peak] = [moments.rms(), moments.peak()].map(|part| significant(MICRO * part));
        let text =
            format!("{rms} µm RMS, peak {peak}, crest factor {crest:.2}, kurtosis {kurtosis:.2}");
        out.line(&format!("vibration {}", each.channel), text);
        out.more(velocity(motion, each.channel));
    }
}

/// The velocities of the housings, where machines are measured.
pub(super) fn add_housings(out: &mut Lines, motion: &Motion) {
    let levels = motion.housing_velocity.iter();
    out.each(
        "vibration",
        levels.map(|of| level_text(of.channel, &of.level)),
    );
}

/// In which zone of ISO 20816-3 the vibration lies, and how far that holds.
pub(in crate::report) fn add_severity(out: &mut Lines, severity: &VibrationSeverity) {
    let support = match severity.support {
        MachineSupport::Rigid => "rigid",
        MachineSupport::Flexible => "flexible",
    };
    let (standard, group) = (severity.standard, severity.group);
    let boundaries = severity.boundaries;
    let boundaries = listed(boundaries.map(|boundary| format!("{:.1}", MILLI * boundary)));
    let zone = format!(
        "{:?} of {standard}, {}: {}; boundaries {boundaries} mm/s (group {group}, {support} support)",
        severity.zone,
        severity.meaning,
        level_text(severity.channel, &severity.level)
    );
    out.line("zone", zone);
    out.each("", &severity.remarks);
}

fn kind(kind: &Kind) -> String {
    match kind {
        Kind::Rest => "none".to_owned(),
        Kind::Diverging => "grows beyond all bounds".to_owned(),
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
    level.as_ref().map_or_else(String::new, rms_text)
}

/// Velocity and whose it is: `0.123 mm/s RMS from 10 to 1000 Hz of housing1 along x`.
fn level_text(channel: Channel, level: &VelocityLevel) -> String {
    if let Channel::Measured(_) = channel {
        return format!("{} of {channel}", rms_text(level));
    }
    let name = channel.name().trim_end_matches("_velocity");
    let (part, axis) = name.split_once('_').unwrap_or(("the shaft", name));
    format!("{} of {part} along {axis}", rms_text(level))
}

pub(in crate::report) fn rms_text(level: &VelocityLevel) -> String {
    let [low, high] = level.band;
    format!(
        "{} mm/s RMS from {low:.0} to {high:.0} Hz",
        significant(MILLI * level.rms)
    )
}

/// One row a point, section by section: which section, cycles since the start, time, then displacements and
/// velocities.
pub(super) fn poincare_table(motion: &Motion) -> Table<'static> {
    let sections = motion.sections.iter();
    let points: Vec<_> = sections
        .flat_map(|section| section.points.iter().map(|point| (section.kind, point)))
        .collect();
    let table = Table::from_items(&points)
        .word("section", |(kind, _)| kind)
        .count("number", |(_, point)| point.number as f64)
        .number("t", "s", |(_, point)| point.time);
    let displaced = (0..FREEDOMS).fold(table, |table, freedom| {
        let column = Channel::Displacement(freedom).column();
        table.column(column, |(_, point)| point.displacement[freedom])
    });
    let moving = (0..FREEDOMS).fold(displaced, |table, freedom| {
        let column = Channel::Velocity(freedom).column();
        table.column(column, |(_, point)| point.velocity[freedom])
    });
    moving.end()
}

/// Most points of a section that are drawn: the last ones.
const MOST_POINTS: usize = 600;

/// y over x in µm at one scale, both from their means.
pub(super) fn orbit_figure(title: &str, motion: &Motion) -> Figure {
    let centre = [0, 1].map(|axis| MICRO * motion.statistics[axis].moments.mean());
    let seen = |x: f64, y: f64| -> Point { (MICRO * x - centre[0], MICRO * y - centre[1]) };
    let path = shown_orbit(motion).iter().map(|[x, y]| seen(*x, *y));
    let path = Curve {
        fine: !matches!(motion.recognition.kind, Kind::Periodic { .. }),
        ..Curve::line(distinct(0), path.collect())
    };
    let reach = path
        .points
        .iter()
        .fold(0.0, |reach: f64, (x, y)| reach.max(x.abs()).max(y.abs()));
    let up = if reach > 0.0 { 1.08 * reach } else { 1.0 };
    let [x, y] = [("x", centre[0]), ("y", centre[1])].map(|(name, mean)| {
        let quantity = format!("{name} from its mean {mean:.4} µm");
        Axis::over((quantity, "µm"), -up..up)
    });
    let mut names = vec![Name::new("orbit", distinct(0))];
    let mut curves = vec![path];
    for section in &motion.sections {
        let (name, colour) = match section.kind {
            SectionKind::Revolution => ("each revolution", distinct(1)),
            SectionKind::BallPass => ("each ball pass", distinct(2)),
        };
        let from = section.points.len().saturating_sub(MOST_POINTS);
        let points = section.points[from..].iter();
        let points = points.map(|point| seen(point.displacement[0], point.displacement[1]));
        names.push(Name::new(name, colour));
        curves.push(Curve::dots(colour, points.collect()));
    }
    let panel = Panel {
        curves,
        aspect: Some(1.0),
        ..Panel::new(x, y, 0)
    };
    Figure::new("orbit", title, 1, vec![panel]).with_names(names)
}

/// One period and a little more where the motion repeats, else all that was kept.
fn shown_orbit(motion: &Motion) -> &[[f64; 2]] {
    let Kind::Periodic {
        section, cycles, ..
    } = motion.recognition.kind
    else {
        return &motion.orbit;
    };
    let section = motion.sections.iter().find(|known| known.kind == section);
    let samples = section.and_then(|section| samples_a_cycle(section, motion));
    let wanted = samples.map_or(motion.orbit.len(), |samples| {
        (samples * cycles as f64).ceil() as usize + 2
    });
    &motion.orbit[motion.orbit.len().saturating_sub(wanted)..]
}

fn samples_a_cycle(section: &Section, motion: &Motion) -> Option<f64> {
    let (first, last) = (section.points.first()?, section.points.last()?);
    let cycles = (last.number - first.number) as f64;
    (cycles > 0.0).then(|| (last.time - first.time) / cycles * motion.rate)
}
