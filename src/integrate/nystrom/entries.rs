//! Matrices of freedoms that couple none, or few of them.

use std::ops::Range;

/// A matrix of freedoms; the first N/2 rows and columns are used.
pub(super) type Matrix<const N: usize> = [[f64; N]; N];

/// What is kept of a matrix: all of it, or the diagonal and the entries that couple the freedoms of a
/// range with the ones before them.
pub(super) trait Entries<const N: usize>: Copy + AsRef<[f64]> + AsMut<[f64]> {
    const ZERO: Self;

    /// What is to be kept of a matrix.
    fn of(matrix: &Matrix<N>, coupled: &Range<usize>) -> Self;

    /// Times a vector.
    fn times(&self, coupled: &Range<usize>, vector: &[f64; N]) -> [f64; N];
}

/// The diagonal, then the entry above it and the one below it for each coupling.
#[derive(Debug, Clone, Copy)]
pub(super) struct Few<const N: usize>([f64; N]);

/// All entries.
#[derive(Debug, Clone, Copy)]
pub(super) struct All<const N: usize>(Matrix<N>);

impl<const N: usize> Few<N> {
    /// Whether so many couplings have room.
    pub fn holds(couplings: usize) -> bool {
        N / 2 + 2 * couplings <= N
    }
}

impl<const N: usize> AsRef<[f64]> for Few<N> {
    fn as_ref(&self) -> &[f64] {
        &self.0
    }
}

impl<const N: usize> AsMut<[f64]> for Few<N> {
    fn as_mut(&mut self) -> &mut [f64] {
        &mut self.0
    }
}

impl<const N: usize> AsRef<[f64]> for All<N> {
    fn as_ref(&self) -> &[f64] {
        self.0.as_flattened()
    }
}

impl<const N: usize> AsMut<[f64]> for All<N> {
    fn as_mut(&mut self) -> &mut [f64] {
        self.0.as_flattened_mut()
    }
}

impl<const N: usize> Entries<N> for Few<N> {
    const ZERO: Self = Self([0.0; N]);

    fn of(matrix: &Matrix<N>, coupled: &Range<usize>) -> Self {
        let mut entries = [0.0; N];
        for index in 0..N / 2 {
            entries[index] = matrix[index][index];
        }
        for (place, index) in coupled.clone().enumerate() {
            entries[N / 2 + 2 * place] = matrix[index - 1][index];
            entries[N / 2 + 2 * place + 1] = matrix[index][index - 1];
        }
        Self(entries)
    }

    #[inline(always)]
    fn times(&self, coupled: &Range<usize>, vector: &[f64; N]) -> [f64; N] {
        let mut product = [0.0; N];
        for index in 0..N / 2 {
            product[index] = self.0[index] * vector[index];
        }
        let (_, beside) = self.0.split_at(N / 2);
        for (index, [above, below]) in coupled.clone().zip(beside.as_chunks().0) {
            product[index - 1] += above * vector[index];
            product[index] += below * vector[index - 1];
        }
        product
    }
}

impl<const N: usize> Entries<N> for All<N> {
    const ZERO: Self = Self([[0.0; N]; N]);

    fn of(matrix: &Matrix<N>, _: &Range<usize>) -> Self {
        Self(*matrix)
    }

    #[inline(always)]
    fn times(&self, _: &Range<usize>, vector: &[f64; N]) -> [f64; N] {
        let mut product = [0.0; N];
        for row in 0..N / 2 {
            for column in 0..N / 2 {
                product[row] += self.0[row][column] * vector[column];
            }
        }
        product
    }
}

/// The freedoms that a matrix, whatever its power, couples with the ones before them; `None` where it
/// couples others, or more than have room.
pub(super) fn couplings<const N: usize>(matrix: &Matrix<N>) -> Option<Range<usize>> {
    let mut coupled = 0..0;
    for row in 0..N / 2 {
        for column in (0..N / 2).filter(|&column| column != row && matrix[row][column] != 0.0) {
            let index = row.max(column);
            if row.abs_diff(column) > 1 || !(coupled.is_empty() || coupled.contains(&index)) {
                return None;
            }
            // a second one would couple three freedoms
            coupled = index..index + 1;
        }
    }
    Few::<N>::holds(coupled.len()).then_some(coupled)
}
