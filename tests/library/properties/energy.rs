//! Energy: kept by a Hertz contact without damping, accounted for with it.

use std::sync::atomic::AtomicBool;

use crate::bearing::{Ball, ForceLaw, HertzLaw};
use crate::integrate::{Grid, Integration, Scaling, States, System};
use crate::rotor::{
    CageMotion, Damping, Freedoms, InitialState, Load, Rotor, RotorDefinition, Sample,
};
use nalgebra::DMatrix;

use crate::tests::support::{
    AT_EQUILIBRIUM, assert_near, bearing, constant, law, model, mounted, rotor, samples, settings,
    shaft, thrust_rotor,
};

const MASS: f64 = 1.0;

/// A mass that a constant load presses onto one ball, moving along the line of contact.
struct OneBall {
    law: HertzLaw,
    load: f64,
}

impl OneBall {
    fn new(load: f64) -> Self {
        Self {
            law: law(&bearing("7205C")),
            load,
        }
    }

    fn stiffness(&self) -> f64 {
        self.law.contact.stiffness
    }

    /// ½ m v² + (2/5) K δ^(5/2) − W x, J.
    fn energy(&self, state: &[f64]) -> f64 {
        let [place, speed] = [state[0], state[1]];
        let contact = 0.4 * self.stiffness() * place.max(0.0).powf(2.5);
        0.5 * MASS * speed * speed + contact - self.load * place
    }

    /// States on a uniform grid; lengths and speeds are given to scale them.
    fn motion(&self, start: [f64; 2], grid: Grid, [length, time]: [f64; 2]) -> States {
        let scaling = Scaling {
            origin: vec![0.0; 2],
            scale: vec![length, length / time],
            time,
        };
        let stop = AtomicBool::new(false);
        let mut integration = Integration::new(self, scaling, grid, settings(1e-13), &stop, &start);
        let mut states = States::new(2);
        while integration.done() < grid.count {
            integration
                .advance(1000, &mut states)
                .expect("smooth enough");
        }
        states
    }
}

impl System for OneBall {
    fn states(&self) -> usize {
        2
    }

    fn derivative(&self, _time: f64, state: &[f64], rate: &mut [f64]) {
        let force = self
            .law
            .force(&Ball::at(0.0, self.law.distance + state[0]), 0.0)
            .radial;
        rate[0] = state[1];
        rate[1] = (self.load - force) / MASS;
    }

    fn linearisation(&self, _time: f64, state: &[f64], jacobian: &mut DMatrix<f64>) {
        let place = self.law.distance + state[0];
        let (_, tangent) = self.law.force_and_tangent(0.0, place, 0.0);
        jacobian.copy_from_slice(&[0.0, -tangent[1][1] / MASS, 1.0, 0.0]);
    }

    fn rate_by_time(&self, _time: f64, _state: &[f64], by_time: &mut [f64]) {
        by_time.fill(0.0);
    }
}

/// The mass swings between half and about one and a half times its static approach.
#[test]
fn a_contact_keeps_its_energy_over_ten_thousand_periods() {
    let system = OneBall::new(100.0);
    let still = (system.load / system.stiffness()).cbrt().powi(2);
    // the period of a small vibration: k = 1.5 W/δ
    let period = std::f64::consts::TAU / (1.5 * system.load / still / MASS).sqrt();
    let grid = Grid {
        interval: 1.01 * period,
        count: 10_001,
    };
    let start = [0.5 * still, 0.0];
    let states = system.motion(start, grid, [still, period / std::f64::consts::TAU]);
    let swing = system.energy(&start) - system.energy(&[still, 0.0]);
    let drift = states
        .iter()
        .map(|state| (system.energy(state) - system.energy(&start)).abs() / swing)
        .fold(0.0, f64::max);
    println!("energy drift over 1e4 periods: {drift:e}");
    // the position is known to ε A/δ = 1e-13 of the approach: that, times the 1e5 steps
    assert!(drift < 1e-7, "{drift:e}");
}

/// (2/5) K δ_max^(5/2) = ½ m v², and the mass leaves as fast as it came.
#[test]
fn an_impact_turns_kinetic_into_contact_energy_and_back() {
    let system = OneBall::new(0.0);
    let speed = 0.1;
    let expected = (0.5 * MASS * speed * speed / (0.4 * system.stiffness())).powf(0.4);
    // contact lasts 2.94 δ_max/v; the mass starts as far away as it will press in
    let grid = Grid {
        interval: 0.01 * expected / speed,
        count: 500,
    };
    let start = [-expected, speed];
    let states = system.motion(start, grid, [expected, expected / speed]);
    let turning = states
        .iter()
        .min_by(|a, b| a[1].abs().total_cmp(&b[1].abs()))
        .expect("states");
    // beside the turning point by v²/2a
    let deceleration = system.stiffness() * turning[0].powf(1.5) / MASS;
    let deepest = turning[0] + turning[1] * turning[1] / (2.0 * deceleration);
    // the sample nearest to the turning point leaves a remainder of the fourth order in 0.005
    assert_near("δ_max", deepest, expected, 1e-9 * expected);
    let last = states.last().expect("states");
    let rebound = last[1];
    assert!(last[0] < 0.0);
    assert_near("rebound", rebound, -speed, 1e-9 * speed);
}

#[test]
fn damped_motion_settles_on_the_static_equilibrium() {
    let starts = [
        (
            Freedoms::Radial,
            [Some(3e-6), Some(-2e-6), None, None, None],
        ),
        (
            Freedoms::Translational,
            [Some(3e-6), Some(-2e-6), Some(2e-5), None, None],
        ),
        (
            Freedoms::All,
            [Some(3e-6), Some(-2e-6), Some(2e-5), Some(1e-4), Some(-2e-4)],
        ),
    ];
    for (freedoms, displacement) in starts {
        let mut definition = thrust_rotor();
        definition.shaft = shaft(freedoms);
        definition.cage = CageMotion::Frozen;
        definition.loads = constant([50.0, -300.0, 1000.0, 0.0, 0.0]);
        definition.damping = Damping::Ratio(0.2);
        definition.initial = InitialState {
            displacement,
            ..AT_EQUILIBRIUM
        };
        let place = Rotor::assemble(&definition)
            .expect("a rotor")
            .equilibrium()
            .displacement;
        let last = samples(&model(definition, 0.2, 1000.0), 0.2 - 1e-9)
            .pop()
            .expect("samples");
        for (axis, place) in place.into_iter().enumerate() {
            let arm = if axis < 3 { 1.0 } else { 0.0194 };
            // the tolerance of 1e-10 of a start 20 µm away
            assert_near("place", arm * last.displacement[axis], arm * place, 2e-14);
        }
    }
}

/// Simpson's rule over samples at a uniform distance.
fn integral(samples: &[Sample], interval: f64, value: impl Fn(&Sample) -> f64) -> f64 {
    let last = samples.len() - 1;
    let weighted = samples.iter().enumerate().map(|(index, sample)| {
        let weight = match index {
            0 => 1.0,
            index if index == last => 1.0,
            index if index % 2 == 1 => 4.0,
            _ => 2.0,
        };
        weight * value(sample)
    });
    weighted.sum::<f64>() * interval / 3.0
}

/// Kinetic energy plus that of the contacts, (2/5) Σ Q δ, minus the work left in constant loads.
fn stored(sample: &Sample, definition: &RotorDefinition, supports: &Rotor) -> f64 {
    let kinetic = (0..3).map(|axis| 0.5 * definition.shaft.mass * sample.velocity[axis].powi(2));
    let support = supports.supports().next().expect("a bearing");
    let stiffness = law(&bearing("7205C")).contact.stiffness;
    let contact = crate::tests::support::contacts(support, &sample.displacement, 0.0)
        .into_iter()
        .map(|ball| 0.4 * ball.load_inner * (ball.load_inner / stiffness).cbrt().powi(2));
    let constant = definition.loads.iter().filter_map(Load::as_constant);
    let loads =
        constant.flat_map(|parts| (0..3).map(|axis| parts[axis] * sample.displacement[axis]));
    kinetic.sum::<f64>() + contact.sum::<f64>() - loads.sum::<f64>()
}

#[test]
fn what_unbalance_puts_in_is_dissipated_or_stored() {
    let damping = 800.0;
    let mut definition = thrust_rotor();
    definition.shaft.eccentricity = 2e-6;
    definition.cage = CageMotion::Frozen;
    definition.loads = constant([0.0, -400.0, 1000.0, 0.0, 0.0]);
    definition.damping = Damping::Coefficients([damping, damping, damping, 0.0, 0.0]);
    let assembled = Rotor::assemble(&definition).expect("a rotor");
    let (rate, duration) = (100_000.0, 0.02);
    let samples = samples(&model(definition.clone(), duration, rate), 0.0);
    assert_eq!(samples.len(), 2001);
    let unbalance =
        definition.shaft.mass * definition.shaft.eccentricity * definition.speed.powi(2);
    let input = integral(&samples, 1.0 / rate, |s| {
        unbalance * (s.velocity[0] * s.angle.cos() + s.velocity[1] * s.angle.sin())
    });
    let dissipated = integral(&samples, 1.0 / rate, |s| {
        damping * s.velocity.iter().map(|v| v * v).sum::<f64>()
    });
    let energy = |sample: &Sample| stored(sample, &definition, &assembled);
    let gained = energy(&samples[samples.len() - 1]) - energy(&samples[0]);
    println!("in {input:e} J, out {dissipated:e} J, stored {gained:e} J");
    assert!(dissipated > 0.0 && input > 0.0);
    // Simpson at 60 samples a period of the fastest vibration: (2π/60)⁴/180 of a swing
    assert_near(
        "balance",
        dissipated + gained,
        input,
        1e-6 * (dissipated + input),
    );
}

/// Constant load, no unbalance, the cage standing with the shaft: nothing moves.
#[test]
fn a_shaft_at_its_static_equilibrium_stays_there() {
    let mut definition = rotor(shaft(Freedoms::Radial), vec![mounted(bearing("6305"))]);
    definition.loads = constant([0.0, -500.0, 0.0, 0.0, 0.0]);
    let place = Rotor::assemble(&definition)
        .expect("a rotor")
        .equilibrium()
        .displacement;
    for sample in samples(&model(definition, 0.02, 10_000.0), 0.0) {
        for (displacement, place) in sample.displacement.into_iter().zip(place) {
            // round-off of a position between the races: ε A = 1e-19 m, gathered over 100 periods
            assert_near("place", displacement, place, 1e-16);
        }
    }
}
