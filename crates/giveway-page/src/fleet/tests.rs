//! Several robots, drawn in rows and said in a sentence.

use giveway_model::{Battery, Cell};

use super::{FleetAction, card};
use crate::draw::{Measure, Shape};
use crate::reduce::tests::{after, stroke};
use crate::{Action, BoardAction, Draft, SolveAction, State, Tool};

/// A floor of 40 × 24 cells with a shelf.
fn floor() -> State {
    let scene = giveway_model::Scene {
        map: vec![".".repeat(40); 24],
        ..giveway_model::Scene::default()
    };
    let state = State::new(Draft::new(scene).unwrap());
    let shelf = [Action::Board(BoardAction::PickShape(Shape::Rectangle))];
    after(
        &after(&state, shelf),
        stroke(Tool::Obstacle, &[(4, 3), (28, 10)]),
    )
}

fn say(state: &State, actions: &[FleetAction]) -> State {
    after(state, actions.iter().map(|&action| Action::Fleet(action)))
}

/// Eight starts at the left side, eight goals at the right one.
fn drawn() -> State {
    let row = [Action::Board(BoardAction::PickShape(Shape::Row))];
    let state = after(
        &floor(),
        [Action::Board(BoardAction::PickTool(Tool::Agent))],
    );
    let state = after(&state, row);
    let state = after(&state, drag((1, 1), (1, 15)));
    assert!(card(&state).unwrap().add.is_none(), "where do they go?");
    after(&state, drag((38, 1), (38, 15)))
}

fn drag(from: (u32, u32), to: (u32, u32)) -> Vec<Action> {
    stroke(Tool::Agent, &[from, to])
        .into_iter()
        .skip(1)
        .collect()
}

#[test]
fn two_drags_and_a_sentence_are_sixteen_robots() {
    let state = drawn();
    assert_eq!(card(&state).unwrap().add.unwrap(), "Add 8 robots");
    let state = say(
        &state,
        &[
            FleetAction::Back(true),
            FleetAction::Waypoints(2),
            FleetAction::Battery(Some(400)),
            FleetAction::Level(300),
        ],
    );
    let said = card(&state).unwrap();
    assert_eq!(
        (said.count, said.add.as_deref()),
        (8, Some("Add 16 robots"))
    );
    assert!(state.world().agents().is_empty(), "nothing is there before");
    let added = say(&state, &[FleetAction::Add]);
    let agents = added.world().agents();
    assert_eq!(agents.len(), 16);
    for (index, agent) in agents.iter().enumerate() {
        let (from, to) = if index < 8 { (1, 38) } else { (38, 1) };
        let y = 1 + 2 * (u32::try_from(index).unwrap() % 8);
        assert_eq!(
            (agent.start, agent.goal),
            (Cell::new(from, y), Some(Cell::new(to, y)))
        );
        assert_eq!(
            agent.battery,
            Some(Battery {
                capacity: 400,
                initial: 300
            })
        );
        let grid = added.world().grid();
        let beside = |cell: &Cell| {
            let near = |other: Cell| cell.x.abs_diff(other.x) + cell.y.abs_diff(other.y) == 1;
            grid.cells()
                .any(|(other, _)| near(other) && !grid.is_vertex(other))
        };
        assert!(agent.waypoints.len() == 2 && agent.waypoints.iter().all(beside));
    }
    assert!(added.document.draft.problems().is_empty());
    assert_eq!(
        after(&added, [Action::Undo]).world().agents().len(),
        0,
        "one step"
    );
    assert_eq!(
        say(&state, &[FleetAction::Add]),
        added,
        "the same words, the same robots"
    );
    let other = say(&state, &[FleetAction::DrawAgain, FleetAction::Add]);
    assert_ne!(other.world().agents()[0].waypoints, agents[0].waypoints);
}

#[test]
fn going_on_keeps_them_and_cancel_drops_them() {
    let solving = after(&drawn(), [Action::Solve(SolveAction::Solve)]);
    assert_eq!(solving.world().agents().len(), 8);
    assert!(solving.view.fleet.is_none());
    let other = after(
        &drawn(),
        [Action::Board(BoardAction::PickTool(Tool::SlowZone))],
    );
    assert_eq!(other.world().agents().len(), 8);
    let next = after(&drawn(), drag((0, 1), (0, 5)));
    assert_eq!(next.world().agents().len(), 8, "another row begins");
    assert_eq!(card(&next).unwrap().count, 3);
    let none = say(&drawn(), &[FleetAction::Cancel]);
    assert_eq!(none.document, floor().document);
    assert!(card(&none).is_none());
}

#[test]
fn a_count_is_spread_evenly_and_what_does_not_fit_is_said() {
    let state = say(&drawn(), &[FleetAction::Count(Some(3))]);
    let starts = |state: &State| {
        state
            .fleet_agents()
            .iter()
            .map(|a| a.start.y)
            .collect::<Vec<_>>()
    };
    assert_eq!(starts(&state), [1, 8, 15]);
    let all = say(&state, &[FleetAction::Count(Some(99))]);
    let said = card(&all).unwrap();
    assert_eq!(
        (said.count, said.told.as_str()),
        (15, "Only 15 of 99 have a free start and goal there.")
    );
}

#[test]
fn taken_cells_and_obstacles_are_left_out() {
    let state = say(&drawn(), &[FleetAction::Add]);
    let mut actions = vec![Action::Board(BoardAction::SetMeasure(
        Measure::RobotEvery,
        1,
    ))];
    actions.extend(drag((1, 1), (1, 4)));
    actions.extend(drag((4, 12), (7, 12)));
    let state = after(&state, actions);
    let starts: Vec<Cell> = state.fleet_agents().iter().map(|a| a.start).collect();
    assert_eq!(starts, [Cell::new(1, 2), Cell::new(1, 4)]);
    let both = say(&state, &[FleetAction::Back(true), FleetAction::Add]);
    assert!(both.document.draft.problems().is_empty());
}

#[test]
fn rows_over_each_other_give_each_cell_to_one_start_and_one_goal() {
    let row = |state: &State| {
        after(
            state,
            [
                Action::Board(BoardAction::PickTool(Tool::Agent)),
                Action::Board(BoardAction::PickShape(Shape::Row)),
            ],
        )
    };
    let mut actions = drag((1, 12), (9, 12));
    actions.extend(drag((5, 12), (13, 12)));
    actions.push(Action::Fleet(FleetAction::Back(true)));
    actions.push(Action::Fleet(FleetAction::Add));
    let state = after(&row(&floor()), actions);
    assert!(state.document.draft.problems().is_empty());
    assert!(!state.world().agents().is_empty());
}
