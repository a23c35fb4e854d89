//! The events of a plan: each agent's moves from cell to cell, in order.

use std::collections::BTreeMap;

use giveway_model::change::{Changes, History, Trajectory, What};
use giveway_model::{Cell, Plan};

use crate::{End, rules::TurnRules};

/// The time of an event, in steps; one that begins before time 0 is negative.
pub(crate) type Time = i64;

/// An agent enters a cell, and with that leaves the one before it. The first event of an
/// agent is its appearance; where it leaves the floor, the last one is that.
#[derive(Clone, Debug)]
pub(crate) struct Event {
    /// The agent, by its number in the graph.
    pub(crate) agent: usize,
    /// The number of the visit that it comes to; of the last event one beyond.
    pub(crate) visit: usize,
    /// The cell that it enters; `None` where it leaves the floor.
    pub(crate) enters: Option<Cell>,
    /// When it begins in the plan.
    pub(crate) planned: Time,
    /// The least steps between its arrival at the cell before and this, which it turns in.
    pub(crate) stands: Time,
    /// The events that have to begin before, each by how many steps: that with which the agent
    /// before it leaves the cell, and others under a rule `gap`.
    pub(crate) after: Vec<(usize, Time)>,
    /// The event with which the cell is left before, be it by the agent itself.
    pub(crate) cell_before: Option<usize>,
}

/// The way of an agent through the plan.
#[derive(Debug)]
pub(crate) struct Way<'a> {
    pub(crate) trajectory: Trajectory<'a>,
    /// Its stays, in order.
    pub(crate) stays: Vec<Stay>,
    /// The number of its first event.
    pub(crate) first: usize,
    pub(crate) end: End,
    /// Its breakdowns: when each comes, and for how many steps.
    pub(crate) breakdowns: Vec<(Time, Time)>,
}

/// A stay at a cell, as the plan has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Stay {
    pub(crate) cell: Cell,
    /// The first time at which the agent is there.
    pub(crate) arrives: u32,
    /// The last time at which the path lists it there.
    pub(crate) leaves: u32,
}

impl Way<'_> {
    pub(crate) fn name(&self) -> &str {
        self.trajectory.timeline.name()
    }

    /// Whether it leaves the floor in the end.
    pub(crate) fn is_gone(&self) -> bool {
        match self.end {
            End::Stays => false,
            End::Vanishes | End::Removed => true,
        }
    }

    /// The time before which it is removed.
    pub(crate) fn until(&self) -> Option<u32> {
        self.trajectory.timeline.until
    }

    /// How many events it has.
    pub(crate) fn events(&self) -> usize {
        self.stays.len() + usize::from(self.is_gone())
    }
}

/// All ways of a plan, and their events without links.
pub(crate) fn ways<'a>(
    history: &'a History,
    changes: &Changes,
    plan: &'a Plan,
) -> (Vec<Way<'a>>, Vec<Event>) {
    let mut breakdowns = breakdowns(changes);
    let (mut ways, mut events) = (Vec::new(), Vec::new());
    let turns = TurnRules::of(history);
    for timeline in history.timelines() {
        let Some(trajectory) = Trajectory::of(history, timeline, plan) else {
            continue;
        };
        let mut stays = stays(&trajectory);
        let Some(last) = stays.last_mut() else {
            continue;
        };
        let end = match timeline.until {
            Some(_) => End::Removed,
            None if history.keeps(timeline) => End::Stays,
            None => End::Vanishes,
        };
        // One that is removed half way along a slow move has left its cell before.
        if end != End::Stays && trajectory.path.last().is_some_and(Option::is_some) {
            last.leaves = trajectory.end();
        }
        let gone = last.leaves;
        let agent = ways.len();
        let way = Way {
            trajectory,
            first: events.len(),
            end,
            breakdowns: breakdowns.remove(timeline.name()).unwrap_or_default(),
            stays: stays.clone(),
        };
        let event = |visit, enters, planned, stands| Event {
            agent,
            visit,
            enters,
            planned,
            stands,
            after: Vec::new(),
            cell_before: None,
        };
        if let Some(first) = stays.first() {
            let begin = Time::from(first.arrives) - 1;
            events.push(event(0, Some(first.cell), begin, 0));
        }
        let mut heading = timeline.agent.heading;
        for ((visit, from), to) in (1..).zip(&stays).zip(stays.iter().skip(1)) {
            let stands = turns.stands(timeline.name(), &mut heading, (from.cell, to.cell));
            events.push(event(visit, Some(to.cell), Time::from(from.leaves), stands));
        }
        if way.is_gone() {
            events.push(event(stays.len(), None, Time::from(gone), 0));
        }
        ways.push(way);
    }
    (ways, events)
}

/// The breakdowns by the agents' names.
fn breakdowns(changes: &Changes) -> BTreeMap<&str, Vec<(Time, Time)>> {
    let mut breakdowns: BTreeMap<&str, Vec<(Time, Time)>> = BTreeMap::new();
    for change in &changes.changes {
        if let What::DelayAgent { agent, steps } = &change.what {
            let times = (Time::from(change.at), Time::from(*steps));
            breakdowns.entry(agent).or_default().push(times);
        }
    }
    breakdowns
}

/// The stays of a trajectory.
fn stays(trajectory: &Trajectory<'_>) -> Vec<Stay> {
    let mut stays: Vec<Stay> = Vec::new();
    let mut was_there = false;
    for (time, entry) in (trajectory.timeline.from..).zip(trajectory.path) {
        match (entry, stays.last_mut()) {
            (Some(cell), Some(stay)) if was_there && stay.cell == *cell => stay.leaves = time,
            (Some(cell), _) => stays.push(Stay {
                cell: *cell,
                arrives: time,
                leaves: time,
            }),
            (None, _) => {}
        }
        was_there = entry.is_some();
    }
    stays
}
