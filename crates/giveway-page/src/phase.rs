//! Where the page stands.

use giveway_solve::Status;

use crate::front::Front;
use crate::{State, Work};

/// The states of the page's specification, as far as they are built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// No answer, or a stale one.
    Editing,
    /// The solver works.
    Solving,
    /// A question is being answered.
    Asking,
    /// A proof is being checked.
    Checking,
    /// What changes in the world is being listed.
    Changing,
    /// Ways to go on are being looked for.
    Adapting,
    /// Ways to go on are side by side.
    Comparing,
    /// An agent is led by hand.
    Steering,
    /// There is a plan, with a proof that none is better.
    Planned,
    /// There is no plan, with a proof.
    None,
    /// The budget ran out; there may be a plan.
    Stopped,
}

impl State {
    /// Where the page stands.
    pub fn phase(&self) -> Phase {
        match self.work {
            Work::Solving(_) => return Phase::Solving,
            Work::Asking(_) => return Phase::Asking,
            Work::Certifying(_) => return Phase::Checking,
            Work::Adapting(_) => return Phase::Adapting,
            Work::Idle => {}
        }
        if let Some(changing) = &self.changing {
            return match changing.compared {
                None => Phase::Changing,
                Some(_) => Phase::Comparing,
            };
        }
        if self.steering.is_some() {
            return Phase::Steering;
        }
        if self.own_front().is_some_and(Front::is_whole) {
            return Phase::Planned;
        }
        match self.fresh_answer().map(|answer| answer.solved.status) {
            None => Phase::Editing,
            Some(Status::Optimal) => Phase::Planned,
            Some(Status::Impossible) => Phase::None,
            Some(Status::Feasible | Status::Unknown) => Phase::Stopped,
        }
    }
}
