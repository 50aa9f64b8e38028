use std::f64::consts::{PI, TAU};

use super::*;
use crate::bearing::BearingRotation;

fn motion(displacement: [f64; 2], rate: [f64; 2], speed: f64) -> ElementMotion {
    let all = |[x, y]: [f64; 2]| [x, y, 0.0, 0.0, 0.0];
    ElementMotion {
        displacement: all(displacement),
        rate: all(rate),
        rotation: BearingRotation::at_start(speed),
    }
}

#[track_caller]
fn close(found: f64, expected: f64, within: f64) {
    assert!(
        (found - expected).abs() <= within,
        "{found:e}, not {expected:e}"
    );
}

/// Central differences of the force by place and by rate, along x and y.
fn differences(law: &dyn ForceLaw, at: &ElementMotion, steps: [f64; 2]) -> [[[f64; 2]; 2]; 2] {
    let moved = |which: usize, axis: usize, step: f64| {
        let mut moved = *at;
        match which {
            0 => moved.displacement[axis] += step,
            _ => moved.rate[axis] += step,
        }
        law.force(&moved)
    };
    [0, 1].map(|which| {
        [0, 1].map(|row| {
            [0, 1].map(|column| {
                let step = steps[which];
                (moved(which, column, step)[row] - moved(which, column, -step)[row]) / (2.0 * step)
            })
        })
    })
}

#[track_caller]
fn slopes_are_differences(law: &dyn ForceLaw, at: &ElementMotion, steps: [f64; 2]) {
    let slopes = law.slopes(at);
    let differences = differences(law, at, steps);
    let force = law.force(at)[0].hypot(law.force(at)[1]);
    for ((slopes, differences), step) in slopes.iter().zip(&differences).zip(steps) {
        let round_off = 4.0 * f64::EPSILON * force / step;
        let largest = slopes.amax();
        for row in 0..2 {
            for column in 0..2 {
                close(
                    slopes[(row, column)],
                    differences[row][column],
                    1e-6 * largest + round_off,
                );
            }
        }
    }
}

const FILM: SqueezeFilm = SqueezeFilm {
    radius: 0.06,
    length: 0.03,
    clearance: 1e-4,
    viscosity: 0.01,
};

/// μ R L³/c³, N s/m.
const SIZE: f64 = 0.01 * 0.06 * 0.03 * 0.03 * 0.03 / 1e-12;

#[test]
fn a_film_on_a_circle_presses_by_the_closed_form() {
    for e in [1e-6_f64, 0.2, 0.7, 0.98] {
        let (distance, speed) = (e * 1e-4, 800.0);
        let force = FILM.force(&motion([0.0, distance], [-speed * distance, 0.0], 300.0));
        let rest = 1.0 - e * e;
        let tangential = SIZE * 1e-4 * speed * e * PI / (2.0 * rest.powf(1.5));
        let radial = SIZE * 1e-4 * speed * 2.0 * e * e / (rest * rest);
        // the ring presses outwards and, as it goes from +y to −x, that way
        close(force[0], -tangential, 1e-12 * tangential);
        close(force[1], radial, 1e-12 * tangential.max(radial));
    }
}

/// Reynolds's equation of a short film integrated around the ring, the pressure zero where it would be negative.
#[test]
fn a_film_in_any_motion_presses_by_its_pressure() {
    let steps = 20_000;
    for (place, rate) in [
        ([3e-5, -4e-5], [0.02, 0.05]),
        ([-7e-5, 2e-5], [0.03, 0.001]),
        ([0.0, 0.0], [-0.01, 0.02]),
        ([6e-5, 6e-5], [-0.04, 0.01]),
    ] {
        let mut sum = [0.0; 2];
        for step in 0..steps {
            let angle = TAU * (f64::from(step) + 0.5) / f64::from(steps);
            let n = [angle.cos(), angle.sin()];
            let height = 1e-4 - place[0] * n[0] - place[1] * n[1];
            let squeezed = (rate[0] * n[0] + rate[1] * n[1]).max(0.0);
            let pressure = 0.01 * 0.03_f64.powi(3) * squeezed / height.powi(3);
            for axis in 0..2 {
                sum[axis] += pressure * n[axis] * 0.06 * TAU / f64::from(steps);
            }
        }
        let force = FILM.force(&motion(place, rate, 0.0));
        let size = sum[0].hypot(sum[1]);
        for axis in 0..2 {
            close(force[axis], sum[axis], 1e-7 * size);
        }
        slopes_are_differences(&FILM, &motion(place, rate, 0.0), [1e-10, 1e-6]);
    }
}

/// A film at rest may cavitate on either side: its damping is the mean of both, and about the centre that of either.
#[test]
fn a_film_at_rest_damps_by_the_mean_of_both_sides() {
    let [_, about_centre] = FILM.slopes(&motion([0.0; 2], [0.0; 2], 0.0));
    close(about_centre[(0, 0)], 0.5 * PI * SIZE, 1e-12 * SIZE);
    let place = [5e-5, 2e-5];
    let [stiffness, at_rest] = FILM.slopes(&motion(place, [0.0; 2], 0.0));
    assert_eq!(stiffness.amax(), 0.0);
    let sides =
        [1.0, -1.0].map(|side| FILM.slopes(&motion(place, [side * 0.01, side * 0.02], 0.0))[1]);
    let mean = 0.5 * (sides[0] + sides[1]);
    close((at_rest - mean).amax(), 0.0, 1e-12 * mean.amax());
}

const RUB: Rub = Rub {
    clearance: 1e-4,
    stiffness: 2e7,
    friction: 0.15,
    radius: 0.03,
};

#[test]
fn a_rub_presses_across_and_along_and_asks_the_rotation() {
    // pressed in by 20 µm in the direction of 30°, the surface sliding forward
    let n = [0.75_f64.sqrt(), 0.5];
    let at = motion([1.2e-4 * n[0], 1.2e-4 * n[1]], [0.0; 2], 300.0);
    let force = RUB.force(&at);
    let normal = 2e7 * 2e-5;
    close(force[0], normal * (n[0] - 0.15 * n[1]), 1e-6);
    close(force[1], normal * (n[1] + 0.15 * n[0]), 1e-6);
    close(RUB.resisting_moment(&at), 0.03 * 0.15 * normal, 1e-6);
    let (energy, elastic) = RUB.elastic(&at.displacement);
    close(energy, 0.5 * normal * 2e-5, 1e-12);
    close(elastic[0], normal * n[0], 1e-9);
    close(
        RUB.past_event(&at.displacement).expect("an event"),
        2e-5,
        1e-17,
    );
    let open = motion([9.9e-5, 0.0], [0.0; 2], 300.0);
    assert_eq!(RUB.force(&open), [0.0; 5]);
}

/// Where the surface rolls on the ring, friction changes its sign within a creep.
#[test]
fn slopes_of_a_rub_are_those_of_its_force() {
    for (rate, speed) in [
        ([0.3, -0.2], 300.0),
        ([0.0, 0.0], 0.0),
        ([-4.5e-4, 1e-4], 1e-3),
    ] {
        slopes_are_differences(&RUB, &motion([8e-5, 9e-5], rate, speed), [1e-10, 1e-8]);
    }
}
