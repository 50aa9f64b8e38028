//! Oil films through the state, and the shares of film and contact in the stiffness.

use crate::bearing::{Bearing, ContactLaw, FilmState, MountedBearing, Oil};
use crate::physics::RaceControl;

use super::{OIL, state_at, state_under_thrust};
use crate::tests::support::{assert_near, assert_printed, bearing, mounted};

fn oiled(law: ContactLaw) -> MountedBearing {
    MountedBearing {
        law,
        oil: Some(OIL),
        ..mounted(bearing("7205C"))
    }
}

/// Films at the inner and the outer race of a 7205C with Q = 251.39 N at both.
fn films_at(speed: f64) -> [FilmState; 2] {
    let definition = oiled(ContactLaw::Hertz);
    let angle = 15f64.to_radians();
    let along = |s: f64| [s * angle.cos(), 0.0, s * angle.sin(), 0.0, 0.0];
    // the displacement of ball 0 along its line of contact that gives the load
    let (mut low, mut high) = (0.0, 50e-6);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let load = state_at(&definition, along(middle), speed).balls[0]
            .inner
            .load;
        if load < 251.39 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let ball = state_at(&definition, along(low), speed).balls[0].clone();
    [ball.inner, ball.outer].map(|contact| contact.film.expect("a film"))
}

/// Independent implementations, η0 = 0.04 Pa s, α_p = 22 1/GPa: ω, then h_c and h_min in µm at the
/// inner and the outer race.
#[test]
fn film_thickness_at_500_and_1000_radians_per_second() {
    for (speed, printed) in [
        (1000.0, [["0.8562", "0.7001"], ["1.0237", "0.8293"]]),
        (500.0, [["0.5381", "0.4370"], ["0.6434", "0.5176"]]),
    ] {
        for (film, [central, minimum]) in films_at(speed).into_iter().zip(printed) {
            assert_printed("h_c", film.central * 1e6, central);
            assert_printed("h_min", film.minimum * 1e6, minimum);
            // k = Q/(0.067 h)
            let stiffness = 251.39 / (0.067 * film.central);
            assert_near("k", film.stiffness, stiffness, 1e-9 * stiffness);
            assert_eq!(film.lambda, None);
        }
    }
}

#[test]
fn the_film_ratio_is_the_minimum_over_the_roughness() {
    let definition = MountedBearing {
        bearing: Bearing {
            roughness: Some(0.1e-6),
            ..bearing("7205C")
        },
        ..oiled(ContactLaw::Jones(RaceControl::Outer))
    };
    let ball = state_under_thrust(&definition, 1000.0, 1000.0).balls[0].clone();
    for film in [ball.inner.film, ball.outer.film].map(|film| film.expect("a film")) {
        let lambda = film.lambda.expect("a roughness");
        assert_near("λ", lambda, film.minimum / 0.1e-6, 1e-12);
        assert!(lambda > 6.0);
    }
}

#[test]
fn no_film_without_oil_or_at_rest() {
    for (definition, speed) in [
        (mounted(bearing("7205C")), 1000.0),
        (oiled(ContactLaw::Hertz), 0.0),
        (oiled(ContactLaw::Jones(RaceControl::Outer)), 0.0),
    ] {
        let state = state_under_thrust(&definition, 1000.0, speed);
        assert_eq!(state.shares, None);
        assert_eq!(state.friction_moment.viscous, 0.0);
        for ball in state.balls {
            assert_eq!((ball.inner.film, ball.outer.film), (None, None));
        }
    }
}

/// Approach with oil: d − A is the elastic approach less both films.
#[test]
fn films_and_approaches_make_up_the_deformation() {
    let state = state_under_thrust(&oiled(ContactLaw::Hertz), 1000.0, 1000.0);
    let ball = state.balls[0].clone();
    let [inner, outer] =
        [ball.inner, ball.outer].map(|c| c.approach - c.film.expect("a film").central);
    assert_near("d − A", inner + outer, ball.deformation, 1e-16);
}

/// Pure thrust, all balls alike: K_zz = Z (k sin² α + (Q/d) cos² α).
#[test]
fn along_the_normal_the_compliances_of_contact_and_film_add_up() {
    let state = state_under_thrust(&oiled(ContactLaw::Hertz), 1000.0, 1000.0);
    let shares = state.shares.as_ref().expect("films");
    let ball = &state.balls[0].clone();
    let (sin, cos) = ball.inner.angle.sin_cos();
    let distance = bearing("7205C").geometry.groove_centre_distance() + ball.deformation;
    let across = 12.0 * ball.inner.load / distance * cos * cos;
    let whole = (state.stiffness[(2, 2)] - across) / (sin * sin);
    let contacts = (shares.contacts[(2, 2)] - across) / (sin * sin);
    let films = shares.films[(2, 2)] / (sin * sin);
    assert_near(
        "1/k",
        1.0 / contacts + 1.0 / films,
        1.0 / whole,
        1e-12 / whole,
    );
    // and each is what the lines of the balls say
    let series = |inner: f64, outer: f64| 12.0 / (1.0 / inner + 1.0 / outer);
    let expected = series(ball.inner.contact_stiffness, ball.outer.contact_stiffness);
    assert_near("contacts", contacts, expected, 1e-12 * expected);
    let film = |film: Option<FilmState>| film.expect("a film").stiffness;
    let expected = series(film(ball.inner.film), film(ball.outer.film));
    assert_near("films", films, expected, 1e-12 * expected);
}

/// A film ever thinner is rigid: what is left is the dry bearing, of either law.
#[test]
fn with_a_thin_film_the_contacts_are_the_whole() {
    for law in [ContactLaw::Hertz, ContactLaw::Jones(RaceControl::Outer)] {
        let thin = MountedBearing {
            oil: Some(Oil {
                viscosity: 1e-13,
                ..OIL
            }),
            ..oiled(law)
        };
        let wet = state_under_thrust(&thin, 1000.0, 1000.0);
        let contacts = wet.shares.expect("films").contacts;
        let dry = MountedBearing { oil: None, ..thin };
        let dry = state_under_thrust(&dry, 1000.0, 1000.0).stiffness;
        // the film of 1e-15 m is 1e-9 of the approach
        for (share, whole) in contacts.iter().zip(&dry) {
            assert_near("K", *share, *whole, 1e-8 * whole.abs() + 1e-3);
        }
    }
}
