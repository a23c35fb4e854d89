//! How much is read of a file.

use giveway_model::MAX_AGENTS;
use giveway_model::{Fault, tr};

/// The longest text that a reader takes, in bytes.
pub const MAX_TEXT_BYTES: usize = 100_000_000;

/// The most steps that a plan may have, all agents together. A run length such
/// as `999999999r` is short to write and long to walk.
pub const MAX_STEPS: usize = 24_000_000;

/// Refuses something; whoever knows its place adds that.
pub(crate) fn refuse<T>(found: impl Into<String>, expected: impl Into<String>) -> Result<T, Fault> {
    Err(Fault::at("", found, expected))
}

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
            let found = tr!("a plan of over {most} steps", most = MAX_STEPS);
            return refuse(
                found,
                tr!("at most {most} steps of all robots", most = MAX_STEPS),
            );
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
        let found = tr!("over {most} robots", most = MAX_AGENTS);
        return refuse(found, tr!("at most {most}", most = MAX_AGENTS));
    }
    Ok(())
}
