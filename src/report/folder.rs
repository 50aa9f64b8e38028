//! The folder of a run: either it holds the whole of one run, or it does not look whole.

use std::fs::{self, File, TryLockError};
use std::io::{self, BufReader, Write};
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde_json::{Value, json};

use super::figure::Figure;
use super::table::{Origin, TableFiles};
use super::whole_file::{PartialFile, TEMPORARY, WholeFile, sync_files, sync_folder};
use super::{FileAction, ReportError};
use crate::record::open_regular;
use crate::scenario::TableFormat;
use crate::table::Table;

/// The files that one verb leaves in a folder, by the file that seals them.
///
/// The seal is a document whose `sealed` lists all others by their names: what an earlier run left, and whose files another
/// verb is about to replace, is read there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FileSet {
    /// The file that says that the set is whole: set aside before the first rename, renamed last.
    pub seal: &'static str,
    /// What a whole set makes needless: removed once the set is whole, with all that it seals.
    spent: Option<&'static str>,
}

impl FileSet {
    /// What a motion leaves.
    pub const MOTION: Self = Self {
        spent: Some(Self::FAILURE.seal),
        ..Self::sealed("summary.json")
    };
    /// What a run leaves that cannot go on; an earlier whole run may be beside it.
    pub const FAILURE: Self = Self::sealed("failure.json");
    /// What many runs of a scenario leave.
    pub const RUNS: Self = Self {
        spent: Some("runs.jsonl"),
        ..Self::sealed("runs.json")
    };
    /// What a verb leaves whose files that seals.
    pub const fn sealed(seal: &'static str) -> Self {
        Self { seal, spent: None }
    }

    /// The page of an answer, called like its seal; that of runs has a name that stays the same whoever seals them.
    pub(super) fn page(self) -> String {
        match self {
            Self::MOTION | Self::RUNS => "report.html".to_owned(),
            _ => self.seal.replace(".json", ".html"),
        }
    }

    /// Name of the earlier seal while its files are replaced, which a run that is killed meanwhile leaves to the next one.
    fn set_aside(self) -> String {
        format!(".{}.replaced", self.seal)
    }
}

/// Endings of the files that a set may list: no other file is removed, whatever a seal says.
const ENDINGS: [&str; 5] = ["csv", "parquet", "svg", "html", "toml"];
/// Bytes of the largest seal that is read.
const LARGEST_SEAL: u64 = 1 << 30;

/// What is read of an earlier seal.
#[derive(Deserialize)]
struct Sealed {
    #[serde(default)]
    sealed: Vec<String>,
}

/// Names of the files that a seal lists; none where there is no seal, or one without a list.
fn sealed_files(seal: &Path) -> Vec<String> {
    let file = open_regular(seal, LARGEST_SEAL).ok();
    let read = file.and_then(|file| serde_json::from_reader(BufReader::new(file)).ok());
    let Sealed { sealed } = read.unwrap_or(Sealed { sealed: Vec::new() });
    let is_own = |name: &String| {
        let path = Path::new(name);
        let ending = path.extension().and_then(|ending| ending.to_str());
        path.file_name() == Some(path.as_os_str())
            && ending.is_some_and(|ending| ENDINGS.contains(&ending))
    };
    sealed.into_iter().filter(is_own).collect()
}

/// A folder that takes the files of one run.
///
/// Files are written under a temporary name and renamed together by [`RunFolder::commit`]. Until
/// then an earlier run in the same folder stays as it was; a run that ends before leaves nothing
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
        folder._lock = Some(locked(lockable(path)?, path, File::try_lock)?);
        folder.remove_temporary()?;
        Ok(folder)
    }

    /// Opens the folder for one part of a study, while other processes may make others.
    ///
    /// # Errors
    /// As [`RunFolder::open`].
    pub(super) fn open_for_part(path: &Path, set: FileSet) -> Result<Self, ReportError> {
        let mut folder = Self::of_any(path, set)?;
        folder._lock = Some(locked(lockable(path)?, path, File::try_lock_shared)?);
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

    /// The folder, for another set of files.
    pub(super) fn with_set(self, set: FileSet) -> Self {
        Self { set, ..self }
    }

    /// The folder with tables in these formats, which say what scenario they come from.
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
        PartialFile::create(&self.path, name)
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

    /// Gives all files their names, the seal with the document last, and removes what an earlier run left that
    /// this one does not have.
    ///
    /// The document lists the names of the files as `sealed`. Where another verb has sealed one of them, that seal goes.
    /// Returns the paths of all files, and the document.
    ///
    /// # Errors
    /// [`ReportError::File`]; the folder then has no seal.
    pub fn commit(
        self,
        files: Vec<WholeFile>,
        mut document: Value,
    ) -> Result<(Vec<PathBuf>, Value), ReportError> {
        let names: Vec<String> = files.iter().map(WholeFile::name).collect();
        document["sealed"] = json!(names);
        let seal = self.write(self.set.seal, format!("{document:#}\n").as_bytes())?;
        sync_files(files.iter().chain([&seal]))?;
        let earlier = self.earlier_files();
        self.unseal()?;
        self.remove(&self.seals_over(&names))?;
        self.remove(&earlier)?;
        let paths: Result<Vec<_>, _> = files.into_iter().map(WholeFile::rename).collect();
        let mut paths = paths?;
        sync_folder(&self.path)?;
        paths.push(seal.rename()?);
        sync_folder(&self.path)?;
        self.remove(&[self.set.set_aside()])?;
        if let Some(spent) = self.set.spent {
            self.remove(&sealed_files(&self.path.join(spent)))?;
            self.remove(&[spent.to_owned()])?;
        }
        Ok((paths, document))
    }

    /// Sets the earlier seal aside, before anything of what it seals is touched.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be renamed.
    pub(super) fn unseal(&self) -> Result<(), ReportError> {
        let seal = self.path.join(self.set.seal);
        if seal.symlink_metadata().is_err() {
            return Ok(());
        }
        let renamed = fs::rename(&seal, self.path.join(self.set.set_aside()));
        renamed.map_err(ReportError::file(FileAction::Rename, &seal))?;
        sync_folder(&self.path)
    }

    /// Names of the files that earlier runs of the set left.
    fn earlier_files(&self) -> Vec<String> {
        let seals = [self.set.seal.to_owned(), self.set.set_aside()];
        let sealed = seals
            .iter()
            .flat_map(|seal| sealed_files(&self.path.join(seal)));
        sealed.collect()
    }

    /// Names of the files of an earlier run that is whole, the seal first.
    pub(super) fn whole_files(&self) -> Vec<String> {
        let seal = self.path.join(self.set.seal);
        if !seal.exists() {
            return Vec::new();
        }
        let sealed = sealed_files(&seal).into_iter();
        [self.set.seal.to_owned()]
            .into_iter()
            .chain(sealed)
            .collect()
    }

    /// Removes what a killed run left under temporary names.
    fn remove_temporary(&self) -> Result<(), ReportError> {
        let temporary = |name: &String| name.starts_with('.') && name.ends_with(TEMPORARY);
        self.remove(&self.names().filter(temporary).collect::<Vec<_>>())
    }

    /// Names of the seals of other verbs that list one of some files.
    fn seals_over(&self, files: &[String]) -> Vec<String> {
        let other = |name: &String| name.ends_with(".json") && name != self.set.seal;
        let lists = |seal: &String| {
            let mut sealed = sealed_files(&self.path.join(seal)).into_iter();
            sealed.any(|name| files.contains(&name))
        };
        self.names().filter(other).filter(lists).collect()
    }

    /// Names of all files of the folder.
    fn names(&self) -> impl Iterator<Item = String> + use<> {
        let entries = fs::read_dir(&self.path).into_iter().flatten().flatten();
        entries.filter_map(|entry| entry.file_name().into_string().ok())
    }

    fn remove(&self, names: &[String]) -> Result<(), ReportError> {
        for name in names {
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

/// Writes a file that belongs to no set, under a temporary name first; its folder is created where it is missing. A link is
/// followed, and what is no file, as a pipe or a device, takes the bytes as they come.
///
/// # Errors
/// [`ReportError::File`] where folder or file cannot be created or written.
pub fn write_whole(path: &Path, content: &[u8]) -> Result<(), ReportError> {
    let path = &fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir()) {
        return fs::write(path, content).map_err(ReportError::file(FileAction::Write, path));
    }
    let parent = path
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty());
    let folder = RunFolder::of_any(parent.unwrap_or(Path::new(".")), FileSet::MOTION)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    folder.write(&name, content)?.rename_durably()?;
    Ok(())
}

/// Locks a file or folder for this process, alone or with others that share it.
///
/// # Errors
/// [`ReportError::Busy`] where another one has a lock that keeps this one out.
pub(super) fn locked(
    file: File,
    path: &Path,
    lock: fn(&File) -> Result<(), TryLockError>,
) -> Result<File, ReportError> {
    match lock(&file) {
        Err(TryLockError::WouldBlock) => Err(ReportError::Busy {
            path: path.to_owned(),
        }),
        // a file system that knows no locks has none to respect
        _ => Ok(file),
    }
}

/// What is locked: the folder itself, which leaves nothing behind.
#[cfg(unix)]
fn lockable(folder: &Path) -> Result<File, ReportError> {
    File::open(folder).map_err(ReportError::file(FileAction::Create, folder))
}

/// What is locked: a file of its own, as folders cannot be.
#[cfg(not(unix))]
fn lockable(folder: &Path) -> Result<File, ReportError> {
    File::create(folder.join(".lock")).map_err(ReportError::file(FileAction::Create, folder))
}
