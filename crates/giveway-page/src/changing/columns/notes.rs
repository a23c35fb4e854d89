//! A method in words: what it promises, what else there is to say, how long it took.

use giveway_model::tr;
use giveway_model::words::{and, decimal};
use giveway_solve::change::Method;
use giveway_solve::{Ended, Status};

use crate::changing::Tried;

/// What became of the old paths: robots that were freed are not held to theirs.
pub(super) fn promise(tried: &Tried) -> String {
    let kept = held(
        tried.method,
        tried.told.retimed.is_empty() && tried.answer.is_some(),
    );
    match tried.told.freed.as_slice() {
        freed if freed.is_empty() || tried.method == Method::Replan => kept,
        freed => tr!("{kept}, except {robots}", kept, robots = and(freed)),
    }
}

/// What a method holds the old robots to; `is_on_time`: all of them keep their times.
fn held(method: Method, is_on_time: bool) -> String {
    match method {
        Method::Revise if is_on_time => tr!("Same paths, same times").to_owned(),
        Method::Revise => tr!("Everyone keeps their path").to_owned(),
        Method::Tunnel(0) => tr!("On the cells of the old paths").to_owned(),
        Method::Tunnel(width) => {
            tr!("At most {n} cell away from their path"
                | "At most {n} cells away from their path" % width)
        }
        Method::Replan => tr!("Everyone plans freely").to_owned(),
    }
}

pub(super) fn notes(tried: &Tried) -> Vec<String> {
    let told = &tried.told;
    let mut notes = Vec::new();
    match (told.result.status, &told.result.plan) {
        (_, Some(_)) if tried.answer.is_none() => {
            notes.push(tr!("Its plan does not fit what is listed.").to_owned());
        }
        // Where it has none, its column says so first.
        (Status::Optimal, Some(_)) | (_, None) => {}
        (_, Some(_)) if told.result.ended == Some(Ended::Time) => {
            notes.push(tr!("The best so far: time ended the search.").to_owned());
        }
        (_, Some(_)) => notes.push(tr!("The best so far: the limits ended the search.").to_owned()),
    }
    notes.extend(giveway_solve::change::notes(told));
    notes
}

pub(super) fn time(seconds: f64) -> String {
    if seconds < 0.0005 {
        tr!("less than 1 ms").to_owned()
    } else if seconds < 1.0 {
        format!("{} ms", decimal(seconds * 1000.0, 0))
    } else {
        format!("{} s", decimal(seconds, 1))
    }
}
