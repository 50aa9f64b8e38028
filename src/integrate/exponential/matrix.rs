//! Products of matrices with vectors, in chunks.

use std::ops::Range;

use nalgebra::DMatrix;

use crate::integrate::chunks::{Chunk, Padded, add_scaled, chunks_of};

/// A matrix: column after column in chunks.
#[derive(Debug, Clone)]
pub(super) struct ChunkMatrix {
    /// Chunks of a column.
    width: usize,
    columns: Vec<Chunk>,
}

impl ChunkMatrix {
    /// The matrix of some entries.
    pub fn from_matrix(matrix: &DMatrix<f64>) -> Self {
        let columns = matrix.as_slice().chunks_exact(matrix.nrows().max(1));
        let chunks = columns.flat_map(|column| Padded::from_slice(column).chunks().to_vec());
        Self {
            width: chunks_of(matrix.nrows()),
            columns: chunks.collect(),
        }
    }

    /// A matrix of zeros.
    pub fn zeros(rows: usize, columns: usize) -> Self {
        let width = chunks_of(rows);
        Self {
            width,
            columns: vec![[0.0; 4]; width * columns],
        }
    }

    /// A column.
    #[inline(always)]
    pub fn column(&self, index: usize) -> &[Chunk] {
        &self.columns[self.width * index..self.width * (index + 1)]
    }

    /// Some neighbouring columns.
    #[inline(always)]
    pub fn columns_mut(&mut self, columns: Range<usize>) -> &mut [Chunk] {
        &mut self.columns[self.width * columns.start..self.width * columns.end]
    }

    /// This matrix, which has so many rows and columns.
    pub fn to_matrix(&self, rows: usize, columns: usize) -> DMatrix<f64> {
        let columns = (0..columns).map(|index| self.column(index).as_flattened());
        let entries: Vec<_> = columns
            .flat_map(|column| &column[..rows])
            .copied()
            .collect();
        DMatrix::from_vec(rows, entries.len() / rows.max(1), entries)
    }

    /// Finds the product with the first numbers of a vector, or adds it, within code for wide registers.
    #[inline(always)]
    pub fn multiply<const ADD: bool>(&self, vector: &[f64], sums: &mut [Chunk]) {
        // a few chunks of rows at a time, with the sums in registers
        match self.width {
            1 => self.multiply_rows::<ADD, 1>(vector, sums, 0),
            2 => self.multiply_rows::<ADD, 2>(vector, sums, 0),
            3 => self.multiply_rows::<ADD, 3>(vector, sums, 0),
            width => {
                let whole = width - width % 4;
                for first in (0..whole).step_by(4) {
                    self.multiply_rows::<ADD, 4>(vector, sums, first);
                }
                match width - whole {
                    1 => self.multiply_rows::<ADD, 1>(vector, sums, whole),
                    2 => self.multiply_rows::<ADD, 2>(vector, sums, whole),
                    3 => self.multiply_rows::<ADD, 3>(vector, sums, whole),
                    _ => {}
                }
            }
        }
    }

    /// Finds the product of some chunks of rows with a vector, or adds it.
    #[inline(always)]
    fn multiply_rows<const ADD: bool, const CHUNKS: usize>(
        &self,
        vector: &[f64],
        sums: &mut [Chunk],
        first: usize,
    ) {
        let sums = &mut sums[first..first + CHUNKS];
        let mut own = [[0.0; 4]; CHUNKS];
        if ADD {
            own.copy_from_slice(sums);
        }
        for (column, value) in self.columns.chunks_exact(self.width).zip(vector) {
            for (own, entries) in own.iter_mut().zip(&column[first..first + CHUNKS]) {
                add_scaled(own, *value, entries);
            }
        }
        sums.copy_from_slice(&own);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Products of every number of chunks, with rows and columns that fill none.
    #[test]
    fn a_product_is_that_of_the_whole_matrix() {
        for rows in 1..30 {
            let entry = |row: usize, column: usize| (1.0 + (3 * row + 7 * column) as f64).sin();
            let matrix = DMatrix::from_fn(rows, 5, entry);
            let vector = [1.0, -2.0, 0.5, 3.0, 0.25];
            let mut sums = Padded::zeros(rows);
            let product = ChunkMatrix::from_matrix(&matrix);
            product.multiply::<false>(&vector, sums.chunks_mut());
            product.multiply::<true>(&vector, sums.chunks_mut());
            let expected = matrix * nalgebra::DVector::from_row_slice(&vector);
            for (found, expected) in sums.iter().zip(&expected) {
                assert!((found - 2.0 * expected).abs() < 1e-14, "{rows} rows");
            }
        }
    }
}
