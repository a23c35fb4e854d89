//! What was adopted at each time, for this browser only: a method, and costs before and
//! after.

use giveway_model::change::Changes;
use giveway_model::{Cost, Costs};
use giveway_solve::change::Method;

use crate::course::Adopted;
use crate::link::text::numbers;

/// What was adopted at each time, in a link's letters.
pub(in crate::link) fn write_steps(steps: &[Adopted]) -> String {
    let costs = |costs: Option<Costs>| {
        Cost::USUAL.map(|cost| costs.map_or(0, |c| c.get(cost).saturating_add(1)))
    };
    let one = |step: &Adopted| {
        let mut parts = vec![number(step.method)];
        parts.extend(costs(step.before));
        parts.extend(costs(step.after));
        // Those of a plan that one method alone found are left out.
        let also = step.also.into_iter().flatten();
        parts.extend(also.map(|method| number(Some(method))));
        let parts: Vec<String> = parts.iter().map(ToString::to_string).collect();
        parts.join(".")
    };
    steps.iter().map(one).collect::<Vec<_>>().join(";")
}

fn number(method: Option<Method>) -> u32 {
    match method {
        None => 0,
        Some(Method::Revise) => 1,
        Some(Method::Replan) => 2,
        Some(Method::Tunnel(width)) => width.saturating_add(3),
    }
}

const fn method(number: u32) -> Option<Method> {
    match number {
        0 => None,
        1 => Some(Method::Revise),
        2 => Some(Method::Replan),
        width => Some(Method::Tunnel(width - 3)),
    }
}

/// What was adopted at each time of the changes, as far as a text tells it.
pub(in crate::link) fn read_steps(text: &str, changes: &Changes) -> Vec<Adopted> {
    let mut told = text.split(';');
    let times = changes.by_time();
    let steps = times.iter().map(|&(at, _)| {
        let told = told.next().and_then(read_step);
        told.map_or(
            Adopted {
                at,
                method: None,
                also: [None; 2],
                before: None,
                after: None,
            },
            |step| Adopted { at, ..step },
        )
    });
    steps.collect()
}

fn read_step(text: &str) -> Option<Adopted> {
    let numbers = numbers(text)?;
    let [first, rest @ ..] = &numbers[..] else {
        return None;
    };
    let (before, rest) = rest.split_first_chunk::<5>()?;
    let (after, also) = rest.split_first_chunk::<5>()?;
    let also = |place: usize| also.get(place).copied().and_then(method);
    Some(Adopted {
        at: 0,
        method: method(*first),
        also: [also(0), also(1)],
        before: costs(before),
        after: costs(after),
    })
}

fn costs(numbers: &[u32; 5]) -> Option<Costs> {
    let [makespan, sum_of_costs, charges, moves, waits] = *numbers;
    Some(Costs {
        makespan: makespan.checked_sub(1)?,
        sum_of_costs: sum_of_costs.checked_sub(1)?,
        charges: charges.checked_sub(1)?,
        moves: moves.checked_sub(1)?,
        waits: waits.checked_sub(1)?,
        // Scenes whose rules make a penalty have no changes.
        penalty: 0,
    })
}
