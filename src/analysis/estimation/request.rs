//! What a spectrum is asked to show, and what it then shows.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Detrend;
use crate::analysis::{Channel, ChannelCheck, Line, Window};
use crate::table::SCALINGS;

/// What is made of the channels.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SpectrumKind {
    /// One one-sided spectrum a channel.
    Plain,
    /// The spectrum of the channel's envelope.
    Envelope {
        /// Lowest and highest frequency of what has the envelope, Hz.
        band: [f64; 2],
    },
    /// The spectrum of the envelope of the band in which the first channel knocks most, which becomes that of an `Envelope`.
    ImpulsiveEnvelope,
    /// Two-sided spectra of x + iy; channels come in pairs.
    Whirl,
    /// Cross spectra of the first channel with each of the others.
    Cross,
}

/// How long a segment is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Segment {
    /// One segment: the record.
    Whole,
    /// So many seconds.
    Seconds(f64),
    /// So many revolutions of the shaft.
    Revolutions(u32),
    /// So many samples.
    Samples(usize),
}

/// Axis of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// Frequency in Hz.
    #[default]
    Frequency,
    /// Shaft orders; at a changing speed of samples at equal shaft angles.
    Order,
}

impl SpectrumKind {
    /// Name as in the files: `plain`, `envelope`, `whirl`, `cross`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Envelope { .. } | Self::ImpulsiveEnvelope => "envelope",
            Self::Whirl => "whirl",
            Self::Cross => "cross",
        }
    }
}

impl Axis {
    /// Unit of its values: `Hz`, or `order`.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Frequency => "Hz",
            Self::Order => "order",
        }
    }
}

/// A spectrum that a run is to estimate.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumRequest {
    /// Its name, by which its file is called.
    pub name: String,
    /// What is made of the channels.
    pub kind: SpectrumKind,
    /// The channels: pairs (x, y) of a whirl, the reference first of a cross spectrum.
    pub channels: Vec<Channel>,
    /// Scaling of the values.
    pub scaling: Scaling,
    /// Window of every segment.
    pub window: Window,
    /// Length of a segment.
    pub segment: Segment,
    /// Share of a segment that the next one holds as well, 0 … 1 (excluded).
    pub overlap: f64,
    /// What is taken out of every segment.
    pub detrend: Detrend,
    /// Its axis.
    pub axis: Axis,
}

impl SpectrumRequest {
    /// Channels that it takes to have `channel`, `resampled` at equal angles or as it is.
    ///
    /// A displacement and a velocity are interpolated with their rates; of an envelope, and of accelerations and forces,
    /// only values are known.
    pub(in crate::analysis) fn sources(&self, channel: Channel, resampled: bool) -> Vec<Channel> {
        let is_plain = !matches!(
            self.kind,
            SpectrumKind::Envelope { .. } | SpectrumKind::ImpulsiveEnvelope
        );
        let rate = rate_of(channel).filter(|_| is_plain && resampled);
        [channel].into_iter().chain(rate).collect()
    }
}

/// The time derivative of a channel, where that is known.
pub(super) fn rate_of(channel: Channel) -> Option<Channel> {
    match channel {
        Channel::Displacement(freedom) => Some(Channel::Velocity(freedom)),
        Channel::Velocity(freedom) => Some(Channel::Acceleration(freedom)),
        Channel::Body {
            body,
            quantity,
            axis,
        } => Some(Channel::Body {
            body,
            quantity: quantity.rate()?,
            axis,
        }),
        _ => None,
    }
}

/// Scaling of a spectrum.
///
/// With P the power of a bin, the mean over the segments of `|Σ w x exp(−2πikn/N)|²/(Σ w)²`, and
/// s = 2 for the image at −f that a one-sided spectrum folds in (s = 1 at zero frequency, at half the
/// sampling rate of an even length, and in a two-sided spectrum):
///
/// ```text
/// peak = s √P    peak to peak = 2 s √P    rms = √(s P)    power = s P    density = s P/ENBW
/// ```
///
/// `scipy.signal.welch` calls power `scaling="spectrum"` and density `scaling="density"`; Matlab's
/// `pwelch` calls them "power" and "psd".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Scaling {
    /// Amplitude.
    Peak,
    /// Root mean square.
    Rms,
    /// Twice the amplitude.
    PeakToPeak,
    /// Mean square: "spectrum" of SciPy, "power" of Matlab.
    Power,
    /// Mean square per Hz or per order: "density" of SciPy, "psd" of Matlab.
    Density,
}

impl Scaling {
    /// The value of a bin of power `power` that counts `sides` times, under a window of the
    /// equivalent noise bandwidth `bandwidth` in units of the axis.
    ///
    /// ```
    /// use jeffcott::internals::Scaling;
    /// // a cosine of amplitude 3 has (3/2)² at f and at −f
    /// assert_eq!(Scaling::Peak.value(2.25, 2.0, 1.5), 3.0);
    /// assert_eq!(Scaling::Power.value(2.25, 2.0, 1.5), 4.5);
    /// assert_eq!(Scaling::Density.value(2.25, 2.0, 1.5), 3.0);
    /// ```
    pub fn value(self, power: f64, sides: f64, bandwidth: f64) -> f64 {
        match self {
            Self::Peak => sides * power.sqrt(),
            Self::PeakToPeak => 2.0 * sides * power.sqrt(),
            Self::Rms => (sides * power).sqrt(),
            Self::Power => sides * power,
            Self::Density => sides * power / bandwidth,
        }
    }

    /// Whether values are in the unit squared.
    pub fn is_square(self) -> bool {
        matches!(self, Self::Power | Self::Density)
    }

    /// Name as in the files: `peak`, `rms`, `peak_to_peak`, `power`, `density`.
    pub fn name(self) -> &'static str {
        SCALINGS[self as usize]
    }
}

/// Factors of a unit such as `m/s^2` or `N m`, with their powers.
struct Factors(Vec<(String, i32)>);

impl Factors {
    /// `m/s^2` is m¹ s⁻²: the divisors come after the slash.
    fn read(unit: &str) -> Self {
        let (above, below) = unit.split_once('/').unwrap_or((unit, ""));
        let mut factors = Self(Vec::new());
        for (text, sign) in [(above, 1), (below, -1)] {
            for word in text.split_whitespace() {
                let (symbol, power) = word.split_once('^').unwrap_or((word, "1"));
                factors.multiply(symbol, sign * power.parse::<i32>().unwrap_or(1));
            }
        }
        factors
    }

    fn multiply(&mut self, symbol: &str, power: i32) {
        match self.0.iter_mut().find(|(known, _)| known == symbol) {
            Some((_, known)) => *known += power,
            None => self.0.push((symbol.to_owned(), power)),
        }
    }

    fn written(&self) -> String {
        let side = |sign: i32| {
            let factors = self.0.iter().filter(|(_, power)| power * sign > 0);
            let words = factors.map(|(symbol, power)| match power.abs() {
                1 => symbol.clone(),
                power => format!("{symbol}^{power}"),
            });
            words.collect::<Vec<_>>().join(" ")
        };
        let (above, below) = (side(1), side(-1));
        match (above.is_empty(), below.is_empty()) {
            (_, true) => above,
            (true, false) => format!("1/{below}"),
            (false, false) => format!("{above}/{below}"),
        }
    }
}

/// Unit of the product of two quantities.
pub(super) fn product(first: &str, second: &str) -> String {
    let mut factors = Factors::read(first);
    for (symbol, power) in Factors::read(second).0 {
        factors.multiply(&symbol, power);
    }
    factors.written()
}

/// Why a spectrum could not be estimated.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EstimateError {
    /// The record holds no segment.
    #[error(
        "the record holds {samples} samples (after the settle time of a run), and a segment {needed}: make it longer or the \
         segment shorter"
    )]
    TooShort {
        /// Samples there are.
        samples: usize,
        /// Samples of a segment.
        needed: usize,
    },
    /// A segment of hardly any samples.
    #[error("a segment of {samples} samples is too short: at least {needed} make a spectrum")]
    ShortSegment {
        /// Its samples.
        samples: usize,
        /// Fewest samples.
        needed: usize,
    },
    /// The shaft turns back, and its angle says no more where the record is.
    #[error("the shaft turns back at t = {time:.4e} s: there is no spectrum over its orders")]
    TurnsBack {
        /// Time, s.
        time: f64,
    },
    /// Less than one revolution.
    #[error(
        "the shaft makes {turns:.2} revolutions (after the settle time of a run): a spectrum over orders needs at least one"
    )]
    NoRevolution {
        /// Revolutions there are.
        turns: f64,
    },
    /// Revolutions of changing length make no segments of equal time.
    #[error(
        "the speed changes, and segments in revolutions are not equally long: take the spectrum over orders, or give the segment \
         in seconds"
    )]
    UnevenRevolutions,
    /// Seconds make no segments of equal angle.
    #[error("a spectrum over orders has segments in revolutions, not in seconds")]
    SecondsOverOrders,
    /// The product of two channels has no amplitude.
    #[error("a cross spectrum is a power or a density: it has no amplitude")]
    CrossAmplitude,
}

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
    /// Highest value of its bins.
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

#[cfg(test)]
mod tests {
    use super::product;

    #[test]
    fn units_multiply() {
        assert_eq!(product("m", "m"), "m^2");
        assert_eq!(product("m/s^2", "m/s^2"), "m^2/s^4");
        assert_eq!(product("N m", "rad/s"), "N m rad/s");
        assert_eq!(product("N m", "m"), "N m^2");
    }
}
