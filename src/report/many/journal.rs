//! What is done of a study, kept as it is done, so that a killed study goes on from there.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use crate::report::bytes::{Checksum, Put, Take};
use crate::report::{FileAction, ReportError};

const MAGIC: [u8; 8] = *b"jcJourn3";

/// Bytes of an entry before its content: task, length, and after it the checksum.
const HEAD: usize = 16;
/// Longest content that is believed.
const LONGEST: u64 = 1 << 32;

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
    path: PathBuf,
    done: Done,
    first: u64,
}

impl Journal {
    /// Goes on with the journal of the same study, if one stands there, or else begins one whose tasks count
    /// from `first` on; what was written last before a kill and is not whole is dropped. `identity` tells
    /// its study from others; `anew` throws away what stands there.
    pub(super) fn open(
        path: &Path,
        identity: &str,
        first: u64,
        anew: bool,
    ) -> Result<Self, JournalError> {
        let refused = |action| ReportError::file(action, path);
        let mut file = alone(path)?;
        let head = head(identity, first);
        let mut done = Done::none(first);
        let mut whole = head.len() as u64;
        if anew || !is_begun(&file, &head).map_err(refused(FileAction::Read))? {
            file.set_len(0)
                .and_then(|()| file.rewind())
                .and_then(|()| file.write_all(&head))
                .map_err(refused(FileAction::Write))?;
        } else {
            let mut entries = Entries::of_study(&file, path, identity, first)?;
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

    /// Its path.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Removes the file: what it held stands elsewhere.
    pub(super) fn remove(self) -> Result<(), ReportError> {
        fs::remove_file(&self.path).map_err(ReportError::file(FileAction::Remove, &self.path))
    }

    /// Tasks that are done.
    pub fn done(&self) -> &Done {
        &self.done
    }

    /// Notes a task with its content; one that is noted already is left as it was.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be written: the journal then ends before it.
    pub fn add(&mut self, task: u64, content: &[u8]) -> Result<(), ReportError> {
        if self.done.holds(task) {
            return Ok(());
        }
        let mut entry = Vec::with_capacity(content.len() + HEAD + 8);
        entry.put_u64(task);
        entry.put_u64(content.len() as u64);
        entry.extend(content);
        let mut checksum = Checksum::START;
        checksum.add(&entry);
        entry.put_u64(checksum.value());
        // in one piece: what a full disk cuts off is found by its checksum
        self.file
            .write_all(&entry)
            .map_err(ReportError::file(FileAction::Write, &self.path))?;
        self.done.add(task);
        Ok(())
    }

    /// Shows the contents in the order of their tasks.
    pub(super) fn in_order(
        &self,
        mut show: impl FnMut(&[u8]) -> Result<(), ReportError>,
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

fn head(identity: &str, first: u64) -> Vec<u8> {
    let mut head = MAGIC.to_vec();
    head.put_text(identity);
    head.put_u64(first);
    head
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
    identity: String,
    first: u64,
    /// Bytes up to the end of the last whole entry.
    whole: u64,
}

impl Entries {
    /// Those of one study.
    fn of_study(
        file: &File,
        path: &Path,
        identity: &str,
        first: u64,
    ) -> Result<Self, JournalError> {
        let entries = Self::of(file, path)?;
        if entries.identity == identity && entries.first == first {
            return Ok(entries);
        }
        let [key, there, here] = entries.difference(identity, first);
        Err(JournalError::Other {
            path: path.to_owned(),
            key,
            there,
            here,
        })
    }

    /// From the start of the file, by the handle that holds it.
    fn of(file: &File, path: &Path) -> Result<Self, JournalError> {
        let unreadable = || JournalError::Unreadable {
            path: path.to_owned(),
        };
        let refused = || ReportError::file(FileAction::Read, path);
        let mut file = file.try_clone().map_err(refused())?;
        file.rewind().map_err(refused())?;
        let mut reader = BufReader::with_capacity(1 << 16, file);
        let mut head = [0; 16];
        reader.read_exact(&mut head).map_err(|_| unreadable())?;
        let mut take = Take(&head);
        let magic: Option<[u8; 8]> = take.array();
        let length = take.u64().filter(|length| *length < LONGEST);
        let length = length
            .filter(|_| magic == Some(MAGIC))
            .ok_or_else(unreadable)?;
        let text = exactly(&mut reader, length + 8).map_err(|_| unreadable())?;
        let mut take = Take(&text);
        let identity = take.bytes(length).map(<[u8]>::to_vec);
        let identity = identity.and_then(|bytes| String::from_utf8(bytes).ok());
        let (Some(identity), Some(first)) = (identity, take.u64()) else {
            return Err(unreadable());
        };
        Ok(Self {
            reader,
            identity,
            first,
            whole: 16 + length + 8,
        })
    }

    /// Task and content of the next entry, if it is whole.
    fn next_entry(&mut self) -> Option<(u64, Vec<u8>)> {
        let mut head = [0; HEAD];
        self.reader.read_exact(&mut head).ok()?;
        let mut take = Take(&head);
        let (task, length) = (take.u64()?, take.u64()?);
        if length > LONGEST {
            return None;
        }
        let mut rest = exactly(&mut self.reader, length + 8).ok()?;
        let sum = rest.split_off(usize::try_from(length).ok()?);
        let mut checksum = Checksum::START;
        checksum.add(&head);
        checksum.add(&rest);
        if Take(&sum).u64()? != checksum.value() {
            return None;
        }
        self.whole += HEAD as u64 + length + 8;
        Some((task, rest))
    }

    /// What differs from the study that is to be gone on with.
    fn difference(&self, identity: &str, first: u64) -> [String; 3] {
        let trees = [&self.identity[..], identity].map(serde_json::from_str);
        if let [Ok(there), Ok(here)] = &trees
            && let Some(found) = crate::report::restart::difference(there, here)
        {
            return found;
        }
        [
            "first chain".to_owned(),
            self.first.to_string(),
            first.to_string(),
        ]
    }
}

/// So many bytes, without believing the number before they are there.
fn exactly(reader: &mut impl Read, count: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    reader.take(count).read_to_end(&mut bytes)?;
    if bytes.len() as u64 == count {
        Ok(bytes)
    } else {
        Err(io::ErrorKind::UnexpectedEof.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contents(journal: &Journal) -> Vec<Vec<u8>> {
        let mut all = Vec::new();
        let shown = journal.in_order(|content| {
            all.push(content.to_vec());
            Ok(())
        });
        shown.unwrap();
        all
    }

    #[test]
    fn what_is_noted_in_any_order_is_shown_in_that_of_the_tasks() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.journal");
        let mut journal = Journal::open(&path, "{}", 3, false).unwrap();
        for task in [4, 3, 6, 5, 4] {
            journal.add(task, &[task as u8]).unwrap();
        }
        assert_eq!(contents(&journal), [[3], [4], [5], [6]]);
    }

    #[test]
    fn an_entry_cut_off_by_a_kill_is_dropped_and_made_again() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.journal");
        let mut journal = Journal::open(&path, "{}", 0, false).unwrap();
        journal.add(0, b"zero").unwrap();
        journal.add(1, b"one").unwrap();
        drop(journal);
        let length = std::fs::metadata(&path).unwrap().len();
        let file = OpenOptions::new().write(true).open(&path).unwrap();
        file.set_len(length - 3).unwrap();
        let mut journal = Journal::open(&path, "{}", 0, false).unwrap();
        assert!(journal.done().holds(0) && !journal.done().holds(1));
        journal.add(1, b"one").unwrap();
        assert_eq!(contents(&journal), [&b"zero"[..], b"one"]);
    }

    #[test]
    fn the_journal_of_another_study_is_refused_by_what_differs() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.journal");
        drop(Journal::open(&path, r#"{"seed": 1}"#, 0, false).unwrap());
        let error = Journal::open(&path, r#"{"seed": 2}"#, 0, false).unwrap_err();
        let told = error.to_string();
        assert!(told.contains("`seed` was 1 there and is 2 now"), "{told}");
    }

    #[test]
    fn one_process_at_a_time_has_a_journal() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.journal");
        let mut journal = Journal::open(&path, "{}", 0, false).unwrap();
        journal.add(0, b"zero").unwrap();
        for anew in [false, true] {
            let error = Journal::open(&path, "{}", 0, anew).unwrap_err();
            assert!(error.to_string().contains("another process"), "{error}");
        }
        assert_eq!(contents(&journal), [b"zero"]);
    }

    #[test]
    fn a_head_that_a_full_disk_cut_off_is_written_anew() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.journal");
        let head = head("{}", 0);
        for length in 0..head.len() {
            fs::write(&path, &head[..length]).unwrap();
            let mut journal = Journal::open(&path, "{}", 0, false).unwrap();
            journal.add(0, b"zero").unwrap();
            assert_eq!(contents(&journal), [b"zero"], "{length} bytes");
        }
    }
}
