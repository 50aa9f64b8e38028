//! The integrations of a run, block by block side by side: the pass whose samples are shown, a second, tighter one that
//! measures its error, and of a shaft that bends one with more modes.

use std::sync::atomic::AtomicBool;

use super::run::{Reduction, ReductionError};
use super::{BLOCK, MeasuredError, Model, SimulateError, sampling};
use crate::analysis::Moments;
use crate::bearing::Vector5;
use crate::integrate::{
    Counters, Grid, IntegrateError, Integration, Progress, Settings, States, System,
};
use crate::rotor::{FREEDOMS, MotionScale, Rotor};

/// Factor between the tolerances of the two passes.
const REFERENCE_FACTOR: f64 = 0.1;
/// Below this tolerance the second pass is the looser one: round-off allows none that is tighter.
const TIGHTEST_WITH_REFERENCE: f64 = 1e-12;

/// Settings of the second pass: a tolerance ten times as tight, or as loose where round-off allows none that is tighter.
pub(crate) fn reference_settings(settings: Settings) -> Settings {
    let factor = if settings.tolerance >= TIGHTEST_WITH_REFERENCE {
        REFERENCE_FACTOR
    } else {
        1.0 / REFERENCE_FACTOR
    };
    Settings {
        tolerance: settings.tolerance * factor,
        ..settings
    }
}

/// Moments of the displacements of a shaft, x, y, z, θx and θy, over the states that were recorded.
#[derive(Debug, Clone, Default)]
pub(crate) struct Recorded([Moments; FREEDOMS]);

impl Recorded {
    /// Adds a displacement.
    pub fn take(&mut self, displacement: &Vector5) {
        for (moments, value) in self.0.iter_mut().zip(displacement) {
            moments.take(*value);
        }
    }

    /// Largest distance of a displacement from its mean, m; tilts count by their arm.
    pub fn size(&self, scale: &MotionScale) -> f64 {
        let axes = self.0.iter().enumerate();
        axes.map(|(axis, moments)| scale.lever(axis) * moments.peak())
            .fold(0.0, f64::max)
    }
}

/// The motion scale that all passes share before the motion is known: it must suit the tighter of the two tolerances.
pub(super) fn motion_scale(model: &Model, rotor: &Rotor) -> MotionScale {
    rotor.motion_scale(reference_settings(model.integrator).tolerance)
}

/// The integration of a rotor from its start.
fn pass<'a>(
    rotor: &'a Rotor,
    scale: &MotionScale,
    grid: Grid,
    settings: Settings,
    (stop, progress): (&'a AtomicBool, Option<&'a Progress>),
) -> Integration<'a> {
    let (scaling, state) = (rotor.scaling(scale), rotor.start_state());
    Integration::new(rotor, scaling, grid, settings, stop, &state).watched(progress)
}

/// The scale of the motion that the first states of a run show, where it is far smaller than the one assumed; none where
/// the rest of the run may differ from them, as in a run-up or before a shock.
fn corrected_by(
    rotor: &Rotor,
    scale: &MotionScale,
    grid: Grid,
    states: &States,
) -> Option<MotionScale> {
    let count = states.len() as u64;
    if count < grid.count && !rotor.goes_on_alike(grid.time(count)) {
        return None;
    }
    let mut recorded = Recorded::default();
    for state in states.iter() {
        recorded.take(&rotor.displacement(state));
    }
    scale.corrected(recorded.size(scale))
}

/// The passes of a run.
pub(super) struct Passes<'a> {
    model: &'a Model,
    pub rotor: &'a Rotor,
    pub grid: Grid,
    pub main: Integration<'a>,
    scale: MotionScale,
    /// The motion after the settle time that errors are relative to; recorded where the error is measured.
    recorded: Recorded,
    watch: Watch<'a>,
    reference: Option<Reference<'a>>,
    /// The pass with more modes of a shaft that bends.
    finer: Option<Reference<'a>>,
}

/// How the passes are stopped from outside, and where each reports its progress: the one shown, the tighter one, the one
/// with more modes.
#[derive(Clone, Copy)]
pub(super) struct Watch<'a> {
    pub stop: &'a AtomicBool,
    pub progress: [Option<&'a Progress>; 3],
}

/// Another pass, and how far the one that is shown is from it.
struct Reference<'a> {
    rotor: &'a Rotor,
    integration: Integration<'a>,
    states: States,
    /// Largest difference of a displacement from the pass that is shown so far, m.
    difference: f64,
    /// Why it cannot go on, where it cannot.
    failure: Option<String>,
    tolerance: f64,
}

impl<'a> Passes<'a> {
    /// Starts all passes with the motion scale that is assumed.
    pub fn start(
        model: &'a Model,
        (rotor, finer): (&'a Rotor, Option<&'a Rotor>),
        grid: Grid,
        watch: Watch<'a>,
        scale: MotionScale,
    ) -> Self {
        let Watch {
            stop,
            progress: [progress, reference_progress, finer_progress],
        } = watch;
        let second = reference_settings(model.integrator);
        let another = |rotor: &'a Rotor, settings: Settings, progress| {
            let integration = pass(rotor, &scale, grid, settings, (stop, progress));
            Reference {
                rotor,
                states: States::new(rotor.states()),
                difference: 0.0,
                failure: None,
                tolerance: settings.tolerance,
                integration,
            }
        };
        let reference = model
            .verify
            .then(|| another(rotor, second, reference_progress));
        let finer = finer.map(|finer| another(finer, model.integrator, finer_progress));
        Self {
            model,
            rotor,
            grid,
            main: pass(rotor, &scale, grid, model.integrator, (stop, progress)),
            scale,
            recorded: Recorded::default(),
            watch,
            reference,
            finer,
        }
    }

    /// Starts all passes anew where the states of the first block show a motion far smaller than the one assumed, whose
    /// error would be too large; whether it does.
    pub fn restart_to_scale(&mut self, states: &States) -> bool {
        let Some(scale) = corrected_by(self.rotor, &self.scale, self.grid, states) else {
            return false;
        };
        let rotors = (self.rotor, self.finer.as_ref().map(|finer| finer.rotor));
        *self = Self::start(self.model, rotors, self.grid, self.watch, scale);
        true
    }

    /// Length of the motion that was assumed first, and the one that the passes were started anew with; none where they were
    /// not.
    pub fn corrected_scale(&self) -> Option<[f64; 2]> {
        let assumed = motion_scale(self.model, self.rotor).length;
        (assumed != self.scale.length).then_some([assumed, self.scale.length])
    }

    /// How many times too large the length of the scale is for the recorded motion, where it is far too large.
    pub fn overestimate(&self) -> Option<f64> {
        let corrected = self.scale.corrected(self.recorded.size(&self.scale))?;
        Some(self.scale.length / corrected.length)
    }

    /// Adds a block of states, the first at grid time number `first`, to the motion that errors are relative to.
    pub fn record(&mut self, first: u64, states: &States) {
        if self.reference.is_none() {
            return;
        }
        for (index, state) in states.iter().enumerate() {
            if self.grid.time(first + index as u64) >= self.model.settle {
                self.recorded.take(&self.rotor.displacement(state));
            }
        }
    }

    /// An error in m relative to the recorded motion.
    fn relative(&self, error: f64) -> f64 {
        error / self.recorded.size(&self.scale).max(self.scale.least)
    }

    /// Advances the other passes by a block, and compares their states with those of the pass that is shown.
    ///
    /// # Errors
    /// [`IntegrateError::Interrupted`] where somebody asked the run to stop.
    pub fn compare(&mut self, states: &States) -> Result<(), IntegrateError> {
        let mut others = self.reference.iter_mut().chain(&mut self.finer);
        others.try_for_each(|other| other.compare(states, self.rotor, &self.scale))
    }

    /// Why the error is not known, where it was to be measured.
    pub fn failure(&self) -> Option<&str> {
        self.reference.as_ref()?.failure.as_deref()
    }

    /// Error by the difference of both passes, with the round-off that they share; none without a second pass that came to its
    /// end.
    pub fn measured_error(&self) -> Option<MeasuredError> {
        let reference = self.reference.as_ref()?;
        let displacement = reference.difference + self.rotor.displacement_round_off();
        reference.failure.is_none().then(|| MeasuredError {
            displacement,
            relative: self.relative(displacement),
            reference_tolerance: reference.tolerance,
            counters: reference.integration.counters(),
        })
    }

    /// What is kept of a shaft that bends, and the difference of the pass with more modes.
    pub fn reduction(&self) -> Option<Reduction> {
        let measured = |finer: &Reference<'_>| {
            finer.failure.is_none().then(|| ReductionError {
                displacement: finer.difference,
                relative: self.relative(finer.difference),
                modes: finer.rotor.bending_modes().unwrap_or_default(),
            })
        };
        Some(Reduction {
            modes: self.rotor.bending_modes()?,
            degrees_of_freedom: self.rotor.dofs(),
            error: self.finer.as_ref().and_then(measured),
        })
    }
}

impl Reference<'_> {
    /// Advances the pass by a block and takes the largest difference from the states shown, over the recorded point of the
    /// shaft, tilts by their arm, and all housings. Where the pass cannot go on, the error stays unknown and the run goes on.
    fn compare(
        &mut self,
        states: &States,
        rotor: &Rotor,
        scale: &MotionScale,
    ) -> Result<(), IntegrateError> {
        if self.failure.is_some() {
            return Ok(());
        }
        self.states.clear();
        match self.integration.advance(states.len(), &mut self.states) {
            Err(interrupted @ IntegrateError::Interrupted { .. }) => return Err(interrupted),
            result => self.failure = result.err().map(|error| error.to_string()),
        }
        for (state, reference) in states.iter().zip(self.states.iter()) {
            let (shown, other) = (
                rotor.displacement(state),
                self.rotor.displacement(reference),
            );
            for &axis in rotor.freedoms().axes() {
                let apart = scale.lever(axis) * (shown[axis] - other[axis]).abs();
                self.difference = self.difference.max(apart);
            }
            // a pass with more modes has its housings at other indices
            for (shown, other) in rotor.body_freedoms().zip(self.rotor.body_freedoms()) {
                let apart = (state[shown] - reference[other]).abs();
                self.difference = self.difference.max(apart);
            }
        }
        Ok(())
    }
}

/// The integration of a model and nothing else, ready to be run as often as one likes: what time and work are
/// measured on.
#[derive(Debug, Clone)]
pub struct BareRun<'a> {
    model: &'a Model,
    rotor: Rotor,
}

impl<'a> BareRun<'a> {
    /// Assembles the rotor of a model.
    ///
    /// # Errors
    /// [`SimulateError::Rotor`] where it cannot be assembled.
    pub fn new(model: &'a Model) -> Result<Self, SimulateError> {
        let mut rotor = Rotor::assemble(&model.rotor)?;
        if model.energy {
            rotor.account_for_energy();
        }
        Ok(Self { model, rotor })
    }

    /// The rotor.
    pub fn rotor(&self) -> &Rotor {
        &self.rotor
    }

    /// Integrates over all samples of the model by its method and forgets the states: no second pass, no
    /// observation of the bearings, no spectra.
    ///
    /// # Errors
    /// [`SimulateError`] as a run.
    pub fn integrate(&self, stop: &AtomicBool) -> Result<Counters, SimulateError> {
        let (model, rotor) = (self.model, &self.rotor);
        let grid = sampling::grid(model, rotor)?;
        let scale = motion_scale(model, rotor);
        let begun = |scale| pass(rotor, scale, grid, model.integrator, (stop, None));
        let mut integration = begun(&scale);
        let mut states = States::with_capacity(rotor.states(), BLOCK);
        integration.advance(BLOCK, &mut states)?;
        if let Some(scale) = corrected_by(rotor, &scale, grid, &states) {
            integration = begun(&scale);
        }
        while integration.done() < grid.count {
            states.clear();
            integration.advance(BLOCK, &mut states)?;
        }
        Ok(integration.counters())
    }
}
