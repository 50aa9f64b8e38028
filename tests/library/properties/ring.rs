//! Symmetries of the ring of balls and of the mounted bearing; its force as a gradient.

use std::f64::consts::TAU;

use crate::bearing::{BearingRotation, Facing, MountedBearing, Preload, Vector5};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use crate::rotor::Attachment;
use crate::tests::support::{bearing, law, mounted, ring, ring_from, supports};

/// Displacements of tens of micrometres, loaded balls and free ones.
fn displacement() -> impl Strategy<Value = Vector5> {
    [
        -30e-6..30e-6f64,
        -30e-6..30e-6f64,
        -20e-6..60e-6f64,
        -1e-3..1e-3f64,
        -1e-3..1e-3f64,
    ]
}

/// Components in N: moments by the arm.
fn in_newton(force: &Vector5) -> Vector5 {
    let arm = bearing("7205C").geometry.inner_groove_radius();
    let [x, y, z, m_x, m_y] = *force;
    [x, y, z, m_x / arm, m_y / arm]
}

/// Asserts that forces are equal to round-off: 1e-11 of what all balls carry, since the approach of
/// a ball, 0.1 … 0.01 of the groove distance, has lost one or two digits.
fn same(left: &Vector5, right: &Vector5) -> Result<(), TestCaseError> {
    let size = in_newton(left)
        .iter()
        .fold(100.0_f64, |size, part| size.max(part.abs()));
    for (a, b) in in_newton(left).into_iter().zip(in_newton(right)) {
        prop_assert!((a - b).abs() <= 1e-11 * size, "{left:?} {right:?}");
    }
    Ok(())
}

/// A vector's x, y and tilts turned about Z.
fn turned(vector: &Vector5, angle: f64) -> Vector5 {
    let (sin, cos) = angle.sin_cos();
    let [x, y, z, tilt_x, tilt_y] = *vector;
    [
        x * cos - y * sin,
        x * sin + y * cos,
        z,
        tilt_x * cos - tilt_y * sin,
        tilt_x * sin + tilt_y * cos,
    ]
}

/// Force of a rigid shaft, displaced at its centre of mass, onto a bearing, moments about that.
fn force_of(mounted: MountedBearing, shaft: &Vector5) -> Vector5 {
    let attachment = Attachment::on_rigid_shaft(mounted.position, mounted.facing);
    let displacement = attachment.displacement(shaft, &[]);
    let own = supports(&[mounted])[0].force(&displacement, &BearingRotation::at_start(0.0));
    let mut force = [0.0; 5];
    attachment.add_force(1.0, &own, &mut force);
    force
}

/// Σ (2/5) K_n δ^(5/2) over all balls, in J, by the formula of the groove centres.
fn energy(displacement: &Vector5) -> f64 {
    let bearing = bearing("7205C");
    let (geometry, law) = (&bearing.geometry, law(&bearing));
    let [x, y, z, tilt_x, tilt_y] = *displacement;
    let ball = |index: usize| {
        let azimuth = TAU * index as f64 / geometry.balls() as f64;
        let (sin, cos) = azimuth.sin_cos();
        let arm = geometry.inner_groove_radius();
        let axial = geometry.free_axial() + z + arm * (tilt_x * sin - tilt_y * cos);
        let radial = geometry.free_radial() + x * cos + y * sin;
        let approach = (axial.hypot(radial) - law.distance).max(0.0);
        0.4 * law.contact.stiffness * approach.powf(2.5)
    };
    (0..geometry.balls()).map(ball).sum()
}

/// Derivative along one axis from four values. Its error is of fourth order in the step where no ball
/// comes into contact within it; where one does, K_n h^(3/2) of an energy and K_n h^(1/2) of a force,
/// 0.025 N and 1.2e6 N/m: those set the tolerances below.
fn slope(axis: usize, at: &Vector5, value: impl Fn(&Vector5) -> f64) -> f64 {
    let step = if axis < 3 { 2e-8 } else { 1e-6 };
    let shifted = |part: f64| {
        let mut place = *at;
        place[axis] += part * step;
        value(&place)
    };
    (8.0 * (shifted(1.0) - shifted(-1.0)) - (shifted(2.0) - shifted(-2.0))) / (12.0 * step)
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: RngSeed::Fixed(2),
        failure_persistence: None,
        ..ProptestConfig::with_cases(500)
    })]

    #[test]
    fn a_cage_turned_by_one_ball_spacing_changes_nothing(
        place in displacement(), angle in -7.0..7.0f64, spacings in 1..30u8,
    ) {
        let ring = ring(&bearing("7205C"));
        let further = angle + f64::from(spacings) * TAU / 12.0;
        let before = ring.force(&place, &BearingRotation::at_start(0.0).with_cage_at(angle));
        same(&before, &ring.force(&place, &BearingRotation::at_start(0.0).with_cage_at(further)))?;
    }

    #[test]
    fn turning_bearing_and_displacement_together_turns_the_force(
        place in displacement(), angle in -7.0..7.0f64,
    ) {
        let ring = ring(&bearing("7205C"));
        let force = ring.force(&place, &BearingRotation::at_start(0.0));
        let of_turned = ring.force(&turned(&place, angle), &BearingRotation::at_start(0.0).with_cage_at(angle));
        same(&turned(&force, angle), &of_turned)?;
        // a first ball elsewhere is the same as a cage turned there
        let bearing = bearing("7205C");
        let other = ring_from(&bearing, angle);
        same(&of_turned, &other.force(&turned(&place, angle), &BearingRotation::at_start(0.0)))?;
    }

    #[test]
    fn both_ways_to_the_force_agree_and_stiffness_is_symmetric(
        place in displacement(), angle in -7.0..7.0f64,
    ) {
        let ring = ring(&bearing("7205C"));
        let cage = BearingRotation::at_start(0.0).with_cage_at(angle);
        let (force, k) = ring.force_and_stiffness(&place, &cage);
        same(&force, &ring.force(&place, &cage))?;
        for row in 0..5 {
            for column in 0..5 {
                let unit = (k[(row, row)] * k[(column, column)]).sqrt();
                prop_assert!((k[(row, column)] - k[(column, row)]).abs() <= 1e-14 * unit);
            }
        }
    }

    #[test]
    fn force_is_the_gradient_of_the_contact_energy(place in displacement()) {
        let force = ring(&bearing("7205C")).force(&place, &BearingRotation::at_start(0.0));
        let gradient = std::array::from_fn(|axis| slope(axis, &place, energy));
        let size = in_newton(&force).iter().fold(100.0_f64, |size, part| size.max(part.abs()));
        for (a, b) in in_newton(&force).into_iter().zip(in_newton(&gradient)) {
            prop_assert!((a - b).abs() <= 1e-4 * size, "{:?} {:?}", force, gradient);
        }
    }

    #[test]
    fn stiffness_is_the_derivative_of_the_force(place in displacement()) {
        let ring = ring(&bearing("7205C"));
        let (_, k) = ring.force_and_stiffness(&place, &BearingRotation::at_start(0.0));
        for row in 0..5 {
            for column in 0..5 {
                let difference =
                    slope(column, &place, |q| ring.force(q, &BearingRotation::at_start(0.0))[row]);
                // N/m of all balls together, floor for the kink where a ball comes into contact
                let lever = |axis: usize| if axis < 3 { 1.0 } else { 0.0194 };
                let unit = 3e8 * lever(row) * lever(column);
                prop_assert!((k[(row, column)] - difference).abs() <= 5e-3 * unit);
            }
        }
    }

    #[test]
    fn a_mirrored_bearing_has_the_mirrored_force(
        place in displacement(), offset in -1e-5..1e-5f64,
    ) {
        let mirror = |[x, y, z, a, b]: Vector5| [x, y, -z, -a, -b];
        let plus = MountedBearing {
            preload: Preload::AxialOffset(offset),
            ..mounted(bearing("7205C"))
        };
        let minus = MountedBearing { facing: Facing::MinusZ, ..plus.clone() };
        let expected = mirror(force_of(plus, &place));
        prop_assert_eq!(expected, force_of(minus, &mirror(place)));
    }

    #[test]
    fn a_bearing_at_a_position_does_the_same_virtual_work(
        place in displacement(), position in -0.2..0.2f64,
    ) {
        let [x, y, z, tilt_x, tilt_y] = place;
        let centred = mounted(bearing("7205C"));
        let moved = MountedBearing { position, ..centred.clone() };
        // the displacement of the shaft's centre that puts this bearing at `place`
        let of_shaft = [x - position * tilt_y, y + position * tilt_x, z, tilt_x, tilt_y];
        let local = force_of(centred, &place);
        let on_shaft = force_of(moved, &of_shaft);
        let shift = |axis: usize| {
            let mut unit = [0.0; 5];
            unit[axis] = 1.0;
            let [x, y, z, a, b] = unit;
            [x + position * b, y - position * a, z, a, b]
        };
        let work = std::array::from_fn(|axis| {
            local.iter().zip(shift(axis)).map(|(force, part)| force * part).sum()
        });
        // moments grow by position/arm
        let [a, b] = [on_shaft, work].map(|[x, y, z, m, n]: Vector5| [x, y, z, m / 10.0, n / 10.0]);
        same(&a, &b)?;
    }
}

/// The loop over the balls is compiled for wider registers, too; here it is compiled without.
#[test]
fn wider_registers_give_the_same_bytes() {
    let bearing = bearing("7205C");
    let (ring, support) = (ring(&bearing), &supports(&[mounted(bearing)])[0]);
    let bits = |force: &Vector5| force.map(f64::to_bits);
    for step in 0..2000 {
        let t = 0.01 * f64::from(step);
        let place = [
            3e-6 * t.sin(),
            -2e-6 * t.cos(),
            2e-5 * (0.3 * t).sin(),
            1e-5 * t.cos(),
            1e-6 * t,
        ];
        let cage = BearingRotation::at_start(0.0).with_cage_at(t);
        let (narrow, wide) = (ring.force(&place, &cage), support.force(&place, &cage));
        assert_eq!(bits(&narrow), bits(&wide), "{narrow:?} {wide:?}");
    }
}
