//! Freedoms that nothing holds: refused before the first step where the scene rests on their
//! stiffness, run with a warning where it does not.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::bearing::{ContactLaw, MountedBearing};
use crate::rotor::load::{Harmonic, HarmonicRate};
use crate::rotor::{
    CageMotion, Damping, Freedoms, InitialPosition, InitialState, Load, LoadKind, Rotor,
    RotorDefinition, Sample, UnconstrainedError,
};
use crate::simulate::{Run, SimulateError, speed_warnings};

use crate::tests::support::{
    back_to_back_pair, constant, literature_bearing, model, mounted, rotor, shaft, try_run, under,
};

const COEFFICIENTS: Damping = Damping::Coefficients([200.0, 200.0, 200.0, 1.0, 1.0]);

/// A shaft in a clearance of 3 µm, without weight or load, 150 rad/s, unbalanced by 5 µm.
fn floating() -> RotorDefinition {
    let bearing = literature_bearing(8, [11.9062e-3, 52e-3], 3e-6, 1.334e10);
    let mut definition = RotorDefinition {
        speed: 150.0,
        damping: COEFFICIENTS,
        ..rotor(shaft(Freedoms::Radial), vec![mounted(bearing)])
    };
    definition.shaft.eccentricity = 5e-6;
    definition
}

/// What 20 ms of a scene give.
fn run(definition: RotorDefinition) -> (Result<Run, SimulateError>, Vec<Sample>) {
    try_run(&model(definition, 0.02, 10_000.0), 0.0)
}

/// The error of a scene that must be refused before the first sample.
#[track_caller]
fn refusal(definition: RotorDefinition) -> UnconstrainedError {
    let (result, samples) = run(definition);
    assert!(samples.is_empty(), "{} samples", samples.len());
    match result {
        Err(SimulateError::Unconstrained(error)) => error,
        other => panic!("not refused as unconstrained: {other:?}"),
    }
}

/// The warning of a scene that runs although something is unconstrained.
#[track_caller]
fn warning(definition: RotorDefinition) -> String {
    let (result, samples) = run(definition);
    let warnings = result.expect("the scene runs").warnings;
    assert_eq!(samples.len(), 201);
    let unconstrained = warnings.iter().find(|text| text.contains("nothing holds"));
    unconstrained
        .unwrap_or_else(|| panic!("no warning: {warnings:?}"))
        .clone()
}

#[test]
fn a_shaft_that_floats_in_its_clearance_is_told() {
    let text = warning(floating());
    assert!(
        text.contains("along x, y at the static equilibrium"),
        "{text}"
    );
    assert!(text.contains("0.0e0 N/m, where a loaded contact"), "{text}");
}

/// What linearises the shaft has no motion that would tell.
#[test]
fn linearised_answers_say_what_nothing_holds() {
    let told = speed_warnings(&floating());
    let unconstrained = told.iter().find(|text| text.contains("nothing holds"));
    let text = unconstrained.unwrap_or_else(|| panic!("no warning: {told:?}"));
    assert!(text.contains("natural frequencies leave it out"), "{text}");
    let loaded = RotorDefinition {
        loads: constant([100.0, -500.0, 0.0, 0.0, 0.0]),
        ..floating()
    };
    assert_eq!(speed_warnings(&loaded), Vec::<String>::new());
}

#[test]
fn a_ratio_of_no_critical_damping_is_refused() {
    let error = refusal(RotorDefinition {
        damping: Damping::Ratio(0.02),
        ..floating()
    });
    let UnconstrainedError::Damping(unconstrained) = &error else {
        panic!("{error}");
    };
    assert_eq!(
        (unconstrained.freedoms.as_str(), unconstrained.stiffness),
        ("x, y", 0.0)
    );
    let text = error.to_string();
    for remedy in [
        "damping.coefficients",
        "a load or a preload",
        "shaft.freedoms",
    ] {
        assert!(text.contains(remedy), "{text}");
    }
    // a ratio of zero asks for none
    warning(RotorDefinition {
        damping: Damping::Ratio(0.0),
        ..floating()
    });
}

#[test]
fn damping_in_proportion_to_no_stiffness_is_refused() {
    let error = refusal(RotorDefinition {
        damping: Damping::StiffnessTime(1e-5),
        ..floating()
    });
    assert!(matches!(error, UnconstrainedError::Damping(_)), "{error}");
}

#[test]
fn a_linear_bearing_that_holds_nothing_is_refused() {
    let mut definition = floating();
    definition.bearings[0].law = ContactLaw::Linear;
    let error = refusal(definition);
    assert!(matches!(error, UnconstrainedError::Linear(_)), "{error}");
    assert!(error.to_string().contains("contact = \"hertz\""), "{error}");
}

#[test]
fn a_start_that_is_one_of_many_is_refused() {
    let still = || {
        let mut definition = floating();
        definition.shaft.eccentricity = 0.0;
        definition
    };
    let error = refusal(still());
    assert!(matches!(error, UnconstrainedError::Start(_)), "{error}");
    assert!(
        error.to_string().contains("initial.displacement"),
        "{error}"
    );
    // said where, or shaken, or pushed, it is a scene again
    let origin = InitialState {
        from: InitialPosition::Origin,
        ..still().initial
    };
    let placed = InitialState {
        displacement: [Some(1e-6), Some(0.0), None, None, None],
        ..still().initial
    };
    let pushed = InitialState {
        velocity: [Some(1e-3), Some(1e-3), None, None, None],
        ..still().initial
    };
    for initial in [origin, placed, pushed] {
        warning(RotorDefinition { initial, ..still() });
    }
    let shaken = Harmonic {
        amplitude: [1.0, 1.0, 0.0, 0.0, 0.0],
        rate: HarmonicRate::Frequency(50.0),
        phase: 0.0,
    };
    let shaken = Load {
        kind: LoadKind::Harmonic(shaken),
        position: 0.0,
    };
    warning(under(still(), [shaken]));
}

/// In its clearance a shaft rests on a single ball right below, which holds it along y alone; half the spacing of their rolling elements
/// later two balls hold it. Damping that is derived from a stiffness is that of the latter, unless the cage stands.
#[test]
fn a_shaft_on_a_single_ball_is_damped_as_on_two() {
    let resting = |first_ball: f64, cage: CageMotion| {
        let mut definition = floating();
        definition.loads = constant([0.0, -10.0, 0.0, 0.0, 0.0]);
        definition.damping = Damping::Ratio(0.03);
        definition.bearings[0].first_ball = first_ball;
        definition.cage = cage;
        definition
    };
    let below = -FRAC_PI_2;
    let text = warning(resting(below, CageMotion::Rolling));
    assert!(text.contains("along x at"), "{text}");
    assert!(
        text.contains("half the spacing of their rolling elements"),
        "{text}"
    );
    let damping = |definition| {
        Rotor::assemble(&definition)
            .expect("a rotor")
            .damping_matrix()
    };
    let [single, two] =
        [below, below + PI / 8.0].map(|first| damping(resting(first, CageMotion::Rolling)));
    assert!(single[0][0] > 100.0 && single[1][1] > 100.0, "{single:?}");
    assert_eq!(single, two);
    let error = refusal(resting(below, CageMotion::Frozen));
    assert!(matches!(error, UnconstrainedError::Damping(_)), "{error}");
}

#[test]
fn the_axial_freedom_alone_is_named() {
    // radially driven, axially nothing
    let definition = RotorDefinition {
        shaft: crate::rotor::Shaft {
            eccentricity: 5e-6,
            ..shaft(Freedoms::Translational)
        },
        ..floating()
    };
    let error = refusal(definition);
    let UnconstrainedError::Start(unconstrained) = &error else {
        panic!("{error}");
    };
    assert_eq!(unconstrained.freedoms, "z");
}

/// Two bearings that hang on a ball right below each, as far before the centre of mass as behind it: passing balls move x, and by
/// symmetry nothing moves θy, which nothing holds either. It is a scene all the same.
#[test]
fn a_tilt_that_symmetry_keeps_still_is_no_reason_to_refuse() {
    let mut definition = floating();
    definition.shaft = crate::rotor::Shaft {
        inertia_transverse: 0.01,
        inertia_polar: 0.004,
        ..shaft(Freedoms::Lateral)
    };
    definition.speed = 300.0;
    definition.loads = constant([0.0, -10.0, 0.0, 0.0, 0.0]);
    let own = MountedBearing {
        first_ball: -FRAC_PI_2,
        ..definition.bearings[0].clone()
    };
    definition.bearings = [-0.03, 0.03]
        .map(|position| MountedBearing {
            position,
            ..own.clone()
        })
        .to_vec();
    let text = warning(definition);
    assert!(text.contains("x") && text.contains("tilt_y"), "{text}");
}

/// A shaft that hangs on one of three balls, which stands at −45°: held along the contact, free across.
fn on_one_ball() -> RotorDefinition {
    let bearing = literature_bearing(3, [11.9062e-3, 52e-3], 20e-6, 1.334e10);
    let mut mounted = mounted(bearing);
    mounted.first_ball = -std::f64::consts::FRAC_PI_4;
    RotorDefinition {
        loads: constant([14.0, -14.0, 0.0, 0.0, 0.0]),
        damping: COEFFICIENTS,
        ..rotor(shaft(Freedoms::Radial), vec![mounted])
    }
}

#[test]
fn a_combination_is_found_where_no_freedom_is_loose_by_itself() {
    let error = refusal(on_one_ball());
    let UnconstrainedError::Start(unconstrained) = &error else {
        panic!("{error}");
    };
    assert_eq!(unconstrained.freedoms, "x, y");
    assert!(unconstrained.stiffness.abs() < 1e-2, "{error}");
    // each of x and y by itself has its stiffness, so a ratio damps both, and the start is all that
    // is missing
    let error = refusal(RotorDefinition {
        damping: Damping::Ratio(0.02),
        ..on_one_ball()
    });
    assert!(matches!(error, UnconstrainedError::Start(_)), "{error}");
    let error = refusal(RotorDefinition {
        damping: Damping::StiffnessTime(1e-5),
        ..on_one_ball()
    });
    assert!(matches!(error, UnconstrainedError::Damping(_)), "{error}");
    // balls that pass drive it
    warning(RotorDefinition {
        speed: 150.0,
        ..on_one_ball()
    });
}

#[test]
fn a_preloaded_pair_has_nothing_loose() {
    let definition = RotorDefinition {
        speed: 150.0,
        damping: Damping::Ratio(0.02),
        ..rotor(shaft(Freedoms::All), back_to_back_pair())
    };
    let (result, _) = run(definition);
    let warnings = result.expect("it runs").warnings;
    assert!(warnings.is_empty(), "{warnings:?}");
}

#[test]
fn a_standing_shaft_that_floats_bounces_in_its_clearance() {
    // nothing gives the motion a time scale but the contact that it will meet
    let mut definition = floating();
    definition.speed = 0.0;
    definition.cage = CageMotion::Frozen;
    definition.damping = Damping::Undamped;
    definition.initial.from = InitialPosition::Origin;
    definition.initial.velocity = [Some(1e-2), None, None, None, None];
    let (result, samples) = run(definition);
    result.expect("it runs");
    let reach = samples
        .iter()
        .map(|sample| sample.displacement[0].abs())
        .fold(0.0, f64::max);
    // half the clearance and what the impact presses in
    assert!((3e-6..60e-6).contains(&reach), "{reach}");
    let turns = samples
        .windows(2)
        .filter(|pair| pair[0].velocity[0] * pair[1].velocity[0] < 0.0);
    assert!(turns.count() > 3);
    // every impact gives the speed back
    let fastest = samples
        .iter()
        .map(|sample| sample.velocity[0].abs())
        .fold(0.0, f64::max);
    assert!((fastest - 1e-2).abs() < 1e-8, "{fastest}");
}
