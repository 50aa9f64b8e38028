//! The peaks of the spectra, each with what it is called.

use super::named_peak::NamedPeak;
use super::table::Table;
use crate::analysis::{Peak, Spectrum};

/// One row a peak, channel by channel, strongest first.
///
/// `distance` is that of the peak from its name's frequency, `operating_f_Hz` where the same line stands
/// with the cage rolling at the operating contact angle.
pub(super) fn peak_table(peaks: &[Peak], spectrum: &Spectrum) -> Table {
    let named = peaks
        .iter()
        .map(|peak| NamedPeak::new(peak, Some(spectrum)));
    let named: Vec<NamedPeak> = named.collect();
    let peaks = || named.iter();
    let mut table = Table::default();
    table.words("channel", peaks().map(|peak| peak.channel));
    table.words("unit", peaks().map(|peak| peak.unit));
    table.numbers("f_Hz", peaks().map(|peak| peak.frequency));
    table.numbers("order", peaks().map(|peak| peak.order));
    table.numbers("amplitude", peaks().map(|peak| peak.amplitude));
    table.numbers("phase_rad", peaks().map(|peak| peak.phase));
    table.words(
        "name",
        peaks().map(|peak| peak.name.as_deref().unwrap_or_default()),
    );
    table.numbers("name_f_Hz", peaks().map(|peak| peak.name_frequency));
    table.numbers("distance_Hz", peaks().map(|peak| peak.distance));
    table.numbers("distance_bins", peaks().map(|peak| peak.distance_bins));
    table.numbers("operating_f_Hz", peaks().map(|peak| peak.operating));
    table.words(
        "other_names",
        peaks().map(|peak| peak.other_names.join("; ")),
    );
    table
}
