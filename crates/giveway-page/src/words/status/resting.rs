//! The status where nothing runs: of a scene, with its plan if it has one.

use std::rc::Rc;

use giveway_solve::{SolveAnswer, Status};

use super::bounds::{known, with_bounds};
use super::{Badge, Standing};
use crate::front::Front;
use crate::words::costs::values;
use crate::words::{change, count};
use crate::{Answer, State};

/// Where the page stands with a scene and its plan, if it has one.
pub(super) fn resting(state: &State) -> Standing {
    let say = |badge, sentence| Standing { badge, sentence };
    if let Some(problem) = state.document.draft.problems().first()
        && state.document.fresh_answer().is_none()
    {
        let fault = format!("This cannot be solved: {}", problem.sentence);
        return say(Badge::Faulty, fault);
    }
    let Some(answer) = &state.document.answer else {
        return say(Badge::Draft, "No plan yet.".to_owned());
    };
    if state.document.is_stale() {
        let what = match answer.plan() {
            Some(_) => "The scene has changed since this plan. Solve again.",
            None => "The scene has changed. Solve again.",
        };
        return say(Badge::Stale, what.to_owned());
    }
    if answer.course.is_some() {
        let badge = match answer.solved.status {
            Status::Optimal => Badge::Adopted,
            _ => Badge::Stopped,
        };
        return say(badge, change::adopted(answer));
    }
    if let Some(front) = state.document.own_front() {
        return on_front(front, answer);
    }
    if answer.is_shared {
        return say(Badge::Shared, shared(answer));
    }
    let badge = match answer.solved.status {
        Status::Optimal => Badge::Proved,
        Status::Impossible => Badge::Impossible,
        Status::Feasible | Status::Unknown => Badge::Stopped,
    };
    say(badge, answered(answer))
}

/// `On the Pareto front of 3 plans: makespan 18, sum of costs 35.`
fn on_front(front: &Front, answer: &Rc<Answer>) -> Standing {
    let plans = count(front.points.len(), "plan");
    let costs = front.name(front.place_of(answer).unwrap_or_default());
    let (badge, what) = if front.is_whole() {
        (
            Badge::Proved,
            format!("On the Pareto front of {plans}: {costs}."),
        )
    } else {
        (
            Badge::Stopped,
            format!("On the Pareto front, {plans} so far: {costs}."),
        )
    };
    Standing {
        badge,
        sentence: what,
    }
}

/// `Not checked yet whether it is the best: makespan 18.`
fn shared(answer: &Answer) -> String {
    let objective = &answer.draft.scene().objective;
    let costs = answer.solved.costs;
    let costs = costs.map_or_else(String::new, |costs| values(objective, &costs));
    format!("This plan was shared: {costs}. Nobody has checked here whether it is the best.")
}

fn answered(answer: &Answer) -> String {
    let SolveAnswer {
        status,
        costs,
        bounds,
        within,
        complete,
        reason,
        ..
    } = &answer.solved;
    let objective = &answer.draft.scene().objective;
    let reason = reason.as_deref().map_or_else(String::new, sentence);
    let horizon = within.filter(|_| !complete);
    match (status, costs) {
        (Status::Optimal, Some(costs)) => {
            let values = values(objective, costs);
            match horizon {
                Some(within) => format!("Optimal within makespan {within}: {values}."),
                None => format!("Optimal: {values}."),
            }
        }
        (Status::Feasible, Some(costs)) => {
            let costs = with_bounds(objective, costs, bounds);
            format!("Best so far: {costs}. {reason}")
                .trim_end()
                .to_owned()
        }
        (Status::Impossible, _) => match horizon {
            Some(within) if reason.is_empty() => format!("No plan within makespan {within}."),
            Some(within) => format!("No plan within makespan {within}: {reason}"),
            None if reason.is_empty() => {
                "No plan exists, no matter how many steps you allow.".to_owned()
            }
            None => format!("No plan exists, no matter how many steps you allow: {reason}"),
        },
        _ => {
            let known = known(objective, bounds, None);
            let said = match known.as_str() {
                "" => String::new(),
                known => format!(" Proved so far: {known}."),
            };
            let reason = match reason.as_str() {
                "" => "Time ran out.",
                reason => reason,
            };
            format!("{reason} There may be a plan; none was found yet.{said}")
        }
    }
}

/// With a full stop at its end.
fn sentence(text: &str) -> String {
    let text = text.trim();
    if text.is_empty() || text.ends_with(['.', '!', '?']) {
        text.to_owned()
    } else {
        format!("{text}.")
    }
}
