//! An instance with only some of its facts, or without some, made from the text of what leaving a
//! fact out means: to see whether they exclude a plan together.

use std::collections::BTreeSet;

use giveway_model::{Cell, Instance, Question, Scene};
use giveway_solve::explain::{Fact, FactKind};

use crate::oracle::Leniency;

/// The instance without all facts but these, breakdowns apart, as a scene and the rules between
/// agents that do not count any more. The agent that a question is about is
/// never left out.
pub fn only(instance: &Instance, question: &Question, facts: &[Fact]) -> (Scene, Leniency) {
    keeping(instance, question, |kind, agents, cell| {
        facts.iter().any(|fact| is(fact, kind, agents, cell))
    })
}

/// The instance without some facts, all others kept.
pub fn without(instance: &Instance, question: &Question, facts: &[Fact]) -> (Scene, Leniency) {
    keeping(instance, question, |kind, agents, cell| {
        !facts.iter().any(|fact| is(fact, kind, agents, cell))
    })
}

/// Whether a fact is the one of this kind, of these agents, at this cell.
fn is(fact: &Fact, kind: FactKind, agents: &[&str], cell: Option<Cell>) -> bool {
    let of: BTreeSet<&str> = fact.agents.iter().map(String::as_str).collect();
    fact.kind == kind && of == agents.iter().copied().collect() && fact.cell == cell
}

fn keeping(
    instance: &Instance,
    question: &Question,
    has: impl Fn(FactKind, &[&str], Option<Cell>) -> bool,
) -> (Scene, Leniency) {
    let mut scene = instance.to_scene();
    scene.agents.retain(|agent| {
        let name = agent.name.as_str();
        question.agent() == Some(name)
            || match agent.goal {
                Some(_) => has(FactKind::Task, &[name], None),
                None => has(FactKind::Presence, &[name], None),
            }
    });
    for agent in &mut scene.agents {
        let name = agent.name.clone();
        let needed = |&cell: &Cell| has(FactKind::Waypoint, &[&name], Some(cell));
        agent.waypoints.retain(needed);
        if !has(FactKind::Battery, &[&name], None) {
            agent.battery = None;
        }
    }
    for (y, row) in scene.map.iter_mut().enumerate() {
        let cells = row.chars().enumerate().map(|(x, ground)| {
            let cell = Cell::new(x as u32, y as u32);
            match ground {
                '#' if !has(FactKind::Obstacle, &[], Some(cell)) => '.',
                '~' if !has(FactKind::Slow, &[], None) => '.',
                '*' if !has(FactKind::Slow, &[], None) => '+',
                other => other,
            }
        });
        *row = cells.collect();
    }
    if !has(FactKind::Floor, &[], None) {
        scene.rules.battery_floor = 0;
    }
    let mut leniency = Leniency::default();
    for (i, a) in scene.agents.iter().enumerate() {
        let stay = match a.goal {
            Some(_) => FactKind::Stay,
            None => FactKind::Rest,
        };
        if !has(stay, &[&a.name], None) {
            leniency.gone.insert(a.name.clone());
        }
        for b in scene.agents.iter().take(i) {
            if !has(FactKind::Collision, &[&a.name, &b.name], None) {
                leniency.ignoring.insert((a.name.clone(), b.name.clone()));
            }
        }
    }
    (scene, leniency)
}
