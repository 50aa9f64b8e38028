//! What the reader of a run should know.

use super::{MeasuredError, Model};
use crate::rotor::Rotor;

/// A measured error above this many tolerances is worth a warning.
const PROMISE: f64 = 10.0;

pub(super) fn warnings(model: &Model, rotor: &Rotor, error: Option<&MeasuredError>) -> Vec<String> {
    let mut warnings = Vec::new();
    if model.spectrum.is_some() && rotor.steady_from(model.settle).is_none() {
        warnings.push(format!(
            "the speed changes after the settle time of {} s: lines of shaft and bearings smear in \
             the spectra, which have no orders, and no peak is named after them; ball-pass \
             frequencies are those at the highest speed, {} rad/s",
            model.settle,
            rotor.highest_speed()
        ));
    }
    let tolerance = model.integrator.tolerance;
    match error {
        Some(error) if error.relative > PROMISE * tolerance => warnings.push(format!(
            "the measured error is {:.1e} of the motion, more than {PROMISE} × the tolerance \
             {tolerance:.0e}: the motion may be irregular or rest on contact changes; trust \
             statistics rather than the single trace",
            error.relative
        )),
        None if model.verify => warnings.push(
            "the second pass that measures the error failed; the error of this run is unknown"
                .to_owned(),
        ),
        _ => {}
    }
    warnings
}
