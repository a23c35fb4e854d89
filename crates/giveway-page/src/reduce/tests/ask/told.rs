//! A question is answered bit by bit, and left.

use giveway_model::{Question, Version};
use giveway_proof::{Certified, Report};
use giveway_solve::{Progress, Request, Response};

use super::{answered, asked, id, learn, told};
use crate::ask::{
    Held,
    Reached::{self, Ahead, Done, Now},
    card,
};
use crate::proof::{Proof, proof};
use crate::reduce::tests::{after, stroke};
use crate::sample::solved;
use crate::{
    Action, AskAction, BoardAction, Lit, Phase, Selection, SolveAction, State, Tool, WorkerAction,
    words,
};

fn reached(state: &State) -> Vec<Reached> {
    let coming = card(state).unwrap().coming.unwrap();
    coming.layers.iter().map(|layer| layer.reached).collect()
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
    assert_eq!(card.verdict, None);
    let coming = card.coming.unwrap();
    assert!(coming.is_looking);
    let held = Held {
        verdict: true,
        ways: 1,
        rows: 5,
        other: true,
        reasons: true,
        help: true,
    };
    assert_eq!(coming.held, held, "every part has its place");
    assert_eq!(reached(&state), [Now, Ahead, Ahead, Ahead, Ahead]);
    assert!(state.is_looking());
    let asking = state.document.mode.asking().unwrap();
    assert!(asking.request.plan.is_some());
}

#[test]
fn the_answer_grows_until_it_is_whole() {
    let state = learn(&asked());
    let grown = card(&state).unwrap();
    assert_eq!(grown.verdict.as_ref().unwrap().badge.word, "Costly");
    assert_eq!(reached(&state), [Done, Done, Done, Now, Done]);
    assert_eq!(grown.standing, None);
    let pays = grown.pays.unwrap();
    let charges = &pays.costs[2];
    assert_eq!((charges.this, charges.other), (3, 4));
    assert_eq!(charges.difference(), "+1");
    assert_eq!(
        grown.repairs[0].costs,
        "makespan 18, sum of costs 35, 4 charges"
    );

    let state = answered(&state);
    assert!(state.work.is_idle());
    let whole = card(&state).unwrap();
    assert_eq!(whole.coming, None);
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
        [Action::Worker(WorkerAction::Progress { job: run, event })],
    );
    assert_eq!(later, state);
}

#[test]
fn cancelling_keeps_what_is_known() {
    let state = after(&learn(&asked()), [Action::Solve(SolveAction::Cancel)]);
    assert!(state.work.is_idle());
    let kept = card(&state).unwrap();
    assert!(kept.verdict.is_some());
    let coming = kept.coming.unwrap();
    assert_eq!(
        (coming.is_looking, coming.doing.as_str()),
        (false, "Stopped")
    );
    assert_eq!(coming.held, Held::default(), "nothing comes any more");
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
        certified: Certified::Proved,
        conclusion: None,
        concluded: None,
        reason: None,
        stopped: false,
        claims: Vec::new(),
    };
    let response = Box::new(Response::Certified(Box::new(report)));
    let checked = after(
        &checking,
        [Action::Worker(WorkerAction::Respond { job: run, response })],
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
    assert!(notice.sentence().contains("does not wait"), "{notice:?}");
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

#[test]
fn a_robot_that_pays_lights_up_by_its_row() {
    let state = answered(&asked());
    let light = |lit| Action::Ask(AskAction::Light(lit));
    let lit = after(&state, [light(Some(Lit::Robot(1)))]);
    assert_eq!(card(&lit).unwrap().pays.unwrap().lit, Some(1));
    assert_eq!(crate::board::lit(&lit), Some(vec![1]));
    // Beside the other plan a press on the robot does the same, and leaves no question.
    let press = Action::Board(BoardAction::Select(Selection::Agent(1)));
    let beside = Action::Ask(AskAction::ShowOther(true));
    let pressed = after(&state, [beside, press.clone()]);
    assert_eq!(card(&pressed).unwrap().pays.unwrap().lit, Some(1));
    assert_eq!(after(&state, [press]).document.mode.asking(), None);
    let dark = after(&lit, [light(None)]);
    assert_eq!(card(&dark).unwrap().pays.unwrap().lit, None);
    assert_eq!(crate::board::lit(&dark), None);
}
