//! Judges an answer that was picked; what it claims of the scene, the solver must confirm.

use giveway_solve::Response;

use super::statement::{self, Held};
use super::{Judging, Situation, Verdict, Why};
use crate::lesson::task::{Choice, Choose};

pub(super) fn begin(task: &Choose, situation: Situation<'_>, answer: usize) -> Judging {
    let Some(choice) = task.answers.get(answer) else {
        return Verdict::not_yet(Why::Untouched).into();
    };
    match &choice.claim {
        None => replied(choice, answer).into(),
        Some(claim) => match statement::requests(claim, situation) {
            Ok(requests) => Judging::Ask(requests),
            Err(why) => Verdict::not_yet(why).into(),
        },
    }
}

pub(super) fn conclude(
    task: &Choose,
    situation: Situation<'_>,
    answer: usize,
    responses: &[Response],
) -> Verdict {
    let Some(choice) = task.answers.get(answer) else {
        return Verdict::not_yet(Why::Untouched);
    };
    let Some(claim) = &choice.claim else {
        return replied(choice, answer);
    };
    let outcome = statement::decide(claim, situation, responses);
    let verdict = match (outcome.held, choice.right) {
        (Held::Unknown, _) => Verdict::not_yet(outcome.why),
        (Held::Yes, true) | (Held::No, false) => replied(choice, answer),
        (Held::Yes, false) | (Held::No, true) => Verdict::not_yet(Why::Disputed),
    };
    verdict.with(outcome.evidence)
}

fn replied(choice: &Choice, answer: usize) -> Verdict {
    Verdict::if_holds(choice.right, Why::Reply(answer))
}
