//! Ellipse, pressure, approach, stiffness and static safety of every contact.

use crate::bearing::{
    Bearing, FreePosition, Geometry, MountedBearing, RaceContact, permissible_static_load,
};
use crate::physics::Material;

use super::{state_at, state_under_thrust};
use crate::tests::support::{assert_near, bearing, literature_bearing, mounted};

const INCH: f64 = 0.0254;
const POUND: f64 = 4.448_221_615_260_5;
const PSI: f64 = POUND / (INCH * INCH);

/// The paper's inputs are printed to five digits, which moves p_max in its fifth digit.
const MINDEL_DIGITS: f64 = 1e-4;

/// Harris & Mindel 1973, Fig. 15 (E = 2.90e7 psi, ν = 0.25, Z = 21, D = 0.8125 in, pitch 6.2008 in,
/// f = 0.52): both contacts of ball 0, moved along its line of contact until it bears `pounds`.
fn harris_mindel(pounds: f64, degrees: f64) -> [RaceContact; 2] {
    let steel = Material {
        youngs_modulus: 2.90e7 * PSI,
        poisson_ratio: 0.25,
        ..Material::BEARING_STEEL
    };
    let angle = degrees.to_radians();
    let free = FreePosition::ContactAngle(angle);
    let bearing = Bearing {
        geometry: Geometry::new(21, 0.8125 * INCH, 6.2008 * INCH, free, 0.52, 0.52)
            .expect("a bearing"),
        ring_material: steel,
        ball_material: steel,
        ..bearing("7205C")
    };
    let constant = bearing.load_deflection_constant().expect("a contact");
    // Q = K_n δ^(3/2)
    let approach = (pounds * POUND / constant).powf(2.0 / 3.0);
    let place = [
        approach * angle.cos(),
        0.0,
        approach * angle.sin(),
        0.0,
        0.0,
    ];
    let ball = state_at(&mounted(bearing), place, 0.0).balls[0].clone();
    // the line of contact keeps its direction
    assert_near("α", ball.inner.angle, angle, 1e-14);
    assert_near("δ", ball.deformation, approach, 1e-12 * INCH);
    [ball.inner, ball.outer]
}

#[track_caller]
fn assert_mindel(name: &str, value: f64, expected: f64) {
    assert_near(name, value, expected, MINDEL_DIGITS * expected);
}

#[test]
fn harris_and_mindel_outer_race() {
    let [_, outer] = harris_mindel(571.07, 14.475);
    assert_mindel("a, in", outer.semi_major / INCH, 0.096824);
    assert_mindel("b, in", outer.semi_minor / INCH, 0.012801);
    assert_mindel("p_max, psi", outer.peak_pressure / PSI, 2.1999e5);
}

#[test]
fn harris_and_mindel_inner_race() {
    let [inner, _] = harris_mindel(287.76, 29.762);
    assert_mindel("a, in", inner.semi_major / INCH, 0.078504);
    assert_mindel("b, in", inner.semi_minor / INCH, 0.0089653);
    assert_mindel("p_max, psi", inner.peak_pressure / PSI, 1.9522e5);
    assert_mindel("δ, in", inner.approach / INCH, 4.0335e-4);
}

#[test]
fn without_oil_the_approaches_are_the_deformation() {
    let state = state_under_thrust(&mounted(bearing("7205C")), 1000.0, 0.0);
    for ball in &state.balls {
        let sum = ball.inner.approach + ball.outer.approach;
        assert_near("δ", sum, ball.deformation, 1e-12 * ball.deformation);
        for contact in [ball.inner, ball.outer] {
            // Q = K δ^(3/2): dQ/dδ = 3/2 Q/δ
            let slope = 1.5 * contact.load / contact.approach;
            assert_near("k", contact.contact_stiffness, slope, 1e-12 * slope);
        }
    }
}

#[test]
fn azimuths_go_round_from_the_first_ball() {
    let first = MountedBearing {
        first_ball: 0.25,
        ..mounted(bearing("7205C"))
    };
    let balls = state_under_thrust(&first, 100.0, 0.0).balls;
    assert_eq!(balls.len(), 12);
    for (number, ball) in balls.iter().enumerate() {
        let expected = 0.25 + std::f64::consts::TAU * number as f64 / 12.0;
        assert_near("φ", ball.azimuth, expected, 1e-15);
    }
}

#[test]
fn a_given_stiffness_leaves_the_ellipse_to_the_geometry() {
    let literature = literature_bearing(8, [11.9062e-3, 52.0e-3], 0.0, 8.37536e9);
    let ball = state_at(&mounted(literature), [10e-6, 0.0, 0.0, 0.0, 0.0], 0.0).balls[0].clone();
    // Q = K_n δ^(3/2) of the given constant
    let load = 8.37536e9 * 10e-6f64.powf(1.5);
    assert_near("Q", ball.inner.load, load, 1e-12 * load);
    let contact = literature.inner_contact().expect("a contact");
    assert_near(
        "p_max",
        ball.inner.peak_pressure,
        contact.ellipse(load).peak_pressure,
        1e-3,
    );
}

#[test]
fn static_safety_is_one_where_a_contact_reaches_4200_megapascal() {
    let bearing = bearing("7205C");
    let permissible = [bearing.inner_contact(), bearing.outer_contact()]
        .map(|contact| permissible_static_load(&contact.expect("a contact")));
    let state = state_under_thrust(&mounted(bearing), 1000.0, 0.0);
    let safety = state.static_safety.expect("a loaded bearing");
    let weaker = permissible[0].min(permissible[1]);
    let expected = weaker / state.balls[0].inner.load;
    assert_near("safety", safety, expected, 1e-12 * expected);
    let largest = f64::max(
        state.balls[0].inner.peak_pressure,
        state.balls[0].outer.peak_pressure,
    );
    // p grows as Q^(1/3)
    assert_near("p", largest * safety.cbrt(), 4.2e9, 1.0);
}

#[test]
fn an_unloaded_bearing_has_no_life_safety_or_angle() {
    let state = state_at(
        &mounted(bearing("7205C")),
        [0.0, 0.0, -1e-6, 0.0, 0.0],
        500.0,
    );
    assert_eq!(state.balls_loaded, 0);
    assert_eq!(state.life, None);
    assert_eq!(state.static_safety, None);
    assert_eq!(state.friction_moment.total(), 0.0);
    assert!(state.warnings.is_empty());
    for ball in &state.balls {
        assert!(ball.deformation < 0.0);
        assert_eq!(
            ball.inner,
            RaceContact {
                angle: ball.inner.angle,
                ..Default::default()
            }
        );
    }
}
