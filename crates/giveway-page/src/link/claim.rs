//! What is claimed of a plan, as this browser keeps it: numbers joined by
//! points, 0 for what is not there and 1 more for what is; behind `!!` the reason, in letters.
//! Behind one `!` it was a sentence once, in the language of the page: the claim is read, and
//! the reason where it is one of the limits.

use giveway_model::{Cost, sorting};
use giveway_solve::{Ended, Reason, SolveAnswer, Status};
use serde_json::json;

use super::answers;
use super::text::numbers;

const STATUSES: [Status; 4] = [
    Status::Optimal,
    Status::Feasible,
    Status::Impossible,
    Status::Unknown,
];

const ENDS: [Ended; 9] = [
    Ended::Proof,
    Ended::Work,
    Ended::Conflicts,
    Ended::Time,
    Ended::Memory,
    Ended::Cancelled,
    Ended::Size,
    Ended::Fault,
    Ended::Assumptions,
];

pub(super) fn write(solved: &SolveAnswer) -> String {
    let status = STATUSES.iter().position(|status| *status == solved.status);
    let plus_one = |n: Option<u32>| n.map_or(0, |n| n.saturating_add(1));
    let count = |n: u64| u32::try_from(n).unwrap_or(u32::MAX);
    let mut parts = vec![
        status.unwrap_or(1) as u32,
        u32::from(solved.reach.is_complete()),
        plus_one(solved.reach.within()),
    ];
    let bounds = Cost::USUAL.map(|cost| plus_one(solved.bounds.get(&cost).copied()));
    parts.extend(bounds);
    let stats = solved.stats;
    parts.extend([stats.variables, stats.clauses, stats.conflicts].map(count));
    let mut parts: Vec<String> = parts.iter().map(ToString::to_string).collect();
    parts.push(format!("{:.0}", stats.cpu_seconds * 1000.0));
    let ended = ENDS.iter().position(|&ended| solved.ended == Some(ended));
    parts.extend(ended.map(|place| place.to_string()));
    let reason = solved.reason.as_ref().map(answers::write);
    format!("{}!!{}", parts.join("."), reason.unwrap_or_default())
}

/// Takes a claim in; `None`, and the answer stays as it was, where the claim is
/// broken or does not fit the plan.
pub(super) fn read(solved: &mut SolveAnswer, text: &str) -> Option<()> {
    let (parts, reason) = text.split_once('!')?;
    let [status, complete, within, rest @ ..] = &numbers(parts)?[..] else {
        return None;
    };
    let (bounds, [variables, clauses, conflicts, milliseconds, ended @ ..]) =
        rest.split_first_chunk::<5>()?
    else {
        return None;
    };
    let status = *STATUSES.get(*status as usize)?;
    let is_plan = matches!(status, Status::Optimal | Status::Feasible);
    if is_plan != solved.plan.is_some() {
        return None;
    }
    let ended = ended.first();
    let ended = ended.and_then(|&place| ENDS.get(place as usize).copied());
    let reason = match reason.strip_prefix('!') {
        Some("") => None,
        Some(letters) => answers::read(letters)?,
        None => ended.and_then(Ended::limit).map(Reason::Stopped),
    };
    let reach = json!({ "complete": *complete == 1, "within": within.checked_sub(1) });
    let reach = serde_json::from_value(reach).ok()?;
    solved.status = status;
    solved.reach = reach;
    let bounds = Cost::USUAL.into_iter().zip(bounds);
    let bounds = bounds.filter_map(|(cost, &bound)| Some((cost, bound.checked_sub(1)?)));
    solved.bounds = sorting::map(bounds);
    solved.ended = ended;
    solved.reason = reason;
    solved.stats.variables = (*variables).into();
    solved.stats.clauses = (*clauses).into();
    solved.stats.conflicts = (*conflicts).into();
    solved.stats.cpu_seconds = f64::from(*milliseconds) / 1000.0;
    Some(())
}
