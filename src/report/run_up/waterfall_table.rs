//! The table `waterfall`: one row a short-time spectrum and frequency.

use super::super::columns::amplitude_column;
use super::super::table::Column;
use super::super::{ReportError, RunFolder, WholeFile};
use crate::analysis::Waterfall;

/// Writes time, mean speed and frequency, then the amplitude of every channel.
pub(super) fn write(
    waterfall: &Waterfall,
    folder: &RunFolder,
) -> Result<Vec<WholeFile>, ReportError> {
    let mut columns = ["t_s", "speed_rad_s", "f_Hz"].map(Column::number).to_vec();
    let channels = waterfall.channels.iter();
    columns.extend(channels.map(|channel| Column::number(amplitude_column(*channel))));
    folder.write_rows("waterfall", &columns, |take| {
        let mut row = Vec::new();
        for slice in &waterfall.slices {
            for k in 0..waterfall.bins() {
                row.clear();
                row.extend([slice.time, slice.speed, k as f64 * waterfall.resolution]);
                row.extend(slice.amplitude.iter().map(|amplitude| amplitude[k]));
                take(&row)?;
            }
        }
        Ok(())
    })
}
