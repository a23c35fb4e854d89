//! Questions about an agent: this moment, and its way as a whole.

use giveway_model::{Cell, Question, tr};

use super::{About, Group, Offer};
use crate::Answer;
use crate::timeline::{Lane, Step, Way};
use giveway_model::sorting::sort;

/// The most orders of waypoints that are offered.
const ORDERS: usize = 2;

pub(super) fn groups(answer: &Answer, agent: usize, time: u32) -> Vec<Group> {
    let Some(lane) = Lane::of(answer, agent) else {
        return Vec::new();
    };
    vec![
        Group {
            title: tr!("Ask about this moment").to_owned(),
            offers: moment(answer, &lane, time),
            about: About::Moment,
        },
        Group {
            title: tr!("Ask about {name}", name = lane.name),
            offers: whole(answer, &lane),
            about: About::Selected,
        },
    ]
}

fn moment(answer: &Answer, lane: &Lane, time: u32) -> Vec<Offer> {
    let mut offers = Vec::new();
    let Some(step) = lane.step_at(time) else {
        return offers;
    };
    let agent = || lane.name.clone();
    if step.way.stays() {
        let (from, to) = whole_wait(lane, step);
        // What came before the last change is settled.
        let from = from.max(answer.changed_last().unwrap_or(0));
        let wait = Question::Wait {
            agent: agent(),
            at: Some(step.from),
            from: Some(from),
            to: Some(to),
            at_least: None,
        };
        // Most waits can be made elsewhere: whom it lets pass tells more.
        offers.extend(gives_way(answer, lane, step));
        offers.push(Offer::new("pause", wait).with(tr!("from time {from} to {to}", from, to)));
    }
    if lane.charges.contains(&time) {
        let charge = Question::Charge {
            agent: agent(),
            at: Some(step.from),
            time: Some(time),
        };
        let left = lane.level_at(time).unwrap_or_default();
        offers.push(Offer::new("charger", charge).with(tr!("with {left} left", left)));
    }
    if !step.way.stays() {
        let go = Question::Move {
            agent: agent(),
            from_cell: step.from,
            to_cell: step.to,
            time: Some(step.begins),
        };
        offers.push(Offer::new("question", go));
    }
    if step.way == Way::Slow {
        let slow = Question::Slow {
            agent: agent(),
            from_cell: Some(step.from),
            to_cell: Some(step.to),
        };
        offers.push(Offer::new("slow", slow));
    }
    offers
}

/// The wait that a step is part of: its first and its last time.
fn whole_wait(lane: &Lane, step: &Step) -> (u32, u32) {
    let is_same = |other: &&Step| other.way.stays() && other.from == step.from;
    let after = lane.steps.iter().filter(|s| s.begins >= step.begins);
    let to = after
        .take_while(is_same)
        .last()
        .map_or(step.ends, |s| s.ends);
    let before = lane.steps.iter().rev().filter(|s| s.begins <= step.begins);
    let from = before.take_while(is_same).last();
    (from.map_or(step.begins, |s| s.begins), to)
}

/// Whether the agent waits for another to pass the cell that it goes to next. It is asked of the far
/// end of the stretch that both use: nearer, it could drive in and back, and nothing would be said.
/// Not offered where the other agent was there before the wait began: who goes first was decided then.
fn gives_way(answer: &Answer, lane: &Lane, step: &Step) -> Option<Offer> {
    let mut further = lane.steps.iter();
    let mut further = further
        .by_ref()
        .skip_while(|s| s.begins < step.begins || s.way.stays());
    let next = further.next()?;
    let others = (0..answer.draft.agents().len()).filter(|&other| other != lane.agent);
    // Who was there last before the agent comes.
    let (_, other) = others
        .filter_map(|other| {
            let other = Lane::of(answer, other)?;
            let leaves = leaves_before(&other, next)?;
            (leaves >= step.begins).then_some((leaves, other))
        })
        .max_by_key(|(leaves, _)| *leaves)?;
    let shared = further.filter(|s| !s.way.stays());
    let far = far_end(next, shared, &other);
    let (from, _) = whole_wait(lane, step);
    if comes_first(&other, far.to) < Some(from) {
        return None;
    }
    let question = Question::Yield {
        agent: lane.name.clone(),
        to: other.name,
        at: far.to,
    };
    Some(Offer::new("question", question))
}

/// The last step along the cells of another agent, which it passed in one direction: where the
/// agent turns round, or follows from then on, the stretch ends.
fn far_end<'a>(first: &'a Step, further: impl Iterator<Item = &'a Step>, other: &Lane) -> &'a Step {
    let mut far = first;
    let mut direction = None;
    for step in further {
        let (Some(before), Some(now)) = (leaves_before(other, far), leaves_before(other, step))
        else {
            break;
        };
        let way = now.cmp(&before);
        if *direction.get_or_insert(way) != way {
            break;
        }
        far = step;
    }
    far
}

/// When an agent is at a cell first.
fn comes_first(other: &Lane, cell: Cell) -> Option<u32> {
    let is_there = |s: &&Step| s.from == cell || s.to == cell;
    let first = other.steps.iter().find(is_there)?;
    Some(if first.from == cell {
        first.begins
    } else {
        first.ends
    })
}

/// When an agent leaves a cell last before another one comes there by a step.
fn leaves_before(other: &Lane, comes: &Step) -> Option<u32> {
    let visits = other.steps.iter().filter(|s| s.from == comes.to);
    visits.map(|s| s.begins).filter(|&t| t < comes.ends).max()
}

fn whole(answer: &Answer, lane: &Lane) -> Vec<Offer> {
    let agent = || lane.name.clone();
    let mut offers = vec![
        Offer::new("clock", Question::Arrival { agent: agent() })
            .with(tr!("it arrives at {time}", time = lane.arrival)),
    ];
    let waits = lane.waits();
    if waits > 0 {
        let waits = tr!("it waits for {waits} in all", waits);
        offers.push(
            Offer::new(
                "pause",
                Question::Waits {
                    agent: Some(agent()),
                },
            )
            .with(waits),
        );
    }
    if !lane.charges.is_empty() {
        let charges = tr!("it charges at {times}", times = list(&lane.charges));
        let ask = Question::Charges {
            agent: Some(agent()),
        };
        offers.push(Offer::new("charger", ask).with(charges));
    }
    offers.extend(orders(answer, lane));
    if lane.steps.iter().any(|step| step.way == Way::Slow) {
        let slow = Question::Slow {
            agent: agent(),
            from_cell: None,
            to_cell: None,
        };
        offers.push(Offer::new("slow", slow));
    }
    let length = Question::Length {
        agent: agent(),
        fewer_than: None,
    };
    offers.push(Offer::new("trail", length).with(tr!(
        "it makes {n} move" | "it makes {n} moves" % lane.moves()
    )));
    offers
}

/// Waypoints that are visited one after the other.
fn orders(answer: &Answer, lane: &Lane) -> Vec<Offer> {
    let Some(who) = answer.draft.agents().get(lane.agent) else {
        return Vec::new();
    };
    let first_visit = |cell: Cell| {
        let entry = (lane.entry == cell).then_some(lane.begins);
        let steps = lane.steps.iter().filter(|step| step.to == cell);
        entry.into_iter().chain(steps.map(|step| step.ends)).min()
    };
    let mut visits: Vec<(u32, Cell)> = who
        .waypoints
        .iter()
        .filter_map(|&cell| Some((first_visit(cell)?, cell)))
        .collect();
    sort(&mut visits);
    let pairs = visits.windows(2).take(ORDERS);
    pairs
        .map(|pair| {
            let order = Question::Order {
                agent: lane.name.clone(),
                first: pair[0].1,
                second: pair[1].1,
            };
            Offer::new("waypoint", order)
        })
        .collect()
}

fn list(times: &[u32]) -> String {
    let times: Vec<String> = times.iter().map(u32::to_string).collect();
    match times.as_slice() {
        [init @ .., last] if !init.is_empty() => {
            tr!("list" => "{list} and {last}", list = init.join(", "), last)
        }
        times => times.concat(),
    }
}
