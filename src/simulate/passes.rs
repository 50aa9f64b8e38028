//! The integrations of a run: the pass whose samples are shown, and a second, tighter one that measures its error.

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

/// Settings of the second pass: another tolerance.
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

/// The displacements of a shaft, as far as they were recorded.
#[derive(Debug, Clone, Default)]
pub(crate) struct Recorded([Moments; FREEDOMS]);

impl Recorded {
    /// Takes another displacement.
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

/// Sizes of a motion as both passes take them, where it is not known yet.
pub(super) fn motion_scale(model: &Model, rotor: &Rotor) -> MotionScale {
    rotor.motion_scale(reference_settings(model.integrator).tolerance)
}

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

/// The right scale, where states up to a grid time show a motion far below the one assumed; none where the rest of
/// the run need not be like them.
fn corrected(
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
    /// The motion after the settle time, where its error is measured.
    recorded: Recorded,
    watch: Watch<'a>,
    reference: Option<Reference<'a>>,
    /// The pass with more modes of a shaft that bends.
    finer: Option<Reference<'a>>,
}

/// Who ends the passes from outside, and who watches each of them.
#[derive(Clone, Copy)]
pub(super) struct Watch<'a> {
    pub stop: &'a AtomicBool,
    pub progress: [Option<&'a Progress>; 3],
}

/// Another pass, and how far the first is from it.
struct Reference<'a> {
    rotor: &'a Rotor,
    integration: Integration<'a>,
    states: States,
    /// Largest difference of a displacement from the first so far, m.
    difference: f64,
    /// Why it cannot go on, where it cannot.
    failure: Option<String>,
    tolerance: f64,
}

impl<'a> Passes<'a> {
    /// Starts all passes of a motion of a size.
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

    /// Starts anew with the right scale where the states of the first block show a motion far below the one assumed;
    /// whether it does.
    pub fn restart_to_scale(&mut self, states: &States) -> bool {
        let Some(scale) = corrected(self.rotor, &self.scale, self.grid, states) else {
            return false;
        };
        let rotors = (self.rotor, self.finer.as_ref().map(|finer| finer.rotor));
        *self = Self::start(self.model, rotors, self.grid, self.watch, scale);
        true
    }

    /// The size of the motion that the passes were started anew for, after the one assumed; none where that one was right.
    pub fn corrected_scale(&self) -> Option<[f64; 2]> {
        let assumed = motion_scale(self.model, self.rotor).length;
        (assumed != self.scale.length).then_some([assumed, self.scale.length])
    }

    /// How many times the recorded motion the scale is, where that is far too much.
    pub fn overestimate(&self) -> Option<f64> {
        let corrected = self.scale.corrected(self.recorded.size(&self.scale))?;
        Some(self.scale.length / corrected.length)
    }

    /// Takes the states from grid time number `first` on for the motion that errors are relative to.
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

    /// Goes on with the other passes over as many samples as the first has states in a block, and compares them.
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

    /// Difference of both passes; none without a second one that came to its end.
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
    /// A pass that cannot go on leaves the error of the run unknown.
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
            let (own, other) = (
                rotor.displacement(state),
                self.rotor.displacement(reference),
            );
            for &axis in rotor.freedoms().axes() {
                let apart = scale.lever(axis) * (own[axis] - other[axis]).abs();
                self.difference = self.difference.max(apart);
            }
            for (own, other) in rotor.body_freedoms().zip(self.rotor.body_freedoms()) {
                let apart = (state[own] - reference[other]).abs();
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
        if let Some(scale) = corrected(rotor, &scale, grid, &states) {
            integration = begun(&scale);
        }
        while integration.done() < grid.count {
            states.clear();
            integration.advance(BLOCK, &mut states)?;
        }
        Ok(integration.counters())
    }
}
