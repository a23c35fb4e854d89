//! Questions: asking, learning, taking the other plan or a repair.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::words::Sentence;
use giveway_model::{Costs, Plan, Question, Version, question::fits, tr_data};
use giveway_solve::explain::ExplainAnswer;
use giveway_solve::{Limits, Reach, SolveAnswer, Stats, Status};

use super::document::{amend, edit_scene, put};
use super::play::seek;
use super::{find, solve, stroke};
use crate::asking::{Asking, Lit};
use crate::edit::repair;
use crate::rules::Clash;
use crate::{Activity, Answer, AskAction, Document, Mode, Notice, State, Tab, Task};

#[inline(never)]
pub(super) fn questions(state: &mut State, action: AskAction) {
    match action {
        AskAction::Ask(question) => ask(state, &question),
        AskAction::Again => {
            let asking = state.document.mode.asking();
            if let Some(before) = asking.cloned() {
                go_on(state, &before);
            }
        }
        AskAction::Close => close(state),
        AskAction::ShowOther(on) => show_other(state, on),
        AskAction::Light(lit) => light(state, lit),
        AskAction::GoTo(cell) => {
            let lit = Some(Lit::Cell(cell));
            let is_lit = state.document.mode.asking().is_some_and(|it| it.lit == lit);
            light(state, lit.filter(|_| !is_lit));
            if !is_lit {
                find::show(state, cell);
            }
        }
        AskAction::Group(index) => change(state, |asking| {
            let lit = Some(Lit::Group(index));
            // The first one is open before any was pressed.
            let is_first = index == 0 && asking.lit.is_none() && !asking.folds_groups;
            let closes = asking.lit == lit || is_first;
            asking.lit = lit.filter(|_| !closes);
            asking.folds_groups = closes;
        }),
        AskAction::Choose(variation) => change(state, |asking| asking.choose(variation)),
        AskAction::Unfold => change(state, |asking| asking.is_unfolded = true),
        AskAction::TakeOther => take_other(state),
        AskAction::TakeFound => {
            if let Some(better) = state.found_better().cloned() {
                take(state, better);
            }
        }
        AskAction::TakeRepair(index) => take_repair(state, index),
    }
}

/// The question about what is shown; where it cannot be asked, a notice says why.
fn asking(state: &mut State, question: &Question) -> Option<Asking> {
    let limits = Limits {
        seconds: Some(f64::from(state.settings.seconds)),
        ..Limits::default()
    };
    let asked = |answer: &Rc<Answer>| Asking::about(answer, question.clone(), limits);
    match &state.document.mode.activity {
        // A plan of one's own may break any rule: that is what is asked.
        Activity::Steering(own) if *question == Question::Plan => Some(asked(&own.answer)),
        Activity::Steering(_) => {
            super::steer::is_in_the_way(state);
            None
        }
        Activity::Comparing(comparing)
            if *question == Question::Unsolvable && comparing.preview().is_none() =>
        {
            Some(Asking::stuck(&comparing.changing, limits))
        }
        Activity::Changing(_) | Activity::Comparing(_) => {
            refuse(
                state,
                tr_data!("Use a new plan first, or discard the changes."),
            );
            None
        }
        Activity::Editing | Activity::Auditing(_) => {
            let Some(answer) = state.document.fresh_answer() else {
                refuse(state, tr_data!("Solve first: questions are about a plan."));
                return None;
            };
            if answer.course.is_none()
                && let (Ok(instance), Some(plan)) = (answer.draft.instance(), answer.plan())
                && let Err(misfit) = fits(question, instance, plan)
            {
                refuse(state, misfit.in_sentences());
                return None;
            }
            let mut asking = asked(answer);
            // What an earlier question found is known to this one.
            let better = state.found_better().and_then(|better| better.plan());
            Rc::make_mut(&mut asking.request).known = better.cloned();
            Some(asking)
        }
    }
}

/// Asks about the plan that is shown; about the scene where there is none.
pub(super) fn ask(state: &mut State, question: &Question) {
    stroke::release(state);
    let Some(asking) = asking(state, question) else {
        return;
    };
    let request = Rc::clone(&asking.request);
    state.view.notice = None;
    state.view.playback.playing = false;
    state.view.tab = Tab::Inspector;
    set_question(state, Some(Rc::new(asking)));
    state.work.start(Task::Explain(request));
}

/// Asks the same again: what is known stands until more is.
fn go_on(state: &mut State, before: &Rc<Asking>) {
    ask(state, before.question());
    change(state, |asking| {
        if asking.question() == before.question() && Rc::ptr_eq(&asking.about, &before.about) {
            *asking = Asking {
                request: Rc::clone(&asking.request),
                ..(**before).clone()
            };
        }
    });
}

pub(super) fn refuse(state: &mut State, sentence: impl Into<Sentence>) {
    state.view.notice = Some(Notice::refusal(sentence));
}

/// Another question or none, as part of the last step: asking is no step of its own.
fn set_question(state: &mut State, question: Option<Rc<Asking>>) {
    let document = Document {
        mode: state.document.mode.with(question),
        ..state.document.clone()
    };
    amend(state, document);
}

/// Leaves the question, at the time at which it was asked.
pub(super) fn close(state: &mut State) {
    if let Some(asking) = state.document.mode.asking() {
        let before = asking.time_before;
        set_question(state, None);
        if let Some(time) = before {
            seek(state, time);
        }
    }
}

/// Beside a question's other plan a robot that is pressed is lit up; the question stays. Whether it
/// is so.
pub(super) fn lights_robot(state: &mut State, agent: usize) -> bool {
    let asking = state.document.mode.asking();
    let is_beside = asking.is_some_and(|asking| asking.shows_other);
    if is_beside {
        light(state, Some(Lit::Robot(agent)));
    }
    is_beside
}

fn change(state: &mut State, by: impl FnOnce(&mut Asking)) {
    if let Some(asking) = state.document.mode.asking_mut() {
        by(asking);
        super::document::settle(state);
    }
}

/// More became known. Why there is no plan stays known after the question is left.
pub(super) fn learn(state: &mut State, answer: ExplainAnswer) {
    change(state, |asking| asking.learn(answer));
    let before = state.view.found.take();
    remember(state);
    let asking = state.document.mode.asking();
    state.view.found = asking.and_then(|asking| asking.kept(before));
    let asking = asking.filter(|it| *it.question() == Question::Unsolvable && it.can_be_repaired());
    let core = asking.and_then(|asking| asking.told.as_deref()?.core.clone());
    if let Some(core) = core {
        let draft = Rc::clone(&state.document.draft);
        state.view.rules.clash = Some(Rc::new(Clash { draft, core }));
    }
}

/// Keeps the question with its answer for the report.
#[inline(never)]
fn remember(state: &mut State) {
    let asking = state.document.mode.asking().cloned();
    if let Some(asking) = asking.filter(|asking| crate::ask::is_answered(asking)) {
        crate::ask::remember(Rc::make_mut(&mut state.document.asked), &asking);
    }
}

/// Opens the other plan at the first difference, or leaves it: side by side at the time that was
/// shown before; one in the place of the other at the same time, to be looked at in turn.
fn show_other(state: &mut State, on: bool) {
    let time = state.view.playback.time;
    let keeps_time = !state.view.is_wide;
    let Some(asking) = state.document.mode.asking_mut() else {
        return;
    };
    let is_opened = on && asking.other.is_some();
    let before = asking.time_before;
    asking.shows_other = is_opened;
    asking.time_before = match (is_opened, before) {
        (true, None) => Some(time),
        (false, _) if !keeps_time => None,
        (_, before) => before,
    };
    super::document::settle(state);
    let to = if is_opened && before.is_none() {
        let differences = state.differences();
        differences.first().map(|first| first.time)
    } else if !is_opened && !keeps_time {
        before
    } else {
        // This plan may end before the other one.
        (time > state.last_time()).then_some(time)
    };
    if let Some(time) = to {
        seek(state, time);
    }
}

fn light(state: &mut State, lit: Option<Lit>) {
    change(state, |asking| asking.lit = lit);
}

/// The other plan becomes the plan.
fn take_other(state: &mut State) {
    let asking = state.document.mode.asking();
    if let Some(other) = asking.and_then(|asking| asking.other.clone()) {
        take(state, other);
    }
}

fn take(state: &mut State, plan: Rc<Answer>) {
    let document = Document {
        answer: Some(plan),
        mode: Mode::default(),
        ..state.document.clone()
    };
    put(state, document);
}

/// Makes the edits of a repair, as one step of undo, and shows its plan while
/// the scene is solved again.
fn take_repair(state: &mut State, index: usize) {
    let asking = state.document.mode.asking();
    let asking = asking.filter(|asking| asking.can_be_repaired());
    let found = asking.and_then(|asking| {
        let told = asking.told.as_ref()?;
        told.repairs.get(index).cloned()
    });
    let Some(found) = found else { return };
    if let Some(comparing) = state.document.mode.comparing() {
        let changing = Rc::clone(&comparing.changing);
        return super::change::repaired(state, &changing, &found);
    }
    let edits = repair(&found.edits, state.document.draft.agents());
    if let Err(notice) = edit_scene(state, &edits) {
        state.view.notice = Some(notice);
        return;
    }
    close(state);
    solve::start(state, solve::Start::quiet());
    show(state, found.costs, found.plan);
}

/// A plan of an edited scene is shown until there is a proved one.
pub(super) fn show(state: &mut State, costs: Costs, plan: Plan) {
    let Some(run) = state.work.solving() else {
        return;
    };
    let solved = SolveAnswer {
        giveway: Version,
        status: Status::Feasible,
        costs: Some(costs),
        bounds: BTreeMap::new(),
        reach: Reach::default(),
        ended: None,
        reason: None,
        plan: Some(plan),
        stats: Stats::default(),
        trace: None,
    };
    let answer = Answer::new(Rc::clone(&run.draft), Rc::clone(&run.request), solved);
    let document = Document {
        answer: Some(Rc::new(answer)),
        ..state.document.clone()
    };
    amend(state, document);
    state.view.playback.stop_at(0);
}
