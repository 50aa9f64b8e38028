//! Figures: panels of curves, marks and cells over axes, told as data and drawn in one way.

mod axis;
mod colour;
mod draw;
mod layout;
mod png;
mod turn;

pub(super) use self::axis::{Axis, ends, padded, round_ticks};
pub(super) use self::colour::{COLOURS, GREY, WHITE, distinct, graded};
pub(super) use self::layout::PLOT_WIDTH;
pub(super) use self::turn::{all_around, turned};
use super::{Decimator, ReportError};
use plotters::style::RGBColor;

/// Points of a curve: more cannot be seen on the width of a figure.
pub(super) const CURVE_BUCKETS: usize = 2048;

/// A place in the units of the axes.
pub(super) type Point = (f64, f64);

/// A figure: a title, what its colours mean, and panels row by row.
#[derive(Debug, Clone)]
pub(super) struct Figure {
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
pub(super) struct Name {
    pub text: String,
    pub colour: RGBColor,
    /// What stands at the points of its curve, if that tells it apart.
    pub mark: Option<Mark>,
}

/// Curves and marks over two axes.
#[derive(Debug, Clone, Default)]
pub(super) struct Panel {
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
    /// Rectangles between two corners.
    pub cells: Vec<([Point; 2], RGBColor)>,
    /// What the colours of the cells mean: a bar of all of them along this axis.
    pub bar: Option<Axis>,
    /// A map that fills the plot.
    pub map: Option<Map>,
    pub curves: Vec<Curve>,
    /// Texts at their places.
    pub labels: Vec<(Point, String, RGBColor)>,
    /// Places with a name, which are left out where they would cover one before them.
    pub peaks: Vec<(Point, String)>,
    /// Lines that stand in the place of a plot.
    pub words: Vec<String>,
}

/// A line through points, and marks.
#[derive(Debug, Clone, Default)]
pub(super) struct Curve {
    pub colour: RGBColor,
    /// Points that straight lines join.
    pub points: Vec<Point>,
    /// Points that are marked.
    pub marks: Vec<Point>,
    /// How they are marked.
    pub mark: Mark,
    /// Whether the line is thin, for it covers itself many times over.
    pub fine: bool,
}

/// What marks a point.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Mark {
    /// One of many points.
    Spot,
    #[default]
    Dot,
    /// A dot that stands alone.
    Disc,
    Triangle,
}

/// Levels row by row from the top, 0 to 255, in the colours of [`graded`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Map {
    /// Levels in a row.
    pub width: usize,
    pub levels: Vec<u8>,
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
        let mut envelope = Decimator::new(CURVE_BUCKETS);
        for (at, value) in points {
            envelope.push(at, value);
        }
        Self::line(colour, envelope.points().collect())
    }
}
