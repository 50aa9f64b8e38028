//! The tangent of each law is the derivative of its force.

use crate::bearing::{Ball, BallForce, BallLaw, HertzFilmLaw, JonesFilmLaw, JonesLaw};
use crate::physics::RaceControl;

use super::OIL;
use super::random::{Case, Random};

#[test]
fn tangent_of_hertz_with_film() {
    let mut random = Random::new(3);
    for _ in 0..500 {
        let case = random.case();
        let law = HertzFilmLaw::with_film(&case.bearing, OIL, case.speed).unwrap();
        check(&law, &case);
    }
}

#[test]
fn tangent_of_jones() {
    let mut random = Random::new(4);
    for _ in 0..500 {
        let case = random.case();
        for control in [RaceControl::Outer, RaceControl::Inner, RaceControl::Even] {
            check(&JonesLaw::new(&case.bearing, control).unwrap(), &case);
        }
    }
}

#[test]
fn tangent_of_jones_with_film() {
    let mut random = Random::new(5);
    for _ in 0..500 {
        let case = random.case();
        for control in [RaceControl::Outer, RaceControl::Inner, RaceControl::Even] {
            let law = JonesFilmLaw::with_film(&case.bearing, control, OIL, case.speed).unwrap();
            check(&law, &case);
        }
    }
}

/// Compares with a difference quotient of sixth order, in steps that shrink until it agrees: near
/// the edge of contact the force is smooth only on its own scale. Below 1e4 N/m
/// (loaded contacts have 1e7) that scale is less than the shortest step.
fn check(law: &impl BallLaw, case: &Case) {
    let (_, tangent) = law.force_and_tangent(case.axial, case.radial, case.speed);
    let diameter = case.bearing.geometry.ball_diameter();
    for column in 0..2 {
        let along = |step: f64| {
            let (mut axial, mut radial) = (case.axial, case.radial);
            *[&mut axial, &mut radial][column] += step;
            components(law.force(&Ball::at(axial, radial), case.speed), diameter)
        };
        let exact = [
            tangent[0][column],
            tangent[1][column],
            tangent[2][column] / diameter,
        ];
        let mut best = f64::INFINITY;
        for exponent in 4..10 {
            let step = diameter * 10f64.powi(-exponent);
            let error = quotient_error(&along, exact, step);
            best = best.min(error);
        }
        let scale = tangent
            .as_flattened()
            .iter()
            .fold(1e4, |s, x| x.abs().max(s));
        assert!(
            best <= 1e-5 * scale,
            "column {column}: off by {best:e} of {scale:e} N/m at {} {} {}",
            case.axial,
            case.radial,
            case.speed
        );
    }
}

fn components(force: BallForce, diameter: f64) -> [f64; 3] {
    [force.axial, force.radial, force.couple / diameter]
}

fn quotient_error(along: &impl Fn(f64) -> [f64; 3], exact: [f64; 3], step: f64) -> f64 {
    let pair = |k: f64| {
        let (up, down) = (along(k * step), along(-k * step));
        [0, 1, 2].map(|row| (up[row] - down[row]) / (2.0 * k * step))
    };
    let [one, two, three] = [pair(1.0), pair(2.0), pair(3.0)];
    let errors = [0, 1, 2].map(|row| {
        // f' = (15 d₁ − 6 d₂ + d₃)/10, d_k the central quotient over k steps
        ((15.0 * one[row] - 6.0 * two[row] + three[row]) / 10.0 - exact[row]).abs()
    });
    errors[0].max(errors[1]).max(errors[2])
}
