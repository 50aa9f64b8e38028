//! The spectra that a run was asked for, and what to know when reading spectra.

use super::Model;
use crate::analysis::{
    Axis, Channel, ChannelCheck, ChannelSpectrum, EstimateError, EstimatedSpectrum, Line,
    Recording, Spectrum, TopPower, Window, estimate, leak,
};

/// A share of the power in the top tenth of the frequencies that is worth a warning: what folds is
/// then a hundredth of the signal.
const ALIASING: f64 = 1e-4;
/// A share of the time without a fine enough grid of angle that is worth a warning.
const COARSE: f64 = 0.01;
/// An interpolation error, relative to the signal, that is worth a warning.
const RESAMPLING: f64 = 1e-3;

/// A spectrum, or the name of the one that could not be estimated and why.
pub(super) type Estimate<'a> = (&'a str, Result<EstimatedSpectrum, EstimateError>);

/// The spectra that a model asks for, in its order, the lines of envelopes named by their causes; beside what is random,
/// those alone that are above the noise.
pub(super) fn estimated<'a>(
    model: &'a Model,
    recording: Option<&Recording>,
    causes: &[Line],
    random: bool,
) -> Vec<Estimate<'a>> {
    let requests = recording.map_or(&[][..], |_| &model.spectra).iter();
    let pairs = requests.filter_map(|request| Some((request, recording?)));
    pairs
        .map(|(request, recording)| {
            let mut found = estimate(recording, request);
            if let Ok(spectrum) = &mut found {
                spectrum.name_lines(causes);
                if random {
                    spectrum.forget_lines_of_noise();
                }
            }
            (request.name.as_str(), found)
        })
        .collect()
}

/// What the reader of the spectra should know; lines of a speed that changes over a spectrum's
/// frequencies are not sought.
pub(super) fn warnings(
    spectrum: Option<&Spectrum>,
    estimates: &[Estimate<'_>],
    speed_changes: bool,
) -> Vec<String> {
    let mut warnings = Vec::new();
    for (name, estimate) in estimates {
        match estimate {
            Ok(found) => warnings.extend(resampling(name, found)),
            Err(error) => {
                warnings.push(format!("the spectrum `{name}` was not estimated: {error}"))
            }
        }
    }
    let whole = spectrum.map_or_else(Vec::new, checks);
    let estimated = || {
        let found = estimates.iter();
        found.filter_map(|(_, found)| found.as_ref().ok())
    };
    let all = whole
        .iter()
        .chain(estimated().flat_map(|found| &found.checks));
    let powers = all.filter_map(|check| Some((check.channel, check.top_power?)));
    warnings.extend(aliasing(&powers.collect::<Vec<_>>()));
    if let Some(spectrum) = spectrum.filter(|_| !speed_changes) {
        let remedy = "the table of peaks is right all the same; window = \"hann\" in [output]";
        warnings.extend(leakage(
            "spectrum.csv",
            &whole,
            spectrum.resolution,
            "Hz",
            remedy,
        ));
    }
    for found in estimated() {
        let file = format!("the spectrum `{}`", found.request.name);
        let unit = match found.request.axis {
            Axis::Frequency => "Hz",
            Axis::Order => "orders",
        };
        if !speed_changes || found.request.axis == Axis::Order {
            let remedy = "window = \"hann\"";
            warnings.extend(leakage(
                &file,
                &found.checks,
                found.resolution,
                unit,
                remedy,
            ));
        }
    }
    warnings
}

/// Whether a line off its bin hides weaker ones at a constant speed.
pub(super) fn leaks(spectrum: &Spectrum) -> bool {
    checks(spectrum).iter().any(|check| check.leak.is_some())
}

/// What sampling and its end did to the channels of the spectra of the whole run.
fn checks(spectrum: &Spectrum) -> Vec<ChannelCheck> {
    let floor = spectrum.noise_floor();
    let is_plain = spectrum.window == Window::Rectangular;
    let of = |entry: &ChannelSpectrum| {
        let noise = floor.below(entry.channel);
        ChannelCheck {
            channel: entry.channel,
            top_power: Some(TopPower::of_channel(entry, spectrum.window, noise)),
            leak: leak(&entry.amplitude, noise).filter(|_| is_plain),
        }
    };
    spectrum.channels.iter().map(of).collect()
}

/// The channel that is sampled most seldom; a freedom that hardly moves compared with the others of its unit is not
/// judged by itself.
fn aliasing(powers: &[(Channel, TopPower)]) -> Option<String> {
    let loudest = |unit| {
        let same = powers.iter().filter(|(channel, _)| channel.unit() == unit);
        let loud = same.map(|(_, power)| power.total.max(power.rest));
        loud.fold(f64::MIN_POSITIVE, f64::max)
    };
    let shares = powers.iter();
    let shares = shares.map(|(channel, power)| (channel, power.top / loudest(channel.unit())));
    let (channel, share) = shares.max_by(|a, b| a.1.total_cmp(&b.1))?;
    (share > ALIASING).then(|| {
        format!(
            "aliasing: {:.3} % of the power of {channel} lies in the top tenth of the frequencies, \
             and about as much from above half the sampling rate is folded below it: raise \
             `samples_per_revolution` or `sample_rate` in [output] until it is below {} %",
            100.0 * share,
            100.0 * ALIASING
        )
    })
}

/// The channel that leaks most, in words, and what to do about it.
fn leakage(
    file: &str,
    checks: &[ChannelCheck],
    resolution: f64,
    unit: &str,
    remedy: &str,
) -> Option<String> {
    let leaks = checks.iter();
    let leaks = leaks.filter_map(|check| Some((check.channel, check.leak?)));
    let (channel, leak) = leaks.max_by(|a, b| a.1.reach().total_cmp(&b.1.reach()))?;
    let position = (leak.bin as f64 + leak.offset) * resolution;
    Some(format!(
        "leakage: in {file} the line of {channel} at {position:.2} {unit} is {:.2} bins off its \
         bin under the rectangular window, shows {:.0} % of its amplitude, and hides what is weaker \
         than 1 % of it within {:.1} {unit}; {remedy} leaves narrow skirts, \"flat_top\" shows \
         amplitudes within 1 %",
        leak.offset.abs(),
        100.0 * leak.shown(),
        leak.reach() * resolution
    ))
}

fn resampling(name: &str, spectrum: &EstimatedSpectrum) -> Vec<String> {
    let Some(resampling) = &spectrum.resampling else {
        return Vec::new();
    };
    let mut warnings = Vec::new();
    if resampling.coarse_share > COARSE {
        warnings.push(format!(
            "the spectrum `{name}`: for {:.1} % of its time the shaft turns at less than 1/{} of its \
             highest speed, and frequencies above half the sampling rate of its angle fold there: \
             start later with `settle`",
            100.0 * resampling.coarse_share,
            resampling.oversampling
        ));
    }
    let known = resampling.errors.iter();
    let known = known.filter_map(|(channel, error)| Some((channel, (*error)?)));
    let worst = known.max_by(|a, b| a.1.total_cmp(&b.1));
    warnings.extend(worst.filter(|(_, error)| *error > RESAMPLING).map(|(channel, error)| {
        format!(
            "the spectrum `{name}`: the interpolation of {channel} to equal shaft angles errs by {:.2} \
             % of its RMS: raise `samples_per_revolution` or `sample_rate` in [output]",
            100.0 * error
        )
    }));
    warnings
}
