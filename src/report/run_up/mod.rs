//! A run whose speed changes: its waterfall and its order tracks.

mod order_tracks;
mod raster;
mod waterfall_figure;
mod waterfall_table;

pub(in crate::report) use raster::{MOST_CELLS, Raster, moving};
pub(in crate::report) use waterfall_figure::runs_figure;

use serde_json::{Value, json};

use super::table::TableTarget;
use super::{ReportError, WholeFile};
use crate::simulate::Maps;

/// Writes both tables, and both figures where they are drawn.
pub(super) fn write_maps(
    target: TableTarget<'_>,
    title: &str,
    maps: &Maps,
    figures: bool,
) -> Result<Vec<WholeFile>, ReportError> {
    let mut files = waterfall_table::write(&maps.waterfall, target)?;
    files.extend(order_tracks::write(&maps.tracks, target)?);
    if figures && !maps.waterfall.slices.is_empty() {
        let figure = waterfall_figure::waterfall_figure(title, maps);
        files.push(target.folder.write_figure(&figure)?);
    }
    if figures && !maps.tracks.points.is_empty() {
        let figure = order_tracks::order_figure(title, &maps.tracks);
        files.push(target.folder.write_figure(&figure)?);
    }
    Ok(files)
}

/// What the tables rest on.
pub(super) fn maps_json(maps: &Maps) -> Value {
    let (waterfall, tracks) = (&maps.waterfall, &maps.tracks);
    json!({
        "waterfall": {
            "window": "hann",
            "window_s": waterfall.window(),
            "samples": waterfall.length,
            "overlap_samples": waterfall.length - waterfall.hop,
            "resolution_Hz": waterfall.resolution,
            "frequencies": waterfall.bins(),
            "spectra": waterfall.slices.len(),
            "scaling": "one-sided, peak values; the mean is kept at frequency zero",
        },
        "order_tracks": {
            "window": "hann over the angle of the shaft",
            "window_revolutions": tracks.revolutions,
            "points": tracks.points.len(),
            "orders": tracks
                .orders
                .iter()
                .map(|order| json!({ "name": order.name, "order": order.order }))
                .collect::<Value>(),
            "scaling": "peak values; phase of cos(order psi + phase), psi the angle of the shaft; mean \
                        and all orders fitted together by weighted least squares",
        },
    })
}
