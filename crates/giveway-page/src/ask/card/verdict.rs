//! The verdict of an answer: a title, how far it is proved, and one short sentence that names who
//! arrives later.

use giveway_model::{Cost, Question, check, condition::Clause, tr};
use giveway_solve::explain::{AgentDifference, ExplainAnswer, How, Part, Verdict};

use super::heading::heading;
use super::late::{late, who_is_late};
use super::parts::VerdictPart;
use super::pieces::pieces;
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
    if told.verdict == Verdict::Needless && title.is_some() {
        // The title says what could be instead: "needless" beside it reads as if nothing had been
        // the reason.
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
const fn is_of_a_whole(told: &ExplainAnswer) -> bool {
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
        Verdict::Costly | Verdict::Necessary => match told.reach.within() {
            None if told.reach.is_complete() => Some(tr!("an answer" => "proved").to_owned()),
            None => None,
            Some(n) => Some(tr!("proved" => "within {n}", n)),
        },
    }
}

/// The verdict in words; nothing where its one word is all that is known.
fn title(asking: &Asking, told: &ExplainAnswer) -> Option<String> {
    if is_of_a_whole(told) {
        return None;
    }
    match told.verdict {
        Verdict::Needless => needless(told),
        Verdict::Costly => {
            let (cost, n) = first_difference(asking, told, |delta| delta > 0)?;
            Some(match cost {
                Cost::Charges => tr!("It would cost {n} charge" | "It would cost {n} charges" % n),
                Cost::Moves => tr!("It would cost {n} move" | "It would cost {n} moves" % n),
                Cost::Penalty => tr!("It would cost a penalty of {n}", n),
                Cost::Waits => tr!("It would cost {n} wait" | "It would cost {n} waits" % n),
                Cost::Makespan => {
                    tr!("{n} step more until all are done"
                        | "{n} steps more until all are done" % n)
                }
                Cost::SumOfCosts => tr!("{n} step more in all" | "{n} steps more in all" % n),
            })
        }
        Verdict::Improvable => {
            let (cost, n) = first_difference(asking, told, |delta| delta < 0)?;
            Some(match cost {
                Cost::Charges => tr!("It would save {n} charge" | "It would save {n} charges" % n),
                Cost::Moves => tr!("It would save {n} move" | "It would save {n} moves" % n),
                Cost::Penalty => tr!("It would save a penalty of {n}", n),
                Cost::Waits => tr!("It would save {n} wait" | "It would save {n} waits" % n),
                Cost::Makespan => {
                    tr!("All can be done {n} step sooner" | "All can be done {n} steps sooner" % n)
                }
                Cost::SumOfCosts => tr!("{n} step less in all" | "{n} steps less in all" % n),
            })
        }
        Verdict::Necessary if matches!(told.question, Question::Rule { .. }) => {
            Some(tr!("It cannot be so").to_owned())
        }
        Verdict::Necessary => None,
        // The other plan is the best one that was found: another may cost less.
        Verdict::Unknown => at_most(asking, told),
    }
}

/// What the best other plan that was found costs, with the name of the cost.
fn at_most(asking: &Asking, told: &ExplainAnswer) -> Option<String> {
    asking.other.as_ref()?;
    if told.deltas.values().all(|&delta| delta == 0) {
        return Some(tr!("It costs no more").to_owned());
    }
    if let Some((cost, n)) = first_difference(asking, told, |delta| delta < 0) {
        let cost = words::name(cost);
        return Some(tr!("A better plan: {cost} {n} less", cost, n));
    }
    let (cost, n) = first_difference(asking, told, |delta| delta > 0)?;
    Some(match cost {
        Cost::Charges => tr!("At most {n} charge more" | "At most {n} charges more" % n),
        Cost::Moves => tr!("At most {n} move more" | "At most {n} moves more" % n),
        Cost::Penalty => tr!("At most a penalty of {n} more", n),
        Cost::Waits => tr!("At most {n} wait more" | "At most {n} waits more" % n),
        Cost::Makespan => {
            tr!("At most {n} step more until all are done"
                | "At most {n} steps more until all are done" % n)
        }
        Cost::SumOfCosts => {
            tr!("At most {n} step more in all" | "At most {n} steps more in all" % n)
        }
    })
}

/// The first cost of the objective that differs so, and by how much.
fn first_difference(
    asking: &Asking,
    told: &ExplainAnswer,
    is_so: impl Fn(i64) -> bool,
) -> Option<(Cost, u32)> {
    let costs = asking.objective().costs().iter();
    let mut deltas = costs.filter_map(|cost| Some((*cost, *told.deltas.get(cost)?)));
    let (cost, delta) = deltas.find(|(_, delta)| *delta != 0)?;
    let n = u32::try_from(delta.unsigned_abs()).ok()?;
    is_so(delta).then_some((cost, n))
}

/// How the other plan of the same costs does without it.
fn needless(told: &ExplainAnswer) -> Option<String> {
    let asked = told.question.agent();
    let is_wait = matches!(
        told.question,
        Question::Wait { .. } | Question::Yield { .. }
    );
    Some(match told.how.first()? {
        How::Others => {
            let others = told.pays.iter();
            let mut others = others.filter(|it| Some(it.agent.as_str()) != asked);
            let pays =
                |it: &&AgentDifference| it.other > it.arrival || it.more_waits > 0 || it.other_way;
            let other = others.find(pays)?;
            let name = &other.agent;
            if other.more_waits > 0 {
                tr!("{name} could wait instead", name)
            } else if other.other_way {
                tr!("{name} could go another way instead", name)
            } else {
                tr!("{name} could arrive later instead", name)
            }
        }
        How::OtherWay => tr!("It could drive around instead").to_owned(),
        How::Elsewhere if is_wait => tr!("It could wait elsewhere").to_owned(),
        How::Elsewhere => tr!("It could wait instead").to_owned(),
        How::Free if is_wait => tr!("It need not wait at all").to_owned(),
        How::Free => tr!("It was for nothing").to_owned(),
    })
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
        Verdict::Needless | Verdict::Improvable | Verdict::Costly => {
            asking.other.as_ref()?;
            saved(asking, told).or_else(|| who_is_late(told, clause.as_ref()))
        }
        Verdict::Necessary => {
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
