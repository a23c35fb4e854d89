//! How many robots the floor bears: said, solved by the solver itself, looked at, taken.

use giveway_model::{Cell, Scene};
use giveway_solve::sizing::SizingFloor;
use giveway_solve::{Response, Status};

use super::{answer, answered};
use crate::reduce::tests::after;
use crate::sizing::{Beside, SizingAction, card, charts, table};
use crate::{Action, BoardAction, Draft, SolveAction, State, Tool, WorkerAction};

/// A floor of two racks and a charger, with a robot and a rule that names it.
fn floor() -> State {
    let scene = r#"{ "giveway": 1, "name": "floor",
        "map": ["..........", "..####.##.", ".+........", "..####.##.", ".........."],
        "agents": [{ "name": "own", "start": [5, 2], "goal": [5, 0],
                     "battery": { "capacity": 30, "initial": 20 } }],
        "zones": [{ "name": "middle", "rect": [2, 2, 8, 2] }],
        "constraints": [{ "kind": "capacity", "zone": "middle", "most": 1 },
                        { "kind": "depart", "agents": ["own"], "from": 3 }] }"#;
    let scene: Scene = giveway_model::format::native::read_scene(scene).unwrap();
    State::new(Draft::new(scene).unwrap())
}

fn act(state: &State, actions: &[SizingAction]) -> State {
    after(state, actions.iter().map(|&action| Action::Sizing(action)))
}

fn opened() -> State {
    act(
        &floor(),
        &[
            SizingAction::Show(true),
            SizingAction::From(2),
            SizingAction::To(6),
            SizingAction::By(2),
        ],
    )
}

/// With the solver's own answer.
fn solved(state: &State) -> State {
    answered(&act(state, &[SizingAction::Solve]))
}

#[test]
fn rows_are_at_both_sides_with_the_battery_of_the_last_robot() {
    let state = opened();
    let card = card(&state).unwrap();
    assert_eq!((card.from, card.to, card.by), (2, 6, 2));
    assert_eq!(
        card.rows,
        "Starts along (0, 0) to (0, 4), goals along (9, 0) to (9, 4)."
    );
    assert_eq!(card.battery.unwrap().initial, 20);
    assert_eq!(card.solve.unwrap(), "Solve 3 plans");
    // A rule of a robot cannot stand beside; that of the zone can.
    assert_eq!(card.choices.len(), 2);
    assert_eq!(
        card.choices[1].1,
        "without the rule: At most 1 robot in 'middle'"
    );
}

#[test]
fn plans_are_charted_and_say_what_follows() {
    let state = solved(&act(
        &opened(),
        &[SizingAction::Beside(Some(Beside::Rule(0)))],
    ));
    let all = charts(&state);
    assert_eq!(all.len(), 3);
    for chart in &all {
        assert_eq!((chart.dots.len(), chart.beside.len()), (3, 3));
        for dot in chart.dots.iter().flatten() {
            assert!((0.0..=1.0).contains(&dot.at.1), "{chart:?}");
            assert!(dot.is_proved);
        }
    }
    // The rule costs something, which the floor without it saves.
    let card = card(&state).unwrap();
    let said: Vec<&str> = card.says.iter().map(|row| row.text.as_str()).collect();
    let rule = "Without the rule: At most 1 robot in 'middle'";
    assert!(
        said[1].starts_with(&format!("{rule}: the last one arrives")),
        "{said:?}"
    );
    assert!(said[1].ends_with("sooner"), "{said:?}");
    let table = table(&state).unwrap();
    assert_eq!(table.lines().count(), 7);
}

#[test]
fn a_plan_is_looked_at_and_nothing_of_the_scene_changes() {
    let state = solved(&opened());
    let own = state.document.clone();
    let looked = act(&state, &[SizingAction::Look(Some(1))]);
    assert_eq!(looked.document.draft.agents().len(), 4);
    assert_eq!(looked.playing().unwrap().solved.status, Status::Optimal);
    assert_eq!(card(&looked).unwrap().take.unwrap(), "Take these 4 robots");
    // What the browser keeps is the own document.
    assert_eq!(looked.moment().document, own);
    assert!(looked.is_kept_alike(&state));
    assert_eq!(looked.history.can_undo(), state.history.can_undo());
    // It plays, another one is looked at, and it is left.
    let other = act(&looked, &[SizingAction::Look(Some(2))]);
    assert_eq!(other.document.draft.agents().len(), 6);
    let left = act(&other, &[SizingAction::Look(None)]);
    assert_eq!(left.document, own);
    // An edit is one of the own scene, not of what is looked at.
    let edited = after(
        &looked,
        [
            Action::Board(BoardAction::PickTool(Tool::Obstacle)),
            Action::Solve(SolveAction::Solve),
        ],
    );
    assert_eq!(edited.document.draft, own.draft);
    let closed = act(&looked, &[SizingAction::Show(false)]);
    assert_eq!(closed.document, own);
    assert!(!closed.shows_sizing());
}

#[test]
fn robots_are_taken_as_one_step_with_their_plan() {
    let state = solved(&opened());
    let taken = act(&state, &[SizingAction::Look(Some(1)), SizingAction::Take]);
    assert_eq!(taken.document.draft.agents().len(), 4);
    let answer = taken.document.fresh_answer().unwrap();
    assert_eq!(answer.solved.status, Status::Optimal);
    // The rule that named the robot that is gone went with it.
    assert_eq!(taken.document.draft.scene().constraints.len(), 1);
    let undone = after(&taken, [Action::Undo]);
    assert_eq!(undone.document, floor().document);
}

#[test]
fn what_is_cancelled_keeps_what_is_there() {
    let state = act(&opened(), &[SizingAction::Solve]);
    let Action::Worker(WorkerAction::Respond { job, response }) = answer(&state) else {
        panic!("an answer")
    };
    let Response::Sized(answer) = *response else {
        panic!("plans of robots")
    };
    let event = giveway_solve::Progress::Sized {
        floor: SizingFloor::This,
        point: Box::new(answer.points[0].clone()),
        pending: 2,
    };
    let heard = after(
        &state,
        [Action::Worker(WorkerAction::Progress { job, event })],
    );
    let progress = card(&heard).unwrap().progress.unwrap();
    assert_eq!(progress.text, "1 of 3 plans, solving 4 robots");
    let cancelled = act(&heard, &[SizingAction::Cancel]);
    assert!(cancelled.work.is_idle());
    assert_eq!(charts(&cancelled)[0].dots.len(), 1);
    // Another sentence is about other plans.
    let other = act(&cancelled, &[SizingAction::Back(false)]);
    assert!(charts(&other).is_empty());
}

#[test]
fn an_edit_of_the_floor_ends_it() {
    let state = act(&opened(), &[SizingAction::Solve]);
    let edited = after(
        &state,
        [Action::Edit(crate::Edit::Name("other".to_owned()))],
    );
    assert!(edited.work.is_idle());
    assert!(charts(&edited).is_empty());
}

#[test]
fn the_cell_of_a_charger_is_pressed_on_the_board() {
    let state = act(&opened(), &[SizingAction::Pick(true)]);
    let press = |cell| Action::Board(BoardAction::Press(cell));
    let select = |cell| Action::Board(BoardAction::Select(crate::Selection::Cell(cell)));
    let selected = after(&state, [select(Cell::new(8, 2))]);
    assert_eq!(
        card(&selected).unwrap().beside,
        "one charger more at (8, 2)"
    );
    let wall = after(&state, [press(Cell::new(3, 1))]);
    assert!(wall.view.notice.is_some());
    assert_eq!(card(&wall).unwrap().beside, "nothing");
    let more = after(
        &state,
        [press(Cell::new(8, 2)), Action::Board(BoardAction::Release)],
    );
    assert_eq!(card(&more).unwrap().beside, "one charger more at (8, 2)");
    assert_eq!(more.document, state.document, "the scene stays");
    assert_eq!(card(&more).unwrap().solve.unwrap(), "Solve 6 plans");
    let less = act(&more, &[SizingAction::Pick(true)]);
    let less = after(&less, [press(Cell::new(1, 2))]);
    assert_eq!(card(&less).unwrap().beside, "one charger less at (1, 2)");
}

#[test]
fn numbers_are_kept_in_their_ranges() {
    let state = act(&opened(), &[SizingAction::From(9)]);
    let told = card(&state).unwrap();
    assert_eq!((told.from, told.to), (9, 9));
    let state = act(&opened(), &[SizingAction::To(99)]);
    assert!(card(&state).unwrap().told.contains("room for 10 robots"));
}
