//! What is drawn over the map: who pushes whom, and where a robot has to go.

use giveway_model::{Cell, Plan, tr};
use giveway_solve::plan::Inherited;

use super::at;
use crate::State;
use crate::board::{CELL, middle};
use crate::inside::board::between;
use crate::inside::{Ban, Overlay, index, steps};

/// How far what is said of a cell is from its middle, in units.
const UP: f64 = 51.0;

/// A step of PIBT: an arrow's line from each robot to the one whose cell it wants.
pub(in crate::inside) fn in_pibt(overlay: &mut Overlay, state: &State) {
    let (Some(run), Some((time, ..))) = (super::pibt(state), steps::place(state)) else {
        return;
    };
    let leader = run.leaders.get(time).and_then(|name| index(state, name));
    let mut lit: Vec<usize> = leader.into_iter().collect();
    for one in run.step(time) {
        lit.extend(
            [&one.from, &one.to]
                .into_iter()
                .filter_map(|name| index(state, name)),
        );
        let from = run
            .plan
            .as_ref()
            .and_then(|plan| at(plan, &one.from, time as u32));
        overlay.bans.extend(push(state, one, from));
    }
    lit.sort_unstable();
    lit.dedup();
    overlay.lit = (!lit.is_empty()).then_some(lit);
}

/// A step of `LaCAM`: where robots had to go in it, and who pushed whom.
pub(in crate::inside) fn in_lacam(overlay: &mut Overlay, state: &State) {
    let (Some(run), Some((step, ..))) = (super::lacam(state), steps::place(state)) else {
        return;
    };
    let event = step.checked_sub(1).and_then(|place| run.events.get(place));
    let Some(event) = event else { return };
    let asked = event.constrained.iter().zip(&event.constraints);
    overlay.bans = asked
        .filter_map(|(name, &cell)| {
            let (x, y) = middle(cell);
            let up = if y < CELL { UP } else { -UP };
            Some(Ban {
                agent: index(state, name)?,
                cell: Some(cell),
                line: None,
                is_asked: true,
                label: (x, y + up),
                text: tr!("on the board, a robot" => "has to go here").to_owned(),
            })
        })
        .collect();
    let before: Option<Plan> = run.plan(event.from, state.document.draft.agents());
    let depth = u32::try_from(run.depth(event.from)).unwrap_or(u32::MAX);
    for one in &event.inherited {
        let from = before.as_ref().and_then(|plan| at(plan, &one.from, depth));
        overlay.bans.extend(push(state, one, from));
    }
}

/// The line from a robot to the one that it pushes.
fn push(state: &State, one: &Inherited, from: Option<Cell>) -> Option<Ban> {
    let edge = [from.filter(|&from| from != one.cell)?, one.cell];
    let (x, y) = between(edge);
    let is_across = edge[0].y == edge[1].y;
    let up = if y < CELL { UP } else { -UP };
    Some(Ban {
        agent: index(state, &one.from)?,
        cell: None,
        line: Some(edge.map(middle)),
        is_asked: true,
        label: (x, if is_across { y + up } else { y }),
        text: tr!("on the board, a robot" => "pushes {robot}", robot = one.to),
    })
}
