//! What can be integrated.

use nalgebra::{DimMin, SMatrix};

use super::VelocityDependence;

/// A system of N first-order differential equations.
///
/// The derivative must be a pure function of time and state, or the error estimate lies. Where it
/// has no value it writes NaN; the integration then ends with an error that says when.
pub trait System<const N: usize> {
    /// Writes `d(state)/dt` at a time in s into `rate`.
    fn derivative(&self, time: f64, state: &[f64; N], rate: &mut [f64; N]);

    /// The first time after `after`, in s, at which the derivative or its slope by time jumps, as
    /// where a shock begins; infinite where it is smooth from there on. No step reaches over such a
    /// time, so none can miss what begins there.
    fn next_break(&self, _after: f64) -> f64 {
        f64::INFINITY
    }

    /// Whether the state is (q, q̇), displacements first and as many velocities after them: the motion
    /// between two steps then follows from both ends at no cost.
    fn is_second_order(&self) -> bool {
        false
    }

    /// ∂q″/∂q′ of a motion whose forces know the velocity in constant linear terms alone, in the first
    /// N/2 rows and columns: of a state (q, q′), then, q″ is this times q′ and a part that knows only time
    /// and place.
    ///
    /// # Errors
    /// [`VelocityDependence`] where the velocity enters otherwise.
    fn velocity_slopes(&self) -> Result<[[f64; N]; N], VelocityDependence> {
        Err(VelocityDependence {
            because: "how the forces depend on the velocity is not known",
        })
    }
}

/// A system that knows its own slopes, as implicit methods need them.
pub trait Linearised<const N: usize>: System<N> {
    /// `∂f/∂y`, rows by component of f, and `∂f/∂t` at fixed state.
    fn linearisation(&self, time: f64, state: &[f64; N]) -> (SMatrix<f64, N, N>, [f64; N]);
}

/// A number of states for which square matrices can be factored: every `Const<N>` that is used.
pub trait Square: DimMin<Self, Output = Self> {}

impl<D: DimMin<D, Output = D>> Square for D {}

/// Makes every component of a state a number of order one: `scaled = (state − origin)/scale`.
///
/// Tolerances then mean the same for a displacement of a nanometre and a speed of a metre per
/// second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scaling<const N: usize> {
    /// State that becomes zero.
    pub origin: [f64; N],
    /// Size of one unit of each component, positive.
    pub scale: [f64; N],
    /// Unit of time, s, positive.
    pub time: f64,
}

impl<const N: usize> Scaling<N> {
    /// The scaling that changes nothing.
    pub const IDENTITY: Self = Self {
        origin: [0.0; N],
        scale: [1.0; N],
        time: 1.0,
    };

    /// The state that scaled numbers stand for.
    #[inline]
    pub fn state(&self, scaled: &[f64]) -> [f64; N] {
        std::array::from_fn(|i| self.origin[i] + self.scale[i] * scaled[i])
    }

    /// Scaled numbers of a state.
    pub fn scaled(&self, state: &[f64; N]) -> [f64; N] {
        std::array::from_fn(|i| (state[i] - self.origin[i]) / self.scale[i])
    }
}
