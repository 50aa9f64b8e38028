//! Files that are written under a temporary name, so that none looks whole before it is.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use super::{FileAction, ReportError};

/// Ending of a file that is being written.
pub(super) const TEMPORARY: &str = ".partial";

/// Files whose content is synced at a time.
const SYNCED_AT_A_TIME: usize = 8;

/// A file being written under its temporary name; dropping it removes it.
#[derive(Debug)]
pub struct PartialFile {
    writer: BufWriter<File>,
    file: WholeFile,
}

impl PartialFile {
    /// Starts a file of a folder.
    pub(super) fn create(folder: &Path, name: &str) -> Result<Self, ReportError> {
        let temporary = folder.join(format!(".{name}{TEMPORARY}"));
        // what is there is removed, not written into: a link may lead anywhere
        let _ = fs::remove_file(&temporary);
        let created = File::create_new(&temporary);
        let created = created.map_err(ReportError::file(FileAction::Create, &temporary))?;
        let path = folder.join(name);
        Ok(Self {
            writer: BufWriter::with_capacity(1 << 16, created),
            file: WholeFile { temporary, path },
        })
    }

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

    /// Name that the file will have.
    pub(super) fn name(&self) -> String {
        let name = self.path.file_name().unwrap_or_default();
        name.to_string_lossy().into_owned()
    }

    /// The file, to have another name.
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

/// Sees that the content of files outlives a loss of power, several at a time, as the device does them in one go.
pub(super) fn sync_files<'a>(
    files: impl IntoIterator<Item = &'a WholeFile>,
) -> Result<(), ReportError> {
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
