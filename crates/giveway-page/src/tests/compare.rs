//! Two plans compared, with the solver's own answers: opened at the first difference, stepped
//! through, left at the time before.

use giveway_model::{Cell, Question};

use super::ledger::corridor;
use super::{answered, seek, select};
use crate::beside::{differences, lanes, same, steps, title};
use crate::keys::{Command, Key, command};
use crate::reduce::tests::after;
use crate::{Action, AskAction, ComparedLanes, PlayAction, State, ViewAction};

/// The robot that steps aside is asked about, at time 2.
fn asked() -> State {
    let state = corridor();
    let plan = state.document.answer.as_ref().unwrap();
    let late = plan.arrivals.iter().position(|at| *at > Some(5)).unwrap();
    let question = Question::Visit {
        agent: plan.agents()[late].name.clone(),
        at: Cell::new(2, 1),
        time: None,
    };
    let actions = [
        Action::View(ViewAction::SetWide(true)),
        select(late),
        seek(2),
        Action::Ask(AskAction::Ask(question)),
    ];
    answered(&after(&state, actions))
}

fn press(state: &State, name: &str, shift: bool) -> State {
    let key = Key {
        name,
        shift,
        ..Key::default()
    };
    match command(key, state) {
        Some(Command::Act(action)) => after(state, [action]),
        other => panic!("{name} does {other:?}"),
    }
}

#[test]
fn the_other_plan_opens_at_its_first_difference_and_closes_at_the_time_before() {
    let state = asked();
    let time = state.view.playback.time;
    assert_eq!((state.beside(), steps(&state)), (None, None));
    let shown = press(&state, "n", false);
    let (this, other) = shown.compared().unwrap();
    let all = differences(this, other);
    assert_eq!(shown.view.playback.time, all[0].time);
    let row = steps(&shown).unwrap();
    assert!(
        row.text
            .starts_with(&format!("Difference 1 of {}", all.len()))
    );
    assert_eq!(row.agents.len(), all[0].agents.len());
    assert!(!row.has_previous);
    assert_eq!(row.has_next, all.len() > 1);
    // Forth and back through all of them.
    let mut now = shown.clone();
    for difference in &all[1..] {
        now = press(&now, "n", false);
        assert_eq!(now.view.playback.time, difference.time);
    }
    assert_eq!(press(&now, "n", false), now, "that was the last");
    for difference in all[..all.len() - 1].iter().rev() {
        now = press(&now, "N", true);
        assert_eq!(now.view.playback.time, difference.time);
    }
    // Escape leaves the plan, then the question.
    let back = press(&after(&shown, [seek(3)]), "Escape", false);
    assert_eq!((back.beside(), back.view.playback.time), (None, time));
    assert!(back.document.mode.asking().is_some());
    let left = press(&back, "Escape", false);
    assert!(left.document.mode.asking().is_none());
    // The question is left at once: the time comes back, too.
    let left = after(&shown, [Action::Ask(AskAction::Close)]);
    assert_eq!(left.view.playback.time, time);
}

#[test]
fn each_difference_is_the_first_time_at_which_its_robots_are_elsewhere() {
    let shown = press(&asked(), "n", false);
    let (this, other) = shown.compared().unwrap();
    let place = |plan: &giveway_model::Plan, name: &str, time: u32| {
        let path = plan.path(name);
        let at = (time as usize).min(path.len() - 1);
        path[at]
    };
    let (plan, second) = (this.plan().unwrap(), other.plan().unwrap());
    let all = differences(this, other);
    assert!(all.is_sorted_by(|a, b| a.time < b.time));
    for (agent, who) in this.agents().iter().enumerate() {
        let mut times = 0..this.makespan().max(other.makespan()) + 1;
        let expect = times.find(|&t| place(plan, &who.name, t) != place(second, &who.name, t));
        let found = all.iter().find(|it| it.agents.contains(&agent));
        assert_eq!(found.map(|it| it.time), expect, "{}", who.name);
    }
}

#[test]
fn lanes_are_those_of_the_robots_that_differ() {
    let shown = press(&asked(), "n", false);
    let (this, other) = shown.compared().unwrap();
    let differ: usize = differences(this, other)
        .iter()
        .map(|it| it.agents.len())
        .sum();
    let names = lanes(&shown).unwrap();
    assert_eq!(names.len(), differ);
    let asked = shown.document.mode.asking().unwrap();
    assert_eq!(Some(names[0].as_str()), asked.question().agent());
    assert!(!names.contains(&"A3".to_owned()), "it drives alone");
    assert_eq!(same(&shown), Some(3 - differ as u32));
    let all = after(
        &shown,
        [Action::View(ViewAction::ShowLanes(ComparedLanes::All))],
    );
    assert_eq!(lanes(&all), None);
    assert_eq!(title(&shown), "This plan");
    assert_eq!(lanes(&corridor()), None);
}

#[test]
fn in_the_place_of_this_plan_both_are_looked_at_in_turn_at_the_same_time() {
    let narrow = after(&asked(), [Action::View(ViewAction::SetWide(false))]);
    let time = narrow.view.playback.time;
    let show = |on| Action::Ask(AskAction::ShowOther(on));
    let shown = after(&narrow, [show(true)]);
    assert_ne!(shown.shown(), narrow.shown());
    let first = shown.view.playback.time;
    let turned = after(
        &shown,
        [show(false), Action::Play(PlayAction::Seek(first + 1))],
    );
    assert_eq!(turned.view.playback.time, first + 1);
    let again = after(&turned, [show(true)]);
    assert_eq!(again.view.playback.time, first + 1, "it was opened before");
    let left = after(&again, [Action::Ask(AskAction::Close)]);
    assert_eq!(left.view.playback.time, time);
}
