//! What a run takes, known before it begins.

use super::{Model, SimulateError, sampling};
use crate::analysis::{Segment, SpectrumRequest};
use crate::rotor::Rotor;

/// Bytes of what does not grow with the duration: program, page, figures, blocks of samples.
const FLAT: f64 = 24e6;
/// Bytes of a number.
const NUMBER: f64 = 8.0;
/// Numbers a sample that are kept while a spectrum of the whole record is taken: the transform and its argument.
const TRANSFORM: f64 = 8.0;
/// Numbers a sample of a segment that an estimated spectrum keeps of each of its channels.
const ESTIMATED: f64 = 3.0;
/// Numbers a sample that the maps of a run-up keep.
const MAPS: f64 = 3.0;

/// What a run takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunSize {
    /// Samples.
    pub samples: u64,
    /// Columns that are kept in memory for the spectra.
    pub columns: usize,
    /// Memory, bytes: of the run alone, somewhat more than it turns out to take.
    pub memory: f64,
}

impl RunSize {
    /// Of a model.
    ///
    /// # Errors
    /// [`SimulateError`] where it cannot be run at all.
    pub fn of(model: &Model) -> Result<Self, SimulateError> {
        let rotor = Rotor::assemble(&model.rotor)?;
        let grid = sampling::grid(model, &rotor)?;
        let recording = sampling::recording(model, &rotor);
        let columns = recording.map_or(0, |recording| recording.columns());
        let rate = 1.0 / grid.interval;
        let recorded = (model.duration - model.settle) * rate + 1.0;
        let mut numbers = columns as f64 * recorded;
        if model.spectrum.is_some() {
            numbers += (columns as f64 + TRANSFORM) * recorded;
        }
        let requests = model.spectra.iter();
        let estimated = requests.map(|request| {
            let segment = segment_samples(request, recorded, rate, rotor.highest_speed());
            ESTIMATED * request.channels.len() as f64 * segment + TRANSFORM * recorded
        });
        numbers += estimated.sum::<f64>();
        if model.analyses.maps {
            numbers += MAPS * grid.count as f64;
        }
        Ok(Self {
            samples: grid.count,
            columns,
            memory: FLAT + NUMBER * numbers,
        })
    }
}

/// Samples of a segment, at most those that are recorded.
fn segment_samples(request: &SpectrumRequest, recorded: f64, rate: f64, highest: f64) -> f64 {
    let samples = match request.segment {
        Segment::Whole => recorded,
        Segment::Seconds(seconds) => seconds * rate,
        Segment::Samples(count) => count as f64,
        Segment::Revolutions(count) => f64::from(count) * std::f64::consts::TAU / highest * rate,
    };
    samples.min(recorded)
}
