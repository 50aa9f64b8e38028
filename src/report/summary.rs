//! The summary of a run.

use serde::Serialize;

use super::motion::MotionSummary;
use super::run_up::MapsSummary;
use super::spectra::EstimatedSummary;
use super::spectrum::NamedPeak;
use super::text::MethodUseSummary;
use crate::analysis::Spectrum;
use crate::simulate::{MeasuredError, Model, Run};
use crate::study::ContactChoice;
use crate::study::campbell::{Campbell, CriticalSpeed};

/// Everything that a run answers except trace and spectra: `summary.json` is `document` of it.
#[derive(Debug, Serialize)]
pub struct RunSummary<'a> {
    #[serde(flatten)]
    run: &'a Run,
    method_use: Option<MethodUseSummary>,
    measured_error: Option<ErrorSummary<'a>>,
    spectrum: Option<SpectrumSummary<'a>>,
    peaks: Vec<NamedPeak<'a>>,
    motion: Option<MotionSummary<'a>>,
    maps: Option<MapsSummary<'a>>,
    spectra: Vec<EstimatedSummary<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    contact_choice: Option<&'a ContactChoice>,
    #[serde(skip_serializing_if = "Option::is_none")]
    critical_speeds: Option<&'a [CriticalSpeed]>,
}

/// The measured error beside what was asked for.
#[derive(Debug, Serialize)]
struct ErrorSummary<'a> {
    #[serde(flatten)]
    error: &'a MeasuredError,
    tolerance: f64,
    reference_share_of_evaluations: f64,
}

/// How the spectra were made.
#[derive(Debug, Serialize)]
struct SpectrumSummary<'a> {
    #[serde(flatten)]
    spectrum: &'a Spectrum,
    scaling: &'static str,
}

impl<'a> RunSummary<'a> {
    /// The summary of a run of a model, with the law of the contacts that was chosen for it and the natural
    /// frequencies over the speed, where there are any.
    pub fn new(
        model: &Model,
        run: &'a Run,
        contact_choice: Option<&'a ContactChoice>,
        campbell: Option<&'a Campbell>,
    ) -> Self {
        let spectrum = run.spectrum.as_ref();
        let peaks = run.peaks.iter();
        Self {
            run,
            method_use: run.method_use.as_ref().map(MethodUseSummary::from),
            measured_error: run.measured_error.as_ref().map(|error| ErrorSummary {
                error,
                tolerance: model.integrator.tolerance,
                reference_share_of_evaluations: error.share_of_evaluations(&run.counters),
            }),
            spectrum: spectrum.map(|spectrum| SpectrumSummary {
                spectrum,
                scaling: "one-sided, peak values; the mean stands alone at frequency zero, taken away before the window; \
                          phase of cos(2 pi f t + phase) with t from start_s",
            }),
            peaks: peaks.map(|peak| NamedPeak::new(peak, spectrum)).collect(),
            motion: run.motion.as_ref().map(MotionSummary::from),
            maps: run.maps.as_ref().map(MapsSummary::from),
            spectra: run.spectra.iter().map(EstimatedSummary::from).collect(),
            contact_choice,
            critical_speeds: campbell.map(|campbell| &campbell.critical_speeds[..]),
        }
    }
}
