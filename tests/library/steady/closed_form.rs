//! The shaft on linear supports.

use std::f64::consts::TAU;
use std::sync::atomic::{AtomicBool, AtomicU64};

use nalgebra::{Complex, DMatrix, DVector};

use crate::analysis::Channel;
use crate::bearing::{ContactLaw, MountedBearing};
use crate::integrate::{Grid, Integration, Settings, Shifted, States, System};
use crate::rotor::{Damping, Freedoms, RotorDefinition};
use crate::scenario;
use crate::shooting::Multipliers;
use crate::steady::{SteadyError, SteadyQuestion, steady};

use super::{found, search};
use crate::tests::support::{assert_near, bearing, constant, model, mounted, rotor, shaft};

const ECCENTRICITY: f64 = 1e-7;

/// Under thrust on a linear bearing, x and y free: K_xx = K_yy.
fn definition(ratio: f64, speed: f64) -> RotorDefinition {
    let mut shaft = shaft(Freedoms::Radial);
    shaft.eccentricity = ECCENTRICITY;
    let linear = MountedBearing {
        law: ContactLaw::Linear,
        ..mounted(bearing("7205C"))
    };
    RotorDefinition {
        speed,
        damping: Damping::Ratio(ratio),
        loads: constant([0.0, 0.0, 1000.0, 0.0, 0.0]),
        ..rotor(shaft, vec![linear])
    }
}

fn natural() -> f64 {
    let rotor = crate::rotor::Rotor::assemble(&definition(0.0, 0.0)).expect("a rotor");
    (rotor.equilibrium().stiffness[(0, 0)] / 5.0).sqrt()
}

/// e r²/√((1 − r²)² + (2ζr)²), and multipliers e^{(−ζ ± i√(1 − ζ²)) ω_n T}, for damping however low.
#[test]
fn unbalance_has_the_closed_form_amplitude_and_multipliers() {
    for ratio in [1e-4, 0.002, 0.05] {
        for r in [0.1_f64, 0.9, 1.0, 5.0] {
            let natural = natural();
            let found = found(&model(definition(ratio, r * natural), 1.0, 1e5));
            let frequency = r * natural / TAU;
            let expected = ECCENTRICITY * r * r / (1.0 - r * r).hypot(2.0 * ratio * r);
            let amplitude = found.lines.amplitude(Channel::Displacement(0), frequency);
            let amplitude = amplitude.expect("a channel");
            println!("ζ {ratio} r {r}: {:e}", amplitude / expected - 1.0);
            // the tolerance 1e-10, magnified by what a period's error becomes until it has died
            let magnified = 1e-10 / (1.0 - found.multipliers.largest());
            assert_near(
                "amplitude",
                amplitude,
                expected,
                magnified.max(1e-8) * expected,
            );
            let Multipliers::Periodic(all) = &found.multipliers else {
                panic!("one frequency");
            };
            let size = (-ratio * natural * found.period).exp();
            for multiplier in all {
                assert_near("magnitude", multiplier.norm(), size, 1e-9);
                let turned = (1.0 - ratio * ratio).sqrt() * natural * found.period;
                assert_near("real part", multiplier.re, size * turned.cos(), 1e-9);
            }
            assert!(found.is_stable());
        }
    }
}

/// A free vibration that decays nearly repeats after two periods; the motion is that of one, taken as often as asked for.
#[test]
fn multiples_of_a_period_have_its_multipliers_to_their_power() {
    let model = model(definition(0.02, 0.3 * natural()), 1.0, 1e5);
    let single = found(&model);
    for multiple in [2, 3, 4, 6] {
        let found = search(&model, Some(multiple)).expect("a motion");
        assert_eq!(found.multiple, multiple);
        let expected = single.multipliers.largest().powi(multiple as i32);
        assert_near("multiplier", found.multipliers.largest(), expected, 1e-9);
    }
    assert!(matches!(
        search(&model, Some(0)),
        Err(SteadyError::NoPeriods)
    ));
}

/// Nothing else makes a line.
#[test]
fn a_linear_scene_has_no_line_but_that_of_the_unbalance() {
    let found = found(&model(definition(0.02, 0.3 * natural()), 1.0, 1e5));
    let of_x = |line: &&crate::steady::SteadyLine| line.amplitude[0] > 1e-8 * ECCENTRICITY;
    let heard: Vec<[i32; 2]> = found
        .lines
        .lines
        .iter()
        .filter(of_x)
        .map(|line| line.multiples)
        .collect();
    assert_eq!(heard, [[1, 0]]);
}

const BENDING: &str = r#"
[shaft]
freedoms = "radial"
[[shaft.section]]
length = "400 mm"
outer_diameter = "30 mm"
[[disc]]
position = "200 mm"
outer_diameter = "200 mm"
width = "30 mm"
[[unbalance]]
amount = "100 g mm"
position = "200 mm"
[[element]]
position = "0 mm"
linear = { stiffness = { x = "1e7 N/m", y = "2e7 N/m" }, damping = { x = "500 N s/m", y = "500 N s/m" } }
[[element]]
position = "400 mm"
linear = { stiffness = { x = "1e7 N/m", y = "2e7 N/m" }, damping = { x = "500 N s/m", y = "500 N s/m" } }
[speed]
constant = "1500 rpm"
[time]
duration = "0.5 s"
"#;

/// A shaft that bends on linear bearings turns as (iω − A)⁻¹ b has it, with ẏ = A y + Re(b e^{iωt}), and is found in a few
/// periods, however stiff its highest modes are.
#[test]
fn a_bending_shaft_on_linear_bearings_is_found_at_once() {
    let scenario = scenario::parse(BENDING, "bending.toml", scenario::Format::Toml);
    let mut model = scenario.expect("a scenario").model.expect("a motion");
    model.integrator.tolerance = 1e-10;
    let (stop, integrated) = (AtomicBool::new(false), AtomicU64::new(0));
    let found = steady(&SteadyQuestion {
        model: &model,
        multiple: None,
        stop: &stop,
        integrated: &integrated,
    });
    let found = found.expect("a motion");
    assert!(integrated.into_inner() < 16);
    assert!(found.is_stable());

    let rotor = crate::rotor::Rotor::assemble(&model.rotor).expect("a rotor");
    let (states, frequency) = (rotor.states(), 50.0 * std::f64::consts::PI);
    let origin = rotor.scaling(&rotor.motion_scale(1e-10)).origin;
    let mut slopes = DMatrix::zeros(states, states);
    rotor.linearisation(0.0, &origin, &mut slopes);
    let rate_at = |time: f64| {
        let mut rate = vec![0.0; states];
        rotor.derivative(time, &origin, &mut rate);
        rate
    };
    let (first, quarter) = (rate_at(0.0), rate_at(0.25 * TAU / frequency));
    let force = DVector::from_fn(states, |row, _| Complex::new(first[row], -quarter[row]));
    let dynamic = DMatrix::from_fn(states, states, |row, column| {
        let inertia = if row == column { frequency } else { 0.0 };
        Complex::new(-slopes[(row, column)], inertia)
    });
    let answer = dynamic.lu().solve(&force).expect("a regular matrix");
    let part = |pick: fn(&Complex<f64>) -> f64| -> Vec<f64> { answer.iter().map(pick).collect() };
    let (real, imaginary) = (part(|value| value.re), part(|value| value.im));
    let rest = rotor.displacement(&origin);
    for (axis, rest) in rest.into_iter().enumerate().take(2) {
        let of = |state: &[f64]| {
            let moved: Vec<f64> = state.iter().zip(&origin).map(|(a, b)| a + b).collect();
            rotor.displacement(&moved)[axis] - rest
        };
        let expected = of(&real).hypot(of(&imaginary));
        let amplitude = found
            .lines
            .amplitude(Channel::Displacement(axis), frequency / TAU);
        assert_near(
            "amplitude",
            amplitude.expect("a channel"),
            expected,
            1e-8 * expected,
        );
    }
}

const LOADS: &str = r#"
[[load]]
harmonic = { amplitude = { y = "20 N" }, frequency = "75 Hz", phase = "30 deg" }
position = "150 mm"
[[load]]
sprocket = { teeth = 7, pitch = "20 mm", span = "0.4 m", force = "300 N" }
position = "300 mm"
"#;

/// Where all that drives a linear rotor are harmonics, nothing is integrated, and a period of the equations from the state
/// that is found ends there again.
#[test]
fn harmonics_on_a_linear_rotor_are_answered_in_closed_form() {
    let text = format!("{BENDING}{LOADS}");
    let scenario = scenario::parse(&text, "bending.toml", scenario::Format::Toml);
    let mut model = scenario.expect("a scenario").model.expect("a motion");
    model.verify = true;
    let found = found(&model);
    assert_eq!(found.counters.evaluations, 0);
    assert!(found.is_stable());
    let (start, state) = found.strobe(0);

    let rotor = crate::rotor::Rotor::assemble(&model.rotor).expect("a rotor");
    let scale = rotor.motion_scale(1e-11);
    let (system, stop) = (
        Shifted {
            system: &rotor,
            start,
        },
        AtomicBool::new(false),
    );
    let grid = Grid {
        interval: 0.125 * found.period,
        count: 9,
    };
    let settings = Settings {
        tolerance: 1e-10,
        ..model.integrator
    };
    let mut integration = Integration::new(
        &system,
        rotor.scaling(&scale),
        grid,
        settings,
        &stop,
        &state,
    );
    let mut states = States::new(state.len());
    integration.advance(9, &mut states).expect("states");
    let samples = found.trace.len();
    for (number, state) in states.iter().enumerate() {
        let sample = &found.trace[number * samples / 8 % samples];
        for (axis, place) in rotor.displacement(state).into_iter().enumerate().take(2) {
            assert_near(
                "place",
                sample.displacement[axis],
                place,
                1e-8 * scale.length,
            );
        }
    }
}
