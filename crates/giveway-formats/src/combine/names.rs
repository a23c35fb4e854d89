//! The agents of a plan matched to those of a scene: by their names, by their order only
//! where no name fits.

use std::collections::{BTreeMap, BTreeSet};

use super::Refused;
use crate::{Format, Walk, WrittenAgent, WrittenPlan};
use giveway_model::words::and;
use giveway_model::{Agent, tr};

/// How many names a note lists.
const MAX_NAMED: usize = 8;

/// The agent of the scene for each agent of a plan, and what is to be said of it.
#[derive(Clone, Debug, Default)]
pub(super) struct Pairing {
    /// By the index of the agent in the plan; `None` where the scene has no such agent.
    pub(super) agents: Vec<Option<usize>>,
    /// Agents of the scene that the plan does not name and that stay where they are.
    pub(super) idle: Vec<usize>,
    /// Each a sentence.
    pub(super) notes: Vec<String>,
}

/// By names where one fits, else by order.
///
/// # Errors
/// When no name fits and the plan has more agents than the scene, or when robots of asprilo act
/// that the scene does not have: they are numbered as in their instance.
pub(super) fn pair(
    (file, format): (&str, Format),
    plan: &WrittenPlan,
    agents: &[Agent],
) -> Result<Pairing, Refused> {
    let by_name = by_name(file, format, plan, agents)?;
    if format == Format::Asprilo || by_name.agents.iter().any(Option::is_some) {
        return Ok(by_name);
    }
    by_order(file, plan, agents)
}

/// By order.
///
/// # Errors
/// When the plan has more agents than the scene.
pub(super) fn by_order(
    file: &str,
    plan: &WrittenPlan,
    agents: &[Agent],
) -> Result<Pairing, Refused> {
    if plan.agents.len() > agents.len() {
        let planned = tr!("{n} robot" | "{n} robots" % plan.agents.len());
        let there = tr!("{n} robot" | "{n} robots" % agents.len());
        return Err(Refused::Apart(tr!(
            "{file} has a plan for {planned}, and the scene has {there}.",
            file,
            planned,
            there
        )));
    }
    Ok(numbered(
        file,
        plan,
        agents,
        (0..plan.agents.len()).collect(),
    ))
}

/// Agents of a plan with those of the scene by number, and a note where names differ.
fn numbered(file: &str, plan: &WrittenPlan, agents: &[Agent], numbers: Vec<usize>) -> Pairing {
    let pairs = plan.agents.iter().zip(&numbers);
    let pairs = pairs.filter_map(|(own, &index)| {
        let (own, name) = (own.name.as_deref()?, &*agents.get(index)?.name);
        (own != name).then(|| format!("{own} = {name}"))
    });
    let pairs: Vec<String> = pairs.collect();
    let mut notes = Vec::new();
    if !pairs.is_empty() {
        notes.push(tr!(
            "The robots in {file} are matched by their order, not by their names: {pairs}.",
            file,
            pairs = listed(&pairs)
        ));
    }
    Pairing {
        agents: numbers.into_iter().map(Some).collect(),
        idle: Vec::new(),
        notes,
    }
}

/// By the numbers in names like `agent0`, which count the agents of the scene from 0;
/// `None` where a name has none, or one that no agent has.
pub(super) fn by_number(file: &str, plan: &WrittenPlan, agents: &[Agent]) -> Option<Pairing> {
    let number = |agent: &WrittenAgent| {
        let number = agent.name.as_deref()?.strip_prefix("agent")?;
        number.parse::<usize>().ok().filter(|&n| n < agents.len())
    };
    let matched: Vec<usize> = plan.agents.iter().map(number).collect::<Option<_>>()?;
    Some(numbered(file, plan, agents, matched))
}

fn by_name(
    file: &str,
    format: Format,
    plan: &WrittenPlan,
    agents: &[Agent],
) -> Result<Pairing, Refused> {
    let indices = agents.iter().enumerate();
    let indices: BTreeMap<&str, usize> = indices.map(|(i, it)| (&*it.name, i)).collect();
    let of = |agent: &WrittenAgent| indices.get(agent.name.as_deref()?).copied();
    let matched: Vec<Option<usize>> = plan.agents.iter().map(of).collect();
    let named: BTreeSet<usize> = matched.iter().flatten().copied().collect();
    let left = agents.iter().enumerate();
    let left: Vec<(usize, &Agent)> = left.filter(|(i, _)| !named.contains(i)).collect();
    // In asprilo a robot without an action stands still.
    let stands = format == Format::Asprilo;
    let mut notes = Vec::new();
    let unknown = plan.agents.iter().zip(&matched);
    let unknown = unknown.filter(|(agent, index)| index.is_none() && !(stands && is_still(agent)));
    let unknown = unknown.filter_map(|(agent, _)| agent.name.as_deref());
    let unknown: Vec<&str> = unknown.collect();
    if !unknown.is_empty() && stands {
        return Err(Refused::Apart(tr!(
            "{file} has actions of robots that the scene does not have: {names}. Open the instance that the plan was made for.",
            file,
            names = listed(&unknown)
        )));
    }
    if !unknown.is_empty() {
        notes.push(tr!(
            "{file} has paths for robots that the scene does not have: {names}.",
            file,
            names = listed(&unknown)
        ));
    }
    let missing: Vec<&str> = left.iter().map(|(_, agent)| &*agent.name).collect();
    if !missing.is_empty() {
        let names = listed(&missing);
        notes.push(if stands {
            tr!(
                "{file} has no action of {names}: they stand still.",
                file,
                names
            )
        } else {
            tr!("{file} has no path for {names}.", file, names)
        });
    }
    let idle = left.iter().map(|&(index, _)| index);
    Ok(Pairing {
        agents: matched,
        idle: if stands { idle.collect() } else { Vec::new() },
        notes,
    })
}

/// Whether an agent has a walk without a step.
pub(super) fn is_still(agent: &WrittenAgent) -> bool {
    matches!(&agent.walk, Walk::Fixed(moves) if moves.is_empty())
}

/// Names as a list that is not too long.
fn listed(names: &[impl AsRef<str>]) -> String {
    let mut all: Vec<String> = names
        .iter()
        .take(MAX_NAMED)
        .map(|it| it.as_ref().to_owned())
        .collect();
    let more = names.len().saturating_sub(MAX_NAMED);
    if more > 0 {
        all.push(tr!("{n} more" | "{n} more" % more));
    }
    and(&all)
}
