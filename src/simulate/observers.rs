//! Everybody who takes the samples of a run.

use std::array;

use super::analyses::Recorders;
use super::energy_audit::EnergyAudit;
use super::observation::Observation;
use super::tables::TableAudit;
use super::{Model, SimulateError, TraceSink, sampling};
use crate::analysis::{Recorder, Recording};
use crate::bearing::LANES;
use crate::integrate::Grid;
use crate::rotor::{Moving, Rotor, Sample, SampleLanes};

/// Samples that are found before anybody but the sink takes them: a whole number of lanes.
const ROW: usize = 16 * LANES;

/// The sink, and what the answer of the run is made of.
pub(super) struct Observers<'a> {
    grid: Grid,
    /// Time before which nobody needs a sample, s.
    start: f64,
    sink: &'a mut dyn TraceSink,
    /// Sees the samples side by side, where it can.
    lanes: Option<SampleLanes<'a>>,
    /// Those found last.
    samples: Vec<Sample>,
    pub recorder: Option<Recorder>,
    pub recorders: Recorders,
    pub recording: Option<Recording>,
    pub observation: Observation<'a>,
    pub audit: EnergyAudit,
    pub tables: TableAudit,
}

impl<'a> Observers<'a> {
    pub fn new(
        model: &Model,
        rotor: &'a Rotor,
        grid: Grid,
        sink: &'a mut dyn TraceSink,
        tables: TableAudit,
    ) -> Self {
        let observation = Observation::new(model, rotor);
        let whole_run = model.energy
            || rotor.is_driven()
            || model.analyses.maps
            || tables.is_due()
            || observation.is_of_whole_run();
        Self {
            grid,
            start: match whole_run {
                true => 0.0,
                false => sink.starts_at().min(model.settle),
            },
            sink,
            // with energies the states are those of more than the rotor
            lanes: observation.lanes(rotor).filter(|_| !model.energy),
            samples: Vec::with_capacity(ROW),
            recorder: model.spectrum.map(|_| sampling::recorder(model, rotor)),
            recorders: Recorders::new(model, rotor, &grid),
            recording: sampling::recording(model, rotor),
            observation,
            audit: EnergyAudit::default(),
            tables,
        }
    }

    /// Shows everybody the samples of states from grid time number `first` on.
    pub fn take<S: Moving<N>, const N: usize>(
        &mut self,
        system: &S,
        first: u64,
        states: &[[f64; N]],
    ) -> Result<(), SimulateError> {
        let times = (first..).map(|number| self.grid.time(number));
        let early = times
            .take(states.len())
            .take_while(|time| *time < self.start);
        let early = early.count();
        let mut first = first + early as u64;
        for states in states[early..].chunks(ROW) {
            self.look(system, first, states)?;
            self.record(system, states);
            first += states.len() as u64;
        }
        Ok(())
    }

    /// Finds the samples of states, which the sink and the observation of the bearings take one after the other.
    fn look<S: Moving<N>, const N: usize>(
        &mut self,
        system: &S,
        first: u64,
        states: &[[f64; N]],
    ) -> Result<(), SimulateError> {
        self.samples.clear();
        let Some(lanes) = &mut self.lanes else {
            return self.look_one_by_one(system, first, states);
        };
        for (number, states) in (first..).step_by(LANES).zip(states.chunks(LANES)) {
            // lanes that are left over see the last state once more
            let last = states.len() - 1;
            let times = array::from_fn(|lane| self.grid.time(number + lane.min(last) as u64));
            let own = array::from_fn(|lane| &states[lane.min(last)]);
            let already = self.samples.len();
            lanes.observe(times, own, states.len(), &mut self.samples);
            let found = &self.samples[already..];
            self.observation
                .take_side_by_side(found, lanes, self.sink)?;
        }
        Ok(())
    }

    fn look_one_by_one<S: Moving<N>, const N: usize>(
        &mut self,
        system: &S,
        first: u64,
        states: &[[f64; N]],
    ) -> Result<(), SimulateError> {
        for (number, state) in (first..).zip(states) {
            let time = self.grid.time(number);
            let sample = system.sample(time, state, self.observation.contacts());
            self.sink.sample(&sample)?;
            self.observation.take(&sample, self.sink)?;
            self.samples.push(sample);
        }
        Ok(())
    }

    /// Shows the samples found last, with their states, to those who know nothing of the bearings.
    fn record<S: Moving<N>, const N: usize>(&mut self, system: &S, states: &[[f64; N]]) {
        if let Some(recorder) = &mut self.recorder {
            recorder.record_all(&self.samples);
        }
        for (sample, state) in self.samples.iter().zip(states) {
            self.audit.sample(sample);
            self.tables.sample(system.rotor(), sample);
            self.recorders.record(sample);
            let recording = self.recording.as_mut();
            if let Some(recording) = recording.filter(|all| all.takes(sample.time)) {
                let asked = recording.needs_acceleration();
                let acceleration = asked.then(|| system.acceleration(sample.time, state));
                recording.record(sample, acceleration.as_ref());
            }
        }
    }
}
