//! Motion and inertia of the balls, ball-pass frequencies, friction moment.

use std::f64::consts::{PI, TAU};

use crate::bearing::{ContactLaw, MountedBearing};
use crate::physics::{BallMotion, Race, RaceControl};

use super::{OIL, state_under_thrust};
use crate::tests::support::{assert_near, assert_printed, bearing, mounted};

fn jones(control: RaceControl) -> MountedBearing {
    MountedBearing {
        law: ContactLaw::Jones(control),
        ..mounted(bearing("7205C"))
    }
}

/// Independent implementations, 1000 N thrust, outer race control: ω, α_i, α_o, Q_i, Q_o, F_c,
/// M_g in N mm.
const AT_SPEED: [(f64, [&str; 6]); 2] = [
    (
        500.0,
        [
            "19.45580", "19.28689", "250.1905", "251.6949", "1.59503", "0.836405",
        ],
    ),
    (
        1000.0,
        [
            "19.74569", "19.06724", "246.6608", "252.6792", "6.38608", "3.312036",
        ],
    ),
];

#[test]
fn every_ball_of_the_jones_law() {
    for (speed, [angle_i, angle_o, load_i, load_o, centrifugal, gyroscopic]) in AT_SPEED {
        let state = state_under_thrust(&jones(RaceControl::Outer), 1000.0, speed);
        for ball in &state.balls {
            assert_printed("α_i", ball.inner.angle.to_degrees(), angle_i);
            assert_printed("α_o", ball.outer.angle.to_degrees(), angle_o);
            assert_printed("Q_i", ball.inner.load, load_i);
            assert_printed("Q_o", ball.outer.load, load_o);
            assert_printed("F_c", ball.centrifugal_force, centrifugal);
            assert_printed("M_g", ball.gyroscopic_moment * 1e3, gyroscopic);
            assert_near("no spin", ball.outer.spin_to_roll, 0.0, 1e-14);
            assert!(ball.inner.spin_to_roll > 0.1);
        }
    }
}

/// Jones: Q_o a_o E_o cos(α_i − α_o) > Q_i a_i E_i. Slow, the inner race of the 7205C with its longer
/// ellipse holds the ball; at 3000 rad/s the centrifugal force has given it to the outer one.
#[test]
fn the_criterion_of_race_control_goes_over_to_the_outer_race() {
    let controlling = |thrust, speed| {
        let state = state_under_thrust(&jones(RaceControl::Outer), thrust, speed);
        state.balls[0].controlling_race
    };
    assert_eq!(controlling(1000.0, 100.0), Some(Race::Inner));
    assert_eq!(controlling(100.0, 3000.0), Some(Race::Outer));
}

/// Without inertia the ball rolls as under outer control at its one contact angle.
#[test]
fn spin_to_roll_without_inertia() {
    let state = state_under_thrust(&mounted(bearing("7205C")), 1000.0, 500.0);
    let ball = state.balls[0].clone();
    let angle = ball.inner.angle;
    let motion = BallMotion::new(RaceControl::Outer, 7.938 / 38.5, angle, angle);
    let spin = motion.spin_to_roll_inner;
    assert_near("spin", ball.inner.spin_to_roll, spin, 1e-14);
    assert_near("no spin", ball.outer.spin_to_roll, 0.0, 1e-14);
    assert_eq!(ball.centrifugal_force, 0.0);
    assert_eq!(ball.controlling_race, None);
    let still = state_under_thrust(&mounted(bearing("7205C")), 1000.0, 0.0);
    assert_eq!(still.balls[0].inner.spin_to_roll, 0.0);
}

/// 1000 N thrust raise the contact angle of the 7205C from 15° to 19.35927° (independent
/// implementations): γ = D cos α/d_m falls, the cage turns faster.
#[test]
fn ball_pass_frequencies_follow_the_operating_angle() {
    let speed = 500.0;
    let state = state_under_thrust(&mounted(bearing("7205C")), 1000.0, speed);
    let gamma = 7.938 / 38.5 * 19.35927f64.to_radians().cos();
    let shaft = speed / TAU;
    // BPFO = Z (f/2)(1 − γ); γ is known to 1e-8 by the digits of the angle
    let outer = 12.0 * shaft / 2.0 * (1.0 - gamma);
    assert_near("BPFO", state.ball_pass.outer, outer, 1e-7 * outer);
    let inner = 12.0 * shaft / 2.0 * (1.0 + gamma);
    assert_near("BPFI", state.ball_pass.inner, inner, 1e-7 * inner);
    // of the ball with inertia the mean of both races
    let state = state_under_thrust(&jones(RaceControl::Outer), 1000.0, speed);
    let cosines = [19.45580f64, 19.28689].map(|angle| angle.to_radians().cos());
    let mean = 0.5 * (cosines[0] + cosines[1]);
    let outer = 12.0 * shaft / 2.0 * (1.0 - 7.938 / 38.5 * mean);
    assert_near("BPFO", state.ball_pass.outer, outer, 1e-7 * outer);
}

/// By hand for the 7205C, C_0 from its own contacts: F_a = 1000 N, P_0 = 0.46 F_a,
/// P_1 = 0.9 F_a cot 15°; ν = 0.04/870 m²/s, n = 1000·30/π, f_0 = 3.3.
#[test]
fn friction_moment_of_an_angular_contact_bearing() {
    let definition = MountedBearing {
        oil: Some(OIL),
        ..mounted(bearing("7205C"))
    };
    let moment = state_under_thrust(&definition, 1000.0, 1000.0).friction_moment;
    let rating = definition.bearing.static_rating().expect("contacts");
    let load = 1e-3 * (460.0 / rating).powf(0.33) * 900.0 / 15f64.to_radians().tan() * 38.5e-3;
    assert_near("M_1", moment.load, load, 1e-9 * load);
    let product: f64 = 0.04 / 870.0 * 1e6 * 1000.0 * 30.0 / PI;
    let viscous = 1e-7 * 3.3 * product.powf(2.0 / 3.0) * 38.5f64.powi(3) * 1e-3;
    assert_near("M_0", moment.viscous, viscous, 1e-12 * viscous);
    assert_near("sum", moment.total(), load + viscous, 1e-9 * load);
}
