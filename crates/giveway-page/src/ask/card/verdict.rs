//! The verdict of an answer: a title, how far it is proved, and one short sentence that names who
//! arrives later.

use giveway_model::{Cost, Question, check, condition::Clause, tr};
use giveway_solve::explain::{ExplainAnswer, Part, Verdict};

use super::heading::heading;
use super::late::{late, who_is_late};
use super::parts::VerdictPart;
use super::pieces::pieces;
use super::tight::{forcing, forcing_sentence};
use super::title::{first_difference, title};
use crate::ask::signs::{badge, verdict_words};
use crate::{Asking, State, words};

/// The verdict as far as it is known; nothing before anything is.
pub(super) fn verdict(state: &State, asking: &Asking, told: &ExplainAnswer) -> Option<VerdictPart> {
    let is_coming = is_coming(told);
    if is_coming && told.words.is_empty() && told.alternative.is_none() {
        return None;
    }
    let mut badge = badge(told);
    if is_coming {
        // Nothing is unknown for good yet.
        badge.word = "";
    }
    let title = title(asking, told);
    let says_it = match told.verdict {
        // "Needless" beside what could be instead reads as if nothing had been the reason.
        Verdict::Needless | Verdict::Necessary | Verdict::Unknown => title.is_some(),
        Verdict::Costly | Verdict::Improvable => false,
    };
    if says_it {
        badge.word = "";
    }
    let title = title.unwrap_or_else(|| heading(told));
    let sentence = if is_coming {
        so_far(asking, told)
    } else {
        sentence(asking, told)
    };
    let here = told.here.as_ref().map(|here| here.words.as_str());
    let sentence = sentence.or_else(|| {
        let said = verdict_words(state, asking, told);
        // All that is known in words begins with what the plan shows.
        let said = here
            .and_then(|here| said.strip_prefix(here))
            .unwrap_or(&said);
        let said = said.trim_start();
        (!said.is_empty()).then(|| words::unnested(said))
    });
    // What the plan shows was said first, and keeps its place.
    let sentences = here.into_iter().chain(sentence.as_deref());
    let sentence = sentences.collect::<Vec<_>>().join("\n");
    Some(VerdictPart {
        badge,
        title,
        claim: claim(told),
        pieces: pieces(&sentence, asking.about.agents()),
        sentence,
    })
}

/// Whether the verdict is still looked for, or the search was stopped before it.
pub(super) fn is_coming(told: &ExplainAnswer) -> bool {
    told.verdict == Verdict::Unknown && told.pending.contains(&Part::Verdict)
}

/// What the best plan found so far saves, or who is late in it.
fn so_far(asking: &Asking, told: &ExplainAnswer) -> Option<String> {
    asking.other.as_ref()?;
    saved(asking, told).or_else(|| {
        let late = late(told).next()?;
        Some(tr!(
            "{name} would arrive at {other} or sooner, not at {arrival}.",
            name = late.agent,
            other = late.other,
            arrival = late.arrival
        ))
    })
}

/// What a better plan saves, in both numbers; nothing where the other plan is no better.
fn saved(asking: &Asking, told: &ExplainAnswer) -> Option<String> {
    let (cost, _) = first_difference(asking, told, |delta| delta < 0)?;
    let (this, other) = (asking.about.solved.costs?, told.costs?);
    let (this, other) = (this.get(cost), other.get(cost));
    Some(match cost {
        Cost::Makespan => tr!(
            "All robots could be done at {other} instead of {this}.",
            other,
            this
        ),
        Cost::SumOfCosts | Cost::Penalty => tr!(
            "The {cost} could be {other} instead of {this}.",
            cost = words::name(cost),
            other,
            this
        ),
        Cost::Charges | Cost::Moves | Cost::Waits => tr!(
            "There could be {other} instead of {this}.",
            other = words::value(cost, other),
            this
        ),
    })
}

/// Whether the answer is about a whole plan: then it has words of its own.
pub(super) const fn is_of_a_whole(told: &ExplainAnswer) -> bool {
    told.valid.is_some() || matches!(told.question, Question::Unsolvable | Question::Plan)
}

/// How far the verdict is proved, in a few words.
fn claim(told: &ExplainAnswer) -> Option<String> {
    if is_of_a_whole(told) {
        return None;
    }
    match told.verdict {
        Verdict::Needless => Some(tr!("costs" => "same cost").to_owned()),
        // The other plan is there to be seen.
        Verdict::Improvable => None,
        Verdict::Unknown if told.pending.contains(&Part::Verdict) => {
            Some(tr!("an answer" => "so far").to_owned())
        }
        Verdict::Unknown => told
            .costs
            .map(|_| tr!("an answer" => "not proved").to_owned()),
        // That it costs more is proved even where it is not known yet how much.
        Verdict::Costly | Verdict::Necessary => match told.reach.within() {
            None if told.reach.is_complete() => Some(tr!("an answer" => "proved").to_owned()),
            None => None,
            Some(n) => Some(tr!("proved" => "within {n}", n)),
        },
    }
}

/// One sentence of at most 30 words; nothing where too little is known to make it.
fn sentence(asking: &Asking, told: &ExplainAnswer) -> Option<String> {
    if is_of_a_whole(told) {
        return None;
    }
    let clause = clause(asking);
    match told.verdict {
        // What is not proved is said no harder at the end than on the way.
        Verdict::Unknown => so_far(asking, told),
        Verdict::Costly if told.at_most => so_far(asking, told),
        Verdict::Needless | Verdict::Improvable | Verdict::Costly => {
            asking.other.as_ref()?;
            saved(asking, told).or_else(|| who_is_late(told, clause.as_ref()))
        }
        Verdict::Necessary => {
            if let Some(bound) = forcing(asking, told) {
                return Some(forcing_sentence(asking, bound));
            }
            let does = clause?.does;
            Some(match told.reach.within() {
                None => tr!("There is no plan in which {does}.", does),
                Some(n) => tr!(
                    "There is no plan with a makespan of at most {n} in which {does}.",
                    n,
                    does
                ),
            })
        }
    }
}

/// The contrast of the question as a clause; `None` where it has none, or a number in it is not
/// known.
fn clause(asking: &Asking) -> Option<Clause> {
    let about = &asking.about;
    let costs = about.solved.costs?;
    let position = |name: &str| about.agents().iter().position(|agent| agent.name == name);
    let condition = asking
        .question()
        .condition(|agent, cost| match (agent, cost) {
            (None, cost) => Some(costs.get(cost)),
            (Some(name), Cost::Makespan | Cost::SumOfCosts) => {
                *about.arrivals.get(position(name)?)?
            }
            // What a robot did before the world changed does not count there.
            (Some(_), _) if about.course.is_some() => None,
            (Some(_), _) => {
                check::cost_of(about.draft.instance().ok()?, about.plan()?, agent, cost)
            }
        });
    Some(condition?.clause())
}
