//! The check of a task to edit the scene: a small search over one and two edits.

use super::edit::{applied, edits};
use super::examine::{Asked, Next};
use super::{Finding, Problem};
use crate::judge::statement::{self, Held};
use crate::judge::{Did, Situation};
use crate::lesson::task::Paint;

/// The most scenes that are tried.
const MOST: usize = 200;

/// The start must not be solved. An edit or two must solve it, or else the author.
pub(super) fn search(
    task: &Paint,
    start: Situation<'_>,
    is_tried: bool,
    asked: &mut Asked<'_>,
) -> Next {
    let outcome = match statement::requests(&task.until, start) {
        Ok(requests) => statement::decide(&task.until, start, asked.all(requests)?),
        Err(why) => return Ok(Finding::of(why)),
    };
    match outcome.held {
        Held::Yes => return Ok(Problem::StartSolved.into()),
        Held::Unknown => return Ok(Finding::of(outcome.why)),
        Held::No if is_tried => return Ok(Finding::Passed),
        Held::No => {}
    }
    let Situation { step, scene, .. } = start;
    let first = edits(step, scene, MOST);
    let ones = first.iter().filter_map(|edit| applied(scene, edit));
    let twos = ones.clone().flat_map(|one| {
        let second = edits(step, &one, MOST).into_iter();
        second.filter_map(move |edit| applied(&one, &edit))
    });
    let twos = twos.take(if step.edits == Some(1) { 0 } else { MOST });
    for scene in ones.chain(twos).take(MOST) {
        let now = Situation {
            scene: &scene,
            ..start
        };
        if asked.judge(now, &Did::Edits)?.is_solved() {
            return Ok(Finding::Passed);
        }
    }
    Ok(Problem::Unsolved.into())
}
