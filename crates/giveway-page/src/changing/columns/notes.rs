//! A method in words: what it promises, what else there is to say, how long it took.

use giveway_solve::Status;
use giveway_solve::change::Method;

use crate::changing::Tried;

pub(super) fn promise(method: Method) -> String {
    match method {
        Method::Revise => "Same paths, new times".to_owned(),
        Method::Tunnel(0) => "On the cells of the old paths".to_owned(),
        Method::Tunnel(1) => "Within 1 step of the old paths".to_owned(),
        Method::Tunnel(width) => format!("Within {width} steps of the old paths"),
        Method::Replan => "Everyone plans freely".to_owned(),
    }
}

pub(super) fn notes(tried: &Tried) -> Vec<String> {
    let told = &tried.told;
    let mut notes = Vec::new();
    match (told.result.status, &told.result.plan) {
        (_, Some(_)) if tried.answer.is_none() => {
            notes.push("Its plan does not fit what is listed.".to_owned());
        }
        // Where it has none, its column says so first.
        (Status::Optimal, Some(_)) | (_, None) => {}
        (_, Some(_)) => notes.push("The best so far: the limits ended the search.".to_owned()),
    }
    notes.extend(giveway_solve::change::notes(told));
    notes
}

pub(super) fn time(seconds: f64) -> String {
    if seconds < 0.0005 {
        "less than 1 ms".to_owned()
    } else if seconds < 1.0 {
        format!("{:.0} ms", seconds * 1000.0)
    } else {
        format!("{seconds:.1} s")
    }
}
