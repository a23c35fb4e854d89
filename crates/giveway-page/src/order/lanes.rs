//! The lanes in the order at a cell: when each robot is in it, and the links from lane to lane.

use giveway_model::tr;

use super::crossing::{Pass, Step, between, index, passes};
use super::late::outcome;
use crate::State;

/// When a robot is in the cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stay {
    /// The lane, from 0.
    pub lane: usize,
    /// The robot's index.
    pub agent: Option<usize>,
    /// The first time at which it is there.
    pub from: u32,
    /// The first time at which it is not any longer; `None` where it stays.
    pub to: Option<u32>,
}

/// From the robot that leaves to the one that comes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LaneLink {
    /// The lane and the time at which the first is out.
    pub from: (usize, u32),
    /// The lane and the time at which the second is there.
    pub to: (usize, u32),
    /// `no slack`, `slack 2`.
    pub text: String,
    /// Whether one follows the other in the same step.
    pub is_tight: bool,
}

/// What is drawn over the lanes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LaneOrder {
    /// When robots are in the cell.
    pub stays: Vec<Stay>,
    /// The links.
    pub links: Vec<LaneLink>,
    /// The planned arrivals of robots that are late: the lane and the time.
    pub planned: Vec<(usize, u32)>,
    /// All of it for who does not see it.
    pub aloud: String,
}

/// The names of the robots in the order of their lanes: who passes the cell, in order, then
/// the others. `None` where the order is not shown.
pub fn lanes(state: &State) -> Option<Vec<String>> {
    let passes = passes(state, state.order_cell()?);
    let mut names: Vec<String> = Vec::new();
    for pass in passes {
        if !names.contains(&pass.name) {
            names.push(pass.name);
        }
    }
    let answer = state.document.fresh_answer()?;
    for agent in answer.agents() {
        if !names.contains(&agent.name) {
            names.push(agent.name.clone());
        }
    }
    Some(names)
}

/// What is drawn over the lanes; `None` where the order is not shown.
pub fn lane_order(state: &State) -> Option<LaneOrder> {
    let cell = state.order_cell()?;
    let names = lanes(state)?;
    let lane = |name: &str| names.iter().position(|it| it == name);
    let passes = passes(state, cell);
    let mut drawn = LaneOrder::default();
    for pass in &passes {
        drawn.stays.extend(lane(&pass.name).map(|lane| Stay {
            lane,
            agent: index(state, &pass.name),
            from: pass.arrives,
            to: out(pass),
        }));
    }
    let mut aloud = Vec::new();
    for (first, second) in passes.iter().zip(passes.iter().skip(1)) {
        let Some(step) = between(state, cell, first, second) else {
            continue;
        };
        aloud.push(link_aloud(cell, first, second, &step));
        if let (Some(a), Some(b), Some(out)) = (lane(&first.name), lane(&second.name), out(first)) {
            drawn.links.push(LaneLink {
                from: (a, out),
                to: (b, second.arrives),
                text: slack_words(&step),
                is_tight: step.is_tight,
            });
        }
    }
    drawn.aloud = aloud.join("; ");
    if let Some(late) = outcome(state) {
        let arrivals = late.outcome.arrivals.iter();
        let late = arrivals.filter(|it| it.now != Some(it.planned));
        drawn
            .planned
            .extend(late.filter_map(|it| Some((lane(&it.agent)?, it.planned))));
    }
    Some(drawn)
}

/// The first time at which a robot is out of the cell.
pub(super) fn out(pass: &Pass) -> Option<u32> {
    pass.leaves.map(|leaves| leaves + 1)
}

fn slack_words(step: &Step) -> String {
    match step.slack {
        0 => tr!("no slack").to_owned(),
        slack => tr!("slack {slack}", slack),
    }
}

/// `A4 before A1 at (4, 2): out at 5, comes at 6, slack 1`.
pub(super) fn link_aloud(
    cell: giveway_model::Cell,
    first: &Pass,
    second: &Pass,
    step: &Step,
) -> String {
    tr!(
        "{first} before {second} at {cell}: out at {out}, comes at {comes}, slack {slack}",
        first = first.name,
        second = second.name,
        cell,
        out = out(first).map_or_else(String::new, |out| out.to_string()),
        comes = second.arrives,
        slack = step.slack
    )
}

/// What stands below a robot's name in its lane while the late plan is on the board.
pub fn fate(state: &State, name: &str) -> Option<String> {
    let late = outcome(state)?;
    let arrival = late.outcome.arrivals.iter().find(|it| it.agent == name)?;
    let now = arrival.now?;
    Some(match now.saturating_sub(arrival.planned) {
        0 => tr!("arrives at {now}", now),
        late => tr!("arrives at {now}, {late} late", now, late),
    })
}
