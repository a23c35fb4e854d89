//! Tables that are pasted, and rows as a whole.

use super::*;

#[test]
fn a_table_without_faults_asks_nothing() {
    let text = "Roboter\tZiel\tStart\nA3\t6, 3\t1, 3\nnew\t5,3\t2, 3\n";
    let before = floor();
    assert!(before.takes_robots(text));
    let state = pasted(&before, text);
    assert!(shown(&state).banner.is_none());
    let agents = state.document.draft.agents();
    assert_eq!(
        (agents[2].start, agents[2].goal),
        (Cell::new(1, 3), Some(Cell::new(6, 3)))
    );
    assert_eq!(agents[2].battery.unwrap().initial, 60, "no column has it");
    assert_eq!(
        (agents[3].name.as_str(), agents[3].start),
        ("new", Cell::new(2, 3))
    );
    assert_eq!(
        after(&state, [Action::Undo]).document.draft,
        before.document.draft
    );
}

#[test]
fn csv_without_heads_is_found_by_what_it_holds() {
    let quoted = "R1,\"3, 3\",\"1, 1; 2, 2\",\"5, 3\",40,30\nR2,\"4, 3\",,\"6, 3\",40,20\n";
    assert!(floor().takes_robots(quoted));
    let state = pasted(&floor(), quoted);
    let agents = state.document.draft.agents();
    assert_eq!(agents.len(), 5);
    assert_eq!(agents[3].waypoints, [Cell::new(1, 1), Cell::new(2, 2)]);
    assert_eq!(agents[4].battery.unwrap().initial, 20);
    let halves = "name;start x;start y;goal x;goal y\nR1;3;3;5;3";
    let state = pasted(&floor(), halves);
    let last = state.document.draft.agents().last().unwrap().clone();
    assert_eq!(
        (last.start, last.goal),
        (Cell::new(3, 3), Some(Cell::new(5, 3)))
    );
    for other in [
        "....\n.#..\n",
        "type octile\nheight 1\nwidth 2\nmap\n..\n",
        "{\"a\": [1, 2]}",
        "1\t2\t3\n4\t5\t6",
        "hello, world",
    ] {
        assert!(!floor().takes_robots(other), "{other}");
    }
}

#[test]
fn with_faults_nothing_is_taken_until_it_is_said() {
    let text = "Name\tStart\tGoal\nA10\t0, 0\t6, 0\nA2\t4, 1\t7, 1\nA3\t0, 2\t6, 0";
    let before = floor();
    let state = pasted(&act(&before, &[RobotsAction::Show(false)]), text);
    assert_eq!(state.document, before.document);
    let now = shown(&state);
    let banner = now.banner.unwrap();
    assert_eq!(
        banner.told,
        "3 rows pasted: 1 fit, 2 to look at. Nothing has changed yet."
    );
    assert_eq!(banner.take.unwrap(), "Take the 1");
    assert_eq!(
        now.rows[2].faults[0].why,
        "(6, 0) is the goal of A10 already."
    );
    assert!(now.rows[0].cells[3].is_new && !now.rows[0].cells[1].is_new);
    let taken = act(&state, &[RobotsAction::Take]);
    let agents = taken.document.draft.agents();
    assert_eq!(agents[0].goal, Some(Cell::new(6, 0)));
    assert_eq!(agents[1..], before.document.draft.agents()[1..]);
    let mended = act(
        &state,
        &[
            RobotsAction::Remedy(1, Column::Start),
            RobotsAction::Remedy(2, Column::Goal),
        ],
    );
    assert!(shown(&mended).banner.is_none(), "all of it fits now");
    assert_eq!(
        mended.document.draft.agents()[0].goal,
        Some(Cell::new(6, 0))
    );
    assert_eq!(
        after(&mended, [Action::Undo]).document.draft,
        before.document.draft
    );
    assert_eq!(act(&state, &[RobotsAction::Drop]).document, before.document);
}

#[test]
fn robots_may_change_places_and_names() {
    let text = "Name\tStart\nA10\t0, 1\nA2\t0, 0";
    let state = pasted(&floor(), text);
    let agents = state.document.draft.agents();
    assert_eq!(
        (agents[0].start, agents[1].start),
        (Cell::new(0, 1), Cell::new(0, 0))
    );
}

#[test]
fn a_row_that_does_not_fit_keeps_its_place_from_others() {
    // A3 would go where A2 is, and A2 cannot leave.
    let text = "Name\tStart\nA3\t0, 1\nA2\t4, 1";
    let state = pasted(&floor(), text);
    let faults: Vec<usize> = shown(&state)
        .rows
        .iter()
        .map(|row| row.faults.len())
        .collect();
    assert_eq!(faults, [0, 1, 1]);
}

#[test]
fn a_block_is_pasted_from_the_keyboard_on() {
    let state = act(&floor(), &[RobotsAction::Focus(1, Column::Battery)]);
    let state = act(
        &state,
        &[RobotsAction::Paste("40\t30\n50\t20".to_owned(), true)],
    );
    let levels: Vec<(u32, u32)> = state
        .document
        .draft
        .agents()
        .iter()
        .filter_map(|agent| agent.battery)
        .map(|battery| (battery.capacity, battery.initial))
        .collect();
    assert_eq!(levels, [(80, 60), (40, 30), (50, 20)]);
}

#[test]
fn rows_are_sorted_and_filtered() {
    let sorted = act(&floor(), &[RobotsAction::Sort(Column::Name)]);
    assert_eq!(names(&sorted), ["A2", "A3", "A10"]);
    let back = act(&sorted, &[RobotsAction::Sort(Column::Name)]);
    assert_eq!(names(&back), ["A10", "A3", "A2"]);
    // What is typed goes to the row that is seen.
    let state = typed(&back, 2, Column::Level, "7");
    assert_eq!(state.document.draft.agents()[1].battery.unwrap().initial, 7);
    let filter = |words: &str| names(&act(&state, &[RobotsAction::Filter(words.to_owned())]));
    assert_eq!(filter("a1"), ["A10"]);
    assert_eq!(filter("at the start < 10"), ["A2"]);
    assert_eq!(filter("goal 2"), ["A3"]);
    let bare = typed(&state, 0, Column::Battery, "");
    let none = act(&bare, &[RobotsAction::Filter("no battery".to_owned())]);
    assert_eq!(names(&none), ["A10"]);
}

#[test]
fn an_edit_moves_no_row_of_a_sorted_table() {
    let sorted = act(&floor(), &[RobotsAction::Sort(Column::Name)]);
    let sort = |state: &State| table(state).unwrap().sort;
    assert_eq!(sort(&sorted), Some((Column::Name, false)));
    let renamed = typed(&sorted, 0, Column::Name, "Z");
    assert_eq!(names(&renamed), ["Z", "A3", "A10"]);
    assert_eq!(sort(&renamed), None, "they stand in no order");
    // The next cell that is typed in is the one that is seen.
    let state = typed(&renamed, 0, Column::Level, "7");
    assert_eq!(state.document.draft.agents()[1].battery.unwrap().initial, 7);
    let again = act(&state, &[RobotsAction::Sort(Column::Name)]);
    assert_eq!(names(&again), ["A3", "A10", "Z"]);
    assert_eq!(sort(&again), Some((Column::Name, false)), "not turned");
    // Nor does one take a row out of a filter's.
    let full = RobotsAction::Filter("battery 80".to_owned());
    let state = typed(&act(&again, &[full]), 1, Column::Battery, "70");
    assert_eq!(names(&state), ["A3", "A10", "Z"]);
    // A robot more is another table.
    let more = act(&state, &[RobotsAction::Select(0), RobotsAction::Duplicate]);
    assert_eq!(names(&more).len(), 3, "those with a battery of 80");
}

#[test]
fn selected_rows_are_deleted_doubled_and_get_a_battery() {
    let state = act(
        &floor(),
        &[RobotsAction::Select(0), RobotsAction::Select(2)],
    );
    assert_eq!(shown(&state).count, "3 of 3, 2 selected");
    let gone = act(&state, &[RobotsAction::Delete]);
    assert_eq!(names(&gone), ["A2"]);
    assert_eq!(
        after(&gone, [Action::Undo]).document.draft,
        floor().document.draft
    );
    let charged = act(&state, &[RobotsAction::Battery(Some(50))]);
    let levels: Vec<u32> = charged
        .document
        .draft
        .agents()
        .iter()
        .filter_map(|agent| agent.battery)
        .map(|battery| battery.capacity)
        .collect();
    assert_eq!(levels, [50, 80, 50]);
    let initial = |state: &State| -> Vec<u32> {
        let agents = state.document.draft.agents().iter();
        let batteries = agents.filter_map(|agent| agent.battery);
        batteries.map(|battery| battery.initial).collect()
    };
    let low = act(&charged, &[RobotsAction::Level(30)]);
    assert_eq!(initial(&low), [30, initial(&floor())[0], 30]);
    assert_eq!(after(&low, [Action::Undo]).document, charged.document);
    let high = act(&charged, &[RobotsAction::Level(51)]);
    assert_eq!(
        high.document, charged.document,
        "none begins above its battery"
    );
    let bare = act(&state, &[RobotsAction::Battery(None)]);
    let none = act(&bare, &[RobotsAction::Level(30)]);
    assert_eq!(none.document, bare.document, "there is no battery");
    let doubled = act(&state, &[RobotsAction::Duplicate]);
    assert_eq!(doubled.document.draft.agents().len(), 5);
    assert!(
        doubled.document.draft.instance().is_ok(),
        "free starts and goals"
    );
    assert_eq!(shown(&doubled).selected, 2);
    assert_eq!(
        copied(&doubled).lines().count(),
        3,
        "the new ones, with their heads"
    );
}

#[test]
fn what_is_copied_can_be_pasted() {
    let before = floor();
    let text = copied(&before);
    assert!(text.starts_with("Name\tStart\tWaypoints\tGoal\tBattery\tAt the start\tArrives\tWaits\nA10\t0, 0\t\t7, 0\t80\t60"));
    let emptied = act(&before, &[RobotsAction::SelectAll, RobotsAction::Delete]);
    let back = pasted(&emptied, &text);
    assert_eq!(back.document.draft.agents(), before.document.draft.agents());
}
