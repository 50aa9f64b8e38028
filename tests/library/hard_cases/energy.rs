//! Energy that nothing takes away.

use std::io;

use crate::integrate::{Counters, System};
use crate::rotor::{CageMotion, Damping, Freedoms, InitialState, Rotor, RotorDefinition, Sample};
use crate::simulate::TraceSink;

use crate::tests::support::{
    AT_EQUILIBRIUM, bearing, constant, contacts, law, model, settings, shaft, simulate_into,
    thrust_rotor,
};

/// N.
const LOAD: [f64; 5] = [0.0, -400.0, 1000.0, 0.0, 0.0];

/// A 7205C under thrust and a radial load, let go 5 µm beside its equilibrium: x and y vibrate, coupled
/// by the contacts, and nothing damps them.
struct Vibration {
    definition: RotorDefinition,
    rotor: Rotor,
    stiffness: f64,
    /// Energy at the start, and above that of the equilibrium, J.
    start: f64,
    swing: f64,
    /// Frequency of the slower mode, Hz.
    frequency: f64,
}

impl Vibration {
    fn new() -> Self {
        let mut definition = RotorDefinition {
            shaft: shaft(Freedoms::Radial),
            cage: CageMotion::Frozen,
            damping: Damping::Undamped,
            loads: constant(LOAD),
            ..thrust_rotor()
        };
        let assemble = |definition: &RotorDefinition| Rotor::assemble(definition).expect("a rotor");
        let place = assemble(&definition).equilibrium().displacement;
        let start = [
            Some(place[0] + 4e-6),
            Some(place[1] - 3e-6),
            None,
            None,
            None,
        ];
        definition.initial = InitialState {
            displacement: start,
            ..AT_EQUILIBRIUM
        };
        let rotor = assemble(&definition);
        let mut vibration = Self {
            stiffness: law(&bearing("7205C")).contact.stiffness,
            frequency: rotor.natural_frequencies()[0].frequency,
            definition,
            rotor,
            start: 0.0,
            swing: 0.0,
        };
        vibration.start = vibration.energy(&vibration.first_state());
        vibration.swing = vibration.start - vibration.energy(&[place[0], place[1], 0.0, 0.0]);
        vibration
    }

    fn first_state(&self) -> [f64; 4] {
        let state = self.rotor.start_state();
        [state[0], state[1], state[2], state[3]]
    }

    /// ½ m v² + Σ (2/5) Q (Q/K_n)^(2/3) − W y of a state x, y and their velocities, J.
    fn energy(&self, [x, y, u, v]: &[f64; 4]) -> f64 {
        let mut place = self.rotor.equilibrium().displacement;
        [place[0], place[1]] = [*x, *y];
        let mut energy = 0.5 * self.definition.shaft.mass * (u * u + v * v);
        energy -= LOAD[1] * y;
        let mut add = |load: f64| energy += 0.4 * load * (load / self.stiffness).cbrt().powi(2);
        let support = self.rotor.supports().next().expect("a bearing");
        for ball in contacts(support, &place, 0.0) {
            add(ball.load_inner);
        }
        energy
    }

    /// How the energy drifts over so many periods, and the work.
    fn drift(&self, periods: f64, tolerance: f64) -> (Drift<'_>, Counters) {
        let mut model = model(self.definition.clone(), periods / self.frequency, 100.0);
        model.integrator = settings(tolerance);
        let mut drift = Drift {
            vibration: self,
            tenth: 0.1 * model.duration,
            early: 0.0,
            largest: 0.0,
        };
        let run = simulate_into(&model, &mut drift).expect("a run");
        println!(
            "{periods} periods at {tolerance:e}: {:e}, {:?}",
            drift.largest, run.counters
        );
        (drift, run.counters)
    }
}

/// Largest distance of the energy from that at the start, part of the swing.
struct Drift<'a> {
    vibration: &'a Vibration,
    /// Time at which a tenth of the run is over, s.
    tenth: f64,
    /// The largest within that tenth.
    early: f64,
    largest: f64,
}

impl TraceSink for Drift<'_> {
    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        let [x, y, ..] = sample.displacement;
        let [u, v, ..] = sample.velocity;
        let energy = self.vibration.energy(&[x, y, u, v]);
        let drift = (energy - self.vibration.start).abs() / self.vibration.swing;
        self.largest = self.largest.max(drift);
        if sample.time <= self.tenth {
            self.early = self.largest;
        }
        Ok(())
    }
}

/// 1e5 periods is where small losses add up: a million steps, each allowed an error of 2.5e-9 at the
/// default tolerance. The drift grows with time and falls with the tolerance.
#[test]
fn a_bearing_keeps_its_energy_over_a_hundred_thousand_periods() {
    let vibration = Vibration::new();
    let (long, counters) = vibration.drift(1e5, 1e-8);
    assert!(long.largest < 3e-4, "{:e}", long.largest);
    // a dozen steps a period
    assert!(counters.evaluations < 20_000_000, "{counters:?}");
    let growth = long.largest / long.early;
    assert!((9.0..11.0).contains(&growth), "{growth}");
    let tighter = [1e-10, 1e-12].map(|tolerance| vibration.drift(1e4, tolerance).0.largest);
    assert!(
        tighter[0] < 0.03 * long.early && tighter[1] < 0.03 * tighter[0],
        "{:e}, {tighter:?}",
        long.early
    );
}

/// The classic Runge–Kutta method with 20 fixed steps a period is the usual choice where steps are
/// not controlled. It damps by (ωh)⁶/72 a step: a tenth of the periods takes nine tenths of the swing.
#[test]
fn fixed_runge_kutta_steps_lose_the_energy() {
    let vibration = Vibration::new();
    let step = 1.0 / (20.0 * vibration.frequency);
    let rate = |state: [f64; 4]| {
        let mut rate = [0.0; 4];
        vibration.rotor.derivative(0.0, &state, &mut rate);
        rate
    };
    let along = |state: [f64; 4], slope: [f64; 4], h: f64| -> [f64; 4] {
        std::array::from_fn(|i| state[i] + h * slope[i])
    };
    let mut state = vibration.first_state();
    for _ in 0..20 * 10_000 {
        let first = rate(state);
        let second = rate(along(state, first, 0.5 * step));
        let third = rate(along(state, second, 0.5 * step));
        let fourth = rate(along(state, third, step));
        let mean =
            std::array::from_fn(|i| (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]) / 6.0);
        state = along(state, mean, step);
    }
    let lost = (vibration.start - vibration.energy(&state)) / vibration.swing;
    println!("lost {lost}");
    assert!(lost > 0.9, "{lost}");
}
