//! Where the page stands.

use giveway_solve::Status;

use crate::front::Front;
use crate::{Activity, Answer, State, Task};

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
    /// What all best plans share is being looked for.
    Counting,
    /// What changes in the world is being listed.
    Changing,
    /// Ways to go on are being looked for.
    Adapting,
    /// Ways to go on are side by side.
    Comparing,
    /// An agent is led by hand.
    Steering,
    /// A plan of elsewhere is judged.
    Auditing,
    /// There is a plan, with a proof that none is better.
    Planned,
    /// There is a plan, and no search said whether it is the best: of a planner, or from
    /// elsewhere.
    Found,
    /// There is no plan, with a proof.
    None,
    /// The budget ran out; there may be a plan.
    Stopped,
}

impl State {
    /// Where the page stands.
    pub fn phase(&self) -> Phase {
        match self.work.task() {
            Some(Task::Solve(_)) => return Phase::Solving,
            Some(Task::Explain(_)) => return Phase::Asking,
            Some(Task::Certify(_) | Task::Export(_)) => return Phase::Checking,
            Some(Task::Freedom(_) | Task::Delays(_)) => return Phase::Counting,
            Some(Task::Change(_)) => return Phase::Adapting,
            Some(Task::Look(_) | Task::Price(..) | Task::Sizing(_) | Task::Order(_)) | None => {}
        }
        self.resting_phase()
    }

    /// Where the page would stand if nothing ran.
    pub fn resting_phase(&self) -> Phase {
        match self.document.mode.activity {
            Activity::Changing(_) => return Phase::Changing,
            Activity::Comparing(_) => return Phase::Comparing,
            Activity::Steering(_) => return Phase::Steering,
            Activity::Auditing(_) => return Phase::Auditing,
            Activity::Editing => {}
        }
        if self.document.own_front().is_some_and(Front::is_whole) {
            return Phase::Planned;
        }
        let answer = self.document.fresh_answer();
        // The search for a front was stopped where that is not whole.
        let is_point = self.document.own_front().is_some();
        let is_open = |answer: &Answer| answer.by.is_some() || !answer.is_searched();
        let is_found = !is_point && answer.is_some_and(|answer| is_open(answer));
        match answer.map(|answer| answer.solved.status) {
            Some(Status::Feasible) if is_found => Phase::Found,
            None => Phase::Editing,
            Some(Status::Optimal) => Phase::Planned,
            Some(Status::Impossible) => Phase::None,
            Some(Status::Feasible | Status::Unknown) => Phase::Stopped,
        }
    }
}
