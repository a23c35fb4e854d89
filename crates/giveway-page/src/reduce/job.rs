//! What the worker tells, heard in one place: only the job that is not over is
//! heard, and each kind of answer goes to the part that asked for it.

use giveway_model::tr_data;
use std::rc::Rc;

use giveway_solve::{Progress, Refusal, Response};

use super::{ask, change, freedom, inside, ledger, order, planners, prices, proof, sizing, solve};
use crate::{Adapting, Notice, Size, Solving, State, Task, WorkerAction};

/// A worker tells of a job.
pub(super) fn worker(state: &mut State, action: WorkerAction) {
    match action {
        WorkerAction::Progress { job, event } => progress(state, job, event),
        WorkerAction::Respond { job, response } => respond(state, job, *response),
        WorkerAction::Crash {
            job,
            sentence,
            had_started,
        } => crash(state, job, sentence, had_started),
    }
}

/// Something became known on the way.
fn progress(state: &mut State, id: u64, event: Progress) {
    let Some(task) = state.work.task_mut(id) else {
        return;
    };
    match (task, event) {
        (
            Task::Solve(Solving { size, .. }) | Task::Change(Adapting { size, .. }),
            Progress::Size {
                variables,
                clauses,
                conflicts,
            },
        ) => {
            *size = Size {
                variables,
                clauses,
                conflicts,
            };
        }
        (Task::Solve(run), event) => {
            run.learn(event);
            solve::preview(state);
        }
        (Task::Certify(run), Progress::Certifying { claim, checking }) => {
            run.at = Some((claim, checking));
        }
        (Task::Export(run), Progress::Certifying { claim, checking }) => {
            run.at = Some((claim, checking));
        }
        (Task::Export(run), Progress::Exporting { done, of }) => {
            run.made = (done, of);
            run.at = None;
        }
        (Task::Explain(_), Progress::Explained { answer }) => ask::learn(state, *answer),
        (Task::Freedom(_), Progress::Freedom { answer }) => freedom::learn(state, *answer),
        (Task::Price(draft, request), Progress::Priced { answer }) => {
            let (draft, request) = (Rc::clone(draft), Rc::clone(request));
            prices::learn(state, &draft, &request, *answer);
        }
        (Task::Delays(_), Progress::Delays { answer }) => ledger::learn(state, *answer),
        (
            Task::Sizing(_),
            Progress::Sized {
                floor,
                point,
                pending,
            },
        ) => sizing::learn(state, floor, *point, pending),
        _ => {}
    }
}

/// The worker answered.
fn respond(state: &mut State, id: u64, response: Response) {
    if state.work.id() != Some(id) {
        return;
    }
    let Some(task) = state.work.end() else { return };
    match (task, response) {
        (Task::Solve(run), Response::Solved(answer)) => solve::answered(state, run, answer),
        (Task::Solve(run), Response::Front(front)) => solve::front(state, &run, front),
        (Task::Solve(run), Response::Planned(told)) => planners::planned(state, &run, &told),
        (Task::Explain(_), Response::Explained(answer)) => ask::learn(state, *answer),
        (Task::Certify(run), Response::Certified(report)) => proof::checked(state, &run, *report),
        (Task::Export(_), Response::Exported(answer)) => proof::exported(state, *answer),
        (Task::Freedom(_), Response::Freedom(answer)) => freedom::learn(state, *answer),
        (Task::Price(draft, request), Response::Priced(answer)) => {
            prices::learn(state, &draft, &request, *answer);
        }
        (Task::Delays(_), Response::Delays(answer)) => ledger::learn(state, *answer),
        (Task::Order(request), Response::Order(answer)) => {
            order::answered(state, &request, *answer);
        }
        (Task::Sizing(_), Response::Sized(answer)) => sizing::answered(state, *answer),
        (Task::Change(run), Response::Changed(told)) => change::answered(state, &run, *told),
        (Task::Look(looking), response) => inside::respond(state, &looking, response),
        (task, Response::Refused(refusal)) => refused(state, &task, &refusal),
        _ => {}
    }
}

fn refused(state: &mut State, task: &Task, refusal: &Refusal) {
    let sentence = match task {
        Task::Solve(_) => tr_data!("The solver refused the scene."),
        Task::Explain(_) => tr_data!("The question cannot be answered."),
        Task::Certify(_) => tr_data!("The proof cannot be checked."),
        Task::Export(_) => tr_data!("The certificate cannot be made."),
        Task::Change(_) => tr_data!("The changes were refused."),
        Task::Look(_) => tr_data!("The planner refused the scene."),
        Task::Freedom(_) => tr_data!("All best plans cannot be compared for this scene."),
        Task::Price(..) => tr_data!("What the rules cost cannot be found out for this scene."),
        Task::Delays(_) => tr_data!("There is no ledger of this plan."),
        Task::Order(_) => tr_data!("The order of this plan cannot be told."),
        Task::Sizing(_) => tr_data!("How many robots the floor bears cannot be found out."),
    };
    if let Task::Explain(_) = task {
        let is_stuck = state.document.mode.comparing().is_some();
        ask::close(state);
        if is_stuck {
            // Nobody asked: what the methods answered tells the cause.
            return;
        }
    }
    if let Task::Freedom(_) = task {
        freedom::refused(state);
    }
    if let Task::Delays(_) = task {
        ledger::refused(state);
    }
    if let Task::Order(_) = task {
        order::refused(state);
    }
    state.view.notice = Some(Notice::refusal(sentence).with(match refusal {
        // What can be asked, as a sentence: nobody types it here.
        Refusal::Question { misfit } => vec![misfit.in_sentences()],
        other => other.sentences(),
    }));
}

/// The worker broke off, or did not even start.
fn crash(state: &mut State, id: u64, sentence: String, had_started: bool) {
    if state.work.id() != Some(id) {
        return;
    }
    let is_solving = state.work.solving().is_some();
    solve::cancel(state);
    let what = if had_started {
        tr_data!("The solver broke off and was started again. Your scene is as it was.")
    } else if is_solving {
        tr_data!("The solver could not be started. Press Solve to try again.")
    } else {
        tr_data!(
            "The part of the solver that answers could not be loaded. Try again when the network is back."
        )
    };
    state.view.notice = Some(Notice::refusal(what).with([sentence]));
}
