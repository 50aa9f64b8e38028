//! Places of the shaft over the axis of a study.

use std::path::Path;

use super::digest::Digest;
use super::figures::HEIGHT;
use crate::report::figure::{Axis, Curve, Figure, Mark, Panel, Point, distinct, padded};
use crate::report::terminal::MICRO;
use crate::report::{FileAction, ReportError};

/// Value of the axis and place, and whether the run was come to from above.
type Place = (Point, bool);

impl Digest {
    /// Places of the shaft over the only axis.
    pub(super) fn bifurcation(
        &self,
        title: &str,
        points: &Path,
    ) -> Result<Option<Figure>, ReportError> {
        let [axis] = &self.axes[..] else {
            return Ok(None);
        };
        let Some([low, high]) = self.ends(0) else {
            return Ok(None);
        };
        let (name, places) = self.places(points)?;
        let dots = |down: bool| {
            let places = places.iter().filter(|(_, of)| *of == down);
            Curve {
                mark: Mark::Spot,
                ..Curve::dots(
                    distinct(usize::from(down)),
                    places.map(|(place, _)| *place).collect(),
                )
            }
        };
        let heights = places.iter().map(|((_, place), _)| *place);
        let panel = Panel {
            curves: vec![dots(false), dots(true)],
            ..Panel::new(
                Axis::over(axis, low..high),
                Axis::around(name, heights),
                HEIGHT,
            )
        };
        Ok(Some(Figure::new("bifurcation.svg", title, 1, vec![panel])))
    }

    /// Of the displacement that is spread most: axis value, place in µm, and direction.
    fn places(&self, points: &Path) -> Result<(String, Vec<Place>), ReportError> {
        let refused = |error: csv::Error| {
            let error = std::io::Error::other(error.to_string());
            ReportError::file(FileAction::Read, points)(error)
        };
        let mut reader = csv::Reader::from_path(points).map_err(refused)?;
        let names = reader.headers().map_err(refused)?.clone();
        let lengths: Vec<_> = (2..names.len())
            .filter(|k| names[*k].ends_with("_m"))
            .collect();
        let mut rows = self.rows.iter().peekable();
        let mut found = Vec::new();
        for record in reader.records() {
            let record = record.map_err(refused)?;
            let run: u64 = record[0].parse().unwrap_or(0);
            while rows.next_if(|row| row.run < run).is_some() {}
            if let Some(row) = rows.peek().filter(|row| row.run == run) {
                let places: Vec<f64> = lengths
                    .iter()
                    .map(|k| MICRO * record[*k].parse().unwrap_or(f64::NAN))
                    .collect();
                found.push((row.values[0], places, row.down));
            }
        }
        let spread = |k: &usize| {
            let range = padded(found.iter().map(|(_, places, _)| places[*k]));
            range.end - range.start
        };
        let widest = (0..lengths.len())
            .max_by(|a, b| spread(a).total_cmp(&spread(b)))
            .unwrap_or(0);
        let name = lengths
            .get(widest)
            .map_or("", |k| names[*k].trim_end_matches("_m"));
        let places = found
            .iter()
            .map(|(at, places, down)| ((*at, places[widest]), *down));
        Ok((format!("{name} in µm"), places.collect()))
    }
}
