//! Steps that land on the surfaces at which a derivative is not smooth: a ball that bounces on an elastic ground, whose
//! energy is known.

use std::sync::atomic::AtomicBool;

use crate::integrate::{Counters, Grid, Integration, Method, Scaling, Settings, States, System};
use nalgebra::DMatrix;

/// y″ = −1 + K max(−y, 0)^n, as (y, y′).
struct Bouncing {
    exponent: f64,
    /// Whether the integration is told of the ground.
    told: bool,
}

const STIFFNESS: f64 = 1e3;

/// An elastic sphere on an elastic ground.
const SPHERE: Bouncing = Bouncing {
    exponent: 1.5,
    told: true,
};
/// A body on a spring that it leaves.
const SPRING: Bouncing = Bouncing {
    exponent: 1.0,
    told: true,
};

impl Bouncing {
    fn load(&self, depth: f64) -> f64 {
        STIFFNESS * depth.max(0.0).powf(self.exponent)
    }

    /// ½ v² + y + K max(−y, 0)^(n+1)/(n + 1)
    fn energy(&self, state: &[f64]) -> f64 {
        let [place, speed] = [state[0], state[1]];
        let depth = (-place).max(0.0);
        0.5 * speed * speed + place + depth * self.load(depth) / (self.exponent + 1.0)
    }

    fn energy_error(&self, states: &States) -> f64 {
        let drift = |state: &[f64]| (self.energy(state) / self.energy(&START) - 1.0).abs();
        states.iter().map(drift).fold(0.0, f64::max)
    }
}

impl System for Bouncing {
    fn states(&self) -> usize {
        2
    }

    fn derivative(&self, _time: f64, state: &[f64], rate: &mut [f64]) {
        rate[0] = state[1];
        rate[1] = self.load(-state[0]) - 1.0;
    }

    fn linearisation(&self, _time: f64, state: &[f64], jacobian: &mut DMatrix<f64>) {
        let depth = (-state[0]).max(f64::MIN_POSITIVE);
        let stiffness = -self.exponent * self.load(depth) / depth;
        jacobian.copy_from_slice(&[0.0, stiffness, 1.0, 0.0]);
    }

    fn rate_by_time(&self, _time: f64, _state: &[f64], by_time: &mut [f64]) {
        by_time.fill(0.0);
    }

    fn event_count(&self) -> usize {
        usize::from(self.told)
    }

    fn events(&self, _time: f64, state: &[f64], values: &mut [f64]) {
        values.fill(-state[0]);
    }

    fn force_jump(&self, _event: usize, _time: f64, distance: f64, rate: &mut [f64]) {
        rate.copy_from_slice(&[0.0, self.load(distance)]);
    }

    fn event_exponent(&self, _event: usize) -> f64 {
        self.exponent
    }
}

/// Bounces over the grid.
const BOUNCES: f64 = 14.0;
const GRID: Grid = Grid {
    interval: 0.02,
    count: 2001,
};
const START: [f64; 2] = [1.0, 0.1];

fn integration<'a>(
    system: &'a Bouncing,
    method: Method,
    tolerance: f64,
    stop: &'a AtomicBool,
) -> Integration<'a> {
    let settings = Settings {
        method,
        tolerance,
        step_limit: 1_000_000,
    };
    Integration::new(system, Scaling::identity(2), GRID, settings, stop, &START)
}

/// States and work, in blocks of so many points.
fn run(system: &Bouncing, method: Method, tolerance: f64, points: usize) -> (States, Counters) {
    let stop = AtomicBool::new(false);
    let mut integration = integration(system, method, tolerance, &stop);
    let mut states = States::new(2);
    while integration.done() < GRID.count {
        integration
            .advance(points, &mut states)
            .expect("a harmless problem");
    }
    (states, integration.counters())
}

#[test]
fn a_bounce_keeps_the_energy_to_ten_tolerances() {
    for (ground, method) in [
        (&SPHERE, Method::Verner76),
        (&SPHERE, Method::Auto),
        (&SPRING, Method::Verner76),
    ] {
        for tolerance in [1e-5, 1e-7, 1e-9, 1e-11] {
            let (states, work) = run(ground, method, tolerance, 5000);
            let (power, error) = (ground.exponent, ground.energy_error(&states) / BOUNCES);
            println!("power {power}, {method:?} at {tolerance:e}: {error:.1e}, {work:?}");
            assert!(
                error < 10.0 * tolerance,
                "power {power}, {method:?} at {tolerance:e}: {error:e}"
            );
        }
    }
}

/// The same method without a word of the ground has some hundred times the error for more work.
#[test]
fn to_land_on_the_ground_pays() {
    let [told, untold] = [true, false].map(|told| {
        let ground = Bouncing { told, ..SPHERE };
        let (states, work) = run(&ground, Method::Verner76, 1e-9, 5000);
        (ground.energy_error(&states), work.evaluations)
    });
    println!("told {told:?}, untold {untold:?}");
    assert!(untold.0 > 30.0 * told.0, "{told:?} {untold:?}");
    assert!(untold.1 > told.1, "{told:?} {untold:?}");
}

/// Whatever stands between two blocks, a landing ahead or a step from the ground behind.
#[test]
fn blocks_leave_no_trace_about_a_landing() {
    for method in [Method::Verner76, Method::Auto] {
        let (whole, work) = run(&SPHERE, method, 1e-8, 5000);
        let (cut, same_work) = run(&SPHERE, method, 1e-8, 1);
        assert!(cut == whole, "{method:?}");
        assert_eq!(same_work, work, "{method:?}");
    }
}

/// Every sample is the state at its own time, those within the last step before another method goes on among them.
#[test]
fn a_change_of_the_method_leaves_no_sample_behind() {
    // far shorter than any step that matters
    let grid = Grid {
        interval: 2e-4,
        count: 40_001,
    };
    let states = |method, tolerance| {
        let stop = AtomicBool::new(false);
        let settings = Settings {
            method,
            tolerance,
            step_limit: 1_000_000,
        };
        let units = Scaling::identity(2);
        let mut integration = Integration::new(&SPHERE, units, grid, settings, &stop, &START);
        let mut states = States::new(2);
        integration
            .advance(40_001, &mut states)
            .expect("a harmless problem");
        (states, integration.method_use())
    };
    let (exact, _) = states(Method::Verner76, 1e-12);
    for tolerance in [1e-6, 1e-7, 1e-8, 1e-9] {
        let (own, used) = states(Method::Auto, tolerance);
        assert_eq!(used.map(|used| used.latest()), Some(Method::Verner76));
        let pairs = own.as_slice().iter().zip(exact.as_slice());
        let error = pairs.map(|(own, exact)| (own - exact).abs());
        let error = error.fold(0.0, f64::max);
        println!("{tolerance:e}: {error:e}");
        // errors add up from bounce to bounce; a sample left behind is off by 1e-4
        assert!(error < 100.0 * tolerance, "{tolerance:e}: {error:e}");
    }
}
