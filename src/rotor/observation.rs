//! What can be seen of the shaft in motion.

use super::point::about_origin;
use super::{DriveMoments, EnergyBalance, FREEDOMS, Rotation, Rotor};
use crate::bearing::{BallLoads, LOADED_SHARE, Support, Vector5};

impl Rotor {
    /// Room for what [`Rotor::sample`] observes of the balls.
    pub(crate) fn ball_contacts(&self) -> BallContacts {
        BallContacts::new(&self.supports, true)
    }

    /// As [`Rotor::ball_contacts`] for samples that say nothing of contact angles.
    pub(crate) fn ball_loads(&self) -> BallContacts {
        BallContacts::new(&self.supports, false)
    }

    /// As [`Rotor::ball_contacts`] for samples that say nothing of the balls, and of the forces of the bearings
    /// only where asked for.
    pub(crate) fn unwatched_balls(&self, forces: bool) -> BallContacts {
        BallContacts::unwatched(&self.supports, forces)
    }

    /// What is observed in a state at a time; of the balls in `contacts`, which must be this rotor's
    /// own [`Rotor::ball_contacts`]. Accelerations are [`Rotor::acceleration`]'s.
    pub(crate) fn sample(&self, time: f64, state: &[f64], contacts: &mut BallContacts) -> Sample {
        if !self.is_augmented() {
            return self.observe(time, &self.speed.at(time), state, contacts);
        }
        let mut accelerations = vec![0.0; self.dofs()];
        let action = self
            .drive
            .map(|_| self.act(time, state, &mut accelerations));
        let rotation = match &action {
            Some(action) => action.rotation,
            None => self.rotation(time, state),
        };
        Sample {
            energy: Some(self.energy_balance(time, state)),
            drive: action.and_then(|action| action.moments),
            ..self.observe(time, &rotation, state, contacts)
        }
    }

    /// What is observed of the motion in a state.
    pub(super) fn observe(
        &self,
        time: f64,
        rotation: &Rotation,
        state: &[f64],
        contacts: &mut BallContacts,
    ) -> Sample {
        let dofs = self.dofs();
        let (position, velocity) = state[..2 * dofs].split_at(dofs);
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
        contacts.sum_up();
        let has_balls = contacts.has_balls();
        Sample {
            time,
            angle: rotation.angle,
            speed: rotation.speed,
            displacement: self.displacement(state),
            velocity: self.structure.shaft.rate(velocity),
            acceleration: None,
            housings: self.housing_motions(position, velocity),
            force_on_shaft: force,
            largest_ball_load: has_balls.then_some(contacts.largest_load()),
            balls_loaded: has_balls.then_some(contacts.loaded()),
            energy: None,
            drive: None,
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
    pub(super) bearings: Vec<BallLoads>,
    /// By bearing, in its own orientation, N.
    pub(super) axial_forces: Vec<f64>,
    /// Whether the forces of the bearings are observed.
    pub(super) forces: bool,
    largest: f64,
    least: f64,
    loaded: u32,
}

impl BallContacts {
    /// Room for the balls of some bearings, and for their angles; a linear bearing has none.
    pub(super) fn new(supports: &[Support], angles: bool) -> Self {
        let loads = |support: &Support| BallLoads::new(support.known_balls(), angles);
        Self {
            bearings: supports.iter().map(loads).collect(),
            axial_forces: vec![0.0; supports.len()],
            forces: true,
            largest: 0.0,
            least: 0.0,
            loaded: 0,
        }
    }

    /// Room for none of the balls: they are not observed, and the forces of the bearings only where asked for.
    pub(super) fn unwatched(supports: &[Support], forces: bool) -> Self {
        Self {
            bearings: vec![BallLoads::default(); supports.len()],
            forces,
            ..Self::new(supports, false)
        }
    }

    /// The balls of each bearing; none of a linear one.
    pub fn bearings(&self) -> &[BallLoads] {
        &self.bearings
    }

    /// Whether any ball is observed.
    pub(super) fn has_balls(&self) -> bool {
        self.bearings.iter().any(|bearing| bearing.balls() > 0)
    }

    /// Axial force that the inner ring presses onto each bearing, positive the way its facing loads
    /// it, N.
    pub fn axial_forces(&self) -> &[f64] {
        &self.axial_forces
    }

    /// Largest load at either race, N; zero without balls.
    pub fn largest_load(&self) -> f64 {
        self.largest
    }

    /// Load at the inner race above which a ball counts as loaded, N: a millionth of the largest
    /// there, of all bearings, for behind an oil film no load is quite zero.
    pub fn least_load(&self) -> f64 {
        self.least
    }

    /// Number of loaded balls of all bearings.
    pub fn loaded(&self) -> u32 {
        self.loaded
    }

    /// Takes stock of the balls, once they are those of another sample.
    pub(super) fn sum_up(&mut self) {
        let mut largest = [0.0_f64; 2];
        for bearing in &self.bearings {
            for (largest, of_bearing) in largest.iter_mut().zip(bearing.largest) {
                *largest = largest.max(of_bearing);
            }
        }
        self.largest = largest[0].max(largest[1]);
        self.least = LOADED_SHARE * largest[0];
        self.loaded = 0;
        for bearing in &self.bearings {
            let loaded = bearing.load[0]
                .iter()
                .map(|load| u32::from(*load > self.least));
            self.loaded += loaded.sum::<u32>();
        }
    }
}
