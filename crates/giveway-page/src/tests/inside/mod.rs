//! How the plan was found, looked into: opened, stepped through, and asked about.

mod by_hand;
mod closer;
mod crowds;
mod orders;
mod proof;
mod tree;

use giveway_model::format::native;
use giveway_model::{Cell, Cost};

use super::{answered, page, saying};
use crate::inside::{
    Column, InsideAction, Method, Nothing, column, legend, nothing, overlay, said, steps,
};
use crate::reduce::tests::after;
use crate::{Action, Draft, Edit, PlayAction, Selection, SolveAction, State, Tab, Task};

fn draft(scene: &str) -> Draft {
    Draft::new(native::read_scene(scene).unwrap()).unwrap()
}

/// Two robots that want the middle cell at the same time.
fn crossing() -> State {
    page(&[".b.", "a.A", ".B."], &[Cost::SumOfCosts, Cost::Makespan])
}

/// Three robots in a corridor with one bay: whoever goes first blocks another one.
fn last_in() -> State {
    State::new(draft(include_str!(
        "../../../../../static/examples/last-in.json"
    )))
}

const SOLVE: Action = Action::Solve(SolveAction::Solve);

fn inside(state: &State, actions: impl IntoIterator<Item = InsideAction>) -> State {
    after(state, actions.into_iter().map(Action::Inside))
}

/// With the answers to all that is asked, one after the other.
fn settled(state: &State) -> State {
    let mut state = state.clone();
    while !state.work.is_idle() {
        state = answered(&state);
    }
    state
}

fn solved(state: &State) -> State {
    settled(&after(state, [SOLVE]))
}

fn shown(state: &State) -> Column {
    column(state).unwrap()
}

#[test]
fn it_opens_in_the_place_of_the_lanes_and_closes() {
    let state = solved(&crossing());
    assert!(!state.is_inside() && column(&state).is_none());
    let open = inside(&state, [InsideAction::Show(true)]);
    assert!(open.is_inside());
    assert_eq!(open.view.tab, Tab::Timeline);
    assert_eq!(open.document, state.document, "it only looks");
    assert!(!open.history.can_undo() || state.history.can_undo());
    let closed = inside(&open, [InsideAction::Show(false)]);
    assert!(!closed.is_inside() && column(&closed).is_none());
    assert!(legend(&closed, &overlay(&closed)).is_none());
}

#[test]
fn leaving_it_shows_the_time_that_was_shown_before() {
    let state = after(&solved(&crossing()), [Action::Play(PlayAction::Seek(2))]);
    for method in Method::ALL {
        let open = settled(&inside(&state, [InsideAction::By(method)]));
        let looked = inside(&open, [InsideAction::Last, InsideAction::Back]);
        let closed = inside(&looked, [InsideAction::Show(false)]);
        assert_eq!(closed.view.playback.time, 2, "{method:?}");
        let again = inside(&closed, [InsideAction::Show(false)]);
        assert_eq!(again.view.playback.time, 2, "it is left once");
    }
    let open = inside(&state, [InsideAction::Show(true)]);
    let other = inside(&open, [InsideAction::By(Method::Tree)]);
    let presented = after(&settled(&other), [crate::present::BEGIN]);
    assert_eq!(presented.view.playback.time, 2);
}

#[test]
fn the_best_plan_is_played_from_its_end() {
    let state = inside(
        &solved(&crossing()),
        [InsideAction::Show(true), InsideAction::Last],
    );
    let button = shown(&state).foot.pop().unwrap();
    assert_eq!((button.text, button.is_primary), ("Play the plan", true));
    let playing = inside(&state, [button.action.unwrap()]);
    assert!(!playing.is_inside() && playing.view.playback.playing);
}

#[test]
fn without_a_plan_it_says_what_to_do() {
    let state = inside(&crossing(), [InsideAction::Show(true)]);
    let Nothing { title, action, .. } = nothing(&state);
    assert_eq!(title, "Nothing is proved yet");
    let running = after(&state, [action.unwrap().1]);
    assert_eq!(nothing(&running).title, "The search begins");
    // Nothing of the old scene is told of the new one.
    let edited = after(&solved(&running), [Action::Edit(Edit::Clear)]);
    assert_eq!(column(&edited), None);
    assert_eq!(overlay(&edited), crate::inside::Overlay::default());
}

#[test]
fn an_answer_without_a_record_says_so() {
    let state = inside(&crate::sample::solved(), [InsideAction::Show(true)]);
    let told = nothing(&state);
    assert_eq!(told.title, "No record of this proof was kept");
    assert_eq!(told.text, "Solve again to see how.");
    assert!(crate::files::trace_file(&state).is_none());
}

#[test]
fn what_was_chosen_is_said_to_those_who_listen() {
    let state = inside(&solved(&crossing()), [InsideAction::Show(true)]);
    assert_eq!(
        said(&state),
        "Each robot alone, by its fastest way: at least 4"
    );
    assert_eq!(said(&inside(&state, [InsideAction::Show(false)])), "");
}

#[test]
fn a_robot_that_is_selected_is_told_of_and_given_up_by_the_next_step() {
    let state = inside(&solved(&crossing()), [InsideAction::Show(true)]);
    let selected = after(&state, [super::select(0)]);
    assert_eq!(selected.view.selection, Selection::Agent(0));
    assert!(selected.is_inside());
    let next = inside(&selected, [InsideAction::Next]);
    assert_eq!(next.view.selection, Selection::Nothing);
}
