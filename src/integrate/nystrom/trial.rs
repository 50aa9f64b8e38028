//! Stages of a step, its end and its error.

use fearless_simd::Level;

use super::entries::Entries;
use super::factor::Factor;
use super::tableau::{
    Arguments, CoarseError, Factors, Pair, Place, PlaceError, Velocity, VelocityError, sum,
};
use super::walk::Walk;
use crate::integrate::course::Course;
use crate::integrate::registers::in_wide_registers;
use crate::integrate::{Scaling, System};

impl<const N: usize> Walk<N> {
    /// f at a deviation of place.
    #[inline(always)]
    pub(super) fn push<S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        time: f64,
        place: &[f64; N],
    ) -> [f64; N] {
        let (mut state, mut rate, mut push) = ([0.0; N], [0.0; N], [0.0; N]);
        for i in 0..N / 2 {
            state[i] = course.scaling.origin[i] + place[i];
        }
        course.system.derivative(time, &state, &mut rate);
        self.counters.evaluations += 1;
        for i in 0..N / 2 {
            push[i] = rate[N / 2 + i];
        }
        push
    }

    /// Time of a stage: what begins at a break is no part of a step that ends there.
    #[inline(always)]
    pub(super) fn stage_time(&self, node: f64) -> f64 {
        (self.from.time + node * self.size).min(self.limit.next_down())
    }

    /// Tries a step; its error over what is allowed, or no number.
    pub(super) fn trial<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &Factor<E, N>,
    ) -> f64 {
        if const { E::MOTIONS > 1 } {
            in_wide_registers!(Level::new(), self.tried::<P, S, E>(course, factor))
        } else {
            self.tried::<P, S, E>(course, factor)
        }
    }

    #[inline(always)]
    fn tried<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &Factor<E, N>,
    ) -> f64 {
        self.to.state = self.moved_by::<P, S, E>(course, factor);
        if const { P::ENDS_ON_STAGE } {
            let to = self.to.state;
            self.to.push = self.push(course, self.stage_time(1.0), &to);
            self.keep_stage(factor, const { P::STAGES - 1 }, self.to.push, &to);
        }
        self.error::<P, E>(course.scaling) / (P::LOCAL_PART * course.settings.tolerance)
    }

    /// Deviation after a step of the present size.
    #[inline(always)]
    pub(super) fn moved_by<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &Factor<E, N>,
    ) -> [f64; N] {
        self.stages[0] = self.from.push;
        factor.add_square(&self.from.state, &mut self.stages[0]);
        // u′ = v + B q at the start
        let mut slope = [0.0; N];
        slope[..N / 2].copy_from_slice(&self.from.state[N / 2..]);
        let half = factor.half(&self.from.state);
        for i in 0..N / 2 {
            slope[i] += half[i];
        }
        macro_rules! stages {
            ($($stage:literal)*) => {$(
                if const { $stage < P::STAGES - P::ENDS_ON_STAGE as usize } {
                    self.stage::<P, S, E, $stage>(course, factor, &slope);
                }
            )*};
        }
        stages!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16);
        self.arrival::<P, E>(factor, &slope)
    }

    #[inline(always)]
    fn stage<P: Pair, S: System<N>, E: Entries<N>, const I: usize>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &Factor<E, N>,
        slope: &[f64; N],
    ) {
        let node = const { P::NODES[I] };
        let place = factor.forth(I, &self.moved::<Arguments<P, I>>(node, slope));
        let push = self.push(course, self.stage_time(node), &place);
        self.keep_stage(factor, I, push, &place);
    }

    /// u″ = exp(B τ) (f + B² q) as a stage.
    #[inline(always)]
    fn keep_stage<E: Entries<N>>(
        &mut self,
        factor: &Factor<E, N>,
        stage: usize,
        mut push: [f64; N],
        place: &[f64; N],
    ) {
        factor.add_square(place, &mut push);
        self.stages[stage] = factor.back(stage, &push);
    }

    /// u at a part of the step, by some factors.
    #[inline(always)]
    fn moved<F: Factors>(&self, node: f64, slope: &[f64; N]) -> [f64; N] {
        let sum = sum::<F, N>(&self.stages);
        let mut moved = [0.0; N];
        for i in 0..N / 2 {
            moved[i] = self.from.state[i] + self.size * (node * slope[i] + self.size * sum[i]);
        }
        moved
    }

    /// Deviation at the end of the step, from its stages.
    #[inline(always)]
    fn arrival<P: Pair, E: Entries<N>>(&self, factor: &Factor<E, N>, slope: &[f64; N]) -> [f64; N] {
        let last = const { P::STAGES - 1 };
        let mut arrival = factor.forth(last, &self.moved::<Place<P>>(1.0, slope));
        let sum = sum::<Velocity<P>, N>(&self.stages);
        let mut velocity = *slope;
        for i in 0..N / 2 {
            velocity[i] += self.size * sum[i];
        }
        // v = exp(−B h) u′ − B q
        let (velocity, half) = (factor.forth(last, &velocity), factor.half(&arrival));
        for i in 0..N / 2 {
            arrival[N / 2 + i] = velocity[i] - half[i];
        }
        arrival
    }

    /// Root mean square of the error, relative to one unit and the deviation; of motions side by side that of
    /// the worst.
    #[inline(always)]
    fn error<P: Pair, E: Entries<N>>(&self, scaling: &Scaling<N>) -> f64 {
        let place = sum::<PlaceError<P>, N>(&self.stages);
        let velocity = sum::<VelocityError<P>, N>(&self.stages);
        let coarse = sum::<CoarseError<P>, N>(&self.stages);
        let unit =
            |i: usize| scaling.scale[i] + self.from.state[i].abs().max(self.to.state[i].abs());
        let mut worst = 0.0;
        for motion in 0..E::MOTIONS {
            let (mut fine, mut both) = (0.0, 0.0);
            for i in (motion..N / 2).step_by(E::MOTIONS) {
                let per_velocity = unit(N / 2 + i).recip();
                let parts = [
                    self.size * place[i] / unit(i),
                    velocity[i] * per_velocity,
                    coarse[i] * per_velocity,
                ];
                fine += parts[0] * parts[0] + parts[1] * parts[1];
                both += parts[2] * parts[2];
            }
            both += fine;
            if both != 0.0 {
                let states = const { N / E::MOTIONS } as f64;
                let error = self.size * fine / (both * states).sqrt();
                // what is no number is worst of all
                worst = if worst >= error { worst } else { error };
            }
        }
        worst
    }
}
