//! Rotors that move side by side.

use fearless_simd::{Level, Simd, SimdBase, dispatch};

use super::damping::DampingMatrix;
use super::{FREEDOMS, MotionScale, Moving, Rotor};
use crate::bearing::{LANES, LaneRow, Lanes, SupportEnsemble};
use crate::integrate::{Scaling, System, VelocityDependence};
use crate::physics::sines_and_cosines;

/// As many rotors as lanes of a register, each in its own: their derivatives are found in about the time
/// of one or two.
///
/// The equations are those of a [`Rotor`] at a constant speed. Component i of a state belongs to rotor number
/// i modulo their count; displacements come first. Each rotor has its own unit of time, so that all are sampled
/// at the same times: for one whose unit is r seconds, velocities are r q̇.
#[derive(Debug, Clone)]
pub(crate) struct RotorEnsemble<'a> {
    rotors: [&'a Rotor; LANES],
    level: Level,
    kept: usize,
    /// Unit of time of every rotor, s.
    units: LaneRow,
    /// Displacements of the freedoms that are not kept.
    held: [LaneRow; FREEDOMS],
    /// r²/m and what follows from it for the tilts.
    inverse_mass: [LaneRow; FREEDOMS],
    /// ∂q″/∂q′ of every freedom by itself.
    slopes: [LaneRow; FREEDOMS],
    /// ∂θx″/∂θy′, and less ∂θy″/∂θx′.
    gyroscopic: LaneRow,
    load: [LaneRow; FREEDOMS],
    /// m e ω², N.
    inward: LaneRow,
    /// Angle of the shaft in a unit of time.
    speed: LaneRow,
    /// Angle of the cages over that of the shaft, and which bearings follow which.
    cages: Vec<LaneRow>,
    supports: Vec<(usize, SupportEnsemble)>,
    /// Whether any load varies.
    varies: bool,
}

impl<'a> RotorEnsemble<'a> {
    /// Rotors with their units of time, s; none where they cannot move side by side: at a constant speed, under
    /// loads without jumps, with equally many freedoms and diagonal damping, on equally many plain Hertz bearings
    /// of equally many balls.
    pub fn new(rotors: [&'a Rotor; LANES], units: [f64; LANES]) -> Option<Self> {
        let first = rotors[0];
        let alike = |rotor: &&Rotor| {
            rotor.kept == first.kept
                && rotor.supports.len() == first.supports.len()
                && rotor.speed.is_constant()
                && rotor.drive.is_none()
                && !rotor.contacts_damped
                && rotor.next_break_after(0.0) == f64::INFINITY
                && matches!(rotor.damping, DampingMatrix::Diagonal(_))
        };
        if !rotors.iter().all(alike) {
            return None;
        }
        let mut ensemble = Self::without_supports(rotors, units);
        for place in 0..first.supports.len() {
            let supports = rotors.map(|rotor| &rotor.supports[place]);
            let ratio = std::array::from_fn(|lane| rotors[lane].cage_ratio(supports[lane]));
            let known = ensemble.cages.iter().position(|cage| cage.0 == ratio);
            let cage = known.unwrap_or(ensemble.cages.len());
            if known.is_none() {
                ensemble.cages.push(LaneRow(ratio));
            }
            let supports = SupportEnsemble::new(supports)?;
            ensemble.supports.push((cage, supports));
        }
        Some(ensemble)
    }

    fn without_supports(rotors: [&'a Rotor; LANES], units: [f64; LANES]) -> Self {
        let row = |of: &dyn Fn(&Rotor, f64) -> f64| {
            LaneRow(std::array::from_fn(|lane| of(rotors[lane], units[lane])))
        };
        let rows = |of: &dyn Fn(&Rotor, f64, usize) -> f64| {
            std::array::from_fn(|axis| row(&|rotor, unit| of(rotor, unit, axis)))
        };
        let [first, ..] = rotors;
        Self {
            rotors,
            level: first.level,
            kept: first.kept,
            units: LaneRow(units),
            held: rows(&|rotor, _, axis| rotor.equilibrium.displacement[axis]),
            inverse_mass: rows(&|rotor, unit, axis| unit * unit * rotor.inverse_mass[axis]),
            slopes: rows(&|rotor, unit, axis| {
                -unit * rotor.damping.entry(axis, axis) * rotor.inverse_mass[axis]
            }),
            gyroscopic: row(&|rotor, unit| {
                -unit * rotor.inertia_polar * rotor.speed() * rotor.inverse_mass[3]
            }),
            load: rows(&|rotor, _, axis| rotor.load[axis]),
            inward: row(&|rotor, _| rotor.imbalance * rotor.speed() * rotor.speed()),
            speed: row(&|rotor, unit| rotor.speed() * unit),
            cages: Vec::new(),
            supports: Vec::new(),
            varies: rotors.iter().any(|rotor| !rotor.loads.is_empty()),
        }
    }

    /// A state of all rotors from one of each, in their own units of time.
    pub fn side_by_side<const N: usize, const M: usize>(
        &self,
        states: &[[f64; N]; LANES],
    ) -> [f64; M] {
        std::array::from_fn(|index| {
            let (component, lane) = (index / LANES, index % LANES);
            states[lane][component] * self.unit_of::<N>(component, lane)
        })
    }

    /// The state of one rotor, in seconds.
    #[inline]
    pub fn state_of<const N: usize, const M: usize>(
        &self,
        lane: usize,
        states: &[f64; M],
    ) -> [f64; N] {
        let mut own = [0.0; N];
        for (component, value) in own.iter_mut().enumerate() {
            *value = states[component * LANES + lane];
        }
        for velocity in &mut own[N / 2..] {
            *velocity /= self.units.0[lane];
        }
        own
    }

    /// Seconds in which a component of a rotor's state changes by what it changes by in one.
    fn unit_of<const N: usize>(&self, component: usize, lane: usize) -> f64 {
        if component < N / 2 {
            1.0
        } else {
            self.units.0[lane]
        }
    }

    /// States at the start.
    pub fn start<const N: usize, const M: usize>(&self) -> [f64; M] {
        self.side_by_side(&self.rotors.map(Moving::<N>::start))
    }

    /// Scaling under which deviations of all rotors from their equilibria are numbers of order one.
    pub fn scaling<const N: usize, const M: usize>(
        &self,
        scales: &[MotionScale; LANES],
    ) -> Scaling<M> {
        let own: [Scaling<N>; LANES] =
            std::array::from_fn(|lane| Moving::scaling(self.rotors[lane], &scales[lane]));
        let times = (0..LANES).map(|lane| own[lane].time / self.units.0[lane]);
        Scaling {
            origin: self.side_by_side(&own.map(|own| own.origin)),
            scale: self.side_by_side(&own.map(|own| own.scale)),
            time: times.fold(f64::INFINITY, f64::min),
        }
    }

    /// Loads, weight and unbalance less the forces on the bearings: the same code for all numbers of states.
    #[inline(never)]
    fn force(&self, time: f64, place: &[LaneRow; FREEDOMS], force: &mut [LaneRow; FREEDOMS]) {
        dispatch!(self.level, simd => self.force_by(simd, time, place, force));
        if self.varies {
            self.add_varying_loads(time, force);
        }
    }

    /// Without loads that vary, for the processor's level `S`.
    #[inline(always)]
    fn force_by<S: Simd>(
        &self,
        simd: S,
        time: f64,
        rows: &[LaneRow; FREEDOMS],
        sum: &mut [LaneRow; FREEDOMS],
    ) {
        let angle = time * self.speed.load(simd);
        let [sin, cos] = sines_and_cosines(angle);
        let inward = self.inward.load(simd);
        let (mut push, mut place) = ([Lanes::splat(simd, 0.0); FREEDOMS], [angle; FREEDOMS]);
        for axis in 0..FREEDOMS {
            push[axis] = self.load[axis].load(simd);
            place[axis] = rows[axis].load(simd);
        }
        push[0] += inward * cos;
        push[1] += inward * sin;
        for (number, ratio) in self.cages.iter().enumerate() {
            let [cage_sin, cage_cos] = sines_and_cosines(ratio.load(simd) * angle);
            for (_, support) in self.supports.iter().filter(|(own, _)| *own == number) {
                let force = support.forces(simd, &place, [cage_cos, cage_sin]);
                for axis in 0..FREEDOMS {
                    push[axis] -= force[axis];
                }
            }
        }
        for axis in 0..FREEDOMS {
            sum[axis] = LaneRow(*push[axis]);
        }
    }

    /// Apart from the rest, which stays small where no load varies.
    #[inline(never)]
    fn add_varying_loads(&self, time: f64, rows: &mut [LaneRow; FREEDOMS]) {
        for (lane, rotor) in self.rotors.into_iter().enumerate() {
            let time = time * self.units.0[lane];
            let mut sum = [0.0; FREEDOMS];
            for load in &rotor.loads {
                load.add(time, rotor.speed() * time, rotor.mass[0], &mut sum);
            }
            for (row, part) in rows.iter_mut().zip(sum) {
                row.0[lane] += part;
            }
        }
    }
}

impl<const M: usize> System<M> for RotorEnsemble<'_> {
    fn derivative(&self, time: f64, state: &[f64; M], rate: &mut [f64; M]) {
        let kept = const { M / (2 * LANES) };
        let velocities = &state.as_chunks::<LANES>().0[kept..];
        let mut accelerations = [0.0; M];
        self.push(time, state, &mut accelerations);
        let (rates, rest) = rate.as_chunks_mut::<LANES>().0.split_at_mut(kept);
        rates.copy_from_slice(velocities);
        rest.copy_from_slice(&accelerations.as_chunks::<LANES>().0[..kept]);
        for axis in 0..kept {
            for lane in 0..LANES {
                rest[axis][lane] += self.slopes[axis].0[lane] * velocities[axis][lane];
            }
        }
        if kept == FREEDOMS {
            for lane in 0..LANES {
                let gyroscopic = self.gyroscopic.0[lane];
                rest[3][lane] += gyroscopic * velocities[4][lane];
                rest[4][lane] -= gyroscopic * velocities[3][lane];
            }
        }
    }

    /// Inlined, so that what is read as a whole was written as a whole.
    #[inline(always)]
    fn push(&self, time: f64, place: &[f64; M], push: &mut [f64; M]) {
        let kept = const { M / (2 * LANES) };
        let mut displacement = self.held;
        for (row, place) in displacement
            .iter_mut()
            .zip(&place.as_chunks::<LANES>().0[..kept])
        {
            row.0 = *place;
        }
        let mut force = [LaneRow::default(); FREEDOMS];
        self.force(time, &displacement, &mut force);
        let rows = push.as_chunks_mut::<LANES>().0[..kept].iter_mut();
        for (axis, row) in rows.enumerate() {
            let (force, inverse_mass) = (&force[axis].0, &self.inverse_mass[axis].0);
            *row = std::array::from_fn(|lane| force[lane] * inverse_mass[lane]);
        }
    }

    fn is_second_order(&self) -> bool {
        true
    }

    fn velocity_slopes(&self) -> Result<[[f64; M]; M], VelocityDependence> {
        let mut slopes = [[0.0; M]; M];
        for lane in 0..LANES {
            for axis in 0..self.kept {
                let index = axis * LANES + lane;
                slopes[index][index] = self.slopes[axis].0[lane];
            }
            if self.kept == FREEDOMS {
                let [x, y] = [3, 4].map(|axis| axis * LANES + lane);
                slopes[x][y] = self.gyroscopic.0[lane];
                slopes[y][x] = -self.gyroscopic.0[lane];
            }
        }
        Ok(slopes)
    }
}
