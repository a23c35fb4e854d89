//! Questions: asking, learning, taking the other plan or a repair.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Question, Version, question::fits};
use giveway_solve::explain::{Edit, ExplainAnswer, ExplainRequest, Repair, edited_scene};
use giveway_solve::{Limits, SolveAnswer, Stats, Status};

use super::{edit, solve, stroke};
use crate::asking::{Asking, Lit};
use crate::{Answer, Inquiry, Notice, State, Tab, Work};

/// Asks about the plan that is shown; about the scene where there is none.
pub(super) fn ask(state: &mut State, question: Question) {
    stroke::release(state);
    let own = state.steering.as_deref().map(|own| Rc::clone(&own.answer));
    let own = own.filter(|_| question == Question::Plan);
    if own.is_none() && super::steer::is_in_the_way(state) {
        return;
    }
    let fresh = || state.answer.clone().filter(|_| !state.is_stale());
    let Some(answer) = own.or_else(fresh) else {
        refuse(
            state,
            "Solve the scene first: questions are about its plan.",
        );
        return;
    };
    if answer.course.is_some() || state.changing.is_some() {
        return refuse(state, crate::ask::NO_QUESTIONS);
    }
    // A plan of one's own may break any rule: that is what is asked.
    if question != Question::Plan
        && let (Ok(instance), Some(plan)) = (answer.draft.instance(), answer.plan())
        && let Err(misfit) = fits(&question, instance, plan)
    {
        refuse(state, &misfit.to_string());
        return;
    }
    state.notice = None;
    state.playback.playing = false;
    state.view.tab = Tab::Inspector;
    state.runs += 1;
    let request = Rc::new(ExplainRequest {
        scene: answer.draft.scene().clone(),
        plan: answer.plan().cloned(),
        changes: None,
        at: None,
        question,
        objective: answer.request.objective.clone(),
        within: answer.request.within,
        limits: Limits {
            seconds: Some(f64::from(state.settings.seconds)),
            ..Limits::default()
        },
    });
    state.work = Work::Asking(Inquiry {
        id: state.runs,
        request: Rc::clone(&request),
    });
    state.asking = Some(Rc::new(Asking::new(request, answer)));
}

pub(super) fn refuse(state: &mut State, sentence: &str) {
    state.notice = Some(Notice {
        sentence: sentence.to_owned(),
        details: Vec::new(),
    });
}

/// Leaves the question; what is still looked for is given up.
pub(super) fn close(state: &mut State) {
    let is_about_it = match &state.work {
        Work::Asking(_) => true,
        Work::Certifying(run) => run.of_question,
        Work::Idle | Work::Solving(_) | Work::Adapting(_) => false,
    };
    if is_about_it {
        solve::cancel(state);
    }
    state.asking = None;
    state.playback.time = state.playback.time.min(state.last_time());
}

/// Ends the search for the rest of an answer, and keeps what is known.
pub(super) fn give_up(state: &mut State) {
    change(state, |asking| asking.is_done = true);
    if state.asking.as_ref().is_some_and(|a| a.told.is_none()) {
        state.asking = None;
    }
}

pub(super) fn change(state: &mut State, by: impl FnOnce(&mut Asking)) {
    if let Some(asking) = &mut state.asking {
        by(Rc::make_mut(asking));
    }
}

pub(super) fn is_current(state: &State, id: u64) -> bool {
    matches!(&state.work, Work::Asking(inquiry) if inquiry.id == id)
}

/// More became known.
pub(super) fn learn(state: &mut State, id: u64, answer: ExplainAnswer) {
    if is_current(state, id) {
        change(state, |asking| asking.learn(answer));
        state.playback.time = state.playback.time.min(state.last_time());
    }
}

/// All there is became known.
pub(super) fn answered(state: &mut State, id: u64, answer: ExplainAnswer) {
    if is_current(state, id) {
        learn(state, id, answer);
        change(state, |asking| asking.is_done = true);
        state.work = Work::Idle;
    }
}

/// Shows the other plan or this one, at the same time.
pub(super) fn show_other(state: &mut State, on: bool) {
    change(state, |asking| {
        asking.shows_other = on && asking.other.is_some();
    });
    state.playback.time = state.playback.time.min(state.last_time());
}

pub(super) fn light(state: &mut State, lit: Option<Lit>) {
    change(state, |asking| asking.lit = lit);
}

/// The other plan becomes the plan.
pub(super) fn take_other(state: &mut State) {
    let other = state
        .asking
        .as_ref()
        .and_then(|asking| asking.other.clone());
    if let Some(other) = other {
        close(state);
        if state.steering.is_some() {
            // The plan of one's own is not lost.
            let before = super::change::moment(state);
            state.history.record(before);
            state.steering = None;
        }
        state.answer = Some(other);
        state.playback.time = state.playback.time.min(state.last_time());
    }
}

/// Makes the edits of a repair, as one step of undo, and shows its plan while
/// the scene is solved anew.
pub(super) fn take_repair(state: &mut State, index: usize) {
    let repair = state.asking.as_ref().and_then(|asking| {
        let told = asking.told.as_ref()?;
        told.repairs.get(index).cloned()
    });
    let Some(repair) = repair else { return };
    close(state);
    for edit in &repair.edits {
        if let Edit::Deadline { within } = edit {
            state.settings.within = Some(*within);
        }
    }
    if let Ok(instance) = state.draft.instance() {
        let edited = edited_scene(instance, &repair.edits);
        edit::change(state, |scene| *scene = edited);
    }
    solve::start(state);
    show(state, repair);
}

/// The repair's plan is shown until there is a proved one.
fn show(state: &mut State, repair: Repair) {
    let Work::Solving(run) = &state.work else {
        return;
    };
    let solved = SolveAnswer {
        giveway: Version,
        status: Status::Feasible,
        costs: Some(repair.costs),
        bounds: BTreeMap::new(),
        within: None,
        complete: false,
        reason: None,
        plan: Some(repair.plan),
        stats: Stats::default(),
    };
    let answer = Answer::new(Rc::clone(&run.draft), Rc::clone(&run.request), solved);
    state.answer = Some(Rc::new(answer));
    state.playback.time = 0;
}
