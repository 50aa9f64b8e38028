//! What is drawn of static answers over the only axis: stiffness, and deformation and contact angles around every
//! bearing.

use super::digest::{Digest, number};
use super::rows::Rows;
use crate::keys;
use crate::report::ReportError;
use crate::report::figure::{
    Axis, Curve, Figure, Name, Panel, all_around, distinct, graded, turned,
};
use crate::report::terminal::{MICRO, of_bearing, shown_column};
use crate::report::variable::{axis_label, shown};
use crate::study::Variable;
use crate::study::many::{Ask, Place, RunRecord};

/// Height of a plot, px.
const HEIGHT: u32 = 272;
/// Most points of a curve that are marked.
const MOST_MARKS: usize = 40;
/// Most values that are named.
const MOST_NAMES: usize = 8;
/// Most values whose curves around a bearing are drawn, about.
const MOST_CURVES: usize = 100;

impl Digest {
    /// The figures of static answers.
    pub(super) fn standing(&self, rows: &Rows) -> Result<Vec<Figure>, ReportError> {
        let ([variable], Ask::Bearing, false) =
            (&self.head.axes[..], self.head.ask, self.head.drawn)
        else {
            return Ok(Vec::new());
        };
        let every = self.rows.len().div_ceil(MOST_CURVES).max(1);
        let runs = self.rows.iter().step_by(every).map(|row| row.run);
        let mut all = Vec::new();
        rows.each_of(runs, |row| all.push(row))?;
        let around = Around::new(&self.head.title, variable, &all);
        let around = [around.deformation(), around.contact_angle()];
        let around = around
            .into_iter()
            .filter(|figure| !figure.panels.is_empty());
        Ok(self.stiffness(variable).into_iter().chain(around).collect())
    }

    /// The diagonal of the stiffness against the variable, a panel each.
    fn stiffness(&self, variable: &Variable) -> Option<Figure> {
        let columns = keys::diagonal_columns().map(|column| self.column(&column.name()));
        let columns: Vec<usize> = columns.into_iter().collect::<Option<_>>()?;
        let values = self.rows.iter().map(|row| self.at(row, 0));
        let axis = Axis::spanning(axis_label(variable), values);
        let panels = columns.iter().enumerate().map(|(index, column)| {
            let (label, factor) = shown_column(&self.columns[*column].column);
            let rows = self.rows.iter();
            let points = rows.map(|row| (self.at(row, 0), factor * number(row, *column)));
            let mut points: Vec<_> = points.collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            let curve = Curve::marked(distinct(index), points, MOST_MARKS);
            Panel::holding(axis.clone(), label, HEIGHT, vec![curve])
        });
        Some(Figure::new(
            "stiffness",
            &self.head.title,
            2,
            panels.collect(),
        ))
    }
}

/// Places around every bearing, a curve a value of the variable.
struct Around<'a> {
    title: &'a str,
    /// What the colours of the values mean; of many, of some.
    names: Vec<Name>,
    /// The places of every value.
    answers: Vec<&'a [Place]>,
    /// Number of bearings.
    bearings: usize,
}

impl<'a> Around<'a> {
    fn new(title: &'a str, variable: &Variable, rows: &'a [RunRecord]) -> Self {
        let values: Vec<f64> = rows.iter().map(|row| row.values[0]).collect();
        let outcomes = rows.iter().flat_map(|row| &row.outcome);
        let answers: Vec<_> = outcomes.map(|outcome| &outcome.around[..]).collect();
        let bearings = answers
            .iter()
            .flat_map(|places| places.iter().map(|place| place.bearing));
        let count = values.len();
        let shown_names = shown_names(count);
        let indices = (0..shown_names).map(|place| place * (count - 1) / (shown_names - 1).max(1));
        let name = |index: usize| Name::new(shown(variable, values[index]), graded(index, count));
        Self {
            title,
            names: indices.map(name).collect(),
            bearings: bearings.max().unwrap_or(0),
            answers,
        }
    }

    /// Deformation around every bearing; left as it is, right less its mean.
    fn deformation(&self) -> Figure {
        let value = |place: &Place| MICRO * place.number("deformation");
        let panels = (1..=self.bearings).flat_map(|bearing| {
            let curves = self.curves(bearing, value);
            let change = less_mean(&curves, "δ less its mean in µm");
            [self.panel(bearing, "deformation δ in µm", curves), change]
        });
        self.figure("deformation", panels.collect())
    }

    /// Contact angles around every bearing; inner race left, outer race right, each as it is and below that less its
    /// mean.
    fn contact_angle(&self) -> Figure {
        let panels = (1..=self.bearings).flat_map(|bearing| {
            let inner = self.curves(bearing, |at| at.number("angle_inner").to_degrees());
            let outer = self.curves(bearing, |at| at.number("angle_outer").to_degrees());
            let changes = [
                less_mean(&inner, "inner α less its mean in deg"),
                less_mean(&outer, "outer α less its mean in deg"),
            ];
            let whole = [
                self.panel(bearing, "inner angle α in deg", inner),
                self.panel(bearing, "outer angle α in deg", outer),
            ];
            whole.into_iter().chain(changes)
        });
        self.figure("contact_angle", panels.collect())
    }

    fn figure(&self, file: &str, panels: Vec<Panel>) -> Figure {
        Figure::new(file, self.title, 2, panels).with_names(self.names.clone())
    }

    /// One quantity around a bearing, each of its rows by itself.
    fn curves(&self, bearing: usize, value: impl Fn(&Place) -> f64) -> Vec<Curve> {
        let mut curves = Vec::new();
        for (index, places) in self.answers.iter().enumerate() {
            let rows = places.chunk_by(|a, b| (a.bearing, a.row) == (b.bearing, b.row));
            for row in rows.filter(|row| row[0].bearing == bearing) {
                let points = row
                    .iter()
                    .map(|place| (place.number("azimuth"), value(place)));
                let colour = graded(index, self.answers.len());
                curves.push(Curve::line(colour, all_around(turned(points))));
            }
        }
        curves
    }

    fn panel(&self, bearing: usize, name: &str, curves: Vec<Curve>) -> Panel {
        let name = of_bearing(bearing - 1, self.bearings) + name;
        Panel::holding(Axis::azimuth(), name, HEIGHT, curves)
    }
}

/// Curves, each less its mean around the bearing: what the load across the shaft does,
/// however large the rest is.
fn less_mean(curves: &[Curve], name: &str) -> Panel {
    let curve = |curve: &Curve| {
        // the ends only close the turn
        let inner = curve.points.get(1..curve.points.len().max(2) - 1);
        let inner = inner.unwrap_or_default();
        let sum: f64 = inner.iter().map(|point| point.1).sum();
        let mean = sum / inner.len().max(1) as f64;
        let points = curve.points.iter().map(|(at, value)| (*at, value - mean));
        Curve::line(curve.colour, points.collect())
    };
    let curves = curves.iter().map(curve).collect();
    Panel::holding(Axis::azimuth(), name, HEIGHT, curves)
}

/// How many of `count` names are shown: of many, as many as can be evenly spaced ones.
fn shown_names(count: usize) -> usize {
    if count <= MOST_NAMES {
        return count;
    }
    let mut few = (4..=MOST_NAMES).rev();
    let even = few.find(|shown| (count - 1).is_multiple_of(shown - 1));
    even.unwrap_or(MOST_NAMES)
}

#[cfg(test)]
mod tests {
    use super::shown_names;

    #[test]
    fn of_many_names_evenly_spaced_ones_are_shown() {
        let shown = [1, 8, 9, 17, 21, 26, 24].map(shown_names);
        assert_eq!(shown, [1, 8, 5, 5, 6, 6, 8]);
    }
}
