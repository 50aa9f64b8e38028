//! How a spectrum was made, for the summary: what it takes to make it again.

use std::collections::BTreeMap;

use serde::Serialize;

use super::{names, table_name};
use crate::analysis::{
    Axis, EstimatedSpectrum, Resampling, Scaling, SpectrumKind, SpectrumQuantity,
};

/// File, settings, record and averages of a spectrum.
#[derive(Debug, Serialize)]
pub(in crate::report) struct EstimatedSummary<'a> {
    table: String,
    name: &'a str,
    kind: &'static str,
    channels: Vec<&'static str>,
    over: &'static str,
    scaling: &'static str,
    /// The scaling in words.
    meaning: String,
    /// `one` or `two`: whether negative frequencies stand apart.
    sides: &'static str,
    window: &'static str,
    coherent_gain: f64,
    detrend: &'static str,
    /// Samples of the record.
    samples: usize,
    start_s: f64,
    end_s: f64,
    segment_samples: usize,
    overlap_samples: usize,
    averages: usize,
    columns: Vec<ColumnSummary>,
    noise_bandwidth_bins: f64,
    #[serde(flatten)]
    axis: AxisSummary,
    #[serde(rename = "shaft_frequency_Hz", skip_serializing_if = "Option::is_none")]
    shaft_frequency: Option<f64>,
    /// Band of an envelope.
    #[serde(rename = "band_Hz", skip_serializing_if = "Option::is_none")]
    band: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    resampling: Option<ResamplingSummary>,
}

/// A column of the table.
#[derive(Debug, Serialize)]
struct ColumnSummary {
    name: String,
    unit: String,
}

/// What has the unit of the axis.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum AxisSummary {
    Frequency {
        #[serde(rename = "sampling_rate_Hz")]
        rate: f64,
        #[serde(rename = "resolution_Hz")]
        resolution: f64,
        #[serde(rename = "noise_bandwidth_Hz")]
        bandwidth: f64,
    },
    Order {
        #[serde(rename = "samples_per_revolution")]
        rate: f64,
        #[serde(rename = "resolution_orders")]
        resolution: f64,
        #[serde(rename = "noise_bandwidth_orders")]
        bandwidth: f64,
    },
}

/// How a record over time became one over the angle of the shaft.
#[derive(Debug, Serialize)]
struct ResamplingSummary {
    highest_order: f64,
    oversampling: usize,
    share_of_time_too_slow: f64,
    /// By channel; null: too few samples.
    interpolation_error: BTreeMap<&'static str, Option<f64>>,
    interpolation_error_means: &'static str,
}

impl<'a> From<&'a EstimatedSpectrum> for EstimatedSummary<'a> {
    fn from(spectrum: &'a EstimatedSpectrum) -> Self {
        let request = &spectrum.request;
        let column = |quantity| ColumnSummary {
            name: names::column(spectrum, quantity),
            unit: names::unit(spectrum, quantity),
        };
        let columns = spectrum.columns.iter();
        Self {
            table: table_name(spectrum),
            name: &request.name,
            kind: request.kind.name(),
            channels: request
                .channels
                .iter()
                .map(|channel| channel.name())
                .collect(),
            over: request.axis.name(),
            scaling: request.scaling.name(),
            meaning: meaning(spectrum),
            sides: if request.kind == SpectrumKind::Whirl {
                "two"
            } else {
                "one"
            },
            window: request.window.name(),
            coherent_gain: request.window.coherent_gain(),
            detrend: request.detrend.name(),
            samples: spectrum.samples,
            start_s: spectrum.span[0],
            end_s: spectrum.span[1],
            segment_samples: spectrum.segment,
            overlap_samples: spectrum.overlap,
            averages: spectrum.averages,
            columns: columns.map(|of| column(of.quantity)).collect(),
            noise_bandwidth_bins: request.window.equivalent_noise_bandwidth(),
            axis: axis(spectrum),
            shaft_frequency: Some(spectrum.shaft_frequency).filter(|frequency| *frequency > 0.0),
            band: match request.kind {
                SpectrumKind::Envelope { band } => Some(band),
                _ => None,
            },
            resampling: spectrum.resampling.as_ref().map(resampled),
        }
    }
}

fn axis(spectrum: &EstimatedSpectrum) -> AxisSummary {
    let (rate, resolution) = (spectrum.rate, spectrum.resolution);
    let bandwidth = spectrum.noise_bandwidth;
    match spectrum.request.axis {
        Axis::Frequency => AxisSummary::Frequency {
            rate,
            resolution,
            bandwidth,
        },
        Axis::Order => AxisSummary::Order {
            rate,
            resolution,
            bandwidth,
        },
    }
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
    let is_phase = |quantity| matches!(quantity, SpectrumQuantity::Phase(_));
    let mut columns = spectrum.columns.iter();
    let phase = match columns.any(|column| is_phase(column.quantity)) {
        true => "; phase of cos(2 pi f t + phase) with t from start_s",
        false => "",
    };
    format!("{what}{of}{phase}")
}

fn resampled(resampling: &Resampling) -> ResamplingSummary {
    let errors = resampling.errors.iter();
    ResamplingSummary {
        highest_order: 0.5 * resampling.per_revolution as f64,
        oversampling: resampling.oversampling,
        share_of_time_too_slow: resampling.coarse_share,
        interpolation_error: errors
            .map(|(channel, error)| (channel.name(), *error))
            .collect(),
        interpolation_error_means: "root mean square of the error over that of the signal about its \
                                    mean, extrapolated from samples left out; null: too few samples",
    }
}
