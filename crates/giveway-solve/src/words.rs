//! What answers say to a person: one text for the page and the command.

use giveway_model::words::Later;
use std::collections::BTreeMap;
use std::fmt;

use giveway_model::words::{name, retold, sentence, value, values};
use giveway_model::{Assumption, Cost, Costs, Objective, tr, tr_later};

use crate::{Ended, Reach, SolveAnswer, Status};

/// An answer in one sentence. It begins with a word that may be made bold.
///
/// ```
/// use giveway_solve::words::Headline;
/// let headline = Headline { word: "Optimal".into(), rest: ": makespan 4.".into() };
/// assert_eq!(headline.to_string(), "Optimal: makespan 4.");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Headline {
    /// The word or words that it begins with.
    pub word: String,
    /// What follows, its own blank or colon included.
    pub rest: String,
}

impl fmt::Display for Headline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.word)?;
        f.write_str(&self.rest)
    }
}

/// What is known, and how far it reaches.
pub fn headline(objective: &Objective, answer: &SolveAnswer) -> Headline {
    let reason = answer
        .reason
        .as_deref()
        .map(|given| sentence(&reason(given)));
    let within = answer.reach.within();
    let costs = answer.costs.unwrap_or_default();
    let say = |word: &str, rest: String| Headline {
        word: word.to_owned(),
        rest,
    };
    match answer.status {
        Status::Optimal => {
            let costs = values(objective.costs(), &costs);
            let rest = match within {
                Some(n) => tr!("behind: Optimal" => " within makespan {n}: {costs}.", n, costs),
                None => format!(": {costs}."),
            };
            say(tr!("an answer" => "Optimal"), rest)
        }
        Status::Feasible => {
            let is_assumed = answer.ended == Some(Ended::Assumptions);
            let costs = if is_assumed {
                values(objective.costs(), &costs)
            } else {
                with_bounds(objective, &costs, &answer.bounds)
            };
            let reason = reason.map_or_else(String::new, |reason| format!(" {reason}"));
            let word = if is_assumed {
                tr!("an answer" => "Not proved")
            } else {
                tr!("an answer" => "Best so far")
            };
            say(word, format!(": {costs}.{reason}"))
        }
        Status::Impossible => {
            let reason = reason.map_or_else(|| ".".to_owned(), |reason| format!(": {reason}"));
            match within {
                Some(n) => say(
                    tr!("an answer" => "No plan"),
                    tr!("behind: No plan" => " within makespan {n}{reason}", n, reason),
                ),
                None => say(
                    tr!("an answer" => "No plan exists"),
                    tr!("behind: No plan exists" => ", no matter how many steps you allow{reason}", reason),
                ),
            }
        }
        Status::Unknown => {
            let known = known(objective, &answer.bounds, None);
            let said = match known.as_str() {
                "" => String::new(),
                known => tr!("behind a sentence" => " Proved so far: {known}.", known),
            };
            Headline {
                word: reason.unwrap_or_else(|| tr!("Time ran out.").to_owned()),
                rest: tr!("behind a sentence" => " There may be a plan; none was found yet.{said}", said),
            }
        }
    }
}

/// What the solver gives as a reason, each in its sentence: it speaks English, wherever
/// it runs, and what it said is said anew where it is shown.
const REASONS: [Later; 41] = [
    tr_later!("The time limit was reached."),
    tr_later!("The conflict limit was reached."),
    tr_later!("The work limit was reached."),
    tr_later!("The memory limit was reached. Fewer robots or a smaller map need less."),
    tr_later!("There were too many sets of robots to free to compare them all."),
    tr_later!(
        "This asks about a time after 20,000, which is later than the search looks at step by step."
    ),
    tr_later!("The search was cancelled."),
    tr_later!("A plan and a bound contradicted each other, which is a fault of this program."),
    tr_later!("What has already happened takes longer than that."),
    tr_later!("{name} cannot do its task, even alone."),
    tr_later!("{name} has more waypoints than can be planned for."),
    tr_later!("The robots cannot all arrive."),
    tr_later!("{one} and {two} cannot both arrive."),
    tr_later!("{robots} cannot all arrive."),
    tr_later!("{one} cannot arrive."),
    tr_later!("{agent} has to go to {place}, where there is an obstacle now."),
    tr_later!("An obstacle at {place} blocks the rest of the path of {agent}."),
    tr_later!("The goal of {agent} is now {place}, which is not {bounds}."),
    tr_later!("{agent} has to visit {place}, which is not {bounds}."),
    tr_later!("The battery of {agent} does not last {bounds}."),
    tr_later!("{agent} cannot do its task {bounds}, even alone."),
    tr_later!("{agent} cannot arrive {bounds}, no matter when it waits."),
    tr_later!(
        "{robots} block each other: as long as they keep to their old paths, no choice of waits lets them all arrive."
    ),
    tr_later!(
        "{robots} block each other: as long as they keep to their old paths, no choice of waits lets them all arrive with what their batteries hold."
    ),
    tr_later!("{robots} block each other: they cannot all stay in their tunnels."),
    tr_later!("Plans that cost less were found only without the obstacles that move."),
    tr_later!(
        "The best plan without the obstacles that move breaks a rule with them: {meeting} Plans that evade them cost as much or more."
    ),
    tr_later!(
        "The plan that the search found meets an obstacle that moves, so it is open whether a legal plan costs as little."
    ),
    tr_later!(
        "Rules of the file's problem are left out, and this plan may break them. What every plan costs at least holds with them, too."
    ),
    tr_later!(
        "Rules of the file's problem are left out of the search, so it is open whether a plan that keeps them costs as little as the bound."
    ),
    tr_later!(
        "There is no plan for the goals that were chosen here. Another choice that the file allows may have one."
    ),
    tr_later!("The file leaves goals open: what a legal plan costs depends on which are chosen."),
    tr_later!(
        "The file has keys that are not heeded and may change the problem: {keys}. Whatever is said here is said for the scene without them."
    ),
    tr_later!("{agent} is at {cell} at time {time}, where the moving obstacle {obstacle} is."),
    tr_later!(
        "{agent} and the moving obstacle {obstacle} exchange {from} and {to} from time {time} to {next}."
    ),
    tr_later!("on its old path"),
    tr_later!("in its tunnel"),
    tr_later!("on any path"),
    tr_later!("The robots"),
    tr_later!("There is a better plan"),
    tr_later!("list" => "{list} and {last}"),
];

/// A reason that the solver gave, in the language that is spoken.
pub fn reason(given: &str) -> String {
    retold(given, &REASONS)
}

/// How far a claim reaches that holds for plans of any makespan.
pub const FOR_EVER: Later = tr_later!("a claim holds" => "no matter how many steps you allow");

/// What is claimed of an answer for a scene that takes something for granted.
pub fn claim_under(answer: &SolveAnswer, assumptions: &[Assumption]) -> String {
    let claim = claim(answer);
    if assumptions.contains(&Assumption::GoalsChosen) && !claim.is_empty() {
        tr!("{claim} This holds for the goals chosen.", claim)
    } else {
        claim
    }
}

/// What is claimed of an answer in a sentence of its own.
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

/// What is claimed of so many plans of a Pareto front: of all of them where it is
/// whole, up to a makespan or for plans of any makespan; otherwise that there may be more.
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

/// What is proved of each cost in turn: `makespan is 18; sum of costs is at least
/// 33, the best plan so far has 35`.
pub fn known(objective: &Objective, bounds: &BTreeMap<Cost, u32>, best: Option<&Costs>) -> String {
    let parts = objective.costs().iter().filter_map(|&cost| {
        let at_least = *bounds.get(&cost)?;
        let name = name(cost);
        Some(match best.map(|costs| costs.get(cost)) {
            Some(best) if best == at_least => tr!("{cost} is {best}", cost = name, best),
            Some(best) if best > at_least => {
                tr!(
                    "{cost} is at least {least}, the best plan so far has {best}",
                    cost = name,
                    least = at_least,
                    best
                )
            }
            _ => tr!("{cost} is at least {least}", cost = name, least = at_least),
        })
    });
    parts.collect::<Vec<_>>().join("; ")
}

/// The costs of a plan that is not proved best, each with what is proved:
/// `makespan 20, proved at least 17; 3 charges`.
fn with_bounds(objective: &Objective, costs: &Costs, bounds: &BTreeMap<Cost, u32>) -> String {
    let parts = objective.costs().iter().map(|&cost| {
        let n = costs.get(cost);
        let said = value(cost, n);
        match bounds.get(&cost) {
            None => said,
            Some(&bound) if bound >= n => tr!("{cost}, proved", cost = said),
            Some(&bound) => tr!("{cost}, proved at least {bound}", cost = said, bound),
        }
    });
    parts.collect::<Vec<_>>().join("; ")
}
