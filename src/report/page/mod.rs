//! `report.html`: what a run did, in one file that any browser opens from disk, without a network.
//!
//! Numbers come from the summary, which the page holds as a whole; curves are thinned to what a screen shows.

mod answer;
mod frame;

use std::io::{self, Write};

use serde_json::{Value, json};

pub(super) use self::answer::AnswerPage;
pub(super) use self::frame::Frame;
use super::figure::Figure;
use super::histories::Histories;
use super::spectra::{estimated_figure, frequency_limit_of, spectra_figures};
use super::terminal::shown_column;
use crate::analysis::Channel;
use crate::bearing::{BallLine, BearingState};
use crate::rotor::Freedoms;
use crate::simulate::Run;
use crate::table::Column;

const SCRIPT: &str = include_str!("page.js");
const FILM: &str = include_str!("film.js");

/// Writes the page of a run whose numbers stand in `summary`; `figures` are drawn beside its histories and spectra, and
/// `film` shows its end in motion.
pub(super) fn write_page(
    summary: &Value,
    run: &Run,
    histories: &Histories,
    figures: &[&Figure],
    film: Option<Value>,
    out: &mut impl Write,
) -> io::Result<()> {
    let limit = frequency_limit_of(run);
    let spectra = run.spectrum.iter();
    let spectra = spectra.flat_map(|spectrum| spectra_figures(spectrum, &run.peaks));
    let further = run.spectra.iter();
    let further = further.map(|spectrum| estimated_figure("", spectrum, limit));
    let bearings = run.equilibrium.bearings.iter();
    let data = json!({
        "summary": summary,
        "columns": columns(run),
        "balls": bearings.map(|state| state.as_ref().map(balls)).collect::<Value>(),
        "film": film,
        "histories": histories.page_figure(),
        "figures": figures,
        "spectra": spectra.collect::<Vec<_>>(),
        "furtherSpectra": further.collect::<Vec<_>>(),
    });
    let frame = Frame {
        title: summary["title"].as_str().unwrap_or_default(),
        sealed: "summary.json",
        scripts: &[FILM, SCRIPT],
    };
    frame.write(&data, out)
}

/// What the columns of equilibrium, statistics and velocities are called on the page, and their units.
fn columns(run: &Run) -> Value {
    let places = Channel::of_freedoms(Freedoms::All).into_iter();
    let motion = run.motion.iter();
    let statistics = motion.clone().flat_map(|motion| &motion.statistics);
    let velocities = motion.flat_map(|motion| &motion.housing_velocity);
    let severity = run.vibration_severity.iter().map(|own| own.channel);
    let channels = places.chain(statistics.map(|own| own.channel));
    let channels = channels.chain(velocities.map(|own| own.channel));
    let told = |column: Column| {
        let ((name, _), _) = shown_column(&column);
        (column.name(), json!([name, column.unit]))
    };
    let columns = channels.chain(severity).map(Channel::column).map(told);
    Value::Object(columns.collect())
}

/// Every ball of a bearing: azimuth and contact angles in degrees, loads in N.
fn balls(state: &BearingState) -> Value {
    let ball = |line: &BallLine| {
        json!({
            "azimuth": line.azimuth.to_degrees(),
            "load": [line.inner.load, line.outer.load],
            "angle": [line.inner.angle.to_degrees(), line.outer.angle.to_degrees()],
        })
    };
    state.balls.iter().map(ball).collect()
}
