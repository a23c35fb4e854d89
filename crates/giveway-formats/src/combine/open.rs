//! Goals that a file leaves open, decided by where the paths of a plan end.

use std::collections::BTreeSet;

use super::orders::{self, Handled};
use crate::{OpenGoals, matching};
use giveway_model::{AtGoal, Cell, Plan, Scene, tr};

/// Sets the goals of a scene, and what its agents visit, to what a plan does, as far as its
/// file allows that; what is to be said of it, `None` where it did not.
pub(super) fn decide(
    scene: &mut Scene,
    open: &OpenGoals,
    (file, plan, handled): (&str, &Plan, &Handled<'_>),
) -> Option<Vec<String>> {
    let is_decided = match open {
        OpenGoals::None => false,
        OpenGoals::Choices(choices) => choose(scene, choices, plan),
        OpenGoals::Orders(orders) if handled.delivers() => {
            return Some(orders::serve(scene, orders, plan, handled));
        }
        OpenGoals::Orders(orders) => end(scene, &orders.shelves, plan),
    };
    is_decided.then(|| {
        vec![tr!(
            "The goals are where the paths in {file} end, since its problem leaves them open.",
            file
        )]
    })
}

pub(super) fn last(plan: &Plan, name: &str) -> Option<Cell> {
    plan.path(name).iter().rev().copied().flatten().next()
}

/// Each agent goes to where it ends if it may choose that goal; the others share what is left.
fn choose(scene: &mut Scene, choices: &[Vec<Cell>], plan: &Plan) -> bool {
    let mut taken = BTreeSet::new();
    let mut kept = Vec::with_capacity(choices.len());
    for (agent, choices) in scene.agents.iter().zip(choices) {
        let end = last(plan, &agent.name).filter(|end| choices.contains(end));
        kept.push(end.filter(|&end| taken.insert(end)));
    }
    let left = kept.iter().zip(choices).map(|(end, choices)| {
        let free = || {
            choices
                .iter()
                .filter(|cell| !taken.contains(*cell))
                .copied()
        };
        end.map_or_else(|| free().collect(), |end| vec![end])
    });
    let goals = matching::assign(&left.collect::<Vec<_>>());
    let goals: Option<Vec<Cell>> = goals.into_iter().collect();
    let Some(goals) = goals else { return false };
    for (agent, goal) in scene.agents.iter_mut().zip(goals) {
        agent.goal = Some(goal);
    }
    !taken.is_empty()
}

/// Each agent ends where its path does, if that serves all places; a plan that does the
/// tasks of the scene leaves them.
fn end(scene: &mut Scene, served: &[Vec<Cell>], plan: &Plan) -> bool {
    let does_tasks = scene.agents.iter().all(|agent| {
        let path = plan.path(&agent.name);
        let mut waypoints = agent.waypoints.iter();
        agent
            .goal
            .is_none_or(|goal| last(plan, &agent.name).unwrap_or(agent.start) == goal)
            && waypoints.all(|waypoint| path.contains(&Some(*waypoint)))
    });
    let ends = scene.agents.iter();
    let ends = ends.map(|agent| last(plan, &agent.name).unwrap_or(agent.start));
    let ends: Vec<Cell> = ends.collect();
    let different: BTreeSet<Cell> = ends.iter().copied().collect();
    let is_shared = different.len() < ends.len() && scene.rules.at_goal == AtGoal::Stay;
    let mut places = served.iter();
    let serves = places.all(|cells| cells.iter().any(|cell| different.contains(cell)));
    if does_tasks || is_shared || !serves || !ends.iter().all(|&end| is_free(scene, end)) {
        return false;
    }
    for (agent, end) in scene.agents.iter_mut().zip(ends) {
        agent.goal = Some(end);
        agent.waypoints.clear();
    }
    true
}

pub(super) fn is_free(scene: &Scene, cell: Cell) -> bool {
    let row = scene.map.get(cell.y as usize);
    let ground = row.and_then(|row| row.as_bytes().get(cell.x as usize));
    ground.is_some_and(|&ground| ground != b'#')
}
