//! What is shown of the document: which answer, which plan, up to which time.

use std::rc::Rc;

use giveway_model::{Costs, Plan};

use crate::audit::Beside;
use crate::planners::Runs;
use crate::rules::clash_times;
use crate::steering::Steering;
use crate::{Activity, Answer, Draft, Solving, State, Tab, Task};

impl State {
    /// Whether more of an answer to the question is being looked for.
    pub fn is_looking(&self) -> bool {
        matches!(self.work.task(), Some(Task::Explain(_)))
    }

    /// The answer that is shown: the last one, or the best so far of a search that
    /// goes on; a plan of one's own; the other plan of a question where that takes
    /// its place; the one that is previewed where the world changes.
    pub fn shown(&self) -> Option<&Rc<Answer>> {
        let is_alone = !self.view.is_wide && !self.hides_answers();
        let without = self.plan_without().map(|without| &without.answer);
        let other = self.farthest().or(without).filter(|_| is_alone);
        let in_place = self.plan_in_place().map(|without| &without.answer);
        let other = other.or(in_place);
        let late = self.late_plan();
        let known = self
            .inside_plan()
            .or_else(|| self.so_far())
            .or(late)
            .or(other);
        known.or_else(|| self.document.shown(is_alone))
    }

    /// The best plan so far of a search that goes on, where the board shows it.
    pub fn so_far(&self) -> Option<&Rc<Answer>> {
        let run = self.work.solving()?;
        let is_shown = self.document.mode.is_editing();
        run.preview.as_ref().filter(|_| is_shown)
    }

    /// The search whose bounds stand where the lanes will be: no plan had lanes before it
    /// began. Meanwhile there are no tabs either.
    pub fn awaited(&self) -> Option<&Solving> {
        let is_new = self.so_far().is_some() && self.document.fresh_answer().is_none();
        let waits = (is_new || self.playing().is_none()) && !self.is_inside();
        self.work.solving().filter(|_| waits)
    }

    /// Whether the timeline has something to show: a plan, what is looked into, or the times of
    /// rules that leave no plan. Without it a phone has no tabs.
    pub fn has_timeline(&self) -> bool {
        let has_times = || self.plan().is_some() || clash_times(self).is_some();
        self.is_inside() || (self.awaited().is_none() && has_times())
    }

    /// The tab that a phone shows: without a plan there is no table of it.
    pub fn shown_tab(&self) -> Tab {
        match self.view.tab {
            Tab::Plan if self.plan().is_none() => Tab::Inspector,
            tab => tab,
        }
    }

    /// Whether the board shows a plan that is gone when the page is opened again: one of
    /// another planner's order or tree, of a search that goes on, the late or the farthest one.
    pub(crate) fn shows_passing(&self) -> bool {
        let late = self.late_plan();
        let passing = [self.inside_plan(), self.so_far(), late, self.farthest()];
        passing.iter().any(Option::is_some)
    }

    /// Whether the answer that is shown is of a draft before the last edit.
    pub fn shows_stale(&self) -> bool {
        self.so_far().is_none() && self.document.is_stale()
    }

    /// The answer that is shown beside that one: the other plan of a question,
    /// where there is room for it; or that of another planner.
    pub fn beside(&self) -> Option<&Rc<Answer>> {
        if self.is_inside() || self.hides_answers() {
            return None;
        }
        let mode = &self.document.mode;
        let other = match &mode.activity {
            _ if mode.asking().is_some() => self.opened(),
            Activity::Editing if self.farthest().is_some() => self.farthest(),
            Activity::Editing if self.open_before().is_some() => self.open_before(),
            Activity::Editing if self.plan_in_place().is_some() => None,
            Activity::Editing if self.plan_without().is_some() => {
                self.plan_without().map(|without| &without.answer)
            }
            Activity::Editing => {
                let runs = Runs::fresh(&self.document)?;
                let this = self.document.answer.as_ref();
                let is_other = |other: &&Rc<Answer>| this.is_some_and(|a| !Rc::ptr_eq(a, other));
                runs.plan(self.view.versus?).filter(is_other)
            }
            Activity::Auditing(audit) if audit.beside != Beside::Nothing => audit.other(),
            Activity::Auditing(_)
            | Activity::Changing(_)
            | Activity::Comparing(_)
            | Activity::Steering(_) => None,
        };
        other.filter(|_| self.view.is_wide)
    }

    /// The other plan of a question, where it was opened; before a room it always is.
    pub(crate) fn opened(&self) -> Option<&Rc<Answer>> {
        let asking = self.document.mode.asking()?;
        let is_opened = asking.shows_other || self.is_presented();
        asking.other.as_ref().filter(|_| is_opened)
    }

    /// The best plan before a cell was closed for a look, where there is one without
    /// it to look at, too.
    pub(crate) fn open_before(&self) -> Option<&Rc<Answer>> {
        let closed = self.closed_cell()?;
        let is_found = self.document.plan().is_some();
        is_found.then_some(&closed.before)
    }

    /// The scene on the board of an answer: a cell that is closed for a look is open on
    /// that of the plan before.
    pub fn world_of(&self, answer: Option<&Rc<Answer>>) -> &Rc<Draft> {
        let without = self.plan_without().map(|without| &without.answer);
        let before = self.open_before().or(without).zip(answer);
        match before.filter(|(before, answer)| Rc::ptr_eq(before, answer)) {
            Some((before, _)) => &before.draft,
            None => self.world(),
        }
    }

    /// The plan that is shown, stale or not.
    pub fn plan(&self) -> Option<&Plan> {
        self.shown()?.plan()
    }

    /// The plan that plays: the one that is shown, if any agent on the board has a
    /// part in it.
    pub fn playing(&self) -> Option<&Rc<Answer>> {
        self.shown().filter(|answer| self.plays(answer))
    }

    /// Whether an answer has a plan in which any agent on the board has a part.
    pub(crate) fn plays(&self, answer: &Answer) -> bool {
        let draft = &self.document.draft;
        let mut agents = 0..draft.agents().len();
        let has_part = answer.course.is_some()
            || answer.agents().is_empty()
            || agents.any(|agent| answer.agent(draft, agent).is_some());
        answer.plan().is_some() && has_part
    }

    /// The costs of the plan that plays while a search goes on; those of the best plan so far
    /// where none plays.
    pub(crate) fn playing_costs(&self) -> Option<Costs> {
        let playing = self.playing().filter(|_| !self.shows_stale());
        let playing = playing.and_then(|answer| answer.solved.costs);
        playing.or_else(|| self.work.solving()?.best)
    }

    /// The same, where the search knows a better plan already: that one comes to the board
    /// when no robot would jump.
    pub(crate) fn playing_before_best(&self) -> Option<Costs> {
        let best = self.work.solving()?.best?;
        self.playing_costs().filter(|&playing| playing != best)
    }

    /// The last time that can be shown, in steps.
    pub fn last_time(&self) -> u32 {
        let mode = &self.document.mode;
        match &mode.activity {
            Activity::Changing(changing) => return changing.at,
            Activity::Comparing(comparing) => {
                let preview = comparing.preview();
                return preview.map_or(comparing.changing.at, |answer| answer.makespan());
            }
            Activity::Editing | Activity::Steering(_) | Activity::Auditing(_) => {}
        }
        let both = self.playing().into_iter().chain(self.beside());
        let led = mode.steering().map(|own| Steering::time(own));
        let ends = both.map(|answer| answer.makespan()).chain(led);
        ends.max().unwrap_or(0)
    }
}
