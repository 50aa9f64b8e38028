//! Steps of a Nyström pair, one after the other, and the states between their ends.

use super::entries::{All, Entries, Few};
use super::factor::Factor;
use super::tableau::{
    Arguments, CoarseError, Factors, MOST, Pair, Place, PlaceError, Velocity, VelocityError, sum,
};
use super::within::{ENDS, End, Within};
use crate::integrate::control::Control;
use crate::integrate::course::{Course, STRETCH};
use crate::integrate::{Counters, IntegrateError, Scaling, System, VelocityDependence};

/// Factors of the step size between which it stays as it is: the integrating factor is then at hand.
const KEPT: std::ops::Range<f64> = 0.95..1.2;
/// Part of the error aimed at that states within a step may be estimated to have of their own.
const WITHIN_PART: f64 = 0.3;
/// Starts of steps before the latest that are kept.
const PAST: usize = ENDS - 2;

/// Single numbers of a walk.
const SINGLE: usize = 5 + STANDS;
/// Stands of a walk.
const STANDS: usize = 2 + PAST;

/// A deviation and the force in it.
#[derive(Debug, Clone, Copy)]
struct Stand<const N: usize> {
    time: f64,
    state: [f64; N],
    /// f; the first N/2 components are used, as in all vectors of freedoms.
    push: [f64; N],
}

impl<const N: usize> AnyFactor<N> {
    fn of<S: System<N>>(system: &S) -> Result<Self, VelocityDependence> {
        let slopes = system.velocity_slopes()?;
        Ok(if Few::holds(&slopes) {
            Self::Few(Box::new(Factor::new(&slopes)))
        } else {
            Self::All(Box::new(Factor::new(&slopes)))
        })
    }
}

/// How states within the latest step are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Dense {
    /// Nobody has asked yet.
    Unknown,
    ByPolynomial,
    /// By a step of their own.
    BySteps,
}

/// The latest step, and how to go on. States are kept as deviations from the scaling's origin: sums
/// of them lose less to round-off.
#[derive(Debug, Clone)]
pub(in crate::integrate) struct Walk<const N: usize> {
    from: Stand<N>,
    to: Stand<N>,
    /// Starts of the steps before, the latest first, back to the latest break, and their number.
    past: [Stand<N>; PAST],
    known: usize,
    /// Size of the latest step and of the next one, s.
    size: f64,
    next_size: f64,
    /// Time that the next step must not reach over, s.
    limit: f64,
    stages: [[f64; N]; MOST],
    dense: Dense,
    within: Within<N>,
    control: Control,
    /// Whether a trial since the latest good step was not finite.
    fault: bool,
    counters: Counters,
    /// Made as the walk begins, or goes on.
    factor: Option<AnyFactor<N>>,
}

/// The integrating factor, of as many entries as it takes.
#[derive(Debug, Clone)]
enum AnyFactor<const N: usize> {
    Few(Box<Factor<Few<N>, N>>),
    All(Box<Factor<All<N>, N>>),
}

impl<const N: usize> Walk<N> {
    /// Stands at time 0 in a deviation from the origin.
    pub fn new(deviation: [f64; N]) -> Self {
        let stand = Stand {
            time: 0.0,
            state: deviation,
            push: [0.0; N],
        };
        Self {
            from: stand,
            to: stand,
            past: [stand; PAST],
            known: 0,
            size: 0.0,
            next_size: 0.0,
            limit: 0.0,
            stages: [[0.0; N]; MOST],
            dense: Dense::Unknown,
            within: Within::NONE,
            control: Control::NEW,
            fault: false,
            counters: Counters::default(),
            factor: None,
        }
    }

    /// End of the latest step, s.
    pub fn time(&self) -> f64 {
        self.to.time
    }

    /// Size of the latest step, s, or, where a break or the end cut it, of the one to come; zero
    /// before the first.
    pub fn step_size(&self) -> f64 {
        if self.to.time >= self.limit {
            self.next_size
        } else {
            self.size
        }
    }

    /// Scaled state at the end of the latest step.
    pub fn scaled(&self, scaling: &Scaling<N>) -> [f64; N] {
        std::array::from_fn(|i| self.to.state[i] / scaling.scale[i])
    }

    /// Everything but the counters as numbers.
    pub fn numbers(&self) -> Vec<f64> {
        let single = [
            self.size,
            self.next_size,
            self.limit,
            self.known as f64,
            f64::from(u8::from(self.control.was_rejected())),
        ];
        let stands = || [&self.from, &self.to].into_iter().chain(&self.past);
        let times = stands().map(|stand| stand.time);
        let vectors = stands().flat_map(|stand| [stand.state, stand.push]);
        single
            .into_iter()
            .chain(times)
            .chain(vectors.flatten())
            .collect()
    }

    /// The walk of numbers as by [`Walk::numbers`], with its counters; none of any others.
    pub fn restored(numbers: &[f64], counters: Counters) -> Option<Self> {
        let (single, vectors) = numbers.split_at_checked(SINGLE)?;
        let vectors: &[[f64; N]] = match vectors.as_chunks() {
            (vectors, []) => vectors,
            _ => return None,
        };
        let [size, next_size, limit, known, rejected, times @ ..] =
            *<&[f64; SINGLE]>::try_from(single).ok()?;
        let vectors = <&[[f64; N]; 2 * STANDS]>::try_from(vectors).ok()?;
        let stand = |index: usize| Stand {
            time: times[index],
            state: vectors[2 * index],
            push: vectors[2 * index + 1],
        };
        Some(Self {
            from: stand(0),
            to: stand(1),
            past: std::array::from_fn(|index| stand(2 + index)),
            known: (known as usize).min(PAST),
            size,
            next_size,
            limit,
            control: Control::after(rejected != 0.0),
            counters,
            ..Self::new([0.0; N])
        })
    }

    /// Work done so far.
    pub fn counters(&self) -> Counters {
        self.counters
    }

    /// State at a time that is not before the start of the latest step; walks on as far as needed.
    ///
    /// # Errors
    /// Why the walk ends before that time.
    pub fn state_at<P: Pair, S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        time: f64,
    ) -> Result<[f64; N], IntegrateError> {
        let mut factor = match self.factor.take() {
            Some(factor) => factor,
            None => AnyFactor::of(course.system)?,
        };
        let deviation = match &mut factor {
            AnyFactor::Few(factor) => self.deviation_at::<P, S, _>(course, factor, time),
            AnyFactor::All(factor) => self.deviation_at::<P, S, _>(course, factor, time),
        };
        self.factor = Some(factor);
        let origin = &course.scaling.origin;
        deviation.map(|deviation| std::array::from_fn(|i| origin[i] + deviation[i]))
    }

    fn deviation_at<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &mut Factor<E, N>,
        time: f64,
    ) -> Result<[f64; N], IntegrateError> {
        while self.to.time < time {
            self.step::<P, S, E>(course, factor)?;
        }
        if time >= self.to.time {
            return Ok(self.to.state);
        }
        if self.dense == Dense::Unknown {
            self.dense = self.polynomial(course, factor);
        }
        if self.dense == Dense::ByPolynomial {
            return Ok(self.within.at(time));
        }
        Ok(self.by_step::<P, S, E>(course, factor, time))
    }

    fn step<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &mut Factor<E, N>,
    ) -> Result<(), IntegrateError> {
        self.begin::<P, S, E>(course, factor);
        loop {
            course.check(self.from.time, self.next_size, &self.counters, self.fault)?;
            let cut = self.from.time + STRETCH * self.next_size >= self.limit;
            self.size = if cut {
                self.limit - self.from.time
            } else {
                self.next_size
            };
            factor.prepare::<P>(self.size);
            let error = self.trial::<P, S, E>(course, factor);
            if error <= 1.0 {
                self.accept::<P>(error, cut, factor.largest_step());
                self.finish::<P, S>(course);
                return Ok(());
            }
            self.counters.rejected += 1;
            self.fault |= !error.is_finite();
            self.next_size = self.size * self.control.rejected(error, P::ERROR_POWER);
        }
    }

    /// Makes the end of the latest step the start of the next.
    fn begin<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &Factor<E, N>,
    ) {
        self.past.rotate_right(1);
        self.past[0] = self.from;
        self.known = (self.known + 1).min(PAST);
        self.from = self.to;
        self.dense = Dense::Unknown;
        if self.from.time >= self.limit {
            self.limit = course.limit_after(self.from.time);
            // the force after a break, or the very first
            let from = self.from;
            self.from.push = self.push(course, from.time, &from.state);
            self.known = 0;
        }
        if self.next_size <= 0.0 {
            let first = self.first_size::<P, S, E>(course, factor);
            self.next_size = first.min(factor.largest_step());
        }
    }

    fn first_size<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &Factor<E, N>,
    ) -> f64 {
        let end = end(&self.from, factor);
        let slope = std::array::from_fn(|i| {
            if i < N / 2 {
                end.velocity[i]
            } else {
                end.acceleration[i - N / 2]
            }
        });
        self.counters.evaluations += 1;
        let stretch = [self.from.time, self.limit];
        course.first_size(stretch, &self.from.state, &slope, P::ORDER)
    }

    /// f at a deviation of place.
    #[inline(always)]
    fn push<S: System<N>>(
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
    fn stage_time(&self, node: f64) -> f64 {
        (self.from.time + node * self.size).min(self.limit.next_down())
    }

    /// Tries a step; its error over what is allowed, or no number.
    fn trial<P: Pair, S: System<N>, E: Entries<N>>(
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
        self.error::<P>(course.scaling) / (P::LOCAL_PART * course.settings.tolerance)
    }

    /// Deviation after a step of the present size.
    #[inline(always)]
    fn moved_by<P: Pair, S: System<N>, E: Entries<N>>(
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

    /// Root mean square of the error, relative to one unit and the deviation.
    #[inline(always)]
    fn error<P: Pair>(&self, scaling: &Scaling<N>) -> f64 {
        let place = sum::<PlaceError<P>, N>(&self.stages);
        let velocity = sum::<VelocityError<P>, N>(&self.stages);
        let coarse = sum::<CoarseError<P>, N>(&self.stages);
        let unit =
            |i: usize| scaling.scale[i] + self.from.state[i].abs().max(self.to.state[i].abs());
        let (mut fine, mut both) = (0.0, 0.0);
        for i in 0..N / 2 {
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
        if both == 0.0 {
            return 0.0;
        }
        self.size * fine / (both * N as f64).sqrt()
    }

    /// Makes the end of a good step known, and the size of the next.
    fn accept<P: Pair>(&mut self, error: f64, cut: bool, largest: f64) {
        let growth = self.control.accepted(error, P::ERROR_POWER);
        let growth = if KEPT.contains(&growth) { 1.0 } else { growth };
        let proposed = (self.size * growth).min(largest);
        // a step that was cut tells little of how long the next may be
        self.next_size = if cut {
            proposed.max(self.next_size)
        } else {
            proposed
        };
        self.to.time = if cut {
            self.limit
        } else {
            self.from.time + self.size
        };
    }

    /// Completes a good step.
    fn finish<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) {
        if const { !P::ENDS_ON_STAGE } {
            let to = self.to.state;
            self.to.push = self.push(course, self.stage_time(1.0), &to);
        }
        self.counters.steps += 1;
        self.fault = false;
    }

    /// The polynomial for states within the step, where one is exact enough: of as few ends as it takes.
    fn polynomial<S, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &Factor<E, N>,
    ) -> Dense {
        let part = WITHIN_PART * course.settings.tolerance;
        let scale = &course.scaling.scale;
        let per = std::array::from_fn(|i| 1.0 / (part * (scale[i] + self.from.state[i].abs())));
        let within = &mut self.within;
        within.begin(&end(&self.from, factor), &end(&self.to, factor));
        for stand in &self.past[..self.known] {
            within.add(&end(stand, factor));
            if within.is_within(&per) {
                return Dense::ByPolynomial;
            }
        }
        Dense::BySteps
    }

    /// Deviation at a time within the step by a shorter step from its start.
    fn by_step<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &mut Factor<E, N>,
        time: f64,
    ) -> [f64; N] {
        let size = self.size;
        self.size = time - self.from.time;
        factor.prepare::<P>(self.size);
        let state = self.moved_by::<P, S, E>(course, factor);
        self.size = size;
        state
    }
}

/// Place, velocity and acceleration q″ = f − 2 B q′.
fn end<E: Entries<N>, const N: usize>(stand: &Stand<N>, factor: &Factor<E, N>) -> End<N> {
    let mut velocity = [0.0; N];
    velocity[..N / 2].copy_from_slice(&stand.state[N / 2..]);
    let mut acceleration = stand.push;
    for (acceleration, half) in acceleration.iter_mut().zip(factor.half(&velocity)) {
        *acceleration -= 2.0 * half;
    }
    End {
        time: stand.time,
        place: stand.state,
        velocity,
        acceleration,
    }
}

#[cfg(test)]
#[path = "walk_tests.rs"]
mod tests;
