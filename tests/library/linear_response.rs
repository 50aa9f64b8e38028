//! The linear response: against closed forms, `steady` and a peer's numbers.

use std::f64::consts::TAU;
use std::sync::atomic::{AtomicBool, AtomicU64};

use nalgebra::Complex;

use crate::analysis::Channel;
use crate::rotor::{Pickup, Rotor};
use crate::scenario::Scenario;
use crate::steady::{SteadyQuestion, steady};
use crate::study::linear_response::{LinearResponse, LinearResponseQuestion, Resonance};
use crate::tests::support::{assert_near, scenario};

/// 5 kg, 10 µm beside the axis, on 1 N/µm and 200 N s/m.
const LAVAL: &str = "[shaft]\nmass = \"5 kg\"\neccentricity = \"10 um\"\nfreedoms = \"radial\"\n[speed]\nconstant = \"300 rad/s\"\n\
                     [[element]]\nlinear = { stiffness = { x = \"1 N/um\", y = \"1 N/um\" }, damping = { x = \"200 N s/m\", y = \"200 N \
                     s/m\" } }\n";

fn across(position: f64) -> Vec<Pickup> {
    [0, 1].map(|axis| Pickup { position, axis }).to_vec()
}

#[track_caller]
fn asked(text: &str, at: Vec<Pickup>, by: Option<Pickup>, range: [f64; 2]) -> LinearResponse {
    let scenario = scenario(text);
    let question = LinearResponseQuestion {
        rotor: scenario.question.rotor,
        at,
        by,
        range,
        count: 101,
    };
    let found = question.solve(&AtomicBool::new(false));
    found.unwrap_or_else(|error| panic!("{error}"))
}

fn dynamic(omega: f64) -> Complex<f64> {
    Complex::new(1e6 - 5.0 * omega * omega, 200.0 * omega)
}

/// x = m e ω²/D, y a quarter turn behind; its peak at ω_n/√(1 − 2ζ²), and half power where the closed form has it.
#[test]
fn the_unbalance_of_a_laval_rotor_answers_in_closed_form() {
    let found = asked(LAVAL, across(0.0), None, [100.0, 900.0]);
    for (speed, motions) in &found.points {
        let expected = 5.0 * 1e-5 * speed * speed / dynamic(*speed);
        let [x, y] = motions.as_ref().expect("damped")[..] else {
            panic!("two pickups");
        };
        assert!(
            (x - expected).norm() < 1e-12 * expected.norm(),
            "{x} {expected}"
        );
        let behind = x * Complex::new(0.0, -1.0);
        assert!(
            (y - behind).norm() < 1e-12 * expected.norm(),
            "{y} {behind}"
        );
    }
    let (natural, ratio) = (f64::sqrt(2e5), 200.0 / (2.0 * f64::sqrt(5e6)));
    let peak = natural / (1.0 - 2.0 * ratio * ratio).sqrt();
    assert_eq!(found.resonances.len(), 2);
    for own in &found.resonances {
        assert_near("peak", own.peak, peak, 1e-6 * peak);
        // |x|² = e² r⁴/((1 − r²)² + 4ζ²r²) = ½ of the peak: u² (1 − c) − u (2 − 4ζ²) + 1 = 0 with u = r², c = 2 e²/peak²
        let largest = 1.0 / (2.0 * ratio * (1.0 - ratio * ratio).sqrt());
        let (a, b) = (1.0 - 2.0 / (largest * largest), 2.0 - 4.0 * ratio * ratio);
        let root = (b * b - 4.0 * a).sqrt();
        let [low, high] = [(b - root) / (2.0 * a), (b + root) / (2.0 * a)].map(f64::sqrt);
        let factor = peak / natural / (high - low);
        assert_near(
            "AF",
            own.amplification.expect("both sides"),
            factor,
            1e-5 * factor,
        );
    }
}

/// Points of a curve about the resonance are a twelfth of its height apart or nearer, however coarse the grid, and a direction
/// that nothing moves has no resonance.
#[test]
fn the_loop_of_a_resonance_is_round_in_the_plane() {
    let along_y = Pickup {
        position: 0.0,
        axis: 1,
    };
    let found = asked(LAVAL, across(0.0), Some(along_y), [50.0, 5000.0]);
    let [own] = &found.resonances[..] else {
        panic!("{:?}", found.resonances);
    };
    assert_eq!(found.points.len(), 101);
    let motions = found.drawn.iter().filter_map(|(_, own)| own.as_ref());
    let along: Vec<_> = motions.map(|motion| motion[own.pickup]).collect();
    let steps = along.windows(2).map(|pair| (pair[1] - pair[0]).norm());
    let longest = steps.fold(0.0, f64::max);
    assert!(longest < own.amplitude / 11.0, "{longest} {own:?}");
}

/// A force along y: receptance 1/D on y, nothing on x.
#[test]
fn a_force_answers_in_closed_form() {
    let by = Pickup {
        position: 0.0,
        axis: 1,
    };
    let found = asked(LAVAL, across(0.0), Some(by), [10.0, 900.0]);
    for (omega, motions) in &found.points {
        let expected = dynamic(*omega).inv();
        let [x, y] = motions.as_ref().expect("damped")[..] else {
            panic!("two pickups");
        };
        assert!(
            (y - expected).norm() < 1e-12 * expected.norm(),
            "{y} {expected}"
        );
        assert!(x.norm() < 1e-15 * expected.norm());
    }
}

/// Two modes 1 % apart and 0.1 % damped stand between two frequencies of the grid; the axes of the support are turned by 30°,
/// so that both are peaks along x: x(ω) = c²/D₁ + s²/D₂.
#[test]
fn peaks_between_two_points_of_the_grid_are_found() {
    let stiffness = [1e6, 1.02e6];
    let [c, s] = [0.75_f64, 0.25].map(f64::sqrt);
    let [xx, yy] = [c * c, s * s].map(|part| part * stiffness[0] + (1.0 - part) * stiffness[1]);
    let xy = c * s * (stiffness[0] - stiffness[1]);
    let damping = 2.0 * 0.001 * (5.0 * 1e6_f64).sqrt();
    let text = format!(
        "[shaft]\nmass = \"5 kg\"\nfreedoms = \"radial\"\n[speed]\nconstant = \"300 rad/s\"\n[[element]]\n\
         linear = {{ stiffness = {{ x = \"{xx} N/m\", y = \"{yy} N/m\", xy = \"{xy} N/m\" }}, damping = {{ x = \"{damping} N s/m\", y = \
         \"{damping} N s/m\" }} }}\n"
    );
    let by = Pickup {
        position: 0.0,
        axis: 0,
    };
    let found = asked(&text, vec![by], Some(by), [10.0, 3000.0]);
    let amplitude = |omega: f64| {
        let dynamic = |k: f64| Complex::new(k - 5.0 * omega * omega, damping * omega).inv();
        (c * c * dynamic(stiffness[0]) + s * s * dynamic(stiffness[1])).norm()
    };
    assert_eq!(found.resonances.len(), 2, "{:?}", found.resonances);
    for (own, stiffness) in found.resonances.iter().zip(stiffness) {
        let natural = (stiffness / 5.0_f64).sqrt();
        let fine = (-1000..=1000).map(|step| amplitude(natural * (1.0 + 1e-6 * f64::from(step))));
        let largest = fine.fold(0.0, f64::max);
        assert_near("peak", own.peak, natural, 1e-3 * natural);
        assert_near("amplitude", own.amplitude, largest, 1e-5 * largest);
    }
}

/// The first critical speed at 447 rad/s with 0.1 % of damping, on a grid of 8 rad/s: e/(2ζ) high, and 1/(2ζ) its factor.
#[test]
fn a_sharp_critical_speed_is_told_at_its_height() {
    let text = LAVAL.replace("200 N s/m", "4.472136 N s/m");
    let found = asked(&text, across(0.0), None, [100.0, 900.0]);
    let ratio = 4.472136 / (2.0 * f64::sqrt(5e6));
    assert_eq!(found.resonances.len(), 2);
    for own in &found.resonances {
        assert_near(
            "µm",
            1e6 * own.amplitude,
            10.0 / (2.0 * ratio),
            1e-5 * 5000.0,
        );
        let factor = own.amplification.expect("both sides");
        assert_near("AF", factor, 1.0 / (2.0 * ratio), 1e-3 * factor);
    }
}

const BENDING: &str = r#"
[shaft]
[[shaft.section]]
length = "500 mm"
outer_diameter = "30 mm"
[[disc]]
position = "200 mm"
outer_diameter = "200 mm"
width = "40 mm"
[[unbalance]]
amount = "0.2 g mm"
position = "200 mm"
[[bearing]]
catalogue = "7205C"
position = "20 mm"
preload = "200 N"
[[bearing]]
catalogue = "7205C"
position = "480 mm"
facing = "-z"
preload = "200 N"
[damping]
ratio = 0.03
[speed]
constant = "3000 rpm"
[model]
cage = "frozen"
[integrator]
tolerance = 1e-10
verify = false
[time]
duration = "0.5 s"
settle = "0.2 s"
"#;

/// Balls after Hertz under a small unbalance: the motion of the whole equations is the linear one but for its size squared.
#[test]
fn small_motions_on_ball_bearings_are_those_of_steady() {
    let scenario = scenario(BENDING);
    let model = scenario.model.as_ref().expect("a motion");
    let (stop, integrated) = (AtomicBool::new(false), AtomicU64::new(0));
    let whole = steady(&SteadyQuestion {
        model,
        multiple: None,
        stop: &stop,
        integrated: &integrated,
    });
    let whole = whole.unwrap_or_else(|error| panic!("{error}"));
    let speed = 50.0 * TAU;
    let found = asked(BENDING, across(0.2), None, [speed, 2.0 * speed]);
    let motions = found.points[0].1.as_ref().expect("damped");
    for (axis, motion) in motions.iter().enumerate() {
        let exact = whole.lines.amplitude(Channel::Displacement(axis), 50.0);
        let exact = exact.expect("a channel");
        println!("{:e} m: {:e}", exact, motion.norm() / exact - 1.0);
        assert_near("amplitude", motion.norm(), exact, 1e-6 * exact);
    }
    assert!(found.reduction_error.expect("it bends") < 1e-3);
}

/// Maxwell and Betti: without rotation the motion at one place by a force at another is that at the other by a force at the
/// one.
#[test]
fn receptances_of_a_standing_shaft_are_reciprocal() {
    let text = BENDING.replace("3000 rpm", "0 rpm");
    let text = text.split("[integrator]").next().expect("a scene");
    let force = Pickup {
        position: 0.1,
        axis: 1,
    };
    // another force, and a moment
    for axis in [1, 3] {
        let position = 0.37;
        let other = Pickup { position, axis };
        let [one, other] = [(force, other), (other, force)]
            .map(|(at, by)| asked(text, vec![at], Some(by), [10.0, 3000.0]));
        for ((_, one), (_, other)) in one.points.iter().zip(&other.points) {
            let [one, other] = [one, other].map(|own| own.as_ref().expect("damped")[0]);
            assert!((one - other).norm() < 1e-9 * one.norm(), "{one} {other}");
        }
    }
}

/// A fan with a hub of 120 mm, within which a bearing and both unbalances sit: a shaft of the same mass that is a thousand and two
/// thousand times as stiff there, extrapolated.
#[test]
fn a_hub_is_the_limit_of_a_stiff_section() {
    let text = r#"
[shaft]
observed = "300 mm"
[[shaft.section]]
length = "200 mm"
outer_diameter = "30 mm"
[[shaft.section]]
length = "120 mm"
outer_diameter = "30 mm"
[[shaft.section]]
length = "180 mm"
outer_diameter = "30 mm"
[[disc]]
position = "260 mm"
mass = "9 kg"
inertia_transverse = "0.06 kg m^2"
inertia_polar = "0.1 kg m^2"
hub_width = "120 mm"
[[unbalance]]
amount = "20 g mm"
position = "220 mm"
[[unbalance]]
amount = "30 g mm"
position = "310 mm"
angle = "70 deg"
[[element]]
position = "20 mm"
linear = { stiffness = { x = "50 N/um", y = "30 N/um" }, damping = { x = "500 N s/m", y = "500 N s/m" } }
[[element]]
position = "240 mm"
linear = { stiffness = { x = "5 N/um", y = "5 N/um" }, damping = { x = "300 N s/m", y = "300 N s/m" } }
[speed]
constant = "3000 rpm"
"#;
    let scenario = scenario(text);
    let at = [0.0, 0.21, 0.305, 0.48].map(across).concat();
    for speed in [100.0, 400.0, 900.0, 1500.0] {
        // so many times as stiff; with a hub where none is given
        let moved = |stiffer: Option<f64>| {
            let mut rotor = scenario.question.rotor.at_constant_speed(speed);
            rotor.points.extend(at.iter().map(|own| own.position));
            let shaft = rotor.flexible.as_mut().expect("it bends");
            if let Some(stiffer) = stiffer {
                shaft.discs[0].hub_width = 0.0;
                shaft.sections[1].material.youngs_modulus *= stiffer;
            }
            let rotor = Rotor::assemble(&rotor.with_modes(20)).expect("a rotor");
            rotor.linear_model().to_unbalance(&at).expect("damped")
        };
        let (hub, once, twice) = (moved(None), moved(Some(1e3)), moved(Some(2e3)));
        let largest = hub.iter().map(|own| own.norm()).fold(0.0, f64::max);
        for ((hub, once), twice) in hub.iter().zip(&once).zip(&twice) {
            // what is left is as the compliance, of which the limit has none
            let limit = twice + (twice - once);
            let apart = (hub - limit).norm();
            assert!(apart < 1e-5 * largest, "{speed}: {hub} {limit}");
        }
    }
    let wrong = text.replace("120 mm\"\n[[unb", "700 mm\"\n[[unb");
    let refused = Scenario::from_toml(&wrong).expect_err("off the shaft");
    assert!(refused.render(false).contains("lies off the shaft"));
}

/// The margins of API 617: none below AF 2.5, 17 (1 − 1/(AF − 1.5)) % and 10 % more above the range, with their limits.
#[test]
fn separation_margins_are_those_of_api_617() {
    let at = |peak: f64, factor: f64| Resonance {
        pickup: 0,
        peak,
        amplitude: 1.0,
        amplification: Some(factor),
    };
    for (own, margin, asked) in [
        (at(160.0, 5.0), 0.2, 0.17 * (1.0 - 1.0 / 3.5)),
        (at(160.0, 50.0), 0.2, 0.16),
        (at(260.0, 5.0), 0.3, 0.10 + 0.17 * (1.0 - 1.0 / 3.5)),
        (at(260.0, 90.0), 0.3, 0.26),
        (at(190.0, 2.4), 0.05, 0.0),
    ] {
        let (found, due) = own.separation(200.0);
        assert_near("margin", found, margin, 1e-12);
        assert_near("asked", due.expect("a factor"), asked, 1e-12);
    }
}

/// `λ² m + c λ + k − iκ = 0`: a cross-coupled stiffness κ drives a forward whirl from κ > c ω_n on, at every speed alike. A
/// force as well as the unbalances is warned of.
#[test]
fn an_unstable_shaft_has_no_steady_response() {
    let crossed = |crossing: &str| {
        let springs =
            format!("y = \"1 N/um\", xy = \"{crossing} N/um\", yx = \"-{crossing} N/um\" }}");
        LAVAL.replace("y = \"1 N/um\" }", &springs)
    };
    let told = |crossing: &str, by: Option<Pickup>| {
        let found = asked(&crossed(crossing), across(0.0), by, [100.0, 900.0]);
        let about = |text: &String| text.contains("not stable");
        found.warnings.into_iter().find(about)
    };
    let by = Some(across(0.0)[0]);
    let limit = 200.0 * f64::sqrt(2e5) / 1e6;
    assert_eq!(told(&(0.99 * limit).to_string(), None), None);
    // Re λ of (1.2 ω_n c i − k)/m with the damping in it, by the square root of a complex number
    let crossing = 1.2 * limit;
    let decay = 200.0 / 10.0;
    let root = Complex::new(decay * decay - 2e5, 1e6 * crossing / 5.0).sqrt();
    let eigenvalue = root - decay;
    let ratio = format!("{:.2e}", -eigenvalue.re / eigenvalue.norm());
    for (by, range) in [(None, "from 954.9 to 8594.4 rpm"), (by, "at 2864.8 rpm")] {
        let warning = told(&crossing.to_string(), by).expect("a warning");
        for part in [range, &ratio, "no motion that it settles to"] {
            assert!(warning.contains(part), "{part} in {warning}");
        }
    }
}

/// `k/m = ω²` without damping: the peak is wherever it was looked for last, and says so.
#[test]
fn an_undamped_resonance_is_unbounded() {
    let undamped = LAVAL.replace(", damping = { x = \"200 N s/m\", y = \"200 N s/m\" }", "");
    for (text, unbounded) in [(undamped.as_str(), true), (LAVAL, false)] {
        let found = asked(text, across(0.0), None, [100.0, 900.0]);
        assert_eq!(found.resonances.len(), 2);
        for resonance in &found.resonances {
            assert_eq!(resonance.is_unbounded(), unbounded, "{resonance:?}");
        }
    }
}

/// A circular whirl of 10 µm times ω²/|D| about the middle of a stator: it leaves the clearance where the closed form does.
#[test]
fn a_response_beyond_a_clearance_is_told() {
    let stator = |clearance: &str| {
        format!(
            "{LAVAL}[[element]]\n[element.rub]\nclearance = \"{clearance}\"\nstiffness = \"2 N/um\"\nfriction = 0.05\n\
             shaft_diameter = \"40 mm\"\n"
        )
    };
    let told = |clearance: &str| {
        let found = asked(&stator(clearance), across(0.0), None, [100.0, 900.0]);
        let about = |text: &String| text.contains("clearance");
        found.warnings.into_iter().find(about)
    };
    assert_eq!(told("150 um"), None);
    let whirl = |omega: f64| 5e-5 * omega * omega / dynamic(omega).norm();
    let first = (0..=100)
        .map(|k| 100.0 + 8.0 * f64::from(k))
        .find(|omega| whirl(*omega) > 6e-5);
    let first = first.expect("a speed") * 60.0 / TAU;
    let (natural, ratio) = (f64::sqrt(2e5), 200.0 / (2.0 * f64::sqrt(5e6)));
    let peak = 1e6 * whirl(natural / (1.0 - 2.0 * ratio * ratio).sqrt());
    let warning = told("60 um").expect("a warning");
    for part in [
        format!("from {first:.1} rpm on"),
        format!("{peak:.1} µm from its middle"),
        "element 2, 60.0 µm".to_owned(),
    ] {
        assert!(warning.contains(&part), "{part} in {warning}");
    }
}
