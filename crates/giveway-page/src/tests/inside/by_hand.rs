//! Search by hand: chosen, split, taken back, proved.

use super::*;
use crate::board::Cast;
use crate::inside::by_hand::{HandColumn, column as by_hand_column, dock};
use crate::inside::{HandAction, InsideAction, tree_view};
use crate::keys::{Command, Key, command};
use crate::words::Badge;
use crate::words::standing;

/// The second split can give a plan of 18, while a branch of 17 is open.
fn lanes() -> State {
    State::new(draft(
        r##"{ "giveway": 1, "objective": ["sum-of-costs"], "map": ["......", "#..##.", ".#..#.", "......"],
            "agents": [
            { "name": "A1", "start": [0, 3], "goal": [2, 0] },
            { "name": "A2", "start": [3, 2], "goal": [2, 2] },
            { "name": "A3", "start": [4, 0], "goal": [0, 3] } ] }"##,
    ))
}

fn hand(state: &State, actions: impl IntoIterator<Item = HandAction>) -> State {
    let mut state = state.clone();
    for action in actions {
        state = settled(&inside(&state, [InsideAction::Hand(action)]));
    }
    state
}

/// The search by hand, by its switch.
fn open(state: &State) -> State {
    let tree = settled(&inside(state, [InsideAction::By(Method::Tree)]));
    hand(&tree, [HandAction::Show(true)])
}

fn told(state: &State) -> HandColumn {
    by_hand_column(state).unwrap()
}

/// Chooses the conflict of these two, and the robot that the split names.
fn choose(state: &State, pair: [&str; 2], named: &str) -> State {
    let column = told(state);
    let mut rows = column.conflicts.iter();
    let place = rows.position(|row| {
        row.robots
            .iter()
            .all(|(_, name)| pair.contains(&name.as_str()))
    });
    let chosen = hand(state, [HandAction::Conflict(place.unwrap())]);
    let robots = told(&chosen).robots;
    let robot = robots.iter().position(|row| row.name == named).unwrap();
    hand(&chosen, [HandAction::Robot(robot)])
}

fn says(state: &State) -> (Badge, String) {
    let standing = standing(state);
    (standing.badge, standing.sentence)
}

#[test]
fn a_person_chooses_and_sees_both_branches_before() {
    let state = open(&lanes());
    let column = told(&state);
    assert_eq!(column.title, "Cost 13. Which conflict?");
    assert!(column.conflicts.len() > 1 && column.conflicts[0].is_on);
    assert!(
        column.steps.is_empty(),
        "the planner's choice is not told before"
    );
    assert_eq!(column.branches.len(), 2);
    let drawn = tree_view(&state).unwrap();
    assert_eq!((drawn.nodes.len(), drawn.ghosts.len()), (1, 2));
    assert_eq!(drawn.ghosts[0].cost, column.branches[0].cost);
    assert_eq!(
        says(&state),
        (
            Badge::ByHand,
            "No plan yet. The cheapest open branch costs 13, so no plan costs less.".to_owned()
        )
    );
    assert_eq!(
        dock(&state).unwrap(),
        ("1".to_owned(), "node, 0 splits".to_owned())
    );
}

#[test]
fn a_plan_is_found_and_proved_later() {
    let first = hand(
        &choose(&open(&lanes()), ["A2", "A3"], "A2"),
        [HandAction::Split],
    );
    let step = told(&first).steps[0].clone();
    assert_eq!(
        (step.cost.as_str(), step.text.as_str()),
        ("13", "A3 runs into A2, on A2")
    );
    assert_eq!(step.gave, "gave 17 and 15");
    assert_eq!(
        step.planner,
        "Planner: A1 runs into A2, on A2, gives 16 and 21"
    );
    assert_eq!(
        said(&first),
        "Split 1: A3 runs into A2, on A2, gives 17 and 15."
    );
    let two = settled(&inside(&first, [InsideAction::Node(2)]));
    let early = hand(&choose(&two, ["A1", "A2"], "A2"), [HandAction::Split]);
    assert_eq!(
        says(&early).1,
        "A plan of 18 is found. A branch of 17 is still open, so it may not be the best."
    );
    let column = told(&early);
    assert_eq!(column.steps[0].gave, "gave 18 without a conflict and 21");
    let found = tree_view(&early).unwrap();
    let class = |view: &crate::inside::TreeView, id: u64| {
        view.nodes.iter().find(|node| node.id == id).unwrap().class
    };
    assert_eq!(class(&found, 3), "found");

    let one = settled(&inside(&early, [InsideAction::Node(1)]));
    assert_eq!(told(&one).title, "Cost 17. Which conflict?");
    let third = hand(&choose(&one, ["A1", "A3"], "A1"), [HandAction::Split]);
    assert_eq!(
        says(&third),
        (
            Badge::Proved,
            "Optimal: sum of costs 18. Found and proved by hand.".to_owned()
        )
    );
    let column = told(&third);
    assert_eq!(column.title, "You took 7 nodes, the planner 9");
    let rows: Vec<[&str; 3]> = column
        .table
        .iter()
        .map(|row| [row.name.as_str(), &row.own, &row.planner])
        .collect();
    assert_eq!(
        rows,
        [
            ["Nodes", "7", "9"],
            ["Splits", "3", "4"],
            ["Nodes to the first plan", "5", "7"],
            ["Dead ends", "0", "1"],
            ["Sum of costs", "18", "18"],
        ]
    );
    assert!(column.verdict.unwrap().text.contains("1 more split showed"));
    assert_eq!(class(&tree_view(&third).unwrap(), 3), "sol");
    // The plan is on the board, from its beginning.
    assert_eq!(third.view.playback.time, 0);
    assert_eq!(third.inside_answer().unwrap().makespan(), 9);
}

#[test]
fn what_is_taken_back_is_as_before_and_can_be_split_again() {
    let state = choose(&open(&lanes()), ["A2", "A3"], "A2");
    let split = hand(&state, [HandAction::Split]);
    let back = hand(&split, [HandAction::TakeBack]);
    assert_eq!(
        tree_view(&back).unwrap().nodes,
        tree_view(&state).unwrap().nodes
    );
    assert_eq!(told(&back).steps, []);
    let again = hand(&back, [HandAction::Again]);
    assert_eq!(tree_view(&again).unwrap(), tree_view(&split).unwrap());
    // A new split forgets what was taken back.
    let other = hand(&back, [HandAction::Split]);
    assert_eq!(hand(&other, [HandAction::Again]), other);
    let begun = hand(&again, [HandAction::Restart]);
    assert_eq!(tree_view(&begun).unwrap().nodes.len(), 1);
    let nothing = hand(&begun, [HandAction::TakeBack]);
    assert!(nothing.inside.by_hand.splits.is_empty());
}

#[test]
fn keys_choose_split_and_take_back() {
    let state = open(&lanes());
    let pressed = |state: &State, name: &str, ctrl: bool| {
        let key = Key {
            name,
            ctrl,
            ..Key::default()
        };
        match command(key, state) {
            Some(Command::Act(action)) => settled(&after(state, [action])),
            other => panic!("{other:?}"),
        }
    };
    let second = pressed(&state, "2", false);
    assert!(told(&second).conflicts[1].is_on);
    let split = pressed(&second, "Enter", false);
    assert_eq!(told(&split).steps.len(), 1);
    let back = pressed(&split, "z", true);
    assert_eq!(told(&back).steps.len(), 0);
    assert_eq!(
        back.document, state.document,
        "no edit of the scene is undone"
    );
    // Without a conflict of that number nothing happens.
    assert_eq!(
        pressed(&state, "9", false).inside.by_hand,
        state.inside.by_hand
    );
}

#[test]
fn the_board_shows_all_robots_on_the_cell_of_the_conflict() {
    let state = open(&crossing());
    assert_eq!(state.view.playback.time, 1);
    assert_eq!(overlay(&state).bursts.len(), 1);
    let cast = Cast::of(&state);
    let aside = |agent| cast.pose(agent, 1.0).unwrap().aside.unwrap().0;
    assert!(aside(0) * aside(1) < 0.0);
}

#[test]
fn an_edit_begins_anew() {
    let split = hand(&open(&crossing()), [HandAction::Split]);
    assert_eq!(split.inside.by_hand.splits.len(), 1);
    let edited = after(&split, [Action::Edit(Edit::Within(Some(9)))]);
    assert!(edited.inside.by_hand.splits.is_empty());
    assert_eq!(tree_view(&settled(&edited)).unwrap().nodes.len(), 1);
}

#[test]
fn the_planners_tree_is_there_again() {
    let tree = settled(&inside(&lanes(), [InsideAction::By(Method::Tree)]));
    let back = hand(
        &hand(&tree, [HandAction::Show(true)]),
        [HandAction::Show(false)],
    );
    assert_eq!(tree_view(&back), tree_view(&tree));
    assert!(by_hand_column(&back).is_none() && column(&back).is_some());
}

#[test]
fn a_planner_that_goes_on_does_not_keep_a_person_waiting() {
    let planning = inside(&lanes(), [InsideAction::By(Method::Tree)]);
    let asked = inside(&planning, [InsideAction::Hand(HandAction::Show(true))]);
    assert_ne!(asked.work.id(), planning.work.id());
    let state = settled(&asked);
    assert_eq!(told(&state).title, "Cost 13. Which conflict?");
    assert!(
        state.looked().unwrap().tree.is_none(),
        "it is compared at the end"
    );
}
