//! Structures with more than a rigid shaft: bearings on a housing that moves on springs of its own.

use std::sync::atomic::AtomicBool;

use nalgebra::{DMatrix, DVector};

use super::*;
use crate::bearing::{
    ContactDamping, ContactLaw, Facing, Imperfections, MountedBearing, Preload, catalogue,
};
use crate::integrate::{Grid, Integration, Method, Settings, States, System};
use crate::rotor::{Freedoms, Load, Rotor, RotorDefinition, Shaft};

/// Mass of the shaft and of the housing, kg.
const MASSES: [f64; 2] = [5.0, 12.0];
/// Springs of the housing to the ground along x, y and z, N/m.
const SPRINGS: [f64; 3] = [3e8, 2e8, 1e8];

/// A shaft on 7205C bearings at two places of it, facing each other, thrust and weight on it.
fn definition(law: ContactLaw, freedoms: Freedoms) -> RotorDefinition {
    let entry = catalogue::find("7205C").expect("a designation of the catalogue");
    let mounted = |position, facing| MountedBearing {
        bearing: entry.bearing().expect("a bearing"),
        law,
        oil: None,
        position,
        facing,
        preload: Preload::AxialOffset(20e-6),
        contact_damping: ContactDamping::default(),
        first_ball: 0.3,
        imperfections: Imperfections::default(),
        housing: None,
    };
    let shaft = Shaft {
        mass: MASSES[0],
        inertia_transverse: 0.01,
        inertia_polar: 0.004,
        eccentricity: 2e-6,
        unbalance: Default::default(),
        freedoms,
        gravity: true,
        held_tilt: [0.0; 2],
    };
    let bearings = vec![mounted(-0.03, Facing::PlusZ), mounted(0.04, Facing::MinusZ)];
    RotorDefinition {
        speed: 700.0,
        loads: vec![Load::constant([0.0, 0.0, 300.0, 0.0, 0.0], 0.0)],
        ..RotorDefinition::new(shaft, bearings)
    }
}

/// The structure of a definition with all bearings on one housing, which moves along x, y and z.
fn on_housing(definition: &RotorDefinition) -> Structure {
    let active = definition.shaft.freedoms.axes().len();
    let housing = [active, active + 1, active + 2];
    let grounded = Structure::from_definition(definition).expect("a rigid shaft");
    let mut structure = grounded.arranged(housing.len(), &[]);
    for (axis, index) in housing.into_iter().enumerate() {
        structure.coordinates[index] = Coordinate::from_axis(axis, " of the housing");
        structure.matrices.mass[(index, index)] = MASSES[1];
        structure.matrices.stiffness[(index, index)] = SPRINGS[axis];
    }
    let [x, y, z] = housing;
    let shaft = structure.shaft;
    for attachment in &mut structure.attachments {
        attachment.inner.point = shaft;
        attachment.outer = Some(Place {
            point: Point {
                coordinates: [x, y, z, usize::MAX, usize::MAX],
            },
            arm: 0.0,
        });
    }
    for place in &mut structure.load_places {
        place.point = shaft;
    }
    for own in &mut structure.unbalances {
        own.point = shaft;
    }
    structure
}

fn housed(law: ContactLaw, freedoms: Freedoms) -> (Rotor, Rotor) {
    let definition = definition(law, freedoms);
    let grounded = Rotor::assemble(&definition).expect("a rotor");
    let housed = Rotor::from_structure(on_housing(&definition), &definition).expect("a rotor");
    (grounded, housed)
}

fn near(found: f64, expected: f64, relative: f64) {
    let apart = (found - expected).abs();
    assert!(
        apart <= relative * expected.abs(),
        "{found:e}, not {expected:e}"
    );
}

#[test]
fn a_housing_yields_and_carries_its_bearings_along() {
    for freedoms in [Freedoms::Radial, Freedoms::All] {
        let (grounded, housed) = housed(ContactLaw::Hertz, freedoms);
        let active = freedoms.axes().len();
        let weight = 9.806_65 * MASSES[0];
        let yielding = [0.0, -weight / SPRINGS[1]];
        for (axis, expected) in yielding.into_iter().enumerate() {
            let (own, whole) = (
                housed.start.rest[active + axis],
                housed.start.equilibrium.displacement[axis],
            );
            assert!((own - expected).abs() < 1e-18, "{own:e}");
            let relative = grounded.start.equilibrium.displacement[axis];
            assert!((whole - own - relative).abs() < 1e-17, "{whole:e}");
        }
        assert_eq!(housed.states(), 2 * (active + 3));
    }
}

/// ω of two masses in a row: m – k – M – K – ground, rad/s, lower first.
fn in_a_row([m, big_m]: [f64; 2], [k, big_k]: [f64; 2]) -> [f64; 2] {
    // ω⁴ m M − ω² (m (k + K) + M k) + k K = 0
    let (a, b, c) = (m * big_m, m * (k + big_k) + big_m * k, k * big_k);
    let root = (b * b - 4.0 * a * c).sqrt();
    [2.0 * c / (b + root), (b + root) / (2.0 * a)].map(f64::sqrt)
}

#[test]
fn natural_frequencies_are_those_of_two_masses_in_a_row() {
    let mut definition = definition(ContactLaw::Linear, Freedoms::Translational);
    // one bearing under thrust: x, y and z do not know of each other
    definition.bearings.truncate(1);
    (definition.shaft.gravity, definition.bearings[0].position) = (false, 0.0);
    let rotor = Rotor::from_structure(on_housing(&definition), &definition).expect("a rotor");
    let stiffness = &rotor.start.equilibrium.stiffness;
    let mut expected: Vec<f64> = (0..3)
        .flat_map(|axis| in_a_row(MASSES, [stiffness[(axis, axis)], SPRINGS[axis]]))
        .collect();
    expected.sort_by(f64::total_cmp);
    let modes = rotor.modes();
    assert_eq!(modes.len(), expected.len());
    for (mode, expected) in modes.iter().zip(expected) {
        near(mode.eigenvalue.norm(), expected, 1e-9);
    }
}

#[test]
fn coupled_masses_have_the_frequencies_of_the_whole_matrix() {
    let mut definition = definition(ContactLaw::Linear, Freedoms::Radial);
    definition.bearings.truncate(1);
    (definition.shaft.gravity, definition.bearings[0].position) = (false, 0.0);
    let mut structure = on_housing(&definition);
    let coupling = 2.5;
    (
        structure.matrices.mass[(0, 2)],
        structure.matrices.mass[(2, 0)],
    ) = (coupling, coupling);
    let rotor = Rotor::from_structure(structure, &definition).expect("a rotor");
    // along x: det(K − ω² M) = 0
    let (k, [m, big_m]) = (rotor.start.equilibrium.stiffness[(0, 0)], MASSES);
    let a = m * big_m - coupling * coupling;
    let b = m * (k + SPRINGS[0]) + big_m * k + 2.0 * coupling * k;
    let c = k * SPRINGS[0];
    let root = (b * b - 4.0 * a * c).sqrt();
    let frequencies: Vec<f64> = rotor
        .modes()
        .iter()
        .map(|mode| mode.eigenvalue.norm())
        .collect();
    for expected in [(b - root) / (2.0 * a), (b + root) / (2.0 * a)].map(f64::sqrt) {
        let apart = frequencies
            .iter()
            .map(|found| (found / expected - 1.0).abs());
        assert!(
            apart.fold(1.0, f64::min) < 1e-9,
            "{expected}: {frequencies:?}"
        );
    }
    // and M q̈ is the force
    let mut state = rotor.start_state();
    (state[0], state[2]) = (1e-6, -2e-6);
    let mut rate = vec![0.0; state.len()];
    rotor.derivative(0.0, &state, &mut rate);
    let accelerations = DVector::from_column_slice(&rate[5..]);
    let force = rotor.structure.matrices.mass.view((0, 0), (5, 5)) * accelerations;
    near(force[2], k * 3e-6 + SPRINGS[0] * 2e-6, 1e-6);
}

/// A state away from rest.
fn somewhere(rotor: &Rotor) -> Vec<f64> {
    let mut state = rotor.start_state();
    let dofs = rotor.dofs();
    for (index, state) in state.iter_mut().enumerate() {
        let size = if index < dofs { 2e-6 } else { 1e-3 };
        *state += size * (1.7 * index as f64 + 0.4).sin();
    }
    state
}

#[test]
fn bearings_act_on_the_housing_as_back_on_the_shaft() {
    let (_, rotor) = housed(ContactLaw::Hertz, Freedoms::All);
    let (state, mut rate) = (somewhere(&rotor), vec![0.0; rotor.states()]);
    rotor.derivative(0.01, &state, &mut rate);
    let rotation = rotor.speed_profile().at(0.01);
    let unbalance = rotor.excitation.unbalances[0]
        .unbalance
        .force(&rotation, crate::bearing::Angle::new(rotation.angle));
    let external = [unbalance[0], unbalance[1] - 9.806_65 * MASSES[0], 300.0];
    for axis in 0..3 {
        let momentum = MASSES[0] * rate[8 + axis] + MASSES[1] * rate[13 + axis];
        near(
            momentum,
            external[axis] - SPRINGS[axis] * state[5 + axis],
            1e-9,
        );
    }
}

#[test]
fn slopes_are_those_of_the_derivative() {
    let (_, rotor) = housed(ContactLaw::Hertz, Freedoms::All);
    let (state, states) = (somewhere(&rotor), rotor.states());
    let mut jacobian = DMatrix::zeros(states, states);
    rotor.linearisation(0.01, &state, &mut jacobian);
    let at = |column: usize, step: f64| {
        let (mut moved, mut rate) = (state.clone(), vec![0.0; states]);
        moved[column] += step;
        rotor.derivative(0.01, &moved, &mut rate);
        rate
    };
    for column in 0..states {
        let step = if column < rotor.dofs() { 1e-9 } else { 1e-4 };
        let (up, down) = (at(column, step), at(column, -step));
        let largest = jacobian.column(column).amax();
        for row in 0..states {
            let expected = (up[row] - down[row]) / (2.0 * step);
            let apart = (jacobian[(row, column)] - expected).abs();
            assert!(
                apart < 1e-6 * largest,
                "{row}, {column}: {apart:e} of {largest:e}"
            );
        }
    }
}

/// The motion from a state, 20 ms long.
fn integrated(rotor: &Rotor, method: Method, state: &[f64]) -> (Grid, States) {
    let (stop, scale) = (AtomicBool::new(false), rotor.motion_scale(1e-10));
    let grid = Grid {
        interval: 1e-3,
        count: 21,
    };
    let settings = Settings {
        method,
        tolerance: 1e-10,
        step_limit: 1_000_000,
    };
    let scaling = rotor.scaling(&scale);
    let mut integration = Integration::new(rotor, scaling, grid, settings, &stop, state);
    let mut states = States::with_capacity(state.len(), 21);
    integration.advance(21, &mut states).expect("a motion");
    (grid, states)
}

#[test]
fn methods_of_different_kinds_find_the_same_motion() {
    let (_, rotor) = housed(ContactLaw::Hertz, Freedoms::All);
    let state = somewhere(&rotor);
    let [explicit, exponential] =
        [Method::Verner76, Method::Exponential].map(|method| integrated(&rotor, method, &state).1);
    for (first, second) in explicit.iter().zip(exponential.iter()) {
        for (first, second) in first.iter().zip(second).take(rotor.dofs()) {
            assert!((first - second).abs() < 1e-14, "{first:e} {second:e}");
        }
    }
}

#[test]
fn the_energy_of_shaft_housing_and_bearings_is_accounted_for() {
    let (_, mut rotor) = housed(ContactLaw::Hertz, Freedoms::All);
    rotor.account_for_energy();
    let state = somewhere(&rotor);
    let (grid, states) = integrated(&rotor, Method::Verner76, &state);
    let balance = |time: f64, state: &[f64]| {
        let energy = rotor.energy_balance(time, state);
        let works = energy.works;
        let held = energy.kinetic + energy.stored;
        [held, held - works.loads - works.unbalance - works.rotation]
    };
    let [held, whole] = balance(0.0, &state);
    let mut exchanged = 0.0_f64;
    for (sample, state) in states.iter().enumerate() {
        let [held_now, now] = balance(grid.time(sample as u64), state);
        exchanged = exchanged.max((held_now - held).abs());
        assert!((now - whole).abs() < 1e-8 * whole, "{now:e} of {whole:e}");
    }
    assert!(exchanged > 1e-4 * whole, "{exchanged:e} of {whole:e}");
}
