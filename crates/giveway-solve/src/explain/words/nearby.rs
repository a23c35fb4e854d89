//! What the plan shows, and small variations of it, in sentences.

use giveway_model::{Costs, Question, tr, words::and};

use super::{
    costs::instead,
    violations::{passing_first, would},
};
use crate::explain::{
    AgentDifference, ExplainAnswer, Here, Near, Variation, VariationKind, fitting::FittingQuestion,
    layers::MOST_NAMED, losses::Loss,
};

/// The answer in words as long as it has no verdict.
pub(crate) fn nearby(answer: &mut ExplainAnswer) {
    let here = answer.here.iter().map(|here| here.words.as_str());
    let near = answer.near.iter().map(|near| near.words.as_str());
    let sentences: Vec<&str> = here.chain(near).filter(|it| !it.is_empty()).collect();
    answer.words = sentences.join(" ");
}

/// Who comes through, and what would happen: of a wait if the robot went on, of other questions on
/// another way from its start. Of a cost of all robots who arrives last, or loses most.
pub(crate) fn here_sentence(case: &FittingQuestion, here: &Here, loss: Option<&Loss>) -> String {
    if let Some(loss) = loss {
        return lost(case.question, loss);
    }
    let agent = &here.agent;
    let passing: Vec<&String> = here.let_pass().collect();
    let violations = passing_first(here.violations.iter().collect(), Some(here));
    if violations.is_empty() {
        return tr!(
            "If only {agent} changed its way, no rule would be broken.",
            agent
        );
    }
    let what = would(agent, &violations, Some(case.instance));
    // What it would run into may lie long before the cell, and be about others.
    if let (Question::Yield { to, at, .. }, Some(first)) = (case.question, here.passing.first()) {
        return tr!(
            "{to} is at {at} first, at time {time}. On its quickest way to be there before, {agent} \
             would {what}.",
            to,
            at,
            time = first.time,
            agent,
            what
        );
    }
    if !matches!(case.question, Question::Wait { .. }) {
        tr!(
            "On its quickest way to do so, {agent} would {what}.",
            agent,
            what
        )
    } else if passing.is_empty() {
        tr!("Going on, {agent} would {what}.", agent, what)
    } else {
        let others = and(&passing);
        tr!(
            "{agent} lets {others} pass: going on, it would {what}.",
            agent,
            others,
            what
        )
    }
}

/// Who arrives last, or loses most, and when it would arrive alone.
fn lost(question: &Question, loss: &Loss) -> String {
    let Loss {
        agent,
        arrival,
        alone,
    } = loss;
    let is_of_last = *question == Question::Makespan;
    match (is_of_last, alone < arrival) {
        (true, true) => tr!(
            "{agent} arrives last, at {arrival}; alone it would arrive at {alone}.",
            agent,
            arrival,
            alone
        ),
        (true, false) => tr!(
            "{agent} arrives last, at {arrival}; alone it could not arrive sooner.",
            agent,
            arrival
        ),
        (false, true) => tr!(
            "{agent} loses most: it arrives at {arrival}; alone it would arrive at {alone}.",
            agent,
            arrival,
            alone
        ),
        (false, false) => tr!("Each robot arrives as soon as it could alone.").to_owned(),
    }
}

/// A variation with what it costs and who arrives later by most.
pub(crate) fn variation(
    case: &FittingQuestion,
    agent: &str,
    it: &Variation,
    before: &Costs,
) -> String {
    let does = match (it.kind, &it.other, it.cell, it.from) {
        (VariationKind::Elsewhere, _, Some(cell), Some(from)) => tr!(
            "{agent} could wait at {cell} from time {from} on",
            agent,
            cell,
            from
        ),
        (VariationKind::Elsewhere | VariationKind::OtherWay, ..) => {
            tr!("{agent} could go another way", agent)
        }
        (VariationKind::Swapped, Some(other), ..) => {
            tr!("{agent} could go first, and {other} later", agent, other)
        }
        (VariationKind::Swapped | VariationKind::Others, ..) => {
            let names: Vec<&String> = it.pays.iter().map(|it| &it.agent).collect();
            if names.len() > MOST_NAMED {
                tr!("{n} robots could move differently", n = names.len())
            } else {
                tr!("{robots} could move differently", robots = and(&names))
            }
        }
    };
    let instead = instead(case.objective(), &it.costs, before);
    let costs = if instead.is_empty() {
        tr!("{does}: that costs the same", does)
    } else {
        tr!("{does}: {instead}", does, instead)
    };
    match it.pays.first().and_then(later) {
        Some(later) => tr!("{costs}; {later}.", costs, later),
        None => tr!("{costs}.", costs),
    }
}

fn later(it: &AgentDifference) -> Option<String> {
    let steps = it
        .other
        .checked_sub(it.arrival)
        .filter(|&steps| steps > 0)?;
    Some(tr!("{name} arrives {steps} later", name = it.agent, steps))
}

/// The cheapest variation, and at how many places it could wait at that cost.
pub(crate) fn near_sentence(near: &Near) -> String {
    let Some(first) = near.variations.first() else {
        return tr!("None of the small changes that were tried would do.").to_owned();
    };
    let is_elsewhere = |it: &&Variation| it.kind == VariationKind::Elsewhere;
    let as_cheap = near
        .variations
        .iter()
        .filter(|it| it.deltas == first.deltas);
    let cells: Vec<_> = as_cheap.filter(is_elsewhere).collect();
    if cells.len() > 1 && is_elsewhere(&first) {
        let places = tr!("Any of {n} places of its way would do.", n = cells.len());
        return format!("{} {places}", first.text);
    }
    first.text.clone()
}
