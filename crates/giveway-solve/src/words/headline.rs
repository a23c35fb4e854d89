//! The headline of an answer: its status and costs in one sentence.

use std::fmt;

use giveway_model::words::{sentence, values};
use giveway_model::{Objective, tr};

use super::{
    bounds::{known, with_bounds},
    reasons::reason,
};
use crate::{Ended, SolveAnswer, Status};

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
    /// The rest of the headline, its own blank or colon included.
    pub rest: String,
}

impl fmt::Display for Headline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.word)?;
        f.write_str(&self.rest)
    }
}

/// The status of an answer, and how far it reaches.
pub fn headline(objective: &Objective, answer: &SolveAnswer) -> Headline {
    let reason = answer.reason.as_ref().map(|given| sentence(&reason(given)));
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
