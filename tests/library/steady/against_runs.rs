//! The motion found directly is that which a long run settles to, with the same spectrum.

use crate::analysis::{Channel, Window};
use crate::integrate::{Method, Settings};
use crate::rotor::Damping;
use crate::simulate::{BareRun, Model, Sampling};
use crate::steady::Steady;

use super::{found, shipped};
use crate::tests::support::{Collector, peak_to_peak, samples, simulate_into};

/// Settled to e^(−25) of the start.
fn settled_after(model: &Model) -> f64 {
    let rotor = crate::rotor::Rotor::assemble(&model.rotor).expect("a rotor");
    let modes = rotor.natural_frequencies();
    let decay = modes
        .iter()
        .map(|mode| std::f64::consts::TAU * mode.frequency * mode.damping_ratio);
    25.0 / decay.fold(f64::INFINITY, f64::min)
}

/// The model run until it has settled and so many periods on, on the samples of the steady motion.
fn long(model: &Model, steady: &Steady, periods: usize) -> (Model, usize) {
    let per_period = steady.trace.len();
    let interval = steady.period / per_period as f64;
    let settle = (settled_after(model) / steady.period).ceil() as usize * per_period;
    let last = settle + periods * per_period - 1;
    let long = Model {
        duration: (last as f64 + 0.25) * interval,
        settle: (settle as f64 - 0.25) * interval,
        sampling: Sampling::Rate(1.0 / interval),
        spectrum: Some(Window::Rectangular),
        verify: false,
        ..model.clone()
    };
    (long, per_period)
}

fn check_periodic(name: &str, mut model: Model) {
    model.integrator.tolerance = 1e-9;
    let steady = found(&model);
    let (long, per_period) = long(&model, &steady, 4);
    let mut sink = Collector {
        from: long.settle,
        samples: Vec::new(),
    };
    let run = simulate_into(&long, &mut sink).expect("a run");
    let freedoms = model.rotor.shaft.freedoms;
    for &axis in freedoms.axes() {
        let swing = peak_to_peak(steady.trace.iter().map(|sample| sample.displacement[axis]));
        let apart = sink.samples.iter().enumerate().map(|(number, sample)| {
            let other = &steady.trace[number % per_period];
            (sample.displacement[axis] - other.displacement[axis]).abs()
        });
        let apart = apart.fold(0.0, f64::max);
        println!("{name}, axis {axis}: {apart:e} of {swing:e}");
        assert!(
            apart < 1e-7 * swing.max(1e-9),
            "{name}, axis {axis}: {apart:e} of {swing:e}"
        );
    }
    let spectrum = run.spectrum.expect("a spectrum");
    for channel in Channel::of_freedoms(freedoms) {
        let lines = spectrum.channel(channel).expect("a channel");
        let largest = lines.amplitude.iter().skip(1).copied().fold(0.0, f64::max);
        for harmonic in 1..=8 {
            let frequency = f64::from(harmonic) / steady.period;
            let bin = (frequency / spectrum.resolution).round() as usize;
            let own = steady
                .lines
                .amplitude(channel, frequency)
                .expect("a channel");
            let apart = (lines.amplitude[bin] - own).abs();
            assert!(
                apart < 1e-7 * largest,
                "{name}, {channel} line {harmonic}: {apart:e} of {largest:e}"
            );
        }
    }
}

#[test]
fn passing_balls_make_the_motion_of_a_long_run() {
    check_periodic("balanced", shipped("balanced-7205c"));
}

#[test]
fn a_motion_of_doubled_period_is_that_of_a_long_run() {
    // the phase of a doubled motion is one of two: a long run takes either
    let mut model = shipped("varying-compliance-6306");
    model.integrator.tolerance = 1e-9;
    let steady = found(&model);
    assert_eq!(steady.multiple, 2);
    let (mut long, per_period) = long(&model, &steady, 2);
    // e^(−25) of a motion that leaves an unstable one first
    let more = (4.0 * long.settle / steady.period).ceil() * steady.period;
    long.duration += more;
    long.settle += more;
    let run = samples(&long, long.settle);
    let apart = |shift: usize| {
        let pairs = run.iter().enumerate();
        let apart = pairs.map(|(number, sample)| {
            let other = &steady.trace[(number + shift) % per_period];
            (sample.displacement[0] - other.displacement[0]).abs()
        });
        apart.fold(0.0, f64::max)
    };
    let swing = peak_to_peak(steady.trace.iter().map(|sample| sample.displacement[0]));
    let [same, other] = [apart(0), apart(per_period / 2)];
    println!("{same:e} and {other:e} of {swing:e}");
    assert!(
        same.min(other) < 1e-6 * swing,
        "{same:e}, {other:e} of {swing:e}"
    );
    assert!(
        same.max(other) > 1e-2 * swing,
        "{same:e}, {other:e} of {swing:e}"
    );
}

/// States where every period begins, and the strongest lines.
fn check_torus(name: &str, mut model: Model) {
    model.integrator.tolerance = 1e-9;
    let steady = found(&model);
    assert!(steady.is_torus());
    let first = (settled_after(&model) / steady.period).ceil() as usize;
    let long = Model {
        duration: (first + 200) as f64 * steady.period,
        settle: 0.0,
        sampling: Sampling::Rate(1.0 / steady.period),
        spectrum: None,
        verify: false,
        ..model.clone()
    };
    let run = samples(&long, 0.0);
    let freedoms = model.rotor.shaft.freedoms;
    for &axis in freedoms.axes() {
        let late = || run.iter().skip(first);
        let swing = peak_to_peak(late().map(|sample| sample.displacement[axis]));
        let apart = late().enumerate().map(|(number, sample)| {
            let (time, state) = steady.strobe((first + number) as u64);
            assert!((time - sample.time).abs() < 1e-12);
            (state[axis] - sample.displacement[axis]).abs()
        });
        let apart = apart.fold(0.0, f64::max);
        println!("{name}, axis {axis}: {apart:e} of {swing:e}");
        assert!(
            apart < 1e-6 * swing.max(1e-9),
            "{name}, axis {axis}: {apart:e} of {swing:e}"
        );
    }
}

#[test]
fn unbalance_and_passing_balls_make_two_frequencies() {
    for name in ["steady-7205c", "back-to-back-7205c"] {
        check_torus(name, shipped(name));
    }
}

/// The line of the unbalance stands on a bin of a run of whole revolutions; those of passing balls are
/// refined between bins.
#[test]
fn two_frequencies_have_the_lines_of_a_long_run() {
    let model = shipped("steady-7205c");
    let steady = found(&model);
    let long = Model {
        duration: 2.5,
        settle: 0.8,
        spectrum: Some(Window::Hann),
        verify: false,
        ..model.clone()
    };
    let run = simulate_into(&long, &mut Collector::default()).expect("a run");
    let mut compared = 0;
    for peak in run.peaks.iter().filter(|peak| peak.line.is_some()) {
        let same = run
            .peaks
            .iter()
            .filter(|other| other.channel == peak.channel);
        let strongest = same.map(|other| other.amplitude).fold(0.0, f64::max);
        if peak.amplitude < 1e-3 * strongest {
            continue;
        }
        let own = steady
            .lines
            .amplitude(peak.channel, peak.frequency)
            .expect("a channel");
        let apart = (own - peak.amplitude).abs() / peak.amplitude;
        println!("{} {:.3} Hz: {apart:e}", peak.channel, peak.frequency);
        // what the tails of other lines add to a peak under a Hann window
        assert!(
            apart < 1e-5,
            "{} {:.3} Hz: {apart:e}",
            peak.channel,
            peak.frequency
        );
        compared += 1;
    }
    assert!(compared >= 4, "{compared} lines");
}

/// Where a free vibration takes hundreds of revolutions to die, the search needs a tenth of the work of an
/// explicit run that waits for it, however the slopes' evaluations are counted. The method chosen on the way
/// waits with fewer evaluations: some four times those of the search.
#[test]
fn a_lightly_damped_scene_needs_a_tenth_of_the_work() {
    let mut scenes = vec![
        shipped("steady-7205c"),
        shipped("balanced-7205c"),
        shipped("linear-7205c"),
    ];
    for model in &mut scenes {
        model.rotor.damping = Damping::Ratio(0.002);
        model.verify = false;
        let stop = std::sync::atomic::AtomicBool::new(false);
        model.duration = settled_after(model) * (1e-8_f64.ln().abs() / 25.0);
        let mut waiting = model.clone();
        waiting.integrator.method = Method::Verner76;
        let run = BareRun::new(&waiting)
            .expect("a rotor")
            .integrate(&stop)
            .expect("a run");
        let steady = found(model);
        let ratio = run.evaluations as f64 / steady.counters.evaluations as f64;
        println!(
            "{} against {}: {ratio}",
            steady.counters.evaluations, run.evaluations
        );
        assert!(ratio > 10.0, "{ratio}");
    }
}

/// Where balls lose contact, a run misses its tolerance as well, and by more.
#[test]
fn the_measured_error_is_the_promise() {
    for name in [
        "steady-7205c",
        "balanced-7205c",
        "linear-7205c",
        "varying-compliance-6306",
    ] {
        for tolerance in [1e-6, 1e-8] {
            let mut model = shipped(name);
            model.integrator = Settings {
                tolerance,
                ..model.integrator
            };
            model.verify = true;
            let error = found(&model).measured.expect("a measured error").relative;
            let promise = if name == "varying-compliance-6306" {
                model.duration = 1.0;
                model.settle = 0.0;
                let run = simulate_into(&model, &mut Collector::default()).expect("a run");
                let own = run.measured_error.expect("a measured error").relative;
                f64::max(own, 10.0 * tolerance)
            } else {
                10.0 * tolerance
            };
            println!("{name} at {tolerance:e}: {error:e} of {promise:e}");
            assert!(
                error < promise,
                "{name} at {tolerance:e}: {error:e} of {promise:e}"
            );
        }
    }
}
