//! Where there is no motion that repeats, the answer says why.

use std::sync::atomic::{AtomicBool, AtomicU64};

use crate::bearing::MountedBearing;
use crate::integrate::IntegrateError;
use crate::rotor::load::{Harmonic, HarmonicRate};
use crate::rotor::{
    CageMotion, Damping, Freedoms, Load, LoadKind, Rotor, RotorDefinition, RotorError, Unrepeated,
};
use crate::steady::{
    ResponseQuestion, Stability, SteadyError, SteadyQuestion, response_warnings, steady,
};

use super::{search, shipped};
use crate::tests::support::{
    bearing, constant, model, mounted, rotor, scenario, shaft, thrust_rotor,
};

#[test]
fn what_does_not_repeat_has_no_steady_motion() {
    let told = |name: &str| search(&shipped(name), None).expect_err("nothing repeats");
    assert_eq!(
        told("run-up-7205c"),
        SteadyError::Unrepeated(Unrepeated::Speed)
    );
    assert_eq!(
        told("drive-start-7205c"),
        SteadyError::Unrepeated(Unrepeated::Drive)
    );
    let SteadyError::Unrepeated(Unrepeated::Load { what, .. }) = told("coal-impact-7205c") else {
        panic!("a load");
    };
    assert!(what.contains("shock"), "{what}");
}

#[test]
fn what_nothing_moves_rests() {
    let definition = RotorDefinition {
        cage: CageMotion::Frozen,
        ..thrust_rotor()
    };
    let error = search(&model(definition, 1.0, 1e4), None).expect_err("nothing moves");
    assert_eq!(error, SteadyError::Rest);
}

fn harmonic(frequency: f64) -> Load {
    Load {
        kind: LoadKind::Harmonic(Harmonic {
            amplitude: [1.0, 0.0, 0.0, 0.0, 0.0],
            rate: HarmonicRate::Frequency(frequency),
            phase: 0.0,
        }),
        position: 0.0,
    }
}

#[test]
fn three_frequencies_are_too_many() {
    let mut definition = thrust_rotor();
    definition.shaft.eccentricity = 1e-6;
    definition.loads.push(harmonic(123.4));
    let error = search(&model(definition, 1.0, 1e4), None).expect_err("three frequencies");
    let SteadyError::Frequencies { frequencies } = &error else {
        panic!("{error}");
    };
    assert_eq!(frequencies.len(), 3);
    assert!(error.to_string().contains("123.4"), "{error}");
}

#[test]
fn two_frequencies_have_no_multiple() {
    let error = search(&shipped("steady-7205c"), Some(2)).expect_err("no period");
    assert!(
        matches!(error, SteadyError::NoPeriod { multiple: 2, .. }),
        "{error}"
    );
}

#[test]
fn a_search_can_be_stopped() {
    let (model, stop) = (shipped("steady-7205c"), AtomicBool::new(true));
    let error = steady(&SteadyQuestion {
        model: &model,
        multiple: None,
        stop: &stop,
        integrated: &AtomicU64::new(0),
    });
    let error = error.expect_err("stopped");
    assert!(error.is_interrupted(), "{error}");
    assert!(matches!(
        error,
        SteadyError::Integrate(IntegrateError::Interrupted { .. })
    ));
}

/// Without damping a free vibration never dies: a multiplier has the magnitude 1 and the motion is neutral.
#[test]
fn an_undamped_shaft_has_multipliers_on_the_unit_circle() {
    let mut undamped = rotor(
        shaft(Freedoms::Radial),
        vec![MountedBearing {
            ..mounted(bearing("7205C"))
        }],
    );
    undamped.shaft.eccentricity = 1e-7;
    undamped.speed = 400.0;
    undamped.cage = CageMotion::Frozen;
    undamped.loads = constant([0.0, 0.0, 1000.0, 0.0, 0.0]);
    let found = search(&model(undamped, 1.0, 1e4), None).expect("a motion");
    for multiplier in found.multipliers.values() {
        assert!((multiplier.norm() - 1.0).abs() < 1e-5, "{multiplier}");
    }
    assert_eq!(found.stability, Stability::Neutral);
    assert!(
        found.warnings[0].contains("neutral"),
        "{:?}",
        found.warnings
    );
}

/// As `run`, `steady` tells of an unbalance and of pressures that no bearing is made for.
#[test]
fn the_limits_of_the_model_are_watched_as_in_a_run() {
    let mut shaft = shaft(Freedoms::Translational);
    shaft.eccentricity = 3e-4;
    let model = model(
        RotorDefinition {
            speed: 500.0,
            cage: CageMotion::Frozen,
            damping: Damping::Ratio(0.02),
            loads: constant([0.0, 0.0, 6e4, 0.0, 0.0]),
            ..rotor(shaft, vec![mounted(bearing("7205C"))])
        },
        1.0,
        1e4,
    );
    let (stop, integrated) = (AtomicBool::new(false), AtomicU64::new(0));
    let found = steady(&SteadyQuestion {
        model: &model,
        multiple: None,
        stop: &stop,
        integrated: &integrated,
    });
    let warnings = found.expect("a motion").warnings;
    for words in [
        "balance grade G",
        "at the inner race exceeds",
        "at the outer race exceeds",
    ] {
        assert!(
            warnings.iter().any(|told| told.contains(words)),
            "{words}: {warnings:#?}"
        );
    }
    assert!(integrated.into_inner() > 1);
}

#[test]
fn a_centre_of_mass_outside_the_bearings_is_refused() {
    let mut shaft = shaft(Freedoms::Translational);
    shaft.eccentricity = 2.7;
    let definition = rotor(shaft, vec![mounted(bearing("7205C"))]);
    let error = Rotor::assemble(&definition).expect_err("no such shaft");
    assert!(matches!(error, RotorError::Eccentricity { .. }), "{error}");
}

/// Two frequencies whose ratio is all but 1 lead too slowly around; what was searched is told, 8192 periods a node.
#[test]
fn periods_that_were_searched_are_told() {
    let mut definition = thrust_rotor();
    definition.cage = CageMotion::Frozen;
    definition.loads.push(harmonic(100.0));
    definition.loads.push(harmonic(100.0 * (1.0 + 1e-9)));
    let error = search(&model(definition, 1.0, 1e4), None).expect_err("nearly one frequency");
    let SteadyError::NearlyCommon { searched, .. } = error else {
        panic!("{error}");
    };
    assert!(
        searched >= 8192 * 5 && searched.is_multiple_of(8192),
        "{searched}"
    );
    assert!(
        error
            .to_string()
            .contains(&format!("in {searched} periods")),
        "{error}"
    );
}

/// Two 6205 under different loads and an unbalance: three frequencies with cages that roll at the loaded angles, two without;
/// along a speed as at a single one.
#[test]
fn cages_of_a_response_roll_as_those_of_a_motion() {
    let text = r#"
[shaft]
mass = "8 kg"
eccentricity = "2.5 um"
freedoms = "all"
inertia_transverse = "0.02 kg m^2"
inertia_polar = "0.008 kg m^2"
[speed]
constant = "1480 rpm"
[[bearing]]
catalogue = "6205"
position = "-60 mm"
[[bearing]]
catalogue = "6205"
position = "120 mm"
[damping]
ratio = 0.03
[[load]]
constant = { y = "-300 N", z = "100 N" }
"#;
    let scenario = scenario(text);
    let told = |definition: &RotorDefinition| {
        let (stop, integrated) = (AtomicBool::new(false), AtomicU64::new(0));
        let question = ResponseQuestion {
            model: &model(definition.clone(), 1.0, 1e4),
            family: &|speed| Ok(definition.at_constant_speed(speed)),
            range: [155.0, 156.0],
            multiple: 1,
            points: 2,
            doubled: false,
            stop: &stop,
            integrated: &integrated,
        };
        let warnings = response_warnings(&question, &[]);
        let rolls = |text: &&String| text.contains("here they roll at the free contact angle");
        warnings.iter().filter(rolls).count()
    };
    let operating = scenario.question.rotor;
    let rolling = RotorDefinition {
        cage: CageMotion::Rolling,
        ..operating.clone()
    };
    let mut balanced = operating.clone();
    balanced.shaft.eccentricity = 0.0;
    assert_eq!([&operating, &rolling, &balanced].map(told), [1, 0, 0]);
}
