//! What can be seen of the shaft in motion.

use super::point::about_origin;
use super::{DriveMoments, EnergyBalance, FREEDOMS, Rotation, Rotor};
use crate::bearing::{BallLoads, LOADED_SHARE, Support, Vector5};

impl Rotor {
    /// Room for what [`Rotor::sample`] observes of the balls.
    pub(crate) fn ball_contacts(&self) -> BallContacts {
        self.room_for(|support| BallLoads::new(support.known_balls(), true))
    }

    /// As [`Rotor::ball_contacts`] for samples that say nothing of contact angles.
    pub(crate) fn ball_loads(&self) -> BallContacts {
        self.room_for(|support| BallLoads::new(support.known_balls(), false))
    }

    /// As [`Rotor::ball_contacts`] for samples that say nothing of the balls, and of the forces of the bearings
    /// only where asked for.
    pub(crate) fn unwatched_balls(&self, forces: bool) -> BallContacts {
        let unwatched = self.room_for(|_| BallLoads::default());
        BallContacts {
            forces,
            ..unwatched
        }
    }

    /// Room for some balls of each bearing, and for its forces.
    fn room_for(&self, balls: impl Fn(&Support) -> BallLoads) -> BallContacts {
        BallContacts {
            bearings: self.supports.iter().map(balls).collect(),
            axial_forces: vec![0.0; self.supports.len()],
            forces: true,
        }
    }

    /// What is observed in a state at a time; of the balls in `contacts`, which must be this rotor's
    /// own [`Rotor::ball_contacts`]. Accelerations are [`Rotor::acceleration`]'s.
    pub(crate) fn sample(&self, time: f64, state: &[f64], contacts: &mut BallContacts) -> Sample {
        let dofs = self.dofs();
        let (position, velocity) = state[..2 * dofs].split_at(dofs);
        let action = self
            .drive
            .map(|_| self.act(time, state, &mut vec![0.0; dofs]));
        let rotation = match &action {
            Some(action) => &action.rotation,
            None => &self.speed.at(time),
        };
        let force = contacts.forces.then(|| {
            let mut force = self.observe_bearings(position, rotation, contacts);
            if self.contacts_damped {
                let damping = self.contact_damping(position, velocity, rotation);
                for axis in 0..FREEDOMS {
                    force[axis] += damping[axis];
                }
            }
            force.map(|force| -force)
        });
        let has_balls = contacts.bearings.iter().any(|balls| balls.balls() > 0);
        Sample {
            time,
            angle: rotation.angle,
            speed: rotation.speed,
            displacement: self.displacement(state),
            velocity: self.structure.shaft.rate(&self.rate_of_all(velocity)),
            acceleration: None,
            housings: self.housing_motions(position, velocity),
            force_on_shaft: force,
            largest_ball_load: has_balls.then_some(contacts.largest_load()),
            balls_loaded: has_balls.then_some(contacts.loaded()),
            energy: self
                .is_augmented()
                .then(|| self.energy_balance(time, state)),
            drive: action.and_then(|action| action.moments),
        }
    }

    /// Force of the shaft onto all bearings, N and N m; axial forces and balls go to `contacts`.
    fn observe_bearings(
        &self,
        position: &[f64],
        rotation: &Rotation,
        contacts: &mut BallContacts,
    ) -> Vector5 {
        let mut total = [0.0; FREEDOMS];
        let observed = contacts.bearings.iter_mut().zip(&mut contacts.axial_forces);
        let phases = self.phases(rotation);
        let bearings = self.bearings().zip(&self.structure.arms);
        for ((bearing, arm), (loads, axial)) in bearings.zip(observed) {
            let (support, displacement) = (bearing.support, bearing.displacement(position));
            let rotation = self.seen_by(support, rotation, &phases);
            let force = if loads.balls() > 0 {
                support.force_and_loads(&displacement, &rotation, loads)
            } else {
                support.force(&displacement, &rotation)
            };
            let about = about_origin(&force, *arm);
            for axis in 0..FREEDOMS {
                total[axis] += about[axis];
            }
            *axial = support.definition().facing.sign() * force[2];
        }
        total
    }
}

impl Rotor {
    /// Indices of the degrees of freedom of the housings.
    pub(crate) fn housing_freedoms(&self) -> std::ops::Range<usize> {
        let housings = self.structure.housings.iter();
        let firsts = housings.map(|housing| housing.point.coordinates[0]);
        firsts.min().unwrap_or(self.dofs())..self.dofs()
    }

    /// Motion of the housings of the first bearings; none without any.
    pub(super) fn housing_motions(
        &self,
        place: &[f64],
        velocity: &[f64],
    ) -> Option<[HousingMotion; MOST_HOUSINGS]> {
        let mut motions = [HousingMotion::default(); MOST_HOUSINGS];
        for housing in &self.structure.housings {
            if let Some(motion) = motions.get_mut(housing.bearing) {
                let [x, y, z, ..] = housing.point.displacement(place, &[]);
                motion.displacement = [x, y, z];
                let [x, y, z, ..] = housing.point.rate(velocity);
                motion.velocity = [x, y, z];
            }
        }
        (!self.structure.housings.is_empty()).then_some(motions)
    }

    /// Writes the accelerations of the housings, taken from the derivative of a state.
    pub(crate) fn accelerate_housings(
        &self,
        rate: &[f64],
        motions: &mut Option<[HousingMotion; MOST_HOUSINGS]>,
    ) {
        let (Some(motions), dofs) = (motions, self.dofs()) else {
            return;
        };
        for housing in &self.structure.housings {
            if let Some(motion) = motions.get_mut(housing.bearing) {
                let [x, y, z, ..] = housing.point.rate(&rate[dofs..2 * dofs]);
                motion.acceleration = Some([x, y, z]);
            }
        }
    }
}

/// Housings are observed of so many bearings, the first ones.
pub const MOST_HOUSINGS: usize = 4;

/// Motion of a housing at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct HousingMotion {
    /// x, y, z from where its own weight has put it, m.
    pub displacement: [f64; 3],
    /// m/s.
    pub velocity: [f64; 3],
    /// m/s², where asked for.
    pub acceleration: Option<[f64; 3]>,
}

/// State of the shaft and of its bearings at one instant, SI units. What was not observed is none.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sample {
    /// Time, s.
    pub time: f64,
    /// Shaft angle ψ, rad.
    pub angle: f64,
    /// Angular speed, rad/s.
    pub speed: f64,
    /// x, y, z in m and θx, θy in rad.
    pub displacement: [f64; FREEDOMS],
    /// Time derivatives of `displacement`.
    pub velocity: [f64; FREEDOMS],
    /// Second time derivatives of `displacement`, where asked for.
    pub acceleration: Option<[f64; FREEDOMS]>,
    /// Housings of the first bearings; none where no bearing has one.
    pub housings: Option<[HousingMotion; MOST_HOUSINGS]>,
    /// Force of all bearings on the shaft: x, y, z in N, moments about X and Y in N m; none where it is not
    /// observed.
    pub force_on_shaft: Option<[f64; FREEDOMS]>,
    /// Largest load on a ball of any bearing, N; none where no ball is observed, as of a linear bearing.
    pub largest_ball_load: Option<f64>,
    /// Number of balls in contact, all bearings together; likewise.
    pub balls_loaded: Option<u32>,
    /// Energy, where it is integrated.
    #[doc(hidden)]
    pub energy: Option<EnergyBalance>,
    /// Moments on the shaft, where it is driven.
    #[doc(hidden)]
    pub drive: Option<DriveMoments>,
}

/// Loads and contact angles of every ball of every bearing at one instant, and what each bearing
/// bears axially; filled anew at every sample, without allocation.
#[derive(Debug, Clone, PartialEq)]
pub struct BallContacts {
    bearings: Vec<BallLoads>,
    /// By bearing, in its own orientation, N.
    axial_forces: Vec<f64>,
    /// Whether the forces of the bearings are observed.
    forces: bool,
}

impl BallContacts {
    /// The balls of each bearing; none of a linear one.
    pub fn bearings(&self) -> &[BallLoads] {
        &self.bearings
    }

    /// Axial force that the inner ring presses onto each bearing, positive the way its facing loads
    /// it, N.
    pub fn axial_forces(&self) -> &[f64] {
        &self.axial_forces
    }

    /// Largest loads at the inner and the outer race, N; zero without balls.
    fn largest_loads(&self) -> [f64; 2] {
        [0, 1].map(|race| {
            let largest = self.bearings.iter().map(|balls| balls.largest[race]);
            largest.fold(0.0, f64::max)
        })
    }

    /// Largest load at either race, N; zero without balls.
    pub fn largest_load(&self) -> f64 {
        let [inner, outer] = self.largest_loads();
        inner.max(outer)
    }

    /// Load at the inner race above which a ball counts as loaded, N: a millionth of the largest
    /// there, of all bearings, for behind an oil film no load is quite zero.
    pub fn least_load(&self) -> f64 {
        LOADED_SHARE * self.largest_loads()[0]
    }

    /// Number of loaded balls of all bearings.
    pub fn loaded(&self) -> u32 {
        let least = self.least_load();
        let loads = self.bearings.iter().flat_map(|balls| &balls.load[0]);
        loads.map(|load| u32::from(*load > least)).sum()
    }
}
