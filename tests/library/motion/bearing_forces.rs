//! The forces of all bearings on the shaft, and the share of each of them.

use std::f64::consts::TAU;

use crate::bearing::{ContactDamping, ContactLaw, MountedBearing};
use crate::rotor::load::{Harmonic, HarmonicRate};
use crate::rotor::{
    Damping, ElementLaw, ForceElement, Freedoms, LinearLaw, Load, LoadKind, RotorDefinition, Sample,
};
use crate::simulate::RecordedRun;

use crate::tests::support::{assert_near, back_to_back_pair, model, rotor, shaft};

const SPEED: f64 = 400.0;
const ECCENTRICITY: f64 = 20e-6;
const GRAVITY: f64 = 9.80665;

/// Away from the centre of mass, with tilts of its own.
const POSITION: f64 = -0.12;
const STIFFNESS: [f64; 5] = [4e6, 3e6, 2e6, 5e3, 7e3];
const DAMPING: [f64; 5] = [300.0, 200.0, 100.0, 0.5, 0.4];

fn springs(position: f64) -> ForceElement {
    ForceElement {
        position: Some(position),
        housing_of: None,
        housing: None,
        law: ElementLaw::Linear(Box::new(LinearLaw::new(
            (STIFFNESS, [0.0; 2]),
            (DAMPING, [0.0; 2]),
        ))),
    }
}

/// An unbalanced shaft with weight on ball bearings between springs and dampers.
fn mixed(freedoms: Freedoms, law: ContactLaw) -> RotorDefinition {
    let mut shaft = shaft(freedoms);
    (shaft.eccentricity, shaft.gravity) = (ECCENTRICITY, true);
    let contact_damping = ContactDamping {
        inner: 0.2,
        outer: 0.3,
    };
    let pair = back_to_back_pair()
        .into_iter()
        .map(|bearing| MountedBearing {
            law,
            contact_damping,
            ..bearing
        });
    let shaken = LoadKind::Harmonic(Harmonic {
        amplitude: [30.0, 20.0, 10.0, 0.3, 0.2],
        rate: HarmonicRate::Frequency(210.0),
        phase: 0.0,
    });
    RotorDefinition {
        speed: SPEED,
        loads: vec![Load {
            kind: shaken,
            position: 0.0,
        }],
        elements: vec![springs(POSITION), springs(0.2)],
        ..rotor(shaft, pair.collect())
    }
}

fn recorded(definition: RotorDefinition) -> Vec<Sample> {
    let run = RecordedRun::from_model(&model(definition, 0.02, 5000.0));
    run.expect("a run").samples
}

/// What the bearings must press with: inertia less unbalance, weight and load.
fn due(sample: &Sample) -> [f64; 5] {
    let [a_x, a_y, a_z, tilt_x, tilt_y] = sample.acceleration.expect("accelerations");
    let [.., rate_x, rate_y] = sample.velocity;
    let (mass, transverse, polar) = (5.0, 2e-3, 1.5e-3);
    let unbalance = mass * ECCENTRICITY * SPEED * SPEED;
    let shaken = (TAU * 210.0 * sample.time).cos();
    [
        mass * a_x - unbalance * sample.angle.cos() - 30.0 * shaken,
        mass * a_y - unbalance * sample.angle.sin() + mass * GRAVITY - 20.0 * shaken,
        mass * a_z - 10.0 * shaken,
        transverse * tilt_x + polar * SPEED * rate_y - 0.3 * shaken,
        transverse * tilt_y - polar * SPEED * rate_x - 0.2 * shaken,
    ]
}

#[test]
fn the_bearings_of_a_rigid_shaft_balance_its_inertia() {
    let freedoms = [
        Freedoms::Radial,
        Freedoms::Translational,
        Freedoms::Lateral,
        Freedoms::All,
    ];
    for (freedoms, law) in freedoms
        .into_iter()
        .flat_map(|own| [ContactLaw::Hertz, ContactLaw::Linear].map(|law| (own, law)))
    {
        let samples = recorded(mixed(freedoms, law));
        assert!(samples.len() > 90);
        for sample in &samples {
            let total = sample.force_on_shaft.expect("observed");
            let due = due(sample);
            for axis in freedoms.axes().iter().copied() {
                let unit = if axis < 3 { 1.0 } else { 0.1 };
                assert_near("balance", total[axis], due[axis], 1e-7 * unit);
            }
            assert_eq!(sample.bearing_forces.len(), 4);
            for axis in 0..5 {
                let sum = sample.bearing_forces.iter().map(|force| force[axis]);
                assert_near("sum", sum.sum(), total[axis], 1e-9);
            }
        }
    }
}

#[test]
fn a_linear_element_presses_by_where_its_place_is() {
    for sample in recorded(mixed(Freedoms::All, ContactLaw::Hertz)) {
        let [x, y, z, tilt_x, tilt_y] = sample.displacement;
        let [vx, vy, vz, rate_x, rate_y] = sample.velocity;
        for (place, arm) in [(2, POSITION), (3, 0.2)] {
            let u = [x + arm * tilt_y, y - arm * tilt_x, z, tilt_x, tilt_y];
            let v = [vx + arm * rate_y, vy - arm * rate_x, vz, rate_x, rate_y];
            let own: [f64; 5] =
                std::array::from_fn(|axis| -STIFFNESS[axis] * u[axis] - DAMPING[axis] * v[axis]);
            let [f_x, f_y, f_z, m_x, m_y] = own;
            let expected = [f_x, f_y, f_z, m_x - arm * f_y, m_y + arm * f_x];
            for (axis, expected) in expected.into_iter().enumerate() {
                let found = sample.bearing_forces[place][axis];
                assert_near("force", found, expected, 1e-9 * (1.0 + expected.abs()));
            }
        }
    }
}

/// `m ÿ + k (y − a θ) = −m g` with the tilt θ about X held: at rest where the springs balance weight and held tilt.
#[test]
fn springs_press_by_a_tilt_that_is_held() {
    let mut shaft = shaft(Freedoms::Radial);
    (shaft.gravity, shaft.held_tilt) = (true, [1e-3, 0.0]);
    let definition = RotorDefinition {
        elements: vec![springs(POSITION)],
        damping: Damping::Undamped,
        ..rotor(shaft, Vec::new())
    };
    let rest = 1e-3 * POSITION - 5.0 * GRAVITY / STIFFNESS[1];
    for sample in recorded(definition) {
        assert_near("rest", sample.displacement[1], rest, 1e-12);
        let [_, y, ..] = sample.force_on_shaft.expect("observed");
        assert_near("weight", y, 5.0 * GRAVITY, 1e-6);
    }
}
