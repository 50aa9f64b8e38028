//! An estimated spectrum.

use super::request::{Axis, SpectrumRequest};
use super::unit_product::product;
use crate::analysis::{Channel, ChannelCheck, Line};

/// What a column of a spectrum holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SpectrumQuantity {
    /// A channel, in the scaling of the spectrum.
    Value(Channel),
    /// Phase in rad of `cos(2πft + phase)`, t from the start of the record.
    Phase(Channel),
    /// x + iy of two channels, in the scaling of the spectrum.
    Rotary(Channel, Channel),
    /// Magnitude of the cross power or density.
    Cross(Channel, Channel),
    /// Phase in rad by which the second channel leads the first.
    CrossPhase(Channel, Channel),
    /// Coherence, 0 … 1.
    Coherence(Channel, Channel),
}

/// A column of a spectrum.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SpectrumColumn {
    /// What it holds.
    pub quantity: SpectrumQuantity,
    /// One value a bin.
    pub values: Vec<f64>,
}

/// How a record was brought to equal shaft angles.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Resampling {
    /// Half of this is the highest order, samples per revolution.
    pub per_revolution: usize,
    /// The angles are this much finer than that.
    pub oversampling: usize,
    /// Share of the time in which the shaft is so slow that the angles are coarser than the samples:
    /// what is above half their rate folds there.
    pub coarse_share: f64,
    /// Error of the interpolation of every channel, relative to the root mean square of its vibration;
    /// `None` where the record is too short to tell.
    pub errors: Vec<(Channel, Option<f64>)>,
}

/// A spectrum as it was asked for.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct EstimatedSpectrum {
    /// What was asked for.
    pub(crate) request: SpectrumRequest,
    /// Times of the first and of the last sample, s.
    pub span: [f64; 2],
    /// Samples of the record.
    pub samples: usize,
    /// Samples a second, or per revolution over orders.
    pub rate: f64,
    /// Frequency of a shaft of constant speed, Hz; zero where it changes or is at rest.
    pub shaft_frequency: f64,
    /// Samples of a segment.
    pub segment: usize,
    /// Samples that it shares with the next.
    pub overlap: usize,
    /// Segments that were averaged.
    pub averages: usize,
    /// Distance of neighbouring bins, Hz or orders.
    pub resolution: f64,
    /// Equivalent noise bandwidth, Hz or orders.
    pub noise_bandwidth: f64,
    /// How the record was brought to equal angles, where it had to be.
    pub(crate) resampling: Option<Resampling>,
    /// Number of the first bin: negative where the spectrum is two-sided.
    pub first: isize,
    /// The columns, all of one length.
    pub columns: Vec<SpectrumColumn>,
    /// What sampling did to each channel that has a column of its own.
    pub(crate) checks: Vec<ChannelCheck>,
    /// Named lines of an envelope, strongest first in each column.
    pub lines: Vec<EnvelopeLine>,
}

/// A line of an envelope that has a name.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct EnvelopeLine {
    /// Number of its column.
    pub column: usize,
    /// Its position between the bins, Hz or orders.
    pub place: f64,
    /// Its value, in the scaling of the spectrum; between bins what it would be on one.
    pub value: f64,
    /// What causes it.
    pub line: Line,
}

impl EstimatedSpectrum {
    /// Number of bins.
    pub fn bins(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// Position of the bin of row `row`, Hz or orders.
    pub fn place(&self, row: usize) -> f64 {
        (self.first + row as isize) as f64 * self.resolution
    }

    /// Frequency of a row in Hz; none over orders of a speed that changes.
    pub fn frequency(&self, row: usize) -> Option<f64> {
        match self.request.axis {
            Axis::Frequency => Some(self.place(row)),
            Axis::Order => self.shaft().map(|shaft| self.place(row) * shaft),
        }
    }

    /// Shaft order of a row; none over frequencies of a speed that changes.
    pub fn order(&self, row: usize) -> Option<f64> {
        match self.request.axis {
            Axis::Order => Some(self.place(row)),
            Axis::Frequency => self.shaft().map(|shaft| self.place(row) / shaft),
        }
    }

    /// Frequency of a shaft of constant speed, Hz.
    fn shaft(&self) -> Option<f64> {
        Some(self.shaft_frequency).filter(|frequency| *frequency > 0.0)
    }

    /// Unit of a column, for instance `m`, `m^2` or `N m`; that of a density is per [`Axis::unit`]
    /// besides.
    pub fn unit(&self, quantity: SpectrumQuantity) -> String {
        match quantity {
            SpectrumQuantity::Value(channel) | SpectrumQuantity::Rotary(channel, _) => {
                match self.request.scaling.is_square() {
                    true => product(channel.unit(), channel.unit()),
                    false => channel.unit().to_owned(),
                }
            }
            SpectrumQuantity::Cross(reference, other) => product(reference.unit(), other.unit()),
            SpectrumQuantity::Phase(_) | SpectrumQuantity::CrossPhase(..) => "rad".to_owned(),
            SpectrumQuantity::Coherence(..) => "1".to_owned(),
        }
    }
}
