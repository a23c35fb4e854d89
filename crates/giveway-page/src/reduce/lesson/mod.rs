//! A lesson on the board: opened, heard, left.

mod admit;

use giveway_model::tr_data;
use std::rc::Rc;

use giveway_course::lesson::Layer;
use giveway_course::port::{Board, BoardPlan, Deed, Evidence, ToPage};
use giveway_model::Fault;

use super::document::{amend, undo};
use super::{inside, play, solve, steer, step, stroke};
use crate::lesson::{Lesson, LessonAction, Revealed, document, evidence};
use crate::present::Presenting;
use crate::rules::RuleAction;
use crate::steering::Lead;
use crate::view::Layers;
use crate::{
    Action, AskAction, BoardAction, Edit, Notice, Paint, Selection, SolveAction, State, Tab,
    ViewAction, ask,
};

pub(super) use admit::admit;

#[inline(never)]
pub(super) fn lesson(state: &mut State, action: LessonAction) {
    match action {
        LessonAction::Says(message) => says(state, *message),
        LessonAction::Leave => leave(state),
    }
}

/// A plan of a scene that was edited since is not shown on the board of a lesson.
pub(super) fn settle(state: &mut State) {
    if state.lesson().is_some() && state.document.is_stale() {
        state.document.answer = None;
        super::document::keep_to_plan(state);
    }
}

fn change(state: &mut State, by: impl FnOnce(&mut Lesson)) {
    if let Some(lesson) = &mut state.lesson {
        by(Rc::make_mut(lesson));
    }
}

fn says(state: &mut State, message: ToPage) {
    match message {
        ToPage::Open(board) => open(state, &Rc::new(*board)),
        ToPage::Light(lit) => change(state, |lesson| lesson.lit = lit),
        ToPage::Go(time) => play::seek(state, time),
        ToPage::Play => play::begin(state),
        ToPage::Show(found) => show(state, &found),
        ToPage::Seal(cells) => change(state, |lesson| lesson.sealed = cells),
        ToPage::Lead(name) => {
            let mut agents = state.document.agents().iter();
            if let Some(agent) = agents.position(|agent| agent.name == name) {
                super::board::select(state, Selection::Agent(agent));
            }
        }
        ToPage::Wait => steer::steer(state, Lead::Step((0, 0))),
        ToPage::Do(deed) => tour(state, deed),
        ToPage::TakeBack => {
            change(state, |lesson| lesson.sealed.clear());
            undo(state);
        }
        ToPage::StartAfresh(number) => {
            if let Some(lesson) = &state.lesson {
                let board = Board {
                    number,
                    ..(*lesson.board).clone()
                };
                open(state, &Rc::new(board));
            }
        }
        ToPage::Say(sentence) => {
            state.view.notice = Some(Notice::information(sentence));
        }
        ToPage::Present => super::view::view(state, &ViewAction::Present(Presenting::Told)),
        ToPage::Close => leave(state),
        // They change no state: the page acts by itself.
        ToPage::Take | ToPage::Speak(_) => {}
    }
}

/// A board takes the place of what was there; a person's own page is put aside.
fn open(state: &mut State, board: &Rc<Board>) {
    stroke::abandon(state);
    let document = match document(board) {
        Ok(document) => document,
        Err(faults) => {
            state.view.notice = Some(refusal(&faults));
            return;
        }
    };
    let (own, resumes) = match &state.lesson {
        Some(lesson) => (Rc::clone(&lesson.own), lesson.resumes),
        None => (Rc::new(aside(state)), is_searching(state)),
    };
    let mut next = State::of(document);
    carry(state, &mut next);
    // On a phone the lesson comes first: it says what is to be done with the rest.
    next.view.tab = Tab::Inspector;
    let lesson = Lesson::new(Rc::clone(board), own, resumes);
    next.view.layers = Layers {
        trails: lesson.shows(Layer::Trails),
        heat: lesson.shows(Layer::Heat),
    };
    next.view.table = lesson.shows(Layer::Table);
    next.lesson = Some(Rc::new(lesson));
    if let Some(own) = next.document.mode.steering() {
        next.view.selection = Selection::Agent(own.agent);
    }
    *state = next;
    if board.plan == BoardPlan::Best && state.document.mode.is_editing() {
        solve::start(state, solve::Start::quiet());
    }
    play::seek(state, board.time);
    if board.playing {
        play::begin(state);
    }
    if state.lesson().is_some_and(Lesson::is_by_hand) {
        inside::begin_in_lesson(state);
    }
}

fn refusal(faults: &[Fault]) -> Notice {
    Notice::refusal(tr_data!("The board of this lesson cannot be shown."))
        .with(faults.iter().map(ToString::to_string))
}

/// Whether the best plan is searched for.
fn is_searching(state: &State) -> bool {
    let run = state.work.solving();
    run.is_some_and(|run| run.planner.is_none() && run.then.is_none())
}

/// A person's own page as it is put aside: nothing runs on it, and nothing plays. What
/// a search has found stays, and it goes on from there when the lesson ends.
fn aside(state: &State) -> State {
    let mut own = state.clone();
    solve::cancel(&mut own);
    own.intake.end();
    own.view.playback.playing = false;
    own.view.notice = None;
    // Who has found the course needs no welcome.
    own.view.waiting.welcome = false;
    own
}

/// What goes along from one board to another: what a person set, and the numbers by
/// which late answers are known.
fn carry(from: &State, to: &mut State) {
    to.settings = from.settings;
    to.work = from.work.clone();
    to.work.end();
    to.intake = from.intake.clone();
    to.intake.end();
    let (view, before) = (&mut to.view, &from.view);
    view.theme = before.theme;
    view.is_wide = before.is_wide;
    view.presenting = before.presenting;
    view.tab = before.tab;
    view.playback.speed = before.playback.speed;
}

/// The lesson ends: a person's own page is back, where it was.
fn leave(state: &mut State) {
    stroke::abandon(state);
    if let Some(lesson) = state.lesson.take() {
        let mut own = (*lesson.own).clone();
        let speed = own.view.playback.speed;
        carry(state, &mut own);
        own.view.playback.speed = speed;
        *state = own;
        if lesson.resumes {
            solve::start(state, solve::Start::quiet());
        }
    }
}

/// Does what a person could do. Outside of a tour nobody asks for it.
fn tour(state: &mut State, deed: Deed) {
    if !state.lesson.as_ref().is_some_and(|lesson| lesson.is_tour()) {
        return;
    }
    let action = match deed {
        Deed::Select(name) => {
            let mut agents = state.document.agents().iter();
            let agent = agents.position(|agent| agent.name == name);
            agent.map(|agent| Action::Board(BoardAction::Select(Selection::Agent(agent))))
        }
        Deed::Ask => {
            let first = ask::offers(state).into_iter().next();
            let offer = first.and_then(|group| group.offers.into_iter().next());
            offer.map(|offer| Action::Ask(AskAction::Ask(offer.question)))
        }
        Deed::Paint(cell) => Some(Action::Edit(Edit::Paint(Paint::Obstacle, cell, true))),
        Deed::Solve => Some(Action::Solve(SolveAction::Solve)),
        Deed::Rule(zone, rule) => {
            super::rules::show(state, &zone, rule);
            None
        }
        Deed::Price => Some(Action::Rules(RuleAction::Price)),
    };
    if let Some(action) = action {
        step(state, action);
    }
}

/// What shows that something is so.
fn show(state: &mut State, found: &Evidence) {
    let revealed = if found.proved {
        Revealed::Best
    } else {
        Revealed::Shown
    };
    change(state, |lesson| lesson.revealed = revealed);
    if let Some(lesson) = state.lesson.clone() {
        state.view.layers.trails = lesson.shows(Layer::Trails);
        state.view.table = lesson.shows(Layer::Table);
    }
    let draft = Rc::clone(&state.document.draft);
    let shown = found.plan.as_ref();
    let changes = found.changes.as_ref();
    if let Some(document) = shown.and_then(|plan| evidence(&draft, plan, changes)) {
        amend(state, document);
    }
    if let Some(found) = &found.without {
        let plan = found.plan.clone();
        state.view.rules.without = crate::rules::best_without(state, found.rule as usize, plan);
    }
    if let Some(time) = found.time {
        play::seek(state, time);
    }
}
