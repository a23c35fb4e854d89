//! Where the files of `convert` go, and that they hurt nothing there.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::{failure::Failure, output::files::NewFile};

/// The files in their folder.
///
/// # Errors
/// When two of them would have one name.
pub(super) fn place(folder: &Path, files: Vec<NewFile>) -> Result<Vec<NewFile>, Failure> {
    let mut seen = BTreeSet::new();
    let mut placed = Vec::with_capacity(files.len());
    for file in files {
        let path = folder.join(&file.path);
        if !seen.insert(path.clone()) {
            return Err(Failure::Usage(format!(
                "found two files to be written to {}, expected names that differ",
                path.display()
            )));
        }
        placed.push(NewFile { path, ..file });
    }
    Ok(placed)
}

/// Makes sure that no file that was read is overwritten. The folder must be
/// there by now: only then can its path be compared with others.
///
/// # Errors
/// When one would be.
pub(super) fn spare(read: &[PathBuf], files: &[NewFile]) -> Result<(), Failure> {
    let real = |path: &PathBuf| fs::canonicalize(path).ok();
    let read: BTreeSet<PathBuf> = read.iter().filter_map(real).collect();
    match files
        .iter()
        .find(|file| real(&file.path).is_some_and(|path| read.contains(&path)))
    {
        None => Ok(()),
        Some(file) => Err(Failure::Usage(format!(
            "{} is an input file and would be overwritten, expected another folder for --output",
            file.path.display()
        ))),
    }
}
