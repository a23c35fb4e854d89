//! The order in sentences.

use giveway_model::words::and;
use giveway_model::{Cell, tr};

use crate::{Lateness, Link, Loss, NoOrder, Order, Outcome, Rotation, Shift};

/// At most so many of a kind are told in a text.
const MOST_TOLD: usize = 6;

/// How many links there are.
pub fn links(order: &Order) -> String {
    if order.links.is_empty() {
        return tr!("No robot comes to a cell after another one: each can go on its own.")
            .to_owned();
    }
    tr!(
        "{n} time a robot comes to a cell after another one: it begins to come no earlier than the other one begins to leave."
            | "{n} times a robot comes to a cell after another one: it begins to come no earlier than the other one begins to leave."
                % order.links.len() as u32
    )
}

/// How many links have no slack, and what that means for robots that do not follow in one
/// step; nothing where there are none.
pub fn without_slack(order: &Order) -> Option<String> {
    let n = order.without_slack() as u32;
    if n == 0 {
        return None;
    }
    let gap = if order.has_slow_moves() { 2_u32 } else { 1 };
    Some(tr!(
        "{n} link has no slack: one robot follows the other in the same step. Robots that enter a cell only once it is free lose a step there; under the rule \"gap\" {gap} a plan has no such link."
            | "{n} links have no slack: one robot follows the other in the same step. Robots that enter a cell only once it is free lose a step at each; under the rule \"gap\" {gap} a plan has no such links."
                % n,
        gap
    ))
}

/// A link: `A4 before A1 at (4, 2): begins to leave at 4, the other to come at 5, slack 1`.
pub fn link(link: &Link) -> String {
    tr!(
        "{first} before {second} at {cell}: begins to leave at {leaves}, the other to come at {comes}, slack {slack}",
        first = link.first.agent,
        second = link.second.agent,
        cell = link.cell,
        leaves = link.first.time,
        comes = link.second.time,
        slack = link.slack
    )
}

/// A rotation.
pub fn rotation(rotation: &Rotation) -> String {
    let moves = rotation.moves.iter();
    let moves: Vec<String> = moves.map(|it| going(&it.agent, it.cell)).collect();
    tr!(
        "At {time} robots rotate, each into the cell that the next one leaves: {moves}. They go together, in one step.",
        time = rotation.time,
        moves = and(&moves)
    )
}

fn going(agent: &str, cell: Cell) -> String {
    tr!("{agent} to {cell}", agent, cell)
}

/// A move that begins later than in the plan.
pub fn shift(shift: &Shift) -> String {
    tr!(
        "{agent} begins its move to {cell} at {begins}, not at {planned} as in the plan.",
        agent = shift.agent,
        cell = shift.cell,
        begins = shift.begins,
        planned = shift.planned
    )
}

/// Why moves begin later than in the plan.
fn why_later() -> &'static str {
    tr!(
        "A slow move may begin a step before its end is left; no order alone makes that safe, so that robot begins a step later."
    )
}

/// Why there is no order.
pub fn no_order(none: &NoOrder) -> String {
    let moves = none.moves.iter();
    let moves: Vec<String> = moves.map(|it| going(&it.agent, it.cell)).collect();
    tr!(
        "No order alone keeps this plan safe: a slow move begins a step before its end is left. Begun a step later, these moves would wait for each other: {moves}.",
        moves = and(&moves)
    )
}

/// What the order does not keep by itself.
pub fn loss(loss: &Loss) -> String {
    match loss {
        Loss::Rule { text, .. } => tr!(
            "The order alone does not keep this rule when robots are late: {text}",
            text
        ),
        Loss::Battery { agent, spare } => tr!(
            "The battery of {agent} bears {n} step of lateness."
                | "The battery of {agent} bears {n} steps of lateness." % *spare,
            agent
        ),
        Loss::Changes { last } => tr!(
            "The world changes at its own time, up to {last}: a late robot may meet another world.",
            last
        ),
        Loss::MovingObstacles => {
            tr!("Obstacles that move keep their own times: a late robot may meet one.").to_owned()
        }
    }
}

/// All that the order does not keep by itself; batteries in one sentence, the weakest first.
pub fn losses(losses: &[Loss]) -> Vec<String> {
    let mut batteries: Vec<(&str, u32)> = Vec::new();
    let mut sentences = Vec::new();
    for it in losses {
        match it {
            Loss::Battery { agent, spare } => batteries.push((agent, *spare)),
            Loss::Rule { .. } | Loss::Changes { .. } | Loss::MovingObstacles => {
                sentences.push(loss(it));
            }
        }
    }
    if let [(agent, spare)] = batteries.as_slice() {
        sentences.push(loss(&Loss::Battery {
            agent: (*agent).to_owned(),
            spare: *spare,
        }));
    } else if !batteries.is_empty() {
        giveway_model::sorting::sort_by_key(&mut batteries, |&(_, spare)| spare);
        let named = batteries
            .iter()
            .map(|(agent, spare)| format!("{agent} {spare}"));
        sentences.push(tr!(
            "Batteries bear so many steps of lateness: {named}.",
            named = few(named.collect())
        ));
    }
    sentences
}

/// The first of some names, and how many others there are.
fn few(mut named: Vec<String>) -> String {
    let more = named.len().saturating_sub(MOST_TOLD);
    if more > 1 {
        named.truncate(MOST_TOLD);
        named.push(tr!("robots" => "{n} other" | "{n} others" % more as u32));
    }
    and(&named)
}

/// Who comes late.
pub fn lateness(late: &Lateness) -> String {
    tr!(
        "{agent} comes {n} step late to {cell}"
            | "{agent} comes {n} steps late to {cell}" % late.steps,
        agent = late.agent,
        cell = late.cell
    )
}

/// What follows if robots come late: who is pushed, when the last one arrives, what breaks.
pub fn outcome(outcome: &Outcome) -> Vec<String> {
    let mut sentences = vec![pushed(outcome)];
    sentences.extend(last_arrival(outcome));
    let broken = outcome.violations.iter().map(|it| it.message.as_str());
    let broken = broken.chain(outcome.refused.iter().map(String::as_str));
    sentences.extend(
        broken
            .take(MOST_TOLD)
            .map(|message| tr!("This does not go well then: {message}", message)),
    );
    sentences
}

/// Who is pushed if robots come late, with the most steps first.
pub fn pushed(outcome: &Outcome) -> String {
    let late: Vec<String> = outcome.late.iter().map(lateness).collect();
    let mut pushed: Vec<(&str, u32)> = Vec::new();
    for it in outcome.pushed() {
        pushed.push((&it.agent, it.most));
    }
    giveway_model::sorting::sort_by_key(&mut pushed, |&(_, most)| std::cmp::Reverse(most));
    let count = pushed.len() as u32;
    let named = pushed.iter().map(|(agent, most)| {
        tr!(
            "{agent} by {n} step" | "{agent} by {n} steps" % *most,
            agent
        )
    });
    let named = few(named.collect());
    let late = and(&late);
    if count == 0 {
        tr!("If {late}, no other robot is pushed.", late)
    } else {
        tr!(
            "If {late}, {n} robot is pushed: {named}."
                | "If {late}, {n} robots are pushed: {named}." % count,
            late,
            named
        )
    }
}

/// When the last robot arrives if robots come late; nothing where none does.
pub fn last_arrival(outcome: &Outcome) -> Option<String> {
    let planned = outcome.arrivals.iter().map(|it| it.planned).max()?;
    let now = outcome.arrivals.iter().filter_map(|it| it.now).max()?;
    Some(if planned == now {
        tr!("The last robot arrives at {now}, as planned.", now)
    } else {
        tr!(
            "The last robot arrives at {now}, not at {planned}.",
            now,
            planned
        )
    })
}

/// All that is to be said of an order: links, rotations, moves that begin later.
pub fn all(order: &Order) -> Vec<String> {
    let mut sentences = vec![links(order)];
    sentences.extend(without_slack(order));
    sentences.extend(order.rotations.iter().take(MOST_TOLD).map(rotation));
    let more = order.rotations.len().saturating_sub(MOST_TOLD);
    if more > 0 {
        sentences.push(tr!(
            "{n} more rotation." | "{n} more rotations." % more as u32
        ));
    }
    sentences.extend(later(order));
    sentences
}

/// The moves that begin later than in the plan, and why; nothing where there are none.
pub fn later(order: &Order) -> Vec<String> {
    if order.later.is_empty() {
        return Vec::new();
    }
    let mut sentences = vec![why_later().to_owned()];
    sentences.extend(order.later.iter().take(MOST_TOLD).map(shift));
    let more = order.later.len().saturating_sub(MOST_TOLD);
    if more > 0 {
        sentences.push(tr!(
            "{n} more move begins later." | "{n} more moves begin later." % more as u32
        ));
    }
    sentences
}

/// What way-points and orders are in, where the scene has no units.
pub fn no_units() -> String {
    tr!("The scene has no units: a cell counts as 1 m, a step as 1 s.").to_owned()
}
