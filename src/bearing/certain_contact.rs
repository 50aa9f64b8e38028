//! Whether all balls of a plain Hertz bearing bear, told without looking at any of them.

use super::support::imposed;
use super::{SupportObservation, Vector5};

impl SupportObservation {
    /// Whether it is certain that, with the shaft at a displacement, every ball is approached by at least so many m
    /// and pressed the way the bearing faces, wherever the cage stands. Where it is not, the balls must be asked.
    ///
    /// A distance is no shorter than its part along any direction, here along that to the mean (a, b) of all
    /// inner groove centres:
    ///
    /// ```text
    /// A1 = a + R_i (θx sin φ − θy cos φ)   A2 = b + x cos φ + y sin φ   c = √(a² + b²)
    /// √(A1² + A2²) ≥ (a A1 + b A2)/c ≥ c − |(b x − a R_i θy, b y + a R_i θx)|/c
    /// ```
    pub fn is_certainly_in_contact(&self, displacement: &Vector5, approach: f64) -> bool {
        let [x, y, z, tilt_x, tilt_y] = imposed(displacement, self.sign, self.position);
        let [axial, radial] = [self.free_axial + (z + self.offset), self.free_radial];
        let [arm_x, arm_y] = [self.arm * tilt_x, self.arm * tilt_y];
        let square = axial * axial + radial * radial;
        let lean = length(radial * x - axial * arm_y, radial * y + axial * arm_x);
        let due = self.law.distance + approach;
        axial > length(arm_x, arm_y) && square - lean >= due * square.sqrt()
    }
}

fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use crate::bearing::{
        ContactDamping, ContactLaw, Facing, LANES, MountedBearing, Preload, Support,
        SupportObservation, catalogue,
    };

    /// What is certain is so at every place of the cage, and most of what is so is certain.
    #[test]
    fn balls_that_are_certain_to_bear_do() {
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
        let support = Support::new(&mounted, 0.0).expect("a support");
        let mut seen = SupportObservation::new(&support).expect("a plain bearing");
        let (mut certain, mut bearing) = (0, 0);
        for step in 0..2000 {
            let part = |rate: f64| (rate * f64::from(step)).sin();
            let place = [
                8e-6 * part(0.37),
                8e-6 * part(0.61),
                -2e-5 + 2e-5 * part(0.23),
                2e-4 * part(0.71),
                2e-4 * part(0.97),
            ];
            let approach = 2e-6 * part(0.41).abs();
            let told = seen.is_certainly_in_contact(&place, approach);
            let mut bears = true;
            for turn in 0..5 {
                let cages = std::array::from_fn(|lane| 0.03 * (turn * LANES + lane) as f64);
                seen.observe(&[place; LANES], cages);
                let lowest = seen.lowest_approach().into_iter();
                bears &= lowest.fold(f64::INFINITY, f64::min) >= approach;
                bears &= (0..LANES).all(|lane| seen.axial_force(lane) > 0.0);
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
}
