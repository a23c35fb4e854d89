//! Claims of answers in sentences, and how far they reach.

use giveway_model::words::Later;
use giveway_model::{Assumption, tr, tr_later};

use crate::{Ended, Reach, SolveAnswer, Status};

/// How far a claim reaches that holds for plans of any makespan.
pub const FOR_EVER: Later = tr_later!("a claim holds" => "no matter how many steps you allow");

/// The claim of an answer for a scene with assumptions.
pub fn claim_under(answer: &SolveAnswer, assumptions: &[Assumption]) -> String {
    let claim = claim(answer);
    if assumptions.contains(&Assumption::GoalsChosen) && !claim.is_empty() {
        tr!("{claim} This holds for the goals chosen.", claim)
    } else {
        claim
    }
}

/// That no plan is better, among those of a makespan where it is given.
pub fn proved(within: Option<u32>) -> String {
    match within {
        None => tr!("Proved: no plan is better.").to_owned(),
        Some(n) => tr!("Proved: no plan of makespan at most {n} is better.", n),
    }
}

/// What a report of the plan says of it, and whether it is proved that none is better.
pub fn on_paper(answer: &SolveAnswer) -> (String, bool) {
    match answer.status {
        Status::Optimal => (proved(answer.reach.within()), true),
        Status::Feasible | Status::Impossible | Status::Unknown => (claim(answer), false),
    }
}

/// The claim of an answer in a sentence of its own.
pub fn claim(answer: &SolveAnswer) -> String {
    let within = answer.reach.within();
    match (answer.status, within) {
        (Status::Optimal, None) => {
            tr!("No plan is better, no matter how many steps you allow.").to_owned()
        }
        (Status::Optimal, Some(n)) => {
            tr!(
                "No plan of makespan at most {n} is better; a longer one might be.",
                n
            )
        }
        (Status::Feasible, _) if may_differ(answer.ended) => {
            tr!("The best plan so far; another run may end with another plan.").to_owned()
        }
        (Status::Feasible, _) => tr!("The best plan so far.").to_owned(),
        (Status::Impossible, None) => {
            tr!("There is no plan, no matter how many steps you allow.").to_owned()
        }
        (Status::Impossible, Some(n)) => {
            tr!(
                "There is no plan of makespan at most {n}; there might be a longer one.",
                n
            )
        }
        (Status::Unknown, _) => tr!("No plan yet, and no proof that there is none.").to_owned(),
    }
}

/// Whether another run of the same search may end elsewhere: time, memory or a person
/// ended this one.
pub fn may_differ(ended: Option<Ended>) -> bool {
    ended.is_some_and(|ended| !ended.is_repeatable())
}

/// How far bounds reach where the search ended early; nothing where there are
/// none, or they hold for plans of any makespan.
pub fn reach_of_bounds(answer: &SolveAnswer) -> Option<String> {
    let early = matches!(answer.status, Status::Feasible | Status::Unknown);
    let is_bounded = early && !answer.bounds.is_empty();
    let within = answer.reach.within().filter(|_| is_bounded)?;
    Some(tr!(
        "What is proved holds for plans of makespan at most {within}.",
        within
    ))
}

/// How far the answer to a question reaches; nothing where nothing is claimed.
pub fn reach(reach: Reach) -> Option<String> {
    match (reach.is_complete(), reach.within()) {
        (true, _) => Some(tr!("This holds no matter how many steps you allow.").to_owned()),
        (false, Some(n)) => Some(tr!("This holds for plans of makespan at most {n}.", n)),
        (false, None) => None,
    }
}

/// The claim of a Pareto front of so many plans: that these are all, up to a makespan or for plans of any
/// makespan; otherwise that there may be more.
pub fn front(plans: &str, is_whole: bool, within: Option<u32>, ended: Option<Ended>) -> String {
    match (is_whole, within) {
        (false, _) if ended == Some(Ended::Time) => tr!(
            "{plans} so far: time ended the search. There may be more, and another run may find others.",
            plans
        ),
        (false, _) => tr!(
            "{plans} so far: the limits ended the search, there may be more.",
            plans
        ),
        (true, None) => tr!(
            "{plans}, and no other plan is better in one of the costs without being worse in \
             another.",
            plans
        ),
        (true, Some(within)) => tr!(
            "{plans}, and no other plan of makespan at most {within} is better in one of the \
             costs without being worse in another.",
            plans,
            within
        ),
    }
}
