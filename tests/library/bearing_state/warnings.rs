//! Warnings: each with its numbers, and none where there is nothing to say.

use crate::bearing::{Bearing, BearingState, ContactLaw, MountedBearing};

use super::{OIL, state_at, state_under_thrust};
use crate::tests::support::{assert_near, bearing, mounted};

fn with_shoulder(degrees: f64) -> MountedBearing {
    mounted(Bearing {
        shoulder_angle: Some(degrees.to_radians()),
        ..bearing("7205C")
    })
}

#[track_caller]
fn assert_warns(state: &BearingState, expected: &[&str]) {
    assert_eq!(
        state.warnings.len(),
        expected.len(),
        "{:#?}",
        state.warnings
    );
    for (warning, expected) in state.warnings.iter().zip(expected) {
        assert!(warning.contains(expected), "{warning}\nhas no\n{expected}");
    }
}

#[test]
fn a_sound_bearing_says_nothing() {
    let definition = MountedBearing {
        bearing: Bearing {
            roughness: Some(0.1e-6),
            ..with_shoulder(40.0).bearing
        },
        oil: Some(OIL),
        ..mounted(bearing("7205C"))
    };
    assert_warns(&state_under_thrust(&definition, 1000.0, 1000.0), &[]);
}

#[test]
fn the_shoulder_margin_is_the_angle_less_the_half_ellipse() {
    let ball = state_under_thrust(&with_shoulder(25.0), 1000.0, 0.0).balls[0].clone();
    for (contact, factor) in [(ball.inner, 0.52), (ball.outer, 0.53)] {
        // sin ϑ = a/(f D)
        let half = (contact.semi_major / (factor * 7.938e-3)).asin();
        let margin = 25f64.to_radians() - contact.angle - half;
        assert_near(
            "margin",
            contact.shoulder_margin.expect("a shoulder"),
            margin,
            1e-15,
        );
    }
    let bare = state_under_thrust(&mounted(bearing("7205C")), 1000.0, 0.0);
    assert_eq!(bare.balls[0].inner.shoulder_margin, None);
}

#[test]
fn an_ellipse_over_the_shoulder() {
    let state = state_under_thrust(&with_shoulder(20.0), 1000.0, 0.0);
    assert_warns(
        &state,
        &[
            "cut off at the shoulder of the inner race on 12 of 12 balls",
            "cut off at the shoulder of the outer race on 12 of 12 balls",
        ],
    );
    assert!(state.warnings[0].contains("contact angle 19.36°"));
    assert!(state.warnings[0].contains("shoulder at 20.00°"));
}

#[test]
fn a_film_thinner_than_the_roughness() {
    // h_min is 0.70 µm at the inner race and 0.83 µm at the outer one
    let definition = MountedBearing {
        bearing: Bearing {
            roughness: Some(0.75e-6),
            ..bearing("7205C")
        },
        oil: Some(OIL),
        ..mounted(bearing("7205C"))
    };
    let state = state_under_thrust(&definition, 1000.0, 1000.0);
    assert_warns(&state, &["the oil film at the inner race"]);
    assert!(
        state.warnings[0].contains("λ = 0.93"),
        "{}",
        state.warnings[0]
    );
}

#[test]
fn an_angular_contact_bearing_pulled_the_wrong_way() {
    // pulled through until the balls lean against the other shoulders
    let z = -2.2 * bearing("7205C").geometry.free_axial();
    let state = state_at(&mounted(bearing("7205C")), [0.0, 0.0, z, 0.0, 0.0], 0.0);
    assert_eq!(state.balls_loaded, 12);
    assert_warns(&state, &["loaded the wrong way: 12 of 12 loaded balls"]);
}

/// Under a radial load alone, in the middle of its axial play.
#[test]
fn an_angular_contact_bearing_without_thrust() {
    let middle = -bearing("7205C").geometry.free_axial();
    let state = state_at(
        &mounted(bearing("7205C")),
        [0.0, -30e-6, middle, 0.0, 0.0],
        0.0,
    );
    assert!(state.balls_loaded > 0);
    assert_warns(&state, &["without any axial force"]);
}

#[test]
fn a_deep_groove_bearing_has_no_wrong_way() {
    let pushed = mounted(bearing("6305"));
    let state = state_at(&pushed, [0.0, 0.0, -100e-6, 0.0, 0.0], 0.0);
    assert_eq!(state.balls_loaded, 7);
    assert_warns(&state, &[]);
}

#[test]
fn more_pressure_than_iso_76_permits() {
    let state = state_under_thrust(&mounted(bearing("7205C")), 30e3, 0.0);
    assert!(state.static_safety.expect("a load") < 1.0);
    assert!(
        state.warnings[0].contains("exceeds the 4200 MPa of ISO 76 on 12 of 12 balls"),
        "{:?}",
        state.warnings
    );
}

/// Behind oil no load quite vanishes: balls far from the race count as unloaded all the same.
#[test]
fn balls_behind_a_film_alone_are_not_loaded() {
    for law in [
        ContactLaw::Hertz,
        ContactLaw::Jones(crate::physics::RaceControl::Outer),
    ] {
        let definition = MountedBearing {
            law,
            oil: Some(OIL),
            ..mounted(bearing("7205C"))
        };
        let state = state_at(&definition, [60e-6, 0.0, 0.0, 0.0, 0.0], 500.0);
        assert!(state.balls.iter().all(|ball| ball.inner.load > 0.0));
        // five on that side, and two across that stand without a gap on their films
        assert_eq!(state.balls_loaded, 7, "{law:?}");
    }
}

#[test]
fn a_speed_above_the_limiting_one() {
    let rpm = std::f64::consts::TAU / 60.0;
    let bearing_with_limit = Bearing {
        limiting_speed: Some(18_000.0 * rpm),
        ..bearing("7205C")
    };
    let definition = MountedBearing {
        law: ContactLaw::Jones(crate::physics::RaceControl::Outer),
        ..mounted(bearing_with_limit)
    };
    let at = |speed: f64| state_under_thrust(&definition, 1000.0, speed * rpm);
    assert_warns(&at(18_000.0), &[]);
    assert_warns(
        &at(27_000.0),
        &["27000 rpm is 1.50 times its limiting speed, 18000 rpm"],
    );
    // 10⁶ mm/min over a pitch diameter of 38.5 mm
    let limit = bearing("7205C").highest_permissible_speed();
    assert_near("limit, rpm", limit / rpm, 1e6 / 38.5, 1e-9);
}
