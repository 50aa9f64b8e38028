//! The integrating factor that takes forces linear in the velocity out of the equations of motion.
//!
//! ```text
//! q″ + 2 B q′ = f(t, q),   q = exp(−B τ) u   →   u″ = exp(B τ) (f + B² q)
//! ```
//!
//! with constant B and τ the time since the start of the step: what is left has no velocity. Of damping
//! and gyroscopic terms B² remains, which is small against the stiffness wherever a motion oscillates.
//!
//! Source: the substitution is Liouville's for a number in the place of B, which commutes with its own
//! exponential as well as a number does; as a numerical method J. D. Lawson, *SIAM J. Numer. Anal.* 4
//! (1967) 372–380.

use super::tableau::{MOST, Pair};

/// Terms of the exponential's series: enough for round-off up to a norm of one.
const TERMS: usize = 20;
/// Sum of the series' last terms that may be left out.
const NOTHING: f64 = 1e-18;
/// Largest product of step size and norm of B: far above it the factor spoils what it multiplies.
const LARGEST: f64 = 1.0;

/// A matrix of freedoms; the first N/2 rows and columns are used.
type Matrix<const N: usize> = [[f64; N]; N];

/// Which entries of a matrix differ from zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Reach {
    Nothing,
    Diagonal,
    /// The diagonal and the entries beside it.
    Neighbours,
    All,
}

/// exp(∓B c_i h) at the nodes of a pair, and what they are made of.
#[derive(Debug, Clone)]
pub(super) struct Factor<const N: usize> {
    reach: Reach,
    /// B.
    half: Matrix<N>,
    /// B².
    square: Matrix<N>,
    /// Norm of B, 1/s.
    norm: f64,
    /// B^k/k!.
    powers: [Matrix<N>; TERMS],
    /// Step size that the exponentials are of, s.
    size: f64,
    /// exp(−B c_i h).
    forth: [Matrix<N>; MOST],
    /// exp(B c_i h).
    back: [Matrix<N>; MOST],
}

impl<const N: usize> Factor<N> {
    /// From ∂q″/∂q′ = −2 B, of which the first N/2 rows and columns are read.
    pub fn new(velocity_slopes: &Matrix<N>) -> Self {
        let half = velocity_slopes.map(|row| row.map(|slope| -0.5 * slope));
        let mut powers = [[[0.0; N]; N]; TERMS];
        for (index, row) in powers[0].iter_mut().enumerate() {
            row[index] = 1.0;
        }
        for order in 1..TERMS {
            let product = product(&powers[order - 1], &half);
            powers[order] = product.map(|row| row.map(|entry| entry / order as f64));
        }
        let zero = [[0.0; N]; N];
        Self {
            reach: reach(&powers),
            half,
            square: product(&half, &half),
            norm: norm(&half),
            powers,
            size: f64::NAN,
            forth: [zero; MOST],
            back: [zero; MOST],
        }
    }

    /// Largest step that the factor serves, s.
    pub fn largest_step(&self) -> f64 {
        LARGEST / self.norm
    }

    /// Prepares the exponentials for steps of a size, s.
    pub fn prepare<P: Pair>(&mut self, size: f64) {
        if self.size == size || self.reach == Reach::Nothing {
            return;
        }
        self.size = size;
        let terms = self.terms(size);
        for node in 1..P::STAGES {
            self.exponentials(node, P::NODES[node] * size, terms);
        }
    }

    /// Terms after which the rest of the series is nothing.
    fn terms(&self, size: f64) -> usize {
        let (mut term, mut count) = (1.0, 1);
        while term > NOTHING && count < TERMS {
            term *= self.norm * size / count as f64;
            count += 1;
        }
        count
    }

    /// Even and odd terms apart: their sum and their difference are the two exponentials.
    fn exponentials(&mut self, node: usize, time: f64, terms: usize) {
        let (forth, back) = (&mut self.forth[node], &mut self.back[node]);
        let width = match self.reach {
            Reach::Nothing | Reach::Diagonal => 0,
            Reach::Neighbours => 1,
            Reach::All => N,
        };
        let square = time * time;
        for row in 0..N / 2 {
            for column in row.saturating_sub(width)..(row + width + 1).min(N / 2) {
                let (mut even, mut odd) = (0.0, 0.0);
                for order in (0..terms.next_multiple_of(2)).step_by(2).rev() {
                    even = even * square + self.powers[order][row][column];
                    odd = odd * square + self.powers[order + 1][row][column];
                }
                forth[row][column] = even - time * odd;
                back[row][column] = even + time * odd;
            }
        }
    }

    /// exp(−B c_i h) times a vector: from u to q.
    #[inline(always)]
    pub fn forth(&self, node: usize, vector: &[f64; N]) -> [f64; N] {
        self.times(&self.forth[node], vector)
    }

    /// exp(B c_i h) times a vector.
    #[inline(always)]
    pub fn back(&self, node: usize, vector: &[f64; N]) -> [f64; N] {
        self.times(&self.back[node], vector)
    }

    /// B times a vector, added to another.
    #[inline(always)]
    pub fn add_half(&self, vector: &[f64; N], sum: &mut [f64; N]) {
        self.add(&self.half, 1.0, vector, sum);
    }

    /// B times a vector, taken off another.
    #[inline(always)]
    pub fn take_half(&self, vector: &[f64; N], sum: &mut [f64; N]) {
        self.add(&self.half, -1.0, vector, sum);
    }

    /// B² times a vector, added to another.
    #[inline(always)]
    pub fn add_square(&self, vector: &[f64; N], sum: &mut [f64; N]) {
        self.add(&self.square, 1.0, vector, sum);
    }

    #[inline(always)]
    fn add(&self, matrix: &Matrix<N>, sign: f64, vector: &[f64; N], sum: &mut [f64; N]) {
        if self.reach == Reach::Nothing {
            return;
        }
        let product = self.times(matrix, vector);
        for index in 0..N / 2 {
            sum[index] += sign * product[index];
        }
    }

    #[inline(always)]
    fn times(&self, matrix: &Matrix<N>, vector: &[f64; N]) -> [f64; N] {
        if self.reach == Reach::Nothing {
            return *vector;
        }
        let mut product = [0.0; N];
        for index in 0..N / 2 {
            product[index] = matrix[index][index] * vector[index];
        }
        match self.reach {
            Reach::Nothing | Reach::Diagonal => {}
            Reach::Neighbours => {
                for index in 1..N / 2 {
                    product[index - 1] += matrix[index - 1][index] * vector[index];
                    product[index] += matrix[index][index - 1] * vector[index - 1];
                }
            }
            Reach::All => {
                for row in 0..N / 2 {
                    for column in (0..N / 2).filter(|&column| column != row) {
                        product[row] += matrix[row][column] * vector[column];
                    }
                }
            }
        }
        product
    }
}

fn product<const N: usize>(left: &Matrix<N>, right: &Matrix<N>) -> Matrix<N> {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let terms = (0..N / 2).map(|k| left[row][k] * right[k][column]);
            terms.sum()
        })
    })
}

/// Largest sum of magnitudes in a row.
fn norm<const N: usize>(matrix: &Matrix<N>) -> f64 {
    let sums = matrix
        .iter()
        .map(|row| row.iter().map(|entry| entry.abs()).sum());
    sums.fold(0.0, f64::max)
}

/// Where any power of B differs from zero.
fn reach<const N: usize>(powers: &[Matrix<N>; TERMS]) -> Reach {
    let mut widest = None;
    for matrix in &powers[1..] {
        for (row, entries) in matrix.iter().enumerate() {
            for (column, entry) in entries.iter().enumerate() {
                if *entry != 0.0 {
                    widest = widest.max(Some(row.abs_diff(column)));
                }
            }
        }
    }
    match widest {
        None => Reach::Nothing,
        Some(0) => Reach::Diagonal,
        Some(1) => Reach::Neighbours,
        Some(_) => Reach::All,
    }
}
