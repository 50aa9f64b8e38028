//! Whether all balls of a plain Hertz bearing bear, told without looking at any of them.

use fearless_simd::dispatch;

use super::support::imposed;
use super::{HertzLaw, LANES, Ring, SupportObservation, Vector5};

/// The circle of the inner groove centres of a bearing, about its outer one.
struct Circle {
    free_axial: f64,
    free_radial: f64,
    /// Radius R_i, m.
    arm: f64,
}

impl Circle {
    /// Distance, m, that no inner groove centre is nearer than to the outer one with the inner ring at a
    /// displacement, wherever the cage stands, and least distance along the axis, m, by which they are pressed the way
    /// the bearing faces; negative where not all are.
    ///
    /// A distance is no shorter than its part along any direction, here along that to the mean (a, b) of all
    /// inner groove centres:
    ///
    /// ```text
    /// A1 = a + R_i (θx sin φ − θy cos φ)   A2 = b + x cos φ + y sin φ   c = √(a² + b²)
    /// √(A1² + A2²) ≥ (a A1 + b A2)/c ≥ c − |(b x − a R_i θy, b y + a R_i θx)|/c
    /// ```
    #[inline(always)]
    fn least_distance(&self, [x, y, z, tilt_x, tilt_y]: Vector5) -> [f64; 2] {
        let [axial, radial] = [self.free_axial + z, self.free_radial];
        let [arm_x, arm_y] = [self.arm * tilt_x, self.arm * tilt_y];
        let square = axial * axial + radial * radial;
        let lean = length(radial * x - axial * arm_y, radial * y + axial * arm_x);
        let least = (square - lean) / square.sqrt();
        [least, axial - length(arm_x, arm_y)]
    }
}

impl SupportObservation {
    /// Whether it is certain that, with the shaft at each of a few displacements, axis by axis, every ball is
    /// approached by at least so many m and pressed the way the bearing faces, wherever the cage stands. Where it is
    /// not, the balls must be asked.
    pub fn is_certainly_in_contact(
        &self,
        displacements: [&[f64; LANES]; 5],
        approach: f64,
    ) -> bool {
        dispatch!(self.level, _simd => self.is_certainly_in_contact_by(displacements, approach))
    }

    /// As [`SupportObservation::is_certainly_in_contact`], in registers as wide as what it is inlined into has them.
    #[inline(always)]
    fn is_certainly_in_contact_by(&self, displacements: [&[f64; LANES]; 5], approach: f64) -> bool {
        let circle = Circle {
            free_axial: self.free_axial,
            free_radial: self.free_radial,
            arm: self.arm,
        };
        let (mut least, mut pressed) = ([0.0; LANES], [0.0; LANES]);
        for lane in 0..LANES {
            let mut place = [0.0; 5];
            for axis in 0..5 {
                place[axis] = displacements[axis][lane];
            }
            let [x, y, z, tilt_x, tilt_y] = imposed(&place, self.sign, self.position);
            let place = [x, y, z + self.offset, tilt_x, tilt_y];
            [least[lane], pressed[lane]] = circle.least_distance(place);
        }
        let due = self.law.distance + approach;
        let mut certain = true;
        for lane in 0..LANES {
            certain &= (least[lane] >= due) & (pressed[lane] > 0.0);
        }
        certain
    }
}

impl Ring<HertzLaw> {
    /// Approach, m, that no ball has less of with the inner ring at a displacement, wherever the cage stands;
    /// negative where that is not certain.
    pub(super) fn least_approach(&self, place: &Vector5) -> f64 {
        let circle = Circle {
            free_axial: self.free_axial,
            free_radial: self.free_radial,
            arm: self.arm,
        };
        circle.least_distance(*place)[0] - self.law().distance
    }
}

fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use crate::bearing::support_observation::tests::support;
    use crate::bearing::{CageAngle, LANES, SupportObservation};

    /// Places that a shaft takes one after the other.
    fn place(step: u32) -> [f64; 5] {
        let part = |rate: f64| (rate * f64::from(step)).sin();
        [
            8e-6 * part(0.37),
            8e-6 * part(0.61),
            -2e-5 + 2e-5 * part(0.23),
            2e-4 * part(0.71),
            2e-4 * part(0.97),
        ]
    }

    /// What is certain is so at every place of the cage, and most of what is so is certain.
    #[test]
    fn balls_that_are_certain_to_bear_do() {
        let support = support("7205C");
        let mut seen = SupportObservation::new(&support).expect("a plain bearing");
        seen.make_room(1);
        let (mut certain, mut bearing) = (0, 0);
        for step in 0..2000 {
            let place = place(step);
            let approach = 2e-6 * (0.41 * f64::from(step)).sin().abs();
            let places = place.map(|axis| [axis; LANES]);
            let told = seen.is_certainly_in_contact(places.each_ref(), approach);
            let mut bears = true;
            for turn in 0..5 {
                let cages = std::array::from_fn(|lane| 0.03 * (turn * LANES + lane) as f64);
                seen.observe(0, places.each_ref(), &cages, 1.0);
                let lowest = seen.lowest_approach(0).iter().copied();
                bears &= lowest.fold(f64::INFINITY, f64::min) >= approach;
                bears &= (0..LANES).all(|lane| seen.axial_force(0, lane) > 0.0);
            }
            assert!(bears || !told, "{place:?}");
            certain += u32::from(told);
            bearing += u32::from(bears);
        }
        assert!(
            (500..1800).contains(&bearing) && 100 * certain > 95 * bearing,
            "{certain} of {bearing}"
        );
    }

    /// Where the shaft moves by less than the balls are from their lift-off, none lifts off, wherever the cage stands.
    #[test]
    fn a_shift_below_the_clearance_lifts_no_ball_off() {
        let support = support("7205C");
        let (mut clear, mut moved) = (0, 0);
        for step in 0..2000 {
            let from = place(step);
            let next = place(step + 1);
            let to = std::array::from_fn(|axis| from[axis] + 0.2 * (next[axis] - from[axis]));
            let shift = support.approach_to_lift_off([&from, &to], 0.0);
            moved += u32::from(shift > 0.0);
            if shift >= support.clearance(&from) {
                continue;
            }
            clear += 1;
            for turn in 0..20 {
                let cage = CageAngle::new(0.03 * f64::from(turn));
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
