//! Everybody who takes the samples of a run.

use super::energy_audit::EnergyAudit;
use super::observation::Observation;
use super::recorders::Recorders;
use super::tables::TableAudit;
use super::{Model, SimulateError, TraceSink, sampling};
use crate::analysis::Recording;
use crate::integrate::{Grid, States};
use crate::rotor::{Rotor, Sample};

/// The sink, and what the answer of the run is made of.
pub(super) struct Observers<'a> {
    grid: Grid,
    /// Time before which nobody needs a sample, s.
    start: f64,
    sink: &'a mut dyn TraceSink,
    settle: f64,
    /// After the settle time, N; none where no ball is observed.
    pub largest_ball_load: Option<f64>,
    pub recorders: Recorders,
    pub recording: Option<Recording>,
    pub observation: Observation<'a>,
    pub audit: EnergyAudit,
    pub tables: TableAudit,
    /// Whether somebody asks for accelerations.
    accelerations: bool,
    /// Room for a derivative.
    rate: Vec<f64>,
}

impl<'a> Observers<'a> {
    pub fn new(
        model: &Model,
        rotor: &'a Rotor,
        grid: Grid,
        sink: &'a mut dyn TraceSink,
        tables: TableAudit,
    ) -> Self {
        let observation = Observation::new(model, rotor, sink.needs_contact_angles());
        let whole_run = model.energy
            || rotor.is_driven()
            || model.analyses.maps
            || tables.is_due()
            || observation.is_of_contacts();
        let recording = sampling::recording(model, rotor);
        let recorded = recording.as_ref();
        let recorders = Recorders::new(model, rotor, &grid);
        let accelerations =
            sink.needs_acceleration() || recorded.is_some_and(Recording::needs_acceleration);
        Self {
            grid,
            start: match whole_run {
                true => 0.0,
                false => sink.starts_at().min(model.settle),
            },
            sink,
            settle: model.settle,
            largest_ball_load: None,
            recorders,
            recording,
            accelerations,
            observation,
            audit: EnergyAudit::default(),
            tables,
            rate: Vec::new(),
        }
    }

    /// Shows everybody the samples of states from grid time number `first` on.
    pub fn take(
        &mut self,
        rotor: &Rotor,
        first: u64,
        states: &States,
    ) -> Result<(), SimulateError> {
        for (index, state) in states.iter().enumerate() {
            let time = self.grid.time(first + index as u64);
            if time < self.start {
                continue;
            }
            let rate = self.accelerations.then_some(&mut self.rate);
            let sample = rotor.whole_sample(time, state, self.observation.contacts(), rate);
            self.sink.sample(&sample)?;
            self.observation.take(&sample, self.sink)?;
            self.record(rotor, &sample, state);
            self.observation.contacts().reuse(sample);
        }
        Ok(())
    }

    /// Shows a sample and its state to those who know nothing of the balls.
    fn record(&mut self, rotor: &Rotor, sample: &Sample, state: &[f64]) {
        if sample.time >= self.settle {
            let largest = [self.largest_ball_load, sample.largest_ball_load];
            self.largest_ball_load = largest.into_iter().flatten().reduce(f64::max);
        }
        self.observation.take_linear(rotor, sample.time, state);
        self.recorders.record(sample);
        self.audit.sample(sample);
        self.tables.sample(rotor, sample.time, state);
        if let Some(recording) = &mut self.recording {
            recording.record(sample);
        }
    }
}
