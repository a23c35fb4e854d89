//! Solving: begun, on its way, answered, stopped.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Question, Version, check};
use giveway_solve::{FrontAnswer, Limits, Progress, SolveAnswer, SolveRequest, Stats, Status};

use super::document::{amend, put};
use super::{ask, change, job, proof, stroke};
use crate::front::{Front, has_front};
use crate::known::{judged, merged};
use crate::{Answer, Arrival, Document, Mode, Notice, Size, SolveAction, Solving, State, Task};

/// A plan of at most so many agents is proved as soon as it is opened.
const SMALL: usize = 12;

pub(super) fn solve(state: &mut State, action: SolveAction) {
    match action {
        SolveAction::Begin => start(state, Start::quiet()),
        SolveAction::Solve => start(state, Start::step()),
        SolveAction::Cancel => cancel(state),
        SolveAction::ShowPoint(point) => show_point(state, point),
        SolveAction::CheckProof => proof::start(state),
        SolveAction::Progress { job, event } => job::progress(state, job, event),
        SolveAction::Respond { job, response } => job::respond(state, job, *response),
        SolveAction::Crash {
            job,
            sentence,
            had_started,
        } => job::crash(state, job, sentence, had_started),
    }
}

/// How a solve begins.
pub(super) struct Start {
    arrival: Arrival,
    then: Option<Question>,
}

impl Start {
    /// A person asked for it.
    pub(super) fn step() -> Self {
        Self {
            arrival: Arrival::Step,
            then: None,
        }
    }

    /// It belongs to the step before.
    pub(super) fn quiet() -> Self {
        Self {
            arrival: Arrival::Quiet,
            ..Self::step()
        }
    }

    /// A link was opened: what it holds is proved, and its question asked.
    pub(super) fn of_link(then: Option<Question>) -> Self {
        Self {
            arrival: Arrival::Quiet,
            then,
        }
    }
}

/// Whether a scene is small enough to be proved without being asked.
pub(super) fn is_small(document: &Document) -> bool {
    document.draft.agents().len() <= SMALL
}

/// Solves the scene; in other modes, what is to be solved there.
pub(super) fn start(state: &mut State, how: Start) {
    stroke::release(state);
    match &state.document.mode {
        Mode::Changing(_) | Mode::Comparing(_) | Mode::Stuck(..) => {
            return change::adapt(state);
        }
        Mode::Steering(_) | Mode::Judging(..) => return ask::ask(state, &Question::Plan),
        Mode::Editing | Mode::Asking(_) => {}
    }
    let draft = &state.document.draft;
    if draft.instance().is_err() {
        let problems = draft.problems().iter();
        state.view.notice = Some(Notice {
            sentence: "The scene cannot be solved as it is.".to_owned(),
            details: problems.map(|problem| problem.sentence.clone()).collect(),
        });
        return;
    }
    ask::close(state);
    state.view.notice = None;
    state.view.playback.playing = false;
    let document = &state.document;
    // What a search that was cut off left is not lost.
    let is_open = |answer: &&Rc<Answer>| {
        let is_open = matches!(answer.solved.status, Status::Feasible | Status::Unknown);
        is_open && answer.course.is_none()
    };
    let from = document.fresh_answer().filter(is_open).cloned();
    let request = SolveRequest {
        scene: document.draft.scene().clone(),
        pareto: state.settings.front && has_front(&document.draft.scene().objective),
        within: document.within,
        start: from.as_ref().and_then(|from| from.solved.plan.clone()),
        limits: Limits {
            seconds: Some(f64::from(state.settings.seconds)),
            ..Limits::default()
        },
        ..SolveRequest::default()
    };
    state.work.start(Task::Solve(Solving {
        draft: Rc::clone(&document.draft),
        request: Rc::new(request),
        bounds: from
            .as_ref()
            .map_or_else(BTreeMap::new, |from| from.solved.bounds.clone()),
        best: from.as_ref().and_then(|from| from.solved.costs),
        plan: None,
        from,
        size: Size::default(),
        then: how.then,
        arrival: how.arrival,
    }));
}

impl Solving {
    /// Takes in what became known.
    pub(super) fn learn(&mut self, event: Progress) {
        match event {
            // It is proved under limits on the other costs, of one point of the front.
            Progress::Bound { .. } if self.request.pareto => {}
            Progress::Bound { cost, at_least } => {
                let bound = self.bounds.entry(cost).or_insert(at_least);
                *bound = at_least.max(*bound);
            }
            // Of a front it is the plan of one point.
            Progress::Plan { costs, plan } if !self.request.pareto => {
                self.best = Some(costs);
                self.plan = Some(Rc::new(plan));
            }
            Progress::Plan { costs, .. } => self.best = Some(costs),
            Progress::Size { .. } | Progress::Explained { .. } | Progress::Certifying { .. } => {}
        }
    }

    /// What is known where the search ends before its answer; `None` where that
    /// is nothing.
    fn stopped(&self, reason: &str) -> Option<SolveAnswer> {
        let plan = self.plan.as_deref().filter(|plan| {
            let instance = self.draft.instance();
            instance.is_ok_and(|instance| check::check(instance, plan).violations.is_empty())
        });
        if plan.is_none() && self.bounds.is_empty() {
            return None;
        }
        Some(SolveAnswer {
            giveway: Version,
            status: match plan {
                Some(_) => Status::Feasible,
                None => Status::Unknown,
            },
            costs: self.best.filter(|_| plan.is_some()),
            bounds: self.bounds.clone(),
            within: self.request.within,
            complete: false,
            reason: Some(reason.to_owned()),
            plan: plan.cloned(),
            stats: Stats::default(),
        })
    }
}

/// Ends what runs; what is known of an answer stays.
pub(super) fn cancel(state: &mut State) {
    match state.work.end() {
        Some(Task::Solve(run)) => {
            if let Some(solved) = run.stopped("You stopped the search") {
                answered(state, run, solved);
            }
        }
        Some(Task::Explain(_)) => {
            let asking = state.document.mode.asking();
            if asking.is_some_and(|asking| asking.told.is_none()) {
                ask::close(state);
            }
        }
        Some(Task::Certify(_) | Task::Change(_)) | None => {}
    }
}

/// The scene was solved, or the search cut off.
pub(super) fn answered(state: &mut State, run: Solving, solved: SolveAnswer) {
    let objective = &run.draft.scene().objective;
    if let Some(shared) = run.from.as_ref().filter(|from| from.is_shared)
        && run.arrival == Arrival::Quiet
    {
        // It stays the plan that was shared; what is known of it is told.
        let solved = judged(&shared.solved, &solved, objective);
        let document = Document {
            answer: Some(Rc::new(Answer::new(run.draft, run.request, solved))),
            ..state.document.clone()
        };
        amend(state, document);
        return;
    }
    let solved = match &run.from {
        Some(from) => merged(&from.solved, solved, objective),
        None => solved,
    };
    let answer = Rc::new(Answer::new(run.draft, run.request, solved));
    arrive(state, &answer, None, run.arrival);
    if let Some(question) = run.then {
        ask::ask(state, &question);
    }
}

/// The front was found.
pub(super) fn front(state: &mut State, run: &Solving, front: FrontAnswer) {
    let front = Front::new(Rc::clone(&run.draft), &run.request, front);
    let first = front.first(&run.request);
    arrive(state, &first, Some(Rc::new(front)), run.arrival);
}

fn arrive(state: &mut State, answer: &Rc<Answer>, front: Option<Rc<Front>>, arrival: Arrival) {
    let shown = state.document.fresh_answer();
    // A link's plan is proved: it goes on being shown where it is looked at.
    let is_proved = arrival == Arrival::Quiet && shown.is_some_and(|shown| shown.plan().is_some());
    let document = Document {
        answer: Some(Rc::clone(answer)),
        found_front: front,
        ..state.document.clone()
    };
    match arrival {
        Arrival::Step => put(state, document),
        Arrival::Quiet => amend(state, document),
    }
    if is_proved {
        return;
    }
    let playback = &mut state.view.playback;
    playback.stop_at(0);
    playback.playing = answer.makespan() > 0;
    playback.sought = false;
}

/// Shows a plan of the front, at the same time as far as it goes.
fn show_point(state: &mut State, point: usize) {
    let points = state.document.front().map(|front| &front.points);
    let Some(answer) = points.and_then(|points| points.get(point)).cloned() else {
        return;
    };
    if super::steer::is_in_the_way(state) {
        return;
    }
    ask::close(state);
    let document = Document {
        answer: Some(answer),
        ..state.document.clone()
    };
    amend(state, document);
}
