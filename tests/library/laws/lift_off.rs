//! Where a ball leaves the inner race, the law knows it without its force.

use crate::bearing::{Ball, BallLaw, HertzLaw, JonesLaw, catalogue};
use crate::physics::RaceControl;

/// Places of the inner groove centre about the line of lift-off of a 7205C, m.
fn places() -> impl Iterator<Item = [f64; 2]> {
    let grid = |steps: i32| (-steps..=steps).map(move |step| f64::from(step) / f64::from(steps));
    grid(9).flat_map(move |along| {
        grid(500).map(move |across| {
            let (angle, length) = (0.35 + 0.3 * along, 396.9e-6 + 12e-6 * across);
            [length * angle.sin(), length * angle.cos()]
        })
    })
}

/// Round-off of the balance of a ball, N, and a distance that makes a load above it, m.
const NOTHING: f64 = 1e-9;
const NEAR: f64 = 1e-11;

/// Number of places at which a ball is pressed; the load, and the law's own word, agree at each.
fn pressed(law: &impl BallLaw, speed: f64) -> usize {
    let mut count = 0;
    for [axial, radial] in places() {
        let past = law.distance_past_lift_off(&Ball::at(axial, radial), 0, speed);
        let load = law.contact(&Ball::at(axial, radial), speed).load_inner;
        let loaded = load > NOTHING;
        if past.abs() > NEAR {
            assert_eq!(past > 0.0, loaded, "{past:e} {load:e} {speed}");
        }
        count += usize::from(loaded);
    }
    count
}

#[test]
fn a_ball_is_loaded_where_it_is_pressed_past_its_lift_off() {
    let bearing = catalogue::find("7205C").unwrap().bearing().unwrap();
    let hertz = HertzLaw::new(
        bearing.load_deflection_constant().unwrap(),
        bearing.geometry.groove_centre_distance(),
    );
    let all = places().count();
    assert!((all / 4..3 * all / 4).contains(&pressed(&hertz, 0.0)));
    for control in [RaceControl::Outer, RaceControl::Inner, RaceControl::Even] {
        let jones = JonesLaw::new(&bearing, control).unwrap();
        for speed in [0.0, 500.0, 2500.0] {
            let pressed = pressed(&jones, speed);
            assert!((1..all).contains(&pressed), "{pressed} of {all}");
        }
    }
}
