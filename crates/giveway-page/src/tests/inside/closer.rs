//! A step looked at more closely: where its robots can be, where they meet, and their
//! own small proof.

use super::*;
use crate::inside::rows;

/// The step that says so, with what was found out about its robots.
fn step(state: &State, said: &str) -> State {
    let (all, _) = rows(state, &(0..1000));
    let texts: Vec<&String> = all.iter().map(|row| &row.text).collect();
    let found = all.iter().find(|row| row.text == said);
    let number = found.unwrap_or_else(|| panic!("{said}: {texts:?}")).number;
    settled(&inside(state, [InsideAction::Step(number)]))
}

fn open() -> State {
    inside(&solved(&crossing()), [InsideAction::Show(true)])
}

const BOTH: &str = "A and B cannot both be on time";

#[test]
fn the_robots_of_a_step_are_lit_and_their_cells_tinted() {
    let state = open();
    assert_eq!(overlay(&state).lit, None, "the bounds are of all");
    let asked = {
        let (all, _) = rows(&state, &(0..1000));
        let row = all.iter().find(|row| row.text == BOTH).unwrap();
        inside(&state, [InsideAction::Step(row.number)])
    };
    assert!(matches!(asked.work.task(), Some(Task::Look(_))));
    assert_eq!(overlay(&asked).lit, Some(vec![0, 1]), "at once");
    assert_eq!(overlay(&asked).shades, []);
    assert_eq!(
        saying(&asked),
        saying(&state),
        "the status speaks of the plan"
    );

    let told = settled(&asked);
    let drawn = overlay(&told);
    let shaded: Vec<usize> = drawn.shades.iter().map(|shade| shade.agent).collect();
    assert_eq!(shaded, [0, 1]);
    let [meeting] = &drawn.meetings[..] else {
        panic!("{:?}", drawn.meetings);
    };
    assert_eq!(
        (meeting.at, meeting.text.as_str()),
        ((150.0, 150.0), "time 1")
    );
    assert_eq!(
        shown(&told).why,
        [
            "To be on time, A must be at (1, 1) at time 1.",
            "To be on time, B must be at (1, 1) at time 1.",
            "So A and B would both be at (1, 1) at time 1."
        ]
    );
    let words: Vec<String> = legend(&told, &drawn)
        .unwrap()
        .into_iter()
        .map(|sign| sign.words)
        .collect();
    assert_eq!(
        words,
        [
            "Cells where A is still on time",
            "The same for B",
            "They meet here",
            "Goal"
        ]
    );
}

#[test]
fn what_is_known_is_not_asked_again() {
    let state = step(&open(), BOTH);
    let back = inside(&state, [InsideAction::First]);
    let again = inside(&back, [InsideAction::Step(at(&state))]);
    assert!(again.work.is_idle());
    assert_eq!(overlay(&again), overlay(&state));
}

fn at(state: &State) -> usize {
    steps(state).unwrap().at.parse().unwrap()
}

#[test]
fn the_proof_of_these_robots_alone_is_followed_and_left() {
    // C is far away from both.
    let scene = page(
        &[".b..c", "a.A..", ".B..C"],
        &[Cost::SumOfCosts, Cost::Makespan],
    );
    let state = inside(&solved(&scene), [InsideAction::Show(true)]);
    let state = step(&state, BOTH);
    let (title, choices) = shown(&state).choices.unwrap();
    assert_eq!(title, "Look closer");
    assert_eq!(choices[0].text, "Why can A and B not both be on time?");
    let alone = inside(&state, [choices[0].action]);
    let column = shown(&alone);
    assert!(
        column.over.starts_with("A and B alone: step 0 of "),
        "{}",
        column.over
    );
    assert_eq!(overlay(&alone).lit, Some(vec![0, 1]), "C has no part in it");
    let (told, _) = rows(&alone, &(0..100));
    assert_eq!(told[0].text, "Each robot alone, by its fastest way");
    // Its end leads back.
    let end = inside(&alone, [InsideAction::Last]);
    assert_eq!(
        shown(&end).choices,
        None,
        "alone once more would be the same"
    );
    let [back] = &shown(&end).foot[..] else {
        panic!("{:?}", shown(&end).foot);
    };
    assert_eq!((back.text, back.is_primary), ("All robots again", true));
    let left = inside(&end, [back.action.unwrap()]);
    assert_eq!(steps(&left), steps(&state));
    assert_eq!(overlay(&left), overlay(&state));
    // Escape leads back, too.
    let key = crate::keys::Key {
        name: "Escape",
        ..crate::keys::Key::default()
    };
    let Some(crate::keys::Command::Act(action)) = crate::keys::command(key, &alone) else {
        panic!("nothing to close");
    };
    assert_eq!(steps(&after(&alone, [action])), steps(&state));
}

#[test]
fn an_edit_ends_the_look_at_robots_alone() {
    let state = step(&open(), BOTH);
    let alone = inside(&state, [InsideAction::Alone(true)]);
    assert!(alone.inside.alone.is_some());
    let solved = solved(&after(&alone, [Action::Edit(Edit::Name("new".to_owned()))]));
    assert_eq!(solved.inside.alone, None);
    assert!(shown(&solved).over.starts_with("Step "));
}

#[test]
fn where_nothing_is_proved_alone_there_is_no_way_to_it() {
    let state = open();
    let same = inside(&state, [InsideAction::Alone(true)]);
    assert_eq!(same, state);
}

#[test]
fn a_step_of_a_running_search_is_not_asked_about() {
    let state = after(&step(&open(), BOTH), [SOLVE]);
    assert!(state.work.solving().is_some());
    let chosen = inside(&state, [InsideAction::Step(0), InsideAction::Next]);
    assert!(chosen.work.solving().is_some(), "the search goes on");
}

#[test]
fn it_can_be_stopped_and_asked_again() {
    let (all, _) = rows(&open(), &(0..1000));
    let row = all.iter().find(|row| row.text == BOTH).unwrap();
    let asked = inside(&open(), [InsideAction::Step(row.number)]);
    let stopped = after(&asked, [Action::Solve(SolveAction::Cancel)]);
    assert!(stopped.work.is_idle(), "nobody asks at once again");
    assert_eq!(shown(&stopped).why, Vec::<String>::new());
    let again = inside(&stopped, [InsideAction::Again]);
    assert!(matches!(again.work.task(), Some(Task::Look(_))));
    assert_eq!(shown(&settled(&again)).why.len(), 3);
}
