//! Modes of the rotor linearised at its static equilibrium: eigenvalues, shapes, and how they whirl.

use std::f64::consts::TAU;
use std::fmt;

use nalgebra::{Complex, DMatrix, DVector};
use serde::Serialize;

use super::Rotor;

/// Part of the kinetic energy along z above which a mode is axial.
const AXIAL: f64 = 0.5;
/// Below this share of whirl a mode is a straight line rather than a circle either way.
const STRAIGHT: f64 = 0.05;
/// A mode of more damping than this is no vibration: within one period it dies out to 2e-6, and nothing rises where an
/// excitation has its frequency. In a shaft with internal damping such modes turn with the shaft.
const MOST_DAMPING: f64 = 0.9;
/// Eigenvalues nearer than this part of their size share their eigenvectors.
const REPEATED: f64 = 1e-6;
/// What keeps a nearly singular matrix with entries of order one from being singular: round-off of an eigenvalue.
const SHIFT: f64 = 1e-14;
/// Inverse iterations for shapes: each leaves at most SHIFT/REPEATED of what belongs to others.
const INVERSE_ITERATIONS: usize = 3;

/// Part of the energy of the place that moves most from which on another is named beside it.
const SECOND_PLACE: f64 = 0.3;

/// How the shaft goes round in a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Whirl {
    /// With the shaft's rotation.
    Forward,
    /// Against it.
    Backward,
    /// Along a line, neither way by more than a twentieth.
    Straight,
    /// Along the shaft's axis, of shaft or housings.
    Axial,
}

/// `forward`, `backward`, `straight`, `axial`.
impl fmt::Display for Whirl {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Forward => "forward",
            Self::Backward => "backward",
            Self::Straight => "straight",
            Self::Axial => "axial",
        })
    }
}

/// A natural frequency of the linearised rotor.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct NaturalFrequency {
    /// Undamped natural frequency |λ|/2π, Hz.
    #[serde(rename = "undamped_frequency_Hz")]
    pub frequency: f64,
    /// Frequency of the damped free vibration, Im λ/2π, Hz: the place of its line.
    #[serde(rename = "damped_frequency_Hz")]
    pub damped_frequency: f64,
    /// Damping ratio −Re λ/|λ|.
    pub damping_ratio: f64,
    /// How the shaft goes round.
    pub whirl: Whirl,
}

/// A mode of vibration: an eigenvalue with its shape.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Mode {
    /// Eigenvalue λ of positive imaginary part, 1/s.
    pub eigenvalue: Complex<f64>,
    /// Displacements of the degrees of freedom times the root of their mass or moment of inertia, of unit
    /// length: `Lᵀ q` with M = L Lᵀ.
    pub shape: Vec<Complex<f64>>,
    /// What goes round forward and backward, and what moves along the axis, by their kinetic energy.
    shares: [f64; 3],
}

/// A damping ratio below this is round-off: next to modes of some MHz the eigenvalue of one of 16 Hz errs by 5e-8 of itself.
pub(super) const UNDAMPED: f64 = 1e-6;

impl Mode {
    /// Frequency of the damped free vibration, Im λ/2π, Hz.
    pub fn damped_frequency(&self) -> f64 {
        self.eigenvalue.im / TAU
    }

    /// Damping ratio −Re λ/|λ|; zero where it is round-off of the eigenvalue.
    pub fn damping_ratio(&self) -> f64 {
        let ratio = -self.eigenvalue.re / self.eigenvalue.norm();
        if ratio.abs() < UNDAMPED { 0.0 } else { ratio }
    }

    /// Modal assurance criterion: 1 for the same shape, 0 for one that is orthogonal.
    ///
    /// `MAC = |aᴴ b|²/((aᴴ a)(bᴴ b))`
    ///
    /// Source: R. J. Allemang & D. L. Brown, *A correlation coefficient for modal vector analysis*,
    /// Proc. 1st Int. Modal Analysis Conf. (1982) 110–116; here of shapes weighted by the masses.
    pub fn assurance(&self, other: &Self) -> f64 {
        let product = |a: &[Complex<f64>], b: &[Complex<f64>]| -> Complex<f64> {
            a.iter().zip(b).map(|(a, b)| a.conj() * b).sum()
        };
        let both = product(&self.shape, &other.shape).norm_sqr();
        let own = product(&self.shape, &self.shape).re * product(&other.shape, &other.shape).re;
        both / own
    }

    /// How much more goes round with the shaft than against it, −1 … 1, of translation and tilt by
    /// their kinetic energy.
    ///
    /// ```text
    /// F = |x + iy|² + |θx + iθy|²,   B = |x − iy|² + |θx − iθy|²,   (F − B)/(F + B)
    /// ```
    ///
    /// Of a shaft that bends over all its coordinates.
    pub fn forward_share(&self) -> f64 {
        let [forward, backward, _] = self.shares;
        let both = forward + backward;
        if both > 0.0 {
            (forward - backward) / both
        } else {
            0.0
        }
    }

    /// How the shaft goes round.
    pub fn whirl(&self) -> Whirl {
        let all: f64 = self.shape.iter().map(Complex::norm_sqr).sum();
        if self.shares[2] > AXIAL * all {
            return Whirl::Axial;
        }
        match self.forward_share() {
            share if share > STRAIGHT => Whirl::Forward,
            share if share < -STRAIGHT => Whirl::Backward,
            _ => Whirl::Straight,
        }
    }
}

impl From<&Mode> for NaturalFrequency {
    fn from(mode: &Mode) -> Self {
        Self {
            frequency: mode.eigenvalue.norm() / TAU,
            damped_frequency: mode.damped_frequency(),
            damping_ratio: mode.damping_ratio(),
            whirl: mode.whirl(),
        }
    }
}

impl Rotor {
    /// Natural frequencies, lowest first; overdamped and rigid-body modes are left out.
    pub(crate) fn natural_frequencies(&self) -> Vec<NaturalFrequency> {
        self.modes().iter().map(NaturalFrequency::from).collect()
    }

    /// Modes by their undamped natural frequency, lowest first; overdamped and rigid-body ones are
    /// left out.
    ///
    /// Eigenvalues λ of `M q̈ + (C + ωG) q̇ + K q = 0`, one of each conjugate pair, with K at the
    /// static equilibrium, G the gyroscopic coupling of the tilts and ω the speed at t = 0; damping of
    /// the contacts is left out.
    pub(crate) fn modes(&self) -> Vec<Mode> {
        let matrices = self.linearised(self.speed());
        let matrices = matrices.map(|matrix| self.linear.mass.normalised(&matrix));
        let eigenvalues = state_matrix(&matrices).complex_eigenvalues();
        let mut eigenvalues: Vec<Complex<f64>> = eigenvalues
            .iter()
            .filter(|own| own.im > 0.0 && own.re.abs() < MOST_DAMPING * own.norm())
            .copied()
            .collect();
        eigenvalues.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
        let alike = |a: &Complex<f64>, b: &Complex<f64>| (a - b).norm() < REPEATED * a.norm();
        let groups = eigenvalues.chunk_by(alike);
        groups
            .flat_map(|group| {
                let shapes = self.shapes(&matrices, group[0], group.len().min(self.dofs()));
                let columns = shapes.column_iter();
                let shapes: Vec<Vec<_>> =
                    columns.map(|own| own.iter().copied().collect()).collect();
                group.iter().zip(shapes)
            })
            .map(|(eigenvalue, shape)| Mode {
                eigenvalue: *eigenvalue,
                shares: self.shares(&shape),
                shape,
            })
            .collect()
    }

    /// Highest undamped natural frequency, Hz, and what moves in its mode, by kinetic energy; none without a vibration.
    pub(crate) fn fastest(&self) -> Option<(f64, String)> {
        let mode = self.modes().pop()?;
        let root = self.linear.mass.root().map(Complex::from);
        let scaled = DVector::from_vec(mode.shape);
        let shape = root.transpose().solve_upper_triangular(&scaled)?;
        let momenta = root * scaled;
        let mut places: Vec<(String, f64)> = Vec::new();
        for (index, coordinate) in self.structure.coordinates[..self.dofs()].iter().enumerate() {
            let (place, energy) = (
                coordinate.place(),
                (shape[index].conj() * momenta[index]).re,
            );
            match places.iter_mut().find(|(known, _)| *known == place) {
                Some((_, sum)) => *sum += energy,
                None => places.push((place, energy)),
            }
        }
        places.sort_by(|a, b| b.1.total_cmp(&a.1));
        let least = SECOND_PLACE * places.first().map_or(0.0, |first| first.1);
        let named = places
            .into_iter()
            .take_while(|place| place.1 >= least)
            .take(2);
        let names: Vec<_> = named.map(|(place, _)| place).collect();
        Some((mode.eigenvalue.norm() / TAU, names.join(" and ")))
    }

    /// The directions that `λ² + λ L⁻¹(C + ωG)L⁻ᵀ + L⁻¹ K L⁻ᵀ` shrinks most, as many as
    /// there are modes of this eigenvalue: of modes that share one any mixture is a mode, and here they
    /// are those that go round as clearly as can be.
    fn shapes(
        &self,
        [stiffness, rate]: &[DMatrix<f64>; 2],
        eigenvalue: Complex<f64>,
        count: usize,
    ) -> DMatrix<Complex<f64>> {
        let dofs = self.dofs();
        let dynamic = DMatrix::from_fn(dofs, dofs, |row, column| {
            let inertia = if row == column {
                eigenvalue * eigenvalue
            } else {
                Complex::ZERO
            };
            inertia + eigenvalue * rate[(row, column)] + stiffness[(row, column)]
        });
        let shapes = most_shrunk(dynamic / Complex::from(eigenvalue.norm_sqr()), count);
        if count == 1 {
            return shapes;
        }
        let whirl = shapes.adjoint() * self.whirl() * &shapes;
        shapes * whirl.symmetric_eigen().eigenvectors
    }

    /// Of a shape, what goes round forward and backward, and what moves along the axis.
    fn shares(&self, shape: &[Complex<f64>]) -> [f64; 3] {
        let at = |index: usize| shape.get(index).copied().unwrap_or(Complex::ZERO);
        let (mut forward, mut backward) = (0.0, 0.0);
        for (first, second, sign) in self.structure.planes() {
            let turned = Complex::<f64>::I * at(second) * sign;
            forward += (at(first) + turned).norm_sqr();
            backward += (at(first) - turned).norm_sqr();
        }
        let bodies = self.structure.bodies.iter().map(|body| &body.point);
        let all = bodies.chain([&self.structure.shaft]);
        let axial = all.map(|point| at(point.coordinates[2]).norm_sqr()).sum();
        [forward, backward, axial]
    }

    /// The Hermitian form of [`Mode::forward_share`]'s F − B.
    fn whirl(&self) -> DMatrix<Complex<f64>> {
        let dofs = self.dofs();
        let mut form = DMatrix::zeros(dofs, dofs);
        for (first, second, sign) in self.structure.planes() {
            if first.max(second) < dofs {
                form[(first, second)] = Complex::new(0.0, 2.0 * sign);
                form[(second, first)] = Complex::new(0.0, -2.0 * sign);
            }
        }
        form
    }
}

/// The orthonormal directions that a nearly singular matrix with entries of order one shrinks most, by inverse iteration.
fn most_shrunk(mut matrix: DMatrix<Complex<f64>>, count: usize) -> DMatrix<Complex<f64>> {
    let size = matrix.nrows();
    // an exact zero among the pivots would end it
    for entry in 0..size {
        matrix[(entry, entry)] += Complex::from(SHIFT);
    }
    let factors = matrix.lu();
    // any start will do that has a part along each of them
    let start =
        |row: usize, column: usize| Complex::cis((1.0 + row as f64) * (1.0 + column as f64));
    let mut directions = DMatrix::from_fn(size, count, start);
    for _ in 0..INVERSE_ITERATIONS {
        if let Some(grown) = factors.solve(&directions) {
            directions = grown.qr().q();
        }
    }
    directions
}

/// Matrix A of `d/dt (ω₀ u, u̇) = A (ω₀ u, u̇)` with u = Lᵀ q: in these units, ω₀ the highest frequency of a freedom
/// by itself, its entries are of one size, and its eigenvalues lose no digits.
pub(super) fn state_matrix([stiffness, rate]: &[DMatrix<f64>; 2]) -> DMatrix<f64> {
    let dofs = rate.nrows();
    let unit = match stiffness.diagonal().amax().sqrt() {
        0.0 => 1.0,
        highest => highest,
    };
    let mut matrix = DMatrix::zeros(2 * dofs, 2 * dofs);
    matrix.view_mut((0, dofs), (dofs, dofs)).fill_diagonal(unit);
    matrix
        .view_mut((dofs, 0), (dofs, dofs))
        .copy_from(&(stiffness / -unit));
    matrix
        .view_mut((dofs, dofs), (dofs, dofs))
        .copy_from(&-rate);
    matrix
}
