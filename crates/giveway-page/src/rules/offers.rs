//! The rules that fit what is selected, as they begin to be written.

use giveway_model::condition::{Times, Visit};
use giveway_model::{Cell, Constraint, constraint::ConstraintKind};

use super::Lit;
use crate::{Selection, State};

/// A rule for all robots.
fn rule(kind: ConstraintKind) -> Constraint {
    Constraint {
        kind,
        agents: None,
        name: None,
        off: false,
    }
}

/// The rules of a zone, the usual one first.
pub(crate) fn of_zone(zone: &str) -> Vec<Constraint> {
    let (zone, times) = (|| zone.to_owned(), Times::default());
    let capacity = ConstraintKind::Capacity {
        zone: zone(),
        most: 1,
        times,
    };
    let closed = ConstraintKind::Closed {
        zone: zone(),
        times,
    };
    let no_waiting = ConstraintKind::NoWaiting {
        zone: zone(),
        most: 0,
    };
    let avoid = ConstraintKind::Avoid {
        zone: zone(),
        weight: 1,
    };
    [capacity, closed, no_waiting, avoid].map(rule).into()
}

/// The rules that fit what is selected.
pub(crate) fn offered(state: &State) -> Vec<Constraint> {
    match state.view.selection {
        Selection::Agent(agent) => of_agent(state, agent),
        Selection::Cell(cell) => of_cell(state, cell),
        Selection::Nothing => {
            // While the world changes no zone is marked: the ones that are there have rules.
            let changes = state.document.mode.changing().is_some();
            let zones = &state.document.draft.scene().zones;
            let zone = zones.first().filter(|_| changes);
            let of_zone = zone.map(|zone| of_zone(&zone.name)).unwrap_or_default();
            of_zone.into_iter().chain(without_place()).collect()
        }
    }
}

/// Rules of all kinds for a question: of what is selected or lit first, then of the first zone
/// and the first robot.
pub(crate) fn every(state: &State) -> Vec<Constraint> {
    let zones = &state.document.draft.scene().zones;
    let lit = match state.lit_rule() {
        Some(Lit::Zone(name)) => zones.iter().find(|zone| zone.name == *name),
        Some(Lit::Rule(_)) | None => None,
    };
    let of_zone = lit.or(zones.first()).map(|zone| of_zone(&zone.name));
    let of_zone = of_zone.into_iter().flatten();
    let mut rules: Vec<Constraint> = match state.view.selection {
        Selection::Nothing => of_zone.collect(),
        Selection::Agent(_) | Selection::Cell(_) => {
            offered(state).into_iter().chain(of_zone).collect()
        }
    };
    rules.extend(of_agent(state, 0));
    rules.extend(without_place());
    let mut kinds: Vec<&str> = Vec::new();
    let mut kept = Vec::new();
    for rule in &rules {
        if !kinds.contains(&rule.kind_name()) {
            kinds.push(rule.kind_name());
            kept.push(rule.clone());
        }
    }
    kept
}

/// The rules that are about no place and no single robot.
fn without_place() -> Vec<Constraint> {
    let apart = ConstraintKind::Apart {
        distance: 2,
        times: Times::default(),
    };
    [
        ConstraintKind::Gap { steps: 1 },
        apart,
        ConstraintKind::Turns { quarter: 1 },
    ]
    .map(rule)
    .into()
}

fn of_agent(state: &State, agent: usize) -> Vec<Constraint> {
    let agents = state.document.agents();
    let Some(who) = agents.get(agent) else {
        return without_place();
    };
    let answer = state.document.fresh_answer();
    let arrival = answer.and_then(|answer| *answer.arrivals.get(agent)?);
    let by = arrival.unwrap_or(10);
    let own = |kind| Constraint {
        agents: Some(vec![who.name.clone()]),
        ..rule(kind)
    };
    let arrive = ConstraintKind::Arrive {
        times: Times {
            from: None,
            to: Some(by),
        },
    };
    let mut offers = vec![
        own(arrive),
        own(ConstraintKind::Depart { from: 1 }),
        own(ConstraintKind::Late { by, weight: 1 }),
    ];
    if let Some(goal) = who.waypoints.first().copied().or(who.goal) {
        offers.push(own(ConstraintKind::Visit {
            cell: goal,
            stay: 1,
            times: Times::default(),
        }));
        if who.waypoints.len() > 1 {
            offers.push(rule(ConstraintKind::Sequence {
                agent: who.name.clone(),
                cells: who.waypoints.clone(),
            }));
        }
        let other = agents.iter().find(|other| other.name != who.name);
        if let Some(other) = other {
            offers.push(rule(ConstraintKind::Before {
                first: visit(&who.name, goal),
                second: visit(&other.name, other.goal.unwrap_or(goal)),
            }));
        }
    }
    offers
}

fn of_cell(state: &State, cell: Cell) -> Vec<Constraint> {
    let mut agents = state.document.agents().iter();
    let Some(first) = agents.next() else {
        return without_place();
    };
    let stay = Constraint {
        agents: Some(vec![first.name.clone()]),
        ..rule(ConstraintKind::Visit {
            cell,
            stay: 1,
            times: Times::default(),
        })
    };
    let before = agents.next().map(|second| {
        rule(ConstraintKind::Before {
            first: visit(&first.name, cell),
            second: visit(&second.name, cell),
        })
    });
    std::iter::once(stay).chain(before).collect()
}

fn visit(agent: &str, cell: Cell) -> Visit {
    Visit {
        agent: agent.to_owned(),
        cell,
    }
}
