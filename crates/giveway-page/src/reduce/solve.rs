//! A request on its way to an answer.
//!
//! The state only says what should run. What runs is seen to by the page: a run
//! that is no longer in [`State::work`] is ended there, and what it still sends
//! is recognised by its number and ignored here.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::Question;
use giveway_solve::{Limits, Progress, Refusal, Response, SolveRequest};

use crate::front::{Front, has_front};
use crate::history::Moment;
use crate::{Answer, Notice, Run, Size, State, Work};

pub(super) fn start(state: &mut State) {
    super::stroke::release(state);
    if state.changing.is_some() {
        return super::change::adapt(state);
    }
    if state.steering.is_some() {
        return super::ask::ask(state, Question::Plan);
    }
    if state.draft.instance().is_err() {
        let problems = state.draft.problems().iter();
        state.notice = Some(Notice {
            sentence: "The scene cannot be solved as it is.".to_owned(),
            details: problems.map(|problem| problem.sentence.clone()).collect(),
        });
        return;
    }
    state.notice = None;
    state.playback.playing = false;
    state.asking = None;
    state.runs += 1;
    let request = SolveRequest {
        scene: state.draft.scene().clone(),
        pareto: state.settings.front && has_front(&state.draft.scene().objective),
        within: state.settings.within,
        limits: Limits {
            seconds: Some(f64::from(state.settings.seconds)),
            ..Limits::default()
        },
        ..SolveRequest::default()
    };
    state.work = Work::Solving(Run {
        id: state.runs,
        draft: Rc::clone(&state.draft),
        request: Rc::new(request),
        bounds: BTreeMap::new(),
        best: None,
        size: Size::default(),
    });
}

/// Ends what the solver does; what is known of an answer stays.
pub(super) fn cancel(state: &mut State) {
    if let Work::Asking(_) = state.work {
        super::ask::give_up(state);
    }
    state.work = Work::Idle;
}

/// The run of this number, if it is still the one.
fn current(state: &mut State, id: u64) -> Option<&mut Run> {
    match &mut state.work {
        Work::Solving(run) if run.id == id => Some(run),
        _ => None,
    }
}

pub(super) fn progress(state: &mut State, id: u64, event: Progress) {
    let event = match event {
        Progress::Explained { answer } => return super::ask::learn(state, id, *answer),
        Progress::Certifying { claim, checking } => {
            return super::proof::learn(state, id, claim, checking);
        }
        event => event,
    };
    if let (
        true,
        Progress::Size {
            variables,
            clauses,
            conflicts,
        },
    ) = (super::change::is_current(state, id), &event)
    {
        let (variables, clauses, conflicts) = (*variables, *clauses, *conflicts);
        return super::change::learn(
            state,
            Size {
                variables,
                clauses,
                conflicts,
            },
        );
    }
    let Some(run) = current(state, id) else {
        return;
    };
    match event {
        Progress::Explained { .. } | Progress::Certifying { .. } => {}
        // It is proved under limits on the other costs, of one point of the front.
        Progress::Bound { .. } if run.request.pareto => {}
        Progress::Bound { cost, at_least } => {
            let bound = run.bounds.entry(cost).or_insert(at_least);
            *bound = at_least.max(*bound);
        }
        Progress::Plan { costs, .. } => run.best = Some(costs),
        Progress::Size {
            variables,
            clauses,
            conflicts,
        } => {
            run.size = Size {
                variables,
                clauses,
                conflicts,
            };
        }
    }
}

pub(super) fn respond(state: &mut State, id: u64, response: Response) {
    let response = match response {
        Response::Explained(answer) => return super::ask::answered(state, id, *answer),
        Response::Certified(report) => return super::proof::checked(state, id, *report),
        response => response,
    };
    if super::ask::is_current(state, id) {
        super::ask::close(state);
        if let Response::Refused(refusal) = response {
            refused(state, "The question cannot be answered.", &refusal);
        }
        return;
    }
    if super::proof::is_current(state, id) {
        state.work = Work::Idle;
        if let Response::Refused(refusal) = response {
            refused(state, "The proof cannot be checked.", &refusal);
        }
        return;
    }
    if super::change::is_current(state, id) {
        state.work = Work::Idle;
        match response {
            Response::Changed(told) => super::change::answered(state, *told),
            Response::Refused(refusal) => {
                refused(state, "The changes were refused.", &refusal);
            }
            _ => {}
        }
        return;
    }
    let Some(run) = current(state, id).cloned() else {
        return;
    };
    state.work = Work::Idle;
    match response {
        Response::Solved(solved) => {
            let answer = Answer::new(run.draft, run.request, solved);
            if state
                .fresh_answer()
                .is_some_and(|before| before.course.is_some())
            {
                // What was adopted goes with its history: that can be undone.
                let before = Moment::Course {
                    answer: state.answer.clone(),
                    changing: None,
                    steering: None,
                };
                state.history.record(before);
            }
            state.front = None;
            play_from_start(state, Rc::new(answer));
            if let Some((_, question)) = state.wanted.take().filter(|(run, _)| *run == id) {
                super::ask::ask(state, question);
            }
        }
        Response::Front(front) => {
            let front = Front::new(run.draft, &run.request, front);
            let first = front.first(&run.request);
            state.front = Some(Rc::new(front));
            play_from_start(state, first);
        }
        Response::Refused(refusal) => refused(state, "The solver refused the scene.", &refusal),
        _ => {}
    }
}

fn play_from_start(state: &mut State, answer: Rc<Answer>) {
    state.playback.time = 0;
    state.playback.playing = answer.makespan() > 0;
    state.playback.sought = false;
    state.answer = Some(answer);
}

/// Shows a plan of the front, at the same time as far as it goes.
pub(super) fn show_point(state: &mut State, point: usize) {
    let points = state.front().map(|front| &front.points);
    let Some(answer) = points.and_then(|points| points.get(point)).cloned() else {
        return;
    };
    if super::steer::is_in_the_way(state) {
        return;
    }
    super::ask::close(state);
    state.answer = Some(answer);
    state.playback.time = state.playback.time.min(state.last_time());
}

fn refused(state: &mut State, sentence: &str, refusal: &Refusal) {
    state.notice = Some(Notice {
        sentence: sentence.to_owned(),
        details: refusal.sentences(),
    });
}

pub(super) fn crash(state: &mut State, id: u64, sentence: String, had_started: bool) {
    if state.work.id() != Some(id) {
        return;
    }
    cancel(state);
    let what = if had_started {
        "The solver broke off and was started again; the scene is as it was."
    } else {
        "The solver could not be started; Solve tries it again."
    };
    state.notice = Some(Notice {
        sentence: what.to_owned(),
        details: vec![sentence],
    });
}
