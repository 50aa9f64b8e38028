//! The law of one ball against its formula differentiated by dual numbers.

use crate::bearing::{Ball, BallLaw, ForceLaw};
use num_dual::{Dual64, DualNum};
use proptest::prelude::*;

use crate::tests::support::{bearing, law};

/// Q = K_n δ^(3/2) along the line of groove centres, written once more, for any kind of number.
fn formula<D: DualNum<f64> + Copy>(stiffness: f64, distance: f64, axial: D, radial: D) -> [D; 2] {
    let length = (axial * axial + radial * radial).sqrt();
    let approach = length - distance;
    if approach.re() <= 0.0 {
        return [D::zero(), D::zero()];
    }
    let load = approach.powf(1.5) * stiffness;
    [load * axial / length, load * radial / length]
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: proptest::test_runner::RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::with_cases(1000) })]

    #[test]
    fn force_and_tangent_are_the_formula_and_its_derivative(
        angle in -3.2..3.2f64, reach in 0.5..1.4f64,
    ) {
        let law = law(&bearing("7205C"));
        let (stiffness, distance) = (law.contact.stiffness, law.distance);
        let (axial, radial) = (reach * distance * angle.sin(), reach * distance * angle.cos());
        let (force, tangent) = law.force_and_tangent(axial, radial, 0.0);
        let by = |axis: usize| {
            let mut place = [Dual64::from_re(axial), Dual64::from_re(radial)];
            place[axis] = place[axis].derivative();
            formula(stiffness, distance, place[0], place[1])
        };
        let [by_axial, by_radial] = [by(0), by(1)];
        prop_assert_eq!(force, law.force(&Ball::at(axial, radial), 0.0));
        // δ is the difference of two lengths of size A: their round-off, 4 ε A, is its error
        let approach = (reach - 1.0).abs() * distance;
        let relative = 16.0 * f64::EPSILON * (1.0 + distance / approach);
        let force_unit = stiffness * approach.powf(1.5);
        let slope_unit = 1.5 * stiffness * approach.sqrt();
        for (row, value) in [force.axial, force.radial].into_iter().enumerate() {
            prop_assert!((value - by_axial[row].re).abs() <= relative * force_unit);
            prop_assert!((tangent[row][0] - by_axial[row].eps).abs() <= relative * slope_unit);
            prop_assert!((tangent[row][1] - by_radial[row].eps).abs() <= relative * slope_unit);
        }
        prop_assert_eq!(force.couple, 0.0);
        prop_assert_eq!(tangent[2], [0.0; 2]);
    }
}

#[test]
fn every_position_has_a_finite_answer() {
    let law = law(&bearing("7205C"));
    let (force, tangent) = law.force_and_tangent(0.0, 0.0, 0.0);
    assert_eq!([force.axial, force.radial], [0.0; 2]);
    assert!(tangent.iter().flatten().all(|entry| *entry == 0.0));
    assert_eq!(law.contact(&Ball::at(0.0, 0.0), 0.0).load_inner, 0.0);
}
