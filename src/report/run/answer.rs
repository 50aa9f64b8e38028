//! What a run answers besides its trace: its document, its text, its figures and its tables.

use serde::Serialize;
use serde_json::{Value, json};

use super::defects;
use super::film::Film;
use super::histories::Histories;
use super::method_use::{method_use_json, parted};
use super::motion::{motion_json, orbit_figure, poincare_table};
use super::order_tracks::tracks_table;
use super::run_up::{maps_figures, maps_json, run_up_json};
use super::text::text;
use crate::analysis::{EstimatedSpectrum, Peak, Spectrum};
use crate::report::compare::{Overlay, overlay_figures};
use crate::report::figure::Figure;
use crate::report::findings::{Findings, with_keys};
use crate::report::rolling_elements::balls_figure;
use crate::report::scene::scene_figure;
use crate::report::spectra::{
    estimated_figures, estimated_json, estimated_table, frequency_limit_of, peak_table,
    spectra_figures, spectrum_table, table_name,
};
use crate::report::{FileSet, SensitivityTable, campbell, spectrum_figure};
use crate::scenario::Scenario;
use crate::simulate::{Maps, Model, Run};
use crate::study::campbell::{Campbell, CriticalSpeed};
use crate::table::Table;

/// What was taken down for the figures while a run went on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Drawn<'a> {
    pub histories: Option<&'a Histories>,
    pub film: Option<&'a Film>,
}

/// A run, and what its answers rest on.
#[derive(Debug, Clone, Copy)]
pub(super) struct RunAnswer<'a> {
    /// What it was made from.
    pub scenario: &'a Scenario,
    /// What ran.
    pub model: &'a Model,
    /// What it gave.
    pub run: &'a Run,
    /// Natural frequencies over the speed, where that changes.
    pub campbell: Option<&'a Campbell>,
    /// Spectra of records that are laid over its own.
    pub measured: &'a [Overlay],
    /// How its numbers change, where that is asked for.
    pub sensitivity: Option<&'a SensitivityTable>,
}

impl<'a> RunAnswer<'a> {
    /// What is reported of it, without its own tables and figures.
    pub fn reported(&self) -> Findings {
        self.with_sensitivity(self.bare())
    }

    fn bare(&self) -> Findings {
        let text = text(&self.scenario.title, self.model, self.run, self.campbell);
        Findings::new(FileSet::MOTION, self.scenario, RunSummary::new(self), text)
    }

    fn with_sensitivity(&self, mut findings: Findings) -> Findings {
        if let Some(found) = self.sensitivity {
            findings.add_sensitivity(found);
        }
        findings
    }

    /// All of it but the tables that are too large to be held twice.
    pub fn findings(&self, drawn: Drawn<'_>) -> Findings {
        let peaks = self.peaks().map(|table| ("peaks", table));
        self.with_sensitivity(Findings {
            tables: peaks.into_iter().collect(),
            figures: self.figures(drawn.histories),
            film: drawn.film.and_then(|film| film.json(&self.model.rotor)),
            ..self.bare()
        })
    }

    /// What is drawn of a run, in the order of its page.
    fn figures(&self, histories: Option<&Histories>) -> Vec<Figure> {
        let Self {
            scenario,
            model,
            run,
            campbell,
            measured,
            ..
        } = *self;
        let title = &scenario.title;
        let limit = frequency_limit_of(run);
        let named = |named| estimated_figures(title, &run.spectra, named, limit);
        let spectrum = run.spectrum.as_ref();
        let mut figures = Vec::new();
        if !measured.is_empty() {
            let own = Overlay::new("simulated", spectrum, &run.spectra);
            figures = overlay_figures(&[&[own], measured].concat());
        }
        figures.extend(named(true));
        let spectra = |spectrum| spectra_figures(title, spectrum, &run.peaks);
        let mut spectra = spectrum.map_or_else(Vec::new, spectra).into_iter();
        // the velocities first
        figures.extend(spectra.next());
        figures.extend(histories.map(|histories| histories.displacements("trace", title)));
        figures.extend(spectrum.map(|spectrum| spectrum_figure(title, spectrum, &run.peaks)));
        let motion = run.motion.as_ref();
        figures.extend(motion.map(|motion| orbit_figure(title, motion)));
        figures.extend(run.maps.iter().flat_map(|maps| maps_figures(title, maps)));
        figures.extend(campbell.map(|campbell| campbell::figure(title, campbell, &[])));
        figures.extend(named(false));
        figures.extend(defects::figure(title, model));
        figures.extend(spectra);
        figures.extend(histories.and_then(|histories| histories.others(title)));
        figures.push(scene_figure(title, &model.rotor).only_on_page());
        let bearings: Vec<_> = run.equilibrium.bearings.iter().flatten().collect();
        figures.extend(balls_figure(title, &bearings).map(Figure::only_on_page));
        figures
    }

    /// The named peaks of the spectrum.
    pub fn peaks(&self) -> Option<Table<'static>> {
        let spectrum = self.run.spectrum.as_ref()?;
        Some(peak_table(&self.run.peaks, spectrum))
    }

    /// Tables of a run that are known at its end, but for peaks and the waterfall.
    pub fn tables(&self) -> Vec<(String, Table<'a>)> {
        let Self { run, campbell, .. } = *self;
        let mut tables = Vec::new();
        let mut add = |name: &str, table| tables.push((name.to_owned(), table));
        if let Some(spectrum) = &run.spectrum {
            add("spectrum", spectrum_table(spectrum));
        }
        if let Some(motion) = &run.motion {
            add("poincare", poincare_table(motion));
        }
        if let Some(maps) = &run.maps {
            add("order_tracks", tracks_table(&maps.tracks));
        }
        if let Some(campbell) = campbell {
            add("campbell", campbell::modes(campbell));
        }
        for spectrum in &run.spectra {
            add(&table_name(spectrum), estimated_table(spectrum));
        }
        tables
    }
}

/// Everything that a run answers except trace and spectra: `summary.json` is its document.
#[derive(Debug, Serialize)]
struct RunSummary<'a> {
    #[serde(flatten)]
    run: &'a Run,
    method_use: Option<Value>,
    measured_error: Option<Value>,
    #[serde(flatten)]
    spectra: SpectraSummary,
    motion: Option<Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    run_up: Option<Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    critical_speeds: Option<&'a [CriticalSpeed]>,
}

/// What the document of a run or a record has of its spectra.
#[derive(Debug, Serialize)]
pub(in crate::report) struct SpectraSummary {
    spectrum: Option<Value>,
    peaks: Value,
    maps: Option<Value>,
    spectra: Vec<Value>,
}

impl SpectraSummary {
    /// Of a spectrum with its peaks, of maps of a speed that changes, and of further spectra.
    pub fn new(
        spectrum: Option<&Spectrum>,
        peaks: &[Peak],
        maps: Option<&Maps>,
        spectra: &[EstimatedSpectrum],
    ) -> Self {
        let peaks = spectrum.map(|spectrum| peak_table(peaks, spectrum));
        Self {
            spectrum: spectrum.map(|spectrum| with_keys(spectrum, json!({ "scaling": SCALING }))),
            peaks: peaks.unwrap_or_default().records(),
            maps: maps.map(maps_json),
            spectra: spectra.iter().map(estimated_json).collect(),
        }
    }
}

/// How the spectra were made.
const SCALING: &str = "one-sided, peak values; the mean is alone at frequency zero, taken away before the window; \
                       phase of cos(2 pi f t + phase) with t from start_s";

impl<'a> RunSummary<'a> {
    fn new(of: &RunAnswer<'a>) -> Self {
        let RunAnswer {
            model,
            run,
            campbell,
            ..
        } = *of;
        Self {
            run,
            method_use: run
                .method_use
                .as_ref()
                .map(|used| method_use_json(used, parted(&run.bearings))),
            measured_error: run.measured_error.as_ref().map(|error| {
                let further = json!({
                    "tolerance": model.integrator.tolerance,
                    "reference_share_of_evaluations": error.share_of_evaluations(&run.counters),
                });
                with_keys(error, further)
            }),
            spectra: SpectraSummary::new(
                run.spectrum.as_ref(),
                &run.peaks,
                run.maps.as_ref(),
                &run.spectra,
            ),
            motion: run.motion.as_ref().map(motion_json),
            run_up: run
                .run_up
                .as_ref()
                .map(|run_up| run_up_json(run_up, campbell)),
            critical_speeds: campbell.map(|campbell| &campbell.critical_speeds[..]),
        }
    }
}
