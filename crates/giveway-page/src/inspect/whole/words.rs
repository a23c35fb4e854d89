//! The scene and its plan in words: what it contains, what is claimed.

use giveway_model::{Ground, tr, words::length};
use giveway_solve::Status;

use crate::{Answer, Draft, changing};

/// What is claimed, and how far it reaches; `None` where no search said anything of the plan,
/// and there is a reason for that.
pub(crate) fn claim(answer: &Answer) -> Option<String> {
    let solved = &answer.solved;
    if let (Some(course), Status::Optimal) = (&answer.course, solved.status) {
        let at = answer.changed_last().unwrap_or(0);
        let step = course.steps.last();
        let method = step.and_then(crate::words::change::methods_in_words);
        return Some(match method {
            Some(method) => tr!(
                "No way to go on from time {at} with {method} is better.",
                at,
                method
            ),
            None => tr!("No way to go on from time {at} is better.", at),
        });
    }
    if answer.by.is_some() && solved.status == Status::Feasible {
        return Some(crate::planners::claim(answer));
    }
    if answer.is_searched() {
        return Some(giveway_solve::words::claim(solved));
    }
    let asked = || tr!("Nobody has asked here whether it is the best.").to_owned();
    solved.reason.is_none().then(asked)
}

/// What a scene contains, and how many robots have broken down for good in it.
pub(super) fn contents(draft: &Draft, is_there: impl Fn(usize) -> bool, stopped: usize) -> String {
    let grid = draft.grid();
    let grounds = |is: fn(Ground) -> bool| {
        let rows = (0..grid.height()).map(|y| grid.row(y));
        rows.flatten().filter(|&&ground| is(ground)).count()
    };
    let agents = (0..draft.agents().len()).filter(|&agent| is_there(agent));
    let mut parts = vec![tr!("{n} robot" | "{n} robots" % agents.count())];
    parts.extend((stopped > 0).then(|| changing::stopped_in_words(stopped)));
    let chargers = grounds(Ground::is_charger);
    if chargers > 0 {
        parts.push(tr!("{n} charger" | "{n} chargers" % chargers));
    }
    let slow = grounds(Ground::is_slow);
    if slow > 0 {
        parts.push(tr!("{n} slow cell" | "{n} slow cells" % slow));
    }
    let obstacles = grounds(|ground| ground == Ground::Obstacle);
    if obstacles > 0 {
        parts.push(tr!("{n} obstacle" | "{n} obstacles" % obstacles));
    }
    // The sides of the floor in metres.
    parts.extend(draft.scene().units.map(|units| {
        let (width, height) = (length(units, grid.width()), length(units, grid.height()));
        tr!("a size" => "{width} x {height}", width, height)
    }));
    parts.join(", ")
}
