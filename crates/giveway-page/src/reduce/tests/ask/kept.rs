//! What stays of an answer: a better plan after the question, numbers on both boards, and steps
//! that are done.

use giveway_model::Question;
use giveway_solve::Status;
use giveway_solve::explain::{
    Core, ExplainAnswer, Fact, FactGroup, FactGroupKind, FactKind, Helps, Part, Verdict,
};

use super::names::with_choice;
use super::pays::respond;
use super::{answered, asked, hear, told};
use crate::ask::{
    Reached::{Ahead, Done, Now, Partly},
    card,
};
use crate::board::{Reasons, Spot, reasons, reasons_beside};
use crate::reduce::tests::after;
use crate::sample::reach;
use crate::{Action, Answer, AskAction, PlayAction, State, ViewAction, found_better};

#[test]
fn a_better_plan_stays_at_hand_when_the_question_is_left() {
    let state = respond(&asked(), with_choice(&asked(), -1));
    // Looking at a worse one changes nothing of it.
    let state = after(
        &state,
        [
            Action::Ask(AskAction::Choose(Some(0))),
            Action::Ask(AskAction::Close),
        ],
    );
    let said = "A question found a better plan: makespan 17, sum of costs 35, 3 charges.";
    assert_eq!(found_better(&state).as_deref(), Some(said));
    // The next question about the same plan knows it.
    let next = after(&state, [Action::Ask(AskAction::Ask(Question::Makespan))]);
    let request = &next.document.mode.asking().unwrap().request;
    let better = state.found_better().unwrap();
    assert_eq!(request.known.as_ref(), better.plan());
    let taken = after(&state, [Action::Ask(AskAction::TakeFound)]);
    let now = taken.document.answer.clone().unwrap();
    assert_eq!(now.solved.costs.unwrap().makespan, 17);
    assert_eq!(found_better(&taken), None);
    // What was claimed of the plan before is refuted: nothing of it is claimed of this one.
    assert_eq!(now.solved.status, Status::Feasible);
    assert_eq!(
        (now.solved.reason.as_ref(), now.solved.bounds.len()),
        (None, 0)
    );
    assert_eq!(now.proved_here(), None);
    let undone = after(&taken, [Action::Undo]);
    assert_eq!(found_better(&undone).as_deref(), Some(said));
    // A plan that costs more is none.
    let same = after(&answered(&asked()), [Action::Ask(AskAction::Close)]);
    assert_eq!(found_better(&same), None);
}

/// A group of facts about a robot has the same number on both boards, at the robot.
#[test]
fn both_boards_number_the_same_groups() {
    let fact = Fact {
        kind: FactKind::Task,
        agents: vec!["A2".to_owned()],
        cell: None,
        index: None,
        time: None,
        until: None,
        text: "A2 must reach its goal".to_owned(),
        helps: Helps::Unknown,
    };
    let group = FactGroup {
        kind: FactGroupKind::Agent,
        agents: vec!["A2".to_owned()],
        cells: Vec::new(),
        facts: vec![0],
        text: "what A2 must do".to_owned(),
        needed: true,
        helps: Helps::Yes,
        price: None,
    };
    let answer = ExplainAnswer {
        core: Some(Core {
            facts: vec![fact],
            groups: vec![group],
            prices: Vec::new(),
            minimal: true,
            reach: reach(None),
            further: Vec::new(),
        }),
        ..with_choice(&asked(), 1)
    };
    let state = respond(&asked(), answer);
    assert_eq!(reasons_beside(&state), Reasons::default(), "it is not open");
    let state = after(
        &state,
        [
            Action::View(ViewAction::SetWide(true)),
            Action::Ask(AskAction::ShowOther(true)),
            Action::Play(PlayAction::Seek(2)),
        ],
    );
    let at = |state: &State, answer: &Answer| {
        let time = state.view.playback.time as usize;
        let cell = answer.plan().unwrap().path("A2")[time].unwrap();
        (
            100.0 * f64::from(cell.x) + 16.0,
            100.0 * f64::from(cell.y) + 16.0,
        )
    };
    let asking = state.document.mode.asking().unwrap();
    let (here, there) = (reasons(&state).spots, reasons_beside(&state).spots);
    let number = |spots: &[Spot]| spots.iter().map(|it| it.number).collect::<Vec<_>>();
    assert_eq!((number(&here), number(&there)), (vec![1], vec![1]));
    assert_eq!(here[0].at, at(&state, &asking.about));
    assert_eq!(there[0].at, at(&state, asking.other.as_ref().unwrap()));
    assert_ne!(here[0].at, there[0].at, "they are elsewhere");
}

/// Parts come in the order in which they are pending; a layer of which one comes last is done in
/// part meanwhile.
#[test]
fn the_steps_say_what_is_at_work() {
    let reached = |pending: &[Part]| {
        let state = asked();
        let answer = ExplainAnswer {
            pending: pending.to_vec(),
            ..told(&state)
        };
        let state = hear(&state, answer);
        let coming = card(&state).unwrap().coming.unwrap();
        let steps = coming.layers.iter().map(|it| it.reached);
        (steps.collect::<Vec<_>>(), coming.doing)
    };
    let [witness, core, repairs, closest] =
        [Part::Witness, Part::Core, Part::Repairs, Part::Closest];
    assert_eq!(
        reached(&[witness, core, repairs, closest]),
        (
            vec![Done, Done, Partly, Now, Ahead],
            "Looking for what would happen".to_owned()
        )
    );
    assert_eq!(
        reached(&[repairs, closest]),
        (
            vec![Done, Done, Partly, Done, Now],
            "Looking for what would help".to_owned()
        )
    );
    assert_eq!(
        reached(&[closest]),
        (
            vec![Done, Done, Now, Done, Done],
            "Looking for a plan closer to this one".to_owned()
        )
    );
}

#[test]
fn what_a_search_that_is_over_did_not_find_is_not_done() {
    let state = asked();
    let answer = ExplainAnswer {
        verdict: Verdict::Unknown,
        pending: Vec::new(),
        ..told(&state)
    };
    let coming = card(&respond(&state, answer)).unwrap().coming.unwrap();
    let steps: Vec<_> = coming.layers.iter().map(|it| it.reached).collect();
    assert_eq!(steps, [Done, Done, Partly, Ahead, Ahead]);
    assert_eq!(coming.doing, "The time limit of 30 s was reached");
}
