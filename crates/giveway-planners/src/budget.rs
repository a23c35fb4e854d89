//! Cooperative cancellation: limits that a search asks often whether to go on.

mod counted;
mod held;
mod stop;

use std::rc::Rc;

pub(crate) use counted::CountedBudget;
pub use held::{HeldBytes, MemoryUse};
pub(crate) use stop::MOST_TIMES;
pub use stop::Stop;

/// The budget of one request: it never decides anything but to stop.
pub trait Budget {
    /// Whether to go on; once it says no, it says no for good.
    ///
    /// # Errors
    /// Why not.
    fn check(&self) -> Result<(), Stop>;

    /// Counts one state. As [`Budget::check`], but may look at a clock only now and
    /// then: for inner loops.
    ///
    /// # Errors
    /// Why not.
    fn tick(&self) -> Result<(), Stop>;

    /// Counts the work of so many states that no [`Budget::tick`] counted, and asks
    /// whether to go on.
    ///
    /// # Errors
    /// Why not.
    fn spend(&self, states: u64) -> Result<(), Stop>;

    /// The bytes that all parts of the request hold together.
    fn held_bytes(&self) -> &HeldBytes;

    /// Counts memory for as long as what is returned is there, in bytes.
    fn hold(&self, bytes: usize) -> MemoryUse {
        MemoryUse::new(self.held_bytes(), bytes)
    }

    /// Counts further memory of something, in bytes.
    fn hold_more(&self, held: &mut MemoryUse, bytes: usize) {
        held.more(self.held_bytes(), bytes);
    }
}

impl<B: Budget + ?Sized> Budget for Rc<B> {
    fn check(&self) -> Result<(), Stop> {
        (**self).check()
    }

    fn tick(&self) -> Result<(), Stop> {
        (**self).tick()
    }

    fn spend(&self, states: u64) -> Result<(), Stop> {
        (**self).spend(states)
    }

    fn held_bytes(&self) -> &HeldBytes {
        (**self).held_bytes()
    }
}

/// A budget without limits.
#[derive(Clone, Debug, Default)]
pub struct Unlimited {
    held: HeldBytes,
}

impl Budget for Unlimited {
    fn check(&self) -> Result<(), Stop> {
        Ok(())
    }

    fn tick(&self) -> Result<(), Stop> {
        Ok(())
    }

    fn spend(&self, _states: u64) -> Result<(), Stop> {
        self.check()
    }

    fn held_bytes(&self) -> &HeldBytes {
        &self.held
    }
}
