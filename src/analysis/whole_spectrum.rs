//! Spectra of a whole run after the settle time, and their peaks.

use super::order_sums::OrderSums;
use super::peaks::peaks;
use super::transform::plan;
use super::{Channel, ChannelSpectrum, Line, Peak, Recording, Spectrum, Transform, Window};

/// Fewer samples than this make no spectrum: the widest window mixes nine bins.
const FEWEST_SAMPLES: usize = 16;

/// Spectra of a run and their peaks.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Analysis {
    /// Spectra of all channels.
    pub spectrum: Spectrum,
    /// Peaks of all channels, channel by channel, strongest first.
    pub peaks: Vec<Peak>,
}

/// On a grid of shaft angle the spectra are taken of the largest whole number of revolutions that fits, the last
/// ones of the run, so that what turns with the shaft stands on a bin; on a free grid of time, of all samples. There
/// is none where less than one revolution, or too few samples for a spectrum, were recorded.
impl Recording {
    /// Spectra of recorded channels under `window` and their peaks, named by the nearest of `causes`.
    pub fn spectrum(
        &self,
        channels: &[Channel],
        window: Window,
        causes: &[Line],
    ) -> Option<Analysis> {
        let (mut spectrum, skipped) = self.frame(window)?;
        let (plan, floor) = (plan(spectrum.length), self.noise_floor());
        let mut found = Vec::new();
        for &channel in channels {
            let values = self.channel(channel)[skipped..].to_vec();
            let transform = Transform::by_plan(values, plan.as_ref());
            let least = floor.below(channel);
            found.extend(peaks(
                channel,
                &transform,
                spectrum.resolution,
                causes,
                least,
            ));
            let entry = ChannelSpectrum::new(channel, transform, window);
            spectrum.channels.push(entry.above(&floor));
        }
        Some(Analysis {
            spectrum,
            peaks: found,
        })
    }

    /// Amplitudes under `window` up to an order of the shaft, or all of them where it does not turn: no
    /// phases, no peaks.
    pub fn lines(
        &self,
        channels: &[Channel],
        window: Window,
        highest_order: f64,
    ) -> Option<Spectrum> {
        let (mut spectrum, skipped) = self.frame(window)?;
        let (plan, floor) = (plan(spectrum.length), self.noise_floor());
        for &channel in channels {
            let values = self.channel(channel)[skipped..].to_vec();
            let transform = Transform::by_plan(values, plan.as_ref());
            let (mean, transform) = transform.split_mean();
            let bins = 1..transform.bins();
            let is_kept = |k: &usize| {
                spectrum
                    .order(*k)
                    .is_none_or(|order| order <= highest_order)
            };
            let lines = bins
                .take_while(is_kept)
                .map(|k| transform.amplitude(k, window));
            let amplitude = mean.map(f64::abs).into_iter().chain(lines).collect();
            let entry = ChannelSpectrum {
                channel,
                amplitude,
                phase: Vec::new(),
            };
            spectrum.channels.push(entry.above(&floor));
        }
        Some(spectrum)
    }

    /// Amplitudes at the first multiples of the shaft's frequency alone: the spectrum of the mean revolution,
    /// whose bins are the orders of the shaft. On a free grid of time, or under a window that is not
    /// rectangular, all amplitudes up to there.
    pub fn orders(&self, channels: &[Channel], window: Window, highest: u32) -> Option<Spectrum> {
        let block = self.grid.block();
        if block == 1 || window != Window::Rectangular {
            // round-off may put the bin of an order just beyond it
            return self.lines(channels, window, f64::from(highest) * (1.0 + 1e-9));
        }
        let (mut spectrum, skipped) = self.frame(window)?;
        let (sums, floor) = (OrderSums::new(block, highest), self.noise_floor());
        spectrum.resolution = spectrum.shaft_frequency;
        let of_channel = |&channel: &Channel| {
            let entry = ChannelSpectrum {
                channel,
                amplitude: sums.amplitudes(&self.channel(channel)[skipped..]),
                phase: Vec::new(),
            };
            entry.above(&floor)
        };
        spectrum.channels.extend(channels.iter().map(of_channel));
        Some(spectrum)
    }

    /// A spectrum whose channels are still to come, and how many samples stand before it.
    fn frame(&self, window: Window) -> Option<(Spectrum, usize)> {
        let (recorded, block) = (self.length(), self.grid.block());
        let length = recorded / block * block;
        if length < FEWEST_SAMPLES {
            return None;
        }
        let skipped = recorded - length;
        let spectrum = Spectrum {
            resolution: self.grid.rate / length as f64,
            shaft_frequency: self.grid.shaft_frequency,
            length,
            start: self.start() + skipped as f64 / self.grid.rate,
            window,
            channels: Vec::new(),
        };
        Some((spectrum, skipped))
    }
}
