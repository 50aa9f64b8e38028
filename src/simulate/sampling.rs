//! Where a run is sampled, what its spectra rest on, and what that takes.

use std::f64::consts::TAU;

use super::recorders::{maps_of, revolutions};
use super::{Model, Sampling, SimulateError, spectra};
use crate::analysis::{
    Analysis, BearingFrequencies, Channel, Line, LineSurfaces, Recording, SampleGrid, Segment,
    Sources, SpectrumKind, SpectrumRequest, Window, causes,
};
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

/// Takes what all spectra that are asked for need, if there are any.
pub(super) fn recording(model: &Model, rotor: &Rotor) -> Option<Recording> {
    if model.spectrum.is_none() && model.spectra.is_empty() {
        return None;
    }
    let whole = model.spectrum.map(|_| channels(model, rotor));
    let recording = Recording::new(sample_grid(model, rotor), model.settle)
        .with(whole.into_iter().flatten())
        .with_requests(&model.spectra);
    let recording = match model.spectra.is_empty() {
        true => recording.of_last(),
        false => recording,
    };
    Some(recording.until(model.duration))
}

/// Channels of the spectra of the whole run.
fn channels(model: &Model, rotor: &Rotor) -> Vec<Channel> {
    let freedoms = rotor.freedoms();
    match model.analyses.highest_order {
        None => {
            let mut channels = Channel::of_freedoms(freedoms);
            let columns = Channel::of_bodies(&model.rotor, freedoms.lengths());
            channels.extend(columns.filter(|channel| channel.needs_acceleration()));
            channels
        }
        Some(_) => {
            let mut channels = Channel::of_motion(&model.rotor);
            let forces = model.analyses.force_lines;
            channels.retain(|channel| forces || !channel.is_force());
            channels
        }
    }
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
    let supports = rotor.supports();
    supports.map(|support| support.ball_pass(speed)).collect()
}

/// Ball-pass frequencies at the nominal contact angles, without slip.
pub(super) fn nominal_ball_pass(rotor: &Rotor, speed: f64) -> Vec<BallPass> {
    let supports = rotor.supports();
    supports
        .map(|support| support.nominal_ball_pass(speed))
        .collect()
}

/// The rotor in the equilibrium of another speed than that of its start, where it has one.
fn at_speed(model: &Model, rotor: &Rotor, speed: f64) -> Option<Rotor> {
    let elsewhere = || Rotor::assemble(&model.rotor.at_constant_speed(speed)).ok();
    (speed != rotor.speed()).then(elsewhere).flatten()
}

/// Spectra of what was recorded, where the scene asks for them, their peaks named by `causes`; beside what is random, those
/// alone that are above the noise.
pub(super) fn analyse(
    model: &Model,
    rotor: &Rotor,
    recording: Option<&Recording>,
    causes: &[Line],
) -> Option<Analysis> {
    let (recording, window) = recording.zip(model.spectrum)?;
    let channels = channels(model, rotor);
    let highest = model.analyses.highest_order;
    if let Some(highest) = highest.filter(|_| !model.analyses.has_peaks()) {
        return Some(Analysis {
            spectrum: recording.lines(&channels, window, highest)?,
            peaks: Vec::new(),
        });
    }
    let mut found = recording.spectrum(&channels, window, causes)?;
    // the skirts of a line off its bin would hide weaker ones
    if model.analyses.fits_window && spectra::leaks(&found.spectrum) {
        found = recording.spectrum(&channels, Window::Hann, causes)?;
    }
    Some(match rotor.is_random() {
        true => found.without_names_of_noise(),
        false => found,
    })
}

/// What can cause lines of the spectra that have names: peaks and envelopes; nothing where none is asked for.
pub(crate) fn line_causes(model: &Model, rotor: &Rotor) -> Vec<Line> {
    let is_envelope = |request: &SpectrumRequest| {
        matches!(
            request.kind,
            SpectrumKind::Envelope { .. } | SpectrumKind::ImpulsiveEnvelope
        )
    };
    let has_peaks = model.spectrum.is_some() && model.analyses.has_peaks();
    if has_peaks || model.spectra.iter().any(is_envelope) {
        causes(&sources(model, rotor))
    } else {
        Vec::new()
    }
}

/// What makes lines: nothing that turns where the speed changes.
fn sources(model: &Model, rotor: &Rotor) -> Sources {
    let Some(speed) = rotor.steady_from(model.settle) else {
        return Sources {
            natural: rotor.natural_frequencies(),
            ..Sources::default()
        };
    };
    let elsewhere = at_speed(model, rotor, speed);
    let rotor_there = elsewhere.as_ref().unwrap_or(rotor);
    let frequencies = |(simulated, nominal)| BearingFrequencies { simulated, nominal };
    let simulated = rotor
        .supports()
        .map(|support| match support.follows_cage() {
            true => support.ball_pass(speed),
            // a stiffness matrix knows no balls
            false => BallPass::from_rings([0.0; 2], 0.0, 0, 0.0),
        });
    Sources {
        shaft: speed / TAU,
        bearings: simulated
            .zip(nominal_ball_pass(rotor, speed))
            .map(frequencies)
            .collect(),
        surfaces: line_surfaces(rotor),
        unbalanced: rotor.is_unbalanced(),
        loads: rotor.load_frequencies(speed),
        natural: rotor_there.natural_frequencies(),
        meshing: rotor.meshing_frequencies(speed),
    }
}

/// What the surfaces of every bearing add to the lines.
fn line_surfaces(rotor: &Rotor) -> Vec<LineSurfaces> {
    rotor.supports().map(LineSurfaces::new).collect()
}

/// Bytes of what does not grow with the duration: program, page, figures, blocks of samples.
const FLAT: f64 = 24e6;
/// Bytes of a number.
const NUMBER: f64 = 8.0;
/// Numbers a sample that are kept while a spectrum of the whole record is taken: the transform and its argument.
const TRANSFORM: f64 = 8.0;
/// Numbers a sample of a segment that an estimated spectrum keeps of each of its channels.
const ESTIMATED: f64 = 3.0;
/// Numbers a sample that the maps of a run-up keep.
const MAPS: f64 = 3.0;

/// What a run takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunSize {
    /// Samples.
    pub samples: u64,
    /// Columns that are kept in memory for the spectra.
    pub columns: usize,
    /// Numbers in the tables of its maps and of spectra by segments.
    pub table_numbers: f64,
    /// Memory, bytes: of the run alone, somewhat more than it turns out to take.
    pub memory: f64,
}

impl RunSize {
    /// What a model takes.
    ///
    /// # Errors
    /// [`SimulateError`] where it cannot be run at all.
    pub fn from_model(model: &Model) -> Result<Self, SimulateError> {
        let rotor = Rotor::assemble(&model.rotor)?;
        let grid = grid(model, &rotor)?;
        let rate = 1.0 / grid.interval;
        let recorded = (model.duration - model.settle) * rate + 1.0;
        let recording = recording(model, &rotor);
        let columns = recording.as_ref().map_or(0, Recording::columns);
        let kept = recording.map_or(0.0, |recording| recording.kept_of(recorded));
        let mut numbers = columns as f64 * kept;
        if model.spectrum.is_some() {
            numbers += (columns as f64 + TRANSFORM) * kept;
        }
        let mut table_numbers = 0.0;
        for request in &model.spectra {
            let segment = segment_samples(request, recorded, rate, rotor.highest_speed());
            let channels = request.channels.len() as f64;
            numbers += ESTIMATED * channels * segment + TRANSFORM * recorded;
            table_numbers += 0.5 * segment * (channels + 1.0);
        }
        if model.analyses.maps {
            let samples = grid.count as f64;
            numbers += MAPS * samples;
            let (waterfall, tracks) = maps_of(model, &rotor, rate);
            table_numbers += waterfall.table_numbers(samples);
            table_numbers += tracks.table_numbers(revolutions(model, &rotor));
        }
        Ok(Self {
            samples: grid.count,
            columns,
            table_numbers,
            memory: FLAT + NUMBER * numbers,
        })
    }
}

/// Samples of a segment, at most those that are recorded.
fn segment_samples(request: &SpectrumRequest, recorded: f64, rate: f64, highest: f64) -> f64 {
    let samples = match request.segment {
        Segment::Whole => recorded,
        Segment::Seconds(seconds) => seconds * rate,
        Segment::Samples(count) => count as f64,
        Segment::Revolutions(count) => f64::from(count) * TAU / highest * rate,
    };
    samples.min(recorded)
}
