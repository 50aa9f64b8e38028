//! Matrices of freedoms that couple no others than the last two, and all others.

/// A matrix of freedoms; the first N/2 rows and columns are used.
pub(super) type Matrix<const N: usize> = [[f64; N]; N];

/// What is kept of a matrix.
pub(super) trait Entries<const N: usize>: Copy + AsRef<[f64]> + AsMut<[f64]> {
    const ZERO: Self;

    /// What is to be kept of a matrix.
    fn of(matrix: &Matrix<N>) -> Self;

    /// Times a vector.
    fn times(&self, vector: &[f64; N]) -> [f64; N];
}

/// The diagonal, and after it the two entries beside it that couple the last two freedoms, as tilts are
/// by gyroscopic moments.
#[derive(Debug, Clone, Copy)]
pub(super) struct Few<const N: usize>([f64; N]);

/// All entries.
#[derive(Debug, Clone, Copy)]
pub(super) struct All<const N: usize>(Matrix<N>);

impl<const N: usize> Few<N> {
    const FREEDOMS: usize = N / 2;
    /// Whether there are two freedoms to couple.
    const COUPLES: bool = Self::FREEDOMS >= 2;

    /// Whether nothing of a matrix is lost, nor of its powers.
    pub fn holds(matrix: &Matrix<N>) -> bool {
        let last = Self::FREEDOMS.saturating_sub(2);
        let kept = |row, column| row == column || (row >= last && column >= last);
        (0..Self::FREEDOMS)
            .all(|row| (0..Self::FREEDOMS).all(|k| kept(row, k) || matrix[row][k] == 0.0))
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

    fn of(matrix: &Matrix<N>) -> Self {
        let mut entries = [0.0; N];
        for index in 0..Self::FREEDOMS {
            entries[index] = matrix[index][index];
        }
        if Self::COUPLES {
            let last = Self::FREEDOMS - 1;
            entries[last + 1] = matrix[last - 1][last];
            entries[last + 2] = matrix[last][last - 1];
        }
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
            let last = Self::FREEDOMS - 1;
            product[last - 1] += self.0[last + 1] * vector[last];
            product[last] += self.0[last + 2] * vector[last - 1];
        }
        product
    }
}

impl<const N: usize> Entries<N> for All<N> {
    const ZERO: Self = Self([[0.0; N]; N]);

    fn of(matrix: &Matrix<N>) -> Self {
        Self(*matrix)
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
}
