//! Spectra as people of signal processing ask for them: scalings, windows, averages, orders,
//! envelopes, whirls, cross spectra.

mod columns;
mod envelope;
mod envelope_lines;
mod error;
mod estimated;
mod interpolation;
mod record;
mod request;
mod signal;
mod unit_product;
mod welch;

pub use envelope::Envelopes;
pub use error::EstimateError;
pub use estimated::{
    EnvelopeLine, EstimatedSpectrum, Resampling, SpectrumColumn, SpectrumQuantity,
};
pub use request::{Axis, Scaling, Segment, SpectrumKind, SpectrumRequest};
pub use welch::{Detrend, Welch};

use super::Recording;
use super::kurtogram::impulsive_band;
use columns::Columns;
use record::Record;

/// Estimates a spectrum of what was recorded for it.
///
/// On a grid of shaft angle the record is the largest whole number of revolutions, the last ones; on a
/// free grid of time it is all samples. Over orders a free grid of time is brought to equal angles by
/// interpolation, at angles so fine that what lower speeds hold above the highest order does not fold.
///
/// # Errors
/// [`EstimateError`] where the record does not hold what the request needs.
pub fn estimate(
    recording: &Recording,
    request: &SpectrumRequest,
) -> Result<EstimatedSpectrum, EstimateError> {
    let request = &with_band(recording, request);
    if request.kind == SpectrumKind::Cross && !request.scaling.is_square() {
        return Err(EstimateError::CrossAmplitude);
    }
    let record = Record::new(recording, request)?;
    let segment = record.segment(request)?;
    // a product such as 0.7 · 10 is no whole number
    let overlap = (request.overlap * segment as f64 * (1.0 + 1e-12)).floor();
    let welch = Welch::new(request.window, segment, overlap as usize, request.detrend);
    let resolution = record.rate / segment as f64;
    let noise_bandwidth = request.window.equivalent_noise_bandwidth() * resolution;
    let mut found = Columns {
        request,
        record: &record,
        welch: &welch,
        bandwidth: noise_bandwidth,
        bins: record.bins(segment),
        floor: recording.noise_floor(),
        columns: Vec::new(),
        checks: Vec::new(),
    };
    found.fill();
    let first = match request.kind {
        SpectrumKind::Whirl => -(found.below() as isize),
        _ => 0,
    };
    Ok(EstimatedSpectrum {
        request: request.clone(),
        span: record.span,
        samples: record.length(),
        rate: record.rate,
        shaft_frequency: recording.grid.shaft_frequency,
        segment,
        overlap: welch.overlap,
        averages: welch.averages(record.length()),
        resolution,
        noise_bandwidth,
        first,
        columns: found.columns,
        checks: found.checks,
        resampling: record.resampling,
        lines: Vec::new(),
    })
}

/// The request with the most impulsive band of its first channel, where it leaves that open; the whole range if the signal
/// has none.
fn with_band(recording: &Recording, request: &SpectrumRequest) -> SpectrumRequest {
    let mut request = request.clone();
    if request.kind == SpectrumKind::ImpulsiveEnvelope {
        let rate = recording.grid.rate;
        let first = request.channels.first();
        let samples = first.map_or(&[][..], |channel| recording.channel(*channel));
        let found = impulsive_band(samples, rate);
        let band = found.map_or([0.0, 0.5 * rate], |found| found.band);
        request.kind = SpectrumKind::Envelope { band };
    }
    request
}
