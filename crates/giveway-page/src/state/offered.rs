//! What could be begun at the time shown: a change of the world, leading an agent.

use std::rc::Rc;

use crate::edit::fresh_name;
use crate::steering::Steering;
use crate::{Activity, Answer, State};

impl State {
    /// Whether a planner could plan the scene: nothing else is done with a plan.
    pub const fn can_plan(&self) -> bool {
        matches!(self.document.mode.activity, Activity::Editing)
    }

    /// Whether the world could change at the time shown: there is a plan, and
    /// nothing has changed then or later yet. A lesson has its own ways to go on.
    pub fn can_change(&self) -> bool {
        if self.lesson().is_some() || self.late_plan().is_some() {
            return false;
        }
        let document = &self.document;
        let answer = document
            .fresh_answer()
            .filter(|answer| answer.plan().is_some());
        let is_later = |answer: &Rc<Answer>| {
            let last = answer.changed_last();
            last.is_none_or(|last| self.view.playback.time > last)
        };
        let can_begin = match document.mode.activity {
            Activity::Editing | Activity::Auditing(_) => true,
            Activity::Changing(_) | Activity::Comparing(_) | Activity::Steering(_) => false,
        };
        can_begin && answer.is_some_and(is_later)
    }

    /// The agent that could be led by hand from the time shown: the one that is
    /// selected, where there is a plan of the scene in one world.
    pub fn can_steer(&self) -> Option<usize> {
        let agent = self
            .selected_agent()
            .filter(|_| self.late_plan().is_none())?;
        let time = self.view.playback.time;
        let can = match &self.document.mode.activity {
            Activity::Steering(own) => own.agent != agent || time < own.time(),
            Activity::Editing | Activity::Auditing(_) => {
                let answer = self.document.fresh_answer();
                answer.is_some_and(|answer| Steering::can_begin(answer, agent, time))
            }
            Activity::Changing(_) | Activity::Comparing(_) => false,
        };
        can.then_some(agent)
    }

    /// The name of the next agent.
    pub fn next_name(&self) -> String {
        match self.document.mode.changing() {
            Some(changing) => changing.fresh_name(),
            None => fresh_name(self.document.draft.scene()),
        }
    }
}
