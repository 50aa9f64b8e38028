//! Exponential collocation where it is meant for: a fast linear oscillation under a slow drive.

use std::sync::atomic::AtomicBool;

use crate::integrate::{Counters, Grid, Integration, Method, Scaling, Settings, States, System};
use crate::rotor::{Freedoms, Rotor, RotorDefinition, Sample};
use crate::simulate::Model;
use nalgebra::DMatrix;

use crate::tests::support::{model, samples, settings, shaft, thrust_rotor};

/// q″ + 2ζω q′ + ω² q = ω² (1 + sin Ωt): at rest about one, and driven slowly.
struct Oscillator {
    natural: f64,
    damping_ratio: f64,
    drive: f64,
}

impl System for Oscillator {
    fn states(&self) -> usize {
        2
    }

    fn derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let push = 1.0 + (self.drive * time).sin();
        let square = self.natural * self.natural;
        let brake = 2.0 * self.damping_ratio * self.natural * state[1];
        rate[0] = state[1];
        rate[1] = square * (push - state[0]) - brake;
    }

    fn linearisation(&self, _time: f64, _state: &[f64], jacobian: &mut DMatrix<f64>) {
        let square = self.natural * self.natural;
        let brake = -2.0 * self.damping_ratio * self.natural;
        jacobian.copy_from_slice(&[0.0, -square, 1.0, brake]);
    }

    fn rate_by_time(&self, time: f64, _state: &[f64], by_time: &mut [f64]) {
        let square = self.natural * self.natural;
        let change = square * self.drive * (self.drive * time).cos();
        by_time.copy_from_slice(&[0.0, change]);
    }
}

impl Oscillator {
    /// The motion from a place at rest, in closed form.
    fn place(&self, start: f64, time: f64) -> f64 {
        let Self {
            natural,
            damping_ratio,
            drive,
        } = *self;
        // steady: a sin Ωt + b cos Ωt
        let (stiff, loss) = (
            natural * natural - drive * drive,
            2.0 * damping_ratio * natural * drive,
        );
        let size = natural * natural / (stiff * stiff + loss * loss);
        let (sine, cosine) = (size * stiff, -size * loss);
        let (decay, turn) = (
            damping_ratio * natural,
            natural * (1.0 - damping_ratio * damping_ratio).sqrt(),
        );
        let free = start - 1.0 - cosine;
        let free_speed = (decay * free - drive * sine) / turn;
        let (sin, cos) = (turn * time).sin_cos();
        1.0 + sine * (drive * time).sin()
            + cosine * (drive * time).cos()
            + (-decay * time).exp() * (free * cos + free_speed * sin)
    }

    /// Largest error of the place over the samples, and the work, from a place at rest.
    fn error(&self, start: f64, grid: Grid, tolerance: f64) -> (f64, Counters) {
        let scaling = Scaling {
            origin: vec![0.0; 2],
            scale: vec![1.0, self.natural],
            time: 1.0 / self.natural,
        };
        let (stop, settings) = (
            AtomicBool::new(false),
            Settings {
                method: Method::Exponential,
                tolerance,
                step_limit: 1_000_000,
            },
        );
        let mut integration = Integration::new(self, scaling, grid, settings, &stop, &[start, 0.0]);
        let mut states = States::new(2);
        while integration.done() < grid.count {
            integration.advance(100, &mut states).expect("no trouble");
        }
        let off = |(index, state): (usize, &[f64])| {
            (state[0] - self.place(start, grid.time(index as u64))).abs()
        };
        let error = states.iter().enumerate().map(off).fold(0.0, f64::max);
        (error, integration.counters())
    }
}

/// Half a second of a shaft with a natural frequency of 5000 rad/s.
const HALF_A_SECOND: Grid = Grid {
    interval: 1e-4,
    count: 5001,
};

/// A free oscillation is exact whatever the steps: they grow without bound, and the samples within
/// them are right in the middle of it.
#[test]
fn a_linear_shaft_under_a_constant_force_is_exact_to_round_off() {
    let shaft = Oscillator {
        natural: 5000.0,
        damping_ratio: 0.002,
        drive: 0.0,
    };
    for tolerance in [1e-2, 1e-8] {
        let (error, work) = shaft.error(0.0, HALF_A_SECOND, tolerance);
        println!("{error:e} {work:?}");
        assert!(error < 1e-11, "{error:e}");
        assert!(work.steps < 20 && work.rejected == 0, "{work:?}");
    }
}

/// The drive decides how long the steps are, not the natural frequency, even where a free oscillation
/// goes on beside it.
#[test]
fn steps_follow_the_drive_and_not_the_natural_frequency() {
    let of = |natural: f64, damping_ratio: f64| Oscillator {
        natural,
        damping_ratio,
        drive: 100.0,
    };
    for tolerance in [1e-4, 1e-6, 1e-9] {
        let work = [1000.0, 10_000.0, 100_000.0].map(|natural| {
            let (error, work) = of(natural, 0.02).error(1.0, HALF_A_SECOND, tolerance);
            println!("{tolerance:e} {natural}: {error:e} {work:?}");
            assert!(error < 10.0 * tolerance, "{natural}: {error:e}");
            work.steps as f64
        });
        assert!(work[2] < 1.5 * work[0], "{work:?}");
    }
}

/// Settled motion of 7205C at a speed by a method, and its evaluations over 0.1 s.
fn settled(speed: f64, method: Method, tolerance: f64) -> (Vec<Sample>, u64) {
    let run = |duration: f64| {
        let mut shaft = shaft(Freedoms::Translational);
        (shaft.eccentricity, shaft.gravity) = (1e-5, true);
        let definition = RotorDefinition {
            shaft,
            speed,
            ..thrust_rotor()
        };
        let mut model = model(definition, duration, 128.0 * speed / std::f64::consts::TAU);
        model.integrator.method = method;
        model.integrator.tolerance = tolerance;
        model
    };
    let evaluations = |model: &Model| {
        let run = crate::tests::support::simulate_into(
            model,
            &mut crate::tests::support::Collector::default(),
        );
        run.expect("a run").counters.evaluations
    };
    let (short, long) = (run(0.3), run(0.4));
    let work = evaluations(&long) - evaluations(&short);
    (samples(&long, 0.3), work)
}

/// Largest distance of two traces over the largest excursion of the first from its mean place.
fn apart(left: &[Sample], right: &[Sample], rest: &Rotor) -> f64 {
    let rest = rest.equilibrium().displacement;
    let largest = |other: &dyn Fn(usize, usize) -> f64| {
        let of = |index: usize| {
            (0..3).map(move |axis| (left[index].displacement[axis] - other(index, axis)).abs())
        };
        (0..left.len()).flat_map(of).fold(0.0, f64::max)
    };
    largest(&|index, axis| right[index].displacement[axis]) / largest(&|_, axis| rest[axis])
}

/// To an error of 1e-6 of the settled motion the exponential method takes a fifth of the evaluations of
/// Dormand–Prince 8(5,3) up to 200 rad/s, and less than a half at 500 rad/s.
#[test]
fn settled_motion_costs_a_fraction_of_an_explicit_method() {
    for (speed, factor) in [(100.0, 5.0), (200.0, 5.0), (500.0, 2.5)] {
        let (truth, _) = settled(speed, Method::Dop853, 1e-12);
        let mut shaft = shaft(Freedoms::Translational);
        shaft.gravity = true;
        let definition = RotorDefinition {
            shaft,
            speed,
            ..thrust_rotor()
        };
        let rest = Rotor::assemble(&definition).expect("a rotor");
        let fewest = |method: Method| {
            let tolerances = (4..=18).map(|half| 10.0_f64.powf(-0.5 * f64::from(half)));
            let runs = tolerances.map(|tolerance| settled(speed, method, tolerance));
            let good = runs.filter(|(trace, _)| apart(&truth, trace, &rest) < 1e-6);
            good.map(|(_, work)| work).min().expect("a good run")
        };
        let (exponential, explicit) = (fewest(Method::Exponential), fewest(Method::Dop853));
        println!("{speed} rad/s: {exponential} and {explicit} evaluations");
        assert!(
            factor * exponential as f64 <= explicit as f64,
            "{speed} rad/s: {exponential} and {explicit} evaluations"
        );
    }
}

/// A shaft whose contacts are damped to eigenvalues beyond −1e6 1/s.
fn damped(method: Method, tolerance: f64, duration: f64) -> Model {
    let mut definition = thrust_rotor();
    definition.shaft.eccentricity = 1e-5;
    definition.bearings[0].contact_damping = crate::bearing::ContactDamping {
        inner: 5000.0,
        outer: 5000.0,
    };
    let mut model = model(definition, duration, 10_000.0);
    model.integrator = Settings {
        method,
        ..settings(tolerance)
    };
    model
}

/// Damping of the contacts to eigenvalues beyond −1e6 1/s holds no step, as with the implicit method.
#[test]
fn stiff_damping_of_the_contacts_holds_no_step() {
    let truth = samples(&damped(Method::Rodas, 1e-9, 0.02), 0.0);
    let found = samples(&damped(Method::Exponential, 1e-7, 0.02), 0.0);
    let reach = truth.iter().map(|sample| (sample.displacement[0]).abs());
    let reach = reach.fold(0.0, f64::max);
    let off = truth
        .iter()
        .zip(&found)
        .map(|(a, b)| (a.displacement[0] - b.displacement[0]).abs());
    let off = off.fold(0.0, f64::max);
    assert!(off < 1e-6 * reach, "{off:e} of {reach:e} m");
    let work = |model: &Model| {
        let run = crate::tests::support::simulate_into(
            model,
            &mut crate::tests::support::Collector::default(),
        );
        run.expect("a run").counters
    };
    let (own, implicit) = (
        work(&damped(Method::Exponential, 1e-7, 0.02)),
        work(&damped(Method::Rodas, 1e-7, 0.02)),
    );
    println!("{own:?} {implicit:?}");
    assert!(own.steps < 1000, "{own:?}");
}

/// Under strong damping of the contacts, too, the error is that which is asked for, however loose.
#[test]
fn a_loose_tolerance_is_kept_under_stiff_damping() {
    let truth = samples(&damped(Method::Exponential, 1e-9, 0.2), 0.0);
    let place = |sample: &Sample| [sample.displacement[0], sample.displacement[1]];
    let reach = truth.iter().flat_map(place).map(f64::abs);
    let reach = reach.fold(0.0, f64::max);
    for tolerance in [3e-2, 1e-2, 3e-3, 1e-3] {
        let found = samples(&damped(Method::Exponential, tolerance, 0.2), 0.0);
        let off = truth.iter().zip(&found).flat_map(|(a, b)| {
            let (a, b) = (place(a), place(b));
            [(a[0] - b[0]).abs(), (a[1] - b[1]).abs()]
        });
        let off = off.fold(0.0, f64::max) / reach;
        println!("{tolerance:e}: {off:e}");
        assert!(off < 3.0 * tolerance, "{tolerance:e}: {off:e}");
    }
}
