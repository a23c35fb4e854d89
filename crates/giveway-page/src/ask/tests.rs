//! The questions offered in the warehouse.

use std::rc::Rc;

use giveway_model::{Agent, Cell, Plan, Scene, check::costs};
use giveway_solve::{SolveAnswer, SolveRequest};

use super::*;
use crate::audit::unproved;
use crate::{Action, BoardAction, Draft, PlayAction, reduce, sample};

fn texts(state: &State) -> Vec<(String, Vec<String>)> {
    let text = |offer: Offer| match offer.detail {
        Some(detail) => format!("{} [{detail}]", offer.text),
        None => offer.text,
    };
    let group = |group: Group| (group.title, group.offers.into_iter().map(text).collect());
    offers(state).into_iter().map(group).collect()
}

fn selected(selection: Selection, time: u32) -> State {
    let state = reduce(&sample::solved(), Action::Play(PlayAction::Seek(time)));
    reduce(&state, Action::Board(BoardAction::Select(selection)))
}

#[track_caller]
fn check(state: &State, expect: &[(&str, &[&str])]) {
    let expect: Vec<(String, Vec<String>)> = expect
        .iter()
        .map(|(title, texts)| {
            let texts = texts.iter().map(|&text| text.to_owned()).collect();
            ((*title).to_owned(), texts)
        })
        .collect();
    assert_eq!(texts(state), expect);
}

const PLAN: (&str, &[&str]) = (
    "Ask about the plan",
    &[
        "Why does it take this long? [makespan 18, proved]",
        "Why is the sum of costs not less? [sum of costs 35, proved]",
        "Why are there not fewer charges? [charges 3, proved]",
    ],
);

#[test]
fn an_agent_that_charges() {
    check(
        &selected(Selection::Agent(0), 9),
        &[
            (
                "Ask about this moment",
                &[
                    "Why does A1 charge at (6, 2) at time 9? [with 1 left]",
                    "Why does A1 go from (6, 2) to (6, 1) at time 9?",
                ],
            ),
            (
                "Ask about A1",
                &[
                    "Why does A1 not arrive sooner? [it arrives at 17]",
                    "Why does A1 not charge fewer times? [it charges at 9]",
                    "Why does A1 visit (2, 0) before (4, 2)?",
                    "Why does A1 visit (4, 2) before (7, 0)?",
                    "Why does A1 take the slow way?",
                    "Why is the path of A1 this long? [it makes 15 moves]",
                ],
            ),
            PLAN,
        ],
    );
}

#[test]
fn after_its_arrival_an_agent_does_nothing_to_ask_about() {
    let groups = offers(&selected(Selection::Agent(0), 18));
    assert_eq!(groups[0].title, "Ask about A1");
}

#[test]
fn cells() {
    let state = |x, y| selected(Selection::Cell(Cell::new(x, y)), 0);
    let title = "Ask about (6, 0)";
    check(
        &state(6, 0),
        &[(
            title,
            &["Why does A1 pass (6, 0)?", "Why does A2 pass (6, 0)?"],
        )],
    );
    check(
        &state(5, 2),
        &[("Ask about (5, 2)", &["Why does A1 pass (5, 2)?"])],
    );
    check(&state(1, 1), &[]);
    check(
        &state(3, 2),
        &[(
            "Ask about (3, 2)",
            &[
                "Why does A1 pass (3, 2)?",
                "Why does A2 pass (3, 2)?",
                "Why does A1 not charge at (3, 2)?",
            ],
        )],
    );
}

#[test]
fn a_cost_is_asked_about_at_its_row() {
    let state = selected(Selection::Nothing, 0);
    let asked = |cost| of_cost(&state, cost).map(|offer| offer.question);
    assert_eq!(asked(Cost::Makespan), Some(Question::Makespan));
    assert_eq!(asked(Cost::SumOfCosts), Some(Question::SumOfCosts));
    assert_eq!(
        asked(Cost::Charges),
        Some(Question::Charges { agent: None })
    );
    assert_eq!(asked(Cost::Waits), None, "it is not minimised");
    let stale = crate::reduce::tests::after(&state, [Action::Edit(crate::Edit::RemoveAgent(0))]);
    assert_eq!(of_cost(&stale, Cost::Makespan), None);
}

#[test]
fn nothing_is_asked_of_a_stale_plan() {
    let state = selected(Selection::Nothing, 0);
    check(&state, &[PLAN]);
    let stale = reduce(
        &state,
        Action::Board(BoardAction::PickTool(crate::Tool::Obstacle)),
    );
    let stale = reduce(&stale, Action::Board(BoardAction::Press(Cell::new(8, 2))));
    let stale = reduce(&stale, Action::Board(BoardAction::Release));
    assert!(stale.document.is_stale());
    check(&stale, &[]);
}

#[test]
fn every_question_at_every_time_can_be_asked() {
    for time in 0..=18 {
        for agent in 0..2 {
            let state = selected(Selection::Agent(agent), time);
            let groups = offers(&state);
            assert!(groups.len() >= 2, "{time} {agent}");
            let names: std::collections::BTreeSet<_> = groups
                .iter()
                .flat_map(|group| group.offers.iter().map(|offer| offer.text.clone()))
                .collect();
            let count: usize = groups.iter().map(|group| group.offers.len()).sum();
            assert_eq!(names.len(), count, "no question twice");
        }
    }
}

#[test]
fn at_a_cell_the_robot_that_was_selected_is_asked_about_first() {
    let select = |selection| Action::Board(BoardAction::Select(selection));
    let cell = |x, y| select(Selection::Cell(Cell::new(x, y)));
    let state = reduce(&sample::solved(), select(Selection::Agent(1)));
    let there = reduce(&state, cell(6, 0));
    let elsewhere = (0..9).flat_map(|x| (0..4).map(move |y| (x, y)));
    let mut passed = 0;
    for (x, y) in elsewhere {
        let state = reduce(&there, cell(x, y));
        let groups = offers(&state);
        let Some(group) = groups.first() else {
            continue;
        };
        // Another cell is looked at: it is still about the same robot.
        let own = |offer: &&Offer| offer.question.agent() == Some("A2");
        let own: Vec<&Offer> = group.offers.iter().filter(own).collect();
        let first = own.first().map(|offer| &offer.question);
        if let Some(Question::NoVisit { .. } | Question::Visit { .. }) = first {
            passed += 1;
            assert_eq!(group.offers[0], *own[0], "it comes first");
        }
    }
    assert!(passed > 5, "{passed} cells have a question about it");
    // Without a robot before, A1 and A2 come in their order.
    let texts = |state: &State| texts(state)[0].1.clone();
    let alone = reduce(&sample::solved(), cell(3, 2));
    assert!(texts(&alone)[0].starts_with("Why does A1 pass (3, 2)?"));
    let asked = reduce(&there, cell(3, 2));
    assert!(texts(&asked)[0].starts_with("Why does A2 pass (3, 2)?"));
    let back = reduce(&there, select(Selection::Nothing));
    let again = reduce(&back, cell(3, 2));
    assert_eq!(texts(&again), texts(&alone), "it is forgotten");
}

/// A1 waits at (6, 0) from a time on, and then drives into the aisle from which A2 comes.
fn behind_an_aisle(from: u32) -> State {
    let agent = |name: &str, start, goal, waypoints| Agent {
        name: name.to_owned(),
        start,
        goal: Some(goal),
        waypoints,
        battery: None,
        heading: None,
    };
    let inmost = Cell::new(0, 0);
    let scene = Scene {
        map: [".......", "#####..", "#####.."]
            .map(str::to_owned)
            .to_vec(),
        agents: vec![
            agent("A1", Cell::new(6, 2), inmost, Vec::new()),
            agent("A2", Cell::new(4, 0), Cell::new(5, 1), vec![inmost]),
        ],
        ..Scene::default()
    };
    let draft = Rc::new(Draft::new(scene.clone()).unwrap());
    let row = |x: u32| Cell::new(x, 0);
    let mut first = vec![Cell::new(6, 2); from as usize - 1];
    first.push(Cell::new(6, 1));
    first.extend((from..10).map(|_| row(6)));
    first.extend((0..6).rev().map(row));
    let second = (0..5).rev().chain(1..6).map(row).chain([Cell::new(5, 1)]);
    let path = |cells: Vec<Cell>| cells.into_iter().map(Some).collect();
    let paths = [("A1", path(first)), ("A2", path(second.collect()))];
    let plan = Plan {
        paths: paths.map(|(name, path)| (name.to_owned(), path)).into(),
        ..Plan::default()
    };
    let request = Rc::new(SolveRequest {
        scene,
        ..SolveRequest::default()
    });
    let solved = SolveAnswer {
        costs: costs(draft.instance().unwrap(), &plan),
        plan: Some(plan),
        ..unproved()
    };
    let mut state = State::new((*draft).clone());
    state.document.draft = Rc::clone(&draft);
    state.document.answer = Some(Rc::new(Answer::new(draft, request, solved)));
    state.view.selection = Selection::Agent(0);
    reduce(&state, Action::Play(PlayAction::Seek(8)))
}

#[test]
fn who_goes_first_is_asked_where_that_was_decided_during_the_wait() {
    let asks = |state: &State| texts(state).into_iter().flat_map(|(_, texts)| texts);
    let gives_way = "Why does A1 give way to A2 at (0, 0)?";
    let waits = |text: &String| text.starts_with("Why does A1 wait");
    for (from, is_asked) in [(2, true), (4, true), (5, false), (8, false)] {
        let state = behind_an_aisle(from);
        assert!(
            asks(&state).any(|text| waits(&text)),
            "{from}: {:?}",
            texts(&state)
        );
        assert_eq!(
            asks(&state).any(|text| text == gives_way),
            is_asked,
            "{from}"
        );
    }
}
