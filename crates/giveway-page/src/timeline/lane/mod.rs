//! One agent's plan, step by step.

mod sentence;
mod stays;
#[cfg(test)]
mod tests;
mod turns;

use giveway_model::{AtGoal, Cell};

use crate::Answer;
use crate::changing::stopped;

pub use turns::Turn;

/// How an agent spends a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// A move to a neighbour.
    Move,
    /// A slow move: two time steps, in transit between.
    Slow,
    /// A wait.
    Wait,
    /// A wait in which it turns, under a rule about that.
    Turn(Turn),
    /// A wait that is part of a stay that a rule asks for.
    Stay,
    /// A wait of an agent that is broken down.
    Broken,
}

impl Way {
    /// Whether it stays on its cell.
    pub fn stays(self) -> bool {
        match self {
            Self::Move | Self::Slow => false,
            Self::Wait | Self::Turn(_) | Self::Stay | Self::Broken => true,
        }
    }
}

/// A move or a wait.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// What it is.
    pub way: Way,
    /// The time at which it begins.
    pub begins: u32,
    /// The time at which it ends.
    pub ends: u32,
    /// The cell that it leads from.
    pub from: Cell,
    /// The cell that it leads to; the same for a wait.
    pub to: Cell,
}

/// One agent's plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Lane {
    /// Its index in the scene that was solved.
    pub agent: usize,
    /// Its name.
    pub name: String,
    /// The cell at which it enters.
    pub entry: Cell,
    /// The time at which it enters.
    pub begins: u32,
    /// The time at which it arrives.
    pub arrival: u32,
    /// Whether it arrives at all: one that is removed does not, nor one that has
    /// not been led to its goal.
    pub arrives: bool,
    /// Whether it stays where it arrived.
    pub stays: bool,
    /// The time from which it is gone, where it was removed: it never arrives.
    pub removed: Option<u32>,
    /// When and where it broke down for good, where it did: it stays there.
    pub stopped: Option<(u32, Cell)>,
    /// What it does, by time, without gaps.
    pub steps: Vec<Step>,
    /// The times at which it charges.
    pub charges: Vec<u32>,
    /// The capacity of its battery, if it has one.
    pub capacity: Option<u32>,
    /// The level at each time from its entry to its arrival; empty without a
    /// battery.
    pub levels: Vec<u32>,
}

impl Lane {
    /// The plan of an agent of an answer; `None` where there is none.
    pub fn of(answer: &Answer, agent: usize) -> Option<Self> {
        let plan = answer.plan()?;
        let who = answer.agents().get(agent)?;
        let removed = answer.removed(agent);
        let stopped = removed.and_then(|_| stopped(answer, &who.name));
        let path = plan.path(&who.name);
        let begins = plan.from.get(&who.name).copied().unwrap_or(0);
        let mut stops = path
            .iter()
            .zip(begins..)
            .filter_map(|(cell, time)| cell.map(|cell| (time, cell)));
        let (_, entry) = stops.next()?;
        let breakdowns = answer.breakdowns(agent);
        let is_broken = |time: u32| {
            breakdowns
                .iter()
                .any(|&(from, to)| from <= time && time < to)
        };
        let mut steps = Vec::with_capacity(path.len());
        let (mut begin, mut from) = (begins, entry);
        for (end, to) in stops {
            let way = match (end - begin, from == to) {
                (1, true) if is_broken(begin) => Way::Broken,
                (1, true) => Way::Wait,
                (1, false) => Way::Move,
                _ => Way::Slow,
            };
            steps.push(Step {
                way,
                begins: begin,
                ends: end,
                from,
                to,
            });
            (begin, from) = (end, to);
        }
        let rules = &answer.draft.scene().constraints;
        turns::mark(&mut steps, rules, who);
        stays::mark(&mut steps, rules, who, path);
        let arrives = answer.arrivals.get(agent).copied().flatten().is_some();
        let levels = answer.levels.get(agent).map_or(&[][..], Vec::as_slice);
        Some(Self {
            agent,
            name: who.name.clone(),
            entry,
            begins,
            arrival: begin,
            arrives,
            stays: arrives && answer.draft.scene().rules.at_end_of(who) == AtGoal::Stay,
            removed,
            stopped,
            steps,
            charges: plan.charges(&who.name).to_vec(),
            capacity: who.battery.map(|battery| battery.capacity),
            levels: levels.iter().map(|&n| level(n)).collect(),
        })
    }

    /// The step that is under way at a time; `None` before the entry and from
    /// the arrival on.
    pub fn step_at(&self, time: u32) -> Option<&Step> {
        let after = self.steps.partition_point(|step| step.ends <= time);
        let step = self.steps.get(after)?;
        (step.begins <= time).then_some(step)
    }

    /// Whether a step of another plan for this agent is not so in this one: it
    /// does something else at that time, or never makes that move. A move that
    /// is made earlier or later is the same.
    pub fn differs_from(&self, step: &Step) -> bool {
        let at_once = self.step_at(step.begins);
        if at_once.is_some_and(|mine| mine.way != step.way) {
            return true;
        }
        let is_move = |mine: &Step| (mine.from, mine.to) == (step.from, step.to);
        !self.steps.iter().any(is_move)
    }

    /// Where it arrives.
    pub fn end(&self) -> Cell {
        self.steps.last().map_or(self.entry, |step| step.to)
    }

    /// The battery level at a time; from the arrival on, that of the arrival.
    pub fn level_at(&self, time: u32) -> Option<u32> {
        if self.removed.is_some_and(|until| until <= time) {
            return None;
        }
        let index = time.saturating_sub(self.begins) as usize;
        self.levels.get(index).or(self.levels.last()).copied()
    }

    /// The number of steps of a kind.
    pub fn count(&self, way: Way) -> usize {
        self.steps.iter().filter(|step| step.way == way).count()
    }

    /// The waits in which it turns.
    pub fn turns(&self) -> usize {
        let turns = |step: &&Step| matches!(step.way, Way::Turn(_));
        self.steps.iter().filter(turns).count()
    }

    /// The waits, broken down, turning or not.
    pub fn waits(&self) -> usize {
        self.steps.iter().filter(|step| step.way.stays()).count()
    }

    /// The times at which it stops: each begins waits without a move between them.
    pub fn stops(&self) -> Vec<u32> {
        let stays = |step: &Step| step.way.stays();
        let runs = self.steps.chunk_by(|one, next| stays(one) && stays(next));
        let runs = runs.filter_map(|run| run.first());
        runs.filter(|step| stays(step))
            .map(|step| step.begins)
            .collect()
    }

    /// The moves, slow or not.
    pub fn moves(&self) -> usize {
        self.steps.len() - self.waits()
    }
}

/// A level of a plan that was judged: none is below 0.
fn level(n: i64) -> u32 {
    u32::try_from(n).unwrap_or(0)
}
