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

/// Writes all files or, as far as the system allows, none: each is written
/// beside its place first, and all are renamed at the end. The folder is made
/// where it is missing.
pub(crate) fn write_all(folder: &Path, files: &[NewFile]) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|error| failure(folder, error))?;
    let mut written = Vec::with_capacity(files.len());
    for file in files {
        let beside = write_beside(folder, file).map_err(|error| failure(&file.path, error))?;
        written.push((file, beside));
    }
    for (file, beside) in written {
        beside
            .persist(&file.path)
            .map_err(|error| failure(&file.path, error.error))?;
    }
    Ok(())
}

fn write_beside(folder: &Path, file: &NewFile) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(".giveway-");
    // Files of this kind are private by default; a result is as open as any new file.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut beside = builder.tempfile_in(folder)?;
    beside.write_all(file.text.as_bytes())?;
    beside.flush()?;
    Ok(beside)
}

fn failure(path: &Path, error: io::Error) -> Failure {
    Failure::output(plain::text(&path.to_string_lossy()), error)
}
