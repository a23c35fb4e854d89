//! The solver against a second one, and against its budgets.

mod budget;
mod cores;
pub(super) mod either;
mod places;
mod second;
mod session;

/// What [`Sat`](super::Sat) does beside asking varisat.
#[derive(Clone, Copy)]
pub(super) struct Care {
    /// Cores count only once they are verified.
    pub(super) verify: bool,
    /// No variable of the formula takes a place that another one left.
    pub(super) placeholders: bool,
}

impl Care {
    const ALL: Self = Self {
        verify: true,
        placeholders: true,
    };
    const VERIFY: Self = Self {
        verify: true,
        placeholders: false,
    };
    const NONE: Self = Self {
        verify: false,
        placeholders: false,
    };
}
