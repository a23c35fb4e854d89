//! The rules of the scene's own, watched step by step: what has to be remembered of the way
//! so far, what a step costs, and when a rule can be kept no more.
//!
//! Of some agents only, a rule holds among these: that leaves plans in, and none out.
//! Times after the last one that a rule names are alike.

mod places;
mod steps;

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::condition::Times;
use giveway_model::constraint::{ConstraintKind, Heading, InForce, meant};
use giveway_model::sorting::sort_by_key;
use giveway_model::{Cell, Instance, Zone};

use super::lone::{Lone, State, Step};

/// The rules in force, of the agents that are searched.
pub(super) struct Rules<'a> {
    /// Those that remember something come first.
    rules: Vec<Watched<'a>>,
    /// The last time that a rule names.
    last: u32,
}

/// A rule in force.
struct Watched<'a> {
    kind: &'a ConstraintKind,
    /// The agents that it binds, by their places in the search.
    agents: Vec<usize>,
    /// Its zone, where it has one.
    area: BTreeSet<Cell>,
    /// The headings of these agents.
    headings: Vec<Option<Heading>>,
    /// The two agents of a precedence.
    pair: Option<(usize, usize)>,
}

/// The part of the past that the rules ask for.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Past {
    /// The time, up to one after the last that a rule names.
    time: u32,
    /// Of each rule that remembers something.
    records: Vec<Record>,
}

/// What one rule asks for.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Record {
    /// Nothing.
    None,
    /// Of each agent a number: cells that are done, times of a stay, waits on end.
    Counts(Vec<u32>),
    /// For each cell the last agent there, and how long ago it was.
    Visitors(BTreeMap<Cell, (usize, u32)>),
    /// Whether the first agent of a precedence has been at its cell.
    Been(bool),
    /// Of each agent where it faces, and for how long it has stood.
    Facing(Vec<(Option<Heading>, u32)>),
}

impl<'a> Rules<'a> {
    pub(super) fn of(instance: &'a Instance, agents: &[usize]) -> Self {
        let place = |agent: usize| agents.iter().position(|&other| other == agent);
        let rules = instance.constraints_in_force();
        let mut rules: Vec<Watched<'a>> = rules
            .filter_map(|rule| Watched::of(instance, &rule, &place))
            .collect();
        sort_by_key(&mut rules, |rule| rule.begin() == Record::None);
        let named = rules.iter().flat_map(|rule| named_times(rule.kind));
        Self {
            last: named.max().unwrap_or(0),
            rules,
        }
    }

    /// How many rules look at each step.
    pub(super) const fn count(&self) -> usize {
        self.rules.len()
    }

    /// How many rules have a record in each state.
    pub(super) fn recorded(&self) -> usize {
        let records = self.rules.iter().map(Watched::begin);
        records.take_while(|it| *it != Record::None).count()
    }

    /// The past at time 0; `None` where a rule cannot be kept any more.
    pub(super) fn begin(&self, steps: &[Step]) -> Option<Past> {
        let records = self.rules.iter().map(Watched::begin);
        let past = Past {
            time: 0,
            records: records.take_while(|it| *it != Record::None).collect(),
        };
        self.come(None, steps, past)
    }

    /// The past a step later, and what the step costs in penalties; `None` where a rule cannot
    /// be kept any more.
    pub(super) fn step(
        &self,
        before: &[State],
        steps: &[Step],
        past: &Past,
    ) -> Option<(Past, u32)> {
        if self.rules.is_empty() {
            return Some((Past::default(), 0));
        }
        // To arrive where it waited is to have arrived before.
        let mut both = before.iter().zip(steps);
        if both.any(|(from, step)| {
            step.crosses.is_none() && !from.has_arrived() && step.to.has_arrived()
        }) {
            return None;
        }
        let mut past = past.clone();
        let mut penalty: u32 = 0;
        let (mut records, mut nothing) = (past.records.iter_mut(), Record::None);
        for rule in &self.rules {
            let record = records.next().unwrap_or(&mut nothing);
            if !rule.leave(before, steps, past.time, record) {
                return None;
            }
            penalty = penalty.saturating_add(rule.penalty(before, past.time));
        }
        past.time = past.time.saturating_add(1).min(self.last.saturating_add(1));
        Some((self.come(Some(before), steps, past)?, penalty))
    }

    /// Whether all rules are kept for ever, once all agents have arrived.
    pub(super) fn are_kept(&self, past: &Past) -> bool {
        // A rule that remembers nothing demands nothing later.
        let mut rules = self.rules.iter().zip(&past.records);
        self.rules.is_empty()
            || past.time > self.last && rules.all(|(rule, record)| rule.is_done(record))
    }

    fn come(&self, before: Option<&[State]>, steps: &[Step], past: Past) -> Option<Past> {
        let mut past = past;
        let (mut records, mut nothing) = (past.records.iter_mut(), Record::None);
        for rule in &self.rules {
            let record = records.next().unwrap_or(&mut nothing);
            if !rule.come(before, steps, past.time, record) {
                return None;
            }
        }
        Some(past)
    }
}

impl<'a> Watched<'a> {
    /// `None` where it binds none of the agents, or a precedence not both of its own.
    fn of(
        instance: &'a Instance,
        rule: &InForce<'a>,
        place: &dyn Fn(usize) -> Option<usize>,
    ) -> Option<Self> {
        let kind = &rule.constraint.kind;
        let bound = rule.agents.iter();
        let bound: Vec<(usize, usize)> = bound
            .filter_map(|&agent| Some((agent, place(agent)?)))
            .collect();
        let all = instance.agents();
        let heading = |&(agent, _): &(usize, usize)| all.get(agent).and_then(|it| it.heading);
        let number = |name: &str| place(all.iter().position(|agent| agent.name == name)?);
        let pair = match kind {
            ConstraintKind::Before { first, second } => {
                Some((number(&first.agent)?, number(&second.agent)?))
            }
            ConstraintKind::Capacity { .. }
            | ConstraintKind::Closed { .. }
            | ConstraintKind::OneWay { .. }
            | ConstraintKind::Gap { .. }
            | ConstraintKind::Apart { .. }
            | ConstraintKind::Sequence { .. }
            | ConstraintKind::Visit { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Late { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::NoWaiting { .. }
            | ConstraintKind::Turns { .. }
            | ConstraintKind::Avoid { .. } => None,
        };
        let zone = match kind {
            ConstraintKind::Capacity { zone, .. }
            | ConstraintKind::Closed { zone, .. }
            | ConstraintKind::NoWaiting { zone, .. }
            | ConstraintKind::Avoid { zone, .. } => instance.zone(zone),
            ConstraintKind::OneWay { .. }
            | ConstraintKind::Gap { .. }
            | ConstraintKind::Apart { .. }
            | ConstraintKind::Sequence { .. }
            | ConstraintKind::Visit { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Late { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::Before { .. }
            | ConstraintKind::Turns { .. } => None,
        };
        (!bound.is_empty()).then(|| Self {
            kind,
            area: zone.map(Zone::cell_set).unwrap_or_default(),
            headings: bound.iter().map(heading).collect(),
            agents: bound.iter().map(|&(_, place)| place).collect(),
            pair,
        })
    }

    /// The record of nothing that has happened.
    fn begin(&self) -> Record {
        let zeros = || Record::Counts(vec![0; self.agents.len()]);
        match self.kind {
            ConstraintKind::Gap { .. } => Record::Visitors(BTreeMap::new()),
            ConstraintKind::Before { .. } => Record::Been(false),
            ConstraintKind::Turns { .. } => {
                let headings = self.headings.iter();
                Record::Facing(headings.map(|&heading| (heading, 0)).collect())
            }
            ConstraintKind::Sequence { .. }
            | ConstraintKind::Visit { .. }
            | ConstraintKind::NoWaiting { .. } => zeros(),
            ConstraintKind::Capacity { .. }
            | ConstraintKind::Closed { .. }
            | ConstraintKind::OneWay { .. }
            | ConstraintKind::Apart { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Late { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::Avoid { .. } => Record::None,
        }
    }

    /// Whether an agent is in the zone.
    fn is_inside(&self, state: State) -> bool {
        let mut touches = Lone::touches(state);
        touches.any(|cell| self.area.contains(&cell))
    }
}

/// The times that a rule names.
fn named_times(kind: &ConstraintKind) -> Vec<u32> {
    let of = |times: Times| {
        let times = meant(times);
        times.from.into_iter().chain(times.to).collect()
    };
    match kind {
        ConstraintKind::Capacity { times, .. }
        | ConstraintKind::Closed { times, .. }
        | ConstraintKind::Apart { times, .. }
        | ConstraintKind::Visit { times, .. }
        | ConstraintKind::Arrive { times } => of(*times),
        ConstraintKind::Depart { from } => vec![*from],
        ConstraintKind::Late { by, .. } => vec![*by],
        ConstraintKind::OneWay { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Turns { .. }
        | ConstraintKind::Avoid { .. } => Vec::new(),
    }
}
