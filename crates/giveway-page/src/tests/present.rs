//! The page before a room: begun and ended by keys, questions one after the other, what
//! is said, a hand that only points; in a lesson, too.

use giveway_model::{Cell, Question};

use crate::board::{Reasons, reasons};
use crate::keys::{Command, Key, command};
use crate::present::{BEGIN, END, Presenting, third};
use crate::reduce::tests::{after, asked_and_answered};
use crate::sample::solved;
use crate::tests::answered;
use crate::{
    Action, AskAction, BoardAction, Draft, PlayAction, SolveAction, State, Tool, ViewAction, ask,
};

fn key(name: &str, state: &State) -> Option<Action> {
    let key = Key {
        name,
        ..Key::default()
    };
    match command(key, state) {
        Some(Command::Act(action)) => Some(action),
        _ => None,
    }
}

/// The state after keys that all do something.
fn pressed(state: &State, names: &[&str]) -> State {
    names.iter().fold(state.clone(), |state, name| {
        let action = key(name, &state).unwrap_or_else(|| panic!("{name} does nothing"));
        after(&state, [action])
    })
}

fn presented() -> State {
    pressed(&solved(), &["p"])
}

fn question(state: &State) -> Option<Question> {
    let asking = state.document.mode.asking()?;
    Some(asking.question().clone())
}

#[test]
fn keys_begin_hide_and_end_it() {
    let at = |state: &State| state.view.presenting;
    assert_eq!(at(&solved()), Presenting::Off);
    let state = presented();
    assert_eq!((at(&state), state.is_presented()), (Presenting::Told, true));
    let bare = pressed(&state, &["H"]);
    assert_eq!(at(&bare), Presenting::Bare);
    assert_eq!(at(&pressed(&bare, &["h"])), Presenting::Told);
    for end in ["Escape", "p"] {
        assert_eq!(at(&pressed(&bare, &[end])), Presenting::Off);
    }
    // A notice, a selection, a question: they are there afterwards.
    let asked = pressed(&state, &["ArrowDown", "Escape"]);
    assert!(question(&asked).is_some() && !asked.is_presented());
    // Who turned letters off has the menu, and Escape.
    let mut quiet = presented();
    quiet.settings.letter_keys = false;
    assert_eq!(key("h", &quiet), None);
    assert_eq!(key("Escape", &quiet), Some(END));
    // Inside another page there is no room.
    let mut embedded = solved();
    embedded.view.place = crate::Place::Embedded;
    assert_eq!(key("p", &embedded), None);
    assert!(!after(&embedded, [BEGIN]).is_presented());
}

#[test]
fn arrows_and_a_clicker_go_through_the_plan() {
    let state = presented();
    let time = |state: &State| state.view.playback.time;
    assert_eq!(time(&pressed(&state, &["ArrowRight", "PageDown"])), 2);
    assert_eq!(
        time(&pressed(
            &state,
            &["ArrowRight", "ArrowRight", "PageUp", "ArrowLeft"]
        )),
        0
    );
    assert_eq!(key(" ", &state), Some(Action::Play(PlayAction::Pause)));
    let stands = pressed(&state, &["ArrowRight"]);
    assert_eq!(key(" ", &stands), Some(Action::Play(PlayAction::Play)));
    // Without a plan there is no time.
    let empty = after(&State::new(Draft::default()), [BEGIN]);
    for name in ["ArrowRight", "PageDown", " "] {
        assert_eq!(key(name, &empty), None, "{name}");
    }
    // What cannot be seen now is not begun.
    for name in ["o", "x", "m", "l", "/", "n"] {
        assert_eq!(key(name, &state), None, "{name}");
    }
}

#[test]
fn up_and_down_change_the_question() {
    let state = presented();
    let offers = ask::offers(&state)
        .into_iter()
        .flat_map(|group| group.offers);
    let all: Vec<Question> = offers.map(|offer| offer.question).collect();
    assert!(all.len() > 1);
    assert_eq!(key("ArrowUp", &state), None);
    let first = pressed(&state, &["ArrowDown"]);
    assert_eq!(question(&first).as_ref(), all.first());
    let second = pressed(&first, &["ArrowDown"]);
    assert_eq!(question(&second).as_ref(), all.get(1));
    // A clicker does the same once a question is open.
    assert_eq!(
        question(&pressed(&first, &["PageDown"])).as_ref(),
        all.get(1)
    );
    assert_eq!(
        question(&pressed(&second, &["PageUp"])).as_ref(),
        all.first()
    );
    // Before the first one there is none, after the last one none either.
    assert_eq!(question(&pressed(&first, &["ArrowUp"])), None);
    let last = (1..all.len()).fold(first, |state, _| pressed(&state, &["ArrowDown"]));
    assert_eq!(question(&last).as_ref(), all.last());
    assert_eq!(key("ArrowDown", &last), None);
}

#[test]
fn the_verdict_comes_first() {
    assert_eq!(third(&presented()), None, "nothing was asked");
    let asked = pressed(&presented(), &["ArrowDown"]);
    let said = third(&asked).unwrap();
    assert_eq!(said.question, ask::card(&asked).unwrap().question);
    assert_eq!(said.verdict, None);
    assert_eq!(said.text, "Looking at the plan");
    let told = after(&asked_and_answered(), [BEGIN]);
    let said = third(&told).unwrap();
    assert_eq!(said.verdict, Some("It would cost more."));
    assert_eq!(said.text, "1 more charge.");
    assert_eq!(third(&pressed(&told, &["h"])), None, "hidden");
    assert_eq!(third(&after(&told, [END])), None, "the inspector tells it");
}

#[test]
fn a_hand_only_points() {
    let state = after(
        &solved(),
        [Action::Board(BoardAction::PickTool(Tool::Obstacle)), BEGIN],
    );
    assert_eq!(state.view.tool, Tool::Select);
    let start = state.document.agents()[0].start;
    assert!(solved().can_move(start) && !state.can_move(start));
    let to = Cell::new(start.x, start.y + 1);
    let dragged = after(
        &state,
        [
            Action::Board(BoardAction::Press(start)),
            Action::Board(BoardAction::Drag(vec![to])),
            Action::Board(BoardAction::Release),
        ],
    );
    assert_eq!(dragged.document, state.document);
    assert_eq!(dragged.selected_agent(), Some(0));
    // What is asked then is about the robot that was pointed at.
    let asked = pressed(&dragged, &["ArrowDown"]);
    assert_eq!(question(&asked).unwrap().agent(), Some("A1"));
    let closed = after(&asked, [Action::Ask(AskAction::Close)]);
    assert!(closed.is_presented());
}

/// A scene without a plan for two reasons: two robots that cannot pass each other, and one
/// whose battery is too small.
fn impossible() -> State {
    let scene = r####"{"giveway":1,"map":["...","###","..."],"agents":[
        {"name":"A1","start":[0,0],"goal":[2,0]},{"name":"A2","start":[2,0],"goal":[0,0]},
        {"name":"A3","start":[0,2],"goal":[2,2],"battery":{"capacity":2,"initial":1}}]}"####;
    let scene = giveway_model::format::native::read_scene(scene).unwrap();
    let state = State::new(Draft::new(scene).unwrap());
    answered(&after(&state, [Action::Solve(SolveAction::Begin), BEGIN]))
}

#[test]
fn all_causes_are_named_by_the_numbers_of_their_marks() {
    let asked = after(
        &impossible(),
        [Action::Ask(AskAction::Ask(Question::Unsolvable))],
    );
    assert_eq!(third(&asked).unwrap().causes, []);
    let told = answered(&asked);
    let said = third(&told).unwrap();
    assert_eq!(said.verdict, Some("There is none."));
    assert_eq!(
        said.text,
        "A3 cannot do its task, even alone. There is another cause, too."
    );
    let causes: Vec<_> = said
        .causes
        .iter()
        .map(|it| (&*it.numbers, &*it.text))
        .collect();
    assert_eq!(
        causes,
        [
            ("1\u{2013}2", "These facts together rule it out: A3"),
            (
                "3\u{2013}8",
                "These facts together rule it out, too: A1 and A2"
            ),
        ]
    );
    let spots = reasons(&told).spots;
    assert!(!spots.is_empty() && spots.iter().all(|spot| spot.number <= 8));
    let verdict = ask::card(&told).unwrap().verdict.unwrap();
    assert_eq!(verdict.sentence, said.text);
    let standing = crate::words::standing(&told).sentence;
    assert!(standing.ends_with(&said.text), "{standing}");
}

#[test]
fn nothing_of_an_answer_is_left_when_answers_are_hidden() {
    // Before the first question already: the page leaves out the headline.
    let bare = pressed(&presented(), &["h"]);
    assert!(bare.hides_answers() && bare.plan().is_some());
    assert!(!pressed(&bare, &["h"]).hides_answers());
    let asked = after(
        &impossible(),
        [Action::Ask(AskAction::Ask(Question::Unsolvable))],
    );
    // Also while the solver is at work on the question.
    let told = answered(&pressed(&asked, &["h"]));
    assert_eq!((third(&told), reasons(&told)), (None, Reasons::default()));
    assert_ne!(reasons(&pressed(&told, &["h"])), Reasons::default());
    // The other plan of an answer is part of it, beside this one or in its place.
    let told = after(&asked_and_answered(), [BEGIN]);
    let wide = after(&told, [Action::View(ViewAction::SetWide(true))]);
    let hidden = pressed(&wide, &["h"]);
    assert!(wide.beside().is_some() && hidden.beside().is_none());
    let other = after(&told, [Action::Ask(AskAction::ShowOther(true))]);
    let hidden = pressed(&other, &["h"]);
    assert_ne!(other.shown(), other.document.answer.as_ref());
    assert_eq!(hidden.shown(), hidden.document.answer.as_ref());
}
