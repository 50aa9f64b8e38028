//! The linear equations of a correction, factored.

use nalgebra::{Complex, DMatrix, DVector, Dyn, LU};

use super::map::jacobian;
use super::{Circle, ReturnMap, mixed};

/// Factors of the slopes of a residual, by which a correction follows from it.
pub(super) enum Factors {
    /// Of all nodes together.
    Whole(LU<f64, Dyn, Dyn>),
    /// Of A − exp(i k ρ) for each harmonic k, the mean first, where the slopes A are those of one node for all.
    Harmonics(Vec<LU<Complex<f64>, Dyn, Dyn>>),
}

impl Factors {
    /// Those of slopes of every node, or of one for all.
    pub fn new(map: &dyn ReturnMap, slopes: &[DMatrix<f64>]) -> Self {
        match slopes {
            [only] if map.circle().nodes() > 1 => {
                let slopes = only.map(Complex::from);
                let of_harmonic = |harmonic: usize| {
                    let turn = Complex::cis(harmonic as f64 * map.circle().rotation);
                    let unity = DMatrix::from_diagonal_element(map.size(), map.size(), turn);
                    (&slopes - unity).lu()
                };
                let harmonics = 0..=map.circle().harmonics();
                Self::Harmonics(harmonics.map(of_harmonic).collect())
            }
            all => Self::Whole(jacobian(map, all).lu()),
        }
    }

    /// What the slopes make this residual of; none where they are singular.
    pub fn solve(&self, circle: &Circle, residual: &DVector<f64>) -> Option<DVector<f64>> {
        match self {
            Self::Whole(factors) => factors.solve(residual),
            Self::Harmonics(factors) => {
                let size = residual.len() / circle.nodes();
                let mut coefficients = mixed(&circle.coefficients, residual, size);
                for (harmonic, factors) in factors.iter().enumerate() {
                    solve_harmonic(factors, harmonic, size, &mut coefficients)?;
                }
                Some(mixed(&circle.basis(), &coefficients, size))
            }
        }
    }
}

/// Solves for one harmonic a cos kφ + b sin kφ = Re (a − i b) exp(i k φ) among the coefficients.
fn solve_harmonic(
    factors: &LU<Complex<f64>, Dyn, Dyn>,
    harmonic: usize,
    size: usize,
    coefficients: &mut DVector<f64>,
) -> Option<()> {
    let (cosine, sine) = match harmonic {
        0 => (0, None),
        k => (size * (2 * k - 1), Some(size * 2 * k)),
    };
    let residual = DVector::from_fn(size, |row, _| {
        let sine = sine.map_or(0.0, |sine| coefficients[sine + row]);
        Complex::new(coefficients[cosine + row], -sine)
    });
    let solved = factors.solve(&residual)?;
    for (row, value) in solved.iter().enumerate() {
        coefficients[cosine + row] = value.re;
        if let Some(sine) = sine {
            coefficients[sine + row] = -value.im;
        }
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shooting::{Image, MapError, Slopes};

    struct Still(Circle);

    impl ReturnMap for Still {
        fn size(&self) -> usize {
            2
        }

        fn circle(&self) -> &Circle {
            &self.0
        }

        fn image(&mut self, states: &DVector<f64>, _: Slopes) -> Result<Image, MapError> {
            Ok(Image {
                end: states.clone(),
                slopes: Vec::new(),
            })
        }

        fn set(&mut self, _: f64) -> Result<(), MapError> {
            Ok(())
        }
    }

    #[test]
    fn harmonic_by_harmonic_is_as_all_nodes_together() {
        let circle = Circle::around(1.0, 2.0 * 3f64.sqrt(), 3).expect("an irrational turn");
        let map = Still(circle);
        let slopes = DMatrix::from_row_slice(2, 2, &[0.6, -0.5, 0.4, 0.3]);
        let residual = DVector::from_fn(14, |row, _| (1.0 + row as f64).sin());
        let at_once = Factors::new(&map, std::slice::from_ref(&slopes));
        assert!(matches!(at_once, Factors::Harmonics(_)));
        let whole = Factors::new(&map, &vec![slopes; 7]);
        let solve = |factors: Factors| factors.solve(&map.0, &residual).expect("a solution");
        assert!((solve(at_once) - solve(whole)).amax() < 1e-13);
    }
}
