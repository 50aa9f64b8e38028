//! Spectra as people of signal processing ask for them: scalings, windows, averages, orders,
//! envelopes, whirls, cross spectra.

mod envelope;
mod envelope_lines;
mod interpolation;
mod request;
mod signal;
mod welch;

use std::borrow::Cow;

pub use envelope::Envelopes;
pub use request::{
    Axis, EnvelopeLine, EstimateError, EstimatedSpectrum, Resampling, Scaling, Segment,
    SpectrumColumn, SpectrumKind, SpectrumQuantity, SpectrumRequest,
};
pub use welch::{Detrend, Welch};

use super::kurtogram::impulsive_band;
use super::spectrum::FEWEST_SAMPLES;
use super::{Channel, ChannelCheck, Leak, NoiseFloor, Recording, TopPower, Window, leak};
use interpolation::{AngleGrid, Interpolation, Turning};
use request::rate_of;
use signal::{EnvelopeSignal, Signal};

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
    let record = Record::of(recording, request)?;
    let segment = record.segment(request)?;
    // a product such as 0.7 · 10 is no whole number
    let overlap = (request.overlap * segment as f64 * (1.0 + 1e-12)).floor();
    let welch = Welch::new(request.window, segment, overlap as usize, request.detrend);
    let resolution = record.rate / segment as f64;
    let mut found = Columns {
        request,
        record: &record,
        welch: &welch,
        bandwidth: request.window.equivalent_noise_bandwidth() * resolution,
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
        noise_bandwidth: found.bandwidth,
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

/// The signals of a request, at equal steps of its axis.
struct Record<'a> {
    signals: Vec<Source<'a>>,
    /// Samples per second or revolution.
    rate: f64,
    /// Samples per revolution of constant speed, zero where there is none.
    per_revolution: f64,
    /// Times of the first and of the last sample, s.
    span: [f64; 2],
    resampling: Option<Resampling>,
}

impl<'a> Record<'a> {
    fn of(recording: &'a Recording, request: &SpectrumRequest) -> Result<Self, EstimateError> {
        match (request.axis, recording.grid.per_revolution) {
            (Axis::Order, None) => Self::resampled(recording, request),
            _ => Ok(Self::as_recorded(recording, request)),
        }
    }

    fn as_recorded(recording: &'a Recording, request: &SpectrumRequest) -> Self {
        let grid = recording.grid;
        let recorded = recording.length();
        let skipped = skipped(recording);
        let source = |channel: &Channel| Source::of(recording, request, *channel);
        let time = |sample: usize| recording.start() + sample as f64 / grid.rate;
        let per_revolution = match grid.per_revolution {
            Some(samples) => f64::from(samples),
            None if grid.shaft_frequency > 0.0 => grid.rate / grid.shaft_frequency,
            None => 0.0,
        };
        Self {
            signals: request.channels.iter().map(source).collect(),
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
        let mut signals = Vec::new();
        let mut errors = Vec::new();
        for channel in &request.channels {
            let source = Source::of(recording, request, *channel);
            let envelope;
            let interpolation = match (&source, rate_of(*channel)) {
                (Source::Samples(values), Some(of)) if !recording.channel(of).is_empty() => {
                    Interpolation::Rates {
                        values,
                        rates: &recording.channel(of)[skipped..],
                        interval: 1.0 / rate,
                    }
                }
                (Source::Samples(values), _) => Interpolation::Values(values),
                // of an envelope no rates are known
                (Source::Envelope { of, rate, band }, _) => {
                    envelope = EnvelopeSignal::new(of, *rate, *band).collect();
                    Interpolation::Values(&envelope)
                }
            };
            errors.push((*channel, interpolation.error()));
            let positions = angles.positions.iter();
            let values =
                positions.map(|position| interpolation.at(position.index, position.fraction));
            signals.push(Source::Samples(values.collect::<Vec<_>>().into()));
        }
        let time = |position: f64| start + position / rate;
        let ends = [angles.positions.first(), angles.positions.last()];
        let ends = ends.map(|position| position.map_or(0.0, |at| at.index as f64 + at.fraction));
        let per_revolution = (angles.per_revolution * angles.oversampling) as f64;
        Ok(Self {
            signals,
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

    fn length(&self) -> usize {
        let lengths = self.signals.iter().map(Source::length);
        lengths.min().unwrap_or(0)
    }

    /// Samples of a segment.
    fn segment(&self, request: &SpectrumRequest) -> Result<usize, EstimateError> {
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
    fn bins(&self, segment: usize) -> usize {
        let oversampling = self.resampling.as_ref().map_or(1, |by| by.oversampling);
        segment / (2 * oversampling) + 1
    }
}

/// Samples at the start that are left out: on a grid of angle the others are whole revolutions.
fn skipped(recording: &Recording) -> usize {
    recording.length() % recording.grid.block()
}

/// What the spectrum of a channel is taken of: of samples on a grid of angle, whole revolutions.
enum Source<'a> {
    /// Samples, as recorded or at equal angles.
    Samples(Cow<'a, [f64]>),
    /// The envelope in a band in Hz of so many samples a second.
    Envelope {
        of: &'a [f64],
        rate: f64,
        band: [f64; 2],
    },
}

impl<'a> Source<'a> {
    fn of(recording: &'a Recording, request: &SpectrumRequest, channel: Channel) -> Self {
        let of = &recording.channel(channel)[skipped(recording)..];
        match request.kind {
            SpectrumKind::Envelope { band } => {
                let rate = recording.grid.rate;
                Self::Envelope { of, rate, band }
            }
            _ => Self::Samples(of.into()),
        }
    }

    fn length(&self) -> usize {
        match self {
            Self::Samples(samples) => samples.len(),
            Self::Envelope { of, .. } => of.len(),
        }
    }

    /// The samples of what is no envelope as recorded.
    fn samples(&self) -> &[f64] {
        match self {
            Self::Samples(samples) => samples,
            Self::Envelope { .. } => &[],
        }
    }
}

/// Makes the columns of one spectrum.
struct Columns<'a> {
    request: &'a SpectrumRequest,
    record: &'a Record<'a>,
    welch: &'a Welch,
    /// Equivalent noise bandwidth in units of the axis.
    bandwidth: f64,
    /// Bins of a one-sided spectrum.
    bins: usize,
    floor: NoiseFloor,
    columns: Vec<SpectrumColumn>,
    checks: Vec<ChannelCheck>,
}

impl Columns<'_> {
    fn fill(&mut self) {
        let record = self.record;
        let channels = self.request.channels.iter().copied();
        let sources: Vec<(Channel, &Source)> = channels.zip(&record.signals).collect();
        match self.request.kind {
            SpectrumKind::Plain
            | SpectrumKind::Envelope { .. }
            | SpectrumKind::ImpulsiveEnvelope => {
                for (channel, source) in sources {
                    match source {
                        Source::Samples(samples) => self.plain(channel, &mut &samples[..]),
                        Source::Envelope { of, rate, band } => {
                            self.plain(channel, &mut EnvelopeSignal::new(of, *rate, *band));
                        }
                    }
                }
            }
            SpectrumKind::Whirl => {
                let pairs = sources.chunks_exact(2);
                pairs.for_each(|pair| self.whirl(pair[0], pair[1]));
            }
            SpectrumKind::Cross => {
                let others = sources.iter().skip(1);
                others.for_each(|other| self.cross(sources[0], *other));
            }
        }
    }

    fn add(&mut self, quantity: SpectrumQuantity, values: Vec<f64>) {
        self.columns.push(SpectrumColumn { quantity, values });
    }

    fn is_averaged(&self) -> bool {
        self.welch.averages(self.record.length()) > 1
    }

    fn value(&self, power: f64, sides: f64) -> f64 {
        self.request.scaling.value(power, sides, self.bandwidth)
    }

    fn one_sided(&self, powers: &[f64]) -> Vec<f64> {
        let powers = powers.iter().take(self.bins).enumerate();
        powers
            .map(|(k, power)| self.value(*power, self.welch.sides(k)))
            .collect()
    }

    /// The spectrum of a channel and, where it is of one segment and an amplitude, its phase.
    fn plain(&mut self, channel: Channel, signal: &mut impl Signal) {
        let has_phase = !self.is_averaged() && !self.request.scaling.is_square();
        let [powers, mut phases] = match has_phase {
            true => self.welch.power_and_phase(signal),
            false => [self.welch.power(signal), Vec::new()],
        };
        self.checks.push(ChannelCheck {
            channel,
            top_power: self.top_power(channel, &powers, signal),
            leak: self.leak(channel, &powers),
        });
        let mut values = self.one_sided(&powers);
        phases.truncate(self.bins);
        if signal.is_at_rest(self.floor.below(channel)) {
            values.fill(0.0);
            phases.fill(0.0);
        }
        self.add(SpectrumQuantity::Value(channel), values);
        if has_phase {
            self.add(SpectrumQuantity::Phase(channel), phases);
        }
    }

    /// What the channel itself, not its envelope, holds near half the sampling rate. Without a window
    /// the skirts of lines and of ends that do not meet reach up to there: Hann's is taken for it.
    fn top_power(
        &self,
        channel: Channel,
        powers: &[f64],
        signal: &mut impl Signal,
    ) -> Option<TopPower> {
        let is_plain = self.request.kind == SpectrumKind::Plain;
        if !is_plain || self.record.resampling.is_some() {
            return None;
        }
        let (welch, rest) = (self.welch, self.floor.below(channel));
        let of = |powers: &[f64], window| {
            let powers = powers.iter().enumerate();
            let powers: Vec<f64> = powers.map(|(k, power)| welch.sides(k) * power).collect();
            TopPower::of(&powers, rest, window)
        };
        Some(match self.request.window {
            Window::Rectangular => {
                let window = Window::Hann;
                let detrend = self.request.detrend;
                let hann = Welch::new(window, welch.length, welch.overlap, detrend);
                of(&hann.power(signal), window)
            }
            window => of(powers, window),
        })
    }

    fn leak(&self, channel: Channel, powers: &[f64]) -> Option<Leak> {
        if self.request.window != Window::Rectangular {
            return None;
        }
        let powers = powers.iter().take(self.bins).enumerate();
        let peaks = powers.map(|(k, power)| self.welch.sides(k) * power.sqrt());
        leak(&peaks.collect::<Vec<_>>(), self.floor.below(channel))
    }

    /// Bins below zero frequency of a two-sided spectrum.
    fn below(&self) -> usize {
        (self.welch.length / 2).min(self.bins - 1)
    }

    fn whirl(&mut self, (x, x_source): (Channel, &Source), (y, y_source): (Channel, &Source)) {
        let powers = self.welch.rotary(x_source.samples(), y_source.samples());
        let skipped = self.welch.length / 2 - self.below();
        let kept = powers.iter().skip(skipped).take(self.below() + self.bins);
        let values = kept.map(|power| self.value(*power, 1.0)).collect();
        self.add(SpectrumQuantity::Rotary(x, y), values);
    }

    fn cross(&mut self, (reference, x): (Channel, &Source), (other, y): (Channel, &Source)) {
        let found = self.welch.cross(x.samples(), y.samples());
        let bins = 0..self.bins;
        let magnitudes: Vec<f64> = found.cross.iter().map(|bin| bin.norm()).collect();
        let magnitudes = self.one_sided(&magnitudes);
        let phases = bins.clone().map(|k| found.cross[k].arg()).collect();
        self.add(SpectrumQuantity::Cross(reference, other), magnitudes);
        self.add(SpectrumQuantity::CrossPhase(reference, other), phases);
        if self.is_averaged() {
            let coherence = bins.map(|k| found.coherence(k)).collect();
            self.add(SpectrumQuantity::Coherence(reference, other), coherence);
        }
    }
}
