//! The strongest line of an envelope that nothing known causes.

use serde::Serialize;

use crate::analysis::{Axis, EstimatedSpectrum, SpectrumKind, noise_around};

/// Times the noise around it from which on a line without a name is reported.
const FAR_ABOVE: f64 = 20.0;

/// The strongest line of an envelope, which has no name.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct UnnamedLine {
    /// The spectrum.
    pub spectrum: String,
    /// What its axis is.
    pub axis: Axis,
    /// Where it is, Hz or orders.
    pub place: f64,
    /// How many times as high it is as the median of the bins around it.
    pub above_noise: f64,
}

/// Of every envelope whose strongest line is far above the noise and has no name, that line.
pub(super) fn found(spectra: &[EstimatedSpectrum]) -> Vec<UnnamedLine> {
    let is_envelope =
        |of: &&EstimatedSpectrum| matches!(of.request.kind, SpectrumKind::Envelope { .. });
    let envelopes = spectra.iter().filter(is_envelope);
    envelopes
        .flat_map(|spectrum| {
            let columns = spectrum.value_columns();
            columns.filter_map(|column| strongest_unnamed(spectrum, column))
        })
        .collect()
}

fn strongest_unnamed(spectrum: &EstimatedSpectrum, column: usize) -> Option<UnnamedLine> {
    let lines = spectrum.lines_above_noise(column).into_iter();
    let (place, _) = lines.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let is_it = |named: f64| (named - place).abs() < spectrum.resolution;
    let mut named = spectrum.lines.iter();
    if named.any(|line| line.column == column && is_it(line.place)) {
        return None;
    }
    let bin = (place / spectrum.resolution).round() as usize;
    let amplitudes = spectrum.amplitudes(column);
    let noise = noise_around(&amplitudes, bin).filter(|noise| *noise > 0.0)?;
    let above_noise = amplitudes[bin] / noise;
    (above_noise >= FAR_ABOVE).then(|| UnnamedLine {
        spectrum: spectrum.request.name.clone(),
        axis: spectrum.request.axis,
        place,
        above_noise,
    })
}
