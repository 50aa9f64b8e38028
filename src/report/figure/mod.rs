//! Figures: panels of curves, marks and cells over axes, told as data and drawn in one way.

mod axis;
mod draw;
mod format;

use plotters::style::RGBColor;

use super::ReportError;
use super::envelope::{BUCKETS, Decimator};

pub(super) use axis::{Axis, ends, padded, round_ticks};
pub(super) use draw::PLOT_WIDTH;
pub(super) use format::figure_formats;
pub(crate) use format::{FigureFormat, write_figures_as};

/// A place in the units of the axes.
pub(crate) type Point = (f64, f64);

/// A figure: a title, what its colours mean, and panels row by row.
#[derive(Debug, Clone)]
pub(crate) struct Figure {
    /// Name of its file.
    pub file: String,
    /// What stands above it.
    pub title: String,
    /// What the colours mean, in all panels.
    pub names: Vec<Name>,
    /// Panels side by side.
    pub columns: usize,
    /// The panels.
    pub panels: Vec<Panel>,
}

/// What a colour means.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Name {
    pub text: String,
    pub colour: RGBColor,
    /// What stands at the points of its curve, if that tells it apart.
    pub mark: Option<Mark>,
}

/// Curves and marks over two axes.
#[derive(Debug, Clone, Default)]
pub(crate) struct Panel {
    /// What stands above it, if anything.
    pub title: String,
    /// What the colours mean in this panel.
    pub names: Vec<Name>,
    /// From left to right.
    pub x: Axis,
    /// From below to above.
    pub y: Axis,
    /// Height of the plot, px.
    pub height: u32,
    /// Whether a unit is as long upwards as it is across.
    pub equal: bool,
    /// Rectangles.
    pub cells: Vec<Cell>,
    /// What the colours of the cells mean: a bar of all of them along this axis.
    pub bar: Option<Axis>,
    /// A map that fills the plot.
    pub map: Option<Map>,
    pub curves: Vec<Curve>,
    /// Texts at their places.
    pub labels: Vec<(Point, String, RGBColor)>,
    /// Places with a name, which are left out where they would cover one before them.
    pub peaks: Vec<(Point, String)>,
}

/// A line through points, and marks.
#[derive(Debug, Clone, Default)]
pub(crate) struct Curve {
    pub colour: RGBColor,
    /// Points that straight lines join.
    pub points: Vec<Point>,
    /// Points that are marked.
    pub marks: Vec<Point>,
    /// How they are marked.
    pub mark: Mark,
    /// Whether the line is thin, for it covers itself many times over.
    pub fine: bool,
    /// What it is called, where that is more than its colour tells.
    pub name: String,
    /// Of a study: the run that each point stands for, or each mark of a curve without points.
    pub runs: Vec<u64>,
}

/// A rectangle between two corners, and what it stands for.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Cell {
    pub corners: [Point; 2],
    pub colour: RGBColor,
    /// The value that its colour or its length shows.
    pub value: f64,
    /// Of a study: the run that it stands for.
    pub run: Option<u64>,
}

/// What marks a point.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum Mark {
    /// One of many points.
    Spot,
    #[default]
    Dot,
    /// A dot that stands alone.
    Disc,
    Triangle,
}

/// Levels row by row from the top, 0 to 255, in the colours of [`graded`].
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Map {
    /// Levels in a row.
    pub width: usize,
    pub levels: Vec<u8>,
    /// Value of level 255.
    pub top: f64,
    /// Decades from level 0 up to there.
    pub decades: f64,
    /// Unit of the values.
    pub unit: &'static str,
}

impl Figure {
    /// Panels under a title.
    pub fn new(file: &str, title: &str, columns: usize, panels: Vec<Panel>) -> Self {
        Self {
            file: file.to_owned(),
            title: title.to_owned(),
            names: Vec::new(),
            columns,
            panels,
        }
    }

    /// The same with what its colours mean.
    pub fn with_names(self, names: impl IntoIterator<Item = Name>) -> Self {
        Self {
            names: names.into_iter().collect(),
            ..self
        }
    }

    /// Name of its file without the ending.
    pub fn name(&self) -> &str {
        self.file.trim_end_matches(".svg")
    }

    /// The figure as SVG.
    ///
    /// # Errors
    /// [`ReportError::Draw`] where the drawing library fails.
    pub fn svg(&self) -> Result<String, ReportError> {
        draw::svg(self).map_err(|source| ReportError::Draw {
            figure: self.file.clone(),
            source,
        })
    }
}

impl Name {
    /// What a colour means.
    pub fn new(text: impl Into<String>, colour: RGBColor) -> Self {
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
    /// Curves over `x`, with an axis called `y` that holds them.
    pub fn of(x: Axis, y: impl Into<String>, height: u32, curves: Vec<Curve>) -> Self {
        let points = curves.iter().flat_map(|curve| &curve.points);
        let y = Axis::around(y, points.map(|point| point.1));
        Self {
            curves,
            ..Self::new(x, y, height)
        }
    }

    /// A point in the units that its axes are drawn in.
    fn place(&self, (x, y): Point) -> Point {
        (self.x.place(x), self.y.place(y))
    }

    /// Nothing over two axes.
    pub fn new(x: Axis, y: Axis, height: u32) -> Self {
        Self {
            x,
            y,
            height,
            ..Self::default()
        }
    }
}

impl Curve {
    /// A line through points.
    pub fn line(colour: RGBColor, points: Vec<Point>) -> Self {
        Self {
            colour,
            points,
            ..Self::default()
        }
    }

    /// Points that no line joins.
    pub fn dots(colour: RGBColor, marks: Vec<Point>) -> Self {
        Self {
            colour,
            marks,
            ..Self::default()
        }
    }

    /// A line through points that are marked where they are few.
    pub fn marked(colour: RGBColor, points: Vec<Point>, most_marks: usize) -> Self {
        let few = points.len() <= most_marks;
        Self {
            marks: if few { points.clone() } else { Vec::new() },
            ..Self::line(colour, points)
        }
    }

    /// The envelope of a curve of any length.
    pub fn envelope(colour: RGBColor, points: impl IntoIterator<Item = Point>) -> Self {
        let mut envelope = Decimator::new(BUCKETS);
        for (at, value) in points {
            envelope.push(at, value);
        }
        Self::line(colour, envelope.points().collect())
    }
}

/// Colours of Okabe & Ito (2008) that are told apart by every kind of colour vision.
const PALETTE: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];

/// Text and axes.
const INK: RGBColor = RGBColor(40, 40, 40);
/// Grid.
const GRID: RGBColor = RGBColor(225, 225, 225);
/// What others are measured by, and what is not stable.
pub(in crate::report) const GREY: RGBColor = RGBColor(150, 150, 150);
/// Paper, and text on dark maps.
pub(in crate::report) const WHITE: RGBColor = RGBColor(255, 255, 255);

/// Number of colours before they begin anew.
pub(in crate::report) const COLOURS: usize = PALETTE.len();

/// Colour number `index` of things without an order.
pub(in crate::report) fn distinct(index: usize) -> RGBColor {
    PALETTE[index % COLOURS]
}

/// Colour number `index` of `count` values in their order: blue over green to yellow.
pub(in crate::report) fn graded(index: usize, count: usize) -> RGBColor {
    /// The colour map viridis in five anchors (Smith & van der Walt, 2015).
    const ANCHORS: [[f64; 3]; 5] = [
        [68.0, 1.0, 84.0],
        [59.0, 82.0, 139.0],
        [33.0, 145.0, 140.0],
        [94.0, 201.0, 98.0],
        [215.0, 205.0, 40.0],
    ];
    let steps = count.saturating_sub(1).max(1);
    let place = (ANCHORS.len() - 1) as f64 * index as f64 / steps as f64;
    let below = (place as usize).min(ANCHORS.len() - 2);
    let part = place - below as f64;
    let mixed = |k: usize| ANCHORS[below][k] * (1.0 - part) + ANCHORS[below + 1][k] * part;
    let [red, green, blue] = [0, 1, 2].map(|k| mixed(k).round() as u8);
    RGBColor(red, green, blue)
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
}
