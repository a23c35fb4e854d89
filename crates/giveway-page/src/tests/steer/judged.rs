//! The plan of one's own is checked: its faults, its costs, the better plan.

use giveway_model::Question;
use giveway_solve::Status;

use super::{DOWN, RIGHT, WAIT, leading, path, told};
use crate::board::reasons;
use crate::reduce::tests::after;
use crate::tests::answered;
use crate::{Action, AskAction, Phase, SolveAction, State, ask};

#[test]
fn who_is_not_at_its_goal_yet_is_in_nobodys_way_later() {
    let state = after(&leading(0, 0), [DOWN]);
    assert_eq!(told(&state).violations, [], "it may yet be led away");
    let checked = answered(&after(
        &state,
        [Action::Ask(AskAction::Ask(Question::Plan))],
    ));
    let card = ask::card(&checked).unwrap();
    let verdict = card.verdict.unwrap();
    let text = verdict.sentence;
    assert_eq!(verdict.badge.word, "Against the rules");
    assert!(text.starts_with("The plan breaks a rule: "), "{text}");
    let [(title, broken)] = &card.witness[..] else {
        panic!("{:?}", card.witness);
    };
    assert_eq!(title, "What is against the rules");
    let [goal, meets] = &broken[..] else {
        panic!("{broken:?}");
    };
    assert!(goal.text.contains("its goal is (3, 0)"), "{}", goal.text);
    assert!(
        meets.text.contains("A2 is at (0, 1) at time 3"),
        "{}",
        meets.text
    );
    let spots = reasons(&checked).spots;
    assert_eq!(
        spots.iter().map(|spot| spot.number).collect::<Vec<_>>(),
        [1, 2]
    );
}

/// What is against the rules now, not done yet, and only so until robots are led on: their number
/// is that of the answer.
#[test]
fn the_problems_are_counted_once() {
    let count = |state: &State| {
        let facts = told(state);
        let checked = answered(&after(state, [Action::Ask(AskAction::Ask(Question::Plan))]));
        let card = ask::card(&checked).unwrap();
        let listed: usize = card.witness.iter().map(|(_, all)| all.len()).sum();
        let heading = card.verdict.unwrap().title;
        (facts, listed, heading)
    };
    let (facts, listed, heading) = count(&after(&leading(0, 0), [DOWN]));
    assert_eq!(
        (facts.violations.len(), facts.to_do.len(), listed),
        (0, 1, 2)
    );
    assert_eq!(heading, "The plan has 2 problems");
    assert_eq!(
        facts.count.unwrap(),
        "As it stands, the plan has 2 problems. 1 of them goes away once a robot is led on."
    );
    let (facts, listed, heading) = count(&after(&leading(0, 0), [DOWN, RIGHT]));
    assert_eq!(heading, format!("The plan has {listed} problems"));
    let counted = format!("As it stands, the plan has {listed} problems.");
    assert!(facts.count.unwrap().starts_with(&counted));
    assert_eq!(told(&leading(0, 4)).count, None);
}

#[test]
fn a_plan_that_is_as_good_is_confirmed() {
    let state = after(
        &leading(0, 0),
        [RIGHT, RIGHT, RIGHT, Action::Solve(SolveAction::Solve)],
    );
    assert_eq!(state.phase(), Phase::Asking);
    let state = answered(&state);
    let verdict = ask::card(&state).unwrap().verdict.unwrap();
    assert_eq!(verdict.badge.word, "Optimal");
    assert_eq!(
        verdict.sentence,
        "The plan keeps all rules, and no plan is better."
    );
    let state = after(&state, [Action::Ask(AskAction::Close)]);
    assert_eq!(state.phase(), Phase::Steering);
}

#[test]
fn of_a_worse_plan_it_is_told_what_is_too_much() {
    let own = after(&leading(0, 0), [WAIT, RIGHT, RIGHT, RIGHT]);
    let state = answered(&after(&own, [Action::Ask(AskAction::Ask(Question::Plan))]));
    let card = ask::card(&state).unwrap();
    let verdict = card.verdict.unwrap();
    let text = verdict.sentence;
    assert_eq!(verdict.badge.word, "Improvable");
    assert!(text.contains("A1 waits 1 step less"), "{text}");
    let makespan = &card.pays.unwrap().costs[0];
    assert_eq!((makespan.this, makespan.other), (4, 3));
    let taken = after(&state, [Action::Ask(AskAction::TakeOther)]);
    assert_eq!(taken.document.mode.steering(), None);
    let answer = taken.document.answer.as_ref().unwrap();
    assert_eq!(answer.solved.status, Status::Optimal, "the bounds hold");
    assert_eq!(
        after(&taken, [Action::Undo]).document.mode.steering(),
        own.document.mode.steering()
    );
}

#[test]
fn a_step_closes_the_answer_and_ends_the_search() {
    let state = after(
        &leading(0, 0),
        [WAIT, Action::Ask(AskAction::Ask(Question::Plan)), RIGHT],
    );
    assert_eq!(
        (state.phase(), state.document.mode.asking()),
        (Phase::Steering, None)
    );
    assert_eq!(path(&state, "A1").len(), 3);
}
