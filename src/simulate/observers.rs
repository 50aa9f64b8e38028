//! Everybody who takes the samples of a run.

use std::array;

use super::analyses::Recorders;
use super::energy_audit::EnergyAudit;
use super::observation::Observation;
use super::tables::TableAudit;
use super::{Model, SimulateError, TraceSink, sampling};
use crate::analysis::{Recorder, Recording};
use crate::bearing::{LANES, Vector5};
use crate::integrate::Grid;
use crate::rotor::{Moving, Rotor, Sample, SampleLanes};

/// Samples that are found before anybody but the sink takes them: a whole number of lanes.
const ROW: usize = 16 * LANES;

/// The sink, and what the answer of the run is made of.
pub(super) struct Observers<'a> {
    grid: Grid,
    /// Time before which nobody needs a sample, s.
    start: f64,
    /// Time before which samples tell no more than whether contacts part and meet, s.
    whole_from: f64,
    /// Time and displacement of the last instant at which contacts were certain and nobody looked at them.
    passed: Option<(f64, Vector5)>,
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
            || observation.is_of_early_loads();
        let whole_from = match whole_run {
            true => 0.0,
            false => sink.starts_at().min(model.settle),
        };
        // with energies the states are those of more than the rotor
        let lanes = observation.lanes(rotor).filter(|_| !model.energy);
        let start = match observation.is_of_contacts() {
            true => 0.0,
            false => whole_from,
        };
        Self {
            grid,
            start,
            whole_from: match lanes {
                Some(_) => whole_from,
                None => start,
            },
            passed: None,
            sink,
            lanes,
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
        let before = |end: f64| {
            let times = (first..).map(|number| self.grid.time(number));
            let times = times.take(states.len());
            times.take_while(|time| *time < end).count()
        };
        let [early, whole] = [self.start, self.whole_from].map(before);
        self.follow(system, first + early as u64, &states[early..whole])?;
        let mut first = first + whole as u64;
        for states in states[whole..].chunks(ROW) {
            self.catch_up();
            self.look(system, first, states)?;
            self.record(system, states);
            first += states.len() as u64;
        }
        Ok(())
    }

    /// Follows the contacts through states that tell nothing else, and looks at no ball where they are certain.
    fn follow<S: Moving<N>, const N: usize>(
        &mut self,
        system: &S,
        first: u64,
        states: &[[f64; N]],
    ) -> Result<(), SimulateError> {
        for (number, states) in (first..).step_by(LANES).zip(states.chunks(LANES)) {
            match self.last_certain(states) {
                Some(place) => {
                    let last = number + (states.len() - 1) as u64;
                    self.passed = Some((self.grid.time(last), place));
                }
                None => {
                    self.catch_up();
                    self.look(system, number, states)?;
                }
            }
        }
        Ok(())
    }

    /// Where the shaft is in the last of states; none unless it is certain that nothing happens in any of them.
    fn last_certain<const N: usize>(&self, states: &[[f64; N]]) -> Option<Vector5> {
        let lanes = self.lanes.as_ref()?;
        let places = states.iter().map(|state| lanes.displacement(state));
        let certain = self.observation.is_certainly_quiet(lanes, places);
        let last = states.last().filter(|_| certain)?;
        Some(lanes.displacement(last))
    }

    /// Looks at the contacts where they were certain last: what comes next is compared with them.
    fn catch_up(&mut self) {
        if let (Some((time, place)), Some(lanes)) = (self.passed.take(), &mut self.lanes) {
            lanes.look_at(time, &place);
            self.observation.pass(time, lanes);
        }
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
        self.recorders.record_all(&self.samples);
        for sample in &self.samples {
            self.audit.sample(sample);
            self.tables.sample(system.rotor(), sample);
        }
        let Some(recording) = &mut self.recording else {
            return;
        };
        let asked = recording.needs_acceleration();
        for (sample, state) in self.samples.iter().zip(states) {
            if recording.takes(sample.time) {
                let acceleration = asked.then(|| system.acceleration(sample.time, state));
                recording.record(sample, acceleration.as_ref());
            }
        }
    }
}
