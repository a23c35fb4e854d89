//! The plan in a link: a letter a step, agent by agent. `l r u d` are moves,
//! large letters slow ones, `w` waits; `c` before a step charges in it.

use crate::{Agent, Cell, Plan};

use super::text::{letters, runs};

/// The most steps of all agents together.
const STEPS: usize = 1_000_000;

/// The letter of each direction, as (column, row).
const WAYS: [(char, i32, i32); 5] = [
    ('w', 0, 0),
    ('l', -1, 0),
    ('r', 1, 0),
    ('u', 0, -1),
    ('d', 0, 1),
];

/// The path of an agent that is removed as it appears: it has no step at all.
const NOWHERE: &str = "x";

/// A plan for agents; `None` where it is of a kind that a link does not hold.
pub fn write(agents: &[Agent], plan: &Plan) -> Option<String> {
    let one = |agent: &Agent| {
        let path = plan.path(&agent.name);
        if path.is_empty() {
            return Some(NOWHERE.to_owned());
        }
        let charges = plan.charges(&agent.name);
        let from = plan.from.get(&agent.name).copied().unwrap_or(0);
        let mut stops = path.iter().zip(from..);
        let mut last = (stops.next()?.0.as_ref().copied()?, from);
        let mut text = Vec::new();
        for (stop, time) in stops {
            let Some(cell) = *stop else { continue };
            if charges.contains(&last.1) {
                text.push('c');
            }
            let by = (
                i32::try_from(cell.x).ok()? - i32::try_from(last.0.x).ok()?,
                i32::try_from(cell.y).ok()? - i32::try_from(last.0.y).ok()?,
            );
            let (letter, ..) = WAYS.iter().find(|way| (way.1, way.2) == by)?;
            text.push(match time - last.1 {
                1 => *letter,
                _ => letter.to_ascii_uppercase(),
            });
            last = (cell, time);
        }
        Some(runs(text.into_iter()))
    };
    let paths: Option<Vec<String>> = agents.iter().map(one).collect();
    Some(paths?.join(";"))
}

/// The plan for agents that a text tells; `None` where it is none. It may break
/// any rule. When agents join and leave comes from `times`.
pub fn read(agents: &[Agent], text: &str, times: Plan) -> Option<Plan> {
    let mut plan = times;
    let mut room = STEPS;
    let mut texts = text.split(';');
    for agent in agents {
        let (mut at, mut path) = (agent.start, vec![Some(agent.start)]);
        let mut charges = Vec::new();
        let from = plan.from.get(&agent.name).copied().unwrap_or(0);
        let own = texts.next()?;
        if own == NOWHERE {
            plan.paths.insert(agent.name.clone(), Vec::new());
            continue;
        }
        let letters = letters(own, room)?;
        room -= letters.len();
        for letter in letters {
            if letter == 'c' {
                charges.push(u32::try_from(path.len()).ok()? - 1 + from);
                continue;
            }
            let small = letter.to_ascii_lowercase();
            let (_, x, y) = WAYS.iter().find(|way| way.0 == small)?;
            at = Cell::new(at.x.checked_add_signed(*x)?, at.y.checked_add_signed(*y)?);
            if small != letter {
                path.push(None);
            }
            path.push(Some(at));
        }
        if !charges.is_empty() {
            plan.charges.insert(agent.name.clone(), charges);
        }
        plan.paths.insert(agent.name.clone(), path);
    }
    texts.next().is_none_or(str::is_empty).then_some(plan)
}
