//! One agent: its states, and where it is in them.

use std::collections::BTreeSet;

use super::scene::{Kind, OracleRule, RuleScene, Spot};

/// Where an agent is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Where {
    /// At a cell.
    At(Spot),
    /// In transit.
    On(Spot, Spot),
    /// Arrived, at its goal.
    Home,
    /// Arrived, and vanished.
    Gone,
}

/// An agent at one time, with what its rules need to remember.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Mind {
    pub(super) place: Where,
    pub(super) level: Option<i64>,
    pub(super) seen: BTreeSet<Spot>,
    /// Of each of its sequences, how many cells are done.
    pub(super) done: Vec<usize>,
    /// Of each of its visits, for how many times on end it has been there; one more than the
    /// stay: made.
    pub(super) stays: Vec<i64>,
    /// Of each rule about waits, how many it has just made, as far as the rule asks.
    pub(super) waited: Vec<i64>,
    /// Wait steps since its last move, as far as turns ask.
    pub(super) stood: i64,
    pub(super) facing: Option<i64>,
    /// How long it is still broken down.
    pub(super) held: i64,
    /// The zones, by rule, in which it is not counted until it has left.
    pub(super) uncounted: BTreeSet<usize>,
    /// How far it has come on the path that it is held to.
    pub(super) progress: usize,
    /// Its cells 1, 2, ... steps ago, as far as a gap asks.
    pub(super) past: Vec<Option<Spot>>,
}

impl Mind {
    /// An agent that has arrived where it is.
    pub(super) fn home(&self) -> Self {
        Self {
            place: Where::Home,
            level: None,
            seen: BTreeSet::new(),
            done: Vec::new(),
            stays: Vec::new(),
            waited: Vec::new(),
            stood: 0,
            facing: None,
            held: 0,
            progress: 0,
            ..self.clone()
        }
    }
}

impl RuleScene {
    pub(super) fn of(&self, agent: usize) -> impl Iterator<Item = &OracleRule> {
        self.numbered(agent).map(|(_, rule)| rule)
    }

    /// The rules of an agent with their numbers.
    pub(super) fn numbered(&self, agent: usize) -> impl Iterator<Item = (usize, &OracleRule)> {
        let rules = self.rules.iter().enumerate();
        rules.filter(move |(_, rule)| rule.agents.contains(&agent))
    }

    /// The cell that it is at.
    pub(super) fn cell(&self, agent: usize, mind: &Mind) -> Option<Spot> {
        match mind.place {
            Where::At(spot) => Some(spot),
            Where::Home => Some(self.agents[agent].goal),
            Where::On(..) | Where::Gone => None,
        }
    }

    /// The cells that count for zones and distances.
    pub(super) fn touches(&self, agent: usize, mind: &Mind) -> Vec<Spot> {
        match mind.place {
            Where::On(from, to) => vec![from, to],
            _ => self.cell(agent, mind).into_iter().collect(),
        }
    }

    pub(super) fn is_in(&self, zone: &BTreeSet<Spot>, agent: usize, mind: &Mind) -> bool {
        self.touches(agent, mind)
            .iter()
            .any(|spot| zone.contains(spot))
    }

    /// What an agent on its way pays for a time.
    pub(super) fn penalty(&self, agent: usize, mind: &Mind, time: i64) -> i64 {
        let rules = self.of(agent).map(|rule| match &rule.kind {
            Kind::Avoid(zone, weight) if self.is_in(zone, agent, mind) => *weight,
            Kind::Late(weight) if time >= rule.from => *weight,
            _ => 0,
        });
        rules.sum()
    }

    pub(super) fn begin(&self, agent: usize) -> Vec<Mind> {
        self.be_there(agent, self.fresh(agent), 0, true)
    }

    /// An agent at its start that has done nothing yet.
    pub(super) fn fresh(&self, agent: usize) -> Mind {
        let task = &self.agents[agent];
        let count = |is: fn(&Kind) -> bool| self.of(agent).filter(|rule| is(&rule.kind)).count();
        let gaps = self.of(agent).map(|rule| match rule.kind {
            Kind::Gap(steps) => steps,
            _ => 0,
        });
        let turns = count(|kind| matches!(kind, Kind::Turns(_))) > 0;
        Mind {
            place: Where::At(task.start),
            level: task.battery.map(|(_, level)| level),
            seen: BTreeSet::new(),
            done: vec![0; count(|kind| matches!(kind, Kind::Sequence(_)))],
            stays: vec![0; count(|kind| matches!(kind, Kind::Visit(..)))],
            waited: vec![0; count(|kind| matches!(kind, Kind::NoWaiting(..)))],
            stood: 0,
            facing: task.heading.filter(|_| turns),
            held: 0,
            uncounted: BTreeSet::new(),
            progress: 0,
            past: vec![None; gaps.max().unwrap_or(0)],
        }
    }
}
