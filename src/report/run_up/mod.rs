//! A run whose speed changes: its waterfall and its order tracks.

mod order_tracks;
mod raster;
mod waterfall_csv;
mod waterfall_figure;

use serde_json::{Value, json};

use super::{ReportError, RunFolder, WholeFile};
use crate::simulate::Maps;

/// Writes both tables, and both figures where they are drawn.
pub(super) fn write_maps(
    folder: &RunFolder,
    title: &str,
    maps: &Maps,
    figures: bool,
) -> Result<Vec<WholeFile>, ReportError> {
    let mut files = vec![
        folder.write_with("waterfall.csv", |file| {
            waterfall_csv::write(&maps.waterfall, file)
        })?,
        folder.write_with("order_tracks.csv", |file| {
            order_tracks::write(&maps.tracks, file)
        })?,
    ];
    if figures && !maps.waterfall.slices.is_empty() {
        let svg = waterfall_figure::draw(title, maps)?;
        files.push(folder.write("waterfall.svg", svg.as_bytes())?);
    }
    if figures && !maps.tracks.points.is_empty() {
        let svg = order_tracks::figure(title, &maps.tracks)?;
        files.push(folder.write("order_tracks.svg", svg.as_bytes())?);
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
