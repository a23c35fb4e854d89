//! Judges a scene that was edited until a statement holds.

use giveway_solve::Response;

use super::statement::{self, Held};
use super::{Judging, Situation, Verdict, Why, edits};
use crate::lesson::task::Paint;

pub(super) fn begin(task: &Paint, situation: Situation<'_>) -> Judging {
    if situation.scene == situation.start {
        return Verdict::not_yet(Why::Untouched).into();
    }
    match statement::requests(&task.until, situation) {
        Ok(requests) => Judging::Ask(requests),
        Err(why) => Verdict::not_yet(why).into(),
    }
}

pub(super) fn conclude(task: &Paint, situation: Situation<'_>, responses: &[Response]) -> Verdict {
    let edited = match edits::allowed(situation) {
        Ok(edited) if situation.scene != situation.start => edited,
        Ok(_) => return Verdict::not_yet(Why::Untouched),
        Err(why) => return Verdict::not_like_this(why),
    };
    let outcome = statement::decide(&task.until, situation, responses);
    let verdict = match (outcome.held, &outcome.why) {
        (Held::Yes, _) => Verdict {
            seal: edited,
            ..Verdict::solved(outcome.why)
        },
        (Held::No, Why::AloneStuck(_)) | (Held::Unknown, Why::Refused(_)) => {
            Verdict::not_like_this(outcome.why)
        }
        (Held::No | Held::Unknown, _) => Verdict::not_yet(outcome.why),
    };
    verdict.with(outcome.evidence)
}
