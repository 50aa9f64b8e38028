//! The rows of a study: a file to whose end they are added as they come, so that a killed study goes on behind them.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufRead, BufReader, Seek, SeekFrom, Write};
use std::num::NonZeroU64;
use std::ops::Range;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde_json::json;

use super::StudyError;
use super::head::StudyHead;
use crate::record::open_regular;
use crate::report::folder::locked;
use crate::report::{FileAction, ReportError};
use crate::study::many::{RunRecord, Shard};

/// Most missing parts that are named.
const MOST_NAMED: usize = 20;

/// A file of rows.
#[derive(Debug)]
pub(crate) struct RowFile {
    file: File,
    path: PathBuf,
    pub head: StudyHead,
    /// Where the row of each run begins, from the first run of the part on.
    places: Vec<Option<NonZeroU64>>,
    /// Number of rows.
    pub count: u64,
    /// Where the last whole row ends.
    end: u64,
}

impl RowFile {
    /// Goes on with the rows of the same study, if the file has them, or else begins one for them; a last row that a
    /// kill has cut off is dropped. `anew` throws away what the file has.
    pub fn open(path: &Path, head: StudyHead, anew: bool) -> Result<Self, StudyError> {
        let mut rows = Self::new(alone(path)?, path, head);
        let mut reader = rows.reader(0)?;
        let mut first = String::new();
        let read = reader.read_line(&mut first);
        let begin = json!(rows.head).to_string() + "\n";
        // a full disk may have cut off the head
        if anew || (read.is_ok() && first.len() < begin.len() && begin.starts_with(&first)) {
            rows.file
                .set_len(0)
                .map_err(ReportError::file(FileAction::Write, path))?;
            rows.append(&begin)?;
            return Ok(rows);
        }
        let there: StudyHead = parsed(&first).ok_or_else(|| StudyError::NoRows(path.into()))?;
        if let Some([key, there, here]) = there.difference(&rows.head) {
            let path = path.to_owned();
            return Err(StudyError::Other {
                path,
                key,
                there,
                here,
            });
        }
        rows.take_whole(reader, first.len());
        rows.file
            .set_len(rows.end)
            .map_err(ReportError::file(FileAction::Write, path))?;
        Ok(rows)
    }

    /// Reads the rows of a part.
    fn read(path: &Path) -> Result<Self, StudyError> {
        let broken = |reason: String| StudyError::Broken {
            path: path.to_owned(),
            reason,
        };
        let opened = open_regular(path, u64::MAX);
        let opened = opened.and_then(|file| Ok((file.try_clone()?, file.metadata()?.len(), file)));
        let (reader, bytes, file) = opened.map_err(|error| broken(error.to_string()))?;
        let mut reader = BufReader::new(reader);
        let mut first = String::new();
        let _ = reader.read_line(&mut first);
        let head = parsed(&first).ok_or_else(|| broken("it does not begin as one".to_owned()))?;
        let mut rows = Self::new(file, path, head);
        // room is made for every run of the part, each of which has a row
        if rows.missing() > bytes {
            let runs = rows.missing();
            return Err(broken(format!("{bytes} bytes cannot hold {runs} runs")));
        }
        rows.take_whole(reader, first.len());
        match rows.missing() {
            0 => Ok(rows),
            missing => Err(broken(format!("{missing} of its runs are missing"))),
        }
    }

    fn new(file: File, path: &Path, head: StudyHead) -> Self {
        Self {
            file,
            path: path.to_owned(),
            head,
            places: Vec::new(),
            count: 0,
            end: 0,
        }
    }

    /// Number of runs of the part that have no row.
    pub fn missing(&self) -> u64 {
        let Range { start, end } = self.head.runs;
        end.saturating_sub(start).saturating_sub(self.count)
    }

    /// Notes all rows behind the head, up to the first that is not whole.
    fn take_whole(&mut self, mut reader: impl BufRead, head: usize) {
        self.end = head as u64;
        let mut line = String::new();
        while let Ok(length @ 1..) = reader.read_line(&mut line) {
            let Some(row) = parsed(&line).filter(|row| self.head.owns(row)) else {
                return;
            };
            self.note(row.run, length);
            line.clear();
        }
    }

    fn note(&mut self, run: u64, length: usize) {
        let place = (run - self.head.runs.start) as usize;
        self.places.resize(self.places.len().max(place + 1), None);
        if self.places[place].is_none() {
            self.places[place] = NonZeroU64::new(self.end);
            self.count += 1;
        }
        self.end += length as u64;
    }

    /// Whether the row of a run is there.
    pub fn holds(&self, run: u64) -> bool {
        self.place(run).is_some()
    }

    fn place(&self, run: u64) -> Option<u64> {
        let place = run.checked_sub(self.head.runs.start)?;
        self.places.get(place as usize)?.map(NonZeroU64::get)
    }

    /// Adds the row of a run; one that is there already stays.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be written: the rows then end before it.
    pub fn add(&mut self, row: &RunRecord) -> Result<(), ReportError> {
        if self.holds(row.run) || !self.head.owns(row) {
            return Ok(());
        }
        let line = json_line(row);
        let start = self.end;
        self.append(&line)?;
        self.end = start;
        self.note(row.run, line.len());
        Ok(())
    }

    fn append(&mut self, line: &str) -> Result<(), ReportError> {
        self.file
            .seek(SeekFrom::Start(self.end))
            .and_then(|_| self.file.write_all(line.as_bytes()))
            .map_err(ReportError::file(FileAction::Write, &self.path))?;
        self.end += line.len() as u64;
        Ok(())
    }

    /// A reader of the file from a place on, by the handle that locks it.
    fn reader(&self, place: u64) -> Result<BufReader<File>, ReportError> {
        let reader = self.file.try_clone().and_then(|mut file| {
            file.seek(SeekFrom::Start(place))?;
            Ok(BufReader::with_capacity(1 << 16, file))
        });
        reader.map_err(ReportError::file(FileAction::Read, &self.path))
    }

    /// The rows of some runs, as far as they are there, in the order of the runs.
    fn rows(
        &self,
        runs: impl Iterator<Item = u64>,
    ) -> Result<impl Iterator<Item = Result<RunRecord, ReportError>>, ReportError> {
        let mut reader = self.reader(self.end)?;
        let mut at = self.end;
        let mut line = String::new();
        let rows = runs.filter_map(|run| self.place(run)).map(move |place| {
            line.clear();
            let read = reader
                .seek_relative(place as i64 - at as i64)
                .and_then(|()| reader.read_line(&mut line));
            at = place + line.len() as u64;
            let row = read.and_then(|_| parsed(&line).ok_or(io::ErrorKind::InvalidData.into()));
            row.map_err(ReportError::file(FileAction::Read, &self.path))
        });
        Ok(rows)
    }
}

fn parsed<'a, T: Deserialize<'a>>(line: &'a str) -> Option<T> {
    serde_json::from_str(line.strip_suffix('\n')?).ok()
}

fn json_line(row: &RunRecord) -> String {
    serde_json::to_string(row).expect("the keys of rows are texts") + "\n"
}

/// Opens the file for this process alone.
fn alone(path: &Path) -> Result<File, StudyError> {
    // a link is not followed, and a device or a pipe may never end
    if fs::symlink_metadata(path).is_ok_and(|known| !known.is_file()) {
        return Err(StudyError::NoRows(path.to_owned()));
    }
    let file = OpenOptions::new()
        .read(true)
        .write(true)
        .create(true)
        .truncate(false)
        .open(path)
        .map_err(ReportError::file(FileAction::Create, path))?;
    Ok(locked(file, path, File::try_lock)?)
}

/// All rows of a study: those of its parts, one after the other.
#[derive(Debug)]
pub(crate) struct Rows(Vec<RowFile>);

impl Rows {
    /// The rows of one file.
    pub fn from_one(rows: RowFile) -> Self {
        Self(vec![rows])
    }

    /// The rows of all parts in a folder, if they are one whole.
    ///
    /// # Errors
    /// [`StudyError`] where a part is missing, not whole, or of another study.
    pub fn from_parts(folder: &Path) -> Result<Self, StudyError> {
        let entries = fs::read_dir(folder).map_err(ReportError::file(FileAction::Read, folder))?;
        let paths = entries.flatten().map(|entry| entry.path());
        let parts = paths.filter(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with("runs.part-") && name.ends_with(".jsonl")
        });
        let parts = parts.map(|path| RowFile::read(&path));
        let mut parts: Vec<RowFile> = parts.collect::<Result<_, _>>()?;
        parts.sort_by_key(|part| (part.head.shard.count, part.head.shard.number));
        parts.dedup_by_key(|part| part.head.shard);
        let Some(first) = parts.first() else {
            return Err(StudyError::NoParts(folder.to_owned()));
        };
        for part in &parts {
            let whole = |head: &StudyHead| StudyHead {
                shard: Shard {
                    number: 1,
                    ..head.shard
                },
                runs: 0..0,
                ..head.clone()
            };
            if let Some([key, there, here]) = whole(&first.head).difference(&whole(&part.head)) {
                return Err(StudyError::Different {
                    a: first.path.clone(),
                    b: part.path.clone(),
                    key,
                    there,
                    here,
                });
            }
        }
        let count = first.head.shard.count;
        let there = |number: &u64| parts.iter().any(|part| part.head.shard.number == *number);
        let missing = count.saturating_sub(parts.len() as u64);
        let numbers = (1..=count).filter(|number| !there(number));
        match numbers.take(MOST_NAMED).collect::<Vec<_>>() {
            none if none.is_empty() => Ok(Self(parts)),
            first => Err(StudyError::Missing {
                missing,
                first,
                count,
            }),
        }
    }

    /// Sees that they outlive a loss of power; returns the paths of their files.
    pub fn synced(&self) -> Result<Vec<PathBuf>, ReportError> {
        let synced = self.0.iter().map(|part| {
            let synced = part.file.sync_data();
            synced.map_err(ReportError::file(FileAction::Sync, &part.path))?;
            Ok(part.path.clone())
        });
        synced.collect()
    }

    /// What they are rows of.
    pub fn head(&self) -> &StudyHead {
        &self.0[0].head
    }

    /// Shows every row, in the order of the runs.
    pub fn each<E: From<ReportError>>(
        &self,
        mut show: impl FnMut(RunRecord) -> Result<(), E>,
    ) -> Result<(), E> {
        for part in &self.0 {
            for row in part.rows(part.head.runs.clone())? {
                show(row?)?;
            }
        }
        Ok(())
    }

    /// Shows the rows of some runs, which rise.
    pub fn each_of(
        &self,
        runs: impl Iterator<Item = u64> + Clone,
        mut show: impl FnMut(RunRecord),
    ) -> Result<(), ReportError> {
        for part in &self.0 {
            for row in part.rows(runs.clone())? {
                show(row?);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::many::{Direction, Outcome};

    fn row(run: u64) -> RunRecord {
        let numbers = vec![[f64::NAN, 0.1 + 0.2, f64::INFINITY][run as usize % 3]];
        RunRecord {
            run,
            direction: Direction::Alone,
            values: Vec::new(),
            outcome: Ok(Outcome {
                numbers,
                ..Outcome::default()
            }),
        }
    }

    fn open(path: &Path) -> RowFile {
        RowFile::open(path, StudyHead::of_tests(), false).unwrap()
    }

    fn runs(rows: RowFile) -> Vec<u64> {
        let mut runs = Vec::new();
        let shown = Rows::from_one(rows).each(|found| {
            assert_eq!(format!("{found:?}"), format!("{:?}", row(found.run)));
            runs.push(found.run);
            Ok::<_, ReportError>(())
        });
        shown.unwrap();
        runs
    }

    #[test]
    fn rows_added_in_any_order_are_shown_in_that_of_the_runs() {
        let folder = tempfile::tempdir().unwrap();
        let mut rows = open(&folder.path().join("runs.jsonl"));
        for run in [5, 3, 12, 4, 3, 13] {
            rows.add(&row(run)).unwrap();
        }
        assert_eq!((rows.count, rows.missing()), (4, 6));
        assert_eq!(runs(rows), [3, 4, 5, 12]);
    }

    #[test]
    fn a_file_that_ends_anywhere_is_gone_on_with() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.jsonl");
        let mut rows = open(&path);
        let head = rows.end as usize;
        rows.add(&row(4)).unwrap();
        rows.add(&row(3)).unwrap();
        drop(rows);
        let whole = fs::read(&path).unwrap();
        for length in 0..whole.len() {
            fs::write(&path, &whole[..length]).unwrap();
            let mut rows = open(&path);
            assert!(!rows.holds(3) && (length > head || !rows.holds(4)));
            rows.add(&row(4)).unwrap();
            rows.add(&row(3)).unwrap();
            drop(rows);
            assert!(fs::read(&path).unwrap() == whole, "{length} bytes");
        }
    }

    #[test]
    fn the_rows_of_another_study_are_refused_by_what_differs() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.jsonl");
        drop(open(&path));
        let mut other = StudyHead::of_tests();
        other.study = json!({ "seed": 2 });
        let error = RowFile::open(&path, other, false).unwrap_err();
        let reported = error.to_string();
        assert!(
            reported.contains("`study.seed` was 1 there and is 2 now"),
            "{reported}"
        );
    }

    #[test]
    fn parts_that_cannot_be_whole_take_no_room() {
        let folder = tempfile::tempdir().unwrap();
        let part = Shard {
            number: 1,
            count: u64::MAX,
        };
        for (shard, runs, last, reported) in [
            (Shard::WHOLE, 0..u64::MAX, u64::MAX - 1, "cannot hold"),
            (part, 0..1, 0, "parts are missing: 2, 3, "),
        ] {
            let head = StudyHead {
                shard,
                runs,
                ..StudyHead::of_tests()
            };
            let text = json!(head).to_string() + "\n" + &json_line(&row(last));
            fs::write(folder.path().join("runs.part-1-of-1.jsonl"), text).unwrap();
            let error = Rows::from_parts(folder.path()).unwrap_err().to_string();
            assert!(error.contains(reported), "{error}");
        }
    }

    #[test]
    fn one_process_at_a_time_has_the_rows() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.jsonl");
        let mut rows = open(&path);
        rows.add(&row(3)).unwrap();
        for anew in [false, true] {
            let error = RowFile::open(&path, StudyHead::of_tests(), anew).unwrap_err();
            assert!(error.to_string().contains("another process"), "{error}");
        }
        assert_eq!(runs(rows), [3]);
    }
}
