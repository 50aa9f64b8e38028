//! The columns of a spectrum, and what sampling did to each channel.

use super::estimated::{SpectrumColumn, SpectrumQuantity};
use super::record::{Record, Signals};
use super::request::{SpectrumKind, SpectrumRequest};
use super::signal::{EnvelopeSignal, Signal};
use super::welch::Welch;
use crate::analysis::{Channel, ChannelCheck, Leak, NoiseFloor, TopPower, Window, leak};

/// Makes the columns of one spectrum.
pub(super) struct Columns<'a> {
    pub request: &'a SpectrumRequest,
    pub record: &'a Record<'a>,
    pub welch: &'a Welch,
    /// Equivalent noise bandwidth in units of the axis.
    pub bandwidth: f64,
    /// Bins of a one-sided spectrum.
    pub bins: usize,
    pub floor: NoiseFloor,
    pub columns: Vec<SpectrumColumn>,
    pub checks: Vec<ChannelCheck>,
}

impl Columns<'_> {
    pub fn fill(&mut self) {
        let channels = self.request.channels.iter().copied();
        match &self.record.signals {
            Signals::Envelopes { of, rate, band } => {
                for (channel, samples) in channels.zip(of) {
                    self.plain(channel, &mut EnvelopeSignal::new(samples, *rate, *band));
                }
            }
            Signals::Samples(signals) => {
                let samples = signals.iter().map(|samples| &samples[..]);
                let signals: Vec<_> = channels.zip(samples).collect();
                self.fill_from(&signals);
            }
        }
    }

    fn fill_from(&mut self, signals: &[(Channel, &[f64])]) {
        match self.request.kind {
            SpectrumKind::Whirl => {
                let pairs = signals.chunks_exact(2);
                pairs.for_each(|pair| self.whirl(pair[0], pair[1]));
            }
            SpectrumKind::Cross => {
                let others = signals.iter().skip(1);
                others.for_each(|other| self.cross(signals[0], *other));
            }
            _ => {
                let signals = signals.iter();
                signals.for_each(|(channel, samples)| self.plain(*channel, &mut &samples[..]));
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
            TopPower::new(&powers, rest, window)
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
    pub fn below(&self) -> usize {
        (self.welch.length / 2).min(self.bins - 1)
    }

    fn whirl(&mut self, (x, xs): (Channel, &[f64]), (y, ys): (Channel, &[f64])) {
        let powers = self.welch.rotary(xs, ys);
        let skipped = self.welch.length / 2 - self.below();
        let kept = powers.iter().skip(skipped).take(self.below() + self.bins);
        let values = kept.map(|power| self.value(*power, 1.0)).collect();
        self.add(SpectrumQuantity::Rotary(x, y), values);
    }

    fn cross(&mut self, (reference, xs): (Channel, &[f64]), (other, ys): (Channel, &[f64])) {
        let found = self.welch.cross(xs, ys);
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
