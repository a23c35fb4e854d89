//! Mirrored, turned, copied, repeated, erased.

use super::*;

#[test]
fn mirrored_twice_and_turned_four_times_it_is_as_it_was() {
    let state = framed(&floor(), (0, 1), (4, 4), Frame::Replace);
    for way in [AreaAction::Mirror(true), AreaAction::Mirror(false)] {
        let once = act(&state, &[way]);
        assert_ne!(map(&once), map(&state), "{way:?}");
        let twice = act(&once, &[way]);
        assert_eq!(twice.document.draft, state.document.draft, "{way:?}");
    }
    let mut turned = state.clone();
    for _ in 0..4 {
        turned = act(&turned, &[AreaAction::Turn]);
    }
    assert_eq!(turned.document.draft, state.document.draft);
    let once = act(&state, &[AreaAction::Turn]);
    assert_eq!(
        once.document.draft.agents()[0].start,
        Cell::new(3, 1),
        "right: (0, 1) is the corner"
    );
}

#[test]
fn what_is_pasted_turns_in_the_hand_even_where_it_does_not_fit() {
    let copied = framed(&floor(), (1, 1), (3, 1), Frame::Replace);
    let copied = act(&copied, &[AreaAction::Copy]);
    let pasted = after(
        &copied,
        [
            Action::Board(BoardAction::MoveCursor(Cell::new(5, 0))),
            Action::Area(AreaAction::Paste),
        ],
    );
    let is_refused = |state: &State| {
        let ghosts = shown(state).unwrap().ghosts;
        ghosts.iter().any(|ghost| ghost.class == "refused")
    };
    assert!(!is_refused(&pasted));
    let mirrored = act(&pasted, &[AreaAction::Mirror(true)]);
    assert!(is_refused(&mirrored), "A2 starts at (7, 0)");
    let twice = act(&mirrored, &[AreaAction::Mirror(true)]);
    assert!(!is_refused(&twice), "it turned where it was refused");
    assert_eq!(map(&mirrored), map(&floor()), "nothing is made yet");
    let refused = act(&mirrored, &[AreaAction::Make]);
    assert_eq!(map(&refused), map(&floor()));
    assert!(refused.view.notice.is_some(), "and it is said");
    let made = act(&refused, &[AreaAction::Nudge(0, 4), AreaAction::Make]);
    assert_eq!(map(&made)[4], "...~.+##", "mirrored");
    let turned = act(
        &refused,
        &[AreaAction::Turn, AreaAction::Nudge(-2, 1), AreaAction::Make],
    );
    let column: String = map(&turned).iter().map(|row| &row[3..4]).collect();
    assert!(column.contains('+'), "{column}");
}

#[test]
fn copies_have_names_of_their_own() {
    let state = act(&selected(), &[AreaAction::Copy]);
    let state = after(
        &state,
        [Action::Board(BoardAction::MoveCursor(Cell::new(4, 4)))],
    );
    let ghost = act(&state, &[AreaAction::Paste]);
    assert_eq!(map(&ghost), map(&state));
    let pasted = act(&ghost, &[AreaAction::Make]);
    let scene = pasted.document.draft.scene();
    assert_eq!(scene.map[4], "...~.##+");
    assert_eq!(scene.agents.len(), 3);
    assert_eq!(
        (scene.agents[2].name.as_str(), scene.agents[2].start),
        ("A3", Cell::new(4, 4))
    );
    assert_eq!(scene.agents[2].goal, Some(Cell::new(6, 5)));
    assert_eq!(
        scene.agents[2].waypoints,
        [Cell::new(5, 5)],
        "only what was there"
    );
    assert!(scene.zones[0].has(Cell::new(4, 5)));
    assert_eq!(scene.constraints.len(), 2);
    assert_eq!(undone(&pasted).document.draft, state.document.draft);
}

#[test]
fn repeated_it_leaves_out_the_copy_that_has_no_room() {
    let scene = Scene {
        map: vec![".".repeat(9); 12],
        agents: vec![agent("A1", (4, 7), (8, 11))],
        ..Scene::default()
    };
    let state = State::new(Draft::new(scene).unwrap());
    let shape = [Action::Board(BoardAction::PickShape(
        crate::draw::Shape::Rectangle,
    ))];
    let rack = after(
        &after(&state, shape),
        crate::reduce::tests::stroke(Tool::Obstacle, &[(1, 0), (6, 1)]),
    );
    let rack = after(&rack, [Action::Board(BoardAction::PickTool(Tool::Select))]);
    let state = framed(&rack, (1, 0), (6, 1), Frame::Replace);
    let state = act(&state, &[AreaAction::Repeat(true), AreaAction::Copies(4)]);
    let repeat = card(&state).unwrap().repeat.unwrap();
    assert_eq!(
        (repeat.step, repeat.to),
        (3, Direction::Down),
        "an aisle is left"
    );
    let classes: Vec<&str> = shown(&state)
        .unwrap()
        .ghosts
        .iter()
        .map(|ghost| ghost.class)
        .collect();
    assert_eq!(
        classes,
        ["comes", "refused", "comes", "refused"],
        "a start, and the end of the map"
    );
    assert_eq!(shown(&state).unwrap().pill.unwrap(), "24 obstacles more");
    let told = card(&state).unwrap().told.unwrap();
    assert!(
        told.starts_with("2 copies are left out: A1 starts at (4, 7)"),
        "{told}"
    );
    // To the right the aisle stays as wide. An obstacle on an obstacle adds nothing.
    let right = act(&state, &[AreaAction::To(Direction::Right)]);
    let step = |state: &State| card(state).unwrap().repeat.unwrap().step;
    assert_eq!(step(&right), 7);
    let close = act(&right, &[AreaAction::Copies(1), AreaAction::Step(1)]);
    assert_eq!(shown(&close).unwrap().pill.unwrap(), "2 obstacles more");
    let down = act(&right, &[AreaAction::To(Direction::Down)]);
    assert_eq!(step(&down), 3);
    let made = act(&state, &[AreaAction::Make]);
    let rows: Vec<usize> = (0..12).filter(|&y| map(&made)[y].contains('#')).collect();
    assert_eq!(rows, [0, 1, 3, 4, 9, 10]);
    assert_eq!(undone(&made).document.draft, rack.document.draft);
}

#[test]
fn erased_its_robots_go_and_goals_stay_open() {
    let state = act(&selected(), &[AreaAction::Erase]);
    let scene = state.document.draft.scene();
    assert_eq!(scene.map[1], "........");
    assert_eq!(scene.agents.len(), 1);
    assert_eq!(scene.agents[0].goal, None);
    let delete = after(&selected(), [Action::Board(BoardAction::Delete)]);
    assert_eq!(delete.document.draft, state.document.draft);
    assert_eq!(undone(&state).document.draft, floor().document.draft);
}

#[test]
fn another_selection_ends_it() {
    let cell = Selection::Cell(Cell::new(5, 5));
    let state = after(&selected(), [Action::Board(BoardAction::Select(cell))]);
    assert!(!state.has_area());
    assert_eq!(state.view.selection, cell);
}

#[test]
fn handles_stretch_it() {
    let state = act(&selected(), &[AreaAction::Stretch(1, 1)]);
    assert_eq!(shown(&drag(&state, (5, 4))).unwrap().frame, [0, 1, 5, 4]);
    let state = act(&selected(), &[AreaAction::Stretch(-1, 0)]);
    assert_eq!(shown(&drag(&state, (2, 5))).unwrap().frame, [2, 1, 3, 2]);
}
