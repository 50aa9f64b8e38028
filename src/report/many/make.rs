//! Makes the runs of a study, or of a part of it, and writes their files.

use std::collections::BTreeSet;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use super::rows::{RowFile, Rows, StudyHead};
use super::traces::{self, Traces};
use super::{Digest, StudyError, write};
use crate::analysis::Channel;
use crate::quasi_static::StaticQuestion;
use crate::report::{FileSet, RunFolder};
use crate::rotor::RotorDefinition;
use crate::scenario::StudyFile;
use crate::simulate::Model;
use crate::study::many::{Ask, Direction, Maker, RunRecord, Schedule, Shard, Unmade, work};

/// A checked study whose first run can be made.
#[derive(Debug)]
pub struct StudyRuns<'a> {
    study: &'a StudyFile,
    /// Its runs and in which order they are made.
    pub schedule: Schedule,
    /// What its first run is asked.
    pub first: Asked,
}

/// What a run of a study is asked.
#[derive(Debug)]
pub enum Asked {
    /// How the shaft moves.
    Motion(Box<Model>),
    /// Where the shaft stands.
    Standing(Box<StaticQuestion>),
}

impl Asked {
    fn rotor(&self) -> &RotorDefinition {
        match self {
            Self::Motion(model) => &model.rotor,
            Self::Standing(question) => &question.rotor,
        }
    }
}

/// Which runs are made, where, and on how many threads.
#[derive(Debug, Clone, Copy)]
pub struct Making<'a> {
    /// Folder of the files.
    pub folder: &'a Path,
    /// The part that is made.
    pub shard: Shard,
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

impl<'a> StudyRuns<'a> {
    /// The runs of a study.
    ///
    /// # Errors
    /// [`StudyError::First`] where its first values make no scenario.
    pub fn new(study: &'a StudyFile) -> Result<Self, StudyError> {
        let plan = &study.plan;
        let points = plan.runs().unwrap_or(u64::MAX);
        let last = plan.axes.last().map_or(1, |axis| axis.length());
        let values = plan.values(0);
        let first = match study.ask {
            Ask::Run => study
                .model(&values)
                .map(|model| Asked::Motion(model.into())),
            Ask::Bearing => study
                .question(&values)
                .map(|question| Asked::Standing(question.into())),
        };
        Ok(Self {
            study,
            schedule: Schedule::new(points, last, study.sweep),
            first: first.map_err(|error| StudyError::First(error.message))?,
        })
    }

    /// Number of runs of some chains.
    pub(crate) fn runs_of(&self, chains: Range<u64>) -> u64 {
        let runs = self.schedule.runs_of(chains);
        runs.end - runs.start
    }

    /// What the rows of a part begin with.
    fn head(&self, shard: Shard) -> StudyHead {
        let study = self.study;
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
            swept: study.sweep.is_some(),
        }
    }

    /// Opens the folder and the rows of a part, behind those that an earlier attempt has kept.
    ///
    /// # Errors
    /// [`StudyError`] where the folder cannot be written, or holds runs of another study.
    pub(crate) fn open(&self, making: &Making<'_>) -> Result<(RunFolder, RowFile), StudyError> {
        let shard = making.shard;
        let (folder, name) = match shard {
            Shard::WHOLE => {
                let folder = RunFolder::open(making.folder, FileSet::RUNS)?;
                (folder, "runs.jsonl".to_owned())
            }
            Shard { number, count } => {
                let folder = RunFolder::open_for_part(making.folder, FileSet::RUNS)?;
                (folder, format!("runs.part-{number}-of-{count}.jsonl"))
            }
        };
        let rows = RowFile::open(&folder.path().join(name), self.head(shard), making.anew)?;
        let (own, all) = (&rows.head.runs, self.schedule.runs());
        let has_traces = traces::stand(folder.path())? || self.study.keep.traces;
        traces::remove_unfinished(folder.path(), own, all)?;
        if has_traces && rows.count == 0 {
            // traces are put in place one by one: what sealed those of an earlier study goes before them
            folder.unseal()?;
            traces::remove_stale(folder.path(), own, all)?;
        }
        Ok((folder, rows))
    }

    /// Makes the runs of one part, behind those that an earlier attempt has kept, and writes its files; returns their
    /// paths and, of a whole study, its digest.
    ///
    /// # Errors
    /// [`StudyError`].
    pub fn make(
        &self,
        making: &Making<'_>,
        watch: &mut StudyWatch<'_>,
    ) -> Result<(Vec<PathBuf>, Option<Digest>), StudyError> {
        let Shard { number, count } = making.shard;
        let most = self.schedule.chains();
        if count > most.max(1) {
            return Err(StudyError::NoPart {
                number,
                count,
                most,
            });
        }
        let (folder, mut rows) = self.open(making)?;
        if rows.count > 0 {
            (watch.resumed)(rows.count);
        }
        self.add_missing(&mut rows, making, watch)?;
        let rows = Rows::of_one(rows);
        if making.shard != Shard::WHOLE {
            traces::sync(folder.path(), &rows)?;
            return Ok((rows.synced()?, None));
        }
        let (paths, digest) = write(folder, &rows)?;
        Ok((paths, Some(digest)))
    }

    /// Makes the runs of a part that have no row, and adds their rows.
    fn add_missing(
        &self,
        rows: &mut RowFile,
        making: &Making<'_>,
        watch: &mut StudyWatch<'_>,
    ) -> Result<(), StudyError> {
        let (study, schedule) = (self.study, self.schedule);
        let chains = making.shard.chains(&schedule);
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
        let all = self.runs_of(chains.clone()) as f64;
        work(
            chains.filter(|chain| !done.contains(chain)),
            making.threads,
            watch.stop,
            |chain, hand| match study.ask {
                Ask::Run => maker.chain(chain, hand),
                Ask::Bearing => {
                    hand(Ok(self.stood(chain)));
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
    fn stood(&self, run: u64) -> RunRecord {
        let values = self.study.plan.values(run);
        RunRecord {
            run,
            direction: Direction::Alone,
            outcome: self.study.standing(&values),
            values,
        }
    }
}
