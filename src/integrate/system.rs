//! What can be integrated.

use nalgebra::{DimMin, SMatrix};

/// Sides of surfaces, a bit for each: set past the surface. Those beyond the last bit go unseen.
pub type Sides = u128;

/// The surfaces about a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surroundings {
    /// Sides on which the state lies.
    pub sides: Sides,
    /// Least distance of a surface, on either side.
    pub nearest: f64,
}

impl Surroundings {
    /// No surface anywhere.
    pub const SMOOTH: Self = Self {
        sides: 0,
        nearest: f64::INFINITY,
    };
}

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

    /// On which side of every surface at which the derivative is not smooth the state lies, and how far
    /// the nearest one is.
    fn surroundings(&self, _time: f64, _state: &[f64; N]) -> Surroundings {
        Surroundings::SMOOTH
    }

    /// How far the state is past a surface, negative before it: continuous, with a simple zero at
    /// the surface.
    fn past(&self, _surface: u32, _time: f64, _state: &[f64; N]) -> f64 {
        f64::INFINITY
    }

    /// No surface comes nearer by more than this between two times with their states; infinite where
    /// nothing is known.
    fn approach(&self, _times: [f64; 2], _states: [&[f64; N]; 2]) -> f64 {
        f64::INFINITY
    }

    /// Distance that a state has from all surfaces, wherever these are by the time; not positive where that is not
    /// known. A [`System::shift`] below it spares [`System::surroundings`] and [`System::approach`].
    fn clearance(&self, _state: &[f64; N]) -> f64 {
        0.0
    }

    /// No surface comes nearer by more than this from one state to another, where it stays as it is by the time;
    /// infinite where nothing is known. It is to cost little.
    fn shift(&self, _states: [&[f64; N]; 2]) -> f64 {
        f64::INFINITY
    }

    /// Upper bound of what a surface has added to each component of the derivative at a distance
    /// past it: it grows with a broken power of the distance, like a contact force.
    fn added(&self, _surface: u32, _time: f64, _distance: f64) -> [f64; N] {
        [0.0; N]
    }

    /// Whether the state is (q, q̇), displacements first and as many velocities after them: the motion
    /// between two steps then follows from both ends at no cost.
    fn is_second_order(&self) -> bool {
        false
    }

    /// Whether the motion is expected to cross a surface at which the derivative is not smooth: estimated before the
    /// motion is known.
    fn expects_crossings(&self) -> bool {
        true
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
