//! The methods answer side by side.

use giveway_model::Cell;

use super::{changing, joined, list};
use crate::changing::{Choice, columns, fate};
use crate::reduce::tests::{after, stroke};
use crate::tests::{answer, answered, saying, seek};
use crate::{Action, ChangeAction, Phase, SolveAction, Task, Tool};

#[test]
fn the_methods_answer_side_by_side() {
    let state = after(&joined(), [Action::Change(ChangeAction::Adapt)]);
    assert_eq!(state.phase(), Phase::Adapting);
    let Some(Task::Change(run)) = state.work.task() else {
        panic!("{:?}", state.work);
    };
    assert_eq!(run.request.since, Some(1));
    let state = answered(&state);
    assert_eq!(state.phase(), Phase::Comparing);
    let columns = columns(&state).unwrap();
    let titles: Vec<&str> = columns
        .iter()
        .flat_map(|column| column.titles.clone())
        .collect();
    assert_eq!(
        titles,
        ["New times", "Near the old paths", "Everything new"]
    );
    let replan = columns.last().unwrap();
    assert_eq!(
        (replan.costs[0].before, replan.costs[0].after),
        (Some(4), 4)
    );
    assert_eq!(replan.costs[0].difference().as_deref(), Some("same"));
    assert!(replan.is_least);
    assert_eq!(replan.groups[3].agents, [(2, "A3".to_owned())]);
    let note = "The sum counts A3 from time 0 on.";
    assert_eq!(replan.counted, [note]);
    let chosen = columns.iter().position(|column| column.is_chosen);
    assert_eq!(chosen, Some(0), "the closest of the best");
    let said = saying(&state);
    assert!(said.starts_with("At time 1: "), "{said}");
    assert_eq!(state.last_time(), 4);
    let other = after(&state, [Action::Change(ChangeAction::Preview(2)), seek(4)]);
    assert_eq!(other.view.playback.time, 4);
    assert_eq!(fate(&other, "A3").as_deref(), Some("joins at 1"));
    assert_eq!(fate(&other, "A1").as_deref(), Some("as before"));
    // A further change makes the answers old.
    let more = after(&state, stroke(Tool::Charger, &[(0, 2)]));
    assert_eq!(more.phase(), Phase::Changing);
    assert_eq!(list(&more).len(), 2);
}

#[test]
fn only_the_methods_chosen_are_asked_and_one_at_least() {
    let choice = Choice {
        revise: false,
        tunnel: false,
        ..Choice::default()
    };
    let state = after(
        &joined(),
        [
            Action::Change(ChangeAction::ChooseMethods(choice)),
            Action::Change(ChangeAction::Adapt),
        ],
    );
    let state = answered(&state);
    assert_eq!(columns(&state).unwrap().len(), 1);
    let none = Choice {
        replan: false,
        ..choice
    };
    let state = after(&state, [Action::Change(ChangeAction::ChooseMethods(none))]);
    assert_eq!(state.settings.methods, choice);
}

#[test]
fn it_is_cancelled_at_once_and_a_late_answer_is_ignored() {
    let state = after(&joined(), [Action::Change(ChangeAction::Adapt)]);
    let late = answer(&state);
    let state = after(&state, [Action::Solve(SolveAction::Cancel)]);
    assert_eq!(state.phase(), Phase::Changing);
    assert_eq!(list(&state).len(), 1);
    assert_eq!(after(&state, [late]), state);
}

#[test]
fn nothing_is_asked_of_an_empty_list() {
    let state = after(&changing(), [Action::Change(ChangeAction::Adapt)]);
    assert!(state.work.is_idle());
    assert!(state.view.notice.is_some());
}

#[test]
fn an_obstacle_on_a_path_frees_its_agent_and_says_why() {
    // A1 goes on over (2, 0).
    let state = after(&changing(), stroke(Tool::Obstacle, &[(2, 0)]));
    let state = answered(&after(&state, [Action::Change(ChangeAction::Adapt)]));
    let columns = columns(&state).unwrap();
    let freed = columns[0]
        .groups
        .iter()
        .find(|group| group.title == "Freed");
    assert_eq!(freed.unwrap().agents, [(0, "A1".to_owned())]);
    assert_eq!(columns[0].promise, "Same paths, same times, except A1");
    assert_eq!(
        columns.last().unwrap().titles.last(),
        Some(&"Everything new")
    );
    assert!(
        columns[0].notes[0].contains("obstacle at (2, 0)"),
        "{:?}",
        columns[0].notes
    );
    let world = after(&state, [seek(1)]);
    assert!(!world.world().grid().is_vertex(Cell::new(2, 0)));
    let before = after(&state, [seek(0)]);
    assert!(before.world().grid().is_vertex(Cell::new(2, 0)));
}
