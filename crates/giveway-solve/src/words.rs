//! What answers say to a person: one text for the page and the command.

use std::collections::BTreeMap;
use std::fmt;

use giveway_model::words::{name, sentence, value, values};
use giveway_model::{Cost, Costs, Objective};

use crate::{SolveAnswer, Status};

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
    let reason = answer.reason.as_deref().map(sentence);
    let within = answer.within.filter(|_| !answer.complete);
    let costs = answer.costs.unwrap_or_default();
    let say = |word: &str, rest: String| Headline {
        word: word.to_owned(),
        rest,
    };
    match answer.status {
        Status::Optimal => {
            let costs = values(objective.costs(), &costs);
            let within = within.map_or_else(String::new, |n| format!(" within makespan {n}"));
            say("Optimal", format!("{within}: {costs}."))
        }
        Status::Feasible => {
            let costs = with_bounds(objective, &costs, &answer.bounds);
            let reason = reason.map_or_else(String::new, |reason| format!(" {reason}"));
            say("Best so far", format!(": {costs}.{reason}"))
        }
        Status::Impossible => {
            let reason = reason.map_or_else(|| ".".to_owned(), |reason| format!(": {reason}"));
            match within {
                Some(n) => say("No plan", format!(" within makespan {n}{reason}")),
                None => say("No plan exists", format!(", {FOR_EVER}{reason}")),
            }
        }
        Status::Unknown => {
            let known = known(objective, &answer.bounds, None);
            let said = match known.as_str() {
                "" => String::new(),
                known => format!(" Proved so far: {known}."),
            };
            Headline {
                word: reason.unwrap_or_else(|| "Time ran out.".to_owned()),
                rest: format!(" There may be a plan; none was found yet.{said}"),
            }
        }
    }
}

/// How far a claim reaches that holds for plans of any makespan.
pub const FOR_EVER: &str = "no matter how many steps you allow";

/// What is claimed of an answer in a sentence of its own.
pub fn claim(answer: &SolveAnswer) -> String {
    let within = answer.within.filter(|_| !answer.complete);
    match (answer.status, within) {
        (Status::Optimal, None) => format!("No plan is better, {FOR_EVER}."),
        (Status::Optimal, Some(n)) => {
            format!("No plan of makespan at most {n} is better; a longer one might be.")
        }
        (Status::Feasible, _) => "The best plan so far: the limits ended the search.".to_owned(),
        (Status::Impossible, None) => format!("There is no plan, {FOR_EVER}."),
        (Status::Impossible, Some(n)) => {
            format!("There is no plan of makespan at most {n}; there might be a longer one.")
        }
        (Status::Unknown, _) => "No plan yet, and no proof that there is none.".to_owned(),
    }
}

/// How far bounds reach where the search ended early; nothing where there are
/// none, or they hold for plans of any makespan.
pub fn reach_of_bounds(answer: &SolveAnswer) -> Option<String> {
    let early = matches!(answer.status, Status::Feasible | Status::Unknown);
    let within = answer
        .within
        .filter(|_| early && !answer.bounds.is_empty())?;
    Some(format!(
        "What is proved holds for plans of makespan at most {within}."
    ))
}

/// How far the answer to a question reaches; nothing where nothing is claimed.
pub fn reach(complete: bool, within: Option<u32>) -> Option<String> {
    match (complete, within) {
        (true, _) => Some(format!("This holds {FOR_EVER}.")),
        (false, Some(n)) => Some(format!("This holds for plans of makespan at most {n}.")),
        (false, None) => None,
    }
}

/// What is claimed of so many plans of a Pareto front: of all of them where it is
/// whole, up to a makespan or for plans of any makespan.
pub fn front(plans: &str, is_whole: bool, within: Option<u32>) -> String {
    match (is_whole, within) {
        (false, _) => format!("{plans} so far: the limits ended the search, there may be more."),
        (true, None) => format!(
            "{plans}, and no other plan is better in one of the costs without being worse in \
             another."
        ),
        (true, Some(within)) => format!(
            "{plans}, and no other plan of makespan at most {within} is better in one of the \
             costs without being worse in another."
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
            Some(best) if best == at_least => format!("{name} is {best}"),
            Some(best) if best > at_least => {
                format!("{name} is at least {at_least}, the best plan so far has {best}")
            }
            _ => format!("{name} is at least {at_least}"),
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
            Some(&bound) if bound >= n => format!("{said}, proved"),
            Some(&bound) => format!("{said}, proved at least {bound}"),
        }
    });
    parts.collect::<Vec<_>>().join("; ")
}
