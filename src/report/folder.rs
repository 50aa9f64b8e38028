//! The folder of a run: either the whole of one run stands there, or it does not look whole.

use std::fs::{self, File, TryLockError};
use std::io::{self, BufWriter, Write};
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use serde_json::Value;

use super::figure::Figure;
use super::table::{Origin, TableFiles};
use super::{FileAction, ReportError};
use crate::scenario::TableFormat;
use crate::table::Table;

/// Names of the files that one verb leaves in a folder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FileSet {
    /// The file that says that the set is whole: removed before the first rename, renamed last.
    pub seal: &'static str,
    /// Tables, which stand in any of their formats; a name with a `*` as among the others.
    pub tables: &'static [&'static str],
    /// Files that may stand beside the seal; those of an earlier run do not outlive the next. A name
    /// with a `*` stands for all that begin and end as it does.
    pub others: &'static [&'static str],
    /// Files that a whole set makes needless: removed when it stands.
    pub spent: &'static [&'static str],
}

impl FileSet {
    /// What a motion leaves.
    pub const MOTION: Self = Self {
        seal: "summary.json",
        tables: &[
            "trace",
            "energy",
            "drive",
            "trace_balls",
            "events",
            "spectrum",
            "peaks",
            "spectrum_*",
            "poincare",
            "waterfall",
            "order_tracks",
            "campbell",
        ],
        others: &[
            "trace.svg",
            "spectrum.svg",
            "spectrum_*.svg",
            "orbit.svg",
            "defects.svg",
            "waterfall.svg",
            "order_tracks.svg",
            "campbell.svg",
            "campbell.json",
            "report.html",
        ],
        spent: &[
            "failure.json",
            "trace.until-failure.csv",
            "trace.until-failure.parquet",
        ],
    };
    /// What a run leaves that cannot go on; an earlier whole run may be beside it.
    pub const FAILURE: Self = Self {
        seal: "failure.json",
        tables: &["trace.until-failure"],
        others: &[],
        spent: &[],
    };
    /// What the answer to a static question leaves.
    pub const BEARING: Self = Self {
        seal: "bearing.json",
        tables: &["balls"],
        others: &["balls.svg", "deflection.svg", "bearing.html"],
        spent: &[],
    };
    /// What natural frequencies over the speed leave.
    pub const CAMPBELL: Self = Self {
        seal: "campbell.json",
        tables: &["campbell"],
        others: &["campbell.svg", "mode_shapes.svg", "campbell.html"],
        spent: &[],
    };
    /// What many runs of a scenario leave.
    pub const RUNS: Self = Self {
        seal: "runs.json",
        tables: &[
            "runs",
            "spectra",
            "poincare",
            "traces",
            "stiffness",
            "around",
        ],
        others: &[
            "response.svg",
            "map.svg",
            "sensitivity.svg",
            "scatter.svg",
            "ross_*.toml",
            "waterfall.svg",
            "bifurcation.svg",
            "stiffness.svg",
            "deformation.svg",
            "contact_angle.svg",
            "report.html",
        ],
        spent: &["runs.jsonl"],
    };
    /// What a measurement of speed against error leaves.
    pub const ACCURACY: Self = Self {
        seal: "accuracy.json",
        tables: &["accuracy", "ladder"],
        others: &["accuracy.svg", "ladder.svg", "accuracy.html"],
        spent: &[],
    };
    /// What a steady motion leaves.
    pub const STEADY: Self = Self {
        seal: "steady.json",
        tables: &["steady_trace", "steady_spectrum"],
        others: &["steady_trace.svg", "steady_spectrum.svg", "steady.html"],
        spent: &[],
    };
    /// What steady motions along a parameter leave.
    pub const RESPONSE: Self = Self {
        seal: "response.json",
        tables: &["response", "response_specials"],
        others: &["response.svg", "response.html"],
        spent: &[],
    };
    /// All whose seals may stand in one folder.
    const ALL: [Self; 7] = [
        Self::MOTION,
        Self::BEARING,
        Self::CAMPBELL,
        Self::RUNS,
        Self::ACCURACY,
        Self::STEADY,
        Self::RESPONSE,
    ];

    /// The page of an answer, called like its seal.
    pub(super) fn page(self) -> String {
        self.seal.replace(".json", ".html")
    }

    /// The seals of other sets whose files are there and are replaced by these.
    fn others_of(self, files: &[WholeFile]) -> Vec<&'static str> {
        let replaced = files.iter().filter(|file| file.path.exists());
        let names = replaced.filter_map(|file| file.path.file_name()?.to_str());
        let names: Vec<_> = names.collect();
        let shares = |set: &Self| {
            let mut patterns = set.beside();
            patterns.any(|pattern| names.iter().any(|name| is_alike(name, &pattern)))
        };
        let others = Self::ALL.into_iter();
        let others = others.filter(|set| set.seal != self.seal && shares(set));
        others.map(|set| set.seal).collect()
    }

    /// Names of what may stand beside the seal.
    fn beside(self) -> impl Iterator<Item = String> {
        let tables = self.tables.iter().flat_map(|stem| {
            TableFormat::ALL.map(|format| format!("{stem}.{}", format.extension()))
        });
        let others = self.others.iter().filter(move |name| **name != self.seal);
        tables.chain(others.map(|name| (*name).to_owned()))
    }
}

/// Whether a pattern stands for a name: `*` is any text that is not empty.
fn is_alike(name: &str, pattern: &str) -> bool {
    let Some((start, end)) = pattern.split_once('*') else {
        return name == pattern;
    };
    name.len() > start.len() + end.len() && name.starts_with(start) && name.ends_with(end)
}

/// Files whose content is synced at a time.
const SYNCED_AT_A_TIME: usize = 8;

/// What a killed run may leave.
const TEMPORARY: &str = ".*.partial";

/// A folder that takes the files of one run.
///
/// Files are written under a temporary name and renamed together by [`RunFolder::commit`]. Until
/// then an earlier run in the same folder stands as it was; a run that ends before leaves nothing
/// behind, and one that is killed, or loses its power, while it renames leaves a folder without the
/// seal of its set. What a killed run leaves under temporary names the next one removes.
#[derive(Debug)]
pub struct RunFolder {
    path: PathBuf,
    /// The lock on it, which the system takes back when the process ends, however it ends; none where files are put
    /// that belong to no set.
    _lock: Option<File>,
    set: FileSet,
    /// Formats of the tables.
    pub(super) formats: Vec<TableFormat>,
    /// What the tables come from.
    pub(super) origin: Origin,
}

impl RunFolder {
    /// Opens the folder for a set of files and for this process alone, creating it and its parents where they are
    /// missing.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be created, [`ReportError::Busy`] where another process writes there.
    pub fn open(path: &Path, set: FileSet) -> Result<Self, ReportError> {
        let mut folder = Self::of_any(path, set)?;
        folder._lock = Some(locked(path, File::try_lock)?);
        folder.remove([TEMPORARY.to_owned()])?;
        Ok(folder)
    }

    /// Opens the folder for one part of a study, while other processes may make others.
    ///
    /// # Errors
    /// As [`RunFolder::open`].
    pub(super) fn open_for_part(path: &Path, set: FileSet) -> Result<Self, ReportError> {
        let mut folder = Self::of_any(path, set)?;
        folder._lock = Some(locked(path, File::try_lock_shared)?);
        Ok(folder)
    }

    /// Opens the folder for files that belong to no set, whoever else writes there.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be created.
    pub(super) fn of_any(path: &Path, set: FileSet) -> Result<Self, ReportError> {
        fs::create_dir_all(path).map_err(ReportError::file(FileAction::Create, path))?;
        Ok(Self {
            path: path.to_owned(),
            _lock: None,
            set,
            formats: vec![TableFormat::Csv],
            origin: Origin::default(),
        })
    }

    /// The same for another set of files.
    pub(super) fn with_set(self, set: FileSet) -> Self {
        Self { set, ..self }
    }

    /// The same with tables in these formats, which say what scenario they come from.
    pub(super) fn with_tables(self, formats: &[TableFormat], scenario: &Value) -> Self {
        let scenario = scenario.to_string();
        Self {
            formats: formats.to_vec(),
            origin: Origin { scenario },
            ..self
        }
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Starts the file `name` under its temporary name `.name.partial`.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be created.
    pub fn create(&self, name: &str) -> Result<PartialFile, ReportError> {
        let temporary = self.path.join(format!(".{name}.partial"));
        // what stands there is removed, not written into: a link may lead anywhere
        let _ = fs::remove_file(&temporary);
        let created = File::create_new(&temporary);
        let created = created.map_err(ReportError::file(FileAction::Create, &temporary))?;
        Ok(PartialFile {
            writer: BufWriter::with_capacity(1 << 16, created),
            file: WholeFile {
                temporary,
                path: self.path.join(name),
            },
        })
    }

    /// Writes a file of known content.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be created or written.
    pub fn write(&self, name: &str, content: &[u8]) -> Result<WholeFile, ReportError> {
        self.write_with(name, |file| file.write_all(content))
    }

    /// Writes a file as `write` makes it.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be created or written.
    pub fn write_with(
        &self,
        name: &str,
        write: impl FnOnce(&mut PartialFile) -> io::Result<()>,
    ) -> Result<WholeFile, ReportError> {
        let mut file = self.create(name)?;
        write(&mut file).map_err(ReportError::file(FileAction::Write, file.path()))?;
        file.close()
    }

    /// Draws a figure into a file.
    pub(super) fn write_figure(&self, figure: &Figure) -> Result<WholeFile, ReportError> {
        self.write(&format!("{}.svg", figure.name), figure.svg().as_bytes())
    }

    /// Writes the table `stem` in every format.
    ///
    /// # Errors
    /// [`ReportError::File`] where a file cannot be created or written.
    pub(super) fn write_table(
        &self,
        stem: &str,
        table: &Table<'_>,
    ) -> Result<Vec<WholeFile>, ReportError> {
        TableFiles::write(self, stem, &table.columns(), table.rows())
    }

    /// Gives all files their names, the seal with the content `sealed` last, and removes
    /// what an earlier run left under the names of outputs that this one does not have.
    ///
    /// Returns the paths of all files.
    ///
    /// # Errors
    /// [`ReportError::File`]; the folder then has no seal.
    pub fn commit(self, files: Vec<WholeFile>, sealed: &[u8]) -> Result<Vec<PathBuf>, ReportError> {
        let seal = self.write(self.set.seal, sealed)?;
        // no seal of another verb stands over files that this one replaces; under its own seal they are its own
        if !seal.path.exists() {
            self.unseal(&self.set.others_of(&files))?;
        }
        let paths = self.put(files, seal, self.set.beside())?;
        self.remove(self.set.spent.iter().map(|name| (*name).to_owned()))?;
        Ok(paths)
    }

    /// Gives files their names, in place of what stands there under these names and those of `earlier`: an earlier
    /// seal goes before all of that, and `seal` gets its name after all others.
    ///
    /// Returns the paths of all files.
    ///
    /// # Errors
    /// [`ReportError::File`]; the folder then has no seal.
    pub(super) fn put(
        &self,
        files: Vec<WholeFile>,
        seal: WholeFile,
        earlier: impl IntoIterator<Item = String>,
    ) -> Result<Vec<PathBuf>, ReportError> {
        sync_files(files.iter().chain([&seal]))?;
        let name = seal.path.file_name().unwrap_or_default();
        self.unseal(&[&name.to_string_lossy()])?;
        self.remove(earlier)?;
        let paths: Result<Vec<_>, _> = files.into_iter().map(WholeFile::rename).collect();
        let mut paths = paths?;
        sync_folder(&self.path)?;
        paths.push(seal.rename()?);
        sync_folder(&self.path)?;
        Ok(paths)
    }

    /// Removes seals for good, before anything of what they seal is touched.
    ///
    /// # Errors
    /// [`ReportError::File`] where one cannot be removed.
    pub(super) fn unseal(&self, seals: &[&str]) -> Result<(), ReportError> {
        if seals.iter().any(|seal| self.path.join(seal).exists()) {
            self.remove(seals.iter().map(|seal| (*seal).to_owned()))?;
            sync_folder(&self.path)?;
        }
        Ok(())
    }

    /// Files of the folder's set, if an earlier run stands here whole.
    pub(super) fn earlier_files(&self) -> Vec<String> {
        if !self.path.join(self.set.seal).exists() {
            return Vec::new();
        }
        let others = self.set.beside();
        let others = others.flat_map(|pattern| self.matching(&pattern));
        let others = others.filter(|name| self.path.join(name).exists());
        std::iter::once(self.set.seal.to_owned())
            .chain(others)
            .collect()
    }

    /// Names that a pattern stands for: itself, or those of the files that are there, in the order of
    /// the alphabet.
    fn matching(&self, pattern: &str) -> Vec<String> {
        if !pattern.contains('*') {
            return vec![pattern.to_owned()];
        }
        let entries = fs::read_dir(&self.path).into_iter().flatten().flatten();
        let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
        let mut names: Vec<_> = names.filter(|name| is_alike(name, pattern)).collect();
        names.sort();
        names
    }

    fn remove(&self, names: impl IntoIterator<Item = String>) -> Result<(), ReportError> {
        let names = names.into_iter();
        for name in names.flat_map(|pattern| self.matching(&pattern)) {
            let path = self.path.join(name);
            match fs::remove_file(&path) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(ReportError::file(FileAction::Remove, &path)(error));
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// Writes a file that belongs to no set, under a temporary name first; its folder is created where it
/// is missing.
///
/// # Errors
/// [`ReportError::File`] where folder or file cannot be created or written.
pub fn write_whole(path: &Path, content: &[u8]) -> Result<(), ReportError> {
    let parent = path
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty());
    let folder = RunFolder::of_any(parent.unwrap_or(Path::new(".")), FileSet::MOTION)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    folder.write(&name, content)?.rename_durably()?;
    Ok(())
}

/// Sees that the content of files outlives a loss of power, several at a time, as the device does them in one go.
fn sync_files<'a>(files: impl IntoIterator<Item = &'a WholeFile>) -> Result<(), ReportError> {
    let files: Vec<_> = files.into_iter().collect();
    let next = AtomicUsize::new(0);
    let sync = || {
        let mut taken = std::iter::from_fn(|| files.get(next.fetch_add(1, Ordering::Relaxed)));
        taken.try_for_each(|file| file.sync())
    };
    thread::scope(|scope| {
        // where the system has no further thread, those that there are do it
        let helpers = (1..SYNCED_AT_A_TIME.min(files.len()))
            .map_while(|_| thread::Builder::new().spawn_scoped(scope, sync).ok());
        let helpers: Vec<_> = helpers.collect();
        let own = sync();
        let theirs = helpers.into_iter().map(|helper| helper.join());
        let theirs = theirs.map(|joined| joined.unwrap_or_else(|panic| resume_unwind(panic)));
        theirs.chain([own]).collect()
    })
}

/// Sees that the names in a folder outlive a loss of power.
#[cfg(unix)]
pub(super) fn sync_folder(path: &Path) -> Result<(), ReportError> {
    let synced = File::open(path).and_then(|folder| folder.sync_all());
    synced.map_err(ReportError::file(FileAction::Sync, path))
}

/// Such a system has no way to ask for it.
#[cfg(not(unix))]
pub(super) fn sync_folder(_path: &Path) -> Result<(), ReportError> {
    Ok(())
}

/// A file being written under its temporary name; dropping it removes it.
#[derive(Debug)]
pub struct PartialFile {
    writer: BufWriter<File>,
    file: WholeFile,
}

impl PartialFile {
    /// Path that the file will have.
    pub fn path(&self) -> &Path {
        &self.file.path
    }

    /// Writes what is buffered and closes the file, which keeps its temporary name.
    ///
    /// # Errors
    /// [`ReportError::File`] where the last bytes cannot be written.
    pub fn close(mut self) -> Result<WholeFile, ReportError> {
        let written = self.writer.flush();
        written.map_err(ReportError::file(FileAction::Write, self.path()))?;
        Ok(self.file)
    }
}

impl Write for PartialFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.flush()
    }
}

/// A file written to its end that still has its temporary name; dropping it removes it.
#[derive(Debug)]
pub struct WholeFile {
    temporary: PathBuf,
    path: PathBuf,
}

impl Drop for WholeFile {
    fn drop(&mut self) {
        // After the rename it is gone; otherwise there is nobody left to tell of a failure.
        let _ = fs::remove_file(&self.temporary);
    }
}

impl WholeFile {
    /// Path that the file will have.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// The same file, to have another name.
    pub(super) fn named(mut self, name: &str) -> Self {
        self.path.set_file_name(name);
        self
    }

    /// Gives it its name for good.
    pub(super) fn rename_durably(self) -> Result<PathBuf, ReportError> {
        self.sync()?;
        let path = self.rename()?;
        sync_folder(path.parent().unwrap_or(&path))?;
        Ok(path)
    }

    fn sync(&self) -> Result<(), ReportError> {
        let path = &self.temporary;
        let file = File::options().append(true).open(path);
        let synced = file.and_then(|file| file.sync_data());
        synced.map_err(ReportError::file(FileAction::Sync, path))
    }

    /// Gives it its name, which may be lost with the power.
    pub(super) fn rename(self) -> Result<PathBuf, ReportError> {
        let renamed = fs::rename(&self.temporary, &self.path);
        renamed.map_err(ReportError::file(FileAction::Rename, &self.path))?;
        Ok(self.path.clone())
    }
}

/// Locks a folder for this process, alone or with others that share it.
///
/// # Errors
/// [`ReportError::Busy`] where another one has a lock that keeps this one out.
fn locked(folder: &Path, lock: fn(&File) -> Result<(), TryLockError>) -> Result<File, ReportError> {
    let file = lockable(folder).map_err(ReportError::file(FileAction::Create, folder))?;
    match lock(&file) {
        Err(TryLockError::WouldBlock) => Err(ReportError::Busy {
            folder: folder.to_owned(),
        }),
        // a file system that knows no locks has none to respect
        _ => Ok(file),
    }
}

/// What is locked: the folder itself, which leaves nothing behind.
#[cfg(unix)]
fn lockable(folder: &Path) -> io::Result<File> {
    File::open(folder)
}

/// What is locked: a file of its own, as folders cannot be.
#[cfg(not(unix))]
fn lockable(folder: &Path) -> io::Result<File> {
    File::create(folder.join(".lock"))
}
