//! Errors are relative to the motion that was recorded, where a linear response says nothing of its size: the stiffness
//! at the equilibrium is next to nothing.

use nalgebra::Complex;

use super::model;
use crate::analysis::Moments;
use crate::rotor::{Rotor, Sample};
use crate::simulate::{Model, Run};
use crate::tests::support::{Collector, simulate_into};

/// Nothing holds the shaft at its equilibrium: clearance, no gravity, no load; only the unbalance moves it. Its tilts
/// respond to the linear rotor with 1.85 m.
const FREE: &str = r#"
[shaft]
mass = "1.6 kg"
freedoms = "all"
inertia_transverse = "0.0344 kg m^2"
inertia_polar = "0.0394 kg m^2"
eccentricity = "0.026 um"
[speed]
constant = "56711 rpm"
[[bearing]]
catalogue = "6204"
position = "-45 mm"
waviness = [ { on = "inner", order = 145, amplitude = "1.6 um" } ]
[[bearing]]
catalogue = "6204"
position = "-34 mm"
preload = "3 N"
waviness = [ { on = "inner", order = 23, amplitude = "0.1 um" } ]
[damping]
ratio = 0.6
[time]
duration = "0.002 s"
[output]
energy = true
sample_rate = "500 kHz"
spectrum = false
motion = false
"#;

/// A long stepped shaft with two loose bearings, axially held by the roughest of their balls only: 0.08 Hz.
const HELD: &str = r#"
unbalance = [{ amount = "0.1691 g mm", angle = "328 deg", position = "665.857 mm" }]
[shaft]
gravity = true
internal_damping = "0.73 us"
section = [
  { length = "158.91 mm", outer_diameter = "34.791 mm" }, { length = "158.91 mm", outer_diameter = "20.18 mm" },
  { length = "158.91 mm", outer_diameter = "26.121 mm" }, { length = "158.91 mm", outer_diameter = "43.66 mm" },
  { length = "158.91 mm", outer_diameter = "41.924 mm" }, { length = "158.91 mm", outer_diameter = "24.018 mm" },
  { length = "158.91 mm", outer_diameter = "33.318 mm" }, { length = "158.91 mm", outer_diameter = "24.253 mm" },
  { length = "158.91 mm", outer_diameter = "45.825 mm" }, { length = "158.91 mm", outer_diameter = "19.934 mm" },
]
[[bearing]]
position = "264.214 mm"
ball_sizes = { variation = "0.17 um", seed = 3 }
[bearing.geometry]
balls = 4
ball_diameter = "12.039 mm"
pitch_diameter = "85.256 mm"
groove_factor_inner = 0.5422
groove_factor_outer = 0.523
diametral_clearance = "42.3 um"
[[bearing]]
position = "1142.77 mm"
defect = [
  { on = "ball", ball = 3, angle = "-2.521 deg", length = "0.5495 mm", depth = "0.6139 mm", profile = "half_sine" },
  { on = "outer", angle = "-144.099 deg", length = "0.1754 mm", depth = "0.02639 mm", profile = "edges" },
  { on = "ball", ball = 2, angle = "-35.963 deg", length = "0.8369 mm", depth = "0.2829 mm", profile = "edges" },
]
[bearing.geometry]
balls = 12
ball_diameter = "1.6035 mm"
pitch_diameter = "11.268 mm"
groove_factor_inner = 0.551
groove_factor_outer = 0.557
diametral_clearance = "47.1 um"
[bearing.housing]
mass = "0.0135 kg"
stiffness = { x = "415 N/um", y = "636.5 N/um", z = "1059 N/um" }
[speed]
constant = "1190.01 rpm"
[damping]
ratio = 0.0101
contact = { inner = "0.1 s/m", outer = "0.1 s/m" }
[time]
duration = "0.015 s"
settle = "0.006 s"
[integrator]
tolerance = 1e-6
[output]
spectrum = false
motion = false
sample_rate = "16102 Hz"
"#;

fn samples(model: &Model) -> (Run, Vec<Sample>) {
    let mut sink = Collector::default();
    let run = simulate_into(model, &mut sink).expect("a run");
    (run, sink.samples)
}

/// The error that a run states, relative to the motion, and the true one: its distance from a run at a ten-thousandth of
/// its tolerance, with the round-off of both, over the largest distance of a displacement from its mean after the settle
/// time.
fn stated_and_true(text: &str) -> (Run, [f64; 2]) {
    let model = model(text);
    let (run, own) = samples(&model);
    let mut exact = model.clone();
    exact.verify = false;
    exact.integrator.tolerance = (1e-4 * model.integrator.tolerance).max(1e-12);
    let (_, exact) = samples(&exact);
    let (mut apart, mut motion) = (0.0_f64, 0.0_f64);
    for axis in 0..3 {
        let along = |sample: &Sample| sample.displacement[axis];
        let pairs = own.iter().zip(&exact);
        apart = pairs.fold(apart, |most, (own, exact)| {
            most.max((along(own) - along(exact)).abs())
        });
        let settled = exact.iter().filter(|sample| sample.time >= model.settle);
        motion = motion.max(settled.map(along).collect::<Moments>().peak());
    }
    let rotor = Rotor::assemble(&model.rotor).expect("a rotor");
    apart += rotor.displacement_round_off();
    let stated = run.measured_error.expect("a verified run");
    println!(
        "{stated:?}, truly {apart:e} of {motion:e}, {:?}",
        run.corrected_scale
    );
    (run, [stated.relative, apart / motion])
}

#[track_caller]
fn assert_stated(text: &str) -> Run {
    let (run, [stated, truth]) = stated_and_true(text);
    // far below the tolerance round-off decides which of the passes is the nearer one
    let negligible = 0.1 * model(text).integrator.tolerance;
    assert!(
        truth < 3.0 * stated && (stated < 3.0 * truth || stated < negligible),
        "{stated:e} stated, {truth:e} true"
    );
    run
}

#[test]
fn a_free_shaft_states_its_error_of_the_recorded_motion() {
    let run = assert_stated(FREE);
    let energy = run.energy.expect("an account");
    assert!(energy.relative_residual < 1e-5, "{energy:?}");
    let [assumed, recorded] = run.corrected_scale.expect("another scale");
    assert!(assumed > 1e3 * recorded, "{assumed} {recorded}");
    // slower and heavier
    let neighbour = FREE
        .replace("56711 rpm", "31000 rpm")
        .replace("1.6 kg", "2.3 kg");
    assert_stated(&neighbour);
}

#[test]
fn a_loosely_held_shaft_states_its_error_of_the_record() {
    assert_stated(HELD);
    let neighbour = HELD
        .replace("1e-6", "1e-3")
        .replace("1190.01 rpm", "1500 rpm")
        .replace("\"42.3 um\"", "\"35 um\"");
    assert_stated(&neighbour);
}

/// Both passes take the same exact steps: 100 µm cos √(K/M) t, and `1 µm e^(λ t)` of a shaft whose springs drive its whirl.
#[test]
fn a_linear_run_states_the_round_off_of_its_length() {
    let scene = |springs: &str, displacement: &str, duration: &str| {
        let text = format!(
            "[shaft]\nmass = \"10 kg\"\nfreedoms = \"radial\"\n[[element]]\nlinear = {{ stiffness = {{ x = \"1 N/um\", y = \
             \"1 N/um\"{springs} }} }}\n[initial]\ndisplacement = {{ x = \"{displacement}\" }}\n[speed]\nconstant = \"3000 rpm\"\n[time]\nduration = \"{duration}\"\nsettle = \"0 s\"\n[output]\nspectrum = false\nmotion = false\n"
        );
        samples(&model(&text))
    };
    let error = |run: &Run| run.measured_error.as_ref().expect("verified").displacement;
    let (run, free) = scene("", "100 um", "6 s");
    let exact = |time: f64| 1e-4 * (1e5_f64.sqrt() * time).cos();
    let apart = free
        .iter()
        .map(|sample| (sample.displacement[0] - exact(sample.time)).abs());
    let apart = apart.fold(0.0, f64::max);
    let stated = error(&run);
    assert!(apart < stated && stated < 1e-14, "{apart:e}, {stated:e}");

    let (run, growing) = scene(", xy = \"0.02 N/um\", yx = \"-0.02 N/um\"", "1 um", "3 s");
    // x + i y goes with λ = √(−(K ∓ i k)/M), one half each of which grows
    let omega = Complex::new(1e5, 2e3).sqrt();
    let exact = |time: f64| {
        let half = |omega: Complex<f64>| (omega * time).cos();
        0.5e-6 * (half(omega) + half(omega.conj())).re
    };
    let (mut apart, mut largest) = (0.0_f64, 0.0_f64);
    for sample in &growing {
        let x = sample.displacement[0];
        apart = apart.max((x - exact(sample.time)).abs());
        largest = largest.max(x.abs());
    }
    let stated = error(&run);
    assert!(largest > 1e-3, "{largest:e}");
    assert!(
        apart < stated && stated < 1e-9 * largest,
        "{apart:e}, {stated:e}"
    );
}
