//! A run whose speed changes: its waterfall and its order tracks.

mod order_tracks;
mod raster;
mod waterfall_figure;
mod waterfall_table;

pub(in crate::report) use raster::{MOST_CELLS, Raster, moving};
pub(in crate::report) use waterfall_figure::runs_figure;

use serde::Serialize;

use super::{ReportError, RunFolder, WholeFile};
use crate::analysis::TrackedOrder;
use crate::simulate::Maps;

/// Writes both tables, and both figures where they are drawn.
pub(super) fn write_maps(
    folder: &RunFolder,
    title: &str,
    maps: &Maps,
    figures: bool,
) -> Result<Vec<WholeFile>, ReportError> {
    let mut files = waterfall_table::write(&maps.waterfall, folder)?;
    files.extend(order_tracks::write(&maps.tracks, folder)?);
    if figures && !maps.waterfall.slices.is_empty() {
        let figure = waterfall_figure::waterfall_figure(title, maps);
        files.push(folder.write_figure(&figure)?);
    }
    if figures && !maps.tracks.points.is_empty() {
        let figure = order_tracks::order_figure(title, &maps.tracks);
        files.push(folder.write_figure(&figure)?);
    }
    Ok(files)
}

/// What the maps of a run-up rest on.
#[derive(Debug, Serialize)]
pub(super) struct MapsSummary<'a> {
    waterfall: WaterfallSummary,
    order_tracks: TracksSummary<'a>,
}

/// How the short-time spectra were made.
#[derive(Debug, Serialize)]
struct WaterfallSummary {
    window: &'static str,
    window_s: f64,
    samples: usize,
    overlap_samples: usize,
    #[serde(rename = "resolution_Hz")]
    resolution: f64,
    /// Frequencies of a spectrum.
    frequencies: usize,
    /// Number of spectra.
    spectra: usize,
    scaling: &'static str,
}

/// How the orders were tracked.
#[derive(Debug, Serialize)]
struct TracksSummary<'a> {
    window: &'static str,
    window_revolutions: f64,
    points: usize,
    orders: &'a [TrackedOrder],
    scaling: &'static str,
}

impl<'a> From<&'a Maps> for MapsSummary<'a> {
    fn from(maps: &'a Maps) -> Self {
        let (waterfall, tracks) = (&maps.waterfall, &maps.tracks);
        Self {
            waterfall: WaterfallSummary {
                window: "hann",
                window_s: waterfall.window(),
                samples: waterfall.length,
                overlap_samples: waterfall.length - waterfall.hop,
                resolution: waterfall.resolution,
                frequencies: waterfall.bins(),
                spectra: waterfall.slices.len(),
                scaling: "one-sided, peak values; the mean is kept at frequency zero",
            },
            order_tracks: TracksSummary {
                window: "hann over the angle of the shaft",
                window_revolutions: tracks.revolutions,
                points: tracks.points.len(),
                orders: &tracks.orders,
                scaling: "peak values; phase of cos(order psi + phase), psi the angle of the shaft; mean \
                          and all orders fitted together by weighted least squares",
            },
        }
    }
}
