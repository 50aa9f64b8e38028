//! What the user chooses about the integration, and what it costs.

/// Integration method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The cheapest of Verner 7(6), Dormand–Prince 8(5,3), the Nyström pair 8(6) and exponential collocation, chosen
    /// on the way.
    Auto,
    /// Verner 7(6), "most efficient".
    Verner76,
    /// Dormand–Prince 8(5,3).
    Dop853,
    /// Tsitouras 5(4).
    Tsit5,
    /// Dormand–El-Mikkawy–Prince 8(6), a Runge–Kutta–Nyström pair: for forces that know the velocity in
    /// constant linear terms alone.
    Dprkn8,
    /// Dormand–El-Mikkawy–Prince 12(10), as [`Method::Dprkn8`].
    Dprkn12,
    /// Dormand–Prince 5(4) of the library `ode_solvers`.
    Dopri5,
    /// Dormand–Prince 8(5,3) of the library `ode_solvers`.
    OdeSolversDop853,
    /// Exponential collocation of order 7: the linear part exactly, for motion that follows a slow drive.
    Exponential,
    /// RODAS 4(3): linearly implicit, for stiff systems.
    Rodas,
}

impl Method {
    /// Whether it is a Nyström method, which a [`super::System`] must serve by
    /// [`super::System::velocity_slopes`].
    pub fn is_nystrom(self) -> bool {
        matches!(self, Self::Dprkn8 | Self::Dprkn12)
    }

    /// Whether its steps end on the surfaces of a [`super::System`] at which the derivative is not smooth.
    pub fn lands_on_surfaces(self) -> bool {
        matches!(self, Self::Verner76 | Self::Dop853 | Self::Tsit5)
    }
}

/// Method, tolerance and limits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Method.
    pub method: Method,
    /// Error aimed at, relative to the scale of the motion; a step's own error is kept at a part of it
    /// that is measured for each method.
    pub tolerance: f64,
    /// Largest number of steps, accepted and rejected together.
    pub step_limit: u64,
}

/// Work done by an integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counters {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Evaluations of the derivative.
    pub evaluations: u64,
}

impl Counters {
    /// Adds the work of a further part.
    pub fn add(&mut self, part: &Self) {
        self.steps += part.steps;
        self.rejected += part.rejected;
        self.evaluations += part.evaluations;
    }
}
