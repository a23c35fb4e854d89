//! The answer to a question about a plan.

use giveway_model::{Costs, Instance, Objective, Plan, Question, tr};

use super::{
    alone::{alone, alone_sentence},
    contrast::contrast,
    costs::instead as in_costs,
    differences::instead,
    joined::because,
    repairs::{led_to, phrase},
    violations::{passing_first, would},
};
use crate::explain::{
    Core, Edit, Here, Repair, SubsetBound, Verdict, WitnessEntry, whole::WholePlan,
};

/// All that is known, as far as it is known.
pub(crate) struct KnownSoFar<'a> {
    pub(crate) instance: &'a Instance,
    pub(crate) question: &'a Question,
    pub(crate) objective: &'a Objective,
    /// The plan that is asked about.
    pub(crate) plan: &'a Plan,
    /// The plan of which the instance is the rest; all times and costs are told as those
    /// of the whole.
    pub(crate) whole: WholePlan<'a>,
    pub(crate) verdict: Verdict,
    /// Whether the best other plan is not known yet, though it costs more.
    pub(crate) is_open: bool,
    /// The other plan.
    pub(crate) alternative: Option<&'a Plan>,
    /// The makespan up to which the verdict holds; `None` for any.
    pub(crate) within: Option<u32>,
    /// What the plan shows, where that was told: the same robots are named.
    pub(crate) here: Option<&'a Here>,
    /// The agent of the witness, and what it would run into.
    pub(crate) witness: (&'a str, &'a [WitnessEntry]),
    pub(crate) core: Option<&'a Core>,
    /// What sets of agents alone need.
    pub(crate) alone: &'a [SubsetBound],
    pub(crate) repairs: &'a [Repair],
}

/// The answer in words.
pub(crate) fn verdict(telling: &KnownSoFar) -> String {
    let Some(contrast) = contrast(telling) else {
        return String::new();
    };
    let costs = |plan: &Plan| telling.whole.costs_of(telling.instance, plan);
    let before = costs(telling.plan).unwrap_or_default();
    let mut sentences = Vec::new();
    let force = forcing(telling, before.makespan);
    sentences.extend(force.map(alone_sentence));
    // A cost that some robots force is not due to the way of one of them.
    let (agent, entries) = match force {
        Some(_) => ("", [].as_slice()),
        None => telling.witness,
    };
    let violations = entries.iter().map(|entry| &entry.violation).collect();
    let violations = passing_first(violations, telling.here);
    let goes_wrong = !violations.is_empty();
    if goes_wrong {
        let of_agent = telling.question.agent() == Some(agent);
        let who = if of_agent {
            tr!("a robot would" => "it")
        } else {
            agent
        };
        let what = would(agent, &violations, Some(telling.instance));
        sentences.push(tr!(
            "If {would}, {who} would {what}.",
            would = contrast.would,
            who,
            what
        ));
    }
    let now = telling.alternative.and_then(costs).unwrap_or(before);
    let within = telling.within.map_or_else(
        String::new,
        |n| tr!("a plan" => " with a makespan of at most {n}", n),
    );
    sentences.push(match telling.verdict {
        Verdict::Needless => needless(telling, goes_wrong, &contrast.does),
        Verdict::Improvable => {
            let instead = in_costs(telling.objective, &now, &before);
            tr!(
                "There is even a better plan{in_which}: {instead}.",
                in_which = in_which(&contrast.does),
                instead
            )
        }
        Verdict::Costly => costly(telling, &contrast.does, &now, &before),
        Verdict::Necessary => tr!(
            "There is no plan{within}{in_which}.",
            within,
            in_which = in_which(&contrast.does)
        ),
        Verdict::Unknown => {
            let does = &contrast.does;
            tr!(
                "The search ended before it was known whether a plan in which {does} would cost \
                 more.",
                does
            )
        }
    });
    if matches!(telling.verdict, Verdict::Necessary | Verdict::Costly) {
        if force.is_none() {
            sentences.extend(alone(telling.alone, telling.core.is_some()));
        }
        sentences.extend(because(telling.core, telling.verdict));
    }
    sentences.extend(help(telling.repairs, telling.question.arriving()));
    sentences.join(" ")
}

/// The robots that alone need as many steps as the plan has, where these are asked about; nothing where
/// they are all robots.
fn forcing<'a>(telling: &KnownSoFar<'a>, makespan: u32) -> Option<&'a SubsetBound> {
    let count = telling.instance.agents().len();
    SubsetBound::forcing(
        telling.alone,
        telling.question,
        telling.verdict,
        makespan,
        count,
    )
}

fn in_which(does: &str) -> String {
    tr!("a plan" => " in which {does}", does)
}

fn needless(telling: &KnownSoFar, goes_wrong: bool, does: &str) -> String {
    let instead = telling
        .alternative
        .and_then(|other| instead(telling.question, telling.instance, telling.plan, other));
    match (instead, goes_wrong) {
        (Some(instead), true) => {
            tr!(
                "But {instead}: there is another plan that costs the same.",
                instead
            )
        }
        (Some(instead), false) => {
            tr!(
                "It does not have to be this way. {instead}: there is a plan that costs the same \
                 and in which {does}.",
                instead,
                does
            )
        }
        (None, true) => tr!("But there is another plan that costs the same.").to_owned(),
        (None, false) => tr!(
            "It does not have to be this way: there is a plan that costs the same and in which \
             {does}.",
            does
        ),
    }
}

fn costly(telling: &KnownSoFar, does: &str, now: &Costs, before: &Costs) -> String {
    let instead = in_costs(telling.objective, now, before);
    match telling.within {
        None if telling.is_open => tr!(
            "There is a plan in which {does}, but none costs as little: the best one so far has \
             {instead}.",
            does,
            instead
        ),
        Some(n) if telling.is_open => tr!(
            "There is a plan in which {does}, but none of makespan at most {n} costs as little: \
             the best one so far has {instead}.",
            does,
            n,
            instead
        ),
        None => tr!(
            "There is a plan in which {does}, but the best one has {instead}.",
            does,
            instead
        ),
        Some(n) => tr!(
            "There is a plan in which {does}, but the best one of makespan at most {n} has {instead}.",
            does,
            n,
            instead
        ),
    }
}

/// The first repair; where it leaves robots out, beside the first that does not.
pub(crate) fn help(repairs: &[Repair], arriving: Option<&str>) -> Option<String> {
    let first = repairs.first()?;
    let leaves_out = |repair: &&Repair| {
        let mut edits = repair.edits.iter();
        edits.any(|edit| matches!(edit, Edit::LeaveOut { .. }))
    };
    if leaves_out(&first)
        && let Some(other) = repairs.iter().find(|repair| !leaves_out(repair))
    {
        return Some(tr!(
            "It would help to {other}, or to {do_so}.",
            other = phrase(&other.edits),
            do_so = phrase(&first.edits)
        ));
    }
    Some(tr!(
        "It would help to {do_so}.",
        do_so = led_to(&phrase(&first.edits), first, arriving)
    ))
}
