//! Stages of a step, its end and its error.

use fearless_simd::Simd;

use super::entries::Entries;
use super::factor::Factor;
use super::row::Row;
use super::tableau::{MOST, Pair, sums};
use super::walk::Walk;
use crate::integrate::course::Course;
use crate::integrate::registers::in_wide_registers;
use crate::integrate::{Scaling, System};

impl<const N: usize> Walk<N> {
    /// f at a deviation of place from an origin.
    #[inline(always)]
    pub(super) fn push<S: System<N>, V: Simd>(
        &mut self,
        simd: V,
        system: &S,
        time: f64,
        [origin, place]: [&Row<N>; 2],
    ) -> Row<N> {
        let state = Row::of(|register| origin.load(simd, register) + place.load(simd, register));
        let mut push = Row::ZERO;
        system.push(time, &state, &mut push);
        self.counters.evaluations += 1;
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
        factor: &mut Factor<E, N>,
    ) -> f64 {
        in_wide_registers!(self.level, simd => self.tried::<P, S, E, _>(simd, course, factor))
    }

    #[inline(always)]
    fn tried<P: Pair, S: System<N>, E: Entries<N>, V: Simd>(
        &mut self,
        simd: V,
        course: &Course<'_, S, N>,
        factor: &mut Factor<E, N>,
    ) -> f64 {
        factor.prepare::<P, V>(simd, self.size);
        self.to.state = self.moved_by::<P, S, E, V>(simd, course, factor);
        if const { P::ENDS_ON_STAGE } {
            let [origin, place] = [&course.scaling.origin, &self.to.state].map(Row::place);
            let end = self.stage_time(1.0);
            self.to.push = self.push(simd, course.system, end, [&origin, &place]);
            let last = const { P::STAGES - 1 };
            let force = factor.add_square(simd, &place, &self.to.push);
            self.stages[last] = factor.back(simd, last, &force);
        }
        self.error::<P, E, V>(simd, course.scaling) / (P::LOCAL_PART * course.settings.tolerance)
    }

    /// Deviation after a step of the present size.
    #[inline(always)]
    pub(super) fn moved_by<P: Pair, S: System<N>, E: Entries<N>, V: Simd>(
        &mut self,
        simd: V,
        course: &Course<'_, S, N>,
        factor: &Factor<E, N>,
    ) -> [f64; N] {
        let size = self.size;
        let [origin, from] = [&course.scaling.origin, &self.from.state].map(Row::place);
        // h u′ = h (v + B q) at the start
        let (velocity, half) = (Row::velocity(&self.from.state), factor.half(simd, &from));
        let slope =
            Row::of(|register| (velocity.load(simd, register) + half.load(simd, register)) * size);
        let mut force = factor.add_square(simd, &from, &self.from.push);
        self.stages[0] = factor.back(simd, 0, &force);
        for index in 1..const { P::STAGES - P::ENDS_ON_STAGE as usize } {
            let node = const { &P::NODES }[index];
            let before = &const { &P::ARGUMENTS }[index][..index - 1];
            let [sum] = sums(simd, [before], &self.stages);
            let moved = Row::of(|register| {
                let straight = from.load(simd, register) + slope.load(simd, register) * node;
                straight + sum.load(simd, register)
            });
            // the latest force comes last: all else is known by the time that it is
            let (known, onward) = (
                factor.forth(simd, index, &moved),
                factor.onward(simd, index, &force),
            );
            let place =
                Row::of(|register| known.load(simd, register) + onward.load(simd, register));
            let time = self.stage_time(node);
            let push = self.push(simd, course.system, time, [&origin, &place]);
            force = factor.add_square(simd, &place, &push);
            self.stages[index] = factor.back(simd, index, &force);
        }
        self.arrival::<P, E, V>(simd, factor, [&from, &slope])
    }

    /// Deviation at the end of the step, from its stages, its start and h u′ there.
    #[inline(always)]
    fn arrival<P: Pair, E: Entries<N>, V: Simd>(
        &self,
        simd: V,
        factor: &Factor<E, N>,
        [from, slope]: [&Row<N>; 2],
    ) -> [f64; N] {
        let last = const { P::STAGES - 1 };
        let known = const { P::STAGES - P::ENDS_ON_STAGE as usize };
        let factors = const { [&P::PLACE, &P::VELOCITY] }.map(|all: &[f64; MOST]| &all[..known]);
        let [place, velocity] = sums(simd, factors, &self.stages);
        let moved = Row::of(|register| {
            let way = slope.load(simd, register) + place.load(simd, register);
            from.load(simd, register) + way
        });
        let place = factor.forth(simd, last, &moved);
        let slope = Row::of(|register| {
            (slope.load(simd, register) + velocity.load(simd, register)) / self.size
        });
        // v = exp(−B h) u′ − B q
        let slope = factor.forth(simd, last, &slope);
        let half = factor.half(simd, &place);
        let velocity = Row::of(|register| slope.load(simd, register) - half.load(simd, register));
        Row::state(&place, &velocity)
    }

    /// Root mean square of the error, relative to one unit and the deviation; of motions side by side that of
    /// the worst.
    #[inline(always)]
    fn error<P: Pair, E: Entries<N>, V: Simd>(&self, simd: V, scaling: &Scaling<N>) -> f64 {
        let factors = const { [&P::PLACE_ERROR, &P::VELOCITY_ERROR, &P::COARSE_ERROR] };
        let factors = factors.map(|all: &[f64; MOST]| &all[..P::STAGES]);
        let [place, velocity, coarse] = sums(simd, factors, &self.stages);
        let unit =
            |i: usize| scaling.scale[i] + self.from.state[i].abs().max(self.to.state[i].abs());
        let mut worst = 0.0;
        for motion in 0..E::MOTIONS {
            let (mut fine, mut both) = (0.0, 0.0);
            for i in (motion..N / 2).step_by(E::MOTIONS) {
                let per_velocity = (self.size * unit(N / 2 + i)).recip();
                let parts = [
                    place[i] / unit(i),
                    velocity[i] * per_velocity,
                    coarse[i] * per_velocity,
                ];
                fine += parts[0] * parts[0] + parts[1] * parts[1];
                both += parts[2] * parts[2];
            }
            both += fine;
            if both != 0.0 {
                let states = const { N / E::MOTIONS } as f64;
                let error = fine / (both * states).sqrt();
                // what is no number is worst of all
                worst = if worst >= error { worst } else { error };
            }
        }
        worst
    }
}
