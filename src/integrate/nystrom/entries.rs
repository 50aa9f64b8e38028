//! Matrices of freedoms that couple no others than the last two, of one motion or of several side by side, and
//! all others.

/// A matrix of freedoms; the first N/2 rows and columns are used.
pub(super) type Matrix<const N: usize> = [[f64; N]; N];

/// What is kept of a matrix.
pub(super) trait Entries<const N: usize>: Copy + AsRef<[f64]> + AsMut<[f64]> {
    const ZERO: Self;
    /// Motions side by side that the vectors are of: component i belongs to number i modulo their count.
    const MOTIONS: usize = 1;

    /// What is to be kept of a matrix.
    fn of(matrix: &Matrix<N>) -> Self;

    /// What leaves every vector as it is.
    fn identity() -> Self;

    /// Times a vector.
    fn times(&self, vector: &[f64; N]) -> [f64; N];

    /// Times another matrix.
    fn product(&self, other: &Self) -> Self;
}

/// The diagonals of `K` motions side by side, and after them, for each, the two entries beside its diagonal
/// that couple its last two freedoms, as tilts are by gyroscopic moments.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrate) struct Few<const N: usize, const K: usize = 1>([f64; N]);

/// All entries.
#[derive(Debug, Clone, Copy)]
pub(super) struct All<const N: usize>(Matrix<N>);

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

impl<const N: usize, const K: usize> AsRef<[f64]> for Few<N, K> {
    fn as_ref(&self) -> &[f64] {
        &self.0
    }
}

impl<const N: usize, const K: usize> AsMut<[f64]> for Few<N, K> {
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

impl<const N: usize, const K: usize> Entries<N> for Few<N, K> {
    const ZERO: Self = Self([0.0; N]);
    const MOTIONS: usize = K;

    fn of(matrix: &Matrix<N>) -> Self {
        let mut entries = [0.0; N];
        for index in 0..Self::FREEDOMS {
            entries[index] = matrix[index][index];
        }
        if Self::COUPLES {
            for motion in 0..K {
                let (before, last) = (Self::BEFORE + motion, Self::LAST + motion);
                entries[Self::FREEDOMS + motion] = matrix[before][last];
                entries[Self::FREEDOMS + K + motion] = matrix[last][before];
            }
        }
        Self(entries)
    }

    fn identity() -> Self {
        let mut entries = [0.0; N];
        entries[..Self::FREEDOMS].fill(1.0);
        Self(entries)
    }

    /// Every index is known when the code is compiled: the product stays in registers.
    #[inline(always)]
    fn times(&self, vector: &[f64; N]) -> [f64; N] {
        let mut product = [0.0; N];
        for index in 0..Self::FREEDOMS {
            product[index] = self.0[index] * vector[index];
        }
        if Self::COUPLES {
            for motion in 0..K {
                let (before, last) = (Self::BEFORE + motion, Self::LAST + motion);
                product[before] += self.0[Self::FREEDOMS + motion] * vector[last];
                product[last] += self.0[Self::FREEDOMS + K + motion] * vector[before];
            }
        }
        product
    }

    fn product(&self, other: &Self) -> Self {
        let (mut product, other) = (*self, &other.0);
        for (entry, other) in product.0.iter_mut().zip(other).take(Self::FREEDOMS) {
            *entry *= other;
        }
        if Self::COUPLES {
            for motion in 0..K {
                let (before, last) = (Self::BEFORE + motion, Self::LAST + motion);
                let (right, left) = (Self::FREEDOMS + motion, Self::FREEDOMS + K + motion);
                product.0[before] = self.0[before] * other[before] + self.0[right] * other[left];
                product.0[last] = self.0[left] * other[right] + self.0[last] * other[last];
                product.0[right] = self.0[before] * other[right] + self.0[right] * other[last];
                product.0[left] = self.0[left] * other[before] + self.0[last] * other[left];
            }
        }
        product
    }
}

impl<const N: usize> Entries<N> for All<N> {
    const ZERO: Self = Self([[0.0; N]; N]);

    fn of(matrix: &Matrix<N>) -> Self {
        Self(*matrix)
    }

    fn identity() -> Self {
        let mut matrix = [[0.0; N]; N];
        for (index, row) in matrix.iter_mut().enumerate() {
            row[index] = 1.0;
        }
        Self(matrix)
    }

    #[inline(always)]
    fn times(&self, vector: &[f64; N]) -> [f64; N] {
        let mut product = [0.0; N];
        for (sum, row) in product.iter_mut().zip(&self.0).take(N / 2) {
            for (entry, component) in row.iter().zip(vector).take(N / 2) {
                *sum += entry * component;
            }
        }
        product
    }

    fn product(&self, other: &Self) -> Self {
        let mut product = Self::ZERO;
        for (sums, row) in product.0.iter_mut().zip(&self.0).take(N / 2) {
            for (entry, other) in row.iter().zip(&other.0).take(N / 2) {
                for (sum, other) in sums.iter_mut().zip(other).take(N / 2) {
                    *sum += entry * other;
                }
            }
        }
        product
    }
}
