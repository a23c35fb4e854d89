//! The table of the robots.

mod pasted;

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, Battery, Cell, Constraint, Scene};

use super::{Column, RobotsAction, Table, copied, table};
use crate::reduce::tests::after;
use crate::{Action, Draft, State};

fn agent(name: &str, start: (u32, u32), goal: (u32, u32)) -> Agent {
    Agent {
        name: name.to_owned(),
        start: Cell::new(start.0, start.1),
        goal: Some(Cell::new(goal.0, goal.1)),
        waypoints: Vec::new(),
        battery: Some(Battery {
            capacity: 80,
            initial: 60,
        }),
        heading: None,
    }
}

/// A floor of 8 × 4 cells with an obstacle at (4, 1) and three robots; A10 is bound by a rule.
fn floor() -> State {
    let scene = Scene {
        map: ["........", "....#...", "........", "........"]
            .map(str::to_owned)
            .to_vec(),
        agents: vec![
            agent("A10", (0, 0), (7, 0)),
            agent("A2", (0, 1), (7, 1)),
            agent("A3", (0, 2), (7, 2)),
        ],
        constraints: vec![Constraint {
            kind: ConstraintKind::Depart { from: 2 },
            agents: Some(vec!["A10".to_owned()]),
            name: None,
            off: false,
        }],
        ..Scene::default()
    };
    let state = State::new(Draft::new(scene).unwrap());
    act(&state, &[RobotsAction::Show(true)])
}

fn act(state: &State, actions: &[RobotsAction]) -> State {
    after(
        state,
        actions.iter().map(|action| Action::Robots(action.clone())),
    )
}

fn typed(state: &State, row: usize, column: Column, text: &str) -> State {
    act(state, &[RobotsAction::Type(row, column, text.to_owned())])
}

fn pasted(state: &State, text: &str) -> State {
    act(state, &[RobotsAction::Paste(text.to_owned(), false)])
}

fn shown(state: &State) -> Table {
    table(state).unwrap()
}

fn names(state: &State) -> Vec<String> {
    shown(state)
        .rows
        .iter()
        .map(|row| row.cells[0].text.clone())
        .collect()
}

#[test]
fn what_is_typed_is_so_and_undone_in_one_step() {
    let before = floor();
    let state = typed(&before, 1, Column::Start, "(3; 3)");
    assert_eq!(state.document.draft.agents()[1].start, Cell::new(3, 3));
    let state = typed(&state, 1, Column::Waypoints, "1, 1; 2,2");
    assert_eq!(
        state.document.draft.agents()[1].waypoints,
        [Cell::new(1, 1), Cell::new(2, 2)]
    );
    let state = typed(&state, 1, Column::Goal, "");
    assert_eq!(state.document.draft.agents()[1].goal, None);
    let state = typed(&state, 1, Column::Battery, "");
    assert_eq!(state.document.draft.agents()[1].battery, None);
    let state = after(
        &state,
        [Action::Undo, Action::Undo, Action::Undo, Action::Undo],
    );
    assert_eq!(state.document.draft, before.document.draft);
    let renamed = typed(&before, 0, Column::Name, "first");
    let bound = &renamed.document.draft.scene().constraints[0].agents;
    assert_eq!(
        bound.as_deref(),
        Some(&["first".to_owned()][..]),
        "rules follow"
    );
}

#[test]
fn what_cannot_be_keeps_its_text_with_a_remedy() {
    let before = floor();
    let state = typed(&before, 2, Column::Start, "4, 1");
    assert_eq!(state.document, before.document);
    let row = &shown(&state).rows[2];
    assert_eq!(row.cells[1].text, "4, 1");
    assert!(row.cells[1].is_faulty);
    assert_eq!(row.faults[0].why, "(4, 1) is an obstacle.");
    assert_eq!(row.faults[0].remedy.as_ref().unwrap().0, "Keep (0, 2)");
    // Another cell is still edited.
    let state = typed(&state, 0, Column::Level, "50");
    assert_eq!(
        state.document.draft.agents()[0].battery.unwrap().initial,
        50
    );
    let remedied = act(&state, &[RobotsAction::Remedy(2, Column::Start)]);
    assert!(shown(&remedied).rows[2].faults.is_empty());
    let dropped = act(&state, &[RobotsAction::Drop]);
    assert_eq!(shown(&dropped).rows[2].cells[1].text, "0, 2");

    let why = |row, column, text| {
        shown(&typed(&before, row, column, text)).rows[row].faults[0]
            .why
            .clone()
    };
    assert_eq!(
        why(1, Column::Goal, "7, 0"),
        "(7, 0) is the goal of A10 already."
    );
    assert_eq!(why(1, Column::Start, "9, 9"), "(9, 9) is not on the map.");
    assert_eq!(why(1, Column::Start, "here"), "A cell is written 4, 3.");
    assert_eq!(
        why(1, Column::Waypoints, "1, 2, 3"),
        "Cells are written 4, 3; 5, 3."
    );
    assert_eq!(
        why(1, Column::Name, "A3"),
        "There is another robot of this name."
    );
    assert_eq!(why(1, Column::Level, "90"), "The battery holds 80.");
}

#[test]
fn a_saved_table_is_pasted_back_as_it_was() {
    let named = typed(&floor(), 0, Column::Name, "A \"10\", left");
    let state = typed(&named, 0, Column::Waypoints, "1, 1; 2, 2");
    let saved = crate::files::robots_file(&state).unwrap();
    assert_eq!(saved.name, "scene-robots.csv");
    let lines: Vec<&str> = saved.text.split("\r\n").collect();
    assert_eq!(
        lines[0],
        "\u{feff}Name,Start,Waypoints,Goal,Battery,At the start,Arrives,Waits"
    );
    let first = r#""A ""10"", left","0, 0","1, 1; 2, 2","7, 0",80,60,,"#;
    assert_eq!(lines[1], first);
    assert_eq!((lines.len(), lines[4]), (5, ""));
    // Rows that a filter leaves out are saved, too.
    let filtered = act(&state, &[RobotsAction::Filter("A3".to_owned())]);
    assert_eq!(crate::files::robots_file(&filtered).unwrap(), saved);
    assert!(state.takes_robots(&saved.text));
    let again = pasted(&state, &saved.text);
    assert_eq!(again.document, state.document, "nothing is new");
    let empty = act(&state, &[RobotsAction::SelectAll, RobotsAction::Delete]);
    let back = pasted(&empty, &saved.text);
    assert_eq!(
        back.document.draft.agents(),
        state.document.draft.agents(),
        "all come back"
    );
}

#[test]
fn robots_whose_rows_are_selected_stand_out_on_the_board() {
    let state = floor();
    assert_eq!(crate::board::lit(&state), None);
    let selected = act(&state, &[RobotsAction::Select(0), RobotsAction::Select(2)]);
    assert_eq!(crate::board::lit(&selected), Some(vec![0, 2]));
    // Not while the table is closed.
    let closed = act(&selected, &[RobotsAction::Show(false)]);
    assert_eq!(crate::board::lit(&closed), None);
}
