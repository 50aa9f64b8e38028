//! The matrices of the equation of motion: mass, and what is linear in displacement and velocity.

use nalgebra::DMatrix;

use crate::numerics::panels::Panels;

/// A matrix of linear forces on the degrees of freedom, stored the way that its products are cheapest.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Coefficients {
    /// All entries, of degrees of freedom and of held coordinates.
    pub entries: DMatrix<f64>,
    is_zero: bool,
    form: Form,
}

/// Entries of a matrix for each that is not zero, from which on it pays to go through these alone: a whole matrix is
/// multiplied in wide registers.
const SPARSE: usize = 8;

/// The entries that a product needs.
#[derive(Debug, Clone, PartialEq)]
enum Form {
    Diagonal(Vec<f64>),
    /// Row, column, value of the few that are not zero.
    Sparse(Vec<(usize, usize, f64)>),
    Full(Panels),
}

impl Coefficients {
    /// Of the first `dofs` of all coordinates; the whole matrix is kept to be read.
    pub fn new(entries: DMatrix<f64>, dofs: usize) -> Self {
        let block = (0..dofs).flat_map(|row| (0..dofs).map(move |column| (row, column)));
        let sparse: Vec<_> = block
            .map(|(row, column)| (row, column, entries[(row, column)]))
            .filter(|(_, _, value)| *value != 0.0)
            .collect();
        let diagonal = sparse.iter().all(|(row, column, _)| row == column);
        let form = if diagonal && !sparse.is_empty() {
            Form::Diagonal((0..dofs).map(|row| entries[(row, row)]).collect())
        } else if SPARSE * sparse.len() < dofs * dofs {
            Form::Sparse(sparse)
        } else {
            Form::Full(Panels::new(&entries, dofs))
        };
        Self {
            is_zero: entries.iter().all(|entry| *entry == 0.0),
            entries,
            form,
        }
    }

    /// All entries, and `factor` times those of another.
    pub fn plus(&self, factor: f64, other: &Self) -> DMatrix<f64> {
        let mut sum = self.entries.clone();
        if !other.is_zero {
            sum.zip_apply(&other.entries, |own, other| *own += factor * other);
        }
        sum
    }

    /// Adds `factor` times the product with a vector of the degrees of freedom.
    #[inline(always)]
    pub fn add_product(&self, factor: f64, vector: &[f64], sum: &mut [f64]) {
        match &self.form {
            Form::Diagonal(diagonal) => {
                let diagonal = &diagonal[..sum.len()];
                for (sum, (entry, value)) in sum.iter_mut().zip(diagonal.iter().zip(vector)) {
                    *sum += factor * entry * value;
                }
            }
            Form::Sparse(entries) => {
                for (row, column, entry) in entries {
                    sum[*row] += factor * entry * vector[*column];
                }
            }
            Form::Full(panels) => panels.add_product(factor, vector, sum),
        }
    }
}

/// `½ vᵀ A v` with the first rows and columns of A.
pub(super) fn half_square(entries: &DMatrix<f64>, vector: &[f64]) -> f64 {
    let mut sum = 0.0;
    for (row, left) in vector.iter().enumerate() {
        for (column, right) in vector.iter().enumerate() {
            sum += left * entries[(row, column)] * right;
        }
    }
    0.5 * sum
}

/// The mass matrix of the degrees of freedom, positive definite.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Mass {
    /// Entries, kg, kg m or kg m².
    pub entries: DMatrix<f64>,
    inverse: Inverse,
}

#[derive(Debug, Clone, PartialEq)]
enum Inverse {
    Diagonal(Vec<f64>),
    /// L of M = L Lᵀ, and the panels of the inverse.
    Full(DMatrix<f64>, Panels),
}

impl Mass {
    /// None where the matrix is not positive definite.
    pub fn new(entries: DMatrix<f64>) -> Option<Self> {
        let diagonal = entries.diagonal();
        let inverse = if entries == DMatrix::from_diagonal(&diagonal) {
            let positive = diagonal.iter().all(|mass| *mass > 0.0);
            positive.then(|| Inverse::Diagonal(diagonal.iter().map(|mass| 1.0 / mass).collect()))
        } else {
            let factors = entries.clone().cholesky();
            factors.map(|factors| {
                let inverse = factors.inverse();
                let panels = Panels::new(&inverse, inverse.ncols());
                Inverse::Full(factors.l(), panels)
            })
        };
        inverse.map(|inverse| Self { entries, inverse })
    }

    /// Makes accelerations of forces, in place.
    #[inline(always)]
    pub fn accelerate(&self, forces: &mut [f64]) {
        match &self.inverse {
            Inverse::Diagonal(inverse) => {
                let inverse = &inverse[..forces.len()];
                for (force, inverse) in forces.iter_mut().zip(inverse) {
                    *force *= inverse;
                }
            }
            Inverse::Full(_, panels) => {
                let (mut few, mut many) = ([0.0; ROOM], Vec::new());
                let given = match few.get_mut(..forces.len()) {
                    Some(few) => few,
                    None => {
                        many.resize(forces.len(), 0.0);
                        &mut many[..]
                    }
                };
                given.copy_from_slice(forces);
                forces.fill(0.0);
                panels.add_product(1.0, given, forces);
            }
        }
    }

    /// L of M = L Lᵀ, which loses no digits of small masses compared with large ones: in coordinates `u = Lᵀ q` the mass is one.
    pub fn root(&self) -> DMatrix<f64> {
        match &self.inverse {
            Inverse::Diagonal(_) => DMatrix::from_diagonal(&self.entries.diagonal().map(f64::sqrt)),
            Inverse::Full(root, _) => root.clone(),
        }
    }

    /// `L⁻¹ A L⁻ᵀ`: a matrix in coordinates in which the mass is one.
    pub fn normalised(&self, matrix: &DMatrix<f64>) -> DMatrix<f64> {
        match &self.inverse {
            Inverse::Diagonal(inverse) => {
                DMatrix::from_fn(inverse.len(), inverse.len(), |row, column| {
                    matrix[(row, column)] * (inverse[row] * inverse[column]).sqrt()
                })
            }
            Inverse::Full(root, _) => {
                let size = root.nrows();
                let mut half = matrix.view((0, 0), (size, size)).into_owned();
                root.solve_lower_triangular_mut(&mut half);
                let mut whole = half.transpose();
                root.solve_lower_triangular_mut(&mut whole);
                whole.transpose()
            }
        }
    }
}

/// Degrees of freedom up to which no memory is asked for at an evaluation.
const ROOM: usize = 64;
