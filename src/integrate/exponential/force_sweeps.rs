//! Sweeps over the points of a step where few forces make the remainder.
//!
//! ```text
//! x_i = V_x (E_i z + c_i) + Σ_j B_ij u_j,   u_i = w(t + c_i h, x₀ + x_i) − K x_i        i = 1 … 6
//! ```
//!
//! with the matrices of `force_operator.rs`. The modes take part at the end of each sweep alone.

use super::force_operator::{ForceOperator, LATER};
use super::nodes::POINTS;
use super::remainder::FewForces;
use super::sweeps::{Moved, Sweeps, Trial};
use crate::integrate::chunks::{Padded, add_scaled};

/// Room for the sweeps.
#[derive(Debug, Clone, Default)]
pub(super) struct ForceSweeps {
    /// V_x (E_i z + c_i) of the points after the first, and E z + c of the end.
    free: Vec<Padded>,
    free_end: Padded,
    /// The u_j, one point after the other, and by how much the latest sweep changed them.
    forces: Vec<f64>,
    change: Vec<f64>,
    /// By how much that moves x at the end.
    shift: Padded,
}

impl ForceSweeps {
    /// Makes room for so many states x and forces.
    fn resize(&mut self, seen: usize, forces: usize) {
        if self.free.len() != LATER || self.shift.len() != seen {
            self.free = vec![Padded::zeros(seen); LATER];
            self.shift = Padded::zeros(seen);
        }
        self.forces.resize(POINTS * forces, 0.0);
        self.change.resize(POINTS * forces, 0.0);
        // nothing changes the forces at the start
        self.change[..forces].fill(0.0);
    }
}

impl Sweeps {
    /// Begins a trial with the forces guessed in `remainder`: finds what the start alone leads to.
    #[inline(always)]
    pub(super) fn begin_forces(
        &mut self,
        trial: &Trial<'_>,
        few: &FewForces,
        operator: &ForceOperator,
    ) {
        let (room, coordinates) = (&mut self.room, &mut self.shift.coordinates);
        let forces = few.acting.len();
        room.resize(few.seen.len(), forces);
        for (point, (free, constant)) in room.free.iter_mut().zip(&operator.constant).enumerate() {
            let from = &trial.from.coordinates;
            trial.operator.find_free(point + 1, from, coordinates);
            let sums = coordinates.chunks_mut().iter_mut();
            sums.zip(constant.chunks())
                .for_each(|(sum, constant)| add_scaled(sum, 1.0, constant));
            few.shapes.multiply::<false>(coordinates, free.chunks_mut());
        }
        room.free_end.clone_from(coordinates);
        self.to.deviation.copy_from(&trial.from.deviation);
        for (number, force) in room.forces.iter_mut().enumerate() {
            let (point, own) = (number / forces, number % forces);
            *force = self.remainder[own / 4][point][own % 4];
        }
    }

    /// Finds the forces point by point, each with the latest ones at all others, and the end of the step that they lead to.
    #[inline(always)]
    pub(super) fn sweep_forces(
        &mut self,
        trial: &Trial<'_>,
        few: &FewForces,
        operator: &ForceOperator,
    ) -> Moved {
        let (room, count) = (&mut self.room, few.acting.len());
        for point in 1..POINTS {
            // x_i = V_x (E_i z + c_i) + Σ_j B_ij u_j, the latest u_j
            let seen = &mut self.deviations[point];
            let (free, matrix) = (room.free[point - 1].chunks(), &operator.seen[point - 1]);
            seen.chunks_mut()[..free.len()].copy_from_slice(free);
            matrix.multiply::<true>(&room.forces, seen.chunks_mut());
            // u_i of x_i at t + c_i h, and Δu_i
            let (system, time) = (trial.problem.system, trial.time_of(point));
            self.evaluation.evaluate_forces(few, system, time, seen);
            let own = count * point..count * (point + 1);
            let known = room.forces[own.clone()].iter_mut();
            let changes = known.zip(&mut room.change[own]);
            for ((known, change), found) in changes.zip(self.evaluation.remainder.iter()) {
                *change = found - *known;
                *known = *found;
            }
        }
        let change = self.seen_shift(trial, few, operator);
        self.find_end(trial, operator);
        Moved {
            change,
            end: self.end_shift(),
        }
    }

    /// How far the latest sweep moves x at the end, Σ_j B_j Δu_j, in its units.
    #[inline(always)]
    fn seen_shift(&mut self, trial: &Trial<'_>, few: &FewForces, operator: &ForceOperator) -> f64 {
        let room = &mut self.room;
        let shift = room.shift.chunks_mut();
        operator.seen[LATER - 1].multiply::<false>(&room.change, shift);
        let units = few.seen.iter().map(|own| trial.problem.scaling.scale[*own]);
        let parts = room.shift.iter().zip(units);
        let parts = parts.map(|(shift, unit)| shift / unit);
        parts.map(|part| part * part).sum::<f64>().sqrt()
    }

    /// Finds the end of the step, how far it is from where it was, and what error of it is allowed.
    #[inline(always)]
    fn find_end(&mut self, trial: &Trial<'_>, operator: &ForceOperator) {
        let (to, shift) = (&mut self.to, &mut self.shift.deviation);
        shift.copy_from(&to.deviation);
        // z₁ = E z + c + Σ_j A_j V⁻¹ D u_j, y₁ = V z₁
        to.coordinates.copy_from(&self.room.free_end);
        let sum = to.coordinates.chunks_mut();
        operator.end.multiply::<true>(&self.room.forces, sum);
        let linear = trial.linear;
        linear.find_deviation(&to.coordinates, &mut to.deviation);
        for (shift, now) in shift.iter_mut().zip(to.deviation.iter()) {
            *shift = now - *shift;
        }
        self.allow(trial);
    }

    /// Takes the forces that the sweeps found as the remainder.
    #[inline(always)]
    pub(super) fn take_forces(&mut self, few: &FewForces) {
        let count = few.acting.len();
        for point in 0..POINTS {
            for own in 0..count {
                self.remainder[own / 4][point][own % 4] = self.room.forces[count * point + own];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use nalgebra::DMatrix;

    use crate::integrate::{
        Grid, Integration, Method, Scaling, Separated, Settings, States, System,
    };

    /// q₁″ = −10⁴ q₁ + 3·10³ q₂ − 5 q̇₁ + w, q₂″ = 2·10³ q₁ − 4·10³ q₂ + 2, with w = cos 7t − 4·10³ q₁³ and, beside both, a
    /// third state that decays.
    struct Chain {
        is_separated: bool,
    }

    fn matrix() -> DMatrix<f64> {
        let rows = [
            [0.0, 0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 1.0, 0.0],
            [-1e4, 3e3, -5.0, 0.0, 0.3],
            [2e3, -4e3, 0.0, 0.0, 0.0],
            [0.0, 0.2, 0.0, 0.0, -30.0],
        ];
        DMatrix::from_row_slice(5, 5, rows.as_flattened())
    }

    const CONSTANT: [f64; 5] = [0.0, 0.0, 0.0, 2.0, 0.0];

    impl System for Chain {
        fn states(&self) -> usize {
            5
        }

        fn derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
            let linear = matrix() * DMatrix::from_column_slice(5, 1, state);
            for (rate, (linear, constant)) in rate.iter_mut().zip(linear.iter().zip(CONSTANT)) {
                *rate = linear + constant;
            }
            let mut forces = [0.0; 5];
            self.forces(time, state, &mut forces);
            rate[2] += forces[0];
        }

        fn separated(&self, time: f64, state: &[f64]) -> Option<Separated> {
            let mut inputs = DMatrix::zeros(5, 1);
            inputs[2] = 1.0;
            self.is_separated.then(|| Separated {
                constant: CONSTANT.to_vec(),
                matrix: matrix(),
                seen: vec![0],
                acting: vec![0],
                inputs,
                slopes: self.force_slopes(time, state, &[0], &[0]),
            })
        }

        fn forces(&self, time: f64, state: &[f64], forces: &mut [f64]) {
            forces[0] = (7.0 * time).cos() - 4e3 * state[0].powi(3);
        }

        fn force_slopes(
            &self,
            _time: f64,
            state: &[f64],
            _seen: &[usize],
            _acting: &[usize],
        ) -> DMatrix<f64> {
            DMatrix::from_element(1, 1, -1.2e4 * state[0].powi(2))
        }
    }

    /// States at ten samples by a method, and the evaluations that they took.
    fn motion(method: Method, tolerance: f64, is_separated: bool) -> (States, u64) {
        let stop = AtomicBool::new(false);
        let settings = Settings {
            method,
            tolerance,
            step_limit: u64::MAX,
        };
        let grid = Grid {
            interval: 0.2,
            count: 10,
        };
        let (system, scaling) = (Chain { is_separated }, Scaling::identity(5));
        let start = [0.3, -0.2, 1.0, 4.0, 0.1];
        let mut integration = Integration::new(&system, scaling, grid, settings, &stop, &start);
        let mut states = States::with_capacity(5, 10);
        integration.advance(10, &mut states).expect("it runs");
        (states, integration.counters().evaluations)
    }

    /// By few forces, by the whole derivative and by Verner's pair: the same motion, and by few forces at most a tenth more
    /// evaluations than by the whole derivative.
    #[test]
    fn a_motion_by_few_forces_is_that_of_the_whole_derivative() {
        let (truth, _) = motion(Method::Verner76, 1e-13, false);
        let (whole, by_whole) = motion(Method::Exponential, 1e-9, false);
        let (few, by_few) = motion(Method::Exponential, 1e-9, true);
        for (name, found) in [("whole", whole), ("few", few)] {
            let pairs = found.as_slice().iter().zip(truth.as_slice());
            let error = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            println!("{name}: {error:e}");
            assert!(error < 1e-7, "{name}: {error:e}");
        }
        println!("{by_whole} {by_few}");
        assert!(by_few <= by_whole + by_whole / 10, "{by_few}, {by_whole}");
    }
}
