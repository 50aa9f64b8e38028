//! Limits and symmetries that every law must have.

use crate::bearing::{Ball, BallLaw, Bearing, ForceLaw, HertzFilmLaw, JonesFilmLaw, JonesLaw, Oil};
use crate::physics::RaceControl;
use proptest::prelude::*;

use super::random::Random;
use super::{OIL, bearing_7205c};

/// Q and α of Hertz contacts in series, no film, no inertia.
fn hertz(bearing: &Bearing, axial: f64, radial: f64) -> (f64, f64) {
    let approach = axial.hypot(radial) - bearing.geometry.groove_centre_distance();
    let load = bearing.load_deflection_constant().unwrap() * approach.max(0.0).powf(1.5);
    (load, axial.atan2(radial))
}

#[test]
fn at_rest_jones_is_hertz() {
    let mut random = Random::new(6);
    for _ in 0..5_000 {
        let case = random.case();
        let (load, angle) = hertz(&case.bearing, case.axial, case.radial);
        let stiffness = case.bearing.load_deflection_constant().unwrap();
        // what rounding leaves: groove factors near 1 are rounded to ε, distances are ε D
        let rounding = 2.0 * f64::EPSILON * case.bearing.geometry.ball_diameter();
        let approach = (load / stiffness).cbrt().powi(2) + rounding;
        let round_off = stiffness * approach.powf(1.5) - load;
        for control in [RaceControl::Outer, RaceControl::Inner, RaceControl::Even] {
            let law = JonesLaw::new(&case.bearing, control).unwrap();
            let contact = law.contact(&Ball::at(case.axial, case.radial), 0.0);
            assert!((contact.load_inner - load).abs() <= 1e-13 * load + round_off);
            assert!((contact.load_outer - load).abs() <= 1e-13 * load + round_off);
            if load > 1e-3 {
                assert!((contact.angle_inner - angle).abs() < 1e-9);
                assert!((contact.angle_outer - angle).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn at_rest_a_film_law_is_its_dry_law() {
    let mut random = Random::new(7);
    for _ in 0..2_000 {
        let case = random.case();
        let place = (case.axial, case.radial, 0.0);
        let dry = JonesLaw::new(&case.bearing, RaceControl::Outer).unwrap();
        let film = JonesFilmLaw::with_film(&case.bearing, RaceControl::Outer, OIL, 100.0).unwrap();
        assert_eq!(
            dry.force_and_tangent(place.0, place.1, place.2),
            film.force_and_tangent(place.0, place.1, place.2)
        );
        let hertz_film = HertzFilmLaw::with_film(&case.bearing, OIL, 100.0).unwrap();
        let (load, _) = hertz(&case.bearing, case.axial, case.radial);
        let contact = hertz_film.contact(&Ball::at(place.0, place.1), place.2);
        assert!((contact.load_inner - load).abs() <= 1e-12 * load + 1e-9);
    }
}

#[test]
fn a_thin_film_changes_nothing() {
    let bearing = bearing_7205c();
    let water_thin = Oil {
        viscosity: 1e-15,
        pressure_viscosity: 1e-15,
    };
    let geometry = &bearing.geometry;
    let (axial, radial) = (geometry.free_axial() + 20e-6, geometry.free_radial());
    let dry = JonesLaw::new(&bearing, RaceControl::Outer).unwrap();
    let film = JonesFilmLaw::with_film(&bearing, RaceControl::Outer, water_thin, 1e3).unwrap();
    let (dry, film) = (
        dry.force(&Ball::at(axial, radial), 1e3),
        film.force(&Ball::at(axial, radial), 1e3),
    );
    assert!((dry.axial / film.axial - 1.0).abs() < 1e-6);
    assert!((dry.radial / film.radial - 1.0).abs() < 1e-6);
}

/// Small speeds approach the law at rest as ω².
#[test]
fn inertia_vanishes_with_the_square_of_speed() {
    let bearing = bearing_7205c();
    let geometry = &bearing.geometry;
    let (axial, radial) = (geometry.free_axial() + 20e-6, geometry.free_radial());
    let law = JonesLaw::new(&bearing, RaceControl::Outer).unwrap();
    let at = |speed: f64| law.contact(&Ball::at(axial, radial), speed);
    let difference = |speed: f64| at(speed).angle_inner - at(speed).angle_outer;
    assert!((difference(20.0) / difference(10.0) - 4.0).abs() < 1e-3);
}

/// Thrown off the inner race, a ball rests on the outer race alone, pressed by F_c only.
#[test]
fn a_ball_without_inner_contact_rests_on_the_outer_race() {
    let bearing = bearing_7205c();
    let geometry = &bearing.geometry;
    let (axial, radial) = (geometry.free_axial(), geometry.free_radial() - 60e-6);
    for control in [RaceControl::Outer, RaceControl::Inner, RaceControl::Even] {
        let law = JonesLaw::new(&bearing, control).unwrap();
        let state = law
            .state(&Ball::at(axial, radial), 3000.0)
            .expect("a law with inertia");
        let contact = state.contact;
        assert_eq!((contact.load_inner, contact.angle_outer), (0.0, 0.0));
        assert!((contact.load_outer / state.centrifugal_force - 1.0).abs() < 1e-13);
        assert_eq!(state.gyroscopic_moment, 0.0);
        let (force, tangent) = law.force_and_tangent(axial, radial, 3000.0);
        assert_eq!((force.axial, force.radial, force.couple), (0.0, 0.0, 0.0));
        assert_eq!(tangent, [[0.0; 2]; 3]);
    }
}

/// Through lift-off the load of a lubricated ball falls without end, never to nothing at once.
#[test]
fn the_film_law_is_monotone_through_lift_off() {
    let bearing = bearing_7205c();
    let geometry = &bearing.geometry;
    let law = HertzFilmLaw::with_film(&bearing, OIL, 1000.0).unwrap();
    let mut last = f64::INFINITY;
    for step in 0..4_000 {
        let radial = geometry.free_radial() + 20e-6 - f64::from(step) * 5e-8;
        let load = law
            .contact(&Ball::at(geometry.free_axial(), radial), 1000.0)
            .load_inner;
        assert!(
            load > 0.0 && load < last,
            "at step {step}: {load:e} after {last:e}"
        );
        last = load;
    }
    assert!(last < 1e-20);
}

#[test]
fn a_law_prepared_for_another_speed_is_the_same_law() {
    let bearing = bearing_7205c();
    let geometry = &bearing.geometry;
    let (axial, radial) = (geometry.free_axial() + 10e-6, geometry.free_radial());
    let here = HertzFilmLaw::with_film(&bearing, OIL, 700.0).unwrap();
    let there = HertzFilmLaw::with_film(&bearing, OIL, 50.0).unwrap();
    assert_eq!(
        here.force(&Ball::at(axial, radial), 700.0),
        there.force(&Ball::at(axial, radial), 700.0)
    );
    assert_eq!(
        here.force(&Ball::at(axial, radial), -700.0),
        there.force(&Ball::at(axial, radial), 700.0)
    );
}

proptest! {
    /// Mirrored along the shaft, the axial force and the couple change sign and nothing else.
    #[test]
    fn mirrored_position_mirrored_force(seed in 1u64..u64::MAX) {
        let case = Random::new(seed).case();
        for control in [RaceControl::Outer, RaceControl::Inner, RaceControl::Even] {
            let law = JonesFilmLaw::with_film(&case.bearing, control, OIL, case.speed).unwrap();
            let (force, tangent) = law.force_and_tangent(case.axial, case.radial, case.speed);
            let (mirror, mirrored) = law.force_and_tangent(-case.axial, case.radial, case.speed);
            prop_assert_eq!(mirror.axial, -force.axial);
            prop_assert_eq!(mirror.radial, force.radial);
            prop_assert_eq!(mirror.couple, -force.couple);
            prop_assert_eq!(mirrored[0][0], tangent[0][0]);
            prop_assert_eq!(mirrored[1][0], -tangent[1][0]);
            prop_assert_eq!(mirrored[2][1], -tangent[2][1]);
        }
    }
}
