//! What is said where there is nothing to look into, and of the step for those who
//! listen.

use giveway_model::tr;
use giveway_solve::Status;
use giveway_solve::plan::Planner;

use super::{InsideAction, Method, by_hand, column, crowd, proof};
use crate::planners::{By, Runs};
use crate::{Action, SolveAction, State, Task};

/// What is said where there is nothing to look into.
#[derive(Clone, Debug, PartialEq)]
pub struct Nothing {
    /// In short.
    pub title: &'static str,
    /// What to do.
    pub text: String,
    /// A button: its words, and what it does.
    pub action: Option<(&'static str, Action)>,
}

/// What is said; where something runs, that it does.
pub fn nothing(state: &State) -> Nothing {
    let is_looking = matches!(state.work.task(), Some(Task::Look(_)));
    let is_ready = state.document.draft.instance().is_ok();
    let say = |title, text: &str, action| Nothing {
        title,
        text: text.to_owned(),
        action,
    };
    let cancel = || Some((tr!("Stop"), Action::Solve(SolveAction::Cancel)));
    if let Some(at) = state.document.changed_last() {
        return after_change(state.inside.method, at);
    }
    match state.inside.method {
        _ if !is_ready => say(
            tr!("Nothing to look into yet"),
            tr!("The scene is not complete."),
            None,
        ),
        Method::Proof => without_proof(state),
        Method::Tree if is_looking && state.inside.by_hand.is_on => {
            say(tr!("CBS plans"), tr!("Each robot by itself."), cancel())
        }
        Method::Tree if is_looking => say(
            tr!("CBS plans"),
            tr!("Its tree comes when it is done."),
            cancel(),
        ),
        Method::Pibt if is_looking => say(
            tr!("PIBT plans"),
            tr!("Its steps come when it is done."),
            cancel(),
        ),
        Method::Lacam if is_looking => say(
            tr!("LaCAM plans"),
            tr!("Its configurations come when it is done."),
            cancel(),
        ),
        Method::Orders if is_looking => say(tr!("One robot plans after the other"), "", cancel()),
        _ if !state.work.is_idle() => say(
            tr!("The solver is busy"),
            tr!("This planner comes next, when the solver is done."),
            None,
        ),
        _ => {
            let failed = state.looked().and_then(|looked| match state.inside.method {
                Method::Tree if state.inside.by_hand.is_on => {
                    crowd::failed(looked.by_hand.as_ref())
                }
                Method::Tree => crowd::failed(looked.tree.as_ref()),
                Method::Pibt => crowd::failed(looked.pibt.as_ref()),
                Method::Lacam => crowd::failed(looked.lacam.as_ref()),
                Method::Proof | Method::Orders => looked.failed.as_ref(),
            });
            let text = failed.map_or("", String::as_str);
            let again = (tr!("Try again"), Action::Inside(InsideAction::Again));
            say(tr!("Nothing was found out"), text, Some(again))
        }
    }
}

fn without_proof(state: &State) -> Nothing {
    let solve = |words| Some((words, Action::Solve(SolveAction::Solve)));
    if proof::is_running(state) {
        return Nothing {
            title: tr!("The search begins"),
            text: tr!("Its steps come here.").to_owned(),
            action: None,
        };
    }
    let answer = state.document.fresh_answer();
    if let Some(planner) = answer.and_then(|answer| answer.by) {
        return of_planner(state, planner);
    }
    let is_final = answer
        .is_some_and(|answer| matches!(answer.solved.status, Status::Optimal | Status::Impossible));
    if is_final {
        return Nothing {
            title: tr!("No record of this proof was kept"),
            text: tr!("Solve again to see how.").to_owned(),
            action: solve(tr!("Solve again")),
        };
    }
    let text = if state.document.is_stale() {
        tr!("The scene has changed since this plan. Solve again to see how.")
    } else {
        tr!("Solve the scene to see how the best plan is found and proved.")
    };
    Nothing {
        title: tr!("Nothing is proved yet"),
        text: text.to_owned(),
        action: solve(tr!("Solve")),
    }
}

/// The plan on the board went on after a change: no record is of it.
fn after_change(method: Method, at: u32) -> Nothing {
    let (title, text) = match method {
        Method::Proof => (
            tr!("No record of this plan"),
            tr!(
                "It went on after a change at time {at}. How that plan was found was not recorded.",
                at
            ),
        ),
        Method::Tree | Method::Orders | Method::Pibt | Method::Lacam => (
            tr!("Nothing to look into"),
            tr!(
                "This planner plans a scene from time 0. The plan on the board went on after a change at time {at}.",
                at
            ),
        ),
    };
    Nothing {
        title,
        text,
        action: None,
    }
}

/// A planner of the textbook has no proof of its plan; the search may have one of its own.
fn of_planner(state: &State, planner: Planner) -> Nothing {
    let runs = Runs::fresh(&state.document);
    let is_searched = runs.is_some_and(|runs| runs.plan(By::Search).is_some());
    let (action, words) = if is_searched {
        (
            SolveAction::ShowPlan(By::Search),
            tr!("Show the plan of the search"),
        )
    } else {
        (SolveAction::Solve, tr!("Solve"))
    };
    Nothing {
        title: tr!("This plan has no proof"),
        text: tr!(
            "{planner} found it. Only the search for the best plan keeps a record of its proof.",
            planner = planner.title()
        ),
        action: Some((words, Action::Solve(action))),
    }
}

/// What is chosen, for those who listen; nothing while steps come by themselves.
pub fn said(state: &State) -> String {
    if !state.is_inside() {
        return String::new();
    }
    let told = match state.inside.method {
        Method::Proof if proof::is_running(state) && state.inside.step.is_none() => None,
        Method::Proof => proof::step_text(state),
        // A tree says its items by itself.
        Method::Tree if state.inside.by_hand.is_on => by_hand::said(state),
        Method::Tree => None,
        Method::Orders | Method::Pibt | Method::Lacam => column::column(state).and_then(|column| {
            let verdict = column.verdict?;
            Some(format!(
                "{} {}: {}",
                verdict.word, verdict.beside, verdict.text
            ))
        }),
    };
    told.unwrap_or_default()
}
