//! Breakdowns that go on when an instance begins.
//!
//! No scene has one: the rest of a plan after a change is an instance whose
//! agents may be held where they are.

use super::Instance;

/// A breakdown: until its end, the agent begins no move.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Breakdown {
    /// The agent's name.
    pub agent: String,
    /// The time at which it began, in steps of the whole plan.
    pub from: u32,
    /// The time of the whole plan from which the agent may go on.
    pub to: u32,
    /// The same end in the times of the instance, which begin at 0.
    pub held: u32,
}

impl Instance {
    /// The same instance with breakdowns that go on when it begins.
    #[must_use]
    pub fn with_breakdowns(mut self, breakdowns: Vec<Breakdown>) -> Self {
        self.breakdowns = breakdowns;
        self
    }

    /// The breakdowns that go on when it begins.
    pub fn breakdowns(&self) -> &[Breakdown] {
        &self.breakdowns
    }

    /// The time before which an agent begins no move; 0 without a breakdown.
    pub fn held(&self, agent: &str) -> u32 {
        let own = self.breakdowns.iter().filter(|it| it.agent == agent);
        own.map(|breakdown| breakdown.held).max().unwrap_or(0)
    }

    /// Leaves out breakdowns.
    pub fn retain_breakdowns(&mut self, keep: impl FnMut(&Breakdown) -> bool) {
        self.breakdowns.retain(keep);
    }
}
