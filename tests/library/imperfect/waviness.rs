//! Which orders of waves move a shaft, how far, and how often.

use crate::bearing::{
    Angle, BearingRotation, Imperfections, MountedBearing, Support, Surface, Wave,
};
use crate::tests::support::{assert_near, bearing, equilibrium, mounted};

use super::support;

const THRUST: f64 = 1000.0;
const BALLS: u32 = 12;

fn wavy(on: Surface, order: u32, amplitude: f64, phase: f64) -> MountedBearing {
    let wave = Wave {
        order,
        amplitude,
        phase,
    };
    with_waves(vec![(on, wave)])
}

fn with_waves(waves: Vec<(Surface, Wave)>) -> MountedBearing {
    MountedBearing {
        imperfections: Imperfections {
            waves,
            ..Imperfections::default()
        },
        ..mounted(bearing("7205C"))
    }
}

fn place(bearing: MountedBearing) -> [f64; 5] {
    let load = [0.0, 0.0, THRUST, 0.0, 0.0];
    let free = [true, true, true, false, false];
    equilibrium(&[bearing], load, free)
        .expect("thrust is carried")
        .displacement
}

#[test]
fn the_shaft_follows_waves_by_the_quasi_static_amplitudes() {
    let amplitude = 1e-10;
    let still = place(mounted(bearing("7205C")));
    for on in [Surface::Outer, Surface::Inner] {
        for order in [BALLS - 1, BALLS + 1, 2 * BALLS + 1] {
            let [x, y, ..] = place(wavy(on, order, amplitude, 0.7));
            assert_near("radial", x.hypot(y) / amplitude, 1.057_905, 1e-5);
        }
        let [.., z, _, _] = place(wavy(on, 2 * BALLS, amplitude, 0.0));
        assert_near("axial", (z - still[2]) / amplitude, 2.680_042, 1e-5);
    }
}

/// Change of the force with shaft and cage turned, N.
fn change(support: &Support, sound: &Support, angle: f64) -> [f64; 3] {
    let at = place_under_thrust();
    let ratio = support.cage_ratio();
    let rotation = BearingRotation {
        cage: Angle::new(ratio * angle),
        shaft: Angle::new(angle),
        cage_angle: ratio * angle,
        cage_speed: 0.0,
        speed: 0.0,
    };
    let [wavy, perfect] = [support, sound].map(|support| support.force(&at, &rotation));
    std::array::from_fn(|axis| wavy[axis] - perfect[axis])
}

/// α = 19.35927°, δz = 31.97643 µm.
fn place_under_thrust() -> [f64; 5] {
    [0.0, 0.0, 31.976_43e-6, 0.0, 0.0]
}

/// Largest radial and axial change of the force over a few turns of a bearing with a wave of an order.
fn largest(on: Surface, order: u32) -> [f64; 2] {
    let (wavy, sound) = (
        support(&wavy(on, order, 1e-11, 0.4), 0.0),
        support(&mounted(bearing("7205C")), 0.0),
    );
    let mut largest = [0.0_f64; 2];
    for part in 0..40 {
        let [x, y, z] = change(&wavy, &sound, 0.31 * f64::from(part));
        largest = [largest[0].max(x.hypot(y)), largest[1].max(z.abs())];
    }
    largest
}

#[test]
fn orders_off_the_rules_give_nothing() {
    for on in [Surface::Outer, Surface::Inner] {
        let [radial, _] = largest(on, BALLS + 1);
        let [_, axial] = largest(on, BALLS);
        assert!(radial > 1e-5 && axial > 1e-5);
        for order in 2..=2 * BALLS + 2 {
            let [by_radial, by_axial] = largest(on, order);
            let along = order % BALLS == 0;
            let across = order % BALLS == 1 || order % BALLS == BALLS - 1;
            assert_eq!(
                by_radial > 1e-6 * radial,
                across,
                "{on:?} {order}: {by_radial:e}"
            );
            assert_eq!(
                by_axial > 1e-6 * axial,
                along,
                "{on:?} {order}: {by_axial:e}"
            );
            if across {
                assert!(by_radial > 0.9 * radial);
            }
        }
    }
}

/// Turns of the radial force, or of a cosine along the axis, by the angle of the shaft: how often they go round as the
/// shaft turns once.
fn assert_goes_round(bearing: &MountedBearing, axial: bool, expected: f64) {
    let (wavy, sound) = (
        support(bearing, 0.0),
        support(&mounted(self::bearing("7205C")), 0.0),
    );
    let at = |angle: f64| change(&wavy, &sound, angle);
    let [x, y, z] = at(0.0);
    // a quarter of a turn of the line later the cosine has become a sine
    let quarter = std::f64::consts::FRAC_PI_2 / expected.abs();
    let [.., sine] = at(-quarter);
    for part in 1..30 {
        let angle = 0.173 * f64::from(part);
        let (sin, cos) = (expected * angle).sin_cos();
        let [found_x, found_y, found_z] = at(angle);
        if axial {
            let size = z.hypot(sine);
            assert_near("z", found_z, z * cos - sine * sin, 2e-5 * size);
        } else {
            let size = x.hypot(y);
            assert_near("x", found_x, x * cos - y * sin, 2e-5 * size);
            assert_near("y", found_y, y * cos + x * sin, 2e-5 * size);
        }
    }
}

#[test]
fn orders_on_the_rules_give_their_lines() {
    let support = support(&mounted(bearing("7205C")), 0.0);
    let (cage, balls) = (support.cage_ratio(), f64::from(BALLS));
    let past = 1.0 - cage;
    for n in [1, 2] {
        let passes = f64::from(n) * balls;
        // k BPFI ± f_r, and as often as balls pass the outer race; forward where a wave more, backward where one less
        for (on, more, less, along) in [
            (
                Surface::Inner,
                passes * past + 1.0,
                1.0 - passes * past,
                passes * past,
            ),
            (Surface::Outer, -passes * cage, passes * cage, passes * cage),
        ] {
            assert_goes_round(&wavy(on, n * BALLS + 1, 1e-11, 0.4), false, more);
            assert_goes_round(&wavy(on, n * BALLS - 1, 1e-11, 0.4), false, less);
            assert_goes_round(&wavy(on, n * BALLS, 1e-11, 0.4), true, along);
        }
    }
}

#[test]
fn even_waves_of_a_ball_act_at_twice_its_spin() {
    let geometry = bearing("7205C").geometry;
    let pass = geometry.ball_pass(std::f64::consts::TAU);
    let bearing = |order| wavy(Surface::Ball(3), order, 1e-11, 0.0);
    assert_goes_round(&bearing(2), true, 2.0 * pass.spin);
    assert_goes_round(&bearing(4), true, 4.0 * pass.spin);
    let [radial, axial] = largest(Surface::Ball(3), 2);
    let odd = largest(Surface::Ball(3), 3);
    assert!(odd[0] < 1e-6 * radial && odd[1] < 1e-6 * axial, "{odd:?}");
    // across the axis: 2 f_b ± f_c, for the force turns with the ball
    let (wavy, sound) = (
        support(&bearing(2), 0.0),
        support(&mounted(self::bearing("7205C")), 0.0),
    );
    for part in 0..20 {
        let angle = 0.21 * f64::from(part);
        let [x, y, _] = change(&wavy, &sound, angle);
        let azimuth = std::f64::consts::TAU * 3.0 / 12.0 + pass.cage * angle;
        let size = (2.0 * pass.spin * angle).cos();
        assert_near("x", x, -radial * size * azimuth.cos(), 3e-2 * radial);
        assert_near("y", y, -radial * size * azimuth.sin(), 3e-2 * radial);
    }
}

#[test]
fn a_large_ball_pushes_the_shaft_round_with_the_cage() {
    let mut oversizes = vec![0.0; 12];
    oversizes[0] = 1e-11;
    let large = MountedBearing {
        imperfections: Imperfections {
            oversizes,
            ..Imperfections::default()
        },
        ..mounted(bearing("7205C"))
    };
    let cage = support(&large, 0.0).cage_ratio();
    assert_goes_round(&large, false, cage);
}
