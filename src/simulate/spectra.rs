//! The spectra that a run was asked for, and what to know when reading spectra.

use super::Model;
use crate::analysis::{
    Axis, Channel, ChannelSpectrum, EstimateError, EstimatedSpectrum, Leak, Recording, Spectrum,
    SpectrumColumn, SpectrumQuantity, TopPower, Window, estimate, leak,
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

/// The spectra that a model asks for, in its order.
pub(super) fn estimated<'a>(model: &'a Model, recording: Option<&Recording>) -> Vec<Estimate<'a>> {
    let requests = recording.map_or(&[][..], |_| &model.spectra).iter();
    let pairs = requests.filter_map(|request| Some((request, recording?)));
    pairs
        .map(|(request, recording)| (request.name.as_str(), estimate(recording, request)))
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
    let whole = estimates
        .iter()
        .filter_map(|(_, estimate)| estimate.as_ref().ok());
    let powers = spectrum.into_iter().flat_map(top_powers);
    let powers = powers.chain(whole.clone().flat_map(estimated_top_powers));
    warnings.extend(aliasing(&powers.collect::<Vec<_>>()));
    warnings.extend(spectrum.filter(|_| !speed_changes).and_then(leakage));
    let has_lines =
        |found: &&EstimatedSpectrum| !speed_changes || found.request.axis == Axis::Order;
    warnings.extend(whole.filter(has_lines).filter_map(estimated_leakage));
    warnings
}

/// Channels with their power, and that in the top tenth of the frequencies.
fn top_powers(spectrum: &Spectrum) -> Vec<(Channel, TopPower)> {
    let floor = spectrum.noise_floor();
    let of = |entry: &ChannelSpectrum| {
        let rest = floor.below(entry.channel);
        (
            entry.channel,
            TopPower::of_channel(entry, spectrum.window, rest),
        )
    };
    spectrum.channels.iter().map(of).collect()
}

fn estimated_top_powers(spectrum: &EstimatedSpectrum) -> Vec<(Channel, TopPower)> {
    let of = |column: &SpectrumColumn| match column.quantity {
        SpectrumQuantity::Value(channel) => Some((channel, column.top_power?)),
        _ => None,
    };
    spectrum.columns.iter().filter_map(of).collect()
}

/// The channel that is sampled most seldom; a freedom that rests beside the others of its unit is not
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

/// The channel of `spectrum.csv` that leaks most, in words.
fn leakage(spectrum: &Spectrum) -> Option<String> {
    if spectrum.window != Window::Rectangular {
        return None;
    }
    let floor = spectrum.noise_floor();
    let entries = spectrum.channels.iter();
    let leaks = entries.filter_map(|entry| {
        let channel = entry.channel;
        Some((channel, leak(&entry.amplitude, floor.below(channel))?))
    });
    let (channel, leak) = furthest(leaks)?;
    Some(
        leakage_text("spectrum.csv", channel, &leak, spectrum.resolution, "Hz")
            + "; the table of peaks is right all the same; window = \"hann\" in [output] leaves narrow \
           skirts, \"flat_top\" shows amplitudes within 1 %",
    )
}

fn estimated_leakage(spectrum: &EstimatedSpectrum) -> Option<String> {
    let leaks = spectrum
        .columns
        .iter()
        .filter_map(|column| match column.quantity {
            SpectrumQuantity::Value(channel) => Some((channel, column.leak?)),
            _ => None,
        });
    let (channel, leak) = furthest(leaks)?;
    let file = format!("the spectrum `{}`", spectrum.request.name);
    let unit = match spectrum.request.axis.unit() {
        "order" => "orders",
        unit => unit,
    };
    Some(
        leakage_text(&file, channel, &leak, spectrum.resolution, unit)
            + "; window = \"hann\" leaves narrow skirts, \"flat_top\" shows amplitudes within 1 %",
    )
}

fn furthest(leaks: impl Iterator<Item = (Channel, Leak)>) -> Option<(Channel, Leak)> {
    leaks.max_by(|a, b| a.1.reach().total_cmp(&b.1.reach()))
}

fn leakage_text(file: &str, channel: Channel, leak: &Leak, resolution: f64, unit: &str) -> String {
    let position = (leak.bin as f64 + leak.offset) * resolution;
    format!(
        "leakage: in {file} the line of {channel} at {position:.2} {unit} is {:.2} bins beside its \
         bin under the rectangular window, shows {:.0} % of its amplitude, and hides what is weaker \
         than 1 % of it within {:.1} {unit}",
        leak.offset.abs(),
        100.0 * leak.shown(),
        leak.reach() * resolution
    )
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
