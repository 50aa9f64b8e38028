//! Collects the samples of a run and turns them into spectra at its end.

use super::order_sums::OrderSums;
use super::peaks::peaks;
use super::transform::plan;
use super::{Channel, ChannelSpectrum, Line, Peak, Spectrum, Transform, Window};
use crate::rotor::Sample;

/// Fewer samples than this make no spectrum: the widest window mixes nine bins.
const FEWEST_SAMPLES: usize = 16;

/// Most samples that room is made for before they come.
const FORESEEN: usize = 1 << 16;

/// Spectra of a run and their peaks.
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis {
    /// Spectra of all channels.
    pub spectrum: Spectrum,
    /// Peaks of all channels, channel by channel, strongest first.
    pub peaks: Vec<Peak>,
}

/// Collects displacements and bearing forces after the settle time.
///
/// The samples must come on a uniform grid of time. On a grid of shaft angle the spectra are taken
/// of the largest whole number of revolutions that fits, the last ones of the run, so that what
/// turns with the shaft stands on a bin; on a free grid of time, of all samples.
///
/// ```
/// use jeffcott::analysis::{Channel, Recorder, Window};
/// use jeffcott::rotor::Sample;
/// // 1 µm at the shaft frequency of 50 Hz, 64 samples a revolution, 0.1 s of 0.5 s left out.
/// let mut recorder = Recorder::on_angle_grid(2, 0.1, 50.0, 64);
/// for n in 0..=1600 {
///     let angle = std::f64::consts::TAU * f64::from(n) / 64.0;
///     recorder.record(&Sample {
///         time: f64::from(n) / 3200.0,
///         angle,
///         speed: 314.16,
///         displacement: [1e-6 * angle.cos(), 0.0, 0.0, 0.0, 0.0],
///         force_on_shaft: Some([0.0; 5]),
///         ..Sample::default()
///     });
/// }
/// let analysis = recorder.finish(Window::Rectangular, &[]).unwrap();
/// assert_eq!(analysis.spectrum.length, 20 * 64);
/// assert_eq!(analysis.peaks.len(), 1);
/// assert!((analysis.peaks[0].frequency - 50.0).abs() < 1e-9);
/// assert!((analysis.peaks[0].amplitude - 1e-6).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Recorder {
    channels: Vec<(Channel, Vec<f64>)>,
    settle: f64,
    shaft_frequency: f64,
    rate: f64,
    /// Number of samples of which the window holds a multiple.
    block: usize,
    /// Time of the first recorded sample, s.
    start: Option<f64>,
}

impl Recorder {
    /// For `per_revolution` samples a revolution of a shaft that turns at `shaft_frequency` Hz;
    /// `freedoms` of x, y, z, θx, θy move, and the first `settle` seconds are left out.
    pub fn on_angle_grid(
        freedoms: usize,
        settle: f64,
        shaft_frequency: f64,
        per_revolution: u32,
    ) -> Self {
        let rate = shaft_frequency * f64::from(per_revolution);
        let block = per_revolution.max(1) as usize;
        Self::new(freedoms, settle, shaft_frequency, rate, block)
    }

    /// For `rate` samples a second, whatever the shaft's frequency in Hz is.
    pub fn on_time_grid(freedoms: usize, settle: f64, shaft_frequency: f64, rate: f64) -> Self {
        Self::new(freedoms, settle, shaft_frequency, rate, 1)
    }

    fn new(freedoms: usize, settle: f64, shaft_frequency: f64, rate: f64, block: usize) -> Self {
        let channels = Channel::of_freedoms(freedoms).into_iter();
        Self {
            channels: channels.map(|channel| (channel, Vec::new())).collect(),
            settle,
            shaft_frequency,
            rate,
            block,
            start: None,
        }
    }

    /// The displacements alone.
    #[must_use]
    pub fn of_displacements(mut self) -> Self {
        let moves = |channel: &Channel| matches!(channel, Channel::Displacement(_));
        self.channels.retain(|(channel, _)| moves(channel));
        self
    }

    /// With room for the samples of a run that ends at a time, s.
    #[must_use]
    pub fn until(mut self, end: f64) -> Self {
        let expected = (end - self.settle) * self.rate + 2.0;
        for (_, values) in &mut self.channels {
            values.reserve((expected as usize).min(FORESEEN));
        }
        self
    }

    /// Takes one sample; those before the settle time are dropped.
    pub fn record(&mut self, sample: &Sample) {
        if sample.time < self.settle {
            return;
        }
        self.start.get_or_insert(sample.time);
        for (channel, values) in &mut self.channels {
            values.extend(channel.of(sample));
        }
    }

    /// Spectra under `window` and their peaks, named by the nearest of `causes`.
    ///
    /// `None` where less than one revolution, or too few samples for a spectrum, were recorded.
    pub fn finish(self, window: Window, causes: &[Line]) -> Option<Analysis> {
        let (mut spectrum, skipped) = self.frame(window)?;
        let plan = plan(spectrum.length);
        let mut found = Vec::new();
        for (channel, mut values) in self.channels {
            values.drain(..skipped);
            let transform = Transform::by_plan(values, plan.as_ref());
            found.extend(peaks(channel, &transform, spectrum.resolution, causes));
            let entry = ChannelSpectrum::new(channel, &transform, window);
            spectrum.channels.push(entry);
        }
        Some(Analysis {
            spectrum,
            peaks: found,
        })
    }

    /// Amplitudes under `window` up to an order of the shaft, or all of them where it does not turn: no
    /// phases, no peaks. `None` as by [`Recorder::finish`].
    pub fn finish_lines(self, window: Window, highest_order: f64) -> Option<Spectrum> {
        let (mut spectrum, skipped) = self.frame(window)?;
        let plan = plan(spectrum.length);
        for (channel, mut values) in self.channels {
            values.drain(..skipped);
            let transform = Transform::by_plan(values, plan.as_ref());
            let bins = 0..transform.bins();
            let is_kept = |k: &usize| {
                spectrum
                    .order(*k)
                    .is_none_or(|order| order <= highest_order)
            };
            let amplitudes = bins.take_while(is_kept);
            let amplitude = amplitudes.map(|k| transform.amplitude(k, window)).collect();
            spectrum.channels.push(ChannelSpectrum {
                channel,
                amplitude,
                phase: Vec::new(),
            });
        }
        Some(spectrum)
    }

    /// Amplitudes at the first multiples of the shaft's frequency alone: the spectrum of the mean revolution,
    /// whose bins are the orders of the shaft. On a free grid of time, or under a window that is not
    /// rectangular, all amplitudes up to there. `None` as by [`Recorder::finish`].
    pub fn finish_orders(self, window: Window, highest: u32) -> Option<Spectrum> {
        if self.block == 1 || window != Window::Rectangular {
            // round-off may put the bin of an order just beyond it
            return self.finish_lines(window, f64::from(highest) * (1.0 + 1e-9));
        }
        let (mut spectrum, skipped) = self.frame(window)?;
        let sums = OrderSums::new(self.block, highest);
        spectrum.resolution = spectrum.shaft_frequency;
        spectrum.channels.extend(
            self.channels
                .iter()
                .map(|(channel, values)| ChannelSpectrum {
                    channel: *channel,
                    amplitude: sums.amplitudes(&values[skipped..]),
                    phase: Vec::new(),
                }),
        );
        Some(spectrum)
    }

    /// A spectrum whose channels are still to come, and how many samples stand before it.
    fn frame(&self, window: Window) -> Option<(Spectrum, usize)> {
        let recorded = self.channels.first()?.1.len();
        let length = recorded / self.block * self.block;
        if length < FEWEST_SAMPLES {
            return None;
        }
        let skipped = recorded - length;
        let spectrum = Spectrum {
            resolution: self.rate / length as f64,
            shaft_frequency: self.shaft_frequency,
            length,
            start: self.start? + skipped as f64 / self.rate,
            window,
            channels: Vec::with_capacity(self.channels.len()),
        };
        Some((spectrum, skipped))
    }
}
