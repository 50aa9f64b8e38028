//! Matrices of freedoms that couple no others than the last two, of one motion or of several side by side, and
//! all others.

use fearless_simd::Simd;

use super::row::Row;

/// A matrix of freedoms; the first N/2 rows and columns are used.
pub(super) type Matrix<const N: usize> = [[f64; N]; N];

/// What is kept of a matrix.
pub(super) trait Entries<const N: usize>: Copy {
    const ZERO: Self;
    /// Motions side by side that the vectors are of: component i belongs to number i modulo their count.
    const MOTIONS: usize = 1;

    /// What is to be kept of a matrix.
    fn of(matrix: &Matrix<N>) -> Self;

    /// What leaves every vector as it is.
    fn identity() -> Self;

    /// All of them, as rows.
    fn rows(&self) -> &[Row<N>];

    /// The same, to be changed.
    fn rows_mut(&mut self) -> &mut [Row<N>];

    /// Times a vector.
    fn times<V: Simd>(&self, simd: V, vector: &Row<N>) -> Row<N>;

    /// Times another matrix.
    fn product(&self, other: &Self) -> Self;
}

/// The diagonals of `K` motions side by side, and for each the two entries beside its diagonal that couple its
/// last two freedoms, as tilts are by gyroscopic moments: each in the row that it stands in.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrate) struct Few<const N: usize, const K: usize = 1>([Row<N>; 2]);

/// All entries.
#[derive(Debug, Clone, Copy)]
pub(super) struct All<const N: usize>([Row<N>; N]);

impl<const N: usize, const K: usize> Few<N, K> {
    const FREEDOMS: usize = N / 2;
    /// Whether there are two freedoms to couple.
    const COUPLES: bool = Self::FREEDOMS >= 2 * K;
    /// The last freedoms, and those before them.
    const LAST: usize = Self::FREEDOMS.saturating_sub(K);
    const BEFORE: usize = Self::FREEDOMS.saturating_sub(2 * K);

    /// Whether nothing of a matrix is lost, nor of its powers.
    pub fn holds(matrix: &Matrix<N>) -> bool {
        let kept = |row: usize, column: usize| {
            let both_late = row >= Self::BEFORE && column >= Self::BEFORE;
            row == column || (both_late && row % K == column % K)
        };
        (0..Self::FREEDOMS)
            .all(|row| (0..Self::FREEDOMS).all(|k| kept(row, k) || matrix[row][k] == 0.0))
    }
}

impl<const N: usize, const K: usize> Entries<N> for Few<N, K> {
    const ZERO: Self = Self([Row::ZERO; 2]);
    const MOTIONS: usize = K;

    fn of(matrix: &Matrix<N>) -> Self {
        let [mut own, mut across] = [Row::ZERO; 2];
        for index in 0..Self::FREEDOMS {
            own[index] = matrix[index][index];
        }
        if Self::COUPLES {
            for motion in 0..K {
                let (before, last) = (Self::BEFORE + motion, Self::LAST + motion);
                across[before] = matrix[before][last];
                across[last] = matrix[last][before];
            }
        }
        Self([own, across])
    }

    fn identity() -> Self {
        let mut own = Row::ZERO;
        own[..Self::FREEDOMS].fill(1.0);
        Self([own, Row::ZERO])
    }

    fn rows(&self) -> &[Row<N>] {
        &self.0
    }

    fn rows_mut(&mut self) -> &mut [Row<N>] {
        &mut self.0
    }

    #[inline(always)]
    fn times<V: Simd>(&self, simd: V, vector: &Row<N>) -> Row<N> {
        // each of the coupled freedoms where the other one stands
        let mut other = Row::<N>::ZERO;
        if Self::COUPLES {
            for motion in 0..K {
                let (before, last) = (Self::BEFORE + motion, Self::LAST + motion);
                other[before] = vector[last];
                other[last] = vector[before];
            }
        }
        Row::of(|register| {
            let product = self.0[0].load(simd, register) * vector.load(simd, register);
            if Self::COUPLES {
                product + self.0[1].load(simd, register) * other.load(simd, register)
            } else {
                product
            }
        })
    }

    fn product(&self, other: &Self) -> Self {
        let ([a, a_across], [b, b_across]) = (&self.0, &other.0);
        let [mut own, mut across] = self.0;
        for index in 0..Self::FREEDOMS {
            own[index] = a[index] * b[index];
        }
        if Self::COUPLES {
            for motion in 0..K {
                let (before, last) = (Self::BEFORE + motion, Self::LAST + motion);
                for (row, other) in [(before, last), (last, before)] {
                    own[row] += a_across[row] * b_across[other];
                    across[row] = a[row] * b_across[row] + a_across[row] * b[other];
                }
            }
        }
        Self([own, across])
    }
}

impl<const N: usize> Entries<N> for All<N> {
    const ZERO: Self = Self([Row::ZERO; N]);

    fn of(matrix: &Matrix<N>) -> Self {
        let mut entries = Self::ZERO;
        for (row, given) in entries.0.iter_mut().zip(matrix).take(N / 2) {
            row[..N / 2].copy_from_slice(&given[..N / 2]);
        }
        entries
    }

    fn identity() -> Self {
        let mut entries = Self::ZERO;
        for index in 0..N / 2 {
            entries.0[index][index] = 1.0;
        }
        entries
    }

    fn rows(&self) -> &[Row<N>] {
        &self.0[..N / 2]
    }

    fn rows_mut(&mut self) -> &mut [Row<N>] {
        &mut self.0[..N / 2]
    }

    #[inline(always)]
    fn times<V: Simd>(&self, _simd: V, vector: &Row<N>) -> Row<N> {
        let mut product = Row::ZERO;
        for (index, row) in self.rows().iter().enumerate() {
            for (entry, component) in row.iter().zip(vector.iter()).take(N / 2) {
                product[index] += entry * component;
            }
        }
        product
    }

    fn product(&self, other: &Self) -> Self {
        let mut product = Self::ZERO;
        for (sums, row) in product.0.iter_mut().zip(self.rows()) {
            for (entry, other) in row.iter().zip(other.rows()) {
                for (sum, other) in sums.iter_mut().zip(other.iter()) {
                    *sum += entry * other;
                }
            }
        }
        product
    }
}
