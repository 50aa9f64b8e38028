//! Whirl frequencies and critical speeds against the closed forms of a rigid rotor.

use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use crate::bearing::{ContactLaw, Facing, MountedBearing, Preload};
use crate::rotor::{Damping, Freedoms, Rotor, RotorDefinition, Shaft, Whirl};
use crate::study::campbell::{
    Branch, Campbell, CampbellError, CampbellQuestion, CriticalSpeed, Mode, NEVER,
};

use crate::tests::support::{assert_near, bearing, mounted, rotor, scenario, shaft};

/// A rigid rotor on two bearings of frozen stiffness, at distances from the centre of mass.
///
/// Twelve balls, loaded along the axis only, are as stiff one way as another across it.
fn rigid(places: [f64; 2]) -> RotorDefinition {
    let faces = [Facing::PlusZ, Facing::MinusZ];
    let pair = places
        .into_iter()
        .zip(faces)
        .map(|(position, facing)| MountedBearing {
            position,
            facing,
            law: ContactLaw::Linear,
            preload: Preload::Force(200.0),
            ..mounted(bearing("7205C"))
        });
    rotor(shaft(Freedoms::All), pair.collect())
}

fn solved(rotor: RotorDefinition, to: f64, orders: &[f64]) -> Campbell {
    let question = CampbellQuestion {
        rotor,
        from: 0.0,
        to,
        count: 41,
        orders: orders.to_vec(),
        highest_frequency: None,
    };
    question.solve(&NEVER).expect("a diagram")
}

/// k_t, k_c and k_θ of the complex coordinates x + iy and θy − iθx.
fn stiffness(definition: &RotorDefinition) -> [f64; 3] {
    let rotor = Rotor::assemble(definition).expect("a rotor");
    let k = &rotor.equilibrium().stiffness;
    for (one, other) in [((0, 0), (1, 1)), ((3, 3), (4, 4)), ((0, 4), (1, 3))] {
        let (one, other) = (k[one], k[other].abs());
        assert_near("isotropy", one.abs(), other, 1e-9 * k[(0, 0)].abs());
    }
    [k[(0, 0)], k[(0, 4)], k[(3, 3)]]
}

fn of_whirl(campbell: &Campbell, whirl: Whirl) -> Vec<usize> {
    let branches = campbell.branches.iter().enumerate();
    branches
        .filter(|(_, branch)| branch.whirl() == whirl)
        .map(|(index, _)| index)
        .collect()
}

/// ω = ±I_p Ω/(2 I_t) + √((I_p Ω/(2 I_t))² + k_θ/I_t): the tilts of a symmetric rotor whirl apart.
#[test]
fn tilts_of_a_symmetric_rotor_whirl_as_the_closed_form_says() {
    let definition = rigid([-0.03, 0.03]);
    let [_, coupling, tilting] = stiffness(&definition);
    assert!(
        coupling.abs() < 1e-6 * tilting,
        "{coupling} N beside {tilting} N m"
    );
    let Shaft {
        inertia_transverse,
        inertia_polar,
        ..
    } = definition.shaft;
    let campbell = solved(definition, 20_000.0, &[1.0]);
    let mut found = 0;
    for (index, speed) in campbell.speeds.iter().enumerate().skip(1) {
        let half = 0.5 * inertia_polar * speed / inertia_transverse;
        let root = half.hypot((tilting / inertia_transverse).sqrt());
        for (whirl, expected) in [
            (Whirl::Forward, root + half),
            (Whirl::Backward, root - half),
        ] {
            let nearest = campbell
                .branches
                .iter()
                .filter_map(|branch| branch.modes[index].as_ref())
                .filter(|mode| mode.whirl() == whirl)
                .map(|mode| (TAU * mode.damped_frequency() / expected - 1.0).abs())
                .fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-10, "{whirl} at {speed} rad/s: {nearest:e}");
            found += 1;
        }
    }
    assert_eq!(found, 80);
}

/// Forward tilt, synchronous: (I_t − I_p) Ω² = k_θ; translation: Ω² = k/m.
#[test]
fn critical_speeds_of_a_symmetric_rotor_are_the_closed_forms() {
    let definition = rigid([-0.03, 0.03]);
    let [across, _, tilting] = stiffness(&definition);
    let Shaft {
        mass,
        inertia_transverse: transverse,
        inertia_polar: polar,
        ..
    } = definition.shaft;
    let campbell = solved(definition, 40_000.0, &[1.0]);
    let synchronous = |whirl: Whirl| -> Vec<f64> {
        let found = campbell.critical_speeds.iter();
        let found = found.filter(|found: &&CriticalSpeed| found.whirl == whirl);
        found.map(|found| found.speed).collect()
    };
    // the translation is no whirl of its own: both its directions have one frequency
    let nearest = |speeds: &[f64], expected: f64| {
        let apart = speeds.iter().map(|speed| (speed / expected - 1.0).abs());
        apart.fold(f64::INFINITY, f64::min)
    };
    let forward = (tilting / (transverse - polar)).sqrt();
    let backward = (tilting / (transverse + polar)).sqrt();
    let all: Vec<f64> = campbell
        .critical_speeds
        .iter()
        .map(|found| found.speed)
        .collect();
    for (name, expected, among) in [
        ("forward", forward, synchronous(Whirl::Forward)),
        ("backward", backward, synchronous(Whirl::Backward)),
        ("translation", (across / mass).sqrt(), all),
    ] {
        let apart = nearest(&among, expected);
        assert!(
            apart < 1e-10,
            "{name} {expected} rad/s: {apart:e} in {among:?}"
        );
    }
}

/// With coupling: (k − m ω²)(k_θ ∓ I_p Ω ω − I_t ω²) = k_c², forward with −… of ω > 0, backward with +.
#[test]
fn whirl_of_an_uneven_rotor_has_the_roots_of_its_equation() {
    let definition = rigid([-0.02, 0.05]);
    let [across, coupling, tilting] = stiffness(&definition);
    assert!(
        coupling.abs() > 1e-3 * (across * tilting).sqrt(),
        "{coupling} N"
    );
    let Shaft {
        mass,
        inertia_transverse,
        inertia_polar,
        ..
    } = definition.shaft;
    let campbell = solved(definition, 20_000.0, &[1.0]);
    assert_eq!(of_whirl(&campbell, Whirl::Forward).len(), 2);
    assert_eq!(of_whirl(&campbell, Whirl::Backward).len(), 2);
    for branch in &campbell.branches {
        for (speed, mode) in campbell.speeds.iter().zip(&branch.modes).skip(1) {
            let mode = mode.as_ref().expect("a mode at every speed");
            let sign = match mode.whirl() {
                Whirl::Forward => 1.0,
                Whirl::Backward => -1.0,
                Whirl::Straight | Whirl::Axial => continue,
            };
            let own = TAU * mode.damped_frequency();
            let gyroscopic = sign * inertia_polar * speed * own;
            let along = across - mass * own * own;
            let about = tilting + gyroscopic - inertia_transverse * own * own;
            let size = (across + mass * own * own) * (tilting + gyroscopic.abs());
            let missed = (along * about - coupling * coupling) / size;
            assert!(
                missed.abs() < 1e-10,
                "{own} rad/s at {speed} rad/s: {missed:e}"
            );
        }
    }
}

/// Branches that cross keep their shapes; ordered by frequency they would change places.
#[test]
fn branches_cross_and_stay_themselves() {
    let definition = RotorDefinition {
        damping: Damping::Ratio(0.02),
        ..rigid([-0.03, 0.03])
    };
    let campbell = solved(definition, 30_000.0, &[1.0]);
    assert!(
        campbell.least_assurance > 0.9,
        "{}",
        campbell.least_assurance
    );
    for branch in &campbell.branches {
        assert_eq!(branch.modes.iter().flatten().count(), campbell.speeds.len());
        for pair in branch.modes.windows(2) {
            let [a, b] = [0, 1].map(|k: usize| pair[k].as_ref().expect("a mode"));
            assert!(a.assurance(b) > 0.9);
        }
    }
    // a branch overtakes another on the way
    let order = |index: usize| -> Vec<usize> {
        let mut all: Vec<usize> = (0..campbell.branches.len()).collect();
        let at = |branch: usize| {
            let mode = campbell.branches[branch].modes[index].as_ref();
            mode.map_or(0.0, |mode| mode.damped_frequency())
        };
        all.sort_by(|a, b| at(*a).total_cmp(&at(*b)));
        all
    };
    assert_ne!(order(1), order(campbell.speeds.len() - 1));
}

#[test]
fn a_range_without_speeds_is_refused() {
    let question = CampbellQuestion {
        rotor: rigid([-0.03, 0.03]),
        from: 100.0,
        to: 100.0,
        count: 10,
        orders: vec![1.0],
        highest_frequency: None,
    };
    let error = question.solve(&NEVER).expect_err("no range");
    assert!(matches!(error, CampbellError::Range { .. }));
    assert!(
        error.to_string().contains("954.93 to 954.93 rpm"),
        "{error}"
    );
    let negative = CampbellQuestion {
        to: 200.0,
        orders: vec![-1.0],
        ..question
    };
    assert_eq!(negative.solve(&NEVER), Err(CampbellError::Order(-1.0)));
}

#[test]
fn a_diagram_that_is_stopped_has_no_end() {
    let question = CampbellQuestion {
        rotor: rigid([-0.03, 0.03]),
        from: 0.0,
        to: 200.0,
        count: 10,
        orders: vec![1.0],
        highest_frequency: None,
    };
    assert!(question.solve(&NEVER).is_ok());
    let stopped = question.solve(&AtomicBool::new(true));
    assert_eq!(stopped, Err(CampbellError::Stopped));
}

/// A shaft of 6 m and 40 mm with 10 kg in its middle: its modes are the same in number at all speeds, and enough at rest.
/// Frequencies at rest by an independent model of Timoshenko beams, 54.55, 85.70 and 108.2 Hz.
#[test]
fn a_slow_shaft_has_the_modes_of_its_highest_order() {
    let text = "[[shaft.section]]\nlength = \"6 m\"\nouter_diameter = \"40 mm\"\n[[disc]]\nposition = \"3 m\"\nmass = \"10 kg\"\n\
                inertia_transverse = \"0.05 kg m^2\"\ninertia_polar = \"0.09 kg m^2\"\n[[element]]\nposition = \"0.1 m\"\n\
                linear = { stiffness = { x = \"50 N/um\", y = \"50 N/um\", z = \"10 N/um\" } }\n[[element]]\nposition = \"5.9 m\"\n\
                linear = { stiffness = { x = \"50 N/um\", y = \"50 N/um\" } }\n[damping]\nratio = 0.01\n[speed]\nconstant = \"3000 rpm\"\n";
    let question = CampbellQuestion {
        rotor: scenario(text).question.rotor,
        from: 0.0,
        to: 900.0 * TAU / 60.0,
        count: 10,
        orders: vec![1.0, 10.0],
        highest_frequency: None,
    };
    let found = question.solve(&NEVER).expect("a diagram");
    let at_rest = |branch: &Branch| branch.modes[0].as_ref().map(Mode::damped_frequency);
    let at_rest: Vec<f64> = found.branches.iter().filter_map(at_rest).collect();
    for expected in [54.55, 85.70, 108.2] {
        let near = at_rest.iter().map(|own| (own / expected - 1.0).abs());
        let nearest = near.fold(f64::INFINITY, f64::min);
        assert!(nearest < 2e-3, "{expected} Hz: {at_rest:?}");
    }
    let tenth = found.critical_speeds.iter().filter(|own| own.order == 10.0);
    let tenth: Vec<_> = tenth.filter(|own| own.speed * 60.0 / TAU > 400.0).collect();
    let speeds: Vec<f64> = tenth.iter().map(|own| own.speed * 60.0 / TAU).collect();
    for expected in [513.3, 515.2, 649.2, 649.4] {
        let near = speeds.iter().map(|own| (own / expected - 1.0).abs());
        let nearest = near.fold(f64::INFINITY, f64::min);
        assert!(nearest < 2e-3, "{expected} rpm: {speeds:?}");
    }
    assert!(found.frequency_error().expect("an error") < 1e-2);
}

/// A housing that nothing but its own spring holds along z vibrates along it, whatever the shaft does at the size of round-off.
#[test]
fn a_housing_that_moves_along_the_axis_is_axial() {
    let text = "[shaft]\nmass = \"5 kg\"\nfreedoms = \"all\"\ninertia_transverse = \"0.02 kg m^2\"\ninertia_polar = \"0.03 kg m^2\"\n\
                [speed]\nconstant = \"300 rad/s\"\n[[element]]\nposition = \"-100 mm\"\nlinear = { stiffness = { x = \"20 N/um\", y = \
                \"30 N/um\", z = \"10 N/um\" } }\n[[element]]\nposition = \"150 mm\"\nlinear = { stiffness = { x = \"10 N/um\", y = \
                \"30 N/um\" } }\n[element.housing]\nmass = \"5 kg\"\nstiffness = { x = \"20 N/um\", y = \"50 N/um\", z = \"30 N/um\" }\n";
    let found = solved(scenario(text).question.rotor, 600.0, &[1.0]);
    for frequency in [f64::sqrt(3e7 / 5.0) / TAU, f64::sqrt(1e7 / 5.0) / TAU] {
        let near = |mode: &Mode| (mode.damped_frequency() / frequency - 1.0).abs() < 1e-6;
        let mut own = found.branches.iter();
        let own = own.find(|branch| branch.modes.iter().flatten().all(near));
        assert_eq!(
            own.expect("a branch").whirl(),
            Whirl::Axial,
            "{frequency} Hz"
        );
    }
}
