//! The integrations of a run, block by block side by side: the pass whose samples are shown, a second, tighter one that
//! measures its error, and of a shaft that bends one with more modes.

use std::sync::atomic::AtomicBool;

use super::run::{Reduction, ReductionError};
use super::{MeasuredError, Model};
use crate::bearing::Vector5;
use crate::integrate::{
    Counters, Grid, IntegrateError, Integration, Method, Progress, Settings, States, System,
};
use crate::rotor::{FREEDOMS, MotionScale, Rotor};

/// Factor between the tolerances of the two passes.
const REFERENCE_FACTOR: f64 = 0.1;
/// Below this tolerance the second pass is the looser one: round-off allows none that is tighter.
const TIGHTEST_WITH_REFERENCE: f64 = 1e-12;

/// Tolerance that the pass with more modes begins with: what it measures is seldom smaller, and needs no more digits.
const FINER_TOLERANCE: f64 = 1e-5;
/// The pass with more modes begins anew with a smaller tolerance unless the difference that it measures is so many times its own.
const FINER_MARGIN: f64 = 2.0;
/// Factor by which that tolerance falls at least.
const FINER_FACTOR: f64 = 0.25;

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

/// Settings of the pass with more modes: by the method whose steps stability does not hold, as modes are stiff.
fn finer_settings(settings: Settings, tolerance: f64) -> Settings {
    Settings {
        method: Method::Exponential,
        tolerance,
        ..settings
    }
}

/// Extremes and means of the displacements of a shaft, x, y, z, θx and θy, over the states that were recorded.
#[derive(Debug, Clone)]
pub(crate) struct Recorded {
    count: f64,
    mean: Vector5,
    lowest: Vector5,
    highest: Vector5,
}

impl Default for Recorded {
    fn default() -> Self {
        Self {
            count: 0.0,
            mean: [0.0; FREEDOMS],
            lowest: [f64::INFINITY; FREEDOMS],
            highest: [f64::NEG_INFINITY; FREEDOMS],
        }
    }
}

impl Recorded {
    /// Adds a displacement.
    pub fn take(&mut self, displacement: &Vector5) {
        self.count += 1.0;
        for (axis, &value) in displacement.iter().enumerate() {
            self.mean[axis] += (value - self.mean[axis]) / self.count;
            self.lowest[axis] = self.lowest[axis].min(value);
            self.highest[axis] = self.highest[axis].max(value);
        }
    }

    /// Largest displacement, m; tilts count by their arm.
    fn largest(&self, scale: &MotionScale) -> f64 {
        let largest = |axis: usize| self.highest[axis].abs().max(self.lowest[axis].abs());
        (0..FREEDOMS)
            .map(|axis| scale.lever(axis) * largest(axis))
            .filter(|largest| largest.is_finite())
            .fold(0.0, f64::max)
    }

    /// Largest distance of a displacement from its mean, m; tilts count by their arm.
    pub fn size(&self, scale: &MotionScale) -> f64 {
        let peak = |axis: usize| {
            let above = self.highest[axis] - self.mean[axis];
            above.max(self.mean[axis] - self.lowest[axis])
        };
        (0..FREEDOMS)
            .map(|axis| scale.lever(axis) * peak(axis))
            .fold(0.0, f64::max)
    }
}

/// The motion scale that all passes share before the motion is known: it must suit the tighter of the two tolerances.
pub(super) fn motion_scale(model: &Model, rotor: &Rotor) -> MotionScale {
    rotor.motion_scale(reference_settings(model.integrator).tolerance)
}

/// The integration of a rotor from its start.
pub(super) fn pass<'a>(
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
pub(super) fn corrected_by(
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
        let another = |rotor: &'a Rotor, settings: Settings, progress| {
            Reference::start(rotor, &scale, grid, settings, (stop, progress))
        };
        let second = reference_settings(model.integrator);
        let reference = model
            .verify
            .then(|| another(rotor, second, reference_progress));
        let tolerance = model.integrator.tolerance.max(FINER_TOLERANCE);
        let few_digits = finer_settings(model.integrator, tolerance);
        let finer = finer.map(|finer| another(finer, few_digits, finer_progress));
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
        let (rotor, scale) = (self.rotor, &self.scale);
        if let Some(reference) = &mut self.reference {
            reference.compare(states, rotor, scale)?;
        }
        let Some(finer) = &mut self.finer else {
            return Ok(());
        };
        let is_first = finer.integration.done() == 0;
        finer.compare(states, rotor, scale)?;
        // after the first block the difference only grows
        let least = self.model.integrator.tolerance;
        while let Some(tolerance) = finer.tighter(scale, least).filter(|_| is_first) {
            let settings = finer_settings(self.model.integrator, tolerance);
            let watch = (self.watch.stop, self.watch.progress[2]);
            *finer = Reference::start(finer.rotor, scale, self.grid, settings, watch);
            finer.compare(states, rotor, scale)?;
        }
        Ok(())
    }

    /// Why the error is not known, where it was to be measured.
    pub fn failure(&self) -> Option<&str> {
        self.reference.as_ref()?.failure.as_deref()
    }

    /// Error by the difference of both passes, with the round-off that they share; none without a second pass that came to its
    /// end.
    pub fn measured_error(&self) -> Option<MeasuredError> {
        let reference = self.reference.as_ref()?;
        let duration = self.grid.time(self.grid.count - 1);
        let round_off = self.rotor.displacement_round_off()
            + self.rotor.linear_round_off(duration) * self.recorded.largest(&self.scale);
        let displacement = reference.difference + round_off;
        reference.failure.is_none().then(|| MeasuredError {
            displacement,
            relative: self.relative(displacement),
            reference_tolerance: reference.tolerance,
            counters: reference.integration.counters(),
        })
    }

    /// Work of the pass with more modes, where it measured anything.
    pub fn finer_counters(&self) -> Option<Counters> {
        let finer = self.finer.as_ref()?;
        finer
            .failure
            .is_none()
            .then(|| finer.integration.counters())
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

impl<'a> Reference<'a> {
    /// Starts a pass of a rotor.
    fn start(
        rotor: &'a Rotor,
        scale: &MotionScale,
        grid: Grid,
        settings: Settings,
        watch: (&'a AtomicBool, Option<&'a Progress>),
    ) -> Self {
        Self {
            rotor,
            integration: pass(rotor, scale, grid, settings, watch),
            states: States::new(rotor.states()),
            difference: 0.0,
            failure: None,
            tolerance: settings.tolerance,
        }
    }

    /// The tolerance, `least` or more, that the difference so far asks for, where it is a smaller one than that of the pass:
    /// its own error would be a part of what it measures.
    fn tighter(&self, scale: &MotionScale, least: f64) -> Option<f64> {
        let reported = self.difference / scale.length / FINER_MARGIN;
        let asks = self.failure.is_none() && reported < self.tolerance && self.tolerance > least;
        asks.then(|| reported.min(FINER_FACTOR * self.tolerance).max(least))
    }

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
