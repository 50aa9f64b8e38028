//! Many runs of one scenario: which there are, in which order, on how many threads, and what is kept of each; the
//! runs of a chain go on from where the one before ended.

mod numbers;
mod record;
mod schedule;
mod statics;

use std::io;
use std::sync::atomic::AtomicBool;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use numbers::{NumberColumn, number_columns};
pub use record::{BearingStiffness, KeptPeak, Line, Outcome, Place, Point, RunRecord, TraceSeal};
use record::{Carried, RunSink};
use schedule::Turn;
pub use schedule::{Cycles, Direction, Schedule, Shard, Sweep, cycles_a_revolution, work};
pub use statics::{AROUND, static_columns, static_outcome};

use crate::analysis::{Channel, Motion, Peak, SectionKind, Spectrum};
use crate::integrate::IntegrateError;
use crate::simulate::{
    Analyses, Model, Monitor, MotionAnalysis, Run, SimulateError, StaticState, TraceSink, simulate,
};
use crate::study::plan::Plan;

/// What a study asks at every point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Ask {
    /// How the shaft moves, as `jeffcott run` does.
    #[default]
    Run,
    /// The static equilibrium of the shaft, as `jeffcott bearing` does.
    Bearing,
}

/// What is kept of every run, besides its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Keep {
    /// Highest order up to which the amplitudes of the displacements are kept; none where `None`.
    pub highest_order: Option<f64>,
    /// Whether the stiffness of every bearing at the static equilibrium is kept.
    pub bearing_stiffness: bool,
    /// Whether the trace of every run is kept.
    pub traces: bool,
    /// The section whose points are kept, where any are.
    pub section: Option<SectionKind>,
}

impl Keep {
    /// Leaves out all that nothing of what is kept rests on.
    fn reduce(&self, columns: &[NumberColumn], model: &mut Model) {
        model.spectra.clear();
        let highest_order = self.order_of_lines(columns);
        model.spectrum = model.spectrum.filter(|_| highest_order.is_some());
        let fits_window = model.analyses.fits_window;
        model.analyses = Analyses {
            fits_window,
            motion: match self.section {
                None => MotionAnalysis::None,
                section => MotionAnalysis::Statistics(section),
            },
            machine: None,
            maps: false,
            loads: false,
            velocities: false,
            settled_only: true,
            highest_order,
            named_peaks: self.highest_order.is_some(),
            force_lines: false,
        };
        for column in columns {
            (column.ask)(&mut model.analyses);
        }
    }

    /// Highest order of the spectra; none where nothing rests on them.
    fn order_of_lines(&self, columns: &[NumberColumn]) -> Option<f64> {
        let orders = columns.iter().filter_map(|column| column.order);
        let highest = orders.map(f64::from).chain(self.highest_order);
        // round-off may put the bin of an order just beyond it
        highest.reduce(f64::max).map(|order| order * (1.0 + 1e-9))
    }
}

/// Why a run is to be made again.
#[derive(Debug, thiserror::Error)]
pub enum Unmade {
    /// It was to stop before its end.
    #[error("interrupted; the same command goes on from what is done")]
    Stopped,
    /// Its trace could not be kept.
    #[error("{0}; with that mended the same command goes on from what is done")]
    Trace(#[from] io::Error),
}

/// Keeps the trace of a run.
pub trait KeptTrace: TraceSink {
    /// Takes note that the run came to its end; answers what the trace is known by.
    ///
    /// # Errors
    /// Whatever keeps the trace from being whole.
    fn finish(self: Box<Self>) -> io::Result<TraceSeal>;
}

/// Begins to keep the trace of the run of a number.
pub type TraceKeeper<'a> = &'a (dyn Fn(u64) -> io::Result<Box<dyn KeptTrace>> + Sync);

/// Makes the runs of a study.
#[derive(Clone, Copy)]
pub struct Maker<'a> {
    /// Values of every point.
    pub plan: &'a Plan,
    /// Runs and chains.
    pub schedule: Schedule,
    /// What is kept.
    pub keep: Keep,
    /// Every so many runs the error is measured; 0 on none.
    pub verify_every: u64,
    /// What keeps the traces of the runs, where they are kept.
    pub traces: Option<TraceKeeper<'a>>,
    /// Numbers that are kept.
    pub columns: &'a [NumberColumn],
    /// The motion of a point's values, or what is wrong with them.
    pub model: &'a (dyn Fn(&[f64]) -> Result<Model, String> + Sync),
    /// Set where all is to stop.
    pub stop: &'a AtomicBool,
}

impl Maker<'_> {
    /// Makes all runs of a chain and hands each on, until it is answered that no more are taken; the last that it hands
    /// on may be [`Unmade`], where it was to stop or a trace could not be kept.
    pub fn chain(&self, chain: u64, hand: &dyn Fn(Result<RunRecord, Unmade>) -> bool) {
        let mut carried = None;
        for turn in self.schedule.chain(chain) {
            let record = self.record(turn, &mut carried);
            let is_last = record.is_err();
            if !hand(record) || is_last {
                return;
            }
        }
    }

    fn record(&self, turn: Turn, carried: &mut Option<Carried>) -> Result<RunRecord, Unmade> {
        let trace = self.traces.map(|keep| keep(turn.number)).transpose()?;
        let values = self.plan.values(turn.point);
        let outcome = self.run(turn, &values, carried, trace)?;
        Ok(RunRecord {
            run: turn.number,
            direction: turn.direction,
            values,
            outcome,
        })
    }

    /// The motion of a run by itself, from where the one before in its chain ended.
    fn model_of(
        &self,
        turn: Turn,
        values: &[f64],
        carried: Option<&Carried>,
    ) -> Result<Model, String> {
        let mut model = (self.model)(values)?;
        model.verify = self.verify_every > 0 && turn.number.is_multiple_of(self.verify_every);
        model.analyses.motion = MotionAnalysis::Kind;
        model.analyses.maps = false;
        if let Some(carried) = carried {
            carried.start(&mut model);
        }
        Ok(model)
    }

    /// The motion of one run, with the start that the runs before it in its chain lead to.
    ///
    /// # Errors
    /// [`Unmade`] where that was to stop; what is wrong with its values, in words.
    pub fn alone(&self, number: u64) -> Result<Result<Model, String>, Unmade> {
        let mut carried = None;
        let chain = self.schedule.chain(self.schedule.chain_of(number));
        let before = chain.take_while(|turn| turn.number < number);
        for turn in before.filter(|_| self.schedule.carries()) {
            let values = self.plan.values(turn.point);
            let _ = self.run(turn, &values, &mut carried, None)?;
        }
        let turn = self.schedule.turn(number);
        let values = self.plan.values(turn.point);
        Ok(self.model_of(turn, &values, carried.as_ref()))
    }

    fn run(
        &self,
        turn: Turn,
        values: &[f64],
        carried: &mut Option<Carried>,
        trace: Option<Box<dyn KeptTrace>>,
    ) -> Result<Result<Outcome, String>, Unmade> {
        let mut model = match self.model_of(turn, values, carried.as_ref()) {
            Ok(model) => model,
            Err(message) => return Ok(Err(message)),
        };
        self.keep.reduce(self.columns, &mut model);
        let mut sink = RunSink::new(&model, self.schedule.carries(), trace);
        let mut monitor = Monitor {
            stop: self.stop,
            progress: &mut |_| {},
        };
        match simulate(&model, &mut sink, &mut monitor) {
            Ok(run) => {
                let trace = sink.trace.take().map(KeptTrace::finish).transpose()?;
                *carried = sink.end.and_then(|end| end.carried(&model));
                Ok(Ok(self.outcome(&run, model.rotor.speed, trace)))
            }
            Err(SimulateError::Integrate(IntegrateError::Interrupted { .. })) => {
                Err(Unmade::Stopped)
            }
            Err(SimulateError::Sink(error)) => Err(Unmade::Trace(error)),
            Err(error) => Ok(Err(error.to_string())),
        }
    }

    fn outcome(&self, run: &Run, speed: f64, trace: Option<TraceSeal>) -> Outcome {
        let spectrum = run.spectrum.as_ref().zip(self.keep.highest_order);
        let points = run.motion.as_ref().zip(self.keep.section);
        let equilibrium = Some(&run.equilibrium).filter(|_| self.keep.bearing_stiffness);
        Outcome {
            numbers: self
                .columns
                .iter()
                .map(|column| column.in_run(run))
                .collect(),
            spectrum: spectrum.map_or_else(Vec::new, |(spectrum, order)| lines(spectrum, order)),
            peaks: spectrum.map_or_else(Vec::new, |(spectrum, _)| kept_peaks(&run.peaks, spectrum)),
            points: points.map_or_else(Vec::new, |(motion, section)| {
                section_points(motion, section)
            }),
            stiffness: equilibrium.map_or_else(Vec::new, |state| bearing_stiffness(state, speed)),
            trace,
            warnings: run.warnings.clone(),
            ..Outcome::default()
        }
    }
}

/// Amplitudes of the displacements up to an order; all of them where the shaft does not turn.
fn lines(spectrum: &Spectrum, highest: f64) -> Vec<Line> {
    let displacements: Vec<_> = spectrum
        .channels
        .iter()
        .filter(|entry| matches!(entry.channel, Channel::Displacement(_)))
        .collect();
    let shown = |k: &usize| spectrum.order(*k).is_none_or(|order| order <= highest);
    (1..spectrum.bins())
        .take_while(shown)
        .map(|k| Line {
            frequency: spectrum.frequency(k),
            order: spectrum.order(k),
            amplitudes: displacements
                .iter()
                .map(|entry| entry.amplitude[k])
                .collect(),
        })
        .collect()
}

/// Peaks of the displacements.
fn kept_peaks(peaks: &[Peak], spectrum: &Spectrum) -> Vec<KeptPeak> {
    let turns = spectrum.shaft_frequency > 0.0;
    let kept = peaks.iter();
    let kept = kept.filter(|peak| matches!(peak.channel, Channel::Displacement(_)));
    let kept = kept.map(|peak| KeptPeak {
        channel: peak.channel,
        frequency: peak.frequency,
        order: turns.then(|| peak.frequency / spectrum.shaft_frequency),
        amplitude: peak.amplitude,
        name: peak.line.map(|line| line.kind.to_string()),
    });
    kept.collect()
}

/// Of every bearing that has a stiffness of its own.
fn bearing_stiffness(equilibrium: &StaticState, speed: f64) -> Vec<BearingStiffness> {
    let bearings = (1..).zip(&equilibrium.bearings);
    let known = bearings.filter_map(|(number, bearing)| Some((number, bearing.as_ref()?)));
    known
        .map(|(bearing, state)| BearingStiffness {
            bearing,
            speed,
            stiffness: BearingStiffness::ENTRIES.map(|(_, entry)| state.stiffness[entry]),
            damping: BearingStiffness::ENTRIES.map(|(_, (row, column))| {
                match equilibrium.stiffness[row][column] {
                    0.0 => 0.0,
                    whole => {
                        equilibrium.damping[row][column] * state.stiffness[(row, column)] / whole
                    }
                }
            }),
        })
        .collect()
}

fn section_points(motion: &Motion, kind: SectionKind) -> Vec<Point> {
    let moving = motion
        .statistics
        .iter()
        .filter_map(|entry| match entry.channel {
            Channel::Displacement(axis) => Some(axis),
            _ => None,
        });
    let moving: Vec<usize> = moving.collect();
    let found = motion.sections.iter().find(|section| section.kind == kind);
    let points = found.map_or(&[][..], |section| &section.points);
    points
        .iter()
        .map(|point| Point {
            time: point.time,
            displacement: moving
                .iter()
                .map(|axis| point.displacement[*axis])
                .collect(),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::scenario;

    /// A number that is kept alone, with all left out that it does not rest on, is that of the whole run.
    #[test]
    fn every_number_asks_for_what_it_rests_on() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/fan-6205.toml");
        let scenario = scenario::load(&file).expect("a scenario");
        let mut model = scenario.model.expect("a motion");
        model.verify = false;
        model.analyses.motion = MotionAnalysis::Kind;
        model.analyses.maps = false;
        let stop = AtomicBool::new(false);
        let run = |model: &Model| {
            let mut sink = RunSink::new(model, false, None);
            let mut monitor = Monitor {
                stop: &stop,
                progress: &mut |_| {},
            };
            simulate(model, &mut sink, &mut monitor).expect("a run")
        };
        let whole = run(&model);
        let (mut found, columns) = (0, number_columns(&model.rotor));
        let one_of_a_kind = |column: &&NumberColumn| {
            !column.is_error() && column.order.is_none_or(|order| order == 1)
        };
        for column in columns.iter().filter(one_of_a_kind) {
            let mut alone = model.clone();
            Keep::default().reduce(std::slice::from_ref(column), &mut alone);
            let [expected, own] = [&whole, &run(&alone)].map(|run| column.in_run(run));
            // a run has the spectra of the forces of single bearings only where they are asked for
            let is_same = own == expected || expected.is_nan();
            assert!(is_same, "{}: {own} {expected}", column.column.name());
            found += u32::from(own.is_finite());
        }
        assert!(found > 60, "{found} of {}", columns.len());
    }
}
