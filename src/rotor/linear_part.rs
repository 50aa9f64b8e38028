//! The linear part of the equations of motion.

use nalgebra::{Complex, DMatrix};

use super::coefficients::{Coefficients, Mass, half_square};
use super::dot;

/// What is linear in the degrees of freedom, at a speed ω of the shaft:
///
/// ```text
/// M q̈ + (C + ω G) q̇ + (K − ω H) q
/// ```
///
/// with H of the damping inside the shaft, which turns with it. Its matrices hold linear bearings, housings and the shaft.
#[derive(Debug, Clone)]
pub(super) struct LinearPart {
    /// M.
    pub mass: Mass,
    /// C.
    pub damping: Coefficients,
    /// G.
    pub gyroscopic: Coefficients,
    /// K without the ball bearings.
    pub stiffness: Coefficients,
    /// H.
    pub circulatory: Coefficients,
    /// The part of C that turns with the shaft, where there is any.
    pub internal_damping: Option<Coefficients>,
    /// Whether a part of K is not symmetric and so has no potential, as of films.
    pub crosses: bool,
}

/// What the linear part does to the energy of a motion.
pub(super) struct LinearPowers {
    /// Power that viscous damping takes, W.
    pub viscous: f64,
    /// Power of the part of K that has no potential, W.
    pub crossing: f64,
    /// Moment of the damping inside the shaft on the rotation, N m.
    pub internal_moment: f64,
}

impl LinearPart {
    /// Number of degrees of freedom.
    fn dofs(&self) -> usize {
        self.mass.entries.nrows()
    }

    /// Adds the forces by the velocities, `−(C + ω G) q̇`.
    #[inline(always)]
    pub fn add_forces_by_rate(&self, speed: f64, velocity: &[f64], sum: &mut [f64]) {
        self.gyroscopic.add_product(-speed, velocity, sum);
        self.damping.add_product(-1.0, velocity, sum);
    }

    /// Adds the forces by the place, `−(K − ω H) q`.
    #[inline(always)]
    pub fn add_forces_by_place(&self, speed: f64, place: &[f64], sum: &mut [f64]) {
        self.stiffness.add_product(-1.0, place, sum);
        self.circulatory.add_product(speed, place, sum);
    }

    /// K − ω H, of all coordinates.
    pub fn by_place(&self, speed: f64) -> DMatrix<f64> {
        self.stiffness.plus(-speed, &self.circulatory)
    }

    /// C + ω G, of all coordinates: what resists, and the gyroscopic coupling of the tilts.
    pub fn by_rate(&self, speed: f64) -> DMatrix<f64> {
        self.damping.plus(speed, &self.gyroscopic)
    }

    /// Writes the slopes of `(q̇, −M⁻¹ (A q + B q̇))` by (q, q̇), where the first rows and columns of A and B are those of the
    /// degrees of freedom.
    pub fn write_state_matrix(
        &self,
        [by_place, by_rate]: &[DMatrix<f64>; 2],
        matrix: &mut DMatrix<f64>,
    ) {
        let (dofs, states) = (self.dofs(), matrix.nrows());
        let (of_places, of_rates) = matrix.as_mut_slice().split_at_mut(states * dofs);
        for (half, slopes) in [(of_places, by_place), (of_rates, by_rate)] {
            let forces = slopes.as_slice().chunks_exact(slopes.nrows());
            for (column, forces) in half.chunks_exact_mut(states).zip(forces) {
                let (rates, accelerations) = column.split_at_mut(dofs);
                rates.fill(0.0);
                for (own, force) in accelerations.iter_mut().zip(forces) {
                    *own = -force;
                }
                self.mass.accelerate(accelerations);
            }
        }
        for dof in 0..dofs {
            matrix[(dof, dofs + dof)] = 1.0;
        }
    }

    /// Dynamic stiffness `A − ω² M + iω B` at an angular frequency ω of what holds by place, A, and by rate, B.
    pub fn dynamic_stiffness(
        &self,
        [by_place, by_rate]: &[DMatrix<f64>; 2],
        omega: f64,
    ) -> DMatrix<Complex<f64>> {
        DMatrix::from_fn(self.dofs(), self.dofs(), |row, column| {
            let inertia = omega * omega * self.mass.entries[(row, column)];
            let rate = omega * by_rate[(row, column)];
            Complex::new(by_place[(row, column)] - inertia, rate)
        })
    }

    /// Kinetic energy `½ q̇ᵀ M q̇`, J.
    pub fn kinetic(&self, velocity: &[f64]) -> f64 {
        half_square(&self.mass.entries, velocity)
    }

    /// Elastic energy `½ qᵀ K q`, J.
    pub fn elastic(&self, place: &[f64]) -> f64 {
        half_square(&self.stiffness.entries, place)
    }

    /// What it does to the energy in a state at a speed.
    pub fn powers(&self, place: &[f64], velocity: &[f64], speed: f64) -> LinearPowers {
        let damped = |damping: &Coefficients| half_square(&damping.entries, velocity);
        let turning = self.internal_damping.as_ref().map_or(0.0, damped);
        let [internal, internal_moment] = self.internal_powers(place, velocity, speed);
        LinearPowers {
            viscous: 2.0 * (damped(&self.damping) - turning) + internal,
            crossing: self.crossing_power(place, velocity),
            internal_moment,
        }
    }

    /// Power in W that damping inside the shaft takes of the velocities in the frame that turns with it, and its moment on
    /// the rotation in N m.
    fn internal_powers(&self, place: &[f64], velocity: &[f64], speed: f64) -> [f64; 2] {
        let Some(internal) = &self.internal_damping else {
            return [0.0; 2];
        };
        let [mut across, mut resisting] = [(); 2].map(|()| vec![0.0; self.dofs()]);
        self.circulatory.add_product(1.0, place, &mut across);
        internal.add_product(1.0, place, &mut resisting);
        let (crossing, held) = (dot(&across, velocity), dot(&resisting, place));
        let moment = crossing - speed * held;
        let along = 2.0 * half_square(&internal.entries, velocity);
        [along - speed * (crossing + moment), moment]
    }

    /// Power of the part of K that is not symmetric, `−½ (q̇ᵀ K q − qᵀ K q̇)`, W.
    fn crossing_power(&self, place: &[f64], velocity: &[f64]) -> f64 {
        if !self.crosses {
            return 0.0;
        }
        let [mut by_place, mut by_rate] = [(); 2].map(|()| vec![0.0; self.dofs()]);
        self.stiffness.add_product(1.0, place, &mut by_place);
        self.stiffness.add_product(1.0, velocity, &mut by_rate);
        0.5 * (dot(&by_rate, place) - dot(&by_place, velocity))
    }
}
