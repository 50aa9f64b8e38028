//! Where a run is sampled, and what its spectra rest on.

use std::f64::consts::TAU;

use super::{Model, Sampling, SimulateError};
use crate::analysis::{Analysis, Recorder, Recording, SampleGrid, causes};
use crate::integrate::Grid;
use crate::physics::BallPass;
use crate::rotor::Rotor;

/// The sample times: the first at 0, the last not after the duration.
pub(super) fn grid(model: &Model, rotor: &Rotor) -> Result<Grid, SimulateError> {
    let highest = rotor.highest_speed();
    let interval = match model.sampling {
        Sampling::Rate(rate) => 1.0 / rate,
        Sampling::PerRevolution(_) if highest == 0.0 => {
            return Err(SimulateError::NoRevolution);
        }
        Sampling::PerRevolution(samples) => TAU / (highest * f64::from(samples)),
    };
    // a duration of whole intervals keeps its last sample in spite of round-off
    let intervals = (model.duration / interval * (1.0 + 4.0 * f64::EPSILON)).floor();
    Ok(Grid {
        interval,
        count: intervals as u64 + 1,
    })
}

pub(super) fn recorder(model: &Model, rotor: &Rotor) -> Recorder {
    let (kept, settle) = (rotor.kept(), model.settle);
    let SampleGrid {
        rate,
        shaft_frequency: shaft,
        per_revolution,
    } = sample_grid(model, rotor);
    match per_revolution {
        Some(samples) => Recorder::on_angle_grid(kept, settle, shaft, samples),
        None => Recorder::on_time_grid(kept, settle, shaft, rate),
    }
}

/// Takes what the spectra that are asked for need, if there are any.
pub(super) fn recording(model: &Model, rotor: &Rotor) -> Option<Recording> {
    let asked = !model.spectra.is_empty();
    asked.then(|| Recording::new(sample_grid(model, rotor), model.settle, &model.spectra))
}

/// On a grid of shaft angle where the speed is steady after the settle time at its highest, and so
/// makes a whole number of samples a revolution; else on a free grid of time.
fn sample_grid(model: &Model, rotor: &Rotor) -> SampleGrid {
    let shaft_frequency = shaft_frequency(model, rotor);
    let highest = rotor.highest_speed() / TAU;
    let (rate, per_revolution) = match model.sampling {
        Sampling::PerRevolution(samples) => {
            let is_uniform = shaft_frequency == highest;
            (highest * f64::from(samples), is_uniform.then_some(samples))
        }
        Sampling::Rate(rate) => (rate, None),
    };
    SampleGrid {
        rate,
        shaft_frequency,
        per_revolution,
    }
}

/// Frequency of the shaft in the spectra, Hz; zero where it changes after the settle time.
fn shaft_frequency(model: &Model, rotor: &Rotor) -> f64 {
    rotor.steady_from(model.settle).unwrap_or(0.0) / TAU
}

/// The speed of the spectra; the highest one where it changes after the settle time, rad/s.
pub(super) fn reported_speed(model: &Model, rotor: &Rotor) -> f64 {
    let steady = rotor.steady_from(model.settle);
    steady.unwrap_or_else(|| rotor.highest_speed())
}

pub(super) fn ball_pass(rotor: &Rotor, speed: f64) -> Vec<BallPass> {
    let supports = rotor.supports().iter();
    supports.map(|support| support.ball_pass(speed)).collect()
}

/// Ball passes that make lines: none where the speed changes.
fn spectral_ball_pass(model: &Model, rotor: &Rotor) -> Vec<BallPass> {
    let steady = rotor.steady_from(model.settle);
    steady.map_or_else(Vec::new, |speed| ball_pass(rotor, speed))
}

/// Spectra of what was recorded, where the scene asks for them, their peaks named.
pub(super) fn analyse(
    model: &Model,
    rotor: &Rotor,
    recorder: Option<Recorder>,
) -> Option<Analysis> {
    let (recorder, window) = recorder.zip(model.spectrum)?;
    let modes = rotor.natural_frequencies();
    let natural: Vec<f64> = modes.iter().map(|mode| mode.frequency).collect();
    let shaft = shaft_frequency(model, rotor);
    recorder.finish(
        window,
        &causes(shaft, &spectral_ball_pass(model, rotor), &natural),
    )
}
