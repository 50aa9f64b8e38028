//! `report.html`: what a run did, in one file that any browser opens from disk, without a network.
//!
//! Numbers come from the summary, which the page holds as a whole; curves are thinned to what a screen
//! shows. The charts are drawn by uPlot (MIT), which stands in the file.

mod balls;
mod curve;
mod frame;
mod further_spectra;
mod histories;
mod orbit;
mod spectra;

use std::io::{self, Write};

use serde_json::{Value, json};

pub(super) use self::frame::{Frame, figures_json};
use self::histories::Histories;
use self::orbit::Orbit;
use super::spectrum::frequency_limit_of;
use crate::rotor::Sample;
use crate::simulate::Run;

const SCRIPT: &str = include_str!("page.js");
const CHARTS: &str = include_str!("uplot/uPlot.iife.min.js");
const CHARTS_STYLE: &str = include_str!("uplot/uPlot.min.css");

/// Collects what the page shows of the samples; its memory does not grow with the run.
#[derive(Debug, Clone)]
pub(super) struct Page {
    histories: Histories,
    orbit: Orbit,
}

impl Page {
    /// For the first `freedoms` of x, y, z, θx, θy.
    pub fn new(freedoms: usize) -> Self {
        Self {
            histories: Histories::new(freedoms),
            orbit: Orbit::default(),
        }
    }

    /// Takes one sample.
    pub fn sample(&mut self, sample: &Sample) {
        self.histories.sample(sample);
        self.orbit.sample(sample);
    }

    /// Takes note of an event since the last sample.
    pub fn event(&mut self) {
        self.histories.event();
    }

    /// Writes the page of a run whose numbers stand in `summary`; `figures` are shown as they are, each an SVG
    /// with its name.
    pub fn write(
        &self,
        summary: &Value,
        run: &Run,
        figures: &[(&str, String)],
        out: &mut impl Write,
    ) -> io::Result<()> {
        let data = json!({
            "summary": summary,
            "balls": balls::balls(&run.equilibrium),
            "histories": self.histories.panels(),
            "orbit": self.orbit.curve(),
            "sections": run.motion.as_ref().map(orbit::sections),
            "figures": figures_json(figures),
            "furtherSpectra": further_spectra(run),
            "spectra": run.spectrum.as_ref().map(|spectrum| spectra::panels(spectrum, &run.peaks)),
        });
        let title = summary["title"].as_str().unwrap_or_default();
        let frame = Frame {
            title,
            sealed: "summary.json",
            styles: CHARTS_STYLE,
            scripts: &[CHARTS, SCRIPT],
        };
        frame.write(&data, out)
    }
}

/// Panels of the spectra that the scenario asks for besides.
fn further_spectra(run: &Run) -> Vec<Value> {
    let limit = frequency_limit_of(run);
    let spectra = run.spectra.iter();
    spectra
        .flat_map(|spectrum| further_spectra::panels(spectrum, limit))
        .collect()
}
