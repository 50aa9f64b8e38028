//! The peaks of the spectra as CSV, each with what it is called.

use std::io::{self, Write};

use super::named_peak::NamedPeak;
use super::statics::{cell, number};
use crate::analysis::{Peak, Spectrum};

/// Columns of `peaks.csv`.
const COLUMNS: [&str; 12] = [
    "channel",
    "unit",
    "f_Hz",
    "order",
    "amplitude",
    "phase_rad",
    "name",
    "name_f_Hz",
    "distance_Hz",
    "distance_bins",
    "operating_f_Hz",
    "other_names",
];

/// Writes one row a peak, channel by channel, strongest first.
///
/// `distance` is that of the peak from its name's frequency, `operating_f_Hz` where the same line stands
/// with the cage rolling at the operating contact angle. Cells without a value are empty.
///
/// # Errors
/// What the writer answers.
pub fn write_peaks(peaks: &[Peak], spectrum: &Spectrum, writer: impl Write) -> io::Result<()> {
    let mut csv = csv::Writer::from_writer(writer);
    csv.write_record(COLUMNS)?;
    for peak in peaks {
        csv.write_record(row(NamedPeak::new(peak, Some(spectrum))))?;
    }
    csv.flush()
}

fn row(peak: NamedPeak<'_>) -> [String; 12] {
    [
        peak.channel.to_owned(),
        peak.unit.to_owned(),
        number(peak.frequency),
        cell(peak.order),
        number(peak.amplitude),
        number(peak.phase),
        peak.name.unwrap_or_default(),
        cell(peak.name_frequency),
        cell(peak.distance),
        cell(peak.distance_bins),
        cell(peak.operating),
        peak.other_names.join("; "),
    ]
}
