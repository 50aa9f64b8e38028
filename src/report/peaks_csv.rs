//! The peaks of the spectra as CSV, each with what it is called.

use std::io::{self, Write};

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
        csv.write_record(row(peak, spectrum))?;
    }
    csv.flush()
}

fn row(peak: &Peak, spectrum: &Spectrum) -> [String; 12] {
    let line = peak.line.as_ref();
    let order = (spectrum.shaft_frequency > 0.0).then(|| peak.frequency / spectrum.shaft_frequency);
    let distance = line.map(|line| peak.frequency - line.frequency);
    [
        peak.channel.name().to_owned(),
        peak.channel.unit().to_owned(),
        number(peak.frequency),
        cell(order),
        number(peak.amplitude),
        number(peak.phase),
        line.map(|line| line.kind.to_string()).unwrap_or_default(),
        cell(line.map(|line| line.frequency)),
        cell(distance),
        cell(distance.map(|distance| distance / spectrum.resolution)),
        cell(line.and_then(|line| line.operating)),
        other_names(peak).join("; "),
    ]
}

/// What else a peak could be called, nearest first.
pub(super) fn other_names(peak: &Peak) -> Vec<String> {
    let others = peak.others.iter();
    others.map(|line| line.kind.to_string()).collect()
}
