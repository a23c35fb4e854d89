//! One robot after the other: the orders, and how far each comes.

use super::*;
use crate::board::Cast;
use crate::inside::notes;
use crate::table;

fn open(state: &State) -> State {
    settled(&inside(state, [InsideAction::By(Method::Orders)]))
}

#[test]
fn all_orders_of_few_robots_are_tried() {
    let state = open(&solved(&last_in()));
    let (title, orders) = shown(&state).orders.unwrap();
    assert_eq!(title, "All 6 orders get stuck");
    let outcomes: Vec<&str> = orders.iter().map(|row| row.outcome.as_str()).collect();
    assert_eq!(
        outcomes,
        [
            "A2 stuck", "A3 stuck", "A1 stuck", "A3 stuck", "A2 stuck", "A1 stuck"
        ]
    );
    let note = shown(&state).note.unwrap();
    assert!(note.starts_with("There is a plan: makespan 10"), "{note}");
}

#[test]
fn lanes_stand_in_the_order_of_planning() {
    let state = inside(&open(&last_in()), [InsideAction::Order(5)]);
    let told = notes(&state).unwrap();
    let who: Vec<(usize, &str)> = told
        .iter()
        .map(|note| (note.agent, note.around.as_str()))
        .collect();
    assert_eq!(
        who,
        [
            (2, "plans freely"),
            (1, "plans around A3"),
            (0, "around A3 and A2")
        ]
    );
    let stop = told[2].stop.as_ref().unwrap();
    assert_eq!((stop.time, stop.text.as_str()), (5, "no free cell at 6"));
    assert!(stop.room() > 0);
    let verdict = shown(&state).verdict.unwrap();
    assert_eq!(
        (verdict.word.as_str(), verdict.beside.as_str()),
        ("Stuck", "in this order")
    );
    // The board stands where it is stuck, and says so.
    assert_eq!(state.view.playback.time, 5);
    let (cell, text) = overlay(&state).stuck.unwrap();
    assert_eq!((cell, text.as_str()), (Cell::new(6, 1), "stuck at 6"));
    assert_eq!(
        Cast::of(&state).pose(0, 5.0).unwrap().at,
        crate::Point { x: 6.0, y: 1.0 }
    );
}

#[test]
fn who_has_not_arrived_has_no_goal_in_its_lane() {
    let state = inside(&open(&last_in()), [InsideAction::Order(5)]);
    let answer = state.shown().unwrap();
    let lanes = table::lanes(answer, &state.document.draft);
    let arrives: Vec<bool> = lanes.iter().map(|lane| lane.arrives).collect();
    assert_eq!(arrives, [false, true, true]);
    // Before it plans, it has no way at all.
    let before = inside(&state, [InsideAction::Robots(1)]);
    let answer = before.shown().unwrap();
    let lanes = table::lanes(answer, &before.document.draft);
    let arrives: Vec<bool> = lanes.iter().map(|lane| lane.arrives).collect();
    assert_eq!(arrives, [false, false, true]);
    assert_eq!(overlay(&before).lit, Some(vec![2]));
    assert_eq!(overlay(&before).stuck, None);
}

#[test]
fn robots_come_one_by_one() {
    let state = open(&last_in());
    let first = inside(&state, [InsideAction::First]);
    assert_eq!(steps(&first).unwrap().at, "1");
    assert!(!steps(&first).unwrap().has_before);
    let next = inside(&first, [InsideAction::Next]);
    assert_eq!(
        (
            steps(&next).unwrap().at.as_str(),
            steps(&next).unwrap().of.as_str()
        ),
        ("2", "of 3 robots")
    );
}

#[test]
fn an_order_that_works_says_what_it_costs() {
    let state = open(&crossing());
    let (title, orders) = shown(&state).orders.unwrap();
    assert_eq!(title, "All 2 orders work");
    assert_eq!(orders[0].outcome, "sum of costs 5");
    let verdict = shown(&state).verdict.unwrap();
    assert_eq!(
        verdict.text,
        "Sum of costs 5, makespan 3. There may be better plans."
    );
    assert_eq!(
        said(&state),
        format!("It works in this order: {}", verdict.text)
    );
}

#[test]
fn what_is_kept_is_at_a_time_of_its_own_plan() {
    // The scene has no plan yet; the order that is looked at goes on until time 5.
    let state = inside(&open(&last_in()), [InsideAction::Order(5)]);
    assert_eq!((state.view.playback.time, state.moment().time), (5, 0));
}
