//! When balls pass the kinks of defects: at times that are known where the speed is prescribed, and as event surfaces
//! where a drive decides it. An event function is the distance of a ball past the kink, m.

use super::motion::AttachedBearing;
use super::{Rotation, Rotor};
use crate::bearing::{BearingRotation, Passing};

impl Rotor {
    /// The first time after `after` at which a ball passes a kink, s; infinite where none does or a drive turns the shaft.
    pub(super) fn next_passing(&self, after: f64) -> f64 {
        if self.drive.is_some() {
            return f64::INFINITY;
        }
        let angle = self.speed.at(after).angle;
        let mut next = f64::INFINITY;
        for support in self
            .supports
            .iter()
            .filter(|support| support.is_imperfect())
        {
            let ratio = self.cage_ratio(support);
            for passing in support.passings() {
                // round-off of angles may bring back the passage that has just been
                let times = (0..3).map_while(|later| {
                    let angle = passing.next_angle(angle, ratio, later)?;
                    self.speed.time_of(angle)
                });
                let first = times.into_iter().find(|time| *time > after);
                next = next.min(first.unwrap_or(f64::INFINITY));
            }
        }
        next
    }

    /// Kinks that are event surfaces, with their bearings.
    fn passing_events(&self) -> impl Iterator<Item = (AttachedBearing<'_>, &Passing)> {
        let driven = self.drive.is_some();
        let bearings = self.bearings().filter(move |_| driven);
        bearings.flat_map(|bearing| {
            let passings = bearing.support.passings().iter();
            passings.map(move |passing| (bearing, passing))
        })
    }

    /// Number of kinks that are event surfaces.
    pub(super) fn passing_event_count(&self) -> usize {
        self.passing_events().count()
    }

    /// Writes how far balls are past them, m.
    pub(super) fn passing_distances(&self, rotation: &Rotation, values: &mut [f64]) {
        for ((bearing, passing), value) in self.passing_events().zip(values) {
            let cage = self.cage_ratio(bearing.support) * rotation.angle;
            *value = passing.distance(cage, rotation.angle);
        }
    }

    /// Writes the accelerations that a ball so far past such a kink gives at most, as the rates of the velocities.
    pub(super) fn passing_jump(&self, event: usize, speed: f64, distance: f64, rate: &mut [f64]) {
        rate.fill(0.0);
        if let Some((bearing, _)) = self.passing_events().nth(event) {
            let load = bearing.support.load_past_kink(distance, speed);
            self.add_acceleration_by_ball(bearing, load, rate);
        }
    }

    /// Rotations that the bearing sees at the start and where a ball first passes each kink, and, for waves, at some angles
    /// of the shaft in its first revolution.
    pub(super) fn imperfect_rotations(&self, bearing: AttachedBearing<'_>) -> Vec<BearingRotation> {
        const ANGLES: usize = 24;
        let support = bearing.support;
        if !support.is_imperfect() {
            return Vec::new();
        }
        let (ratio, speed) = (self.cage_ratio(support), self.speed());
        let passings = support.passings().iter();
        let kinks = passings.filter_map(|passing| passing.next_angle(0.0, ratio, 0));
        let even = (0..ANGLES).map(|part| std::f64::consts::TAU * part as f64 / ANGLES as f64);
        let rotation = |angle| Rotation {
            angle,
            speed,
            acceleration: 0.0,
        };
        kinks
            .chain(even)
            .map(|angle| {
                let rotation = rotation(angle);
                self.seen_by(support, &rotation, &self.phases(&rotation))
            })
            .collect()
    }
}
