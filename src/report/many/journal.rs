//! What is done of a study, kept as it is done, so that a killed study goes on from there.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde_json::{Value, json};

use super::identity::first_difference;
use crate::report::checksum::Checksum;
use crate::report::{FileAction, ReportError};

/// Version of the form: a line that says whose journal it is, then a line a task.
const FORM: u32 = 4;

/// The first line.
#[derive(Debug, Deserialize)]
struct Head {
    journal: u32,
    /// All that tells its study from others.
    identity: Value,
    /// Number of the first task.
    first: u64,
}

/// Tasks of a study that are done.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Done {
    /// All tasks from the first one up to here, this one left out.
    pub below: u64,
    /// Those after it.
    pub beyond: BTreeSet<u64>,
}

impl Done {
    /// None, of tasks that count from `first` on.
    pub fn none(first: u64) -> Self {
        Self {
            below: first,
            beyond: BTreeSet::new(),
        }
    }

    /// Whether a task is done.
    pub fn holds(&self, task: u64) -> bool {
        task < self.below || self.beyond.contains(&task)
    }

    /// Notes a task; false where it was noted before.
    pub fn add(&mut self, task: u64) -> bool {
        if self.holds(task) {
            return false;
        }
        self.beyond.insert(task);
        while self.beyond.remove(&self.below) {
            self.below += 1;
        }
        true
    }
}

/// Why a journal cannot be gone on with.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// It belongs to other runs.
    #[error(
        "{} holds runs of another study: `{key}` was {there} there and is {here} now; undo the change, or \
         begin anew with --restart",
        path.display()
    )]
    Other {
        /// Path of the journal.
        path: PathBuf,
        /// What differs.
        key: String,
        /// There.
        there: String,
        /// Here.
        here: String,
    },
    /// It is none.
    #[error("{} is no journal of a study; remove it, or begin anew with --restart", path.display())]
    Unreadable {
        /// Path of the file.
        path: PathBuf,
    },
    /// Another process is at it.
    #[error(
        "another process is making these runs: it holds {}; wait for its end, or write to another folder by \
         --out",
        path.display()
    )]
    Busy {
        /// Path of the journal.
        path: PathBuf,
    },
    /// The file system refused.
    #[error(transparent)]
    Report(#[from] ReportError),
}

/// A journal that is being written.
#[derive(Debug)]
pub struct Journal {
    file: File,
    /// Its path.
    pub(super) path: PathBuf,
    /// Tasks that are done.
    pub(super) done: Done,
    first: u64,
}

impl Journal {
    /// Goes on with the journal of the same study, if one stands there, or else begins one whose tasks count
    /// from `first` on; what was written last before a kill and is not whole is dropped. `identity` tells
    /// its study from others; `anew` throws away what stands there.
    pub(super) fn open(
        path: &Path,
        identity: &Value,
        first: u64,
        anew: bool,
    ) -> Result<Self, JournalError> {
        let refused = |action| ReportError::file(action, path);
        let mut file = alone(path)?;
        let head = head(identity, first);
        let mut done = Done::none(first);
        let mut whole = head.len() as u64;
        if anew || !is_begun(&file, head.as_bytes()).map_err(refused(FileAction::Read))? {
            file.set_len(0)
                .and_then(|()| file.rewind())
                .and_then(|()| file.write_all(head.as_bytes()))
                .map_err(refused(FileAction::Write))?;
        } else {
            let mut entries = Entries::of(&file, path)?;
            entries.check(identity, first, path)?;
            while let Some((task, _)) = entries.next_entry() {
                done.add(task);
            }
            whole = entries.whole;
        }
        file.set_len(whole)
            .and_then(|()| file.seek(SeekFrom::End(0)))
            .map_err(refused(FileAction::Write))?;
        Ok(Self {
            file,
            path: path.to_owned(),
            done,
            first,
        })
    }

    /// Removes the file: what it held stands elsewhere.
    pub(super) fn remove(self) -> Result<(), ReportError> {
        fs::remove_file(&self.path).map_err(ReportError::file(FileAction::Remove, &self.path))
    }

    /// Notes a task with its content, a single line; one that is noted already is left as it was.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be written: the journal then ends before it.
    pub fn add(&mut self, task: u64, content: &str) -> Result<(), ReportError> {
        if self.done.holds(task) {
            return Ok(());
        }
        let entry = format!("{task} {content}");
        let line = format!("{:016x} {entry}\n", Checksum::of(&entry));
        // in one piece: what a full disk cuts off is found by its checksum
        self.file
            .write_all(line.as_bytes())
            .map_err(ReportError::file(FileAction::Write, &self.path))?;
        self.done.add(task);
        Ok(())
    }

    /// Shows the contents in the order of their tasks.
    pub(super) fn in_order(
        &self,
        mut show: impl FnMut(&str) -> Result<(), ReportError>,
    ) -> Result<(), JournalError> {
        let mut entries = Entries::of(&self.file, &self.path)?;
        let mut waiting = BTreeMap::new();
        let mut next = self.first;
        while let Some((task, content)) = entries.next_entry() {
            waiting.insert(task, content);
            while let Some(content) = waiting.remove(&next) {
                show(&content)?;
                next += 1;
            }
        }
        Ok(())
    }
}

/// Opens the file for this process alone.
fn alone(path: &Path) -> Result<File, JournalError> {
    let refused = |action| ReportError::file(action, path);
    // a link is not followed, and a device or a pipe may never end
    if fs::symlink_metadata(path).is_ok_and(|known| !known.is_file()) {
        let path = path.to_owned();
        return Err(JournalError::Unreadable { path });
    }
    loop {
        let file = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(path)
            .map_err(refused(FileAction::Create))?;
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            let path = path.to_owned();
            return Err(JournalError::Busy { path });
        }
        // a study that ended in between took the file away, and yet another may have begun a new one
        if is_that_of(&file, path) {
            return Ok(file);
        }
    }
}

/// Whether an open file is the one of a path.
#[cfg(unix)]
fn is_that_of(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let [open, there] = [file.metadata(), fs::metadata(path)].map(|known| {
        let known = known.ok()?;
        Some((known.dev(), known.ino()))
    });
    open.is_some() && open == there
}

/// Whether an open file is the one of a path: one that is open cannot be removed there.
#[cfg(not(unix))]
fn is_that_of(_file: &File, path: &Path) -> bool {
    path.exists()
}

fn head(identity: &Value, first: u64) -> String {
    json!({ "journal": FORM, "identity": identity, "first": first }).to_string() + "\n"
}

/// Whether more stands there than a beginning of the head, which a full disk may have cut off.
fn is_begun(mut file: &File, head: &[u8]) -> io::Result<bool> {
    let mut start = Vec::new();
    file.rewind()?;
    file.take(head.len() as u64).read_to_end(&mut start)?;
    Ok(start.len() == head.len() || !head.starts_with(&start))
}

/// The entries of a journal, as far as they are whole.
struct Entries {
    reader: BufReader<File>,
    head: Head,
    /// Bytes up to the end of the last whole entry.
    whole: u64,
}

impl Entries {
    /// From the start of the file, by the handle that holds it.
    fn of(file: &File, path: &Path) -> Result<Self, JournalError> {
        let refused = || ReportError::file(FileAction::Read, path);
        let mut file = file.try_clone().map_err(refused())?;
        file.rewind().map_err(refused())?;
        let mut reader = BufReader::with_capacity(1 << 16, file);
        let mut line = Vec::new();
        reader.read_until(b'\n', &mut line).map_err(refused())?;
        let head: Option<Head> = serde_json::from_slice(&line).ok();
        let Some(head) = head.filter(|head| head.journal == FORM) else {
            let path = path.to_owned();
            return Err(JournalError::Unreadable { path });
        };
        Ok(Self {
            reader,
            head,
            whole: line.len() as u64,
        })
    }

    /// Task and content of the next entry, if it is whole.
    fn next_entry(&mut self) -> Option<(u64, String)> {
        let mut line = Vec::new();
        self.reader.read_until(b'\n', &mut line).ok()?;
        let (sum, entry) = str::from_utf8(&line)
            .ok()?
            .strip_suffix('\n')?
            .split_once(' ')?;
        if u64::from_str_radix(sum, 16).ok()? != Checksum::of(entry) {
            return None;
        }
        let (task, content) = entry.split_once(' ')?;
        let found = (task.parse().ok()?, content.to_owned());
        self.whole += line.len() as u64;
        Some(found)
    }

    /// Whether they are those of the study that is to be gone on with.
    fn check(&self, identity: &Value, first: u64, path: &Path) -> Result<(), JournalError> {
        let other = || {
            let [there, here] = [self.head.first, first].map(|chain| chain.to_string());
            (there != here).then(|| ["first chain".to_owned(), there, here])
        };
        let found = first_difference(&self.head.identity, identity);
        match found.or_else(other) {
            None => Ok(()),
            Some([key, there, here]) => Err(JournalError::Other {
                path: path.to_owned(),
                key,
                there,
                here,
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contents(journal: &Journal) -> Vec<String> {
        let mut all = Vec::new();
        let shown = journal.in_order(|content| {
            all.push(content.to_owned());
            Ok(())
        });
        shown.unwrap();
        all
    }

    #[test]
    fn what_is_noted_in_any_order_is_shown_in_that_of_the_tasks() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.journal");
        let mut journal = Journal::open(&path, &json!({}), 3, false).unwrap();
        for task in [4, 3, 6, 5, 4] {
            journal.add(task, &task.to_string()).unwrap();
        }
        assert_eq!(contents(&journal), ["3", "4", "5", "6"]);
    }

    #[test]
    fn an_entry_cut_off_by_a_kill_is_dropped_and_made_again() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.journal");
        let mut journal = Journal::open(&path, &json!({}), 0, false).unwrap();
        journal.add(0, "zero").unwrap();
        journal.add(1, "one").unwrap();
        drop(journal);
        let length = std::fs::metadata(&path).unwrap().len();
        let file = OpenOptions::new().write(true).open(&path).unwrap();
        file.set_len(length - 3).unwrap();
        let mut journal = Journal::open(&path, &json!({}), 0, false).unwrap();
        assert!(journal.done.holds(0) && !journal.done.holds(1));
        journal.add(1, "one").unwrap();
        assert_eq!(contents(&journal), ["zero", "one"]);
    }

    #[test]
    fn the_journal_of_another_study_is_refused_by_what_differs() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.journal");
        drop(Journal::open(&path, &json!({"seed": 1}), 0, false).unwrap());
        let error = Journal::open(&path, &json!({"seed": 2}), 0, false).unwrap_err();
        let told = error.to_string();
        assert!(told.contains("`seed` was 1 there and is 2 now"), "{told}");
    }

    #[test]
    fn one_process_at_a_time_has_a_journal() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.journal");
        let mut journal = Journal::open(&path, &json!({}), 0, false).unwrap();
        journal.add(0, "zero").unwrap();
        for anew in [false, true] {
            let error = Journal::open(&path, &json!({}), 0, anew).unwrap_err();
            assert!(error.to_string().contains("another process"), "{error}");
        }
        assert_eq!(contents(&journal), ["zero"]);
    }

    #[test]
    fn a_head_that_a_full_disk_cut_off_is_written_anew() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.journal");
        let head = head(&json!({}), 0);
        for length in 0..head.len() {
            fs::write(&path, &head[..length]).unwrap();
            let mut journal = Journal::open(&path, &json!({}), 0, false).unwrap();
            journal.add(0, "zero").unwrap();
            assert_eq!(contents(&journal), ["zero"], "{length} bytes");
        }
    }
}
