//! Edits made of the world from a time on, while a plan runs.

use giveway_model::change::{ConstraintRef, What};
use giveway_model::words::Sentence;
use giveway_model::{Cell, Ground, tr_data};

use super::{Edit, Paint, RuleEdit};
use crate::Draft;

/// The changes of the world that an edit is; `world` is as it stands before, with
/// all agents that there ever are. Empty where it changes nothing.
///
/// # Errors
/// That the world cannot change so, as a sentence.
pub(crate) fn changes(edit: &Edit, world: &Draft) -> Result<Vec<What>, Sentence> {
    let name = |agent: usize| {
        let agent = world.agents().get(agent);
        agent.map_or_else(String::new, |agent| agent.name.clone())
    };
    let ground = |cell: Cell| world.grid().ground(cell).unwrap_or(Ground::Obstacle);
    let one = match edit {
        Edit::Paint(paint, cell, on) => return Ok(painted(*paint, *cell, *on, ground(*cell))),
        Edit::Erase(cell) => return Ok(erased(*cell, ground(*cell))),
        // Moving it onto another one would lose it.
        Edit::MovePaint(paint, _, to) if paint.is_on(ground(*to)) => return Ok(Vec::new()),
        Edit::MovePaint(Paint::Obstacle, from, to) => What::MoveObstacle {
            from: *from,
            to: *to,
        },
        Edit::MovePaint(paint, from, to) => {
            let mut both = painted(*paint, *from, false, ground(*from));
            both.extend(painted(*paint, *to, true, ground(*to)));
            return Ok(both);
        }
        Edit::AddAgent(agent) => What::AddAgent {
            agent: agent.clone(),
        },
        Edit::RemoveAgent(agent) => What::RemoveAgent {
            agent: name(*agent),
        },
        Edit::SetGoal(agent, cell) => What::SetGoal {
            agent: name(*agent),
            cell: *cell,
        },
        Edit::AddWaypoint(agent, cell) => What::AddWaypoint {
            agent: name(*agent),
            cell: *cell,
        },
        Edit::DropWaypoint(agent, cell) => What::DropWaypoint {
            agent: name(*agent),
            cell: *cell,
        },
        Edit::MoveWaypoint(agent, from, to) => {
            let agent = name(*agent);
            return Ok(vec![
                What::DropWaypoint {
                    agent: agent.clone(),
                    cell: *from,
                },
                What::AddWaypoint { agent, cell: *to },
            ]);
        }
        Edit::SetBattery(agent, Some(battery)) => What::SetBattery {
            agent: name(*agent),
            level: battery.initial,
        },
        Edit::SetLevel(agent, level) => What::SetBattery {
            agent: name(*agent),
            level: *level,
        },
        Edit::Delay(agent, steps) => What::DelayAgent {
            agent: name(*agent),
            steps: *steps,
        },
        Edit::Stop(agent) => What::StopAgent {
            agent: name(*agent),
        },
        Edit::SetStart(..) => {
            return Err(tr_data!(
                "Where a robot started is settled while its plan runs."
            ));
        }
        Edit::Rules(RuleEdit::Put(None, rule)) => What::AddConstraint {
            constraint: rule.clone(),
        },
        Edit::Rules(RuleEdit::Remove(rule)) => What::RemoveConstraint {
            constraint: ConstraintRef::Index(u32::try_from(*rule).unwrap_or(u32::MAX)),
        },
        Edit::SetBattery(_, None)
        | Edit::Rename(..)
        | Edit::Face(..)
        | Edit::Name(_)
        | Edit::Units(_)
        | Edit::AddAgents(_)
        | Edit::PaintCells(..)
        | Edit::PutAgents(_)
        | Edit::RemoveAgents(_)
        | Edit::Resize(..)
        | Edit::Clear
        | Edit::Fill(_)
        | Edit::Objective(_)
        | Edit::AtGoal(_)
        | Edit::BatteryFloor(_)
        | Edit::WeakenRule(..)
        | Edit::Rules(_)
        | Edit::Area(_)
        | Edit::Grow(..) => {
            return Err(tr_data!("This cannot change while a plan runs."));
        }
        Edit::Within(_) | Edit::Recolour(..) => return Ok(Vec::new()),
    };
    Ok(vec![one])
}

fn painted(paint: Paint, cell: Cell, on: bool, ground: Ground) -> Vec<What> {
    if paint.is_on(ground) == on || (!ground.is_vertex() && paint != Paint::Obstacle) {
        return Vec::new();
    }
    vec![match (paint, on) {
        (Paint::Obstacle, true) => What::AddObstacle { cell },
        (Paint::Obstacle, false) => What::RemoveObstacle { cell },
        (Paint::Charger, true) => What::AddCharger { cell },
        (Paint::Charger, false) => What::RemoveCharger { cell },
        (Paint::Slow, true) => What::SetSlow { cells: vec![cell] },
        (Paint::Slow, false) => What::SetNormal { cells: vec![cell] },
    }]
}

fn erased(cell: Cell, ground: Ground) -> Vec<What> {
    if !ground.is_vertex() {
        return painted(Paint::Obstacle, cell, false, ground);
    }
    let mut all = painted(Paint::Charger, cell, false, ground);
    all.extend(painted(Paint::Slow, cell, false, ground));
    all
}
