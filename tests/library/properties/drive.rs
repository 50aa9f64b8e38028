//! A shaft whose speed follows from the moments on it.

use crate::bearing::{ContactLaw, MountedBearing};
use crate::rotor::{CageMotion, Damping, Drive, Freedoms, RotorDefinition, Sample};
use crate::simulate::{Model, Run};

use crate::tests::support::{
    Collector, assert_near, bearing, constant, model, mounted, rotor, settings, shaft,
    simulate_into,
};

/// A motor of constant torque against nothing.
const FREE: Drive = Drive {
    torque: 0.3,
    no_load_speed: None,
    load_torque: 0.0,
    friction: false,
    compliance: 0.0,
};

/// A 7205C under 1000 N of thrust with a drive; I_p = 1.5 g m².
fn driven(drive: Drive) -> RotorDefinition {
    RotorDefinition {
        drive: Some(drive),
        damping: Damping::Ratio(0.02),
        loads: constant([0.0, 0.0, 1000.0, 0.0, 0.0]),
        ..rotor(
            shaft(Freedoms::Translational),
            vec![mounted(bearing("7205C"))],
        )
    }
}

fn run(definition: RotorDefinition, duration: f64) -> (Run, Vec<Sample>) {
    let model = Model {
        integrator: settings(1e-9),
        ..model(definition, duration, 5000.0)
    };
    let mut sink = Collector::default();
    let run = simulate_into(&model, &mut sink).expect("a run");
    (run, sink.samples)
}

/// ω = T t/I_p, ψ = T t²/2 I_p
#[test]
fn a_constant_moment_speeds_a_balanced_shaft_up_evenly() {
    let (run, samples) = run(driven(FREE), 1.0);
    let last = samples.last().expect("samples");
    assert_near("speed", last.speed, 200.0, 2e-7);
    assert_near("angle", last.angle, 100.0, 1e-7);
    let energy = run.energy.expect("a driven shaft has an account");
    // ½ I_p ω² = 30 J
    assert_near("work", energy.works.drive, 30.0, 1e-7);
    assert!(energy.relative_residual < 1e-8, "{energy:?}");
}

/// ω = ω_0 (1 − e^(−t T_0/(I_p ω_0)))
#[test]
fn a_motor_that_weakens_with_speed_approaches_its_no_load_speed() {
    let drive = Drive {
        no_load_speed: Some(200.0),
        ..FREE
    };
    let (_, samples) = run(driven(drive), 1.5);
    for sample in samples.iter().step_by(500) {
        let expected = 200.0 * (1.0 - (-sample.time).exp());
        assert_near("speed", sample.speed, expected, 2e-6);
    }
}

/// The friction moment of the bearing brings a coasting shaft to rest, and keeps it there.
#[test]
fn friction_brings_a_coasting_shaft_to_rest() {
    let coasting = Drive {
        torque: 0.0,
        friction: true,
        compliance: 1e-3,
        ..FREE
    };
    let definition = RotorDefinition {
        speed: 50.0,
        ..driven(coasting)
    };
    let (run, samples) = run(definition, 8.0);
    let last = samples.last().expect("samples");
    assert!(last.speed.abs() < 0.01, "{}", last.speed);
    let moments = samples[10].drive.expect("moments");
    assert!(
        moments.friction > 0.005 && moments.friction < 0.05,
        "{moments:?}"
    );
    // θz = M_z L/(G I_p)
    assert_near("twist", moments.twist, 1e-3 * moments.friction, 1e-15);
    let energy = run.energy.expect("an account");
    // ½ I_p ω² = 1.875 J, all of it to heat
    assert_near("friction", energy.works.friction, 1.875, 1e-5);
    assert!(energy.relative_residual < 1e-7, "{energy:?}");
}

/// 500 kg on the frozen stiffness of the bearing: one critical speed, 2 % damping.
fn heavy(torque: f64, start: f64) -> RotorDefinition {
    let mut shaft = shaft(Freedoms::Radial);
    shaft.mass = 500.0;
    shaft.eccentricity = 1e-6;
    shaft.inertia_polar = 1e-4;
    RotorDefinition {
        speed: start,
        drive: Some(Drive { torque, ..FREE }),
        cage: CageMotion::Frozen,
        damping: Damping::Ratio(0.02),
        loads: constant([0.0, 0.0, 1000.0, 0.0, 0.0]),
        ..rotor(
            shaft,
            vec![MountedBearing {
                law: ContactLaw::Linear,
                ..mounted(bearing("7205C"))
            }],
        )
    }
}

/// A motor too weak for the resonance hangs below it, where its power is what the vibration
/// dissipates: T ω = c ω² X², X = e r²/√((1 − r²)² + (2ζr)²). A stronger one passes.
#[test]
fn a_weak_motor_hangs_at_the_critical_speed() {
    let (run_, samples) = run(heavy(2.5e-3, 610.0), 10.0);
    let critical = std::f64::consts::TAU * run_.equilibrium.natural_frequencies[0].frequency
        / (1.0f64 - 0.02 * 0.02).sqrt();
    let hanging = samples[samples.len() - 500..].iter();
    let speed = hanging.map(|sample| sample.speed).sum::<f64>() / 500.0;
    let ratio = speed / critical;
    let swing = 1e-6 * ratio.powi(2) / (1.0 - ratio * ratio).hypot(0.04 * ratio);
    let damping = 0.04 * 500.0 * critical;
    assert!(ratio > 0.9 && ratio < 1.0, "{ratio}");
    assert_near("moment", damping * speed * swing * swing, 2.5e-3, 1e-4);
    let (_, samples) = run(heavy(15e-3, 610.0), 4.0);
    let last = samples.last().expect("samples");
    assert!(last.speed > 1.2 * critical, "{}", last.speed);
}

/// A shaft with two unbalances half a turn apart, which a motor takes through its tilting resonance: what the couple takes
/// from the rotation is what it gives to the tilts.
#[test]
fn a_couple_takes_from_the_rotation_what_it_gives_to_the_tilts() {
    let mut tilting = shaft(Freedoms::All);
    let inertia = tilting.inertia_polar;
    tilting.unbalance.add(4e-4, 0.3, -0.05);
    tilting
        .unbalance
        .add(3e-4, 0.3 + std::f64::consts::PI, 0.06);
    let definition = RotorDefinition {
        drive: Some(Drive {
            torque: 6.0,
            ..FREE
        }),
        damping: Damping::Ratio(0.03),
        loads: constant([0.0, 0.0, 1000.0, 0.0, 0.0]),
        ..rotor(tilting, vec![mounted(bearing("7205C"))])
    };
    let (run, samples) = run(definition, 0.25);
    let last = samples.last().expect("samples");
    let tilt = samples.iter().map(|sample| sample.displacement[3].abs());
    assert!(tilt.fold(0.0, f64::max) > 1e-5);
    // the shaft lags behind the one whose tilts take nothing
    let free = 6.0 * 0.25 / inertia;
    assert!(last.speed < 0.999 * free, "{} of {free}", last.speed);
    let energy = run.energy.expect("an account");
    assert!(energy.relative_residual < 1e-8, "{energy:?}");
}
