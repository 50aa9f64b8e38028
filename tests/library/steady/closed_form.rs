//! The shaft on linear supports.

use std::f64::consts::TAU;

use crate::analysis::Channel;
use crate::bearing::{ContactLaw, MountedBearing};
use crate::rotor::{Damping, Freedoms, RotorDefinition};
use crate::shooting::Multipliers;

use super::found;
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
fn unbalance_whirls_with_the_closed_form_amplitude_and_multipliers() {
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
                assert_near("magnitude", multiplier.norm(), size, 1e-6);
                let turned = (1.0 - ratio * ratio).sqrt() * natural * found.period;
                assert_near("real part", multiplier.re, size * turned.cos(), 2e-6);
            }
            assert!(found.is_stable());
        }
    }
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
