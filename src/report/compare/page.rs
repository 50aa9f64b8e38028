//! The page of results that were compared: of runs also their key numbers side by side, their traces and spectra over
//! each other.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::figure::difference_figure;
use super::key_numbers::{rate_of, tell_key_numbers};
use super::overlay::{Overlay, overlay_figures};
use super::table::Source;
use super::{CompareError, Comparison, document, sealed};
use crate::analysis::{Channel, Rate};
use crate::numerics::distinct::each_once;
use crate::report::envelope::Decimator;
use crate::report::figure::{Axis, Curve, Figure, Name, Panel, Point, distinct, ends};
use crate::report::page::Page;
use crate::report::spectra::content_limit;
use crate::report::terminal::{Lines, MILLI, shown_column, shown_quantity};
use crate::table::Column;

/// Height of a plot, px.
const HEIGHT: u32 = 190;

/// Points of all curves of a quantity together, so that the page stays small.
const MOST_POINTS: usize = 40_000;

/// What is drawn of the traces.
const TRACES: [Channel; 6] = [
    Channel::Displacement(0),
    Channel::Displacement(1),
    Channel::Displacement(2),
    Channel::Displacement(3),
    Channel::Displacement(4),
    Channel::LargestBallLoad,
];

/// A run or a record as its folder has it.
pub(super) struct Folder {
    pub name: String,
    pub trace: Option<Source<'static>>,
    pub spectrum: Option<Source<'static>>,
    /// Spectra that its scenario asks for, by their names.
    pub estimated: Vec<(String, Source<'static>)>,
    pub summary: Value,
}

impl Folder {
    /// Up to which place of an axis its own figures show spectra.
    fn content_limit(&self, over: &Column) -> f64 {
        let peaks = self.summary["peaks"].as_array().into_iter().flatten();
        let peaks = peaks.filter_map(|peak| Some((peak["unit"].as_str()?, peak["f_Hz"].as_f64()?)));
        let shaft = self.summary.pointer("/spectrum/shaft_frequency_Hz");
        let shaft = shaft.and_then(Value::as_f64).unwrap_or(0.0);
        let limit = content_limit(peaks, shaft);
        match *over == Column::frequency() {
            true => limit,
            false if shaft > 0.0 => limit / shaft,
            false => f64::INFINITY,
        }
    }

    /// Reads a folder.
    pub fn open(path: &Path) -> Result<Self, CompareError> {
        let table = |name: &str| {
            let file = path.join(name);
            file.exists().then(|| Source::open(&file)).transpose()
        };
        let summary = sealed(path)?;
        let asked = summary["spectra"].as_array().into_iter().flatten();
        let asked = asked.filter_map(|spectrum| spectrum["table"].as_str());
        let read = |name: &str| Ok(Some((name.to_owned(), table(&format!("{name}.csv"))?)));
        let estimated = asked.filter_map(|name| read(name).transpose());
        let estimated: Vec<(String, Option<_>)> = estimated.collect::<Result<_, CompareError>>()?;
        let estimated = estimated
            .into_iter()
            .filter_map(|(name, table)| Some((name, table?)));
        let name = path.file_name().unwrap_or(path.as_os_str());
        Ok(Self {
            name: name.to_string_lossy().into_owned(),
            trace: table("trace.csv")?,
            spectrum: table("spectrum.csv")?,
            estimated: estimated.collect(),
            summary,
        })
    }

    /// Names of the spectra that its scenario asks for.
    fn asked(&self) -> impl Iterator<Item = &str> {
        self.estimated.iter().map(|(name, _)| name.as_str())
    }

    /// One of them.
    fn estimated(&self, name: &str) -> Option<&Source<'static>> {
        let found = self.estimated.iter().find(|(known, _)| known == name);
        found.map(|(_, table)| table)
    }

    /// Its spectra, to be drawn over those of others.
    pub fn overlay(&self, name: &str) -> Overlay {
        let asked = self.summary["spectra"].as_array().into_iter().flatten();
        let envelopes = asked.filter(|spectrum| spectrum["kind"] == "envelope");
        let names: Vec<_> = envelopes.map(|spectrum| &spectrum["table"]).collect();
        let envelopes = self.estimated.iter();
        let envelopes = envelopes.filter(|(name, _)| names.iter().any(|known| **known == **name));
        Overlay::from_tables(
            name.to_owned(),
            self.spectrum.as_ref().map(|source| source.table.clone()),
            envelopes.map(|(_, source)| source.table.clone()).collect(),
        )
    }
}

/// Writes the page of results of which each further one was compared with the first.
///
/// # Errors
/// [`CompareError`] where a table cannot be read again or the page not be written.
pub(crate) fn write_page(
    compared: &[PathBuf],
    comparisons: &[Comparison],
    file: &Path,
) -> Result<(), CompareError> {
    let (mut lines, mut figures) = (Lines::default(), Vec::new());
    if compared.iter().all(|path| path.is_dir()) {
        figures.extend(show_runs(compared, &mut lines)?);
    }
    for (number, (comparison, other)) in (1..).zip(comparisons.iter().zip(&compared[1..])) {
        let name = format!("comparison_{number}");
        let figure = difference_figure(&name, comparison, [&compared[0], other])?;
        lines.put(&figure.title);
        comparison.tell(&mut lines);
        figures.push(figure);
    }
    let names = compared.iter().map(|path| path.display().to_string());
    let page = Page {
        title: &names.collect::<Vec<_>>().join(" and "),
        sealed: "the tables that were compared",
        text: &lines,
        figures: &figures,
        film: None,
        tables: &[],
        document: &document(comparisons),
    };
    Ok(page.write_alone(file)?)
}

/// Tells the key numbers of runs; returns the figures of their traces and spectra.
fn show_runs(folders: &[PathBuf], lines: &mut Lines) -> Result<Vec<Figure>, CompareError> {
    let runs = folders.iter().map(|folder| Folder::open(folder));
    let runs = runs.collect::<Result<Vec<_>, _>>()?;
    let names = names(&runs, folders);
    tell_key_numbers(&runs, &names, lines);
    let traces = TRACES.map(Channel::column);
    let lines = runs.iter().filter_map(|run| run.spectrum.as_ref());
    let lines = lines.flat_map(Source::columns);
    let lines = lines.filter(|column| rate_of(column).is_some());
    let mut lines = each_once(lines.cloned());
    // the housings, which machines are judged by, first
    lines.sort_by_key(|column| column.unit != "m/s^2");
    let mut measured = Vec::new();
    let mut figures = vec![
        figure("velocity_spectra", &runs, &lines, rate_of, &|run| {
            run.spectrum.as_ref()
        }),
        figure("traces", &runs, &traces, |_| None, &|run| {
            run.trace.as_ref()
        }),
    ];
    let has_record = runs.iter().any(|run| run.summary["motion"].is_null());
    if has_record {
        // its channels need not be called as those of a run
        let overlays = runs.iter().zip(&names);
        let overlays: Vec<Overlay> = overlays.map(|(run, name)| run.overlay(name)).collect();
        measured = overlay_figures(&overlays);
    }
    for name in each_once(runs.iter().flat_map(Folder::asked)) {
        let columns = runs.iter().find_map(|run| run.estimated(name));
        let columns = columns.into_iter().flat_map(Source::columns);
        let columns = columns.filter(|column| column.has_lines());
        let columns: Vec<_> = columns.cloned().collect();
        figures.push(figure(name, &runs, &columns, |_| None, &|run| {
            run.estimated(name)
        }));
    }
    let names = || Name::each(names.iter().map(String::as_str));
    let figures = figures.into_iter().flatten();
    measured.extend(figures.map(|figure| figure.with_names(names())));
    Ok(measured)
}

/// What the runs are called: their folders, with all of the path where two are called alike.
fn names(runs: &[Folder], folders: &[PathBuf]) -> Vec<String> {
    let alike = |name: &str| runs.iter().filter(|run| run.name == name).count() > 1;
    let both = runs.iter().zip(folders);
    let name = |(run, path): (&Folder, &PathBuf)| match alike(&run.name) {
        true => path.display().to_string(),
        false => run.name.clone(),
    };
    both.map(name).collect()
}

/// A panel a column that any of the runs has, a curve a run, as velocities where there is a rate; none where no run has such a
/// table.
fn figure(
    file: &str,
    runs: &[Folder],
    columns: &[Column],
    rate: fn(&Column) -> Option<Rate>,
    table: &dyn Fn(&Folder) -> Option<&Source<'static>>,
) -> Option<Figure> {
    let is_spectrum = file != "traces";
    let tables: Vec<Option<&Source<'_>>> = runs.iter().map(table).collect();
    let columns = columns.iter().filter(|column| {
        let mut tables = tables.iter().flatten();
        tables.any(|table| table.largest(column) > 0.0)
    });
    let axes = tables.iter().flatten().flat_map(|table| table.axis().1);
    let reach = ends(axes.copied())?;
    let over = tables.iter().flatten().next()?.axis().0;
    let limit = runs.iter().map(|run| run.content_limit(over));
    let limit = limit.fold(0.0, f64::max);
    let shown = match is_spectrum {
        true => reach[0].max(-limit)..reach[1].min(limit),
        false => reach[0]..reach[1],
    };
    let over = Axis {
        reach: Some(reach),
        ..Axis::over(shown_column(over).0, shown)
    };
    let panels = columns.map(|column| {
        let (label, factor) = match rate(column) {
            Some(_) => {
                let of = shown_quantity(&column.quantity).replace(" acceleration", "");
                ((format!("velocity of {of}"), "mm/s".to_owned()), MILLI)
            }
            None => shown_column(column),
        };
        let curves = tables.iter().enumerate().filter_map(|(index, table)| {
            let table = (*table)?;
            let values = table.values(column)?.iter().map(|value| factor * value);
            let points = table.axis().1.iter().copied().zip(values);
            // the mean is listed apart from what vibrates
            let points = points.filter(|(at, _)| !is_spectrum || *at > 0.0);
            let rate = rate(column).unwrap_or(|_| 1.0);
            let points = points.map(|(at, value)| (at, rate(at) * value));
            let points = thinned(points, MOST_POINTS / runs.len());
            Some(Curve::line(distinct(index), points))
        });
        let curves: Vec<Curve> = curves.collect();
        if !is_spectrum {
            return Panel::holding(over.clone(), label, HEIGHT, curves);
        }
        let points = curves.iter().flat_map(|curve| &curve.points);
        let strongest = points.fold(0.0, |most: f64, point| most.max(point.1));
        Panel {
            curves,
            ..Panel::new(over.clone(), Axis::below(label, strongest), HEIGHT)
        }
    });
    let panels: Vec<Panel> = panels.collect();
    (!panels.is_empty()).then(|| Figure::new(file, "", 1, panels))
}

/// All points, or of too many the lowest and the highest of every stretch.
pub(super) fn thinned(points: impl Iterator<Item = Point> + Clone, most: usize) -> Vec<Point> {
    let finite = points.filter(|(_, value)| value.is_finite());
    if finite.clone().count() <= most {
        return finite.collect();
    }
    let mut envelope = Decimator::new(most / 2);
    finite.for_each(|(at, value)| envelope.push(at, value));
    envelope.points().collect()
}
