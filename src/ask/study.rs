//! Many runs of one scenario.

use std::collections::BTreeSet;
use std::io;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::AskError;
use crate::analysis::Channel;
use crate::quasi_static::StaticQuestion;
use crate::report::WrittenFindings;
use crate::report::many::{self, RowFile, StudyError, StudyHead, Traces};
use crate::rotor::RotorDefinition;
use crate::scenario::{Issue, Scenario, StudyFile};
use crate::simulate::Model;
use crate::study::many::{Ask, Direction, Maker, RunRecord, Schedule, Shard, Unmade, work};

/// The runs of a study, or of a part of it.
#[derive(Debug)]
pub struct StudyQuestion<'a> {
    study: &'a StudyFile,
    shard: Shard,
    /// All its runs and in which order they are made.
    pub schedule: Schedule,
    /// What its first run is asked.
    pub first: Asked,
}

/// What a run of a study is asked.
#[derive(Debug)]
pub enum Asked {
    /// How the shaft moves.
    Motion(Box<Model>),
    /// Where the shaft rests.
    Static(Box<StaticQuestion>),
}

impl Asked {
    fn rotor(&self) -> &RotorDefinition {
        match self {
            Self::Motion(model) => &model.rotor,
            Self::Static(question) => &question.rotor,
        }
    }
}

/// Where the runs are made, and on how many threads.
#[derive(Debug, Clone, Copy)]
pub struct Making<'a> {
    /// Folder of the files.
    pub folder: &'a Path,
    /// Number of threads.
    pub threads: usize,
    /// Whether to begin anew, whatever runs an earlier attempt has kept.
    pub anew: bool,
}

/// How a study is watched and stopped from outside.
pub struct StudyWatch<'a> {
    /// Set to end it; the runs that are done are kept.
    pub stop: &'a AtomicBool,
    /// Called with the number of runs that an earlier attempt has kept, where there are any.
    pub resumed: &'a mut dyn FnMut(u64),
    /// Called with the part that is done, 0 … 1.
    pub progress: &'a mut dyn FnMut(f64),
}

impl From<StudyError> for AskError {
    fn from(error: StudyError) -> Self {
        match error.is_wrong_input() {
            true => Self::Asked(Issue::new("", error.to_string())),
            false => Self::failed(error),
        }
    }
}

/// Puts the parts of a study together, in their folder: to the bytes of the study made in one piece.
///
/// # Errors
/// [`AskError::Asked`] where a part is missing, broken or of another study, [`AskError::Failed`] where a file cannot be
/// written.
pub fn merge(folder: &Path) -> Result<WrittenFindings, AskError> {
    Ok(many::merge(folder)?)
}

impl<'a> StudyQuestion<'a> {
    /// Asks for the runs of a part of a study.
    ///
    /// # Errors
    /// [`AskError::Asked`] where its first values make no scenario, or where it has fewer parts.
    pub fn new(study: &'a StudyFile, shard: Shard) -> Result<Self, AskError> {
        let plan = &study.plan;
        let points = plan.runs().unwrap_or(u64::MAX);
        let last = plan.axes.last().map_or(1, |axis| axis.length());
        let schedule = Schedule::new(points, last, study.sweep);
        let (Shard { number, count }, most) = (shard, schedule.chains());
        if count > most.max(1) {
            let message = format!(
                "there is no part {number} of {count}: the study can be divided into at most {most} parts"
            );
            return Err(Issue::new("", message).into());
        }
        let values = plan.values(0);
        let first = match study.ask {
            Ask::Run => study
                .model(&values)
                .map(|model| Asked::Motion(model.into())),
            Ask::Bearing => study
                .question(&values)
                .map(|question| Asked::Static(question.into())),
        };
        let first = first.map_err(|issue| Issue {
            message: format!(
                "the first point of the study is no scenario: {}",
                issue.message
            ),
            ..issue
        });
        Ok(Self {
            study,
            shard,
            schedule,
            first: first?,
        })
    }

    /// Number of runs of the part.
    pub fn runs(&self) -> u64 {
        let runs = self.schedule.runs_of(self.shard.chains(&self.schedule));
        runs.end - runs.start
    }

    /// What the rows of the part begin with.
    pub(crate) fn head(&self) -> StudyHead {
        let (study, shard) = (self.study, self.shard);
        let moving = self.first.rotor().shaft.freedoms.axes().iter();
        let displacements = moving.map(|axis| Channel::Displacement(*axis));
        let [asked, base] = ["study", "base"].map(|key| study.echo[key].clone());
        StudyHead {
            jeffcott: env!("CARGO_PKG_VERSION").to_owned(),
            title: study.title.clone(),
            named: serde_json::from_value(asked["keep"]["numbers"].clone()).ok(),
            study: asked,
            base,
            ask: study.ask,
            shard,
            runs: self.schedule.runs_of(shard.chains(&self.schedule)),
            axes: study.variables.clone(),
            numbers: study.columns.iter().map(|own| own.column.clone()).collect(),
            displacements: displacements.collect(),
            keep: study.keep,
            drawn: study.plan.is_drawn(),
        }
    }

    /// Makes the runs of the part, behind those that an earlier attempt has kept, and writes its files.
    ///
    /// # Errors
    /// [`AskError::Asked`] where the folder holds runs of another study, [`AskError::Failed`] where a file cannot be written
    /// or the study is stopped.
    pub fn answer(
        &self,
        making: &Making<'_>,
        watch: &mut StudyWatch<'_>,
    ) -> Result<WrittenFindings, AskError> {
        let (folder, runs) = (making.folder, self.schedule.runs());
        let (folder, mut rows) = many::open(folder, self.head(), runs, making.anew)?;
        if rows.count > 0 {
            (watch.resumed)(rows.count);
        }
        self.add_missing(&mut rows, making, watch)?;
        Ok(many::finish(folder, rows)?)
    }

    /// Makes the runs of the part that have no row, and adds their rows.
    fn add_missing(
        &self,
        rows: &mut RowFile,
        making: &Making<'_>,
        watch: &mut StudyWatch<'_>,
    ) -> Result<(), StudyError> {
        let (study, schedule) = (self.study, self.schedule);
        let chains = self.shard.chains(&schedule);
        let is_done = |chain: &u64| {
            let mut runs = schedule.runs_of(*chain..chain + 1);
            runs.all(|run| rows.holds(run))
        };
        let done: BTreeSet<u64> = chains.clone().filter(is_done).collect();
        let channels = || Channel::of_trace_in(&study.echo["base"], self.first.rotor());
        let traces = study
            .keep
            .traces
            .then(|| Traces::open(making.folder, channels()));
        let traces = traces.transpose()?;
        let keep = |run| match &traces {
            Some(traces) => traces.begin(run),
            None => Err(io::ErrorKind::Unsupported.into()),
        };
        let model = |values: &[f64]| study.model(values).map_err(|error| error.message);
        let maker = Maker {
            traces: traces.is_some().then_some(&keep),
            ..study.maker(schedule, &model, watch.stop)
        };
        let all = self.runs() as f64;
        work(
            chains.filter(|chain| !done.contains(chain)),
            making.threads,
            watch.stop,
            |chain, hand| match study.ask {
                Ask::Run => maker.chain(chain, hand),
                Ask::Bearing => {
                    hand(Ok(self.static_row(chain)));
                }
            },
            |row| -> Result<(), StudyError> {
                match row {
                    // it is made again when the study goes on
                    Err(Unmade::Stopped) => return Ok(()),
                    row => rows.add(&row?)?,
                }
                (watch.progress)(rows.count as f64 / all);
                Ok(())
            },
        )?;
        match rows.missing() {
            0 => Ok(()),
            _ => Err(Unmade::Stopped.into()),
        }
    }

    /// The row of a static question.
    fn static_row(&self, run: u64) -> RunRecord {
        let values = self.study.plan.values(run);
        RunRecord {
            run,
            direction: Direction::Alone,
            outcome: self.study.static_outcome(&values),
            values,
        }
    }

    /// The scenario of one run by itself, called by its number; its motion starts where the runs before it in its chain lead
    /// to.
    ///
    /// # Errors
    /// [`AskError::Asked`] where there is no such run, [`AskError::Failed`] where its values make no scenario, or those runs
    /// are stopped.
    pub fn alone(&self, number: u64, stop: &AtomicBool) -> Result<Scenario, AskError> {
        let (study, schedule) = (self.study, self.schedule);
        let last = schedule.runs().saturating_sub(1);
        if number > last {
            let message = format!("there is no run {number}: they count from 0 to {last}");
            return Err(Issue::new("", message).into());
        }
        let no_run = |message| AskError::Failed(format!("run {number}: {message}").into());
        let values = study.plan.values(schedule.turn(number).point);
        let title = format!("{}, run {number}", study.title);
        let alone = study.alone(&values, title);
        let mut alone = alone.map_err(|issue| no_run(issue.message))?;
        if alone.model.is_some() {
            let model = |values: &[f64]| study.model(values).map_err(|error| error.message);
            let found = study.maker(schedule, &model, stop).alone(number);
            alone.model = Some(found.map_err(AskError::failed)?.map_err(no_run)?);
        }
        Ok(alone)
    }
}
