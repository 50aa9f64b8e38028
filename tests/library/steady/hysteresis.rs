//! A preloaded Hertz contact under a vibrating load: its resonance leans to lower speeds, and between two
//! turning points there are two stable motions and one that is not.

use std::sync::LazyLock;
use std::sync::atomic::{AtomicBool, AtomicU64};

use crate::bearing::MountedBearing;
use crate::rotor::load::{Harmonic, HarmonicRate};
use crate::rotor::{
    CageMotion, Damping, ElementLaw, ForceElement, Freedoms, LinearLaw, Load, LoadKind, Rotor,
    RotorDefinition,
};
use crate::shooting::SpecialKind;
use crate::simulate::Model;
use crate::steady::{Response, ResponsePoint, ResponseQuestion, response};

use crate::tests::support::{
    assert_near, bearing, model, mounted, peak_to_peak, rotor, samples, settings, shaft,
};

/// 1000 N of thrust and 25 N that swing once a revolution.
fn definition(speed: f64) -> RotorDefinition {
    let swinging = Harmonic {
        amplitude: [0.0, 0.0, 25.0, 0.0, 0.0],
        rate: HarmonicRate::Order(1.0),
        phase: 0.0,
    };
    RotorDefinition {
        speed,
        cage: CageMotion::Frozen,
        damping: Damping::Coefficients([500.0, 500.0, 300.0, 0.0, 0.0]),
        loads: vec![
            Load::constant([0.0, 0.0, 1000.0, 0.0, 0.0], 0.0),
            Load {
                kind: LoadKind::Harmonic(swinging),
                position: 0.0,
            },
        ],
        ..rotor(
            shaft(Freedoms::Translational),
            vec![MountedBearing {
                ..mounted(bearing("7205C"))
            }],
        )
    }
}

/// Axial natural frequency of small vibrations, rad/s.
fn natural() -> f64 {
    let rotor = Rotor::assemble(&definition(0.0)).expect("a rotor");
    (rotor.equilibrium().stiffness[(2, 2)] / 5.0).sqrt()
}

fn question(speed: f64) -> Model {
    let mut model = model(definition(speed), 1.0, 1e4);
    model.integrator = settings(1e-9);
    model
}

fn followed(from: f64, to: f64) -> Response {
    let model = question(from);
    let stop = AtomicBool::new(false);
    let question = ResponseQuestion {
        model: &model,
        family: &|speed| Ok(definition(speed)),
        range: [from, to],
        multiple: 1,
        points: 1000,
        doubled: false,
        stop: &stop,
        integrated: &AtomicU64::new(0),
    };
    let mut branches = response(&question, &mut |_| {}).expect("a branch");
    branches.swap_remove(0)
}

/// From above the resonance down through it, which two tests look at.
static DOWN: LazyLock<Response> = LazyLock::new(|| {
    let natural = natural();
    followed(1.15 * natural, 0.6 * natural)
});

fn axial(point: &ResponsePoint) -> f64 {
    point.ranges[2].peak_to_peak
}

fn folds(branch: &Response) -> Vec<f64> {
    let folds = branch
        .specials
        .iter()
        .filter(|special| special.kind == SpecialKind::Fold);
    folds.map(|special| special.point.value).collect()
}

#[test]
fn both_branches_of_a_folded_resonance_are_those_of_long_runs() {
    let natural = natural();
    let branch = &*DOWN;
    let folds = folds(branch);
    println!(
        "natural {natural}, folds {folds:?}, {} points, {}",
        branch.points.len(),
        branch.end
    );
    let [first, second] = folds[..] else {
        panic!("two turning points, not {folds:?}");
    };
    assert!(
        first < natural && first < second,
        "{folds:?} below {natural}"
    );
    for special in &branch.specials {
        let nearest = special
            .point
            .multipliers
            .iter()
            .map(|value| (value - 1.0).norm());
        assert!(
            nearest.fold(f64::INFINITY, f64::min) < 1e-3,
            "{:?}",
            special.point.multipliers
        );
    }
    // from the first turning point to the second nothing is stable
    let turns: Vec<usize> = branch
        .specials
        .iter()
        .map(|special| special.after)
        .collect();
    for (number, point) in branch.points.iter().enumerate() {
        let middle = number >= turns[0] && number < turns[1];
        assert_eq!(point.stable, !middle, "point {number} at {}", point.value);
    }
    // the three motions half way between the turning points
    let speed = 0.5 * (first + second);
    let crossing =
        |pair: &[ResponsePoint]| (pair[0].value - speed) * (pair[1].value - speed) <= 0.0;
    let swings: Vec<(f64, bool)> = branch
        .points
        .windows(2)
        .filter(|pair| crossing(pair))
        .map(|pair| {
            let part = (speed - pair[0].value) / (pair[1].value - pair[0].value);
            let swing = axial(&pair[0]) + part * (axial(&pair[1]) - axial(&pair[0]));
            (swing, pair[1].stable)
        })
        .collect();
    let [(upper, true), (middle, false), (lower, true)] = swings[..] else {
        panic!("a stable, an unstable, a stable motion, not {swings:?}");
    };
    assert!(upper > middle && middle > lower, "{swings:?}");
    let settled = |start: f64| {
        let mut model = question(speed);
        model.rotor.initial.displacement[2] = Some(start);
        let decay = 300.0 / (2.0 * 5.0);
        model.duration = 25.0 / decay;
        model.sampling = crate::simulate::Sampling::Rate(200.0 * speed / std::f64::consts::TAU);
        let late = samples(&model, model.duration - 4.0 * std::f64::consts::TAU / speed);
        peak_to_peak(late.iter().map(|sample| sample.displacement[2]))
    };
    let rest = Rotor::assemble(&definition(speed))
        .expect("a rotor")
        .equilibrium()
        .displacement[2];
    let starts = (-8..16).map(|step| rest + 4e-6 * f64::from(step));
    let ends: Vec<f64> = starts.map(settled).collect();
    println!("{swings:?} {ends:?}");
    // motions between points of the branch are interpolated linearly
    for end in &ends {
        let nearest = (end - upper).abs().min((end - lower).abs());
        assert!(
            nearest < 0.03 * upper,
            "{end:e} is neither {upper:e} nor {lower:e}"
        );
    }
    let reaches = |swing: f64| ends.iter().any(|end| (end - swing).abs() < 0.03 * swing);
    assert!(reaches(upper) && reaches(lower), "{ends:?}");
}

#[test]
fn turning_points_are_the_same_from_either_end() {
    let natural = natural();
    let mut down = folds(&DOWN);
    let mut up = folds(&followed(0.6 * natural, 1.15 * natural));
    down.sort_by(f64::total_cmp);
    up.sort_by(f64::total_cmp);
    assert_eq!((down.len(), up.len()), (2, 2));
    for (down, up) in down.iter().zip(&up) {
        assert_near("turning point", *up, *down, 1e-5 * down);
    }
}

#[test]
fn multipliers_of_a_verified_branch_have_errors() {
    let mut model = question(0.3 * natural());
    for verify in [true, false] {
        model.verify = verify;
        let question = ResponseQuestion {
            model: &model,
            family: &|speed| Ok(definition(speed)),
            range: [0.3 * natural(), 0.31 * natural()],
            multiple: 1,
            points: 2,
            doubled: false,
            stop: &AtomicBool::new(false),
            integrated: &AtomicU64::new(0),
        };
        let branches = response(&question, &mut |_| {}).expect("a branch");
        for point in &branches[0].points {
            let errors = &point.multiplier_errors;
            println!("{errors:?}");
            let count = if verify { point.multipliers.len() } else { 0 };
            assert_eq!(errors.len(), count);
            assert!(errors.iter().all(|error| 0.0 < *error && *error < 1e-5));
        }
    }
}

/// 5 kg, 10 µm beside the axis, on 1 N/µm and a damper in N s/m.
fn laval(speed: f64, damper: f64) -> RotorDefinition {
    let along = |coefficient: f64| ([coefficient, coefficient, 0.0, 0.0, 0.0], [0.0; 2]);
    let mut shaft = shaft(Freedoms::Radial);
    shaft.eccentricity = 1e-5;
    let spring = ForceElement {
        position: Some(0.0),
        housing_of: None,
        housing: None,
        law: ElementLaw::Linear(Box::new(LinearLaw::new(along(1e6), along(damper)))),
    };
    RotorDefinition {
        speed,
        elements: vec![spring],
        damping: Damping::Undamped,
        ..rotor(shaft, Vec::new())
    }
}

fn laval_branch(damper: f64, range: [f64; 2], verify: bool) -> Response {
    let mut model = model(laval(range[0], damper), 1.0, 1e4);
    model.verify = verify;
    let question = ResponseQuestion {
        model: &model,
        family: &|speed| Ok(laval(speed, damper)),
        range,
        multiple: 1,
        points: 1000,
        doubled: false,
        stop: &AtomicBool::new(false),
        integrated: &AtomicU64::new(0),
    };
    let mut branches = response(&question, &mut |_| {}).expect("a branch");
    branches.swap_remove(0)
}

/// On a spring without damping every multiplier has magnitude 1, and no motion of the branch is stable or not stable by chance.
#[test]
fn motions_without_damping_are_neutral_along_a_branch() {
    for verify in [true, false] {
        for point in laval_branch(0.0, [314.0, 330.0], verify).points {
            assert!(point.neutral && !point.stable, "{verify}, {}", point.value);
        }
    }
}

/// Peak to peak is twice `m e ω²/|D|`, between samples: within the error that is told of every motion, which is never below
/// round-off.
#[test]
fn ranges_of_a_branch_are_known_to_their_errors() {
    for point in laval_branch(40.0, [400.0, 500.0], true).points {
        let omega = point.value;
        let dynamic = (1e6 - 5.0 * omega * omega).hypot(40.0 * omega);
        let expected = 2.0 * 5e-5 * omega * omega / dynamic;
        let error = point.range_error.expect("a measured error");
        assert!(error.relative >= f64::EPSILON, "{error:?}");
        let missed = (point.ranges[0].peak_to_peak - expected).abs();
        assert!(
            missed <= 3.0 * error.displacement,
            "{missed:e} at {omega}: {error:?}"
        );
    }
}
