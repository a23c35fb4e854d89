//! The conflict tree of CBS.

use super::*;
use crate::board::Cast;
use crate::inside::{TreeView, tree_view};

/// The tree of the crossing, by its tab.
fn open(state: &State) -> State {
    settled(&inside(state, [InsideAction::By(Method::Tree)]))
}

fn view(state: &State) -> TreeView {
    tree_view(state).unwrap()
}

#[test]
fn it_is_asked_for_once_when_it_is_opened() {
    let asked = inside(&crossing(), [InsideAction::By(Method::Tree)]);
    assert!(matches!(asked.work.task(), Some(Task::Look(_))));
    assert_eq!(nothing(&asked).title, "CBS plans");
    let state = settled(&asked);
    let closed = inside(
        &state,
        [InsideAction::Show(false), InsideAction::Show(true)],
    );
    assert!(closed.work.is_idle());
    assert_eq!(view(&closed), view(&state));
}

#[test]
fn nodes_say_their_cost_and_conflict() {
    let state = open(&crossing());
    let drawn = view(&state);
    let said: Vec<(&str, String)> = drawn
        .nodes
        .iter()
        .map(|node| (node.cost.as_str(), node.lines.join(" / ")))
        .collect();
    assert_eq!(
        said,
        [
            ("4", "A and B meet / (1, 1) at time 1".to_owned()),
            ("5", "No conflict / never opened".to_owned()),
            ("5", "No conflict: / the best plan".to_owned()),
        ]
    );
    let places: Vec<_> = drawn
        .nodes
        .iter()
        .map(|node| (node.level, node.place))
        .collect();
    assert_eq!(places, [(1, (1, 1)), (2, (1, 2)), (2, (2, 2))]);
    assert_eq!(drawn.nodes[0].is_expanded, Some(true));
    let column = shown(&state);
    assert_eq!(column.title, "Cost 4, and still a conflict");
    assert_eq!(column.verdict.unwrap().word, "It splits in two");
    assert_eq!(column.choices.unwrap().1.len(), 2);
}

#[test]
fn the_board_shows_the_plan_of_the_node_at_its_conflict() {
    let state = open(&crossing());
    assert_eq!(state.view.playback.time, 1);
    assert_eq!(overlay(&state).bursts.len(), 1);
    // Both are on one cell, and stand side by side.
    let cast = Cast::of(&state);
    let aside = |agent| cast.pose(agent, 1.0).unwrap().aside.unwrap().0;
    assert!(aside(0) * aside(1) < 0.0);

    let best = inside(&state, [InsideAction::Last]);
    assert_eq!(shown(&best).verdict.unwrap().word, "The best plan");
    let bans = overlay(&best).bans;
    assert_eq!(bans.len(), 1);
    assert_eq!(
        (bans[0].cell, bans[0].text.as_str()),
        (Some(Cell::new(1, 1)), "at 1")
    );
    assert!(bans[0].is_asked);
    let parent = shown(&best).foot[0].action.unwrap();
    assert_eq!(parent, InsideAction::Node(0));
    assert_eq!(inside(&best, [parent]), state);
}

#[test]
fn keys_open_nodes_in_turn() {
    let state = open(&crossing());
    let next = after(&state, [Action::Play(PlayAction::StepForward)]);
    assert_eq!(shown(&next).verdict.unwrap().word, "The best plan");
    let back = after(&next, [Action::Play(PlayAction::StepBack)]);
    assert_eq!(shown(&back).title, shown(&state).title);
}

#[test]
fn large_trees_fold_what_is_beside_the_path() {
    let state = State::new(draft(
        r#"{ "giveway": 1, "objective": ["sum-of-costs"],
            "map": ["......", "......", "......", "......"], "agents": [
            { "name": "A", "start": [0, 0], "goal": [5, 3] },
            { "name": "B", "start": [5, 3], "goal": [0, 0] },
            { "name": "C", "start": [0, 3], "goal": [5, 0] },
            { "name": "D", "start": [5, 0], "goal": [0, 3] },
            { "name": "E", "start": [2, 0], "goal": [3, 3] },
            { "name": "F", "start": [3, 3], "goal": [2, 0] } ] }"#,
    ));
    let state = open(&state);
    let last = inside(&state, [InsideAction::Last]);
    let drawn = view(&last);
    let all = state.looked().unwrap().tree.clone().unwrap().unwrap();
    let folded: usize = drawn.folds.iter().map(|fold| fold.count).sum();
    assert_eq!(drawn.nodes.len() + folded, all.nodes.len());
    if all.nodes.len() > 60 {
        assert!(folded > 0 && drawn.nodes.len() < 60);
    }
    assert!(drawn.nodes.iter().any(|node| node.is_chosen));
}

#[test]
fn why_there_is_none_is_said() {
    let asked = inside(&crossing(), [InsideAction::By(Method::Tree)]);
    let state = after(&asked, [Action::Solve(SolveAction::Cancel)]);
    assert!(state.work.is_idle(), "it is not asked over and over");
    assert_eq!(tree_view(&state), None);
    assert_eq!(nothing(&state).text, "You stopped it.");
    let column = shown(&state);
    assert_eq!(
        (column.title.as_str(), column.remark.as_deref()),
        ("No conflict tree", Some("You stopped it."))
    );
    let again = settled(&inside(&state, [column.foot[0].action.unwrap()]));
    assert_eq!(view(&again), view(&open(&crossing())));
}
