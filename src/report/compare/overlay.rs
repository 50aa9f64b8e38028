//! Spectra of several results over each other in one unit, as of a record and a simulation.

use std::path::Path;

use super::page::{Folder, thinned};
use crate::analysis::{EstimatedSpectrum, Spectrum, SpectrumKind, velocity_rate};
use crate::physics::velocity_band;
use crate::report::ReportError;
use crate::report::figure::{Axis, Curve, Figure, Name, Panel, Point, distinct, ends};
use crate::report::spectra::{estimated_table, spectrum_table};
use crate::report::terminal::{MILLI, shown_column, shown_quantity, shown_unit};
use crate::scenario::load_record;
use crate::table::{Column, ColumnKind, Table};

/// Height of a plot, px.
const HEIGHT: u32 = 340;
/// Columns of a result that are shown of one unit.
const MOST_COLUMNS: usize = 4;
/// Points of a curve.
const MOST_POINTS: usize = 8_000;

/// The spectra of a result, to be drawn over those of others.
#[derive(Debug, Clone)]
pub(in crate::report) struct Overlay {
    name: String,
    spectrum: Option<Table<'static>>,
    envelopes: Vec<Table<'static>>,
}

impl Overlay {
    /// Of a folder of `run` or `analyze`, of a record, or of a file that describes one.
    ///
    /// # Errors
    /// [`ReportError::Measured`] where it cannot be read or analysed.
    pub fn load(path: &Path) -> Result<Self, ReportError> {
        let wrong = |message: String| ReportError::Measured {
            path: path.to_owned(),
            message,
        };
        if path.is_dir() {
            let folder = Folder::open(path).map_err(|error| wrong(error.with_causes()))?;
            return Ok(folder.overlay(&folder.name));
        }
        let file = load_record(path, "{}", &[]).map_err(|error| wrong(error.render(false)))?;
        let found = file.measurement.analyse();
        let name = path.file_stem().unwrap_or(path.as_os_str());
        let name = name.to_string_lossy();
        Ok(Self::new(&name, found.spectrum.as_ref(), &found.spectra))
    }

    /// Of what was estimated.
    pub fn new(name: &str, spectrum: Option<&Spectrum>, spectra: &[EstimatedSpectrum]) -> Self {
        let is_envelope =
            |of: &&EstimatedSpectrum| matches!(of.request.kind, SpectrumKind::Envelope { .. });
        let envelopes = spectra.iter().filter(is_envelope);
        Self {
            name: name.to_owned(),
            spectrum: spectrum.map(|spectrum| spectrum_table(spectrum).into_owned()),
            envelopes: envelopes
                .map(|of| estimated_table(of).into_owned())
                .collect(),
        }
    }

    /// Of tables that were read.
    pub fn from_tables(
        name: String,
        spectrum: Option<Table<'static>>,
        envelopes: Vec<Table<'static>>,
    ) -> Self {
        Self {
            name,
            spectrum,
            envelopes,
        }
    }
}

/// Curves of one unit over one axis.
struct Group {
    over: Column,
    label: (String, String),
    /// Of which result each is, its name, and its points.
    curves: Vec<(usize, String, Vec<Point>)>,
}

/// The figures of results over each other: their velocities, and envelopes of which more than one result has one of the same unit.
pub(in crate::report) fn overlay_figures(results: &[Overlay]) -> Vec<Figure> {
    let mut groups: Vec<Group> = Vec::new();
    for (index, result) in results.iter().enumerate() {
        let name =
            |column: &Column| format!("{}: {}", result.name, shown_quantity(&column.quantity));
        let spectrum = result.spectrum.iter().flat_map(velocities);
        let spectrum = spectrum.map(|(over, column, points)| {
            (
                over,
                ("velocity".to_owned(), "mm/s".to_owned()),
                name(column),
                points,
            )
        });
        let envelopes = result.envelopes.iter().flat_map(with_lines);
        let envelopes = envelopes.map(|(over, column, places, values)| {
            let (unit, factor) = shown_unit(&column.unit);
            let points = places
                .iter()
                .copied()
                .zip(values.iter().map(|value| factor * value));
            (
                over,
                ("envelope".to_owned(), unit),
                name(column),
                points.collect(),
            )
        });
        for (over, label, name, points) in spectrum.chain(envelopes) {
            let known = groups
                .iter()
                .position(|group| group.over == *over && group.label == label);
            let place = known.unwrap_or_else(|| {
                groups.push(Group {
                    over: over.clone(),
                    label,
                    curves: Vec::new(),
                });
                groups.len() - 1
            });
            groups[place].curves.push((index, name, points));
        }
    }
    let is_shared = |group: &Group| {
        let mut of = group.curves.iter().map(|(result, ..)| *result);
        let first = of.next();
        of.any(|other| Some(other) != first)
    };
    let shared = groups.into_iter().filter(is_shared);
    let panels: Vec<Panel> = shared.map(Group::panel).collect();
    let names = results.iter().map(|result| result.name.as_str());
    let title = names.collect::<Vec<_>>().join(" and ");
    match panels.is_empty() {
        true => Vec::new(),
        false => vec![Figure::new("measured", &title, 1, panels)],
    }
}

impl Group {
    fn panel(self) -> Panel {
        let last =
            |points: &[Point]| ends(points.iter().map(|point| point.0)).map_or(0.0, |it| it[1]);
        let shown = self.curves.iter().map(|(.., points)| last(points));
        let shown = shown.fold(f64::INFINITY, f64::min);
        let values = self.curves.iter().flat_map(|(.., points)| points);
        let strongest = values.fold(0.0, |most: f64, point| most.max(point.1));
        let names = Name::each(self.curves.iter().map(|(_, name, _)| name.as_str()));
        let curves = self
            .curves
            .into_iter()
            .enumerate()
            .map(|(index, (.., points))| {
                Curve::line(distinct(index), thinned(points.into_iter(), MOST_POINTS))
            });
        let (label, _) = shown_column(&self.over);
        Panel {
            curves: curves.collect(),
            names,
            ..Panel::new(
                Axis::over(label, 0.0..shown),
                Axis::below(self.label, strongest),
                HEIGHT,
            )
        }
    }
}

/// The columns of a table that have lines, with its first one: columns, places and values.
fn with_lines<'a>(
    table: &'a Table<'static>,
) -> impl Iterator<Item = (&'a Column, &'a Column, &'a [f64], &'a [f64])> {
    let first = table.iter().next();
    let columns = table.iter().filter(|(column, _)| column.has_lines());
    let columns = columns.take(MOST_COLUMNS);
    columns.filter_map(move |(column, values)| {
        let (over, places) = first?;
        Some((over, column, places, values))
    })
}

/// What makes velocities in mm/s of a table: accelerations where it has them, else displacements or velocities.
fn velocities<'a>(
    table: &'a Table<'static>,
) -> impl Iterator<Item = (&'a Column, &'a Column, Vec<Point>)> {
    let is_amplitude = |column: &Column| column.kind == ColumnKind::Measure("amplitude");
    let has_acceleration = table
        .iter()
        .any(|(column, _)| is_amplitude(column) && column.unit == "m/s^2");
    let first = table.iter().next();
    let columns = table.iter().filter(move |(column, _)| {
        let is_shown = match has_acceleration {
            true => column.unit == "m/s^2",
            false => column.unit == "m" || column.unit == "m/s",
        };
        is_amplitude(column) && is_shown
    });
    let columns = columns.take(MOST_COLUMNS);
    columns.filter_map(move |(column, values)| {
        let (over, places) = first?;
        let rate = velocity_rate(&column.unit).unwrap_or(|_| 1.0);
        // below, integrated accelerations show their noise; the mean is no vibration
        let lowest = match has_acceleration {
            true => velocity_band(f64::INFINITY)[0],
            false => 0.0,
        };
        let points = places.iter().zip(values).filter(|(at, _)| **at > lowest);
        let points = points.map(|(at, value)| (*at, MILLI * rate(*at) * value));
        Some((over, column, points.collect()))
    })
}
