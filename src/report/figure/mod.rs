//! Figures: panels of curves, marks and cells over axes, described as data. The SVG file and the page draw what is described.

mod axis;
mod colour;
mod layout;
mod packed;
mod svg;
mod text;
mod ticks;

use serde::Serialize;

use super::envelope::{BUCKETS, Decimator};

pub(super) use axis::{Axis, Label, ends, padded};
pub(super) use colour::{COLOURS, Colour, GREY, WHITE, distinct, graded};
pub(super) use packed::narrow;
pub(super) use text::escaped;

/// A place in the units of the axes.
pub(crate) type Point = (f64, f64);

/// A figure: a title, what its colours mean, and panels row by row.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct Figure {
    /// Name of its file, without the ending.
    pub name: String,
    /// What a page calls it.
    pub heading: String,
    /// The title above it.
    pub title: String,
    /// What the colours mean, in all panels.
    pub names: Vec<Name>,
    /// Panels side by side, where there is room.
    pub columns: usize,
    /// The panels.
    pub panels: Vec<Panel>,
    /// Whether only a page shows it: it has no file.
    #[serde(skip)]
    pub only_on_page: bool,
}

/// What a colour means.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Name {
    pub text: String,
    pub colour: Colour,
    /// The mark at the points of its curve, if that tells it apart.
    pub mark: Option<Mark>,
}

/// Curves and marks over two axes.
#[derive(Debug, Clone, Default, Serialize)]
pub(crate) struct Panel {
    /// The title above it, if it has one.
    pub title: String,
    /// What the colours mean in this panel.
    pub names: Vec<Name>,
    /// From left to right.
    pub x: Axis,
    /// From below to above.
    pub y: Axis,
    /// Height of the plot, px; of one with an aspect the width decides.
    pub height: u32,
    /// How many times as long a unit is upwards as it is across, if that matters.
    pub aspect: Option<f64>,
    /// Rectangles.
    #[serde(serialize_with = "packed::cells")]
    pub cells: Vec<Cell>,
    /// What the colours of the cells or of the map mean: a bar of all of them along this axis.
    pub bar: Option<Axis>,
    /// A map that fills the plot.
    pub map: Option<Map>,
    #[serde(serialize_with = "packed::curves")]
    pub curves: Vec<Curve>,
    /// Texts at their places.
    pub labels: Vec<(Point, String, Colour)>,
    /// Places with a name, which are left out where they would cover one before them.
    pub peaks: Vec<(Point, String)>,
}

/// A line through points, and marks.
#[derive(Debug, Clone, Default)]
pub(crate) struct Curve {
    pub colour: Colour,
    /// Points that straight lines join; no line runs to or from a value that is not a number.
    pub points: Vec<Point>,
    /// Of each point the lowest and the highest value around it, where values are not known one by one.
    pub band: Vec<[f64; 2]>,
    /// Points that are marked.
    pub marks: Vec<Point>,
    /// How they are marked.
    pub mark: Mark,
    /// Whether the line is thin, for it covers itself many times over.
    pub fine: bool,
    /// How far to the right of its places it is drawn, px, so that curves over each other are both seen.
    pub beside: u8,
    /// What it is called, where that is more than its colour tells.
    pub name: String,
    /// Of a study: the run that each point shows, or each mark of a curve without points.
    pub runs: Vec<u64>,
}

/// A rectangle between two corners, and what it shows.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Cell {
    pub corners: [Point; 2],
    pub colour: Colour,
    /// The value that its colour or its length shows.
    pub value: f64,
    /// Of a study: the run that it shows.
    pub run: Option<u64>,
}

/// What marks a point.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Mark {
    /// One of many points.
    Spot,
    #[default]
    Dot,
    /// A single dot.
    Disc,
    Triangle,
}

/// Levels row by row from the top, 0 to 255, evenly over the bar of the panel.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(crate) struct Map {
    /// Levels in a row.
    pub width: usize,
    #[serde(serialize_with = "packed::levels")]
    pub levels: Vec<u8>,
}

/// What a page calls the figure or the table of a file, by the name of the file.
pub(super) fn heading(name: &str) -> String {
    let mut letters = name.chars();
    let first = letters.next().map(|letter| letter.to_ascii_uppercase());
    let words = first.into_iter().chain(letters).collect::<String>();
    words.replace('_', " ")
}

impl Figure {
    /// Panels under a title.
    pub fn new(name: &str, title: &str, columns: usize, panels: Vec<Panel>) -> Self {
        Self {
            name: name.to_owned(),
            heading: heading(name),
            title: title.to_owned(),
            names: Vec::new(),
            columns,
            panels,
            only_on_page: false,
        }
    }

    /// The figure without a file of its own.
    pub fn only_on_page(self) -> Self {
        Self {
            only_on_page: true,
            ..self
        }
    }

    /// The figure with what its colours mean; a name that nothing has the colour of is left out.
    pub fn with_names(mut self, names: impl IntoIterator<Item = Name>) -> Self {
        let is_shown = |name: &Name| self.panels.iter().any(|panel| panel.shows(name));
        self.names = names.into_iter().filter(is_shown).collect();
        self
    }

    /// The figure as SVG, as wide as a page.
    pub fn svg(&self) -> String {
        svg::drawn(self, svg::PAGE)
    }
}

impl Name {
    /// What a colour means.
    pub fn new(text: impl Into<String>, colour: Colour) -> Self {
        Self {
            text: text.into(),
            colour,
            mark: None,
        }
    }

    /// What the [`distinct`] colours mean, in their order.
    pub fn each<T: Into<String>>(texts: impl IntoIterator<Item = T>) -> Vec<Self> {
        let texts = texts.into_iter().enumerate();
        texts
            .map(|(index, text)| Self::new(text, distinct(index)))
            .collect()
    }
}

impl Panel {
    /// Nothing over two axes.
    pub fn new(x: Axis, y: Axis, height: u32) -> Self {
        Self {
            x,
            y,
            height,
            ..Self::default()
        }
    }

    /// Curves over `x`, with an axis called `y` that holds them.
    pub fn holding(x: Axis, y: impl Into<Label>, height: u32, curves: Vec<Curve>) -> Self {
        let points = curves.iter().flat_map(|curve| &curve.points);
        let bands = curves.iter().flat_map(|curve| &curve.band).flatten();
        let y = Axis::around(y, points.map(|point| point.1).chain(bands.copied()));
        Self {
            curves,
            ..Self::new(x, y, height)
        }
    }

    /// Whether something is seen in the colour, and with the mark, of a name.
    fn shows(&self, name: &Name) -> bool {
        let mut curves = self.curves.iter();
        let is_seen = |curve: &Curve| {
            let mut points = curve.points.iter().chain(&curve.marks);
            !curve.band.is_empty() || points.any(|point| self.y.holds(point.1))
        };
        curves.any(|curve| {
            let is_alike = name.mark.is_none_or(|mark| mark == curve.mark);
            curve.colour == name.colour && is_alike && is_seen(curve)
        }) || self.cells.iter().any(|cell| cell.colour == name.colour)
    }
}

impl Curve {
    /// A line through points.
    pub fn line(colour: Colour, points: Vec<Point>) -> Self {
        Self {
            colour,
            points,
            ..Self::default()
        }
    }

    /// Points that no line joins.
    pub fn dots(colour: Colour, marks: Vec<Point>) -> Self {
        Self {
            colour,
            marks,
            ..Self::default()
        }
    }

    /// A line through points that are marked where they are few.
    pub fn marked(colour: Colour, points: Vec<Point>, most_marks: usize) -> Self {
        let few = points.len() <= most_marks;
        Self {
            marks: if few { points.clone() } else { Vec::new() },
            ..Self::line(colour, points)
        }
    }

    /// The envelope of a curve of any length.
    pub fn envelope(colour: Colour, points: impl IntoIterator<Item = Point>) -> Self {
        let mut envelope = Decimator::new(BUCKETS);
        for (at, value) in points {
            envelope.push(at, value);
        }
        Self::line(colour, envelope.points().collect())
    }
}

/// A full turn, degrees.
const TURN: f64 = 360.0;

/// Values at azimuths in rad, as points over one turn in degrees.
pub(in crate::report) fn turned(values: impl IntoIterator<Item = Point>) -> Vec<Point> {
    let turned = |(azimuth, value): Point| (azimuth.to_degrees().rem_euclid(TURN), value);
    let mut points: Vec<_> = values.into_iter().map(turned).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// The curve through points of one turn, from its start to its end.
pub(in crate::report) fn all_around(mut points: Vec<Point>) -> Vec<Point> {
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else {
        return points;
    };
    // the line from the last point over the end of the turn to the first
    let gap = first.0 + TURN - last.0;
    let part = (TURN - last.0) / gap;
    let seam = last.1 + part * (first.1 - last.1);
    points.insert(0, (0.0, seam));
    points.push((TURN, seam));
    points
}

/// Points of an angle in degrees without the lines between those where it begins anew.
pub(in crate::report) fn broken_at_turns(points: &[Point]) -> Vec<Point> {
    let mut broken: Vec<Point> = Vec::new();
    for point in points {
        let before = broken.last().copied();
        let jumps = |before: &Point| (point.1 - before.1).abs() > 0.5 * TURN;
        broken.extend(before.filter(jumps).map(|_| (point.0, f64::NAN)));
        broken.push(*point);
    }
    broken
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_is_closed_at_its_seam() {
        let points = all_around(turned([
            (-90f64.to_radians(), 4.0),
            (90f64.to_radians(), 2.0),
        ]));
        assert_eq!(points[0], (0.0, 3.0));
        assert_eq!(points[3], (360.0, 3.0));
    }

    #[test]
    fn no_line_runs_from_half_a_turn_to_its_other_side() {
        let points = [(1.0, 170.0), (2.0, 179.0), (3.0, -179.0), (4.0, -20.0)];
        let broken = broken_at_turns(&points);
        let gaps: Vec<_> = broken.iter().map(|point| point.1.is_nan()).collect();
        assert_eq!(gaps, [false, false, true, false, false]);
    }
}
