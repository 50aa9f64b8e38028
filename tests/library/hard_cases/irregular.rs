//! Motion that never repeats: two runs part, however exact they are. What can be asked of it is its
//! statistics, and how fast runs part.
//!
//! JIS 6306 of the literature's varying compliance (K_n = 1.334e10 N/m^1.5, 20 kg, c = 200 N s/m,
//! W = 196 N), here with a radial clearance of 20 µm at 120 rad/s.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::bearing::MountedBearing;
use crate::integrate::Method;
use crate::rotor::{Damping, Freedoms, RotorDefinition, Sample, Shaft};

use crate::tests::support::{
    assert_near, constant, literature_bearing, model, mounted, peak_to_peak, rotor, samples,
    settings, shaft,
};

const MASS: f64 = 20.0;
const DAMPING: f64 = 200.0;

/// A speed in rad/s and a radial clearance in m.
#[derive(Clone, Copy)]
struct Scene {
    speed: f64,
    clearance: f64,
}

/// x, y and their velocities.
type State = [f64; 4];

/// A rate in 1/s, seen over a time in s.
struct Exponent {
    rate: f64,
    time: f64,
}

impl Scene {
    fn definition(self) -> RotorDefinition {
        let diameters = [11.9062e-3, 52.0e-3];
        let bearing = literature_bearing(8, diameters, self.clearance, 1.334e10);
        RotorDefinition {
            speed: self.speed,
            damping: Damping::Coefficients([DAMPING, DAMPING, 0.0, 0.0, 0.0]),
            loads: constant([0.0, -196.0, 0.0, 0.0, 0.0]),
            ..rotor(
                Shaft {
                    mass: MASS,
                    ..shaft(Freedoms::Radial)
                },
                vec![MountedBearing {
                    first_ball: -FRAC_PI_2,
                    ..mounted(bearing)
                }],
            )
        }
    }

    /// Time of one ball pass, s.
    fn pass(self) -> f64 {
        TAU / (4.0 * self.speed * (1.0 - 11.9062 / 52.0))
    }

    /// State so many whole ball passes after a state: the balls then stand as they did.
    fn after(self, passes: f64, [x, y, u, v]: State) -> State {
        let mut definition = self.definition();
        definition.initial.displacement = [Some(x), Some(y), None, None, None];
        definition.initial.velocity = [Some(u), Some(v), None, None, None];
        let duration = passes * self.pass();
        let model = model(definition, duration, 1.0 / duration);
        let last = samples(&model, 0.5 * duration).pop().expect("the end");
        let ([x, y, ..], [u, v, ..]) = (last.displacement, last.velocity);
        [x, y, u, v]
    }

    /// Growth of the logarithm of a small distance a second: the largest Lyapunov exponent.
    ///
    /// Two runs start side by side and are compared after every few ball passes; the second one is
    /// then put back to its first distance from the other, in the direction that it had parted to.
    ///
    /// Source: G. Benettin, L. Galgani & J.-M. Strelcyn, *Phys. Rev. A* 14 (1976) 2338–2345.
    fn exponent(self) -> Exponent {
        const DISTANCE: f64 = 1e-10;
        const PASSES: f64 = 4.0;
        let (settling, stretches) = (20, 120);
        // a velocity counts as a length by the time of a vibration
        let unit = |index: usize| if index < 2 { 1.0 } else { 500.0 };
        let mut state = self.after(300.0, [0.0, -self.clearance - 6e-6, 0.0, 0.0]);
        let mut other = state;
        other[0] += DISTANCE;
        let mut growth = 0.0;
        let time = f64::from(stretches - settling) * PASSES * self.pass();
        for stretch in 0..stretches {
            (state, other) = (self.after(PASSES, state), self.after(PASSES, other));
            let part = |index: usize| (other[index] - state[index]) / unit(index);
            let distance = (0..4).map(|index| part(index).powi(2)).sum::<f64>().sqrt();
            if stretch >= settling {
                growth += (distance / DISTANCE).ln();
            }
            let shrink = DISTANCE / distance;
            other = std::array::from_fn(|i| state[i] + shrink * (other[i] - state[i]));
        }
        Exponent {
            rate: growth / time,
            time,
        }
    }
}

const IRREGULAR: Scene = Scene {
    speed: 120.0,
    clearance: 20e-6,
};

#[test]
fn runs_side_by_side_part_where_the_motion_is_irregular() {
    let exponent = IRREGULAR.exponent().rate;
    println!(
        "{exponent} 1/s, {} a ball pass",
        exponent * IRREGULAR.pass()
    );
    // a distance grows tenfold in some 100 ms
    assert!((18.0..28.0).contains(&exponent), "{exponent}");
}

/// Where the motion repeats, runs come together as fast as damping lets a free vibration die:
/// e^(−ct/2m), for a state in four dimensions that shrinks by e^(−2ct/m) in all.
#[test]
fn runs_that_start_side_by_side_join_where_the_motion_repeats() {
    for scene in [
        Scene {
            speed: 200.0,
            clearance: 3e-6,
        },
        Scene {
            speed: 250.0,
            clearance: 10e-6,
        },
    ] {
        let expected = -DAMPING / (2.0 * MASS);
        let exponent = scene.exponent();
        println!("{} 1/s over {} s", exponent.rate, exponent.time);
        // the distance turns between place and velocity, which it counts by a fixed frequency: at
        // the end it may be seen four times larger or smaller than at the start
        let phase = 4.0_f64.ln() / exponent.time;
        assert_near("exponent", exponent.rate, expected, phase);
    }
}

/// Number of parts that a run is cut into to see how far their averages scatter.
const PARTS: usize = 20;

/// Average and its standard error, from the scatter of the averages of parts.
fn average(values: &[f64]) -> [f64; 2] {
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let parts: Vec<f64> = values
        .chunks_exact(values.len() / PARTS)
        .map(mean)
        .collect();
    let whole = mean(&parts);
    let squares: Vec<f64> = parts.iter().map(|part| (part - whole).powi(2)).collect();
    [whole, (mean(&squares) / (PARTS - 1) as f64).sqrt()]
}

/// Displacement along an axis and its square about the mean, each averaged; peak to peak.
fn statistics(samples: &[Sample], axis: usize) -> ([[f64; 2]; 2], f64) {
    let values: Vec<f64> = samples.iter().map(|s| s.displacement[axis]).collect();
    let mean = average(&values);
    let squares: Vec<f64> = values
        .iter()
        .map(|value| (value - mean[0]).powi(2))
        .collect();
    ([mean, average(&squares)], peak_to_peak(values.into_iter()))
}

/// Other tolerances and other methods follow other trajectories of the same motion: displacements
/// differ by as much as there is, while averages over four thousand ball passes agree as far as they
/// are settled, to a few percent, and so do the outermost places.
#[test]
fn irregular_motion_has_the_same_statistics_whatever_the_method() {
    let pass = IRREGULAR.pass();
    let run = |method, tolerance| {
        let mut model = model(IRREGULAR.definition(), 4200.0 * pass, 40.0 / pass);
        model.integrator = settings(tolerance);
        model.integrator.method = method;
        samples(&model, 200.0 * pass)
    };
    let first = run(Method::Dop853, 1e-8);
    for (method, tolerance) in [
        (Method::Dop853, 1e-5),
        (Method::Dopri5, 1e-6),
        (Method::Rodas, 1e-5),
    ] {
        let second = run(method, tolerance);
        for axis in 0..2 {
            let (averages, swing) = statistics(&first, axis);
            let (others, other_swing) = statistics(&second, axis);
            let apart = first.iter().zip(&second);
            let apart = apart.map(|(a, b)| (a.displacement[axis] - b.displacement[axis]).abs());
            let apart = apart.fold(0.0, f64::max);
            assert!(
                apart > 0.5 * swing,
                "trajectories part: {apart:e} of {swing:e}"
            );
            assert_near("peak to peak", other_swing, swing, 0.1 * swing);
            let variance = averages[1][0];
            let pairs = averages.into_iter().zip(others);
            for (([one, error], [other, other_error]), unit) in
                pairs.zip([variance.sqrt(), variance])
            {
                let scatter = error.hypot(other_error);
                println!(
                    "{method:?} {tolerance:e}, axis {axis}: {:.4} ± {:.4}",
                    (other - one) / unit,
                    scatter / unit
                );
                assert!(scatter < 0.05 * unit, "settled: {scatter:e} of {unit:e}");
                // four standard errors
                assert_near("average", other, one, 4.0 * scatter);
            }
        }
    }
}
