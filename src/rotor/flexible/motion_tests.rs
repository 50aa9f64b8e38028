//! A shaft that bends in motion: the rigid limit, slopes, energy, statics, damping that turns with it.

use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use nalgebra::{DMatrix, DVector};

use crate::bearing::{
    ContactDamping, ContactLaw, Facing, Housing, Imperfections, MountedBearing, Preload, catalogue,
};
use crate::integrate::{Counters, Grid, Integration, Method, Settings, States, System};
use crate::physics::{BeamElement, Material};
use crate::rotor::load::{Harmonic, HarmonicRate};
use crate::rotor::{
    Damping, Disc, Drive, ElementLaw, FlexibleShaft, ForceElement, Freedoms, LinearLaw, Load,
    LoadKind, PlaneUnbalance, PointUnbalance, Rotor, RotorDefinition, Shaft, Whirl,
};

const STEEL: Material = Material {
    youngs_modulus: 210e9,
    poisson_ratio: 0.3,
    density: 7850.0,
};
const LENGTH: f64 = 0.5;
const BEARINGS: [f64; 2] = [0.05, 0.45];
const UNBALANCES: [(f64, f64, f64); 2] = [(2e-5, 0.4, 0.15), (3e-5, 2.0, 0.4)];

/// A shaft of 40 mm with a disc off its middle, softer by a factor.
fn shaft(softness: f64) -> FlexibleShaft {
    FlexibleShaft {
        sections: vec![BeamElement {
            length: LENGTH,
            outer_diameter: 0.04,
            inner_diameter: 0.0,
            material: Material {
                youngs_modulus: STEEL.youngs_modulus / softness,
                ..STEEL
            },
        }],
        discs: vec![Disc {
            position: 0.2,
            mass: 6.0,
            inertia_transverse: 0.02,
            inertia_polar: 0.03,
            hub_width: 0.0,
        }],
        unbalances: UNBALANCES
            .map(|(amount, angle, position)| PointUnbalance {
                position,
                amount,
                angle,
            })
            .to_vec(),
        observed: 0.2,
        modes: Some(2),
        ..FlexibleShaft::default()
    }
}

fn on_bearings(flexible: FlexibleShaft) -> RotorDefinition {
    let entry = catalogue::find("7205C").expect("a designation of the catalogue");
    let mounted = |position, facing| MountedBearing {
        bearing: entry.bearing().expect("a bearing"),
        law: ContactLaw::Hertz,
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
        mass: flexible.mass(),
        inertia_transverse: flexible.inertia_transverse(),
        inertia_polar: flexible.inertia_polar(),
        eccentricity: 0.0,
        unbalance: PlaneUnbalance::default(),
        freedoms: Freedoms::All,
        gravity: true,
        held_tilt: [0.0; 2],
    };
    let bearings = vec![
        mounted(BEARINGS[0], Facing::PlusZ),
        mounted(BEARINGS[1], Facing::MinusZ),
    ];
    RotorDefinition {
        speed: 500.0,
        loads: vec![Load::constant([0.0, 0.0, 300.0, 0.0, 0.0], BEARINGS[0])],
        flexible: Some(flexible),
        ..RotorDefinition::new(shaft, bearings)
    }
}

/// The rigid shaft of the same masses, at the place of the observed point.
fn rigid(definition: &RotorDefinition) -> RotorDefinition {
    let flexible = definition.flexible.as_ref().expect("a shaft that bends");
    let parts = [(flexible.discs[0].mass, flexible.discs[0].position)];
    let own = flexible.mass() - parts[0].0;
    let centre = (parts[0].0 * parts[0].1 + own * 0.5 * LENGTH) / flexible.mass();
    let mut rigid = definition.clone();
    rigid.flexible = None;
    for bearing in &mut rigid.bearings {
        bearing.position -= centre;
    }
    for (amount, angle, position) in UNBALANCES {
        rigid.shaft.unbalance.add(amount, angle, position - centre);
    }
    rigid
}

/// The motion from the start, sampled every 0.2 ms.
fn integrated(rotor: &Rotor, method: Method, count: usize) -> (Grid, States) {
    let (grid, states, _) = integrated_to(1e-10, rotor, method, count);
    (grid, states)
}

/// It and the work, to a tolerance.
fn integrated_to(
    tolerance: f64,
    rotor: &Rotor,
    method: Method,
    count: usize,
) -> (Grid, States, Counters) {
    let (stop, scale) = (AtomicBool::new(false), rotor.motion_scale(1e-10));
    let grid = Grid {
        interval: 2e-4,
        count: count as u64,
    };
    let settings = Settings {
        method,
        tolerance,
        step_limit: 10_000_000,
    };
    let scaling = rotor.scaling(&scale);
    let start = rotor.start_state();
    let mut integration = Integration::new(rotor, scaling, grid, settings, &stop, &start);
    let mut states = States::with_capacity(start.len(), count);
    integration.advance(count, &mut states).expect("a motion");
    (grid, states, integration.counters())
}

/// All that may act: two loads at their places, a base that shakes, a housing, damping of both kinds.
fn everything() -> RotorDefinition {
    let harmonic = |amplitude, rate| Harmonic {
        amplitude,
        rate,
        phase: 0.3,
    };
    let mut definition = on_bearings(FlexibleShaft {
        internal_damping: 2e-6,
        ..shaft(1.0)
    });
    definition.damping = Damping::Ratio(0.02);
    definition.loads = vec![
        Load {
            kind: LoadKind::Harmonic(harmonic(
                [100.0, 50.0, 20.0, 0.5, 0.2],
                HarmonicRate::Frequency(700.0),
            )),
            position: 0.1,
        },
        Load {
            kind: LoadKind::Base(Box::new(LoadKind::Harmonic(harmonic(
                [3.0, 5.0, 1.0, 0.0, 0.0],
                HarmonicRate::Order(1.5),
            )))),
            position: 0.0,
        },
        Load::constant([0.0, 0.0, 300.0, 0.0, 0.0], 0.1),
        Load::constant([200.0, -100.0, 0.0, 0.0, 0.0], 0.35),
    ];
    definition.bearings[0].housing = Some(Housing {
        mass: 3.0,
        stiffness: [2e8, 3e8, 1e8],
        damping: [500.0, 400.0, 300.0],
        resonator: None,
    });
    definition.initial.displacement[0] = Some(3e-6);
    definition.initial.velocity[1] = Some(2e-3);
    definition
}

#[test]
fn a_stiff_shaft_moves_as_a_rigid_one() {
    let definition = on_bearings(shaft(1e-6));
    let rotors = [&definition, &rigid(&definition)]
        .map(|definition| Rotor::assemble(definition).expect("a rotor"));
    let frequencies = rotors.each_ref().map(Rotor::natural_frequencies);
    for (stiff, rigid) in frequencies[0].iter().zip(&frequencies[1]) {
        let apart = (stiff.frequency / rigid.frequency - 1.0).abs();
        assert!(
            apart < 1e-4,
            "{} Hz, not {} Hz",
            stiff.frequency,
            rigid.frequency
        );
        assert_eq!(stiff.whirl, rigid.whirl);
    }
    let definition = on_bearings(shaft(1e-2));
    let centre = definition.bearings[0].position - rigid(&definition).bearings[0].position;
    let arm = 0.2 - centre;
    let motions = [&definition, &rigid(&definition)].map(|definition| {
        let rotor = Rotor::assemble(definition).expect("a rotor");
        let states = integrated(&rotor, Method::Verner76, 26).1;
        let shaft = |state: &[f64]| rotor.structure.shaft.displacement(state, &rotor.start.rest);
        states.iter().map(shaft).collect::<Vec<_>>()
    });
    let mut largest = [0.0_f64; 2];
    for (stiff, rigid) in motions[0].iter().zip(motions[1].iter()) {
        let expected = [
            rigid[0] + arm * rigid[4],
            rigid[1] - arm * rigid[3],
            rigid[2],
        ];
        for (found, expected) in stiff.iter().zip(expected) {
            largest[0] = largest[0].max((found - expected).abs());
            largest[1] = largest[1].max(expected.abs());
        }
    }
    assert!(largest[0] < 2e-2 * largest[1], "{largest:?}");
}

/// A state off that of the start in all of its components.
fn somewhere(rotor: &Rotor) -> Vec<f64> {
    let (mut state, states) = (rotor.start_state(), rotor.states());
    for (index, state) in state.iter_mut().enumerate() {
        let size = if index < states / 2 { 1e-6 } else { 1e-3 };
        *state += size * (1.7 * index as f64 + 0.4).sin();
    }
    state
}

/// c + A y + D w is the derivative, and A + D K its slopes, by the forces that act and the states that they depend on alone:
/// with contacts damped or not, and with a base that shakes or not.
#[test]
fn both_parts_of_the_derivative_make_it() {
    for (damped, shaken) in [(false, false), (true, false), (false, true)] {
        let mut definition = everything();
        if !shaken {
            definition.loads.remove(1);
        }
        if damped {
            definition.bearings[0].contact_damping.inner = 0.2;
        }
        let rotor = Rotor::assemble(&definition).expect("a rotor");
        let (state, states) = (somewhere(&rotor), rotor.states());
        let separated = rotor.separated(0.01, &state).expect("two parts");
        let few = separated.seen.len() + separated.acting.len();
        assert!(few < states, "{few} of {states}");
        // what is not seen is no number
        let mut seen = vec![f64::NAN; states];
        for position in &separated.seen {
            seen[*position] = state[*position];
        }
        let mut forces = vec![f64::NAN; states];
        rotor.forces(0.01, &seen, &mut forces);
        let acting = separated.acting.iter().map(|position| forces[*position]);
        let acting = DVector::from_iterator(separated.acting.len(), acting);
        let found = &separated.matrix * DVector::from_column_slice(&state)
            + DVector::from_column_slice(&separated.constant)
            + &separated.inputs * acting;
        let mut rate = vec![0.0; states];
        rotor.derivative(0.01, &state, &mut rate);
        let mut slopes = DMatrix::zeros(states, states);
        rotor.linearisation(0.01, &state, &mut slopes);
        let jacobian = separated.jacobian();
        let largest = DVector::from_column_slice(&rate).amax();
        for row in 0..states {
            let apart = (found[row] - rate[row]).abs();
            assert!(apart < 1e-9 * largest, "{row}: {apart:e} of {largest:e}");
            let apart = (jacobian.row(row) - slopes.row(row)).amax();
            let largest = slopes.row(row).amax();
            assert!(apart < 1e-10 * largest, "{row}: {apart:e} of {largest:e}");
        }
    }
}

/// With four times as many modes an evaluation of the exponential method sees as few states and forces, and half as many more
/// are enough for the same error, from a start at which all modes vibrate.
#[test]
fn modes_cost_the_exponential_method_few_steps() {
    let tolerance = 1e-6;
    let [few, many] = [2, 8].map(|modes| {
        let rotor = Rotor::assemble(&on_bearings(FlexibleShaft {
            modes: Some(modes),
            ..shaft(1.0)
        }))
        .expect("a rotor");
        let (_, states, counters) = integrated_to(tolerance, &rotor, Method::Exponential, 16);
        let exact = integrated(&rotor, Method::Verner76, 16).1;
        let scaling = rotor.scaling(&rotor.motion_scale(1e-10));
        let pairs = states.iter().zip(exact.iter());
        let apart = pairs.flat_map(|(found, exact)| {
            let [found, exact] = [found, exact].map(|state| scaling.scaled(state));
            found.into_iter().zip(exact).map(|(a, b)| (a - b).abs())
        });
        let error = apart.fold(0.0, f64::max);
        assert!(error < 3.0 * tolerance, "{modes} modes: {error:e}");
        let separated = rotor.separated(0.0, &rotor.start_state());
        let separated = separated.expect("two parts");
        let width = separated.seen.len() + separated.acting.len();
        (counters.evaluations as f64, width)
    });
    assert!(many.0 < 1.5 * few.0, "{many:?} and {few:?} evaluations");
    assert_eq!(many.1, few.1);
}

#[test]
fn slopes_are_those_of_the_derivative() {
    let mut definition = everything();
    definition.speed_points = vec![crate::rotor::SpeedPoint {
        time: 1.0,
        speed: 900.0,
    }];
    let rotor = Rotor::assemble(&definition).expect("a rotor");
    let (state, states) = (somewhere(&rotor), rotor.states());
    let (mut slopes, mut by_time) = (DMatrix::zeros(states, states), vec![0.0; states]);
    rotor.linearisation(0.01, &state, &mut slopes);
    rotor.rate_by_time(0.01, &state, &mut by_time);
    let (mut expected, mut expected_by_time) = (slopes.clone(), by_time.clone());
    rotor.linearise_by_differences(0.01, &state, &mut expected);
    rotor.find_rate_by_time_differences(0.01, &state, &mut expected_by_time);
    let near = |found: f64, expected: f64, scale: f64, what: &str| {
        let apart = (found - expected).abs();
        assert!(apart < 1e-5 * scale, "{what}: {found:e}, not {expected:e}");
    };
    for row in 0..states {
        let scale = expected.row(row).amax();
        for column in 0..states {
            let what = format!("{row}, {column}");
            near(slopes[(row, column)], expected[(row, column)], scale, &what);
        }
        let scale = expected_by_time.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        near(
            by_time[row],
            expected_by_time[row],
            100.0 * scale,
            "by time",
        );
    }
}

/// The observed force of all bearings does, in a rigid motion of the shaft, the work of what each of them exerts at its point.
#[test]
fn moments_of_the_bearings_are_about_the_observed_point() {
    let mut definition = on_bearings(shaft(1.0));
    for bearing in &mut definition.bearings {
        bearing.contact_damping = ContactDamping {
            inner: 0.2,
            outer: 0.3,
        };
    }
    let rotor = Rotor::assemble(&definition).expect("a rotor");
    let (mut state, dofs) = (rotor.start_state(), rotor.dofs());
    for (index, rate) in state[dofs..].iter_mut().enumerate() {
        *rate = 1e-2 * (1.7 * index as f64 + 0.4).sin();
    }
    let sample = rotor.sample(0.01, &state, &mut rotor.ball_contacts());
    let rotation = rotor.speed_profile().at(0.01);
    let [mut held, mut damped] = [(); 2].map(|()| vec![0.0; dofs]);
    for (bearing, motion) in rotor
        .elements
        .bearings_at(&rotor.instant(&state, &rotation))
    {
        let (place, rate) = (&motion.displacement, &motion.rate);
        let [elastic, damping] = bearing.support.damped_force(place, rate, &motion.rotation);
        bearing.attachment.add_force(-1.0, &elastic, &mut held);
        bearing.attachment.add_force(-1.0, &damping, &mut damped);
    }
    let found = sample.force_on_shaft.expect("observed");
    for (axis, found) in found.into_iter().enumerate() {
        let motion = &rotor.structure.rigid_motions[axis];
        let along =
            |forces: &[f64]| -> f64 { forces.iter().zip(motion.iter()).map(|(a, b)| a * b).sum() };
        let (expected, damping) = (along(&held) + along(&damped), along(&damped));
        assert!(damping.abs() > 1e-3, "{axis}: {damping:e}");
        let apart = (found - expected).abs();
        assert!(
            apart < 1e-9 * expected.abs().max(1.0),
            "{axis}: {found}, not {expected}"
        );
    }
}

/// Springs and dampers on the ground.
fn linear_element(position: f64, stiffness: [f64; 5], damping: [f64; 5]) -> ForceElement {
    ForceElement {
        position: Some(position),
        housing_of: None,
        housing: None,
        law: ElementLaw::Linear(Box::new(LinearLaw::new(
            (stiffness, [0.0; 2]),
            (damping, [0.0; 2]),
        ))),
    }
}

#[test]
fn all_bearings_of_a_shaft_that_bends_balance_its_inertia() {
    let mut definition = everything();
    definition.damping = Damping::Undamped;
    let springs = |position| {
        let damping = [300.0, 200.0, 100.0, 0.5, 0.4];
        linear_element(position, [4e6, 3e6, 2e6, 5e3, 7e3], damping)
    };
    definition.elements = vec![springs(0.02), springs(0.3)];
    let rotor = Rotor::assemble(&definition).expect("a rotor");
    let (mut state, dofs) = (rotor.start_state(), rotor.dofs());
    for (index, value) in state.iter_mut().enumerate() {
        let size = if index < dofs { 1e-6 } else { 1e-2 };
        *value += size * (1.7 * index as f64 + 0.4).sin();
    }
    let (time, mut rate) = (0.01, Vec::new());
    let sample = rotor.whole_sample(time, &state, &mut rotor.ball_contacts(), Some(&mut rate));
    // M q̈ + ω G q̇ less what is not of the bearings
    let rotation = rotor.speed_profile().at(time);
    let accelerations = DVector::from_column_slice(&rate[dofs..2 * dofs]);
    let mut due = (&rotor.linear.mass.entries * accelerations)
        .as_slice()
        .to_vec();
    rotor
        .linear
        .gyroscopic
        .add_product(rotation.speed, &state[dofs..2 * dofs], &mut due);
    let mut others = rotor.excitation.constant_force.clone();
    let phases = rotor.elements.phases(&rotation);
    rotor
        .excitation
        .add_varying_forces::<false>(time, &rotation, &phases, &mut others);
    for (axis, total) in sample
        .force_on_shaft
        .expect("observed")
        .into_iter()
        .enumerate()
    {
        let motion = rotor.structure.rigid_motions[axis].iter();
        let due: f64 = motion
            .zip(due.iter().zip(&others))
            .map(|(t, (a, b))| t * (a - b))
            .sum();
        assert!(
            (total - due).abs() < 1e-7 * due.abs().max(1.0),
            "{axis}: {total}, not {due}"
        );
        let sum: f64 = sample.bearing_forces.iter().map(|force| force[axis]).sum();
        assert!(
            (total - sum).abs() < 1e-9 * total.abs().max(1.0),
            "{axis}: {sum}"
        );
    }
    assert_eq!(sample.bearing_forces.len(), 4);
}

/// Largest residual of the energy of a motion, and the largest of its parts.
fn energy_residual(definition: &RotorDefinition) -> [f64; 2] {
    let mut rotor = Rotor::assemble(definition).expect("a rotor");
    rotor.account_for_energy();
    let (grid, states) = integrated(&rotor, Method::Verner76, 101);
    let start = rotor.energy_balance(0.0, &rotor.start_state());
    let mut found = [0.0_f64; 2];
    for (sample, state) in states.iter().enumerate() {
        let now = rotor.energy_balance(grid.time(sample as u64), state);
        found[0] = found[0].max(now.residual(&start).abs());
        found[1] = found[1].max(now.largest(&start));
    }
    found
}

#[test]
fn the_energy_of_everything_closes() {
    let [residual, largest] = energy_residual(&everything());
    assert!(residual < 1e-8 * largest, "{residual:e} of {largest:e}");
}

#[test]
fn energy_closes_with_a_drive_and_unbalances_in_two_planes() {
    for bends in [true, false] {
        let mut definition = everything();
        // heavy unbalances, so that they ask much of the rotation
        let flexible = definition.flexible.as_mut().expect("a shaft that bends");
        for own in &mut flexible.unbalances {
            own.amount *= 20.0;
        }
        if !bends {
            definition.loads.truncate(3);
            definition = rigid(&definition);
            definition.shaft.unbalance.couple = [3e-5, -2e-5];
        }
        definition.drive = Some(Drive {
            torque: 5.0,
            no_load_speed: Some(800.0),
            load_torque: 1.0,
            friction: true,
            compliance: 0.0,
        });
        let [residual, largest] = energy_residual(&definition);
        assert!(
            residual < 1e-9 * largest,
            "{bends}: {residual:e} of {largest:e}"
        );
    }
}

/// A shaft of 20 mm between pins, with a point mass in its middle.
fn laval(density: f64, internal_damping: f64) -> RotorDefinition {
    let flexible = FlexibleShaft {
        sections: vec![BeamElement {
            length: 0.8,
            outer_diameter: 0.02,
            inner_diameter: 0.0,
            material: Material { density, ..STEEL },
        }],
        discs: vec![Disc {
            position: 0.4,
            mass: 4.0,
            inertia_transverse: 0.02,
            inertia_polar: 0.03,
            hub_width: 0.0,
        }],
        observed: 0.4,
        modes: Some(4),
        internal_damping,
        ..FlexibleShaft::default()
    };
    let pin = |position| linear_element(position, [1e12, 1e12, 1e9, 0.0, 0.0], [0.0; 5]);
    RotorDefinition {
        bearings: Vec::new(),
        elements: vec![pin(0.0), pin(0.8)],
        loads: Vec::new(),
        ..on_bearings(flexible)
    }
}

#[test]
fn a_pinned_shaft_yields_as_a_beam_and_has_its_frequency() {
    let mut definition = laval(1.0, 0.0);
    definition.shaft.gravity = false;
    definition.loads = vec![Load::constant([100.0, 0.0, 0.0, 0.0, 0.0], 0.4)];
    let rotor = Rotor::assemble(&definition).expect("a rotor");
    // F L³/(48 E I) + F L/(4 κ G A)
    let (area, second) = (TAU / 8.0 * 4e-4, TAU / 128.0 * 1.6e-7);
    let shear = 6.0 * 1.3 / (7.0 + 6.0 * 0.3) * 210e9 / 2.6 * area;
    let compliance = 0.512 / (48.0 * 210e9 * second) + 0.2 / shear;
    let deflection = rotor.equilibrium().displacement[0];
    let expected = 100.0 * compliance;
    assert!(
        (deflection / expected - 1.0).abs() < 1e-6,
        "{deflection:e}, not {expected:e}"
    );
    let stiffness = rotor.equilibrium().stiffness[(0, 0)];
    assert!((stiffness * compliance - 1.0).abs() < 1e-6, "{stiffness:e}");
    let frequency = rotor.natural_frequencies()[0].frequency;
    let expected = (1.0 / (4.0 * compliance)).sqrt() / TAU;
    assert!(
        (frequency / expected - 1.0).abs() < 1e-4,
        "{frequency} Hz, not {expected} Hz"
    );
}

#[test]
fn inner_damping_drives_a_whirl_above_the_speed_of_the_books() {
    // ω = ω_n (1 + c_external/c_internal)
    let (internal, external) = (20e-6, 3.0);
    let mut definition = laval(1.0, internal);
    definition.damping = Damping::Coefficients([external, external, 0.0, 0.0, 0.0]);
    let natural = {
        let rotor = Rotor::assemble(&laval(1.0, 0.0)).expect("a rotor");
        TAU * rotor.natural_frequencies()[0].frequency
    };
    let limit = natural * (1.0 + external / (internal * natural * natural * 4.0));
    for (factor, stable) in [(0.99, true), (1.01, false)] {
        definition.speed = factor * limit;
        let rotor = Rotor::assemble(&definition).expect("a rotor");
        let modes = rotor.natural_frequencies();
        let forward = modes.iter().find(|mode| mode.whirl == Whirl::Forward);
        let ratio = forward.expect("a forward mode").damping_ratio;
        assert_eq!(ratio > 0.0, stable, "{ratio:e} at {factor} of the limit");
    }
    assert!(limit > 1.2 * natural, "{limit}, {natural}");
}

/// The stiffer motions of the shaft are overdamped; seen from the ground they turn with it, at its frequency.
#[test]
fn overdamped_motions_that_turn_with_the_shaft_are_no_modes() {
    let mut definition = laval(7850.0, 1e-3);
    definition.speed = 150.0;
    let modes = Rotor::assemble(&definition).expect("a rotor").modes();
    let ratios = modes.iter().map(|mode| mode.damping_ratio().abs());
    let largest = ratios.fold(0.0, f64::max);
    assert!(!modes.is_empty() && largest < 0.9, "{largest}");
}
