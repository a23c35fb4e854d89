//! Questions whose contrast the oracle knows as a rule that is added.

use giveway_model::{Cell, Plan, Question};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

use super::case::Case;

/// Some questions about the rest of a plan, each with the rules that say the same.
#[allow(
    clippy::too_many_lines,
    reason = "one kind of question after the other"
)]
pub(super) fn questions(
    case: &Case,
    plan: &Plan,
    seed: u64,
    number: u64,
) -> Vec<(Question, Vec<Value>)> {
    let random = &mut ChaCha8Rng::seed_from_u64(seed ^ 0x9e);
    random.set_stream(number);
    let at = case.at;
    let mut questions = Vec::new();
    if let Ok(rule) = serde_json::from_value::<giveway_model::Constraint>(case.other.clone())
        && !rule.is_penalty()
        && !rule.off
    {
        let rule = Box::new(rule);
        questions.push((Question::Rule { rule }, vec![case.other.clone()]));
    }
    let there = plan.paths.iter().filter(|(_, path)| !path.is_empty());
    let names: Vec<&String> = there.map(|(name, _)| name).collect();
    let agent = (*names.choose(random).unwrap()).clone();
    let from = plan.from.get(&agent).copied().unwrap_or(0);
    let path = plan.path(&agent);
    let here = |time: u32| {
        let index = time.checked_sub(from)? as usize;
        path.get(index).or(path.last()).copied().flatten()
    };
    let ends = from + path.len() as u32 - 1;
    let was_removed = plan.until.contains_key(&agent);
    let has_gone = !case.instance.stays() && ends < at;
    let is_whole = |cell: &Cell| json!([cell.x, cell.y]);
    let Some(now) = here(at).filter(|_| !was_removed && !has_gone) else {
        return questions;
    };
    let is_broken_down = case
        .changes
        .iter()
        .any(|it| it["change"] == "delay-agent" && it["agent"] == *agent);
    let grid = case.instance.grid();
    let cells: Vec<Cell> = grid
        .cells()
        .filter(|(_, it)| it.is_vertex())
        .map(|it| it.0)
        .collect();
    let passed = |cell: Cell| (at..=ends.max(at)).any(|time| here(time) == Some(cell));
    let which = random.random_range(0..6);
    let cell = *cells.choose(random).unwrap();
    match which {
        0 if cell != now && passed(cell) => {
            let ask = Question::Visit {
                agent: agent.clone(),
                at: cell,
                time: None,
            };
            let rule = json!({ "kind": "closed", "zone": "asked", "agents": [agent],
                "cells of its zone": [is_whole(&cell)] });
            questions.push((ask, vec![rule]));
        }
        1 if !passed(cell) => {
            let ask = Question::NoVisit {
                agent: Some(agent.clone()),
                at: cell,
            };
            let rule = json!({ "kind": "visit", "cell": is_whole(&cell), "from": at,
                "agents": [agent] });
            questions.push((ask, vec![rule]));
        }
        2 => {
            let steps = (at..ends).filter_map(|time| {
                let to = here(time + 1).or_else(|| here(time + 2))?;
                Some((here(time)?, to)).filter(|(from, to)| from != to)
            });
            let steps: Vec<(Cell, Cell)> = steps.collect();
            if let Some(&(from_cell, to_cell)) = steps.choose(random) {
                let lane = [to_cell, from_cell].map(|it| is_whole(&it));
                let rule = json!({ "kind": "one-way", "lane": lane, "agents": [agent] });
                let ask = Question::Move {
                    agent,
                    from_cell,
                    to_cell,
                    time: None,
                };
                questions.push((ask, vec![rule]));
            }
        }
        3 if ends > at => {
            let rule = json!({ "kind": "arrive", "by": ends - 1, "agents": [agent] });
            questions.push((Question::Arrival { agent }, vec![rule]));
        }
        4 => {
            let last = plan.paths.iter().map(|(name, path)| {
                let from = plan.from.get(name).copied().unwrap_or(0);
                (from + path.len() as u32).saturating_sub(1)
            });
            let last = last.max().unwrap_or(0);
            if last > at {
                let rule = json!({ "kind": "arrive", "by": last - 1 });
                questions.push((Question::Makespan, vec![rule]));
            }
        }
        _ if !is_broken_down => {
            let any = random.random_bool(0.5);
            let zone: Vec<Value> = if any {
                cells.iter().map(is_whole).collect()
            } else {
                vec![is_whole(&now)]
            };
            let rule = json!({ "kind": "no-waiting", "zone": "asked", "agents": [agent],
                "cells of its zone": zone });
            let ask = Question::Wait {
                agent,
                at: (!any).then_some(now),
                from: None,
                to: None,
                at_least: None,
            };
            questions.push((ask, vec![rule]));
        }
        _ => {}
    }
    questions
}
