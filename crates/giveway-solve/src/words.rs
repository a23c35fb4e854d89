//! Answers in sentences: one text for the page and the command.

use giveway_model::words::Later;
use std::collections::BTreeMap;
use std::fmt;

use giveway_model::words::{and, name, sentence, value, values};
use giveway_model::{Assumption, Constraint, Cost, Costs, Objective, assumption, tr, tr_later};

use crate::{Ended, Reach, Reason, SolveAnswer, Status, change};

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

/// A reason as a sentence, in the language that is spoken.
pub fn reason(reason: &Reason) -> String {
    match reason {
        Reason::Stopped(stop) => stop.sentence().to_owned(),
        Reason::StoppedByPerson => tr!("You stopped the search").to_owned(),
        Reason::Alone { agent, rules } if rules.is_empty() => {
            tr!("{name} cannot do its task, even alone.", name = agent)
        }
        Reason::Alone { agent, rules } => tr!(
            "{name} cannot do its task, even alone, because of {rules}.",
            name = agent,
            rules = called(rules)
        ),
        Reason::ManyWaypoints { agent } => {
            tr!(
                "{name} has more waypoints than can be planned for.",
                name = agent
            )
        }
        Reason::Clash { agents } => clash(agents),
        Reason::Cause(cause) => change::words::cause(cause),
        Reason::PastTooLong => {
            tr!("What has already happened takes longer than that.").to_owned()
        }
        Reason::StepsOver { steps, arrived, of } => tr!(
            "After {n} step {arrived} of {all} robots were at their goals, and the planner ended."
                | "After {n} steps {arrived} of {all} robots were at their goals, and the planner ended."
                % *steps,
            arrived,
            all = of
        ),
        Reason::SearchEnded => {
            tr!("The planner's search came to its end without a plan that fits.").to_owned()
        }
        Reason::LeastWithin { cost, within } => tr!(
            "No plan of makespan at most {n} has a smaller {cost}; a longer one might.",
            n = within,
            cost = name(*cost)
        ),
        Reason::Beaten => tr!("There is a better plan").to_owned(),
        Reason::LeftOutRules => tr!(
            "Rules of the file's problem are left out, and this plan may break them. What every plan costs at least holds with them, too."
        )
        .to_owned(),
        Reason::BetterLeftOutRules => tr!(
            "Rules of the file's problem are left out of the search, so it is open whether a plan that keeps them costs as little as the bound."
        )
        .to_owned(),
        Reason::ChosenGoals => tr!(
            "There is no plan for the goals that were chosen here. Another choice that the file allows may have one."
        )
        .to_owned(),
        Reason::OpenGoals => {
            tr!("The file leaves goals open: what a legal plan costs depends on which are chosen.")
                .to_owned()
        }
        Reason::UnknownKeys { keys } => assumption::sentences(keys).join(" "),
    }
}

/// Agents that cannot all arrive, as a sentence; all of the scene where none is named.
pub(crate) fn clash<S: AsRef<str>>(agents: &[S]) -> String {
    let names: Vec<&str> = agents.iter().map(AsRef::as_ref).collect();
    match names.as_slice() {
        [] => tr!("The robots cannot all arrive.").to_owned(),
        [one] => tr!("{one} cannot arrive.", one),
        [one, two] => tr!("{one} and {two} cannot both arrive.", one, two),
        names => tr!("{robots} cannot all arrive.", robots = and(names)),
    }
}

/// Rules of a scene's own by what they are called, as a list.
pub(crate) fn called(rules: &[Constraint]) -> String {
    let rules: Vec<String> = rules.iter().map(Constraint::called).collect();
    and(&rules)
}

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

/// The bound of each cost in turn: `makespan is 18; sum of costs is at least 33, the best plan so far has
/// 35`.
pub fn known(objective: &Objective, bounds: &BTreeMap<Cost, u32>, best: Option<&Costs>) -> String {
    let parts = objective.costs().iter().filter_map(|&cost| {
        let at_least = *bounds.get(&cost)?;
        let name = name(cost);
        let best = best.map(|costs| costs.get(cost));
        // Charges, moves and waits are counted: their number stands before their name.
        if matches!(cost, Cost::Charges | Cost::Moves | Cost::Waits) {
            let least = value(cost, at_least);
            return Some(match best {
                Some(best) if best == at_least => least,
                Some(best) if best > at_least => {
                    tr!(
                        "at least {least}, the best plan so far has {best}",
                        least,
                        best
                    )
                }
                _ => tr!("at least {least}", least),
            });
        }
        Some(match best {
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
