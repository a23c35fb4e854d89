//! Questions: asked, answered bit by bit, left, and what is taken from them.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cell, Cost, Costs, Plan, Question, Version};
use giveway_proof::Report;
use giveway_solve::explain::{Edit, ExplainAnswer, Part, Repair, Verdict};
use giveway_solve::{Progress, Request, Response, Stats, Status};

use super::{after, stroke};
use crate::ask::card;
use crate::proof::{Proof, proof};
use crate::sample::solved;
use crate::{
    Action, AskAction, BoardAction, Lit, Phase, PlayAction, Selection, SolveAction, State, Tool,
    ViewAction, words,
};

fn question() -> Question {
    Question::Charge {
        agent: "A1".to_owned(),
        at: Some(Cell::new(6, 2)),
        time: Some(9),
    }
}

fn asked() -> State {
    after(&solved(), [Action::Ask(AskAction::Ask(question()))])
}

fn id(state: &State) -> u64 {
    state.work.id().unwrap()
}

/// An answer whose other plan is the plan itself, at one more charge.
fn told(state: &State) -> ExplainAnswer {
    let plan: Plan = state
        .document
        .answer
        .as_ref()
        .unwrap()
        .plan()
        .unwrap()
        .clone();
    let costs = state
        .document
        .answer
        .as_ref()
        .unwrap()
        .solved
        .costs
        .unwrap();
    let costs = Costs {
        charges: costs.charges + 1,
        ..costs
    };
    let repair = Repair {
        edits: vec![Edit::DropWaypoint {
            agent: "A1".to_owned(),
            cell: Cell::new(4, 2),
        }],
        costs,
        plan: plan.clone(),
        text: "Drop A1's waypoint (4, 2)".to_owned(),
    };
    ExplainAnswer {
        giveway: Version,
        question: question(),
        since: None,
        plan: None,
        verdict: Verdict::Costly,
        costs: Some(costs),
        deltas: BTreeMap::from([
            (Cost::Makespan, 0),
            (Cost::SumOfCosts, 0),
            (Cost::Charges, 1),
        ]),
        within: None,
        complete: true,
        alternative: Some(plan),
        closest: false,
        witness: Vec::new(),
        core: None,
        repairs: vec![repair],
        exhaustive: false,
        valid: None,
        violations: None,
        optimal: None,
        excess: Vec::new(),
        pending: vec![Part::Witness, Part::Core],
        words: "1 more charge.".to_owned(),
        stats: Stats::default(),
    }
}

fn learn(state: &State) -> State {
    let answer = Box::new(told(state));
    let event = Progress::Explained { answer };
    let run = id(state);
    after(
        state,
        [Action::Solve(SolveAction::Progress { job: run, event })],
    )
}

/// The warehouse with a question that was answered.
pub(crate) fn asked_and_answered() -> State {
    answered(&asked())
}

fn answered(state: &State) -> State {
    let answer = ExplainAnswer {
        pending: Vec::new(),
        ..told(state)
    };
    let response = Box::new(Response::Explained(Box::new(answer)));
    let run = id(state);
    after(
        state,
        [Action::Solve(SolveAction::Respond { job: run, response })],
    )
}

#[test]
fn a_question_runs_in_the_solver_and_is_said() {
    let state = asked();
    assert_eq!(state.phase(), Phase::Asking);
    let standing = words::standing(&state);
    let said = "Why does A1 charge at (6, 2) at time 9?";
    assert_eq!(standing.sentence, said);
    let card = card(&state).unwrap();
    assert_eq!(card.question, said);
    assert_eq!(
        (card.verdict, card.pending),
        (None, vec!["Looking for the verdict"])
    );
    assert!(state.is_looking());
    let asking = state.document.mode.asking().unwrap();
    assert!(asking.request.plan.is_some());
}

#[test]
fn the_answer_grows_until_it_is_whole() {
    let state = learn(&asked());
    let grown = card(&state).unwrap();
    assert_eq!(grown.verdict.as_ref().unwrap().0.word, "Costly");
    assert_eq!(grown.pending.len(), 2);
    assert_eq!(grown.standing, None);
    let charges = &grown.rows[2];
    assert_eq!((charges.this, charges.other), (3, 4));
    assert_eq!(charges.difference(), "+1");
    assert_eq!(
        grown.repairs[0].costs,
        "makespan 18, sum of costs 35, 4 charges"
    );

    let state = answered(&state);
    assert!(state.work.is_idle());
    let whole = card(&state).unwrap();
    assert_eq!(whole.pending, Vec::<&str>::new());
    assert!(whole.standing.is_some());
}

#[test]
fn what_comes_late_is_ignored() {
    let old = asked();
    let state = after(
        &old,
        [
            Action::Ask(AskAction::Close),
            Action::Ask(AskAction::Ask(Question::Makespan)),
        ],
    );
    let run = id(&old);
    let event = Progress::Explained {
        answer: Box::new(told(&old)),
    };
    let later = after(
        &state,
        [Action::Solve(SolveAction::Progress { job: run, event })],
    );
    assert_eq!(later, state);
}

#[test]
fn the_other_plan_is_shown_and_taken() {
    let state = answered(&asked());
    let this = state.document.answer.clone();
    assert_eq!(state.shown(), this.as_ref());
    let shown = after(&state, [Action::Ask(AskAction::ShowOther(true))]);
    assert_ne!(shown.shown(), this.as_ref());
    assert_eq!(shown.document.answer, this, "nothing is taken yet");
    let back = after(&shown, [Action::Ask(AskAction::ShowOther(false))]);
    assert_eq!(back.shown(), this.as_ref());

    let taken = after(&shown, [Action::Ask(AskAction::TakeOther)]);
    assert_eq!(taken.document.mode.asking(), None);
    let answer = taken.document.answer.unwrap();
    // It costs more than what was proved.
    assert_eq!(answer.solved.status, Status::Feasible);
    assert_eq!(answer.solved.costs.unwrap().charges, 4);
}

#[test]
fn where_there_is_room_the_other_plan_is_beside_this_one() {
    let state = answered(&asked());
    assert_eq!(state.beside(), None);
    let wide = after(&state, [Action::View(ViewAction::SetWide(true))]);
    let other = wide.document.mode.asking().as_ref().unwrap().other.clone();
    assert_eq!(wide.beside(), other.as_ref());
    assert!(card(&wide).unwrap().other.unwrap().is_beside);

    // A window that grows while the other plan has the place of this one.
    let grown = after(
        &state,
        [
            Action::Ask(AskAction::ShowOther(true)),
            Action::View(ViewAction::SetWide(true)),
        ],
    );
    assert_eq!(grown.shown(), state.document.answer.as_ref());
    assert_eq!(grown.beside(), other.as_ref());
    let left = after(&wide, [Action::Ask(AskAction::Close)]);
    assert_eq!(left.beside(), None);
}

#[test]
fn two_plans_play_to_the_end_of_the_longer_one() {
    let mut state = after(
        &answered(&asked()),
        [Action::View(ViewAction::SetWide(true))],
    );
    let asking = state.document.mode.asking_mut().unwrap();
    let mut other = asking.other.as_deref().unwrap().clone();
    other.solved.costs.as_mut().unwrap().makespan = 20;
    asking.other = Some(Rc::new(other));
    assert_eq!(state.last_time(), 20);
    let end = after(&state, [Action::Play(PlayAction::Seek(99))]);
    assert_eq!(end.view.playback.time, 20);
    let narrow = after(&end, [Action::View(ViewAction::SetWide(false))]);
    assert_eq!(narrow.view.playback.time, 18);
}

#[test]
fn a_repair_is_an_edit_that_can_be_undone() {
    let state = answered(&asked());
    let before = state.document.draft.clone();
    let repaired = after(&state, [Action::Ask(AskAction::TakeRepair(0))]);
    assert_eq!(repaired.document.draft.agents()[0].waypoints.len(), 2);
    assert_eq!(repaired.phase(), Phase::Solving);
    assert!(repaired.plan().is_some(), "its plan is there already");
    assert_eq!(repaired.document.mode.asking(), None);
    let undone = after(&repaired, [Action::Undo]);
    assert_eq!(undone.document.draft, before);
    let none = after(&state, [Action::Ask(AskAction::TakeRepair(7))]);
    assert_eq!(none, state);
}

#[test]
fn cancelling_keeps_what_is_known() {
    let state = after(&learn(&asked()), [Action::Solve(SolveAction::Cancel)]);
    assert!(state.work.is_idle());
    let kept = card(&state).unwrap();
    assert!(kept.verdict.is_some() && kept.pending.is_empty());
    let state = after(&asked(), [Action::Solve(SolveAction::Cancel)]);
    assert_eq!(card(&state), None, "nothing was known");
}

#[test]
fn the_proof_of_an_answer_is_checked_for_the_answer() {
    assert_eq!(proof(&learn(&asked())), None, "it is not whole");
    let state = answered(&asked());
    assert_eq!(proof(&state), Some(Proof::Offered));
    let checking = after(&state, [Action::Solve(SolveAction::CheckProof)]);
    let Some((run, Request::Certify(request))) = checking.work.request() else {
        panic!("{:?}", checking.work);
    };
    let condition = request.about.sentence();
    assert_eq!(
        condition,
        "There is no plan in which A1 does not charge at (6, 2) at time 9."
    );
    let report = Report {
        giveway: Version,
        accepted: true,
        certified: giveway_proof::Certified::Proved,
        conclusion: None,
        concluded: None,
        reason: None,
        stopped: false,
        claims: Vec::new(),
    };
    let response = Box::new(Response::Certified(Box::new(report)));
    let checked = after(
        &checking,
        [Action::Solve(SolveAction::Respond { job: run, response })],
    );
    assert!(matches!(proof(&checked), Some(Proof::Done(_))));
    let left = after(&checking, [Action::Ask(AskAction::Close)]);
    assert!(left.work.is_idle());
    assert_eq!(
        proof(&left),
        Some(Proof::Offered),
        "the plan's own is another"
    );
    let back = after(&checked, [Action::Ask(AskAction::Close)]);
    assert_eq!(proof(&back), Some(Proof::Offered));
}

#[test]
fn an_edit_or_a_selection_leaves_the_question() {
    let state = learn(&asked());
    let edited = after(&state, stroke(Tool::Obstacle, &[(8, 2)]));
    assert_eq!(edited.document.mode.asking(), None);
    assert!(edited.work.is_idle());
    let selected = after(
        &state,
        [Action::Board(BoardAction::Select(Selection::Agent(1)))],
    );
    assert_eq!(selected.document.mode.asking(), None);
    assert!(selected.work.is_idle());
}

#[test]
fn what_is_not_so_is_refused_with_what_is() {
    let wait = Question::Wait {
        agent: "A1".to_owned(),
        at: None,
        from: None,
        to: None,
        at_least: None,
    };
    let state = after(&solved(), [Action::Ask(AskAction::Ask(wait))]);
    let notice = state.view.notice.unwrap();
    assert!(notice.sentence.contains("does not wait"), "{notice:?}");
    assert!(state.work.is_idle());
}

#[test]
fn a_fact_lights_up_while_it_is_pointed_at() {
    let state = answered(&asked());
    let lit = after(&state, [Action::Ask(AskAction::Light(Some(Lit::Fact(0))))]);
    assert_eq!(lit.document.mode.asking().unwrap().lit, Some(Lit::Fact(0)));
    let dark = after(&state, [Action::Ask(AskAction::Light(None))]);
    assert_eq!(dark.document.mode.asking().unwrap().lit, None);
}
