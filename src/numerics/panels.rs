//! Products of matrices that have blocks of zeros with vectors.

use nalgebra::DMatrix;

/// Rows whose sums are formed side by side.
const PANEL: usize = 4;

/// A square matrix in panels of rows, each from its first column that is not zero to the last.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Panels {
    /// First column of each panel, and where its entries end.
    panels: Vec<(usize, usize)>,
    /// Column by column.
    entries: Vec<[f64; PANEL]>,
}

impl Panels {
    /// Those of the first `size` rows and columns.
    pub fn new(matrix: &DMatrix<f64>, size: usize) -> Self {
        let mut panels = Self::default();
        panels.set(matrix, size);
        panels
    }

    /// Takes the first `size` rows and columns of another matrix.
    pub fn set(&mut self, matrix: &DMatrix<f64>, size: usize) {
        self.panels.clear();
        self.entries.clear();
        for first_row in (0..size).step_by(PANEL) {
            let rows = first_row..size.min(first_row + PANEL);
            let begin = self.entries.len();
            let mut first = 0;
            for column in matrix.column_iter().take(size) {
                let mut entries = [0.0; PANEL];
                entries[..rows.len()].copy_from_slice(&column.as_slice()[rows.clone()]);
                let is_empty = self.entries.len() == begin;
                match is_empty && entries == [0.0; PANEL] {
                    true => first += 1,
                    false => self.entries.push(entries),
                }
            }
            while self.entries.len() > begin && self.entries.last() == Some(&[0.0; PANEL]) {
                self.entries.pop();
            }
            self.panels.push((first, self.entries.len()));
        }
    }

    /// Adds `factor` times the product with a vector.
    #[inline(always)]
    pub fn add_product(&self, factor: f64, vector: &[f64], sum: &mut [f64]) {
        let mut begin = 0;
        for ((first, end), sum) in self.panels.iter().zip(sum.chunks_mut(PANEL)) {
            let mut panel = [0.0; PANEL];
            for (entries, value) in self.entries[begin..*end].iter().zip(&vector[*first..]) {
                for (row, entry) in panel.iter_mut().zip(entries) {
                    *row += entry * value;
                }
            }
            for (sum, row) in sum.iter_mut().zip(panel) {
                *sum += factor * row;
            }
            begin = *end;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six rows: a panel of two blocks, and one that is not full.
    #[test]
    fn a_product_is_that_of_the_whole_matrix() {
        let entry = |row: usize, column: usize| match row / 2 == column / 2 {
            true => (3 * row + column) as f64 + 0.5,
            false => 0.0,
        };
        let matrix = DMatrix::from_fn(7, 7, entry);
        let vector = nalgebra::DVector::from_fn(6, |row, _| 1.0 / (1.0 + row as f64));
        let mut sum = vec![1.0; 6];
        Panels::new(&matrix, 6).add_product(-2.0, vector.as_slice(), &mut sum);
        let product = matrix.view((0, 0), (6, 6)) * &vector;
        for (found, product) in sum.iter().zip(&product) {
            assert!((found - (1.0 - 2.0 * product)).abs() < 1e-14);
        }
    }
}
