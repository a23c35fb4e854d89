//! The status where nothing runs: of a scene, with its plan if it has one.

use std::rc::Rc;

use giveway_model::tr;
use giveway_model::words::sentence;
use giveway_solve::Status;
use giveway_solve::words::{headline, reason};

use super::{Badge, Standing};
use crate::front::Front;
use crate::lesson::{Lesson, Revealed};
use crate::words::change;
use crate::words::costs::values;
use crate::{Activity, Answer, State, planners, rules};

/// Where the page stands with a scene and its plan, if it has one.
pub(super) fn resting(state: &State) -> Standing {
    let say = Standing::new;
    if let Some(problem) = state.document.draft.problems().first()
        && state.document.fresh_answer().is_none()
    {
        let fault = tr!(
            "This cannot be solved: {problem}",
            problem = problem.sentence()
        );
        return say(Badge::Faulty, fault);
    }
    let Some(answer) = &state.document.answer else {
        // A lesson has judged what was painted.
        let is_judged = state
            .lesson()
            .is_some_and(|lesson| !lesson.sealed.is_empty());
        let none = if is_judged {
            tr!("What comes of it is told in the lesson.")
        } else {
            tr!("No plan yet.")
        };
        return say(Badge::Draft, none.to_owned());
    };
    if state.document.is_stale() {
        if let Some(broken) = rules::outdated(state) {
            return say(Badge::Stale, broken);
        }
        let what = match answer.plan() {
            Some(_) => tr!("The scene has changed since this plan. Solve again."),
            None => tr!("The scene has changed. Solve again."),
        };
        return say(Badge::Stale, what.to_owned());
    }
    if answer.course.is_some() {
        let badge = match answer.solved.status {
            Status::Optimal => Badge::Adopted,
            _ if answer.is_shared => Badge::Shared,
            _ if !answer.is_searched() => Badge::Found,
            _ => Badge::Stopped,
        };
        let mut sentence = change::adopted(answer);
        if !answer.is_searched() {
            sentence = format!("{sentence} {}", open(answer));
        }
        return say(badge, sentence);
    }
    if let Some(front) = state.document.own_front() {
        return on_front(front, answer);
    }
    if answer.is_shared {
        return say(Badge::Shared, shared(answer));
    }
    if let Some(planner) = answer.by {
        let badge = match answer.solved.status {
            Status::Optimal => Badge::Proved,
            _ => Badge::Found,
        };
        return say(
            badge,
            planners::sentence(planner, answer, planners::least(&state.document)),
        );
    }
    if !answer.is_searched() {
        let costs = costs(answer);
        let open = open(answer);
        return say(Badge::Found, tr!("A plan: {costs}. {open}", costs, open));
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
    let plans = front.points.len();
    let costs = front.name(front.place_of(answer).unwrap_or_default());
    let (badge, what) = if front.is_whole() {
        (
            Badge::Proved,
            tr!(
                "On the Pareto front of {n} plan: {costs}."
                    | "On the Pareto front of {n} plans: {costs}." % plans,
                costs
            ),
        )
    } else {
        (
            Badge::Stopped,
            tr!(
                "On the Pareto front, {n} plan so far: {costs}."
                    | "On the Pareto front, {n} plans so far: {costs}." % plans,
                costs
            ),
        )
    };
    Standing::new(badge, what)
}

/// The plan of a lesson: what it costs, and nothing that a person is to find.
pub(super) fn of_lesson(lesson: &Lesson, state: &State) -> Option<Standing> {
    let say = |sentence: String| Some(Standing::new(Badge::Found, sentence));
    if lesson.hides_conflicts() && state.audit().is_some() {
        return say(tr!("Does this plan keep the rules?").to_owned());
    }
    if let Activity::Changing(changing) = &state.document.mode.activity {
        return say(change::happening(changing));
    }
    if let Some(without) = state.plan_in_place() {
        let costs = costs(&without.answer);
        let n = without.rule + 1;
        return say(tr!("Without rule {n} there is a plan: {costs}.", n, costs));
    }
    let answer = state.document.fresh_answer();
    let answer = answer.filter(|answer| answer.is_shared && state.audit().is_none())?;
    if answer.course.is_some() {
        return say(change::adopted(answer));
    }
    let objective = &answer.draft.scene().objective;
    let costs = values(objective, &answer.solved.costs?);
    if lesson.revealed == Revealed::Best {
        return Some(Standing::new(
            Badge::Proved,
            tr!("The best plan: {costs}.", costs),
        ));
    }
    say(tr!("A plan: {costs}.", costs))
}

/// `Not checked yet whether it is the best: makespan 18.`
fn shared(answer: &Answer) -> String {
    tr!(
        "This plan was shared: {costs}. Nobody has checked here whether it is the best.",
        costs = costs(answer)
    )
}

/// The costs of a plan by the objective.
fn costs(answer: &Answer) -> String {
    let objective = &answer.draft.scene().objective;
    let costs = answer.solved.costs;
    costs.map_or_else(String::new, |costs| values(objective, &costs))
}

/// What is known of a plan of which no search said whether it is the best.
fn open(answer: &Answer) -> String {
    match &answer.solved.reason {
        Some(given) => sentence(&reason(given)),
        None => tr!("Nobody has checked here whether it is the best.").to_owned(),
    }
}

fn answered(answer: &Answer) -> String {
    let objective = &answer.draft.scene().objective;
    headline(objective, &answer.solved).to_string()
}
