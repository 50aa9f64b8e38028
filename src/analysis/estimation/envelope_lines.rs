//! Named lines of an envelope spectrum.

use super::{Axis, EnvelopeLine, EstimatedSpectrum, SpectrumKind, SpectrumQuantity};
use crate::analysis::{Channel, Line, Precision, is_above_noise, magnitude, nearest_cause};

/// Lines sought in a column, the strongest.
const MOST_LINES: usize = 12;
/// Part of the strongest line from which on others count.
const LEAST_PART: f64 = 0.02;
/// Bins within which the place of a maximum between them is known.
const BINS_KNOWN: f64 = 0.25;
/// Bins at zero frequency that hold what the window makes of the mean.
const MEAN_BINS: usize = 3;

impl EstimatedSpectrum {
    /// Names the lines of an envelope by what can cause them; of a shaft whose speed changes, and of other spectra, none.
    pub(crate) fn name_lines(&mut self, causes: &[Line]) {
        if self.shaft_frequency == 0.0 {
            return;
        }
        let unit = match self.request.axis {
            Axis::Frequency => 1.0,
            Axis::Order => self.shaft_frequency,
        };
        self.name_lines_in(unit, causes);
    }

    /// Names the lines of an envelope whose axis has so many Hz a unit.
    pub(crate) fn name_lines_in(&mut self, unit: f64, causes: &[Line]) {
        if !matches!(self.request.kind, SpectrumKind::Envelope { .. }) {
            return;
        }
        let resolution = self.resolution;
        let lines = self.value_columns().flat_map(|index| {
            let strongest = strongest_maxima(&self.columns[index].values);
            let mut maxima: Vec<_> = strongest.map(|bin| self.refined(index, bin)).collect();
            maxima.sort_by(|a, b| b.1.total_cmp(&a.1));
            maxima.into_iter().filter_map(move |(place, value)| {
                let precision = Precision {
                    resolution: resolution * unit,
                    uncertainty: BINS_KNOWN * resolution * unit,
                };
                let line = nearest_cause(place * unit, precision, causes)?;
                Some(EnvelopeLine {
                    column: index,
                    place,
                    value,
                    line,
                })
            })
        });
        self.lines = lines.collect();
    }

    /// Numbers of the columns that hold values, and no phases.
    pub(crate) fn value_columns(&self) -> impl Iterator<Item = usize> {
        let columns = self.columns.iter().enumerate();
        let of_values =
            columns.filter(|(_, column)| matches!(column.quantity, SpectrumQuantity::Value(_)));
        of_values.map(|(index, _)| index)
    }

    /// The line that makes the maximum of a column at a bin: its place in units of the axis and the value that it would have on a bin.
    fn refined(&self, column: usize, bin: usize) -> (f64, f64) {
        let (values, is_square) = (
            &self.columns[column].values,
            self.request.scaling.is_square(),
        );
        let part = |neighbour: usize| {
            let part = values[neighbour] / values[bin];
            if is_square { part.sqrt() } else { part }
        };
        let [below, above] = [part(bin - 1), part(bin + 1)];
        let (window, length) = (self.request.window, self.segment as f64);
        let offset = window.line_offset(below.max(above), length);
        let response = window.line_response(offset, length);
        let beside = if above >= below { offset } else { -offset };
        (
            (bin as f64 + beside) * self.resolution,
            values[bin] / response.powi(if is_square { 2 } else { 1 }),
        )
    }

    /// Amplitudes of a column.
    pub(crate) fn amplitudes(&self, column: usize) -> Vec<f64> {
        let is_square = self.request.scaling.is_square();
        let values = self.columns[column].values.iter();
        values
            .map(|value| if is_square { value.sqrt() } else { *value })
            .collect()
    }

    /// Places of the maxima of a column that are above the noise around them, in units of the axis, with their values; by place.
    pub(crate) fn lines_above_noise(&self, column: usize) -> Vec<(f64, f64)> {
        let amplitudes = self.amplitudes(column);
        let loud = maxima(&self.columns[column].values)
            .filter(|bin| is_above_noise(&amplitudes, *bin, amplitudes[*bin]));
        loud.map(|bin| self.refined(column, bin)).collect()
    }

    /// Sets columns to zero whose amplitudes are all below a least one of their channel: what round-off leaves of a steady envelope.
    pub(crate) fn silence_below(&mut self, least: impl Fn(Channel) -> f64) {
        for index in 0..self.columns.len() {
            let SpectrumQuantity::Value(channel) = self.columns[index].quantity else {
                continue;
            };
            if magnitude(&self.amplitudes(index)) < least(channel) {
                self.columns[index].values.fill(0.0);
            }
        }
    }

    /// Takes the lines away that are no higher than the noise around them.
    pub(crate) fn forget_lines_of_noise(&mut self) {
        let all: Vec<_> = (0..self.columns.len())
            .map(|column| self.amplitudes(column))
            .collect();
        let resolution = self.resolution;
        self.lines.retain(|line| {
            let amplitudes = &all[line.column];
            let bin = (line.place / resolution).round() as usize;
            is_above_noise(amplitudes, bin, amplitudes[bin])
        });
    }
}

/// Bins that are above both neighbours.
fn maxima(values: &[f64]) -> impl Iterator<Item = usize> + use<'_> {
    let triples = values.windows(3).enumerate().skip(MEAN_BINS);
    let maxima = triples.filter(|(_, three)| three[1] > three[0] && three[1] >= three[2]);
    maxima.map(|(before, _)| before + 1)
}

/// The strongest of them.
fn strongest_maxima(values: &[f64]) -> impl Iterator<Item = usize> + use<'_> {
    let mut found: Vec<usize> = maxima(values).collect();
    found.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    let strongest = found.first().map_or(0.0, |bin| values[*bin]);
    found.retain(|bin| values[*bin] >= LEAST_PART * strongest);
    found.into_iter().take(MOST_LINES)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weak_maxima_and_the_mean_are_left_out() {
        let mut values = vec![0.0; 40];
        values[0] = 9.0; // the mean
        values[10..13].copy_from_slice(&[1.0, 2.0, 1.0]);
        values[20..23].copy_from_slice(&[2.0, 4.0, 3.0]);
        values[31] = 0.01;
        assert_eq!(strongest_maxima(&values).collect::<Vec<_>>(), [21, 11]);
    }
}
