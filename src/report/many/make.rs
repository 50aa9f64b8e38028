//! Makes the runs of a study, or of a part of it, and writes their files.

use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use super::{Digest, JournalError, StudyReport, Traces};
use crate::analysis::Channel;
use crate::report::ReportError;
use crate::scenario::StudyFile;
use crate::simulate::Model;
use crate::study::many::{Maker, Schedule, Shard, Unmade, work};

/// Why a study did not come to its end, in words.
#[derive(Debug, thiserror::Error)]
pub enum MakeError {
    /// Nothing can be made of its first values.
    #[error("the first point of the study is no scenario: {0}")]
    First(String),
    /// The runs that an earlier attempt has kept cannot be gone on from.
    #[error(transparent)]
    Journal(#[from] JournalError),
    /// A file cannot be written or drawn.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// The study has fewer parts.
    #[error(
        "there is no part {number} of {count}: the study can be divided into at most {most} parts"
    )]
    NoPart {
        /// The part that was asked for.
        number: u64,
        /// Of how many.
        count: u64,
        /// How many there can be.
        most: u64,
    },
    /// It was to stop, or the trace of a run cannot be kept.
    #[error(transparent)]
    Unmade(#[from] Unmade),
}

/// A checked study whose first run can be made.
#[derive(Debug)]
pub struct StudyRuns<'a> {
    pub(super) study: &'a StudyFile,
    /// Its runs and in which order they are made.
    pub schedule: Schedule,
    /// The motion of its first run.
    pub first: Model,
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
    /// [`MakeError::First`] where its first values make no scenario.
    pub fn new(study: &'a StudyFile) -> Result<Self, MakeError> {
        let plan = &study.plan;
        let points = plan.runs().unwrap_or(u64::MAX);
        let last = plan.axes.last().map_or(1, |axis| axis.length());
        let first = study.model(&plan.values(0));
        Ok(Self {
            study,
            schedule: Schedule::new(points, last, study.sweep),
            first: first.map_err(|error| MakeError::First(error.message))?,
        })
    }

    /// Number of runs of some chains.
    pub(crate) fn runs_of(&self, chains: Range<u64>) -> u64 {
        let runs = self.schedule.runs_of(chains);
        runs.end - runs.start
    }

    /// Makes the runs of one part, from those on that an earlier attempt has kept, and writes its files; returns their
    /// paths and, of a whole study, its digest.
    ///
    /// # Errors
    /// [`MakeError`].
    pub fn make(
        &self,
        making: &Making<'_>,
        watch: &mut StudyWatch<'_>,
    ) -> Result<(Vec<PathBuf>, Option<Digest>), MakeError> {
        let (study, shard) = (self.study, making.shard);
        let most = self.schedule.chains();
        if shard.count > most.max(1) {
            let Shard { number, count } = shard;
            return Err(MakeError::NoPart {
                number,
                count,
                most,
            });
        }
        let mut report = StudyReport::open(self, making)?;
        let chains = shard.chains(&self.schedule);
        let count = chains.end - chains.start;
        let kept = report.journal.done.clone();
        let is_done = |chain: &u64| kept.holds(*chain);
        let mut done = chains.clone().filter(is_done).count() as u64;
        if done > 0 {
            let runs = chains.clone().filter(is_done);
            (watch.resumed)(runs.map(|chain| self.runs_of(chain..chain + 1)).sum());
        }
        let channels = || Channel::of_trace_in(&study.echo["base"], &self.first.rotor);
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
            ..study.maker(self.schedule, &model, watch.stop)
        };
        work(
            chains.filter(|chain| !is_done(chain)),
            making.threads,
            watch.stop,
            |chain| maker.chain(chain),
            |chain, records| -> Result<(), MakeError> {
                let records = match records {
                    Ok(records) => records,
                    // it is made again when the study goes on
                    Err(Unmade::Stopped) => return Ok(()),
                    Err(unmade) => return Err(unmade.into()),
                };
                report.add(chain, &records)?;
                done += 1;
                (watch.progress)(done as f64 / count as f64);
                Ok(())
            },
        )?;
        if done < count {
            return Err(Unmade::Stopped.into());
        }
        Ok(report.finish()?)
    }
}
