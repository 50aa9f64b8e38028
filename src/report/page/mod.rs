//! `report.html`: what a run did, in one file that any browser opens from disk, without a network.
//!
//! Numbers come from the summary, which the page holds as a whole; curves are thinned to what a screen
//! shows. The charts are drawn by uPlot (MIT), which stands in the file.

mod balls;
mod curve;
mod histories;
mod orbit;
mod spectra;

use std::io::{self, Write};

use serde_json::{Value, json};

use self::histories::Histories;
use self::orbit::Orbit;
use crate::rotor::Sample;
use crate::simulate::Run;

const FRAME: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");
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
            "figures": figures.iter().map(|(name, svg)| json!({ "name": name, "svg": svg })).collect::<Value>(),
            "spectra": run.spectrum.as_ref().map(|spectrum| spectra::panels(spectrum, &run.peaks)),
        });
        let title = summary["title"].as_str().unwrap_or_default();
        let parts = [
            ("title", escaped(title)),
            ("style", [CHARTS_STYLE, STYLE].concat()),
            // no text in the data can end the element that it stands in
            ("data", data.to_string().replace('<', "\\u003c")),
            ("script", [CHARTS, SCRIPT].concat()),
        ];
        fill(FRAME, &parts, out)
    }
}

/// Writes the frame with every `{{name}}` replaced by the part of that name.
fn fill(frame: &str, parts: &[(&str, String)], out: &mut impl Write) -> io::Result<()> {
    let mut pieces = frame.split("{{");
    out.write_all(pieces.next().unwrap_or_default().as_bytes())?;
    for piece in pieces {
        let (name, rest) = piece.split_once("}}").unwrap_or(("", piece));
        let part = parts.iter().find(|(part, _)| *part == name);
        if let Some((_, text)) = part {
            out.write_all(text.as_bytes())?;
        }
        out.write_all(rest.as_bytes())?;
    }
    Ok(())
}

/// Text as it may stand in HTML.
fn escaped(text: &str) -> String {
    let mut html = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => html += "&amp;",
            '<' => html += "&lt;",
            '>' => html += "&gt;",
            '"' => html += "&quot;",
            c if c.is_control() => html.push(' '),
            c => html.push(c),
        }
    }
    html
}
