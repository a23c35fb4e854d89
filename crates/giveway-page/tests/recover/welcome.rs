//! A first visit is welcomed once, and never in the way.

use giveway_course::learner::NEXT;
use giveway_course::port::ToPage;
use giveway_course::tour;
use giveway_page::keys::{Command, Key, command};
use giveway_page::lesson::LessonAction;
use giveway_page::slot::{Kind, Lost, Press, Unkept, Weight, message};
use giveway_page::{
    Action, BoardAction, Place, PlayAction, Selection, SlotAction, State, Tool, reduce,
};

use super::{act, edited, link_to, opened, solved, title};

const WELCOME: Option<&str> = Some("Robots share a floor. Who gives way?");

/// A page on its first visit.
fn first() -> State {
    let mut state = solved(&opened("example"));
    state.view.waiting.welcome = true;
    state
}

#[test]
fn it_offers_three_ways_and_one_of_them_first() {
    let told = message(&first()).unwrap();
    assert_eq!((Some(told.title), told.kind), (WELCOME, Kind::Welcome));
    let weights: Vec<Weight> = told.buttons.iter().map(|button| button.weight).collect();
    assert_eq!(
        weights,
        [Weight::Filled, Weight::Outlined, Weight::Quiet],
        "one of them comes first"
    );
    let opens = |index: usize| told.buttons[index].press.clone();
    assert_eq!(opens(0), Press::Learn("tour"));
    assert_eq!(opens(1), Press::Learn(NEXT), "the first lesson");
}

#[test]
fn it_is_closed_by_its_buttons_and_by_escape() {
    let first = first();
    let close = message(&first).unwrap().close.unwrap();
    assert_eq!(title(&reduce(&first, close)), None);
    assert_eq!(title(&act(&first, "Just play")), None);
    let escape = Key {
        name: "Escape",
        ..Key::default()
    };
    let Some(Command::Act(action)) = command(escape, &first) else {
        panic!("Escape does nothing");
    };
    let closed = reduce(&first, action);
    assert_eq!(title(&closed), None);
    assert_eq!(command(escape, &closed), None, "nothing else was open");
}

#[test]
fn it_goes_with_the_first_edit_and_stays_while_a_person_looks() {
    let looks = [
        Action::Play(PlayAction::Play),
        Action::Play(PlayAction::Seek(2)),
        Action::Board(BoardAction::PickTool(Tool::Obstacle)),
        Action::Board(BoardAction::Select(Selection::Agent(0))),
    ];
    let looked = looks
        .into_iter()
        .fold(first(), |state, action| reduce(&state, action));
    assert_eq!(title(&looked), WELCOME);
    let changed = edited(&looked, 5);
    assert_eq!(title(&changed), None);
    assert_eq!(
        title(&reduce(&changed, Action::Undo)),
        None,
        "nor comes it back"
    );
    let linked = reduce(&looked, link_to("theirs"));
    assert_eq!(title(&linked), Some("Your own scene is kept"));
    let close = message(&linked).unwrap().close.unwrap();
    assert_eq!(title(&reduce(&linked, close)), None);
}

#[test]
fn all_else_is_told_before_it() {
    let told = |action| reduce(&first(), Action::Slot(action));
    let unkept = told(SlotAction::Unkept(Unkept::Full));
    assert_eq!(title(&unkept), Some("Your work is not being kept"));
    let close = message(&unkept).unwrap().close.unwrap();
    assert_eq!(
        title(&reduce(&unkept, close)),
        WELCOME,
        "it was not heard yet"
    );
    let lost = told(SlotAction::Lose(Lost::Damaged));
    assert_eq!(message(&lost).unwrap().kind, Kind::Alert);
}

#[test]
fn nobody_is_welcomed_inside_of_another_page_or_in_the_course() {
    let mut inside = first();
    inside.view.place = Place::Embedded;
    assert_eq!(title(&inside), None);
    let (_, effects) = tour::begin(tour::FIRST);
    let says = |message: &ToPage| Action::Lesson(LessonAction::Says(Box::new(message.clone())));
    let tour::Effect::Page(open) = &effects[0] else {
        panic!("it opens no board");
    };
    let toured = reduce(&first(), says(open));
    assert_eq!(title(&toured), None);
    assert_eq!(title(&reduce(&toured, says(&ToPage::Close))), None);
}
