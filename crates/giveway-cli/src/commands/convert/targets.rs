//! Where the files of `convert` go, and that they hurt nothing there.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::{failure::Failure, output::files::NewFile};

/// The files in their folder.
///
/// # Errors
/// When two of them would have one name, or one would overwrite a file that
/// was read.
pub(super) fn place(
    folder: &Path,
    files: Vec<NewFile>,
    read: &[PathBuf],
) -> Result<Vec<NewFile>, Failure> {
    let read: BTreeSet<PathBuf> = read
        .iter()
        .filter_map(|path| fs::canonicalize(path).ok())
        .collect();
    let mut seen = BTreeSet::new();
    let mut placed = Vec::with_capacity(files.len());
    for file in files {
        let path = folder.join(&file.path);
        if fs::canonicalize(&path).is_ok_and(|path| read.contains(&path)) {
            return Err(Failure::Usage(format!(
                "{} is read and would be overwritten, expected another folder for --output",
                path.display()
            )));
        }
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
