//! How much is read of a file.

use crate::Fault;
use crate::instance::MAX_AGENTS;

/// The longest text that a reader takes, in bytes.
pub const MAX_TEXT_BYTES: usize = 100_000_000;

/// The most steps that a plan may have, all agents together. A run length such
/// as `999999999r` is short to write and long to walk.
pub const MAX_STEPS: usize = 24_000_000;

/// Counts the steps of a plan while it is read.
#[derive(Debug, Default)]
pub(crate) struct Steps(usize);

impl Steps {
    /// Counts some more steps.
    ///
    /// # Errors
    /// When there are more than [`MAX_STEPS`]; the fault has no place yet.
    pub(crate) fn add(&mut self, steps: usize) -> Result<(), Fault> {
        self.0 = self.0.saturating_add(steps);
        if self.0 > MAX_STEPS {
            let found = format!("a plan of over {MAX_STEPS} steps");
            return Err(Fault::at(
                "",
                found,
                format!("at most {MAX_STEPS} steps of all robots"),
            ));
        }
        Ok(())
    }
}

/// Whether a plan has no more agents than an instance may have. Ask before there
/// is room for them: an agent may take a byte of a text.
///
/// # Errors
/// When there are more; the fault has no place yet.
pub(crate) fn robots(agents: usize) -> Result<(), Fault> {
    if agents > MAX_AGENTS {
        let found = format!("over {MAX_AGENTS} robots");
        return Err(Fault::at("", found, format!("at most {MAX_AGENTS}")));
    }
    Ok(())
}
