//! What the polynomials within a step know.

use super::*;

/// Ends of uneven steps: the start of the latest, its end, and the starts of those before it, s.
const TIMES: [f64; ENDS] = [0.5, 0.8, 0.3, -0.1, -0.35, -0.6];

fn ends(times: &[f64], motion: impl Fn(f64) -> [f64; 3]) -> Vec<End<2>> {
    let end = |&time: &f64| {
        let [place, velocity, acceleration] = motion(time);
        End {
            time,
            place: [place, f64::NAN].into(),
            velocity: [velocity, f64::NAN].into(),
            acceleration: [acceleration, f64::NAN].into(),
        }
    };
    times.iter().map(end).collect()
}

fn through(times: &[f64], motion: impl Fn(f64) -> [f64; 3]) -> Within<2> {
    let ends = ends(times, motion);
    let mut within = Within::NONE;
    within.begin(&ends[0], &ends[1]);
    ends[2..].iter().for_each(|end| within.add(end));
    within
}

/// t^n, its slope and the slope of that.
fn power(n: i32, time: f64) -> [f64; 3] {
    let n_ = f64::from(n);
    [
        time.powi(n),
        n_ * time.powi(n - 1),
        n_ * (n_ - 1.0) * time.powi(n - 2),
    ]
}

#[test]
fn a_power_of_time_is_met_up_to_three_times_the_ends_less_one() {
    for known in 2..=ENDS {
        let degree = 3 * known as i32 - 1;
        for (power_of, exact) in [(degree, true), (degree + 1, false)] {
            let motion = |time| power(power_of, time);
            let within = through(&TIMES[..known], motion);
            let [place, velocity] = within.at(0.62);
            let [true_place, true_velocity, _] = motion(0.62);
            let off = (place - true_place)
                .abs()
                .max((velocity - true_velocity).abs());
            assert_eq!(off < 1e-13, exact, "t^{power_of}, {known} ends: {off:e}");
        }
    }
}

fn swing(time: f64) -> [f64; 3] {
    [time.sin(), time.cos(), -time.sin()]
}

/// Largest error of place or velocity within a step.
fn error(within: &Within<2>, start: f64, size: f64) -> f64 {
    let off = |part: f64| {
        let time = start + part * size;
        let [place, velocity] = within.at(time);
        let [true_place, true_velocity, _] = swing(time);
        (place - true_place)
            .abs()
            .max((velocity - true_velocity).abs())
    };
    (1..20)
        .map(|part| off(0.05 * f64::from(part)))
        .fold(0.0, f64::max)
}

/// Whatever is found good enough is, and of two that are the one of fewer terms is taken.
#[test]
fn what_is_found_exact_enough_is() {
    let (mut found, mut quintics) = (0, 0);
    for size in [0.05, 0.1, 0.2, 0.5, 1.0, 2.0] {
        let times = [0.0, 1.0, -0.8, -2.0, -3.0, -3.8].map(|steps| 1.0 + steps * size);
        let ends = ends(&times, swing);
        for allowed in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
            let mut within = Within::NONE;
            within.begin(&ends[0], &ends[1]);
            let enough = ends[2..].iter().any(|end| {
                within.add(end);
                within.is_within(&[1.0 / allowed; 2])
            });
            if !enough {
                continue;
            }
            let error = error(&within, 1.0, size);
            println!("{size} {allowed:e}: {error:e} of {} terms", within.terms);
            assert!(error < 1.5 * allowed, "{size} {allowed:e}: {error:e}");
            found += 1;
            quintics += usize::from(within.terms == QUINTIC);
        }
    }
    assert!(
        found > 15 && (3..found).contains(&quintics),
        "{found} {quintics}"
    );
}
