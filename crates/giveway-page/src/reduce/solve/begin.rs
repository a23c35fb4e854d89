//! A solve begins: with what a search before it left, under the limits that are set.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Question, tr_data};
use giveway_solve::plan::Planner;
use giveway_solve::{Limits, SolveRequest, Status};

use super::tightened;
use super::time::seconds;
use crate::front::has_front;
use crate::problems::Problem;
use crate::reduce::{ask, change, inside, stroke};
use crate::{Activity, Answer, Arrival, Notice, Size, Solving, State, Task};

/// How a solve begins.
pub(in crate::reduce) struct Start {
    arrival: Arrival,
    then: Option<Question>,
    planner: Option<Planner>,
}

impl Start {
    /// A person asked for it.
    pub(in crate::reduce) fn step() -> Self {
        Self {
            arrival: Arrival::Step,
            then: None,
            planner: None,
        }
    }

    /// A person asked for the plan of a planner.
    pub(in crate::reduce) fn by(planner: Planner) -> Self {
        Self {
            planner: Some(planner),
            ..Self::step()
        }
    }

    /// It belongs to the step before.
    pub(in crate::reduce) fn quiet() -> Self {
        Self {
            arrival: Arrival::Quiet,
            ..Self::step()
        }
    }

    /// A link was opened: what it holds is proved, and its question asked.
    pub(in crate::reduce) fn of_link(then: Option<Question>) -> Self {
        Self {
            then,
            ..Self::quiet()
        }
    }
}

/// Solves the scene; in other modes, what is to be solved there.
pub(in crate::reduce) fn start(state: &mut State, how: Start) {
    stroke::release(state);
    if how.planner.is_some() && !state.can_plan() {
        return ask::refuse(
            state,
            tr_data!(
                "Planners plan a scene from time 0. Finish or discard what you do with this plan first."
            ),
        );
    }
    match state.document.mode.activity {
        Activity::Changing(_) | Activity::Comparing(_) => return change::adapt(state),
        Activity::Steering(_) => return ask::ask(state, &Question::Plan),
        Activity::Editing | Activity::Auditing(_) => {}
    }
    if let Some(at) = state.document.changed_last() {
        if how.planner.is_none() && how.arrival == Arrival::Step {
            // This plan is improved, in the world around it.
            return ask::ask(state, &Question::Plan);
        }
        // It would put a plan of the scene before the changes in the place of this one.
        return ask::refuse(
            state,
            tr_data!(
                "This plan went on after a change at time {at}. A new plan from time 0 would drop that change: undo it first.",
                at
            ),
        );
    }
    let draft = &state.document.draft;
    if draft.instance().is_err() {
        let problems = draft.problems().iter();
        state.view.notice = Some(
            Notice::refusal(tr_data!("The scene cannot be solved as it is."))
                .with(problems.map(Problem::sentence)),
        );
        return;
    }
    let better = better_beside(state);
    ask::close(state);
    state.view.notice = None;
    state.view.playback.playing = false;
    let document = &state.document;
    // What a search that was cut off left is not lost.
    let is_open = |answer: &&Rc<Answer>| {
        let is_open = matches!(answer.solved.status, Status::Feasible | Status::Unknown);
        is_open && answer.course.is_none()
    };
    let audit = document.mode.audit();
    let known = match audit {
        Some(audit) => audit.ours.as_ref(),
        None => better.as_ref().or(document.fresh_answer()),
    };
    let goes_on = how.planner.is_none();
    let from = known.filter(|_| goes_on).filter(is_open).cloned();
    // A legal plan of elsewhere is where the search begins.
    let dropped = audit.filter(|audit| audit.plan.is_legal());
    let dropped = dropped.and_then(|audit| audit.plan.answer.plan());
    let request = SolveRequest {
        scene: document.draft.scene().clone(),
        pareto: goes_on
            && audit.is_none()
            && state.settings.front
            && has_front(&document.draft.scene().objective),
        within: document.within,
        start: from
            .as_ref()
            .and_then(|from| from.solved.plan.as_ref())
            .or(dropped)
            .cloned(),
        trace: goes_on && audit.is_none(),
        limits: Limits {
            seconds: Some(seconds(state, from.as_deref())),
            ..Limits::default()
        },
        ..SolveRequest::default()
    };
    let request = SolveRequest {
        trace: request.trace && !request.pareto,
        ..request
    };
    let is_search = how.planner.is_none();
    state.work.start(Task::Solve(Solving {
        draft: Rc::clone(&document.draft),
        request: Rc::new(request),
        bounds: match &from {
            Some(from) => from.solved.bounds.clone(),
            None if goes_on && audit.is_none() => tightened::bounds(document),
            None => BTreeMap::new(),
        },
        best: from.as_ref().and_then(|from| from.solved.costs),
        plan: None,
        preview: None,
        planner: how.planner,
        from,
        trace: None,
        size: Size::default(),
        then: how.then,
        arrival: how.arrival,
    }));
    if is_search {
        inside::begin(state);
    }
}

/// The other plan of a question, where it is open and costs less than the one that was asked about:
/// the search goes on with that one.
fn better_beside(state: &State) -> Option<Rc<Answer>> {
    let asking = state.document.mode.asking()?;
    let is_better = asking.is_bettered() && state.document.mode.audit().is_none();
    state.opened().filter(|_| is_better).cloned()
}
