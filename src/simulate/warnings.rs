//! What the reader of a run should know.

use std::f64::consts::TAU;

use super::{Model, Work};
use crate::analysis::{Channel, Kind, Motion};
use crate::integrate::{Method, Stiffness};
use crate::rotor::Rotor;

/// A measured error above this many tolerances is worth a warning.
pub(crate) const PROMISE: f64 = 10.0;

pub(super) fn warnings(
    model: &Model,
    rotor: &Rotor,
    work: &Work<'_>,
    motion: Option<&Motion>,
) -> Vec<String> {
    let mut warnings = Vec::new();
    if model.spectrum.is_some() && rotor.steady_from(model.settle).is_none() {
        warnings.push(format!(
            "the speed changes after the settle time of {} s: lines of shaft and bearings smear in \
             the spectra, which have no orders, and no peak is named after them; ball-pass \
             frequencies are those at the highest speed, {:.0} rpm ({:.1} rad/s)",
            model.settle,
            rotor.highest_speed() * 60.0 / TAU,
            rotor.highest_speed()
        ));
    }
    let tolerance = model.integrator.tolerance;
    let named = model.integrator.method;
    let method = work.method_use.as_ref().map_or(named, |used| used.latest());
    match &work.measured_error {
        Some(error) if error.relative > PROMISE * tolerance => warnings.push(format!(
            "the measured error is {:.1e} of the motion, more than {PROMISE} × the tolerance \
             {tolerance:.0e}: the motion may be irregular or rest on contact changes; trust \
             statistics rather than the single trace{}",
            error.relative,
            if method == Method::Verner76 {
                ""
            } else {
                ", or set method = \"verner76\" in [integrator], whose steps end where balls lift off"
            }
        )),
        _ => {}
    }
    if let Some(failure) = work.error_unknown {
        warnings.push(format!(
            "the second pass that measures the error failed, and the error of this run is unknown: \
             {failure}"
        ));
    }
    warnings.extend(work.stiffness.as_ref().map(stiff));
    warnings.extend(bearings(rotor));
    warnings.extend(motion.and_then(not_settled));
    warnings
}

/// What the bearings say of themselves at the static equilibrium and the highest speed.
fn bearings(rotor: &Rotor) -> Vec<String> {
    let states = rotor.bearing_states(rotor.highest_speed());
    let bearings = rotor.supports().iter().zip(states).enumerate();
    let known = bearings.filter(|(_, (support, _))| support.known_balls() > 0);
    let told = known.flat_map(|(index, (_, state))| {
        let number = index + 1;
        let say = move |text| format!("bearing {number}, at the static equilibrium: {text}");
        state.warnings.into_iter().map(say)
    });
    told.collect()
}

fn stiff(stiffness: &Stiffness) -> String {
    format!(
        "the problem is stiff: from t = {:.3e} s on stability, not accuracy, held the step at {:.1e} s \
         (largest eigenvalue {:.1e} 1/s); method = \"rodas\" in [integrator] takes steps of {:.1e} s \
         there for the same tolerance",
        stiffness.time, stiffness.step, stiffness.eigenvalue, stiffness.implicit_step
    )
}

/// The statistics of an irregular motion move by themselves, and nothing is said of them.
fn not_settled(motion: &Motion) -> Option<String> {
    let drift = motion.drift.filter(|drift| !drift.is_settled())?;
    if matches!(motion.recognition.kind, Kind::Irregular { .. }) {
        return None;
    }
    Some(format!(
        "the motion has not settled: from the second to the last third after the settle time the mean of \
         {} moves by {:.1} % of the vibration and its RMS by {:.1} %; make `settle` and `duration` longer",
        Channel::Displacement(drift.freedom),
        100.0 * drift.mean,
        100.0 * drift.rms
    ))
}
