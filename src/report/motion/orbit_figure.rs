//! `orbit.svg`: the way of the shaft's centre, and its points once per revolution and per ball pass.

use crate::analysis::{Kind, Motion, Section, SectionKind};
use crate::report::figure::{Axis, Curve, Figure, Name, PLOT_WIDTH, Panel, distinct};
use crate::report::units::MICRO;

/// Height of the plot, px.
const HEIGHT: u32 = 598;
/// Most points of a section that are drawn: the last ones.
const MOST_POINTS: usize = 600;

/// y over x in µm at one scale, both from their means.
pub(in super::super) fn orbit_figure(title: &str, motion: &Motion) -> Figure {
    let centre = [0, 1].map(|axis| motion.statistics[axis].moments.mean());
    let seen = |place: [f64; 2]| {
        let [x, y] = [0, 1].map(|axis| MICRO * (place[axis] - centre[axis]));
        (x, y)
    };
    let orbit = shown_orbit(motion).iter().map(|place| seen(*place));
    let orbit = Curve {
        fine: !matches!(motion.recognition.kind, Kind::Periodic { .. }),
        ..Curve::line(distinct(0), orbit.collect())
    };
    let reach = orbit
        .points
        .iter()
        .fold(0.0, |reach: f64, (x, y)| reach.max(x.abs()).max(y.abs()));
    let up = if reach > 0.0 { 1.08 * reach } else { 1.0 };
    // the same length for a micrometre both ways
    let across = up * f64::from(PLOT_WIDTH) / f64::from(HEIGHT);
    let [x, y] = [("x", centre[0], across), ("y", centre[1], up)].map(|(name, mean, reach)| {
        let mean = MICRO * mean;
        Axis::over(
            format!("{name} from its mean {mean:.4} µm in µm"),
            -reach..reach,
        )
    });
    let mut names = vec![Name::new("orbit", distinct(0))];
    let mut curves = vec![orbit];
    for section in &motion.sections {
        let (name, colour) = match section.kind {
            SectionKind::Revolution => ("each revolution", distinct(1)),
            SectionKind::BallPass => ("each ball pass", distinct(2)),
        };
        let from = section.points.len().saturating_sub(MOST_POINTS);
        let points = section.points[from..].iter();
        let places = points.map(|point| seen([point.displacement[0], point.displacement[1]]));
        names.push(Name::new(name, colour));
        curves.push(Curve::dots(colour, places.collect()));
    }
    let panel = Panel {
        curves,
        ..Panel::new(x, y, HEIGHT)
    };
    Figure::new("orbit.svg", title, 1, vec![panel]).with_names(names)
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
