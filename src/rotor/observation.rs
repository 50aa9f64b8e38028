//! What can be seen of the shaft in motion.

use super::{BallContacts, FREEDOMS, Rotation, Rotor, Sample};
use crate::bearing::Vector5;

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

    /// Of what [`Rotor::sample`] observes the balls and the bearings' axial forces alone.
    pub(crate) fn observe_contacts(&self, time: f64, state: &[f64], contacts: &mut BallContacts) {
        self.observe_bearings(&state[..self.dofs()], &self.speed.at(time), contacts);
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
        let (place, velocity) = state[..2 * dofs].split_at(dofs);
        let force = contacts.forces.then(|| {
            let mut force = self.observe_bearings(place, rotation, contacts);
            if self.contacts_damped {
                let damping = self.contact_damping(place, velocity, rotation);
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
            displacement: self.structure.shaft.displacement(place, &self.rest),
            velocity: self.structure.shaft.rate(velocity),
            acceleration: None,
            housings: self.housing_motions(place, velocity),
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
        place: &[f64],
        rotation: &Rotation,
        contacts: &mut BallContacts,
    ) -> Vector5 {
        let mut total = [0.0; FREEDOMS];
        let observed = contacts.bearings.iter_mut().zip(&mut contacts.axial_forces);
        let phases = self.phases(rotation);
        for (bearing, (loads, axial)) in self.bearings().zip(observed) {
            let (support, displacement) = (bearing.support, bearing.displacement(place));
            let rotation = self.seen_by(support, rotation, &phases);
            let force = if loads.balls() > 0 {
                support.force_and_loads(&displacement, &rotation, loads)
            } else {
                support.force(&displacement, &rotation)
            };
            for axis in 0..FREEDOMS {
                total[axis] += force[axis];
            }
            *axial = support.definition().facing.sign() * force[2];
        }
        total
    }
}
