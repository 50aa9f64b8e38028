//! The static equilibrium of one bearing by itself.

use super::{Equilibrium, RotorError, StaticProblem};
use crate::bearing::{Bearing, Matrix5, MountedBearing, Support, Vector5};

impl Bearing {
    /// Where the inner ring of the standing bearing finds its place under a load on its centre: forces x, y, z in
    /// N, moments about X and Y in N m. Dry Hertz contacts, no preload; all five freedoms are free, a positive axial
    /// force loads an angular contact bearing.
    ///
    /// Films, ball inertia, several bearings and held freedoms: [`crate::quasi_static::quasi_static`].
    ///
    /// ```
    /// use jeffcott::bearing::Bearing;
    /// // 1 kN along the axis of a 7205C: its balls bear alike, and the ring moves by 32 µm
    /// let equilibrium = Bearing::catalogue("7205C")?.equilibrium([0.0, 0.0, 1000.0, 0.0, 0.0])?;
    /// assert!((equilibrium.displacement[2] - 31.9764e-6).abs() < 1e-10);
    /// let stiffness = equilibrium.stiffness();
    /// assert!((stiffness[(0, 0)] / stiffness[(1, 1)] - 1.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RotorError`] where the contacts cannot be formed, or nothing carries the load.
    pub fn equilibrium(&self, load: Vector5) -> Result<Equilibrium, RotorError> {
        let mounted = MountedBearing::new(*self);
        let support = Support::new(&mounted, 0.0)
            .map_err(|source| RotorError::Bearing { number: 1, source })?;
        let problem = StaticProblem {
            supports: &[support],
            load,
            free: [true; 5],
            start: [0.0; 5],
            speed: 0.0,
        };
        Ok(problem.solve()?)
    }
}

impl Equilibrium {
    /// K = ∂F/∂q, rows and columns x, y, z, θx, θy; N/m, N/rad, N m/m, N m/rad.
    pub fn stiffness(&self) -> &Matrix5 {
        &self.stiffness
    }
}
