//! The spectra that a scenario asks for: a table each, how each was made, and what is shown of it.

use std::collections::BTreeMap;
use std::ops::Range;

use serde_json::{Value, json};

use super::shown::{NamedLine, ShownSpectrum};
use crate::analysis::{
    Axis, EstimatedSpectrum, Resampling, Scaling, SpectrumKind, SpectrumQuantity,
};
use crate::report::figure::{Figure, Panel};
use crate::table::{Column, Table};

/// Name of the table of a spectrum, without the ending of its format.
pub(in crate::report) fn table_name(spectrum: &EstimatedSpectrum) -> String {
    format!("spectrum_{}", spectrum.request.name)
}

/// One row a bin: `f_Hz` and, where the shaft turns steadily, `order`, in the other order over orders; then every
/// column.
pub(in crate::report) fn estimated_table(spectrum: &EstimatedSpectrum) -> Table<'_> {
    let rows = || 0..spectrum.bins();
    let frequencies = (
        Column::frequency(),
        rows().map(|k| spectrum.frequency(k)).collect(),
    );
    let orders = (Column::order(), rows().map(|k| spectrum.order(k)).collect());
    let axes: [(_, Vec<Option<f64>>); 2] = match spectrum.request.axis {
        Axis::Frequency => [frequencies, orders],
        Axis::Order => [orders, frequencies],
    };
    let mut table = Table::default();
    for (column, places) in axes {
        if places.first().is_some_and(Option::is_some) {
            table.add(column, places);
        }
    }
    for of in &spectrum.columns {
        table.borrowed(column(spectrum, of.quantity), &of.values);
    }
    table
}

/// `x_peak_m`, `x_velocity_rms_m_s`, `force_x_density_N2_per_Hz`, `x_iy_peak_m`,
/// `force_x_to_x_power_N_m`, `force_x_to_x_phase_rad`, `force_x_to_x_coherence` ….
fn column(spectrum: &EstimatedSpectrum, quantity: SpectrumQuantity) -> Column {
    let scaled = |name: String| {
        let scaling = spectrum.request.scaling.name();
        Column::measure(name, scaling, unit(spectrum, quantity))
    };
    match quantity {
        SpectrumQuantity::Value(channel) => scaled(channel.to_string()),
        SpectrumQuantity::Rotary(x, _) => scaled(x.name().replacen('x', "x_iy", 1)),
        SpectrumQuantity::Cross(x, y) => scaled(format!("{x}_to_{y}")),
        SpectrumQuantity::Phase(channel) => Column::phase(channel.name()),
        SpectrumQuantity::CrossPhase(x, y) => Column::phase(format!("{x}_to_{y}")),
        SpectrumQuantity::Coherence(x, y) => Column::number(format!("{x}_to_{y}_coherence"), ""),
    }
}

/// Unit of a column as text; phases and coherences are not scaled.
fn unit(spectrum: &EstimatedSpectrum, quantity: SpectrumQuantity) -> String {
    let unit = spectrum.unit(quantity);
    match quantity {
        SpectrumQuantity::Value(_) | SpectrumQuantity::Rotary(..) | SpectrumQuantity::Cross(..) => {
            unit + &per_axis(spectrum)
        }
        _ => unit,
    }
}

/// The unit of the axis that a density is divided by.
fn per_axis(spectrum: &EstimatedSpectrum) -> String {
    match spectrum.request.scaling {
        Scaling::Density => format!("/{}", spectrum.request.axis.unit()),
        _ => String::new(),
    }
}

/// Height of a plot, px.
const HEIGHT: u32 = 340;

/// Figures of the spectra that have named lines, or of those that have none, up to `limit` in Hz.
pub(in crate::report) fn estimated_figures(
    title: &str,
    spectra: &[EstimatedSpectrum],
    named: bool,
    limit: f64,
) -> impl Iterator<Item = Figure> {
    let asked = spectra.iter();
    let asked = asked.filter(move |spectrum| spectrum.lines.is_empty() != named);
    asked.map(move |spectrum| figure(title, spectrum, limit))
}

/// A panel for every unit.
fn figure(title: &str, spectrum: &EstimatedSpectrum, limit: f64) -> Figure {
    let table = estimated_table(spectrum);
    let lines = spectrum.lines.iter().map(|line| NamedLine {
        column: column(spectrum, spectrum.columns[line.column].quantity),
        at: line.place,
        value: line.value,
        name: line.line.kind.to_string(),
    });
    let shown = shown_places(spectrum, limit);
    let groups = ShownSpectrum::grouped(&table, &lines.collect::<Vec<_>>(), &shown);
    let panels = groups.iter().map(|group| Panel {
        names: group.names(),
        ..group.panel(HEIGHT)
    });
    let title = format!("{title}: {}", spectrum.request.name);
    Figure::new(&table_name(spectrum), &title, 1, panels.collect())
}

/// Places that are shown at first: those that lines are found at, `limit` in Hz, if the axis has any.
fn shown_places(spectrum: &EstimatedSpectrum, limit: f64) -> Range<f64> {
    let last = spectrum.place(spectrum.bins().saturating_sub(1));
    let limit = match spectrum.request.axis {
        Axis::Frequency => limit,
        Axis::Order if spectrum.shaft_frequency > 0.0 => limit / spectrum.shaft_frequency,
        // of a speed that changes, those up to a little above the named lines
        Axis::Order => {
            let places = spectrum.lines.iter().map(|line| line.place);
            let highest = places.reduce(f64::max);
            highest.map_or(f64::INFINITY, |place| 1.25 * place)
        }
    };
    let end = limit.min(last);
    match spectrum.request.kind {
        SpectrumKind::Whirl => spectrum.place(0).max(-end)..end,
        _ => 0.0..end,
    }
}

/// File, settings, record and averages of a spectrum.
pub(in crate::report) fn estimated_json(spectrum: &EstimatedSpectrum) -> Value {
    let request = &spectrum.request;
    let channels = request.channels.iter().map(|channel| channel.name());
    let columns = spectrum.columns.iter().map(|of| {
        json!({
            "name": column(spectrum, of.quantity),
            "unit": unit(spectrum, of.quantity),
        })
    });
    let mut json = json!({
        "table": table_name(spectrum),
        "name": request.name,
        "kind": request.kind.name(),
        "channels": channels.collect::<Value>(),
        "over": request.axis,
        "scaling": request.scaling.name(),
        "meaning": meaning(spectrum),
        // whether negative frequencies are kept apart
        "sides": if request.kind == SpectrumKind::Whirl { "two" } else { "one" },
        "window": request.window,
        "coherent_gain": request.window.coherent_gain(),
        "detrend": request.detrend,
        "samples": spectrum.samples,
        "start_s": spectrum.span[0],
        "end_s": spectrum.span[1],
        "segment_samples": spectrum.segment,
        "overlap_samples": spectrum.overlap,
        "averages": spectrum.averages,
        "columns": columns.collect::<Value>(),
        "noise_bandwidth_bins": request.window.equivalent_noise_bandwidth(),
    });
    let [rate, unit] = match request.axis {
        Axis::Frequency => ["sampling_rate_Hz", "Hz"],
        Axis::Order => ["samples_per_revolution", "orders"],
    };
    json[rate] = json!(spectrum.rate);
    json[format!("resolution_{unit}")] = json!(spectrum.resolution);
    json[format!("noise_bandwidth_{unit}")] = json!(spectrum.noise_bandwidth);
    if spectrum.shaft_frequency > 0.0 {
        json["shaft_frequency_Hz"] = json!(spectrum.shaft_frequency);
    }
    if let SpectrumKind::Envelope { band } = request.kind {
        json["band_Hz"] = json!(band);
    }
    if let Some(resampling) = &spectrum.resampling {
        json["resampling"] = resampling_json(resampling);
    }
    if !spectrum.lines.is_empty() {
        let lines = spectrum.lines.iter().map(|line| {
            json!({
                "column": column(spectrum, spectrum.columns[line.column].quantity),
                // in the unit of the axis
                "at": line.place,
                "value": line.value,
                "name": line.line.kind.to_string(),
            })
        });
        json["lines"] = lines.collect();
    }
    json
}

/// The scaling in words.
fn meaning(spectrum: &EstimatedSpectrum) -> String {
    let of = match spectrum.request.kind {
        SpectrumKind::Plain => "",
        SpectrumKind::Envelope { .. } | SpectrumKind::ImpulsiveEnvelope => {
            " of the envelope in band_Hz"
        }
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
    let mut quantities = spectrum.columns.iter().map(|column| column.quantity);
    let phase = match quantities.any(|of| matches!(of, SpectrumQuantity::Phase(_))) {
        true => "; phase of cos(2 pi f t + phase) with t from start_s",
        false => "",
    };
    format!("{what}{of}{phase}")
}

/// How a record over time became one over the angle of the shaft; of a channel with too few samples the error is null.
fn resampling_json(resampling: &Resampling) -> Value {
    let errors = resampling.errors.iter();
    let errors: BTreeMap<_, _> = errors
        .map(|(channel, error)| (channel.name(), error))
        .collect();
    json!({
        "highest_order": 0.5 * resampling.per_revolution as f64,
        "oversampling": resampling.oversampling,
        "share_of_time_too_slow": resampling.coarse_share,
        "interpolation_error": errors,
        "interpolation_error_means": "root mean square of the error over that of the signal about its \
                                      mean, extrapolated from samples left out; null: too few samples",
    })
}
