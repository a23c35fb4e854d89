//! What changes while a plan runs.

use std::path::Path;

use giveway_model::{
    Fault,
    change::Changes,
    format::native::{in_text, read_changes},
};

use super::Source;
use crate::failure::Failure;

/// Changes, with the text in which faults have their places.
pub(crate) struct ChangesFile {
    source: Source,
    /// What was read.
    pub(crate) changes: Changes,
}

impl ChangesFile {
    /// A failure because the changes contradict the world.
    pub(crate) fn refused(&self, faults: Vec<Fault>) -> Failure {
        self.source.faults(in_text(&self.source.text, faults))
    }
}

/// Reads changes.
///
/// # Errors
/// When the file is no list of changes.
pub(crate) fn changes(path: &Path) -> Result<ChangesFile, Failure> {
    let source = Source::read(path)?;
    match read_changes(&source.text) {
        Ok(changes) => Ok(ChangesFile { source, changes }),
        Err(fault) => Err(source.fault(fault)),
    }
}
