//! Named lines of an envelope spectrum.

use super::{Axis, EnvelopeLine, EstimatedSpectrum, SpectrumKind, SpectrumQuantity};
use crate::analysis::{Channel, Line, Precision, Window, is_above_noise, magnitude, nearest_cause};

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
        let between = self.between();
        let lines = self.value_columns().flat_map(|index| {
            let values = &self.columns[index].values;
            let maxima = strongest_maxima(values, between).into_iter();
            maxima.filter_map(move |(bin, value)| {
                let place = bin * resolution;
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

    /// How a maximum between bins is found.
    fn between(&self) -> fn([f64; 3]) -> f64 {
        match self.request.window == Window::Hann && !self.request.scaling.is_square() {
            true => between_hann,
            false => vertex,
        }
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
        let maxima = maxima(&self.columns[column].values, self.between());
        let loud = maxima.filter(|(bin, _)| {
            let bin = bin.round() as usize;
            is_above_noise(&amplitudes, bin, amplitudes[bin])
        });
        loud.map(|(bin, value)| (bin * self.resolution, value))
            .collect()
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

/// How far beside the middle of three bins a parabola through them is highest.
fn vertex([before, highest, after]: [f64; 3]) -> f64 {
    0.5 * (before - after) / (before - 2.0 * highest + after)
}

/// The offset of a line under the Hann window: (2a − 1)/(a + 1) towards a neighbour of a times the amplitude (Rife & Vincent, Bell
/// Syst. Tech. J. 49 (1970) 197–228).
fn between_hann([before, highest, after]: [f64; 3]) -> f64 {
    let part = before.max(after) / highest;
    let beside = (2.0 * part - 1.0) / (part + 1.0);
    if after >= before { beside } else { -beside }
}

/// Maxima between the bins, with the values of their bins.
fn maxima(
    values: &[f64],
    between: fn([f64; 3]) -> f64,
) -> impl Iterator<Item = (f64, f64)> + use<'_> {
    let triples = values.windows(3).enumerate().skip(MEAN_BINS);
    let maxima = triples.filter(|(_, three)| three[1] > three[0] && three[1] >= three[2]);
    maxima.map(move |(before, three)| {
        let beside = between([three[0], three[1], three[2]]);
        ((before + 1) as f64 + beside, three[1])
    })
}

/// The strongest maxima.
fn strongest_maxima(values: &[f64], between: fn([f64; 3]) -> f64) -> Vec<(f64, f64)> {
    let mut found: Vec<(f64, f64)> = maxima(values, between).collect();
    found.sort_by(|a, b| b.1.total_cmp(&a.1));
    let strongest = found.first().map_or(0.0, |(_, value)| *value);
    found.retain(|(_, value)| *value >= LEAST_PART * strongest);
    found.truncate(MOST_LINES);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maxima_lie_between_the_bins_and_weak_ones_are_left_out() {
        let mut values = vec![0.0; 40];
        values[0] = 9.0; // the mean
        values[10..13].copy_from_slice(&[1.0, 2.0, 1.0]);
        values[20..23].copy_from_slice(&[2.0, 4.0, 3.0]);
        values[31] = 0.01;
        let found = strongest_maxima(&values, vertex);
        assert_eq!(found.len(), 2);
        assert!((found[0].0 - (21.0 + 1.0 / 6.0)).abs() < 1e-12 && found[0].1 == 4.0);
        assert_eq!(found[1], (11.0, 2.0));
        // midway between two bins both are equally high
        assert_eq!(between_hann([0.2, 1.0, 1.0]), 0.5);
        assert_eq!(between_hann([0.5, 1.0, 0.5]), 0.0);
    }
}
