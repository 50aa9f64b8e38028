//! Hermite's interpolation between samples whose rates are known.

/// The polynomial through values and slopes at the nodes `first`, `first` + 1, …, evaluated at one position: the
/// same weights serve every quantity.
///
/// ```text
/// p(s) = Σ_i [1 − 2 l_i'(i)(s − i)] l_i(s)² f_i + (s − i) l_i(s)² f_i'
/// ```
///
/// with l_i Lagrange's polynomials of the nodes: of degree 7 through four of them. Between the middle
/// two its error is at most `(9/16)² h⁸ |f⁽⁸⁾|/8!`, h the distance of the nodes.
///
/// Source: Hermite's interpolation, e.g. Stoer & Bulirsch, *Introduction to Numerical Analysis*, 3rd ed.
/// (2002), section 2.1.5.
pub struct Hermite<const K: usize> {
    /// Of every value and its slope.
    weights: [[f64; 2]; K],
}

impl<const K: usize> Hermite<K> {
    pub fn new(first: usize, position: f64) -> Self {
        let at = |index: usize| (first + index) as f64;
        let weights = std::array::from_fn(|i| {
            let (mut lagrange, mut rate) = (1.0, 0.0);
            for j in 0..K {
                // known as this is compiled
                let apart = i as f64 - j as f64;
                if j != i {
                    lagrange *= (position - at(j)) / apart;
                    rate += 1.0 / apart;
                }
            }
            let (square, distance) = (lagrange * lagrange, position - at(i));
            [square * (1.0 - 2.0 * rate * distance), square * distance]
        });
        Self { weights }
    }

    /// Value of the polynomial through these at the position.
    pub fn value(&self, values: [f64; K], slopes: [f64; K]) -> f64 {
        let mut sum = 0.0;
        for (i, [own, by_slope]) in self.weights.iter().enumerate() {
            sum += own * values[i] + by_slope * slopes[i];
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_of_degree_seven_is_met_exactly() {
        let value = |s: f64| 1.0 + s - 0.3 * s.powi(4) + 0.01 * s.powi(7);
        let slope = |s: f64| 1.0 - 1.2 * s.powi(3) + 0.07 * s.powi(6);
        let nodes = [0.0, 1.0, 2.0, 3.0];
        for position in [1.0, 1.25, 1.5, 2.0] {
            let found = Hermite::new(0, position).value(nodes.map(value), nodes.map(slope));
            assert!(
                (found - value(position)).abs() < 1e-14,
                "{position}: {found}"
            );
        }
    }

    #[test]
    fn a_cosine_is_met_within_the_bound_of_the_remainder() {
        for step in [0.2, 0.4, 0.8] {
            let value = |s: f64| (step * s).cos();
            let slope = |s: f64| -step * (step * s).sin();
            let nodes = [0.0, 1.0, 2.0, 3.0];
            let bound = (9.0f64 / 16.0).powi(2) * step.powi(8) / 40_320.0;
            for part in 0..=10 {
                let position = 1.0 + 0.1 * f64::from(part);
                let found = Hermite::new(0, position).value(nodes.map(value), nodes.map(slope));
                let error = found - value(position);
                assert!(
                    error.abs() <= bound + 1e-15,
                    "{step} {position}: {error:e} of {bound:e}"
                );
            }
        }
    }
}
