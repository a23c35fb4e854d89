//! The steps of the proof as rows of a list.

use std::collections::BTreeMap;
use std::ops::Range;

use giveway_model::{Cost, Costs, Objective, tr};
use giveway_solve::trace::{SearchEvent, SearchTrace, TraceEvent, words};

use super::{chosen, steps, trace};
use crate::State;

/// What a row is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The bound rises.
    Bound,
    /// A better plan.
    Plan,
    /// Something else.
    Aside,
    /// The next cost begins.
    Head,
    /// The end.
    End,
    /// The search was cut off.
    Stopped,
}

/// A step as a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProofRow {
    /// Its number.
    pub number: usize,
    /// What it says.
    pub text: String,
    /// What kind of step it is.
    pub kind: Kind,
    /// What stands at its end: words, and a figure.
    pub figure: Option<(&'static str, String)>,
    /// Whether it is the one that is chosen.
    pub is_chosen: bool,
}

/// What is known after a step.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Known {
    /// The cost that is bounded.
    pub(super) cost: Cost,
    /// Its bound.
    pub(super) bound: Option<u32>,
    /// Its value in the best plan.
    pub(super) best: Option<u32>,
}

/// What is known after each step.
pub(super) fn known(trace: &SearchTrace) -> Vec<Known> {
    let mut cost = trace
        .objective
        .costs()
        .first()
        .copied()
        .unwrap_or(Cost::Makespan);
    let mut bounds: BTreeMap<Cost, u32> = BTreeMap::new();
    let mut best: Option<Costs> = None;
    let rise = |bounds: &mut BTreeMap<Cost, u32>, cost: Cost, to: u32| {
        let bound = bounds.entry(cost).or_insert(to);
        *bound = to.max(*bound);
    };
    let after = |event: &TraceEvent| {
        match &event.event {
            SearchEvent::Alone { cost, at_least, .. }
            | SearchEvent::Counted { cost, at_least, .. } => rise(&mut bounds, *cost, *at_least),
            SearchEvent::Plan { costs, .. } => best = Some(*costs),
            SearchEvent::Phase { cost: next, .. } => cost = *next,
            SearchEvent::Core(core) => rise(&mut bounds, core.cost, core.to),
            SearchEvent::Closed { cost, to, .. } => rise(&mut bounds, *cost, *to),
            SearchEvent::Exhausted { bounds: least } | SearchEvent::Met { costs: least, .. } => {
                for (&cost, &to) in least {
                    rise(&mut bounds, cost, to);
                }
            }
            _ => {}
        }
        Known {
            cost,
            bound: bounds.get(&cost).copied(),
            best: best.map(|best| best.get(cost)),
        }
    };
    steps(trace).map(after).collect()
}

/// The rows in a range of all; and how many there are.
pub fn rows(state: &State, range: &Range<usize>) -> (Vec<ProofRow>, usize) {
    let Some(trace) = trace(state) else {
        return (Vec::new(), 0);
    };
    let Some((at, last)) = chosen(state) else {
        return (Vec::new(), 0);
    };
    let shown = steps(trace).enumerate().skip(range.start).take(range.len());
    let row = |(number, event): (usize, &TraceEvent)| ProofRow {
        number,
        text: text(&trace.objective, event),
        kind: kind(trace, &event.event),
        figure: figure(trace, &event.event),
        is_chosen: number == at,
    };
    (shown.map(row).collect(), last + 1)
}

/// What a step says, without what stands beside it as a figure. The record has its text
/// in the language of the solver at that time; here it is said anew.
pub(super) fn text(objective: &Objective, event: &TraceEvent) -> String {
    let said = match &event.event {
        SearchEvent::Core(core) => words::claim(core),
        _ => words::sentence(objective, &event.event),
    };
    let said = said.trim_end_matches('.');
    let short = match (&event.event, said.split_once(": ")) {
        (
            SearchEvent::Alone { .. } | SearchEvent::Counted { .. } | SearchEvent::Plan { .. },
            Some((short, _)),
        ) => short,
        _ => said,
    };
    match words::rests_on(&event.rules) {
        Some(rests) => format!("{short}. {}", rests.trim_end_matches('.')),
        None => short.to_owned(),
    }
}

fn kind(trace: &SearchTrace, event: &SearchEvent) -> Kind {
    match event {
        SearchEvent::Alone { .. }
        | SearchEvent::Core(_)
        | SearchEvent::Closed { .. }
        | SearchEvent::Counted { .. }
        | SearchEvent::Exhausted { .. } => Kind::Bound,
        SearchEvent::Plan { .. } => Kind::Plan,
        SearchEvent::Phase { .. } => Kind::Head,
        SearchEvent::Met { costs, .. } if costs.len() < trace.objective.costs().len() => {
            Kind::Bound
        }
        SearchEvent::Met { .. } | SearchEvent::Impossible(_) => Kind::End,
        SearchEvent::Stopped(_) => Kind::Stopped,
        _ => Kind::Aside,
    }
}

fn figure(trace: &SearchTrace, event: &SearchEvent) -> Option<(&'static str, String)> {
    let at_least = |n: u32| Some((tr!("at least"), n.to_string()));
    match event {
        SearchEvent::Alone { at_least: n, .. } | SearchEvent::Counted { at_least: n, .. } => {
            at_least(*n)
        }
        SearchEvent::Core(core) => at_least(core.to),
        SearchEvent::Closed { to, .. } => at_least(*to),
        SearchEvent::Plan { costs, .. } => {
            let values = trace
                .objective
                .costs()
                .iter()
                .map(|&cost| costs.get(cost).to_string());
            Some((
                tr!("before its costs" => "plan"),
                values.collect::<Vec<String>>().join(", "),
            ))
        }
        SearchEvent::Met { costs, .. } => {
            let objective = trace.objective.costs().iter();
            let values = objective
                .filter_map(|cost| costs.get(cost))
                .map(ToString::to_string);
            Some(("", values.collect::<Vec<String>>().join(", ")))
        }
        _ => None,
    }
}
