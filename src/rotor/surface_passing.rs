//! When balls pass the kinks of defects: at times that are known where the speed is prescribed, and as event surfaces
//! where a drive decides it. An event function is the distance of a ball past the kink, m.

use super::element::{AttachedBearing, Instant, seen_by};
use super::{Rotation, Rotor};
use crate::bearing::{BearingRotation, CageJitter, Passing};
use crate::numerics::root::root;

/// Part of an angle of the shaft to which a passage is found.
const FOUND: f64 = 1e-15;

impl Rotor {
    /// The first time after `after` at which a ball passes a kink, s; infinite where none does or a drive turns the shaft.
    pub(super) fn next_passing(&self, after: f64) -> f64 {
        if self.is_driven() {
            return f64::INFINITY;
        }
        let now = self.excitation.speed.at(after).angle;
        let supports = self.elements.supports();
        let imperfect = supports.filter(|support| support.is_imperfect());
        let times = imperfect.flat_map(|support| {
            let ratio = support.cage_ratio();
            support.passings().iter().map(move |passing| {
                self.first_time(after, |later| match support.cage_jitter() {
                    None => passing.next_angle(now, ratio, later),
                    Some(jitter) => angle_with_jitter(passing, jitter, ratio, now, later),
                })
            })
        });
        times.fold(f64::INFINITY, f64::min)
    }

    /// The first time after `after` at which the shaft reaches one of the next angles, s: round-off may bring back that of
    /// `after` itself. Infinite where it reaches none.
    fn first_time(&self, after: f64, angle: impl Fn(u32) -> Option<f64>) -> f64 {
        let mut times = (0..3).map_while(|later| self.excitation.speed.time_of(angle(later)?));
        let first = times.find(|time| *time > after);
        first.unwrap_or(f64::INFINITY)
    }

    /// Kinks that are event surfaces, with their bearings.
    fn passing_events(&self) -> impl Iterator<Item = (AttachedBearing<'_>, &Passing)> {
        let driven = self.is_driven();
        let bearings = self.elements.bearings().filter(move |_| driven);
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
    pub(super) fn passing_distances(&self, at: &Instant<'_>, values: &mut [f64]) {
        for ((bearing, passing), value) in self.passing_events().zip(values) {
            let seen = seen_by(bearing.support, at.rotation, &at.phases);
            *value = passing.distance(seen.cage_angle, at.rotation.angle);
        }
    }

    /// Writes the accelerations that a ball so far past such a kink gives at most, as the rates of the velocities.
    pub(super) fn passing_jump(&self, event: usize, speed: f64, distance: f64, rate: &mut [f64]) {
        rate.fill(0.0);
        if let Some(bearing) = self.bearing_of_kink(event) {
            let load = bearing.support.load_past_kink(distance, speed);
            self.add_acceleration_by_ball(bearing, load, rate);
        }
    }

    /// The bearing of a kink that is an event surface.
    pub(super) fn bearing_of_kink(&self, event: usize) -> Option<AttachedBearing<'_>> {
        self.passing_events().nth(event).map(|(bearing, _)| bearing)
    }

    /// Rotations that the bearing sees at the start and where a ball first passes each kink, and, for waves, at some angles
    /// of the shaft in its first revolution.
    pub(super) fn imperfect_rotations(
        &self,
        bearing: &AttachedBearing<'_>,
    ) -> Vec<BearingRotation> {
        const ANGLES: usize = 24;
        let support = bearing.support;
        if !support.is_imperfect() {
            return Vec::new();
        }
        let (ratio, speed) = (support.cage_ratio(), self.speed());
        let passings = support.passings().iter();
        let kinks = passings.filter_map(|passing| passing.next_angle(0.0, ratio, 0));
        let even = (0..ANGLES).map(|part| std::f64::consts::TAU * part as f64 / ANGLES as f64);
        let seen = |angle: f64| {
            let rotation = Rotation {
                angle,
                speed,
                acceleration: 0.0,
            };
            seen_by(support, &rotation, &self.elements.phases(&rotation))
        };
        kinks.chain(even).map(seen).collect()
    }
}

/// As [`Passing::next_angle`] of a cage that wanders, which never turns backwards.
fn angle_with_jitter(
    passing: &Passing,
    jitter: &CageJitter,
    ratio: f64,
    after: f64,
    later: u32,
) -> Option<f64> {
    let rate = passing.rate(ratio);
    if rate == 0.0 {
        return None;
    }
    let place = |angle: f64| {
        let cage = ratio * angle + jitter.at(ratio * angle)[0];
        (passing.offset + passing.by_cage * cage + passing.by_shaft * angle) / passing.period
            * rate.signum()
    };
    let from = place(after);
    let target = from.floor() + 1.0 + f64::from(later);
    let step = passing.period / rate.abs();
    let mut end = after + step * (target - from);
    while place(end) < target {
        end += step;
    }
    let distance = |angle: f64| place(angle) - target;
    root(
        distance,
        [after, end],
        [from - target, distance(end)],
        FOUND * end,
    )
}
