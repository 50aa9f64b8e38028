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
        match self.table_at(&place, speed) {
            Some(table) => table.table_lift_offs(&place, cage),
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
    #[allow(dead_code)]
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

    /// Whether it is certain that every ball is approached by at least so many m and pressed the way the bearing
    /// faces, wherever the cage stands.
    pub(crate) fn is_certain_to_bear(&self, displacement: &Vector5, approach: f64) -> bool {
        let (None, Some((ring, offset))) = (&self.frozen, self.plain_ring()) else {
            return false;
        };
        let [x, y, z, tilt_x, tilt_y] = self.imposed(displacement);
        let place = [x, y, z + offset, tilt_x, tilt_y];
        ring.least_approach(&place) >= approach && ring.least_axial(&place) > 0.0
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
        match self.table_at(&place, speed) {
            Some(table) => table.table_past_lift_off(ball, &place, cage),
            None => self.ring.past_lift_off(ball, &place, cage, speed),
        }
    }

    /// Largest load of a ball so far past its lift-off in m, N.
    pub(crate) fn load_past_lift_off(&self, distance: f64, speed: f64) -> f64 {
        self.ring.load_past_lift_off(distance, speed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::{ContactDamping, ContactLaw, Facing, MountedBearing, Preload, catalogue};

    /// A preset bearing off the centre of mass that faces −z.
    fn support() -> Support {
        let entry = catalogue::find("7205C").expect("in the catalogue");
        let mounted = MountedBearing {
            bearing: entry.bearing().expect("a bearing"),
            law: ContactLaw::Hertz,
            oil: None,
            position: 0.03,
            facing: Facing::MinusZ,
            preload: Preload::AxialOffset(8e-6),
            contact_damping: ContactDamping::default(),
            first_ball: 0.1,
        };
        Support::new(&mounted, 0.0).expect("a support")
    }

    /// Displacements that a shaft takes one after the other.
    fn displacement(step: u32) -> Vector5 {
        let part = |rate: f64| (rate * f64::from(step)).sin();
        [
            8e-6 * part(0.37),
            8e-6 * part(0.61),
            -2e-5 + 2e-5 * part(0.23),
            2e-4 * part(0.71),
            2e-4 * part(0.97),
        ]
    }

    fn turns() -> impl Iterator<Item = CageAngle> {
        (0..20).map(|turn| CageAngle::new(0.03 * f64::from(turn)))
    }

    /// No ball is nearer to its lift-off than the clearance says, and it says little less than the nearest ball.
    #[test]
    fn no_ball_is_nearer_to_its_lift_off_than_the_clearance() {
        let support = support();
        let (mut clear, mut pressed) = (0, 0);
        for step in 0..2000 {
            let place = displacement(step);
            let clearance = support.clearance(&place);
            let seen = turns().map(|cage| support.lift_offs(&place, cage, 0.0));
            let nearest = seen.fold(f64::INFINITY, |nearest, seen| match seen.pressed {
                0xfff => nearest.min(seen.nearest),
                _ => f64::NEG_INFINITY,
            });
            assert!(nearest > clearance - 1e-15 || clearance <= 0.0, "{place:?}");
            clear += u32::from(clearance > 0.0);
            pressed += u32::from(nearest > 0.0);
        }
        assert!(
            (500..1800).contains(&pressed) && 100 * clear > 95 * pressed,
            "{clear} of {pressed}"
        );
    }

    /// Where the shaft moves by less than the balls are from their lift-off, none lifts off, wherever the cage stands.
    #[test]
    fn a_shift_below_the_clearance_lifts_no_ball_off() {
        let support = support();
        let (mut clear, mut moved) = (0, 0);
        for step in 0..2000 {
            let from = displacement(step);
            let next = displacement(step + 1);
            let to = std::array::from_fn(|axis| from[axis] + 0.2 * (next[axis] - from[axis]));
            let shift = support.approach_to_lift_off([&from, &to], 0.0);
            moved += u32::from(shift > 0.0);
            if shift >= support.clearance(&from) {
                continue;
            }
            clear += 1;
            for cage in turns() {
                let all = support.lift_offs(&to, cage, 0.0).pressed;
                assert_eq!(all.count_ones(), 12, "{from:?} to {to:?}");
            }
        }
        assert!(
            (200..1800).contains(&clear) && moved == 2000,
            "{clear}, {moved}"
        );
    }
}
