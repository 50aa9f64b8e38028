//! What can be seen of the shaft in motion.

use super::{BallContacts, FREEDOMS, Rotation, Rotor, Sample};
use crate::bearing::Vector5;

impl Rotor {
    /// Room for what [`Rotor::sample`] observes of the balls.
    pub fn ball_contacts(&self) -> BallContacts {
        BallContacts::new(&self.supports)
    }

    /// As [`Rotor::ball_contacts`] for samples that say nothing of contact angles.
    pub fn ball_loads(&self) -> BallContacts {
        BallContacts::loads(&self.supports)
    }

    /// As [`Rotor::ball_contacts`] for samples that say nothing of the balls, and of the forces of the bearings
    /// only where asked for: what they leave out is zero there.
    pub fn unwatched_balls(&self, forces: bool) -> BallContacts {
        BallContacts::unwatched(&self.supports, forces)
    }

    /// What is observed in a state at a time; of the balls in `contacts`, which must be this rotor's
    /// own [`Rotor::ball_contacts`].
    pub fn sample(&self, time: f64, state: &[f64], contacts: &mut BallContacts) -> Sample {
        let displacement = self.full(&self.equilibrium.displacement, &state[..self.kept]);
        let velocity = self.full(&[0.0; FREEDOMS], &state[self.kept..]);
        self.observe(
            time,
            &self.speed.at(time),
            [displacement, velocity],
            contacts,
        )
    }

    /// Displacement of the shaft in a state.
    pub(crate) fn displacement(&self, state: &[f64]) -> Vector5 {
        self.full(&self.equilibrium.displacement, &state[..self.kept])
    }

    /// What is observed of a motion, displacement first.
    pub(super) fn observe(
        &self,
        time: f64,
        rotation: &Rotation,
        [displacement, velocity]: [Vector5; 2],
        contacts: &mut BallContacts,
    ) -> Sample {
        let mut force = if contacts.forces {
            self.observe_bearings(&displacement, rotation, contacts)
        } else {
            [0.0; FREEDOMS]
        };
        if contacts.forces && self.contacts_damped {
            let damping = self.contact_damping(&displacement, &velocity, rotation);
            for axis in 0..FREEDOMS {
                force[axis] += damping[axis];
            }
        }
        contacts.sum_up();
        Sample {
            time,
            angle: rotation.angle,
            speed: rotation.speed,
            displacement,
            velocity,
            force_on_shaft: force.map(|force| -force),
            largest_ball_load: contacts.largest_load(),
            balls_loaded: contacts.loaded(),
            energy: None,
            drive: None,
        }
    }

    /// Force of the shaft onto all bearings, N and N m; axial forces and balls go to `contacts`.
    fn observe_bearings(
        &self,
        displacement: &Vector5,
        rotation: &Rotation,
        contacts: &mut BallContacts,
    ) -> Vector5 {
        let mut total = [0.0; FREEDOMS];
        let angles = contacts.angles;
        let mut balls = contacts.balls.as_mut_slice();
        let mut axial_forces = contacts.axial_forces.iter_mut();
        self.for_each_support(rotation.angle, &self.phases(rotation), |support, cage| {
            let own = balls.len().min(support.known_balls());
            let force = match own {
                0 => support.force(displacement, cage, rotation.speed),
                _ => {
                    let (own, others) = std::mem::take(&mut balls).split_at_mut(own);
                    balls = others;
                    support.force_and_balls(displacement, cage, rotation.speed, angles, own)
                }
            };
            for axis in 0..FREEDOMS {
                total[axis] += force[axis];
            }
            if let Some(axial) = axial_forces.next() {
                *axial = support.definition().facing.sign() * force[2];
            }
        });
        total
    }
}
