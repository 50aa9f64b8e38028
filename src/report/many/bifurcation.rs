//! Places of the shaft over the axis of a study.

use super::digest::{Digest, is_down};
use super::figures::HEIGHT;
use super::rows::Rows;
use crate::report::ReportError;
use crate::report::figure::{Axis, Curve, Figure, Mark, Panel, Point, distinct, padded};
use crate::report::terminal::{MICRO, shown_column};
use crate::report::variable::axis_label;

/// Places of the shaft, and the run that each is of.
type Places = (Vec<Point>, Vec<u64>);

/// Most places of the shaft that are drawn, about: of more, those of every so many runs.
const MOST_PLACES: usize = 200_000;

impl Digest {
    /// Places of the shaft over the only axis: the displacement that is spread most, by direction.
    pub(super) fn bifurcation(&self, rows: &Rows) -> Result<Option<Figure>, ReportError> {
        let head = &self.head;
        let ([axis], Some([low, high])) = (&head.axes[..], self.ends(0)) else {
            return Ok(None);
        };
        let lengths = head.lengths();
        // of every displacement: value of the axis and place in µm, up and down
        let mut found = vec![<[Places; 2]>::default(); lengths.len()];
        let every = self.points.div_ceil(MOST_PLACES).max(1);
        let drawn = self.rows.iter().step_by(every).map(|row| row.run);
        rows.each_of(drawn, |row| {
            let at = self.at(&row, 0);
            for point in row.outcome.iter().flat_map(|outcome| &outcome.points) {
                for (places, (index, _)) in found.iter_mut().zip(&lengths) {
                    let (points, runs) = &mut places[usize::from(is_down(&row))];
                    points.push((at, MICRO * point.displacement[*index]));
                    runs.push(row.run);
                }
            }
        })?;
        let range = |places: &[Places; 2]| {
            let points = places.iter().flat_map(|(points, _)| points);
            padded(points.map(|point| point.1))
        };
        let spread = |places: &[Places; 2]| {
            let range = range(places);
            range.end - range.start
        };
        let found = found.into_iter().zip(lengths);
        let found = found.filter(|(places, _)| places.iter().any(|(points, _)| !points.is_empty()));
        let widest = found.max_by(|(a, _), (b, _)| spread(a).total_cmp(&spread(b)));
        let Some((places, (_, channel))) = widest else {
            return Ok(None);
        };
        let (label, _) = shown_column(&channel.column());
        let heights = Axis::over(label, range(&places));
        let places = places.into_iter().enumerate();
        let dots = places.map(|(down, (points, runs))| Curve {
            mark: Mark::Spot,
            // where both ways meet both are seen
            beside: 2 * down as u8,
            runs,
            ..Curve::dots(distinct(down), points)
        });
        let panel = Panel {
            curves: dots.collect(),
            ..Panel::new(Axis::around(axis_label(axis), [low, high]), heights, HEIGHT)
        };
        let figure = Figure::new("bifurcation", &head.title, 1, vec![panel]);
        Ok(Some(figure.with_names(self.directions())))
    }
}
