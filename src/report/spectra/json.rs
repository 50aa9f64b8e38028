//! How a spectrum was made, for the summary: what it takes to make it again.

use serde_json::{Map, Value, json};

use super::{file_name, names};
use crate::analysis::{
    Axis, EstimatedSpectrum, Resampling, Scaling, SpectrumKind, SpectrumQuantity,
};

/// File, settings, record and averages of a spectrum.
pub(in crate::report) fn estimated_json(spectrum: &EstimatedSpectrum) -> Value {
    let request = &spectrum.request;
    let channels = request.channels.iter().map(|channel| channel.name());
    let columns = spectrum.columns.iter().map(|column| {
        json!({
            "name": names::column(spectrum, column.quantity),
            "unit": names::unit(spectrum, column.quantity),
        })
    });
    let mut entry = json!({
        "file": file_name(spectrum),
        "name": request.name,
        "kind": request.kind.name(),
        "channels": channels.collect::<Value>(),
        "over": request.axis.name(),
        "scaling": request.scaling.name(),
        "meaning": meaning(spectrum),
        "sides": if request.kind == SpectrumKind::Whirl { "two" } else { "one" },
        "window": request.window.name(),
        "coherent_gain": request.window.coherent_gain(),
        "detrend": request.detrend.name(),
        "samples": spectrum.samples,
        "start_s": spectrum.span[0],
        "end_s": spectrum.span[1],
        "segment_samples": spectrum.segment,
        "overlap_samples": spectrum.overlap,
        "averages": spectrum.averages,
        "columns": columns.collect::<Value>(),
    });
    if let Value::Object(entries) = &mut entry {
        put_axis(spectrum, entries);
        if let SpectrumKind::Envelope { band } = request.kind {
            entries.insert("band_Hz".to_owned(), json!(band));
        }
        if let Some(resampling) = &spectrum.resampling {
            entries.insert("resampling".to_owned(), resampled(resampling));
        }
    }
    entry
}

/// What has the unit of the axis.
fn put_axis(spectrum: &EstimatedSpectrum, entries: &mut Map<String, Value>) {
    let bins = spectrum.request.window.equivalent_noise_bandwidth();
    entries.insert("noise_bandwidth_bins".to_owned(), bins.into());
    let [rate, resolution, bandwidth] = match spectrum.request.axis {
        Axis::Frequency => ["sampling_rate_Hz", "resolution_Hz", "noise_bandwidth_Hz"],
        Axis::Order => [
            "samples_per_revolution",
            "resolution_orders",
            "noise_bandwidth_orders",
        ],
    };
    entries.insert(rate.to_owned(), spectrum.rate.into());
    entries.insert(resolution.to_owned(), spectrum.resolution.into());
    entries.insert(bandwidth.to_owned(), spectrum.noise_bandwidth.into());
    if spectrum.shaft_frequency > 0.0 {
        let shaft = spectrum.shaft_frequency.into();
        entries.insert("shaft_frequency_Hz".to_owned(), shaft);
    }
}

/// The scaling in words.
fn meaning(spectrum: &EstimatedSpectrum) -> String {
    let of = match spectrum.request.kind {
        SpectrumKind::Plain => "",
        SpectrumKind::Envelope { .. } => " of the envelope in band_Hz",
        SpectrumKind::Whirl => {
            " of x + iy: positive frequencies turn with the shaft, negative ones against it"
        }
        SpectrumKind::Cross => {
            " of conj(X) Y, X the first channel; the phase is by how much Y leads"
        }
    };
    let what = match (spectrum.request.scaling, spectrum.request.kind) {
        (Scaling::Peak, SpectrumKind::Whirl) => "radius of the circle",
        (Scaling::PeakToPeak, SpectrumKind::Whirl) => "diameter of the circle",
        (Scaling::Peak, _) => "amplitude of the cosine, square root of the averaged power",
        (Scaling::PeakToPeak, _) => "twice the amplitude, square root of the averaged power",
        (Scaling::Rms, _) => "root mean square",
        (Scaling::Power, _) => "mean square (SciPy: spectrum, Matlab: power)",
        (Scaling::Density, _) => "mean square per unit of the axis (SciPy: density, Matlab: psd)",
    };
    let is_phase = |quantity| matches!(quantity, SpectrumQuantity::Phase(_));
    let mut columns = spectrum.columns.iter();
    let phase = match columns.any(|column| is_phase(column.quantity)) {
        true => "; phase of cos(2 pi f t + phase) with t from start_s",
        false => "",
    };
    format!("{what}{of}{phase}")
}

fn resampled(resampling: &Resampling) -> Value {
    let errors = resampling.errors.iter();
    let errors = errors.map(|(channel, error)| (channel.name().to_owned(), json!(error)));
    json!({
        "highest_order": 0.5 * resampling.per_revolution as f64,
        "oversampling": resampling.oversampling,
        "share_of_time_too_slow": resampling.coarse_share,
        "interpolation_error": errors.collect::<Map<_, _>>(),
        "interpolation_error_means": "root mean square of the error over that of the signal about its \
                                      mean, extrapolated from samples left out; null: too few samples",
    })
}
