//! What is done on the board of a lesson, and what the lesson hears of it.

use giveway_course::port::{BoardNumber, BoardPlan, Hand, Happened, Lit, Pick, ToPage};

use super::{Board, at, board, heard, opened, say, scene, swapping, told};
use crate::audit::bursts_of;
use crate::reduce::tests::{after, stroke};
use crate::steering::Lead;
use crate::tests::{saying, seek, select};
use crate::{Action, BoardAction, PlayAction, Selection, State, Tab, Tool, sample};

fn press(x: u32, y: u32) -> [Action; 2] {
    [
        Action::Board(BoardAction::Press(at(x, y))),
        Action::Board(BoardAction::Release),
    ]
}

#[test]
fn an_edit_is_told_once_when_the_stroke_ends_and_is_taken_back() {
    let lesson = opened(&sample::solved(), board(7));
    let (edited, said) = heard(&lesson, stroke(Tool::Obstacle, &[(1, 0), (2, 0)]));
    let mut after_it = scene();
    after_it.map[0] = ".##.".to_owned();
    assert_eq!(said, [told(7, Happened::Board(Box::new(after_it)))]);
    let sealed = say(&edited, ToPage::Seal(vec![at(1, 0)]));
    assert_eq!(sealed.lesson().unwrap().sealed, [at(1, 0)]);
    let said = |state: &State| crate::words::standing(state).sentence;
    assert_eq!(said(&lesson), "No plan yet.");
    let judged = say(&lesson, ToPage::Seal(vec![at(1, 0)]));
    assert_eq!(said(&judged), "What comes of it is told in the lesson.");
    let action = Action::Lesson(super::says(ToPage::TakeBack));
    let (back, said) = heard(&sealed, [action]);
    assert_eq!(said, [told(7, Happened::Board(Box::new(scene())))]);
    assert!(back.lesson().unwrap().sealed.is_empty());
    let afresh = say(&edited, ToPage::StartAfresh(BoardNumber(8)));
    assert_eq!(afresh.document.draft.scene(), &scene());
    assert_eq!(afresh.lesson().unwrap().board.number, BoardNumber(8));
    let action = Action::Lesson(super::says(ToPage::StartAfresh(BoardNumber(8))));
    assert_eq!(heard(&edited, [action]).1, [], "it knows that itself");
}

#[test]
fn conflicts_are_not_shown_to_who_is_to_find_them() {
    let spot = Board {
        plan: BoardPlan::Given(swapping()),
        hand: Hand::Points,
        ..board(3)
    };
    let lesson = opened(&sample::solved(), spot);
    assert!(lesson.document.mode.audit().is_some());
    assert!(bursts_of(&lesson, "A1").is_empty());
    assert_eq!(saying(&lesson), "Does this plan keep the rules?");
    let (state, said) = heard(&lesson, [seek(1)].into_iter().chain(press(1, 0)));
    let pick = Pick {
        cell: at(1, 0),
        time: 1,
        robots: vec!["A1".to_owned()],
    };
    let expected = [Happened::Time(1), Happened::Picked(pick.clone())];
    assert_eq!(said, expected.map(|what| told(3, what)));
    let (state, said) = heard(&state, press(1, 0));
    let again = [told(3, Happened::Picked(pick))];
    assert_eq!(said, again, "the same again");
    // A click selects, and a key uses the tool where the cursor is.
    let (state, said) = heard(&state, [select(0)]);
    assert_eq!(said, again, "selected");
    let cursor = Action::Board(BoardAction::MoveCursor(at(1, 0)));
    let (state, said) = heard(&state, [cursor, Action::Board(BoardAction::UseTool)]);
    assert_eq!(said, again, "by a key");
    let shown = say(&state, ToPage::Show(Box::default()));
    assert_eq!(bursts_of(&shown, "A1"), [1.5]);
    assert!(saying(&shown).contains("rule"), "{}", saying(&shown));
}

#[test]
fn robots_are_led_step_by_step() {
    let lead = Board {
        hand: Hand::Leads(vec!["A2".to_owned()]),
        tools: Vec::new(),
        ..board(4)
    };
    let lesson = opened(&sample::solved(), lead);
    assert_eq!(lesson.view.selection, Selection::Agent(1));
    let step = |by| Action::Steer(Lead::Step(by));
    let (state, said) = heard(&lesson, [step((-1, 0)), step((-1, 0))]);
    let led = |state: &State| state.document.mode.steering().unwrap().led().0.clone();
    let cells = led(&state).path("A2").to_vec();
    assert_eq!(cells, [at(3, 0), at(2, 0), at(1, 0)].map(Some));
    let plans: Vec<_> = said
        .iter()
        .filter_map(|said| match &said.what {
            Happened::Led(plan) => Some(plan.path("A2").len()),
            _ => None,
        })
        .collect();
    assert_eq!(plans, [2, 3]);
    let back = say(&state, ToPage::TakeBack);
    assert_eq!(led(&back).path("A2").len(), 2);
    let waits = say(&back, ToPage::Wait);
    let cells = led(&waits).path("A2").to_vec();
    assert_eq!(cells, [at(3, 0), at(2, 0), at(2, 0)].map(Some));
    // Nobody else is led.
    let other = after(&state, [select(0), Action::Steer(Lead::Begin)]);
    assert_eq!(other.document, state.document);
    let left = after(&state, [Action::Steer(Lead::Discard)]);
    assert_eq!(left.document, state.document, "only the lesson ends it");
}

#[test]
fn the_robot_that_is_chosen_is_led_on_from_where_it_is() {
    let lead = Board {
        hand: Hand::Leads(vec!["A1".to_owned(), "A2".to_owned()]),
        tools: Vec::new(),
        ..board(4)
    };
    let lesson = opened(&sample::solved(), lead);
    let step = |by| Action::Steer(Lead::Step(by));
    let own = |state: &State| state.document.mode.steering().unwrap().agent;
    let lengths = |state: &State| {
        let plan = state.document.mode.steering().unwrap().led().0.clone();
        ["A1", "A2"].map(|name| plan.path(name).len())
    };
    let one = after(&lesson, [step((1, 0))]);
    assert_eq!((own(&one), lengths(&one)), (0, [2, 1]));
    let chosen = Action::Lesson(super::says(ToPage::Lead("A2".to_owned())));
    let (two, said) = heard(&one, [chosen]);
    assert!(said.contains(&told(4, Happened::Leads("A2".to_owned()))));
    assert_eq!((own(&two), lengths(&two)), (1, [2, 1]));
    assert_eq!(two.view.playback.time, 0, "it has not moved yet");
    let both = after(&two, [step((-1, 0)), step((-1, 0)), select(0)]);
    assert_eq!((own(&both), lengths(&both)), (0, [2, 3]));
    assert_eq!(both.view.playback.time, 1);
    // To choose a robot is no step that can be taken back.
    let back = say(&both, ToPage::TakeBack);
    assert_eq!((own(&back), lengths(&back)), (1, [2, 2]));
    let nobody = say(&both, ToPage::Lead("A9".to_owned()));
    assert_eq!(nobody.document, both.document);
}

#[test]
fn the_lesson_lights_what_it_names() {
    let lesson = opened(&sample::solved(), board(1));
    let lit = Lit::Robot("A1".to_owned());
    let state = say(&lesson, ToPage::Light(Some(lit.clone())));
    assert_eq!(state.lesson().unwrap().lit, Some(lit));
    let dark = say(&state, ToPage::Light(None));
    assert_eq!(dark.lesson().unwrap().lit, None);
    let play = after(&dark, [Action::Play(PlayAction::Play)]);
    assert!(!play.view.playback.playing, "there is no plan to play");
}

#[test]
fn a_phone_shows_the_lesson_first() {
    let lesson = opened(&sample::solved(), board(5));
    assert_eq!(lesson.view.tab, Tab::Inspector);
}
