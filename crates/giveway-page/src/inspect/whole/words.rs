//! The scene and its plan in words: what it contains, what is claimed.

use giveway_model::Ground;
use giveway_solve::Status;

use crate::words::count;
use crate::{Answer, Draft};

/// What is claimed, and how far it reaches.
pub(super) fn claim(answer: &Answer) -> String {
    let solved = &answer.solved;
    if let (Some(course), Status::Optimal) = (&answer.course, solved.status) {
        let at = answer.changed_last().unwrap_or(0);
        let step = course.steps.last().and_then(|step| step.method);
        let way = step.map_or_else(String::new, |method| {
            format!(" by {}", crate::words::change::method_in_words(method))
        });
        return format!("No way to go on from time {at}{way} is better.");
    }
    match answer.by {
        Some(_) if solved.status == Status::Feasible => crate::planners::claim(answer),
        None if solved.status == Status::Feasible => match solved.reason {
            // The reason says why there is no more.
            Some(_) => "The best plan so far.".to_owned(),
            None => "Nobody has asked here whether it is the best.".to_owned(),
        },
        _ => giveway_solve::words::claim(solved),
    }
}

/// What a scene contains.
pub(super) fn contents(draft: &Draft, is_there: impl Fn(usize) -> bool) -> String {
    let grid = draft.grid();
    let grounds = |is: fn(Ground) -> bool| {
        let rows = (0..grid.height()).map(|y| grid.row(y));
        rows.flatten().filter(|&&ground| is(ground)).count()
    };
    let agents = (0..draft.agents().len()).filter(|&agent| is_there(agent));
    let mut parts = vec![count(agents.count(), "robot")];
    for (n, thing) in [
        (grounds(Ground::is_charger), "charger"),
        (grounds(Ground::is_slow), "slow cell"),
        (grounds(|ground| ground == Ground::Obstacle), "obstacle"),
    ] {
        if n > 0 {
            parts.push(count(n, thing));
        }
    }
    parts.join(", ")
}
