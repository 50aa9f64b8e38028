//! The damping of a mounted bearing's contacts as a force on the shaft.

use fearless_simd::{Simd, dispatch};

use super::contact_damping::DampedRaces;
use super::ring::{CageAngle, Matrix5, Vector5, quarter_turn};
use super::ring_lanes::side_by_side;
use super::support::Support;
use super::{HertzLaw, Ring};

/// Rate at which the damping of a linear bearing is looked at, m/s: so slow that no contact parts.
const SLOW: f64 = 1e-12;

impl Support {
    /// Derivative of the damping force by the rate, at rest and with the cage where it starts.
    pub(super) fn damping_at(&self, imposed: &Vector5, speed: f64) -> Matrix5 {
        let mut damping = Matrix5::zeros();
        if let Some(races) = &self.damped {
            for column in 0..5 {
                let mut rate = [0.0; 5];
                rate[column] = SLOW;
                let force = self.local_damping(races, imposed, &rate, CageAngle::START, speed);
                for row in 0..5 {
                    damping[(row, column)] = force[row] / SLOW;
                }
            }
        }
        damping
    }

    /// Whether the contacts of the bearing are damped.
    pub fn is_damped(&self) -> bool {
        self.damped.is_some()
    }

    /// Force and moment that move the shaft at `velocity` against the damping of the contacts, the
    /// cage turning at `cage_speed` in rad/s.
    pub fn damping_force(
        &self,
        displacement: &Vector5,
        velocity: &Vector5,
        cage: CageAngle,
        [cage_speed, speed]: [f64; 2],
    ) -> Vector5 {
        let Some(races) = &self.damped else {
            return [0.0; 5];
        };
        let (place, rate) = (self.imposed(displacement), self.imposed(velocity));
        let force = match &self.frozen {
            Some(linear) => (linear.damping * nalgebra::SVector::from(rate)).into(),
            None => {
                // seen by one who turns with the cage
                let turn = quarter_turn(&place);
                let rate = std::array::from_fn(|axis| rate[axis] - cage_speed * turn[axis]);
                self.local_damping(races, &place, &rate, cage, speed)
            }
        };
        self.on_shaft(&force)
    }

    /// Force as by [`Support::force`] and by [`Support::damping_force`] together: in one pass over the balls
    /// where their law is the cheap one.
    pub(crate) fn damped_force(
        &self,
        displacement: &Vector5,
        velocity: &Vector5,
        cage: CageAngle,
        speeds: [f64; 2],
    ) -> Vector5 {
        match (&self.damped, &self.frozen, self.plain_ring()) {
            (Some(races), None, Some(ring)) => {
                let motion = [displacement, velocity];
                dispatch!(self.level, simd => {
                    self.damped_ring_force(simd, ring, races, motion, cage, speeds[0])
                })
            }
            _ => {
                let force = self.force(displacement, cage, speeds[1]);
                let damping = self.damping_force(displacement, velocity, cage, speeds);
                std::array::from_fn(|axis| force[axis] + damping[axis])
            }
        }
    }

    /// The same of a ring of plain Hertz contacts with its axial preset.
    #[inline(always)]
    fn damped_ring_force<S: Simd>(
        &self,
        simd: S,
        (ring, offset): (&Ring<HertzLaw>, f64),
        races: &DampedRaces,
        [displacement, velocity]: [&Vector5; 2],
        cage: CageAngle,
        cage_speed: f64,
    ) -> Vector5 {
        let [x, y, z, tilt_x, tilt_y] = self.imposed(&side_by_side(simd, displacement));
        let [x_rate, y_rate, z_rate, tilt_x_rate, tilt_y_rate] =
            self.imposed(&side_by_side(simd, velocity));
        // seen by one who turns with the cage
        let rate = [
            x_rate + cage_speed * y,
            y_rate - cage_speed * x,
            z_rate,
            tilt_x_rate + cage_speed * tilt_y,
            tilt_y_rate - cage_speed * tilt_x,
        ];
        let motion = [[x, y, z + offset, tilt_x, tilt_y], rate];
        self.on_shaft(&ring.damped_force_by(simd, &motion, cage, races))
    }

    fn local_damping(
        &self,
        races: &DampedRaces,
        imposed: &Vector5,
        rate: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> Vector5 {
        let (ring, seat) = (&self.ring, &self.seat);
        let place = seat.settle(ring, imposed, cage, speed);
        let follows = seat.follows(|| ring.force_and_stiffness(&place, cage, speed).1);
        let rate = nalgebra::SVector::from(*rate);
        let rate = follows.map_or(rate, |follows| follows * rate);
        let force = ring.damping_force(&place, &rate.into(), cage, speed, races);
        match follows {
            None => force,
            // by virtual work
            Some(follows) => (follows.transpose() * nalgebra::SVector::from(force)).into(),
        }
    }
}
