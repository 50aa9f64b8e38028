//! What can be seen of the shaft in motion.

use super::element::{Element, ElementMotion, Instant};
use super::{BodyMotion, DriveMoments, EnergyBalance, FREEDOMS, Rotor};
use crate::bearing::{BallLoads, BearingRotation, LOADED_SHARE, Support, Vector5};

impl Rotor {
    /// Room for what [`Rotor::sample`] observes of the balls.
    pub(crate) fn ball_contacts(&self) -> BallContacts {
        self.room_for(|support| support.room_for_loads(true))
    }

    /// As [`Rotor::ball_contacts`] for samples that say nothing of contact angles.
    pub(crate) fn ball_loads(&self) -> BallContacts {
        self.room_for(|support| support.room_for_loads(false))
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
            bearings: self.elements.supports().map(balls).collect(),
            axial_forces: vec![0.0; self.elements.supports().count()],
            forces_on_shaft: vec![[0.0; FREEDOMS]; self.elements.count()],
            spare: Vec::new(),
            forces: true,
        }
    }

    /// What is observed in a state at a time; of the balls in `contacts`, which must be this rotor's
    /// own [`Rotor::ball_contacts`]. Accelerations are [`Rotor::acceleration`]'s.
    pub(crate) fn sample(&self, time: f64, state: &[f64], contacts: &mut BallContacts) -> Sample {
        let dofs = self.dofs();
        let (position, velocity) = state[..2 * dofs].split_at(dofs);
        let action = self
            .is_driven()
            .then(|| self.act(time, state, &mut vec![0.0; dofs]));
        let rotation = match &action {
            Some(action) => &action.rotation,
            None => &self.excitation.speed.at(time),
        };
        let force = contacts.forces.then(|| {
            let (place, velocity) = (self.place_of_all(position), self.rate_of_all(velocity));
            let at = Instant {
                place: &place,
                velocity: &velocity,
                ..self.instant(state, rotation)
            };
            self.observe_elements(&at, contacts)
        });
        let has_balls = contacts.bearings.iter().any(|balls| balls.balls() > 0);
        Sample {
            time,
            angle: rotation.angle,
            speed: rotation.speed,
            displacement: self.displacement(state),
            velocity: self.structure.shaft.rate(&self.rate_of_all(velocity)),
            acceleration: None,
            bodies: self.body_motions(position, velocity),
            force_on_shaft: force,
            bearing_forces: Vec::new(),
            first_element: contacts.bearings.len(),
            largest_ball_load: has_balls.then_some(contacts.largest_load()),
            balls_loaded: has_balls.then_some(contacts.loaded()),
            energy: self
                .is_augmented()
                .then(|| self.energy_balance(time, state)),
            drive: action.and_then(|action| action.moments),
        }
    }

    /// Force of all elements on the shaft, N, and moment about its observed point, N m; that of each of them, axial forces
    /// and balls go to `contacts`.
    fn observe_elements(&self, at: &Instant<'_>, contacts: &mut BallContacts) -> Vector5 {
        // of the shaft onto the elements: by their displacement, and by the damping of contacts
        let [mut total, mut damped] = [[0.0; FREEDOMS]; 2];
        let mut forces = contacts.forces_on_shaft.iter_mut();
        let mut balls = contacts.bearings.iter_mut().zip(&mut contacts.axial_forces);
        self.elements.visit(at, |own, motion| {
            let [force, damping] = match &own.element {
                Element::BallBearing(support) => observe_bearing(support, motion, balls.next()),
                Element::Linear(linear) => {
                    let force = linear.force(&motion.displacement, &motion.rate);
                    [force, [0.0; FREEDOMS]]
                }
                Element::Law(law) => [law.force(motion), [0.0; FREEDOMS]],
            };
            let [force, damping] =
                [force, damping].map(|own_force| own.attachment.about_observed(&own_force));
            if own.attachment.on_shaft {
                add(&mut total, &force);
                add(&mut damped, &damping);
            }
            if let Some(on_shaft) = forces.next() {
                // 0 − 0 is 0, where −0 would be written
                *on_shaft = std::array::from_fn(|axis| 0.0 - (force[axis] + damping[axis]));
            }
        });
        add(&mut total, &damped);
        total.map(|force| -force)
    }
}

/// Force of the shaft onto a bearing and that against the damping of its contacts, in its own orientation; its loads and
/// its axial force go to `room`.
fn observe_bearing(
    support: &Support,
    motion: &ElementMotion,
    room: Option<(&mut BallLoads, &mut f64)>,
) -> [Vector5; 2] {
    let (displacement, rotation) = (&motion.displacement, &motion.rotation);
    let force = match room {
        Some((loads, axial)) => {
            let force = match loads.balls() {
                0 => support.force(displacement, rotation),
                _ => support.force_and_loads(displacement, rotation, loads),
            };
            *axial = force[2];
            force
        }
        None => support.force(displacement, rotation),
    };
    let damping = match support.is_damped() {
        true => support.damped_force(displacement, &motion.rate, rotation)[1],
        false => [0.0; FREEDOMS],
    };
    [force, damping]
}

fn add(sum: &mut Vector5, part: &Vector5) {
    for (sum, part) in sum.iter_mut().zip(part) {
        *sum += part;
    }
}

impl Rotor {
    /// What [`Rotor::sample`] observes with the force of every bearing, and the accelerations where `rate` is room for a
    /// derivative.
    pub(crate) fn whole_sample(
        &self,
        time: f64,
        state: &[f64],
        contacts: &mut BallContacts,
        rate: Option<&mut Vec<f64>>,
    ) -> Sample {
        let mut sample = self.sample(time, state, contacts);
        if contacts.forces {
            sample.bearing_forces = std::mem::take(&mut contacts.spare);
            sample.bearing_forces.clone_from(&contacts.forces_on_shaft);
        }
        if let Some(rate) = rate {
            sample.acceleration = Some(self.acceleration(time, state, rate));
            self.accelerate_bodies(rate, &mut sample.bodies);
        }
        sample
    }
}

impl Rotor {
    /// Largest approach that any ball of each bearing would have in a state, m; none of one whose balls are known.
    pub(crate) fn frozen_approaches(
        &self,
        time: f64,
        state: &[f64],
    ) -> impl Iterator<Item = Option<f64>> {
        let rotation = BearingRotation::at_start(self.rotation(time, state).speed);
        let bearings = self.elements.bearings();
        bearings.map(move |bearing| {
            let frozen = bearing.support.known_balls() == 0;
            frozen.then(|| {
                let rest = &self.start.rest;
                let displacement = bearing.attachment.displacement(&state[..self.dofs()], rest);
                bearing.support.hertz_approach(&displacement, &rotation)
            })
        })
    }
}

/// Most bearings of a shaft, and most of its elements.
pub const MOST_BEARINGS: usize = 64;

/// State of the shaft and of its bearings at one instant, SI units. What was not observed is none.
#[derive(Debug, Clone, PartialEq, Default)]
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
    /// Housings of the first bearings, then what vibrates on them; empty where no bearing has one.
    pub bodies: Vec<BodyMotion>,
    /// Force of all bearings and elements on the shaft: x, y, z in N, moments about X and Y through the point of the shaft whose
    /// displacement is given in N m; none where it is not observed.
    pub force_on_shaft: Option<[f64; FREEDOMS]>,
    /// The share of every bearing in it, in the order of the scene, and behind them the forces of the elements; empty where
    /// it is not observed.
    pub bearing_forces: Vec<[f64; FREEDOMS]>,
    /// Place of the first element among them.
    pub first_element: usize,
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

impl Sample {
    /// This sample without the forces of single bearings.
    pub(crate) fn without_bearings(&self) -> Self {
        Self {
            bodies: self.bodies.clone(),
            bearing_forces: Vec::new(),
            ..*self
        }
    }
}

/// Loads and contact angles of every ball of every bearing at one instant, and the force of each bearing; filled anew at
/// every sample, without allocation.
#[derive(Debug, Clone, PartialEq)]
pub struct BallContacts {
    bearings: Vec<BallLoads>,
    /// By bearing, in its own orientation, N.
    axial_forces: Vec<f64>,
    /// Of every bearing, in the order of the scene, N and N m; moments about the observed point.
    forces_on_shaft: Vec<Vector5>,
    /// Room for them in a sample.
    spare: Vec<Vector5>,
    /// Whether the forces of the bearings are observed.
    forces: bool,
}

impl BallContacts {
    /// Takes back what a sample had room in that nobody needs any more.
    pub(crate) fn reuse(&mut self, sample: Sample) {
        self.spare = sample.bearing_forces;
    }

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
