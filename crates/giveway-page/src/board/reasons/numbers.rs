//! Where the numbers of facts stand on the map.

use giveway_solve::explain::{Fact, FactKind};

use super::super::place::last_cell;
use super::super::star::middle;
use super::{Try, corner};
use crate::State;

/// Where the number of a fact stands: on its obstacle, beside the agent whose task it
/// is, or beside the place where the best try ends.
pub(super) fn fact_place(fact: &Fact, state: &State, tries: &[Try]) -> Option<(f64, f64)> {
    let agents = state.document.agents();
    let agent = |name: &String| agents.iter().find(|agent| agent.name == *name);
    match (fact.kind, fact.cell, fact.agents.as_slice()) {
        (FactKind::Obstacle, Some(cell), _) => Some(middle(cell)),
        (_, Some(cell), _) => Some(corner(middle(cell))),
        (FactKind::Constraint, None, _) => rule_place(fact, state).map(corner),
        (FactKind::Collision, None, _) => tries.first().map(|end| corner(end.at)),
        (FactKind::Stay, None, [name]) => Some(corner(middle(agent(name)?.goal?))),
        (FactKind::Breakdown, None, [name]) => {
            let plan = state.document.mode.asking()?.request.plan.as_ref()?;
            Some(corner(middle(last_cell(plan, name, fact.time?)?)))
        }
        (_, None, [name]) => Some(corner(middle(agent(name)?.start))),
        _ => None,
    }
}

/// Where the number of a rule stands: at its zone, its lane, its goal, or its robot.
fn rule_place(fact: &Fact, state: &State) -> Option<(f64, f64)> {
    let scene = state.document.draft.scene();
    let rule = scene.constraints.get(fact.index? as usize)?;
    if let Some(zone) = crate::rules::zone_of(&rule.kind) {
        let zone = scene.zones.iter().find(|it| it.name == zone)?;
        return Some(middle(zone.cell_set().into_iter().next()?));
    }
    let [name] = fact.agents.as_slice() else {
        return None;
    };
    let agent = scene.agents.iter().find(|agent| agent.name == *name)?;
    let is_of_goal = matches!(rule.kind_name(), "arrive");
    Some(middle(
        agent.goal.filter(|_| is_of_goal).unwrap_or(agent.start),
    ))
}
