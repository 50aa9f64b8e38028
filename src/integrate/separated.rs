//! A derivative in two parts: one that is linear, and forces that few states decide.

use nalgebra::DMatrix;

/// The derivative of a system in two parts, about a state in which the slopes of the second are known:
///
/// ```text
/// f(t, y) = c + A y + D w(t, y),   K = ∂w/∂y
/// ```
///
/// w depends on few states x and has few components that ever act, so that what is not linear costs the same however many
/// states there are.
#[derive(Debug, Clone, PartialEq)]
pub struct Separated {
    /// c.
    pub constant: Vec<f64>,
    /// A.
    pub matrix: DMatrix<f64>,
    /// Positions of the states x that w depends on.
    pub seen: Vec<usize>,
    /// Positions of the components of w that act, among those that [`super::System::forces`] writes.
    pub acting: Vec<usize>,
    /// D, a column for each force that acts.
    pub inputs: DMatrix<f64>,
    /// K, of the forces that act by the states x.
    pub slopes: DMatrix<f64>,
}

impl Separated {
    /// Slopes of the whole, A + D K.
    pub(crate) fn jacobian(&self) -> DMatrix<f64> {
        let mut jacobian = self.matrix.clone();
        let by_seen = &self.inputs * &self.slopes;
        for (position, slopes) in self.seen.iter().zip(by_seen.column_iter()) {
            let mut column = jacobian.column_mut(*position);
            column += slopes;
        }
        jacobian
    }
}
