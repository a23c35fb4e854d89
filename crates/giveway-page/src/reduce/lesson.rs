//! A lesson on the board: opened, heard, left.

use giveway_model::tr;
use std::rc::Rc;

use giveway_course::lesson::Layer;
use giveway_course::port::{Board, BoardPlan, Deed, Evidence, Hand, Pick, ToPage};
use giveway_model::{Cell, Fault};

use super::document::{amend, undo};
use super::{play, solve, steer, step, stroke};
use crate::intake::protocol::Reply;
use crate::lesson::{Fate, Lesson, LessonAction, document, evidence, fate};
use crate::present::Presenting;
use crate::steering::Lead;
use crate::view::Layers;
use crate::{
    Action, AskAction, BoardAction, Edit, IntakeAction, Mode, Notice, Paint, Selection,
    SolveAction, State, Tab, ViewAction, ask,
};

pub(super) fn lesson(state: &mut State, action: LessonAction) {
    match action {
        LessonAction::Says(message) => says(state, *message),
        LessonAction::Leave => leave(state),
    }
}

/// An action of which a lesson decides what becomes; `Some` where it is to happen.
pub(super) fn admit(state: &mut State, action: Action) -> Option<Action> {
    let Some(lesson) = state.lesson.clone() else {
        return Some(action);
    };
    match fate(state, &lesson, &action) {
        Fate::Happens => {
            if lesson.board.hand == Hand::Points
                && let Action::Board(action) = &action
                && let Some(cell) = pointed_at(state, action)
            {
                point(state, cell);
            }
            Some(action)
        }
        Fate::Own => {
            let mut own = (*lesson.own).clone();
            step(&mut own, action);
            change(state, |lesson| lesson.own = Rc::new(own));
            None
        }
        Fate::Leaves => {
            open_instead(state, &lesson.own, action);
            None
        }
        Fate::Closed(why) => {
            state.view.notice = Some(Notice::new(why));
            None
        }
        Fate::Dropped => None,
    }
}

/// What would take the place of a lesson happens to a person's own page. Where nothing
/// comes of it, such as of a file that cannot be read, the lesson stays as it is.
fn open_instead(state: &mut State, own: &State, action: Action) {
    let opens = match &action {
        Action::Intake(IntakeAction::Reply { reply, .. }) => matches!(
            **reply,
            Reply::Found(_)
                | Reply::Run(_)
                | Reply::Missing {
                    on_board: Some(_),
                    ..
                }
        ),
        _ => true,
    };
    let mut left = state.clone();
    leave(&mut left);
    // The answer of the reader is for what asked it.
    left.intake = state.intake.clone();
    step(&mut left, action);
    let is_waiting = left.intake.job().is_some() || left.view.notice.is_some();
    let is_same = left.document == own.document && left.history == own.history;
    if is_same && (is_waiting || !opens) {
        state.intake = left.intake;
        state.view.notice = left.view.notice;
    } else {
        *state = left;
    }
}

/// What a person points at: by a press, by a key, or by selecting it.
fn pointed_at(state: &State, action: &BoardAction) -> Option<Cell> {
    match action {
        BoardAction::Press(cell) | BoardAction::Select(Selection::Cell(cell)) => Some(*cell),
        BoardAction::UseTool => Some(state.view.cursor),
        BoardAction::Select(Selection::Agent(agent)) => {
            let is_on = |cell: &Cell| state.agents_at(*cell).any(|other| other == *agent);
            let (width, height) = {
                let grid = state.document.draft.grid();
                (grid.width(), grid.height())
            };
            let all = (0..height).flat_map(|y| (0..width).map(move |x| Cell::new(x, y)));
            // A pointer has brought the cursor there.
            std::iter::once(state.view.cursor).chain(all).find(is_on)
        }
        _ => None,
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
        ToPage::Present => super::view::view(state, &ViewAction::Present(Presenting::Told)),
        ToPage::Close => leave(state),
        // It changes nothing: the page answers by itself.
        ToPage::Take => {}
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
    if board.plan == BoardPlan::Best && state.document.mode == Mode::Editing {
        solve::start(state, solve::Start::quiet());
    }
    play::seek(state, board.time);
    if board.playing {
        play::begin(state);
    }
}

fn refusal(faults: &[Fault]) -> Notice {
    Notice {
        sentence: tr!("The board of this lesson cannot be shown.").to_owned(),
        details: faults.iter().map(ToString::to_string).collect(),
    }
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
    };
    if let Some(action) = action {
        step(state, action);
    }
}

/// What shows that something is so.
fn show(state: &mut State, found: &Evidence) {
    change(state, |lesson| lesson.is_revealed = true);
    if let Some(lesson) = state.lesson.clone() {
        state.view.layers.trails = lesson.shows(Layer::Trails);
        state.view.table = lesson.shows(Layer::Table);
    }
    let draft = Rc::clone(&state.document.draft);
    let shown = found.plan.as_ref();
    if let Some(document) = shown.and_then(|plan| evidence(&draft, plan)) {
        amend(state, document);
    }
    if let Some(time) = found.time {
        play::seek(state, time);
    }
}

/// A person points at a cell.
fn point(state: &mut State, cell: Cell) {
    let draft = &state.document.draft;
    let cell = draft.clamp(cell);
    let robots = state.agents_at(cell);
    let names = robots.filter_map(|agent| draft.agents().get(agent));
    let pick = Pick {
        cell,
        time: state.view.playback.time,
        robots: names.map(|agent| agent.name.clone()).collect(),
    };
    change(state, |lesson| {
        let number = lesson.pick.as_ref().map_or(0, |(number, _)| number + 1);
        lesson.pick = Some((number, pick));
    });
}
