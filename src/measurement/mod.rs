//! What sensors measured → spectra, envelopes, orders and names, as of a run: a [`Measurement`] goes in, [`Measured`] comes out.
//!
//! The samples become a [`Recording`], of which everything else is made by the code that runs are analysed by.

mod marks;
mod slip;
mod speed_estimate;
mod turning;
mod unnamed;

use std::f64::consts::TAU;

use serde::Serialize;

use crate::analysis::{
    Axis, BearingFrequencies, Channel, ChannelLevel, ChannelStatistics, EstimatedSpectrum,
    LevelRecorder, Line, LineSurfaces, Peak, Recording, SampleGrid, Sources, Spectrum,
    SpectrumKind, SpectrumRequest, TrackRecorder, WaterfallRecorder, Window, causes, estimate,
};
use crate::bearing::Bearing;
use crate::physics::{BallPass, PER_MINUTE, velocity_band};
use crate::simulate::{Machine, Maps, VibrationSeverity, tracked_orders};

pub(crate) use slip::Slip;
pub(crate) use speed_estimate::SpeedEstimate;
pub(crate) use turning::{TachoError, Turning};
pub(crate) use unnamed::UnnamedLine;

/// Part of the RMS of a channel below which its envelope is round-off.
const ROUND_OFF: f64 = 1e-9;
/// Windows of a waterfall in a record.
const WINDOWS: f64 = 48.0;
/// Revolutions of the windows of order tracks, at most, and in parts of all.
const TRACK_REVOLUTIONS: f64 = 16.0;
const TRACK_PART: f64 = 0.05;
/// Orders that a waterfall reaches up to at the highest speed, and multiples of the highest ball-pass frequency.
const SHOWN_ORDERS: f64 = 10.0;
const SHOWN_PASSES: f64 = 2.5;

/// What was measured, all channels at equal times and in SI units.
#[derive(Debug, Clone)]
pub struct Measurement {
    /// The signals, all of one length.
    pub signals: Vec<(Channel, Vec<f64>)>,
    /// Samples a second.
    pub rate: f64,
    /// Time of the first ones, s.
    pub start: f64,
    /// How the shaft turned, where that is known.
    pub turning: Option<Turning>,
    /// The bearings whose lines are looked for.
    pub bearings: Vec<MeasuredBearing>,
    /// The machine, for the zones of ISO 20816-3.
    pub machine: Option<Machine>,
    /// Window of the spectrum of all.
    pub window: Window,
    /// Further spectra.
    pub spectra: Vec<SpectrumRequest>,
}

/// A bearing whose lines are looked for.
#[derive(Debug, Clone)]
pub struct MeasuredBearing {
    /// What it is called.
    pub name: String,
    /// Its dimensions.
    pub bearing: Bearing,
    /// How much slower its cage turns than it would roll, where that is known.
    pub slip: Option<f64>,
}

/// What was found in a measurement. It serialises with the keys of `record.json`, but for its spectra.
#[derive(Debug, Clone, Serialize)]
pub struct Measured {
    /// The signals.
    #[serde(skip)]
    pub recording: Recording,
    /// Samples a second.
    #[serde(rename = "sample_rate_Hz")]
    pub rate: f64,
    /// Mean, lowest and highest speed, rad/s, where it is known.
    #[serde(skip)]
    pub speed: Option<[f64; 3]>,
    /// What the bearings are called.
    pub bearings: Vec<String>,
    /// What rolls in them: `ball` or `roller`.
    #[serde(skip)]
    pub elements: Vec<&'static str>,
    /// Frequencies of the bearings at the mean speed, as they roll at the nominal contact angle.
    #[serde(rename = "nominal_ball_pass")]
    pub nominal: Vec<BallPass>,
    /// Those with the slip that is given or was found.
    pub ball_pass: Vec<BallPass>,
    /// The slip of their cages, where it was found.
    #[serde(rename = "cage_slip")]
    pub slips: Vec<Option<Slip>>,
    /// Speeds that would explain the lines, the likeliest first, where none is known.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub speed_estimates: Vec<SpeedEstimate>,
    /// The strongest lines of envelopes of a known speed, where nothing known causes them.
    #[serde(
        rename = "unnamed_envelope_lines",
        skip_serializing_if = "Vec::is_empty"
    )]
    pub unnamed_lines: Vec<UnnamedLine>,
    /// Statistics of every signal.
    pub statistics: Vec<ChannelStatistics>,
    /// RMS velocity of those that are or make velocities.
    #[serde(rename = "velocity_rms")]
    pub velocity: Vec<ChannelLevel>,
    /// Zone of the largest, where the machine is known.
    #[serde(rename = "vibration_severity", skip_serializing_if = "Option::is_none")]
    pub severity: Option<VibrationSeverity>,
    /// The spectrum of all signals.
    #[serde(skip)]
    pub spectrum: Option<Spectrum>,
    /// Its peaks, with their names.
    #[serde(skip)]
    pub peaks: Vec<Peak>,
    /// The further spectra, as far as the record is long enough.
    #[serde(skip)]
    pub spectra: Vec<EstimatedSpectrum>,
    /// Waterfall and order tracks, where the speed changes.
    #[serde(skip)]
    pub maps: Option<Maps>,
    /// What the reader should know.
    #[serde(skip)]
    pub warnings: Vec<String>,
}

impl Measurement {
    /// Finds out what is in it.
    pub fn analyse(self) -> Measured {
        let Self {
            mut signals,
            rate,
            start,
            turning,
            bearings,
            machine,
            window,
            spectra: requests,
        } = self;
        let (bearings, is_turning) = (&bearings[..], turning.is_some());
        let steady = turning.as_ref().and_then(Turning::steady);
        let speed = turning.as_ref().map(Turning::speeds);
        let channels: Vec<Channel> = signals.iter().map(|(channel, _)| *channel).collect();
        let over_orders = |request: &SpectrumRequest| request.axis == Axis::Order;
        let length = signals.first().map_or(0, |(_, values)| values.len());
        let grid = sample_grid(rate, steady, length);
        if let Some(turning) = turning
            && (steady.is_none() || requests.iter().any(over_orders))
        {
            signals.extend(turning.columns(rate, length));
        }
        let recording = Recording::of_columns(grid, start, signals);
        let mut warnings = Vec::new();
        let mut spectra = estimated(&recording, &requests, &mut warnings);
        let statistics = statistics(&recording, &channels);
        silence_round_off(&mut spectra, &statistics);

        // the lines of a speed that changes are known over orders, of a shaft of 1 Hz
        let unit = steady.unwrap_or(if is_turning { TAU } else { 0.0 });
        let (slips, passes) = slip::found(bearings, &spectra, unit);
        let lines = lines(bearings, &passes, unit / TAU);
        for spectrum in &mut spectra {
            match spectrum.request.axis {
                Axis::Order => spectrum.name_lines_in(unit / TAU, &lines),
                Axis::Frequency => spectrum.name_lines(&lines),
            }
            spectrum.forget_lines_of_noise();
        }
        let unnamed_lines = match is_turning && !bearings.is_empty() {
            true => unnamed::found(&spectra),
            false => Vec::new(),
        };
        let named = if steady.is_some() { &lines[..] } else { &[] };
        let analysis = recording.spectrum(&channels, window, named);
        let analysis = analysis.map(|found| found.without_names_of_noise());
        let (spectrum, peaks) = analysis.map_or_else(Default::default, |found| {
            (Some(found.spectrum), found.peaks)
        });
        let speed_estimates = match is_turning {
            false => speed_estimate::found(bearings, &spectra, &peaks),
            true => Vec::new(),
        };

        let mean = speed.map(|[mean, ..]| mean);
        let velocity = velocities(&recording, &channels, rate, mean);
        let severity = machine.and_then(|machine| {
            let length = recording.length() as f64 / rate;
            let missing = || "no zone of ISO 20816-3: it depends on the speed, which is not given";
            let mean = mean.ok_or_else(|| missing().to_owned());
            let zone = mean.and_then(|speed| {
                VibrationSeverity::from_levels(machine, &velocity, speed, [length, rate])
            });
            zone.map_err(|why| warnings.push(why)).ok()
        });
        let maps = (is_turning && steady.is_none())
            .then(|| maps(&recording, &channels, bearings, speed.unwrap_or_default()));
        if maps.is_some() {
            let [_, lowest, highest] = speed.unwrap_or_default();
            warnings.push(smearing([lowest, highest], &spectra));
        }
        warnings.extend(maps.iter().flat_map(|maps| maps.tracks.warnings()));
        let at_mean = |slip: Option<f64>, own: &MeasuredBearing| {
            own.bearing
                .rolling_ball_pass(slip.unwrap_or(0.0), mean.unwrap_or(0.0))
        };
        let known = |slip: &Option<Slip>, own: &MeasuredBearing| {
            own.slip.or(slip.as_ref().map(|slip| slip.cage_slip))
        };
        Measured {
            rate,
            speed,
            bearings: bearings.iter().map(|own| own.name.clone()).collect(),
            elements: bearings
                .iter()
                .map(|own| own.bearing.geometry.element())
                .collect(),
            nominal: bearings.iter().map(|own| at_mean(None, own)).collect(),
            ball_pass: slips
                .iter()
                .zip(bearings)
                .map(|(slip, own)| at_mean(known(slip, own), own))
                .collect(),
            slips,
            speed_estimates,
            unnamed_lines,
            statistics,
            velocity,
            severity,
            spectrum,
            peaks,
            spectra,
            maps,
            warnings,
            recording,
        }
    }
}

/// On a grid of shaft angle where a whole number of the samples makes a revolution of a constant speed in rad/s, as of the trace of a
/// run; else on a free grid of time.
fn sample_grid(rate: f64, speed: Option<f64>, length: usize) -> SampleGrid {
    let shaft_frequency = speed.unwrap_or(0.0) / TAU;
    let samples = rate / shaft_frequency;
    let whole = samples.round();
    if (1.0..=length as f64).contains(&whole) && (samples - whole).abs() < 1e-9 * whole {
        return SampleGrid::of_angle(shaft_frequency, whole as u32);
    }
    SampleGrid {
        rate,
        shaft_frequency,
        per_revolution: None,
    }
}

/// The spectra that can be estimated; of the others, why not.
fn estimated(
    recording: &Recording,
    requests: &[SpectrumRequest],
    warnings: &mut Vec<String>,
) -> Vec<EstimatedSpectrum> {
    let mut found = Vec::new();
    for request in requests {
        match estimate(recording, request) {
            Ok(spectrum) => found.push(spectrum),
            Err(error) => {
                let name = &request.name;
                warnings.push(format!("the spectrum `{name}` was not estimated: {error}"));
            }
        }
    }
    found
}

/// What a speed in rad/s that changes does to lines, and the spectra that have them over orders.
fn smearing(speeds: [f64; 2], spectra: &[EstimatedSpectrum]) -> String {
    let [lowest, highest] = speeds.map(|speed| speed * PER_MINUTE);
    let over_orders = spectra.iter().filter(|of| of.request.axis == Axis::Order);
    let files: Vec<_> = over_orders
        .map(|of| format!("spectrum_{}.csv", of.request.name))
        .collect();
    let orders = match files[..] {
        [] => "order_tracks.csv has their amplitudes over the speed".to_owned(),
        _ => format!("over orders of the shaft they are in {}", files.join(", ")),
    };
    format!(
        "the speed changes from {lowest:.0} to {highest:.0} rpm: lines of shaft and bearings smear in spectrum.csv and peaks.csv, which \
         have no orders and no names; {orders}"
    )
}

/// Sets envelopes to zero that are the round-off of their channels.
fn silence_round_off(spectra: &mut [EstimatedSpectrum], statistics: &[ChannelStatistics]) {
    let rms = |channel: Channel| {
        let mut all = statistics.iter();
        let own = all.find(|of| of.channel == channel);
        own.map_or(0.0, |of| of.moments.rms())
    };
    for spectrum in spectra {
        if matches!(spectrum.request.kind, SpectrumKind::Envelope { .. }) {
            spectrum.silence_below(|channel| ROUND_OFF * rms(channel));
        }
    }
}

/// The lines of shaft and bearings at a frequency of the shaft in Hz: which of them a machine has, nobody knows before.
fn lines(bearings: &[MeasuredBearing], passes: &[BearingFrequencies], shaft: f64) -> Vec<Line> {
    if shaft == 0.0 {
        return Vec::new();
    }
    let surfaces = bearings.iter().map(|own| LineSurfaces {
        balls: own.bearing.geometry.balls() as u32,
        balls_show_spin: true,
        balls_differ: true,
        turning: true,
        turning_ring: own.bearing.rotating_ring,
        waves: Vec::new(),
    });
    causes(&Sources {
        shaft,
        bearings: passes.to_vec(),
        surfaces: surfaces.collect(),
        unbalanced: true,
        ..Sources::default()
    })
}

fn statistics(recording: &Recording, channels: &[Channel]) -> Vec<ChannelStatistics> {
    let of = |channel: &Channel| ChannelStatistics {
        channel: *channel,
        moments: recording.channel(*channel).iter().copied().collect(),
    };
    channels.iter().map(of).collect()
}

/// RMS velocities in the band of a speed, or of faster shafts where it is not known.
fn velocities(
    recording: &Recording,
    channels: &[Channel],
    rate: f64,
    speed: Option<f64>,
) -> Vec<ChannelLevel> {
    let band = velocity_band(speed.unwrap_or(f64::INFINITY));
    let of = |channel: &Channel| {
        let samples = recording.channel(*channel);
        let level = LevelRecorder::level(samples, channel.unit(), rate, band)?;
        Some(ChannelLevel {
            channel: *channel,
            level,
        })
    };
    channels.iter().filter_map(of).collect()
}

/// Short-time spectra and orders of a shaft whose speed changes.
fn maps(
    recording: &Recording,
    channels: &[Channel],
    bearings: &[MeasuredBearing],
    [_, _, highest]: [f64; 3],
) -> Maps {
    let passes = bearings.iter().map(|own| {
        let pass = own.bearing.rolling_ball_pass(own.slip.unwrap_or(0.0), TAU);
        [pass.outer, pass.inner]
    });
    let passes: Vec<_> = passes.collect();
    let highest_pass = passes.iter().flatten().copied().fold(0.0, f64::max);
    let shown = SHOWN_ORDERS.max(SHOWN_PASSES * highest_pass);
    let rate = recording.rate();
    let [angle, speed] = [Channel::Angle, Channel::Speed].map(|of| recording.channel(of));
    let turns = match (angle.first(), angle.last()) {
        (Some(first), Some(last)) => (last - first) / TAU,
        _ => 0.0,
    };
    let revolutions = (TRACK_PART * turns).round().clamp(1.0, TRACK_REVOLUTIONS);
    let window = recording.length() as f64 / rate / WINDOWS;
    let highest = highest / TAU;
    let (orders, half) = (tracked_orders(&passes, &[]), 0.5 * rate / highest);
    let mut tracks = TrackRecorder::new(orders, channels.to_vec(), revolutions, half);
    let mut waterfall = WaterfallRecorder::new(channels.to_vec(), rate, window, shown * highest);
    for (index, (angle, speed)) in angle.iter().zip(speed).enumerate() {
        let time = recording.start() + index as f64 / rate;
        let value = |channel: Channel| recording.channel(channel)[index];
        waterfall.take([time, *speed], value);
        tracks.take([time, *angle, *speed], value);
    }
    Maps {
        waterfall: waterfall.finish(),
        tracks: tracks.finish(),
    }
}
