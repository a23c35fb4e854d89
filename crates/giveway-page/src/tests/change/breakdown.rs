//! Questions while a robot is broken down.

use giveway_model::{Cell, Question};
use giveway_solve::explain::FactKind;

use super::changing;
use crate::board::reasons;
use crate::reduce::tests::after;
use crate::tests::{answered, seek, select};
use crate::{Action, AskAction, ChangeAction, Edit, Lit, State};

/// A1 breaks down at time 1 for 3 steps, and the plan goes on.
fn broken_down() -> State {
    let state = after(&changing(), [Action::Edit(Edit::Delay(0, 3))]);
    let state = answered(&after(&state, [Action::Change(ChangeAction::Adapt)]));
    after(&state, [Action::Change(ChangeAction::Adopt(0))])
}

fn wait(state: &State) -> Option<Question> {
    let offers = crate::ask::offers(state).into_iter();
    let mut questions = offers.flat_map(|group| group.offers).map(|it| it.question);
    questions.find(|question| matches!(question, Question::Wait { .. }))
}

#[test]
fn the_wait_of_a_broken_robot_is_offered_and_answered_by_its_breakdown() {
    let state = after(&broken_down(), [seek(2), select(0)]);
    let question = wait(&state).unwrap();
    let Question::Wait { from, to, .. } = question else {
        unreachable!()
    };
    assert_eq!((from, to), (Some(1), Some(4)));
    let told = answered(&after(&state, [Action::Ask(AskAction::Ask(question))]));
    let card = crate::ask::card(&told).unwrap();
    let facts = &card.cores[0].facts;
    assert_eq!(facts.len(), 1);
    assert_eq!(facts[0].text, "A1 is broken down from time 1 to 4");
    assert_eq!((facts[0].icon, facts[0].time), ("pause", Some(1)));
    // It lights up the robot.
    let lit = after(&told, [Action::Ask(AskAction::Light(Some(Lit::Fact(0))))]);
    assert_eq!(reasons(&lit).agents, [0]);
    assert!(reasons(&told).agents.is_empty());
    let asking = told.document.mode.asking().unwrap();
    let core = asking.told.as_ref().unwrap().core.as_ref().unwrap();
    assert_eq!(core.facts[0].kind, FactKind::Breakdown);
}

#[test]
fn while_it_is_broken_down_the_plan_can_be_asked_about() {
    let state = broken_down();
    for time in 1..=4 {
        let now = after(&state, [seek(time), select(1)]);
        assert!(!crate::ask::offers(&now).is_empty(), "{time}");
        assert_eq!(crate::ask::no_offers(&now), None, "{time}");
    }
    let makespan = after(&state, [Action::Ask(AskAction::Ask(Question::Makespan))]);
    let told = answered(&makespan);
    let core = crate::ask::card(&told).unwrap().cores.remove(0);
    let texts: Vec<&str> = core.facts.iter().map(|fact| fact.text.as_str()).collect();
    assert!(
        texts.contains(&"A1 is broken down from time 1 to 4"),
        "{texts:?}"
    );
    let cell = Cell::new(0, 0);
    assert!(reasons(&told).places.iter().all(|place| place.cell != cell));
}
