//! The rules that leave no plan together: marked on the board, in the list, and where they have
//! times, in the place of the lanes.

use std::rc::Rc;

use giveway_model::condition::Times;
use giveway_model::constraint::{ConstraintKind, meant};
use giveway_model::{Agent, Constraint, Question, tr};
use giveway_solve::explain::{Core, Fact, FactKind};

use super::pieces::is_always;
use super::shortest::least_steps;
use super::zone_of;
use crate::{Draft, Lit, State};

/// Rules and facts that leave no plan, as they were answered last.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Clash {
    /// The scene that has no plan.
    pub(crate) draft: Rc<Draft>,
    /// The rules and facts.
    pub(crate) core: Core,
}

/// At most so many columns of time are shown.
const COLUMNS: u32 = 400;
/// So many columns follow the last time that a rule names.
const BEYOND: u32 = 3;

/// When rules that leave no plan hold, a row each.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClashTimes {
    /// The rows, in the order of the facts.
    pub rows: Vec<ClashRow>,
    /// The last time of the axis.
    pub last: u32,
}

/// When one of the rules holds, or lets a robot do what it has to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClashRow {
    /// Its number in the list of facts and on the map, from 1.
    pub number: usize,
    /// The rule, by its index in the scene.
    pub rule: usize,
    /// What it is about: a zone, a robot.
    pub title: String,
    /// What is so in these times: `closed`, `may arrive`.
    pub what: &'static str,
    /// The robot, by its index, where the times are those in which it may do something.
    pub agent: Option<usize>,
    /// The first time and the last; nothing where none is left.
    pub times: Option<(u32, u32)>,
    /// The time after which it is too late.
    pub ends: Option<u32>,
    /// What the times come from, where that is not the rule alone.
    pub note: Option<String>,
    /// All of it as a sentence.
    pub label: String,
    /// Whether it is lit.
    pub is_lit: bool,
}

/// The rules and facts that leave no plan for the scene on the board, as far as they are known.
pub(super) fn core(state: &State) -> Option<&Core> {
    let document = &state.document;
    let has_plan = document
        .answer
        .as_ref()
        .is_some_and(|it| it.plan().is_some());
    if has_plan || !state.can_write_rules() || state.hides_answers() {
        return None;
    }
    let asking = document
        .mode
        .asking()
        .filter(|asking| *asking.question() == Question::Unsolvable);
    let told = asking.and_then(|asking| asking.told.as_deref()?.core.as_ref());
    let before = state.view.rules.clash.as_deref();
    let before = before.filter(|clash| clash.draft == document.draft);
    let priced = || state.prices()?.told.as_deref()?.conflict.as_ref();
    told.or(before.map(|clash| &clash.core)).or_else(priced)
}

/// The rules of a set of facts, by their indices.
fn rules(core: &Core) -> impl Iterator<Item = (usize, &Fact, usize)> {
    let facts = core.facts.iter().enumerate();
    let rules = facts.filter(|(_, fact)| fact.kind == FactKind::Constraint);
    rules.filter_map(|(place, fact)| Some((place, fact, fact.index? as usize)))
}

/// The rules that leave no plan together, by their indices.
pub(crate) fn in_clash(state: &State) -> Vec<usize> {
    core(state).map_or_else(Vec::new, |core| {
        rules(core).map(|(.., rule)| rule).collect()
    })
}

/// That a rule is one of those, in a few words.
pub(super) fn told(state: &State, rule: usize) -> Option<String> {
    let core = core(state)?;
    let is_one = rules(core).any(|(.., index)| index == rule);
    is_one.then(|| {
        if core.minimal || super::price::decides(state, rule) {
            tr!("a rule" => "part of why there is no plan").to_owned()
        } else {
            tr!("a rule" => "perhaps part of why there is no plan").to_owned()
        }
    })
}

/// When the rules that leave no plan hold; nothing where none of them has times.
pub fn clash_times(state: &State) -> Option<ClashTimes> {
    let core = core(state)?;
    let constraints = &state.document.draft.scene().constraints;
    let found = rules(core)
        .filter_map(|(place, _, index)| row(state, place, index, constraints.get(index)?));
    let rows: Vec<ClashRow> = found.collect();
    let named = rows.iter().flat_map(|row| {
        let (from, to) = row.times.unzip();
        [from, to.filter(|&to| to != u32::MAX), row.ends]
    });
    let last = named.flatten().max()?.saturating_add(BEYOND).min(COLUMNS);
    Some(ClashTimes { rows, last })
}

fn row(state: &State, place: usize, index: usize, rule: &Constraint) -> Option<ClashRow> {
    let scene = state.document.draft.scene();
    let one = single(&scene.agents, rule);
    let sentence = rule.sentence();
    let title = match (zone_of(&rule.kind), one) {
        (Some(zone), _) => zone.to_owned(),
        (None, Some((_, agent))) => agent.name.clone(),
        (None, None) => rule
            .name
            .clone()
            .unwrap_or_else(|| tr!("Robots").to_owned()),
    };
    let lasting = |times: Times| {
        let times = meant(times);
        (!is_always(times)).then(|| (times.first(), times.last()))
    };
    let mut row = ClashRow {
        number: place + 1,
        rule: index,
        title,
        what: "",
        agent: None,
        times: None,
        ends: None,
        note: None,
        label: sentence.clone(),
        is_lit: state.is_lit(index, rule)
            || state
                .document
                .mode
                .asking()
                .is_some_and(|it| it.lit == Some(Lit::Fact(place))),
    };
    match &rule.kind {
        ConstraintKind::Closed { times, .. } => {
            row.what = tr!("a zone is" => "closed");
            row.times = Some(lasting(*times)?);
        }
        ConstraintKind::Capacity { times, .. } => {
            row.what = tr!("a zone is" => "limited");
            row.times = Some(lasting(*times)?);
        }
        ConstraintKind::Apart { times, .. } => {
            row.what = tr!("robots keep" => "apart");
            row.times = Some(lasting(*times)?);
        }
        ConstraintKind::Visit { times, stay, .. } => {
            let (from, to) = lasting(*times)?;
            row.what = tr!("a robot" => "may stay");
            row.agent = one.map(|(agent, _)| agent);
            row.ends = (to != u32::MAX).then_some(to);
            row.times = (from <= to.saturating_sub(*stay)).then_some((from, to));
        }
        ConstraintKind::Arrive { times } => {
            let (from, to) = lasting(*times)?;
            row.what = tr!("a robot" => "may arrive");
            row.agent = one.map(|(agent, _)| agent);
            row.ends = (to != u32::MAX).then_some(to);
            let least = one.and_then(|(_, agent)| least_steps(state.document.draft.grid(), agent));
            let first = from.max(least.unwrap_or(0));
            row.times = (first <= to).then_some((first, to));
            row.note = least.filter(|&least| least > from).map(|n| {
                tr!("its way takes at least {n} step" | "its way takes at least {n} steps" % n)
            });
        }
        ConstraintKind::Depart { from } => {
            row.what = tr!("a robot" => "may not start");
            row.times = Some((0, from.checked_sub(1)?));
        }
        ConstraintKind::OneWay { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Turns { .. }
        | ConstraintKind::Avoid { .. } => return None,
    }
    if let Some(note) = &row.note {
        row.label = format!("{sentence}, {note}");
    }
    Some(row)
}

/// The only robot that a rule binds, with its index.
pub(super) fn single<'a>(agents: &'a [Agent], rule: &Constraint) -> Option<(usize, &'a Agent)> {
    let name = match rule.agents.as_deref() {
        Some([name]) => name,
        Some(_) => return None,
        None => &agents.first().filter(|_| agents.len() == 1)?.name,
    };
    agents
        .iter()
        .enumerate()
        .find(|(_, agent)| agent.name == *name)
}
