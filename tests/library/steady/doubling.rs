//! Period doubling by passing balls, where the literature has it.

use std::f64::consts::PI;
use std::sync::atomic::{AtomicBool, AtomicU64};

use crate::analysis::Channel;
use crate::rotor::RotorDefinition;
use crate::shooting::{SpecialKind, Stability};
use crate::simulate::Model;
use crate::steady::{Response, ResponseQuestion, Steady, response};

use super::{found, search};
use crate::tests::support::{
    MICROMETRE, assert_near, literature_bearing, model, settings, varying_compliance,
};

/// A vertical load on a ball bearing of eight balls, damped by 200 N s/m.
fn scene(
    speed: f64,
    mass: f64,
    load: f64,
    diameters: [f64; 2],
    clearance: f64,
    stiffness: f64,
) -> RotorDefinition {
    let bearing = literature_bearing(8, diameters, clearance, stiffness);
    varying_compliance(speed, mass, load, bearing)
}

/// JIS 6306 of Fukata et al. (1985) and Mevel & Guyader (1993).
fn jis_6306(speed: f64) -> RotorDefinition {
    scene(speed, 20.0, 196.0, [11.9062e-3, 52.0e-3], 3e-6, 1.334e10)
}

/// Bearing 6204 of Tiwari, Gupta & Prakash (2000): the ball-pass factor 3.05 from the ratio of diameters.
fn tiwari_6204(revolutions_per_minute: f64) -> RotorDefinition {
    let ratio = 1.0 - 2.0 * 3.05 / 8.0;
    let diameters = [7.938e-3, 7.938e-3 / ratio];
    scene(
        revolutions_per_minute * PI / 30.0,
        0.6,
        6.0,
        diameters,
        1e-6,
        7.055e9,
    )
}

fn question(definition: RotorDefinition) -> Model {
    let mut model = model(definition, 1.0, 1e4);
    model.integrator = settings(1e-8);
    model
}

fn swing(steady: &Steady, axis: usize) -> f64 {
    let own = |swing: &&crate::steady::MotionRange| swing.channel == Channel::Displacement(axis);
    let swing = steady.ranges.iter().find(own).expect("a displacement");
    swing.peak_to_peak / MICROMETRE
}

/// Peak to peak as after a thousand ball passes.
#[test]
fn jis_6306_has_the_swings_and_periods_of_long_runs() {
    for (speed, along, across, multiple) in [
        (100.0, 0.0591, 0.8138, 1),
        (150.0, 0.2987, 1.9526, 2),
        (200.0, 0.3118, 1.1927, 1),
    ] {
        let steady = found(&question(jis_6306(speed)));
        assert_eq!(steady.multiple, multiple, "{speed} rad/s");
        assert!(steady.is_stable(), "{speed} rad/s");
        // samples beside a peak miss a little of it
        assert_near("u", swing(&steady, 1), along, 2e-3 * along);
        assert_near("v", swing(&steady, 0), across, 2e-3 * across);
    }
}

/// The multipliers of the period of two ball passes, from variational equations integrated at 1e-13 with steps
/// that end where balls lift off; the determinant is `exp(−∫ trace)`, here with a damping of c/m in both directions.
#[test]
fn multipliers_are_exact_where_balls_lift_off() {
    for (tolerance, within) in [(1e-8, 1e-5), (1e-10, 1e-6)] {
        let mut question = question(jis_6306(150.0));
        question.integrator = settings(tolerance);
        question.verify = true;
        let steady = search(&question, Some(2)).expect("a motion");
        let values = steady.multipliers.values();
        let errors = steady.measured.expect("a measured error").multipliers;
        assert!(errors.iter().all(|error| *error < within), "{errors:?}");
        let expected = [[0.315316, 0.814069], [0.779046, 0.393980]];
        for [re, im] in expected {
            let near =
                |value: &&nalgebra::Complex<f64>| (value.re - re).hypot(value.im - im) < within;
            assert!(values.iter().any(|value| near(&value)), "{values:?}");
        }
        let determinant: f64 = values.iter().map(|value| value.norm()).product();
        let trace = 2.0 * 200.0 / 20.0;
        assert_near(
            "determinant",
            determinant.ln(),
            -trace * steady.period,
            within,
        );
    }
}

/// At tolerances looser than that of the slopes, too, the difference of two solutions tells the error of the first.
#[test]
fn errors_of_multipliers_hold_at_loose_tolerances() {
    let at = |tolerance: f64, verify: bool| {
        let mut question = question(jis_6306(150.0));
        question.integrator = settings(tolerance);
        question.verify = verify;
        search(&question, Some(2)).expect("a motion")
    };
    let exact = at(1e-12, false).multipliers.values();
    for tolerance in [1e-5, 1e-6] {
        let found = at(tolerance, true);
        let stated = found.measured.expect("a measured error").multipliers;
        for (value, stated) in found.multipliers.values().iter().zip(stated) {
            let apart = exact.iter().map(|exact| (value - exact).norm());
            let true_error = apart.fold(f64::INFINITY, f64::min);
            assert!(
                true_error < 3.0 * stated && stated < 3.0 * true_error,
                "{tolerance:e}: {true_error:e} stated as {stated:e}"
            );
        }
    }
}

#[test]
fn at_150_rad_s_the_single_period_has_doubled() {
    let single = search(&question(jis_6306(150.0)), Some(1)).expect("a motion");
    assert_eq!((single.multiple, single.is_stable()), (1, false));
    assert_eq!(
        single.stability,
        Stability::Unstable(SpecialKind::PeriodDoubling)
    );
    let all = single.multipliers.values();
    println!("{all:?}");
    assert!(all[0].im == 0.0 && all[0].re < -1.0, "{all:?}");
    assert!(all[1..].iter().all(|other| other.norm() < 1.0), "{all:?}");
    assert_eq!(single.warnings.len(), 1);
}

/// The product of all multipliers is what damping leaves of a volume: e^(−2(c/m)T), to the exactness of
/// the slopes, stable or not.
#[test]
fn multipliers_shrink_volumes_as_damping_does() {
    for (speed, multiple) in [(100.0, 1), (150.0, 1), (150.0, 2), (200.0, 1)] {
        let steady = search(&question(jis_6306(speed)), Some(multiple)).expect("a motion");
        let product: f64 = steady
            .multipliers
            .values()
            .iter()
            .map(|value| value.norm())
            .product();
        let expected = (-2.0 * 200.0 / 20.0 * steady.period).exp();
        assert_near("product", product, expected, 1e-5);
    }
}

/// Two periods of a motion that repeats after one have its multipliers squared.
#[test]
fn two_periods_have_the_multipliers_of_one_squared() {
    let model = question(jis_6306(200.0));
    let single = search(&model, Some(1)).expect("a motion");
    let double = search(&model, Some(2)).expect("a motion");
    assert_near(
        "largest",
        double.multipliers.largest(),
        single.multipliers.largest().powi(2),
        1e-5,
    );
    assert_near("swing", swing(&double, 0), swing(&single, 0), 1e-4);
}

#[test]
fn tiwari_6204_doubles_its_period_from_13_500_to_15_250_rpm() {
    for (speed, multiple) in [
        (5000.0, 1),
        (13_250.0, 1),
        (13_500.0, 2),
        (14_500.0, 2),
        (15_200.0, 2),
        (15_500.0, 1),
        (20_000.0, 1),
    ] {
        let steady = found(&question(tiwari_6204(speed)));
        assert!(steady.is_stable(), "{speed} rpm");
        assert_eq!(steady.multiple, multiple, "{speed} rpm");
    }
}

/// The doubling at the upper end is subcritical: at 15 250 rpm the single period is stable again while
/// the double one, which a long run from rest settles to, has not yet met its turning point.
#[test]
fn at_15_250_rpm_both_periods_are_stable() {
    let model = question(tiwari_6204(15_250.0));
    let single = found(&model);
    assert_eq!((single.multiple, single.is_stable()), (1, true));
    let double = search(&model, Some(2)).expect("a motion");
    assert_eq!((double.multiple, double.is_stable()), (2, true));
    let apart = (swing(&double, 1) - swing(&single, 1)).abs();
    assert!(apart > 0.05 * swing(&single, 1), "two motions: {apart} µm");
}

fn followed(from: f64, to: f64) -> Vec<Response> {
    let model = question(tiwari_6204(from));
    let stop = AtomicBool::new(false);
    let question = ResponseQuestion {
        model: &model,
        family: &|speed| Ok(tiwari_6204(speed)),
        range: [from, to],
        multiple: 1,
        points: 500,
        doubled: true,
        stop: &stop,
        integrated: &AtomicU64::new(0),
    };
    response(&question, &mut |_| {}).expect("branches")
}

fn doublings(branches: &[Response]) -> Vec<f64> {
    let specials = branches[0].specials.iter();
    let doublings = specials.filter(|special| special.kind == SpecialKind::PeriodDoubling);
    let mut values: Vec<f64> = doublings.map(|special| special.point.value).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// How exactly a multiplier is known: slopes are integrated to 1e-6. A doubling is known where its
/// multiplier is, so the less, the slower that changes with the speed.
const MULTIPLIER_ERROR: f64 = 1e-5;

/// Change of the least multiplier between the motions on both sides of a value, over that of the value.
fn multiplier_slope(branch: &crate::steady::Response, value: f64) -> f64 {
    let least = |point: &crate::steady::ResponsePoint| {
        let parts = point.multipliers.iter().map(|multiplier| multiplier.re);
        parts.fold(f64::INFINITY, f64::min)
    };
    let pair = branch
        .points
        .windows(2)
        .find(|pair| pair[0].value <= value && value <= pair[1].value)
        .expect("motions on both sides");
    ((least(&pair[1]) - least(&pair[0])) / (pair[1].value - pair[0].value)).abs()
}

/// Both ends of the band, the motion of doubled period from one to the other, and the same found from
/// above as from below.
#[test]
fn tiwari_6204_is_followed_through_its_doubling() {
    let upwards = followed(13_000.0, 16_000.0);
    for branch in &upwards {
        println!(
            "{} × {} points: {}",
            branch.multiple,
            branch.points.len(),
            branch.end
        );
        for special in &branch.specials {
            println!(
                "  {} at {} {:?}",
                special.kind, special.point.value, special.point.multipliers
            );
        }
    }
    let found = doublings(&upwards);
    let [begin, end] = found[..] else {
        panic!("two doublings, not {found:?}");
    };
    assert!((13_250.0..13_500.0).contains(&begin), "{begin} rpm");
    assert!((15_200.0..15_250.0).contains(&end), "{end} rpm");
    for special in &upwards[0].specials {
        assert_near(
            "multiplier",
            special.point.multipliers[0].re,
            -1.0,
            MULTIPLIER_ERROR,
        );
    }
    let between = |point: &&crate::steady::ResponsePoint| point.value > begin && point.value < end;
    assert!(
        upwards[0]
            .points
            .iter()
            .filter(between)
            .all(|point| !point.stable)
    );
    let double = upwards
        .iter()
        .find(|branch| branch.multiple == 2)
        .expect("a doubled branch");
    assert!(double.end.contains("single again"), "{}", double.end);
    let fold = &double.specials[0];
    assert_eq!(fold.kind, SpecialKind::Fold);
    let last_double = fold.point.value;
    assert!(
        (15_250.0..15_500.0).contains(&last_double),
        "{last_double} rpm"
    );
    let last = double.points.last().expect("points").value;
    assert_near(
        "the doubled motion ends at the other doubling",
        last,
        end,
        60.0,
    );
    let downwards = doublings(&followed(16_000.0, 13_000.0));
    for (up, down) in found.iter().zip(&downwards) {
        let allowed = MULTIPLIER_ERROR / multiplier_slope(&upwards[0], *up);
        println!("doubling at {up} and {down}, {allowed:.1e} apart allowed");
        assert_near("from above as from below", *down, *up, allowed);
    }
}
