//! Free motions of the linearised shaft that grow instead of dying out.

use std::f64::consts::TAU;
use std::fmt;

use nalgebra::Complex;

use super::Rotor;
use super::modes::{UNDAMPED, state_matrix};

/// Eigenvalues below this part of the largest are those of a shaft that moves freely: round-off parts a double zero by 2e-8.
const FREE: f64 = 1e-7;

/// A free motion of the linearised shaft that grows as `exp(Re λ t)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GrowingMotion {
    /// λ with a positive real part, 1/s.
    eigenvalue: Complex<f64>,
}

impl GrowingMotion {
    /// Damping ratio −Re λ/|λ|, negative; −1 of a motion that does not vibrate.
    pub fn damping_ratio(&self) -> f64 {
        -self.eigenvalue.re / self.eigenvalue.norm()
    }
}

/// `a free vibration of 75.19 Hz has the damping ratio -0.226`
impl fmt::Display for GrowingMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.eigenvalue.im == 0.0 {
            let time = 1e3 / self.eigenvalue.re;
            return write!(
                f,
                "a departure from its equilibrium grows without vibration, by e = 2.718 every {time:.3} ms"
            );
        }
        let (frequency, ratio) = (self.eigenvalue.im.abs() / TAU, self.damping_ratio());
        write!(
            f,
            "a free vibration of {frequency:.2} Hz has the damping ratio {ratio:.2e}"
        )
    }
}

impl Rotor {
    /// Of the free motions of the rotor linearised at its static equilibrium, at the speed of its start, that of the least
    /// damping ratio, where that is negative beyond round-off. Unlike the natural frequencies it has the damping of the
    /// contacts as well.
    pub(crate) fn growing_motion(&self) -> Option<GrowingMotion> {
        let mut matrices = self.linearised(self.speed());
        self.add_contact_damping(&mut matrices);
        let matrices = matrices.map(|matrix| self.linear.mass.normalised(&matrix));
        let eigenvalues = state_matrix(&matrices).complex_eigenvalues();
        let largest = eigenvalues.iter().map(|own| own.norm()).fold(0.0, f64::max);
        let growing = eigenvalues
            .iter()
            .filter(|own| own.norm() > FREE * largest && own.re > UNDAMPED * own.norm())
            .map(|eigenvalue| GrowingMotion {
                eigenvalue: *eigenvalue,
            });
        growing.min_by(|a, b| a.damping_ratio().total_cmp(&b.damping_ratio()))
    }
}
