//! The letters of robots that turn (`MAPF_T`), where turns are a rule of the scene.

use crate::whole_steps::WholeSteps;
use giveway_model::constraint::{ConstraintKind, Heading, InForce};
use giveway_model::{Cell, Instance};

/// Where robots face at first, and their letters.
pub(super) struct Turning {
    pub(super) headings: Vec<&'static str>,
    pub(super) letters: Vec<Vec<&'static str>>,
    /// The instance without what the result holds of turns, for the losses.
    pub(super) rest: Instance,
}

impl Turning {
    /// `None` where the scene has no such rule for all robots with a step for a quarter turn, or
    /// the plan does not keep it.
    pub(super) fn of(instance: &Instance, paths: &WholeSteps) -> Option<Self> {
        let agents = instance.agents();
        let is_it = |rule: &InForce<'_>| {
            rule.constraint.kind == ConstraintKind::Turns { quarter: 1 }
                && rule.agents.len() == agents.len()
        };
        let rule = instance.constraints_in_force().find(is_it)?.index;
        let (mut headings, mut letters) = (Vec::new(), Vec::new());
        for (agent, path) in agents.iter().zip(&paths.paths) {
            let heading = agent.heading?;
            headings.push(match heading {
                Heading::North => "N",
                Heading::East => "E",
                Heading::South => "S",
                Heading::West => "W",
            });
            letters.push(turned(heading, path)?);
        }
        let mut scene = instance.to_scene();
        scene.constraints.remove(rule);
        for agent in &mut scene.agents {
            agent.heading = None;
        }
        let rest = Instance::new(scene).ok()?;
        Some(Self {
            headings,
            letters,
            rest,
        })
    }
}

/// The letters of a path. A robot turns in the last waits before a move.
fn turned(mut heading: Heading, path: &[Cell]) -> Option<Vec<&'static str>> {
    let mut letters: Vec<&'static str> = Vec::new();
    for pair in path.windows(2) {
        let [from, to] = *pair else { continue };
        if from == to {
            letters.push("W");
            continue;
        }
        let next = Heading::of(from, to)?;
        let quarters = heading.quarters_to(next) as usize;
        let clockwise = (4 + next as u32 - heading as u32) % 4;
        let turn = if clockwise == 3 { "C" } else { "R" };
        let begin = letters.len().checked_sub(quarters)?;
        for letter in letters.get_mut(begin..)? {
            if *letter != "W" {
                return None;
            }
            *letter = turn;
        }
        letters.push("F");
        heading = next;
    }
    Some(letters)
}
