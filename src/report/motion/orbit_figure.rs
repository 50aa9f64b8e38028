//! `orbit.svg`: the way of the shaft's centre, and its points once per revolution and per ball pass.

use plotters::prelude::*;

use super::super::ReportError;
use super::super::figure::{Area, DrawError, GRID, INK, LINE, PALETTE, font, px, svg, tick_format};
use super::super::figure_curves::draw_names;
use crate::analysis::{Kind, Motion, Section, SectionKind};
use crate::report::units::MICRO;

/// Height, px.
const HEIGHT: u32 = 720;
/// Height of the strip of names, px.
const NAMES_HEIGHT: u32 = 24;
/// Most points of a section that are drawn: the last ones.
const MOST_POINTS: usize = 600;
/// Width of the line of the orbit where it is drawn many times over.
const FINE: u32 = 1;

/// Draws y over x in µm at one scale, both from their means.
pub(in super::super) fn orbit_figure(title: &str, motion: &Motion) -> Result<String, ReportError> {
    svg("orbit.svg", HEIGHT, title, |area| draw(area, motion))
}

fn draw(area: &Area, motion: &Motion) -> Result<(), DrawError> {
    let (strip, below) = area.split_vertically(px(NAMES_HEIGHT));
    let mut names = vec![("orbit".to_owned(), PALETTE[0])];
    for section in &motion.sections {
        names.push((name(section.kind).to_owned(), colour(section.kind)));
    }
    draw_names(&strip, &names)?;
    let centre = [0, 1].map(|axis| motion.statistics[axis].moments.mean());
    let seen = |place: [f64; 2]| {
        let [x, y] = [0, 1].map(|axis| MICRO * (place[axis] - centre[axis]));
        (x, y)
    };
    let orbit: Vec<(f64, f64)> = shown_orbit(motion)
        .iter()
        .map(|place| seen(*place))
        .collect();
    let reach = orbit
        .iter()
        .fold(0.0, |reach: f64, (x, y)| reach.max(x.abs()).max(y.abs()));
    let reach = if reach > 0.0 { 1.08 * reach } else { 1.0 };
    // the same length for a micrometre both ways
    let [left, bottom, margin] = [74, 44, 12];
    let (width, height) = below.dim_in_pixel();
    let wide = f64::from(width.saturating_sub(px(left + 2 * margin)));
    let high = f64::from(height.saturating_sub(px(bottom + 2 * margin)));
    let across = reach * wide / high.max(1.0);
    let mut chart = ChartBuilder::on(&below)
        .margin(px(margin))
        .set_label_area_size(LabelAreaPosition::Left, px(left))
        .set_label_area_size(LabelAreaPosition::Bottom, px(bottom))
        .build_cartesian_2d(-across..across, -reach..reach)?;
    chart
        .configure_mesh()
        .bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .x_label_formatter(&tick_format(2.0 * across))
        .y_label_formatter(&tick_format(2.0 * reach))
        .x_desc(format!("x from its mean {} in µm", mean(centre[0])))
        .y_desc(format!("y from its mean {} in µm", mean(centre[1])))
        .axis_style(INK)
        .label_style(font(12))
        .axis_desc_style(font(13))
        .draw()?;
    let stroke = if repeats(motion) { LINE } else { FINE };
    chart.draw_series(LineSeries::new(orbit, PALETTE[0].stroke_width(stroke)))?;
    for section in &motion.sections {
        let from = section.points.len().saturating_sub(MOST_POINTS);
        let points = section.points[from..].iter();
        let places = points.map(|point| seen([point.displacement[0], point.displacement[1]]));
        let dot = |place| Circle::new(place, px(3), colour(section.kind).filled());
        chart.draw_series(places.map(dot))?;
    }
    Ok(())
}

fn name(kind: SectionKind) -> &'static str {
    match kind {
        SectionKind::Revolution => "each revolution",
        SectionKind::BallPass => "each ball pass",
    }
}

fn colour(kind: SectionKind) -> RGBColor {
    match kind {
        SectionKind::Revolution => PALETTE[1],
        SectionKind::BallPass => PALETTE[2],
    }
}

fn mean(metres: f64) -> String {
    format!("{:.4} µm", MICRO * metres)
}

fn repeats(motion: &Motion) -> bool {
    matches!(motion.recognition.kind, Kind::Periodic { .. })
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
