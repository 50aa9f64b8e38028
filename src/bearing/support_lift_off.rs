//! Where the balls of a mounted bearing stand about their lift-off.

use std::f64::consts::TAU;

use super::ring::{CageAngle, Vector5};
use super::ring_lift_off::LiftOffs;
use super::seat::Seat;
use super::support::Support;

/// Slope of the distance to lift-off by the place of the inner groove centre: one, but for what the
/// inertia of the ball and the table of a law add.
const LIFT_OFF_SLOPE: f64 = 1.1;
/// Positions of the cage within one ball spacing at which balls are looked at.
const CAGE_POSITIONS: u32 = 8;

impl Support {
    /// Number of balls whose force is not smooth where they lift off: none of a linear bearing, and
    /// none behind films.
    pub(crate) fn balls_that_lift_off(&self) -> u32 {
        match self.frozen {
            None if self.ring.lifts_off() => self.definition.bearing.geometry.balls() as u32,
            _ => 0,
        }
    }

    /// These balls about their lift-off.
    pub(crate) fn lift_offs(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> LiftOffs {
        if self.balls_that_lift_off() == 0 {
            return LiftOffs::NONE;
        }
        let place = self.ring_displacement(displacement, cage, speed);
        match &self.table {
            Some(table) => table.lift_offs(&place, cage, speed),
            None => self.ring.lift_offs(&place, cage, speed),
        }
    }

    /// Whether any ball comes to its lift-off as the shaft swings by the distance of two displacements about the first
    /// of them, at a speed in rad/s: at the start's position of the cage, or, where the cage turns, at any.
    ///
    /// A bound for a bearing that is held; one on a spring is taken to follow the shaft along its axis.
    pub(crate) fn may_part(
        &self,
        [place, reached]: [&Vector5; 2],
        speed: f64,
        cage_turns: bool,
    ) -> bool {
        if self.balls_that_lift_off() == 0 {
            return false;
        }
        let [mut from, mut to] = [place, reached].map(|displacement| self.imposed(displacement));
        if matches!(self.seat, Seat::Spring { .. }) {
            (from[2], to[2]) = (0.0, 0.0);
        }
        let swing = LIFT_OFF_SLOPE * self.shift_of_centres(&from, &to, 0.0);
        let positions = if cage_turns { CAGE_POSITIONS } else { 1 };
        let spacing = TAU / self.definition.bearing.geometry.balls() as f64;
        (0..positions).any(|position| {
            let part = f64::from(position) / f64::from(CAGE_POSITIONS);
            let seen = self.lift_offs(place, CageAngle::new(part * spacing), speed);
            seen.nearest <= swing
        })
    }

    /// No ball comes nearer to its lift-off by more than this as the shaft goes from one displacement
    /// to another and the cage turns by an angle in rad; infinite of a ring that floats.
    pub(crate) fn approach_to_lift_off(&self, ends: [&Vector5; 2], turn: f64) -> f64 {
        if matches!(self.seat, Seat::Spring { .. }) {
            return f64::INFINITY;
        }
        let [from, to] = ends.map(|displacement| self.imposed(displacement));
        LIFT_OFF_SLOPE * self.shift_of_centres(&from, &to, turn.abs())
    }

    /// Distance that every ball has from its lift-off, wherever the cage stands, m; not positive where that is not
    /// known.
    pub(crate) fn clearance(&self, displacement: &Vector5) -> f64 {
        if self.balls_that_lift_off() == 0 {
            return f64::INFINITY;
        }
        let Seat::Fixed { offset } = self.seat else {
            return 0.0;
        };
        let [x, y, z, tilt_x, tilt_y] = self.imposed(displacement);
        let place = [x, y, z + offset, tilt_x, tilt_y];
        match self.ring.least_approach(&place) {
            Some(least) if self.table.is_none() => least,
            _ => 0.0,
        }
    }

    /// How far inner groove centres move at most, m, as the ring goes from one place to another and the cage turns by
    /// an angle in rad, not negative.
    fn shift_of_centres(&self, from: &Vector5, to: &Vector5, turn: f64) -> f64 {
        let [x, y, z, tilt_x, tilt_y] = std::array::from_fn(|axis| to[axis] - from[axis]);
        // plain roots: this is asked for at every step
        let length = |a: f64, b: f64| (a * a + b * b).sqrt();
        // the shift of an inner groove centre, and what it turns with the cage
        let radial = length(x, y) + turn * length(to[0], to[1]);
        if [tilt_x, tilt_y, to[3], to[4]] == [0.0; 4] {
            return length(radial, z);
        }
        let arm = self.ring.arm();
        let tilt = length(tilt_x, tilt_y) + turn * length(to[3], to[4]);
        length(radial, z.abs() + arm * tilt)
    }

    /// How far one of them is pressed past its lift-off, m.
    pub(crate) fn past_lift_off(
        &self,
        ball: usize,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> f64 {
        let place = self.ring_displacement(displacement, cage, speed);
        match &self.table {
            Some(table) => table.past_lift_off(ball, &place, cage, speed),
            None => self.ring.past_lift_off(ball, &place, cage, speed),
        }
    }

    /// Largest load of a ball so far past its lift-off in m, N.
    pub(crate) fn load_past_lift_off(&self, distance: f64, speed: f64) -> f64 {
        self.ring.load_past_lift_off(distance, speed)
    }
}
