//! Places of the shaft over the axis of a study.

use std::collections::BTreeSet;
use std::path::Path;

use plotters::prelude::*;

use super::digest::Digest;
use super::figures::{HEIGHT, padded};
use crate::report::figure::{GRID, INK, font, px, svg, tick_format};
use crate::report::figure_curves::distinct;
use crate::report::units::MICRO;
use crate::report::{FileAction, ReportError};

/// Value of the axis, place, and whether the run was come to from above.
type Place = (f64, f64, bool);

impl Digest {
    /// Places of the shaft over the only axis.
    pub(super) fn bifurcation(
        &self,
        title: &str,
        points: &Path,
    ) -> Result<Option<String>, ReportError> {
        let [axis] = &self.axes[..] else {
            return Ok(None);
        };
        let Some([low, high]) = self.ends(0) else {
            return Ok(None);
        };
        let (name, places) = self.places(points)?;
        let range = padded(places.iter().map(|(_, place, _)| *place));
        let drawn = svg("bifurcation.svg", HEIGHT, title, |area| {
            let mut chart = ChartBuilder::on(area)
                .margin(px(12))
                .set_label_area_size(LabelAreaPosition::Left, px(78))
                .set_label_area_size(LabelAreaPosition::Bottom, px(48))
                .build_cartesian_2d(low..high, range.clone())?;
            chart
                .configure_mesh()
                .bold_line_style(GRID)
                .light_line_style(TRANSPARENT)
                .x_label_formatter(&tick_format(high - low))
                .y_label_formatter(&tick_format(range.end - range.start))
                .x_desc(axis)
                .y_desc(&name)
                .axis_style(INK)
                .label_style(font(13))
                .axis_desc_style(font(14))
                .draw()?;
            // of points on one spot one is drawn: the file stays small
            let mut taken = BTreeSet::new();
            for (at, place, down) in &places {
                let spot = chart.backend_coord(&(*at, *place));
                if taken.insert((spot.0 / 2, spot.1 / 2, *down)) {
                    let colour = distinct(usize::from(*down));
                    chart.draw_series([Circle::new((*at, *place), 2, colour.filled())])?;
                }
            }
            Ok(())
        })?;
        Ok(Some(drawn))
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
            .map(|(at, places, down)| (*at, places[widest], *down));
        Ok((format!("{name} in µm"), places.collect()))
    }
}
