//! A lesson in which the world changes while a plan runs: who joins is on the board.

use giveway_course::lesson::{Lesson, read_glossary, read_lesson};
use giveway_course::port::{Board, BoardPlan, Evidence, Hand, Lit, ToPage};
use giveway_model::change::Changes;
use giveway_model::format::native;
use giveway_model::{Plan, Scene};

use super::{at, board, opened, say};
use crate::board::Cast;
use crate::tests::saying;
use crate::{State, sample};

/// The lesson of the course.
const LESSON: &str = include_str!("../../../../../static/course/when-the-world-changes.json");
const GLOSSARY: &str = include_str!("../../../../../static/course/glossary.json");

fn lesson() -> Lesson {
    read_lesson(LESSON, &read_glossary(GLOSSARY).unwrap()).unwrap()
}

/// The board of a step, as the lesson puts it there.
fn of_step(index: usize) -> Board {
    let lesson = lesson();
    let step = &lesson.steps[index];
    Board {
        scene: step.scene.clone().unwrap(),
        plan: BoardPlan::Given(step.plan.clone().unwrap()),
        changes: step.changes().cloned(),
        time: step.time,
        tools: Vec::new(),
        hand: Hand::Looks,
        ..board(5)
    }
}

/// The plan that the world's change asks for: the third robot goes round.
fn revised() -> (Scene, Plan, Changes) {
    let board = of_step(3);
    let plan = r#"{ "giveway": 1, "knows": 2, "from": { "A3": 2 }, "paths": {
        "A1": [[0, 0], [1, 0], [2, 0], [2, 1], [2, 2]],
        "A2": [[2, 0], [2, 1], [1, 1], [0, 1], [0, 2]],
        "A3": [[0, 1], [0, 0], [1, 0], [1, 1], [2, 1]] } }"#;
    let plan = native::read_plan(plan).unwrap();
    (board.scene, plan, board.changes.unwrap())
}

fn robots(state: &State) -> Vec<String> {
    let cast = Cast::of(state);
    let there = cast.agents.iter().zip(&cast.is_there);
    let there = there.filter(|(_, is_there)| **is_there);
    there.map(|(agent, _)| agent.name.clone()).collect()
}

#[test]
fn a_robot_that_joins_is_on_the_board_before_the_task_is_done() {
    for index in 1..4 {
        let state = opened(&sample::solved(), of_step(index));
        assert!(state.document.mode.changing().is_some(), "{index}");
        assert_eq!(robots(&state), ["A1", "A2", "A3"]);
        assert_eq!(saying(&state), "At time 2: A3 joins at (0, 1).");
        let lit = say(&state, ToPage::Light(Some(Lit::Robot("A3".to_owned()))));
        assert_eq!(lit.named_agent(), Some(2));
        let before = say(&state, ToPage::Go(1));
        assert_eq!(robots(&before), ["A1", "A2"]);
    }
    let first = opened(&sample::solved(), of_step(0));
    assert_eq!(robots(&first), ["A1", "A2"]);
}

#[test]
fn the_plan_that_goes_on_is_shown_and_judged_with_its_changes() {
    let state = opened(&sample::solved(), of_step(3));
    let (_, plan, changes) = revised();
    let evidence = Evidence {
        plan: Some(plan),
        changes: Some(changes),
        ..Evidence::default()
    };
    let shown = say(&state, ToPage::Show(Box::new(evidence)));
    assert!(shown.document.mode.is_editing(), "{}", saying(&shown));
    assert_eq!(
        saying(&shown),
        "The world changed at time 2; the plan went on: makespan 6, sum of costs 14, 0 charges."
    );
    let later = say(&shown, ToPage::Go(6));
    assert_eq!(robots(&later), ["A1", "A2", "A3"]);
    assert_eq!(later.agent_at(at(2, 1)), Some(2));
    let before = say(&later, ToPage::Go(1));
    assert_eq!(robots(&before), ["A1", "A2"]);
}
