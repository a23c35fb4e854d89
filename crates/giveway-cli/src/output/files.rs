//! Files, written whole or not at all.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use super::plain;
use crate::failure::Failure;

/// A file to write.
#[derive(Debug)]
pub(crate) struct NewFile {
    /// Where it goes.
    pub(crate) path: PathBuf,
    /// What stands in it.
    pub(crate) text: String,
}

/// Makes a folder, and those above it, where it is missing.
pub(crate) fn make_folder(folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|error| failure(folder, error))
}

/// Writes all files or, as far as the system allows, none: each is written
/// beside its place first, and all are renamed at the end. Their folders must
/// be there.
pub(crate) fn write_all(files: &[NewFile]) -> Result<(), Failure> {
    let mut written = Vec::with_capacity(files.len());
    for file in files {
        let beside = write_beside(file).map_err(|error| failure(&file.path, error))?;
        written.push((file, beside));
    }
    for (file, beside) in written {
        beside
            .persist(&file.path)
            .map_err(|error| failure(&file.path, error.error))?;
    }
    Ok(())
}

/// Writes one file, of any kind, whole or not at all. Its folder must be there.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let beside = beside(path, bytes).map_err(|error| failure(path, error))?;
    let kept = beside.persist(path);
    kept.map_err(|error| failure(path, error.error)).map(drop)
}

fn write_beside(file: &NewFile) -> io::Result<NamedTempFile> {
    beside(&file.path, file.text.as_bytes())
}

fn beside(path: &Path, bytes: &[u8]) -> io::Result<NamedTempFile> {
    let folder = path.parent().filter(|it| !it.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new("."));
    let mut builder = Builder::new();
    builder.prefix(".giveway-");
    // Files of this kind are private by default; a result is as open as any new file.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    // What goes wrong is told without the name of the file beside.
    let told = |error: io::Error| fs::metadata(folder).err().unwrap_or(error.kind().into());
    let mut beside = builder.tempfile_in(folder).map_err(told)?;
    beside.write_all(bytes)?;
    beside.flush()?;
    Ok(beside)
}

fn failure(path: &Path, error: io::Error) -> Failure {
    Failure::output(plain::text(&path.to_string_lossy()), error)
}
