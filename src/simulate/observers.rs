//! Everybody who takes the samples of a run.

use super::analyses::Recorders;
use super::energy_audit::EnergyAudit;
use super::observation::Observation;
use super::tables::TableAudit;
use super::{Model, SimulateError, TraceSink, sampling};
use crate::analysis::{Recorder, Recording};
use crate::bearing::{LANES, Vector5};
use crate::integrate::Grid;
use crate::rotor::{Moving, Rotor, Sample, SampleLanes, SampleRows};

/// The sink, and what the answer of the run is made of.
pub(super) struct Observers<'a> {
    grid: Grid,
    /// Time before which nobody needs a sample, s.
    start: f64,
    /// Time before which samples tell no more than whether contacts part and meet, s.
    whole_from: f64,
    /// Time and displacement of the last instant up to which nothing has happened to any contact, where nobody has
    /// compared them since.
    passed: Option<(f64, Vector5)>,
    sink: &'a mut dyn TraceSink,
    /// Sees the samples side by side, where it can.
    lanes: Option<SampleLanes<'a>>,
    /// Whether no ball of the samples found last was to be looked at by itself.
    plain: bool,
    /// Those found last.
    rows: Box<SampleRows>,
    /// The same one by one, where anybody but the sink takes them whole.
    samples: Vec<Sample>,
    whole: bool,
    settle: f64,
    /// After the settle time, N.
    pub largest_ball_load: f64,
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
        let accounted = model.energy || rotor.is_driven();
        let takes_whole = accounted || model.analyses.maps || tables.is_due();
        let whole_run = takes_whole || observation.is_of_early_loads();
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
            plain: true,
            rows: SampleRows::new(),
            samples: Vec::new(),
            whole: takes_whole || !model.spectra.is_empty(),
            settle: model.settle,
            largest_ball_load: 0.0,
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
            let is_before = |index: &usize| self.grid.time(first + *index as u64) < end;
            match states.len() {
                // most blocks are on one side of it
                all if all > 0 && is_before(&(all - 1)) => all,
                all => (0..all).take_while(is_before).count(),
            }
        };
        let [early, whole] = [self.start, self.whole_from].map(before);
        self.follow(system, first + early as u64, &states[early..whole])?;
        let mut first = first + whole as u64;
        for states in states[whole..].chunks(SampleRows::MOST) {
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
        mut first: u64,
        states: &[[f64; N]],
    ) -> Result<(), SimulateError> {
        for states in states.chunks(SampleRows::MOST) {
            if self.are_certain(states) {
                self.pass_up_to(first, states.len() - 1);
            } else {
                self.look(system, first, states)?;
            }
            first += states.len() as u64;
        }
        Ok(())
    }

    /// Whether it is certain that nothing happens to any contact in states; leaves their displacements in the rows.
    fn are_certain<const N: usize>(&mut self, states: &[[f64; N]]) -> bool {
        let Some(lanes) = &self.lanes else {
            return false;
        };
        lanes.displace(states, &mut self.rows);
        self.observation.is_certainly_quiet(lanes, &self.rows)
    }

    /// Takes note that nothing has happened to any contact up to a sample in the rows, the first of which has a
    /// number.
    fn pass_up_to(&mut self, first: u64, index: usize) {
        let place = self.rows.displacement_at(index);
        self.passed = Some((self.grid.time(first + index as u64), place));
    }

    /// Finds the samples of states, which the sink and the observation of the bearings take one after the other.
    fn look<S: Moving<N>, const N: usize>(
        &mut self,
        system: &S,
        first: u64,
        states: &[[f64; N]],
    ) -> Result<(), SimulateError> {
        self.rows.clear();
        self.samples.clear();
        let Some(lanes) = &self.lanes else {
            return self.look_one_by_one(system, first, states);
        };
        let time = |index: usize| self.grid.time(first + index as u64);
        lanes.place(time, states, &mut self.rows);
        let plain = self.look_at_all();
        if plain {
            self.pass_up_to(first, states.len() - 1);
        } else {
            for (number, states) in states.chunks(LANES).enumerate() {
                if self.look_side_by_side(number, states.len())? {
                    self.pass_up_to(first, LANES * number + states.len() - 1);
                }
            }
        }
        if let Some(lanes) = &self.lanes {
            self.plain = plain || self.observation.is_plain(&self.rows, lanes);
            self.observation.consume(&self.rows, lanes);
        }
        Ok(())
    }

    /// Finds all samples in the rows at once; answers whether nobody needs them, or any of their balls, one by one.
    fn look_at_all(&mut self) -> bool {
        let (Some(lanes), rows) = (&mut self.lanes, &mut *self.rows) else {
            return false;
        };
        let needed = |time: &f64| *time >= self.sink.starts_at();
        if self.whole || !self.plain || rows.times().last().is_some_and(needed) {
            return false;
        }
        lanes.look_at_all(rows);
        let plain = self.observation.is_plain(rows, lanes);
        if plain {
            self.observation.take_plain(rows, lanes);
        }
        plain
    }

    /// Finds so many samples in the lanes of a number in the rows; answers whether nothing has happened to any
    /// contact.
    fn look_side_by_side(&mut self, number: usize, count: usize) -> Result<bool, SimulateError> {
        let (Some(lanes), rows) = (&mut self.lanes, &mut *self.rows) else {
            return Ok(false);
        };
        lanes.look(rows, number);
        let quiet = self.observation.is_quiet(lanes, number, count);
        // what is compared with the contacts where nobody looked at them
        if let Some((time, place)) = self.passed.take_if(|_| !quiet) {
            let instant = lanes.look_at(time, &place);
            self.observation.pass(time, lanes, instant);
            lanes.look(rows, number);
        }
        let observation = &mut self.observation;
        observation.take_side_by_side(rows, number, quiet, lanes, self.sink)?;
        if self.whole {
            let samples = (0..count).map(|lane| lanes.sample(rows, number, lane));
            self.samples.extend(samples);
        }
        Ok(quiet)
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
            self.rows.push(&sample);
            if self.whole {
                self.samples.push(sample);
            }
        }
        Ok(())
    }

    /// Shows the samples found last, with their states, to those who know nothing of the bearings.
    fn record<S: Moving<N>, const N: usize>(&mut self, system: &S, states: &[[f64; N]]) {
        let settled = self
            .rows
            .times()
            .partition_point(|time| *time < self.settle);
        for load in &self.rows.largest_ball_loads()[settled..] {
            self.largest_ball_load = self.largest_ball_load.max(*load);
        }
        if let Some(recorder) = &mut self.recorder {
            recorder.record_rows(&self.rows);
        }
        self.recorders.record(&self.rows, &self.samples);
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
