//! What drives the shaft from outside: its rotation, unbalances, weight and loads.

use nalgebra::{Complex, DVector};

use super::dot;
use super::phases::Phases;
use super::point::{Place, Point};
use super::structure::UnbalancedPoint;
use super::{Drive, Load, Rotation, SpeedProfile};
use crate::bearing::{Angle, Vector5};

/// Time over which the change of a force, or of the right-hand side, is looked at, s.
pub(super) const TIME_STEP: f64 = 1e-8;

/// What drives the shaft from outside.
#[derive(Debug, Clone)]
pub(super) struct Excitation {
    pub speed: SpeedProfile,
    /// Decides the speed in place of the profile, which then holds that of the start.
    pub drive: Option<Drive>,
    /// Moment of inertia that a drive turns, kg m².
    pub inertia_polar: f64,
    pub unbalances: Vec<UnbalancedPoint>,
    /// Varying loads.
    pub loads: Vec<Load>,
    /// Where each of them acts.
    pub load_places: Vec<Place>,
    /// Constant loads and the weight on the degrees of freedom.
    pub constant_force: Vec<f64>,
    /// Acceleration of gravity along −Y, m/s²; zero where no weight acts.
    pub gravity: f64,
    /// M t of a unit translation t of all masses along x, y and z, kg: times an acceleration of the base, its inertial force
    /// against it.
    pub base_inertia: [Vec<f64>; 3],
}

impl Excitation {
    /// Adds what varies of it, unbalances and loads, to the forces on the degrees of freedom.
    #[inline(always)]
    pub fn add_varying_forces<const RIGID: bool>(
        &self,
        time: f64,
        rotation: &Rotation,
        phases: &Phases,
        sum: &mut [f64],
    ) {
        for UnbalancedPoint { point, unbalance } in &self.unbalances {
            let point = if RIGID { &Point::RIGID_SHAFT } else { point };
            point.add_force(1.0, &unbalance.force(rotation, phases.shaft), sum);
        }
        if !self.loads.is_empty() {
            self.add_loads(time, rotation.angle, sum);
        }
    }

    /// Adds the forces of the varying loads; apart from the rest, which stays small where no load varies.
    #[inline(never)]
    fn add_loads(&self, time: f64, angle: f64, sum: &mut [f64]) {
        for (load, place) in self.placed_loads() {
            self.add_load(load, place, &load.kind.at(time, angle), sum);
        }
    }

    /// The varying loads and their places.
    fn placed_loads(&self) -> impl Iterator<Item = (&Load, &Place)> {
        self.loads.iter().zip(&self.load_places)
    }

    /// Adds a value of a load, an amplitude or a rate of it.
    fn add_load(&self, load: &Load, place: &Place, value: &Vector5, sum: &mut [f64]) {
        if !load.acts_on_mass() {
            return place.add_force(1.0, value, sum);
        }
        // the inertial forces of all masses where the base accelerates
        for (inertia, acceleration) in self.base_inertia.iter().zip(value) {
            for (sum, inertia) in sum.iter_mut().zip(inertia) {
                *sum -= inertia * acceleration;
            }
        }
    }

    /// Adds the time derivative of these forces: of unbalances exactly, of varying loads by a difference over a time that
    /// is short against all that they do.
    pub fn add_force_rates(&self, time: f64, rotation: &Rotation, sum: &mut [f64]) {
        for UnbalancedPoint { point, unbalance } in &self.unbalances {
            point.add_force(1.0, &unbalance.force_rate(rotation), sum);
        }
        for (load, place) in self.placed_loads() {
            let later = |step: f64| {
                let time = time + step;
                load.kind.at(time, self.speed.at(time).angle)
            };
            self.add_load(load, place, &forward_rate(later), sum);
        }
    }

    /// Power of the varying loads at velocities of the degrees of freedom, W.
    pub fn power_of_loads(&self, time: f64, angle: f64, velocity: &[f64]) -> f64 {
        let power = |(load, place): (&Load, &Place)| -> f64 {
            let value = load.kind.at(time, angle);
            if load.acts_on_mass() {
                let axes = self.base_inertia.iter().zip(value);
                return -axes
                    .map(|(inertia, part)| part * dot(inertia, velocity))
                    .sum::<f64>();
            }
            dot(&value, &place.displacement(velocity, &[]))
        };
        self.placed_loads().map(power).sum()
    }

    /// Power of the unbalances at velocities of the degrees of freedom, W.
    pub fn power_of_unbalances(&self, rotation: &Rotation, shaft: Angle, velocity: &[f64]) -> f64 {
        let power = |own: &UnbalancedPoint| {
            let force = own.unbalance.force(rotation, shaft);
            dot(&force, &own.point.rate(velocity))
        };
        self.unbalances.iter().map(power).sum()
    }

    /// Forces of the unbalances on `dofs` degrees of freedom per angular acceleration at an angle of the shaft, kg m and
    /// kg m².
    pub fn unbalances_along(&self, angle: f64, dofs: usize) -> Vec<f64> {
        let mut sum = vec![0.0; dofs];
        for UnbalancedPoint { point, unbalance } in &self.unbalances {
            point.add_force(1.0, &unbalance.along(Angle::new(angle)), &mut sum);
        }
        sum
    }

    /// Moment on the rotation of base motion and weight through the unbalances, N m.
    pub fn moment_of_base(&self, time: f64, angle: f64) -> f64 {
        let [a_x, a_y, _] = self.base_acceleration(time, angle);
        let moment = |own: &UnbalancedPoint| {
            let [x, y, ..] = own.unbalance.along(Angle::new(angle));
            x * a_x + y * (a_y + self.gravity)
        };
        self.unbalances.iter().map(moment).sum()
    }

    /// Acceleration of the base, m/s².
    fn base_acceleration(&self, time: f64, angle: f64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for load in self.loads.iter().filter(|load| load.acts_on_mass()) {
            for (sum, part) in sum.iter_mut().zip(load.kind.at(time, angle)) {
                *sum += part;
            }
        }
        sum
    }

    /// Forces of the unbalances on `dofs` degrees of freedom at a speed as complex amplitudes.
    pub fn unbalance_phasor(&self, speed: f64, dofs: usize) -> DVector<Complex<f64>> {
        let mut sum = DVector::zeros(dofs);
        for UnbalancedPoint { point, unbalance } in &self.unbalances {
            point.add_phasor(&unbalance.phasor(speed), sum.as_mut_slice());
        }
        sum
    }

    /// Angular frequency of each varying load at a speed of the shaft, and its forces on `dofs` degrees of freedom.
    pub fn load_vibrations(&self, speed: f64, dofs: usize) -> Vec<(f64, DVector<Complex<f64>>)> {
        let vibration = |(load, place): (&Load, &Place)| {
            let vibration = load.kind.main_vibration();
            let mut force = DVector::zeros(dofs);
            self.add_load(load, place, &vibration.amplitude, force.as_mut_slice());
            (vibration.frequency_at(speed), force.map(Complex::from))
        };
        self.placed_loads().map(vibration).collect()
    }

    /// Harmonics at a constant speed of the shaft: angular frequencies in rad/s, and forces on `dofs` degrees of freedom as
    /// complex amplitudes; none where a load is not made of them.
    pub fn harmonics(&self, speed: f64, dofs: usize) -> Option<Vec<(f64, DVector<Complex<f64>>)>> {
        let mut all = vec![(speed, self.unbalance_phasor(speed, dofs))];
        for (load, place) in self.placed_loads() {
            for (omega, amplitude) in load.kind.harmonics(speed)? {
                let [mut real, mut imaginary] = [(); 2].map(|()| vec![0.0; dofs]);
                self.add_load(load, place, &amplitude.map(|part| part.re), &mut real);
                self.add_load(load, place, &amplitude.map(|part| part.im), &mut imaginary);
                let parts = real.iter().zip(&imaginary);
                let force = parts.map(|(re, im)| Complex::new(*re, *im));
                all.push((omega, DVector::from_iterator(dofs, force)));
            }
        }
        Some(all)
    }

    /// Whether any unbalance turns with the shaft.
    pub fn is_unbalanced(&self) -> bool {
        self.unbalances.iter().any(|own| own.unbalance.is_some())
    }

    /// Highest speed that the shaft is meant for, [`super::RotorDefinition::highest_speed`], rad/s.
    pub fn highest_speed(&self) -> f64 {
        let idle = self.drive.and_then(|drive| drive.no_load_speed);
        self.speed.highest().max(idle.unwrap_or(0.0))
    }

    /// The first time after `after` at which a load or the acceleration jumps, s.
    pub fn next_break(&self, after: f64) -> f64 {
        let breaks = self.loads.iter().map(|load| load.kind.next_break(after));
        breaks.fold(self.speed.next_break(after), f64::min)
    }
}

/// Rate of change of a force that is given at times after an instant, by a difference forward, so that it does not reach
/// back over a break that the present step begins at.
pub(super) fn forward_rate(force: impl Fn(f64) -> Vector5) -> Vector5 {
    let step = TIME_STEP;
    let (now, half, full) = (force(0.0), force(0.5 * step), force(step));
    std::array::from_fn(|axis| (4.0 * half[axis] - 3.0 * now[axis] - full[axis]) / step)
}
