//! The signals that a spectrum is estimated of, at equal steps of time or of the shaft's angle.

use std::borrow::Cow;

use super::error::EstimateError;
use super::estimated::Resampling;
use super::interpolation::{AngleGrid, Interpolation, Turning};
use super::request::{Axis, Segment, SpectrumKind, SpectrumRequest, rate_of};
use super::signal::EnvelopeSignal;
use crate::analysis::spectrum::FEWEST_SAMPLES;
use crate::analysis::{Channel, Recording};

/// The signals of a request, at equal steps of its axis.
pub(super) struct Record<'a> {
    pub signals: Signals<'a>,
    /// Samples per second or revolution.
    pub rate: f64,
    /// Samples per revolution of constant speed, zero where there is none.
    per_revolution: f64,
    /// Times of the first and of the last sample, s.
    pub span: [f64; 2],
    pub resampling: Option<Resampling>,
}

impl<'a> Record<'a> {
    pub fn new(recording: &'a Recording, request: &SpectrumRequest) -> Result<Self, EstimateError> {
        match (request.axis, recording.grid.per_revolution) {
            (Axis::Order, None) => Self::resampled(recording, request),
            _ => Ok(Self::as_recorded(recording, request)),
        }
    }

    fn as_recorded(recording: &'a Recording, request: &SpectrumRequest) -> Self {
        let grid = recording.grid;
        let recorded = recording.length();
        let skipped = skipped(recording);
        let time = |sample: usize| recording.start() + sample as f64 / grid.rate;
        let per_revolution = match grid.per_revolution {
            Some(samples) => f64::from(samples),
            None if grid.shaft_frequency > 0.0 => grid.rate / grid.shaft_frequency,
            None => 0.0,
        };
        Self {
            signals: Signals::new(recording, request),
            rate: match request.axis {
                Axis::Frequency => grid.rate,
                Axis::Order => per_revolution,
            },
            per_revolution,
            span: [skipped, recorded.saturating_sub(1)].map(time),
            resampling: None,
        }
    }

    fn resampled(
        recording: &'a Recording,
        request: &SpectrumRequest,
    ) -> Result<Self, EstimateError> {
        let rate = recording.grid.rate;
        let skipped = skipped(recording);
        let start = recording.start() + skipped as f64 / rate;
        let turning = Turning {
            angle: &recording.channel(Channel::Angle)[skipped..],
            speed: &recording.channel(Channel::Speed)[skipped..],
        };
        let angles = AngleGrid::new(turning, rate, start)?;
        let mut errors = Vec::new();
        let mut signals = Vec::new();
        for (channel, values) in request.channels.iter().zip(channels(recording, request)) {
            let rates = rate_of(*channel).map(|rate| recording.channel(rate));
            let envelope;
            let interpolation = match (request.kind, rates) {
                // of an envelope no rates are known
                (SpectrumKind::Envelope { band }, _) => {
                    envelope = EnvelopeSignal::new(values, rate, band).collect();
                    Interpolation::Values(&envelope)
                }
                (_, Some(rates)) if !rates.is_empty() => Interpolation::Rates {
                    values,
                    rates: &rates[skipped..],
                    interval: 1.0 / rate,
                },
                _ => Interpolation::Values(values),
            };
            errors.push((*channel, interpolation.error()));
            let positions = angles.positions.iter();
            let values =
                positions.map(|position| interpolation.at(position.index, position.fraction));
            signals.push(values.collect::<Vec<_>>().into());
        }
        let time = |position: f64| start + position / rate;
        let ends = [angles.positions.first(), angles.positions.last()];
        let ends = ends.map(|position| position.map_or(0.0, |at| at.index as f64 + at.fraction));
        let per_revolution = (angles.per_revolution * angles.oversampling) as f64;
        Ok(Self {
            signals: Signals::Samples(signals),
            rate: per_revolution,
            per_revolution,
            span: ends.map(time),
            resampling: Some(Resampling {
                per_revolution: angles.per_revolution,
                oversampling: angles.oversampling,
                coarse_share: angles.coarse_share,
                errors,
            }),
        })
    }

    /// Samples of the shortest signal.
    pub fn length(&self) -> usize {
        let shortest = match &self.signals {
            Signals::Samples(signals) => signals.iter().map(|samples| samples.len()).min(),
            Signals::Envelopes { of, .. } => of.iter().map(|samples| samples.len()).min(),
        };
        shortest.unwrap_or(0)
    }

    /// Samples of a segment.
    pub fn segment(&self, request: &SpectrumRequest) -> Result<usize, EstimateError> {
        let samples = self.length();
        let needed = match request.segment {
            Segment::Whole => samples.max(FEWEST_SAMPLES),
            Segment::Samples(count) => count,
            Segment::Seconds(_) if request.axis == Axis::Order => {
                return Err(EstimateError::SecondsOverOrders);
            }
            Segment::Seconds(seconds) => (seconds * self.rate).round() as usize,
            Segment::Revolutions(_) if self.per_revolution == 0.0 => {
                return Err(EstimateError::UnevenRevolutions);
            }
            Segment::Revolutions(turns) => {
                (f64::from(turns) * self.per_revolution).round() as usize
            }
        };
        if needed < FEWEST_SAMPLES {
            return Err(EstimateError::ShortSegment {
                samples: needed,
                needed: FEWEST_SAMPLES,
            });
        }
        if samples < needed {
            return Err(EstimateError::TooShort { samples, needed });
        }
        Ok(needed)
    }

    /// Bins of a one-sided spectrum that the sampling of time knows at every speed.
    pub fn bins(&self, segment: usize) -> usize {
        let oversampling = self.resampling.as_ref().map_or(1, |by| by.oversampling);
        segment / (2 * oversampling) + 1
    }
}

/// Samples at the start that are left out: on a grid of angle the others are whole revolutions.
fn skipped(recording: &Recording) -> usize {
    recording.length() % recording.grid.block()
}

/// What was recorded of each channel, without what is left out.
fn channels<'a>(
    recording: &'a Recording,
    request: &SpectrumRequest,
) -> impl Iterator<Item = &'a [f64]> {
    let skipped = skipped(recording);
    let channels = request.channels.iter();
    channels.map(move |channel| &recording.channel(*channel)[skipped..])
}

/// What the spectra are taken of, a signal a channel: of samples on a grid of angle, whole revolutions.
pub(super) enum Signals<'a> {
    /// Samples, as recorded or at equal angles.
    Samples(Vec<Cow<'a, [f64]>>),
    /// The envelopes, in a band in Hz, of so many samples a second.
    Envelopes {
        of: Vec<&'a [f64]>,
        rate: f64,
        band: [f64; 2],
    },
}

impl<'a> Signals<'a> {
    fn new(recording: &'a Recording, request: &SpectrumRequest) -> Self {
        let channels = channels(recording, request);
        match request.kind {
            SpectrumKind::Envelope { band } => Self::Envelopes {
                of: channels.collect(),
                rate: recording.grid.rate,
                band,
            },
            _ => Self::Samples(channels.map(Cow::from).collect()),
        }
    }
}
