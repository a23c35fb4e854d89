//! The board of a search by hand: the paths of the node, at the time of the conflict.

use std::rc::Rc;

use giveway_model::{AtGoal, Cell};
use giveway_solve::plan::{NodeFate, ToldConflict, words};

use super::standing::is_open;
use crate::board::ConflictPlace;
use crate::inside::plan::of_node;
use crate::inside::{TreeRun, place_of};
use crate::{Answer, State};

/// The conflict that is shown: the chosen one of an open node, that of the split of another.
fn conflict(state: &State) -> Option<&ToldConflict> {
    let run = state.hand_run()?;
    let node = run.tree.node(run.asked.node)?;
    match &node.fate {
        NodeFate::Split { conflict, .. } => Some(conflict),
        NodeFate::Open if is_open(node) => {
            let choice = run.choice(state.inside.by_hand.conflict)?;
            Some(&choice.conflict)
        }
        NodeFate::Open | NodeFate::Dead | NodeFate::Best { .. } => None,
    }
}

/// The paths of the node, and when its conflict is.
pub(crate) fn plan(state: &State) -> Option<(Rc<Answer>, u32)> {
    let run = state.hand_run()?;
    run.tree.node(run.asked.node)?.cost?;
    let answer = of_node(&state.document.draft, &run.tree, run.asked.node);
    Some((answer, conflict(state).map_or(0, words::moment)))
}

/// The tree whose node is shown, with the number of that node, and where its conflict is.
pub(crate) fn marks(state: &State) -> Option<(&TreeRun, u64, Option<ConflictPlace>)> {
    let run = state.hand_run()?;
    Some((&run.tree, run.asked.node, conflict(state).map(place_of)))
}

/// All robots that are on the cell of the conflict, and when.
pub(crate) fn together(state: &State, answer: &Answer) -> Option<(Vec<usize>, u32)> {
    let (cells, time) = match conflict(state)? {
        ToldConflict::Vertex { cell, time, .. } | ToldConflict::Target { cell, time, .. } => {
            (&[*cell][..], *time)
        }
        // Another robot may rest where one of both is.
        ToldConflict::Swap { edge, time, .. } => (&edge[..], *time),
    };
    let plan = answer.plan()?;
    let stays = answer.draft.scene().rules.at_goal == AtGoal::Stay;
    let is_at = |name: &String, cell: Cell| {
        let at = plan.paths.get(name).and_then(|path| {
            let rest = || path.last().filter(|_| stays);
            path.get(time as usize).or_else(rest)
        });
        at.copied().flatten() == Some(cell)
    };
    let on = |cell: &Cell| -> Vec<usize> {
        let agents = answer.draft.agents().iter().enumerate();
        let there = agents.filter(|(_, agent)| is_at(&agent.name, *cell));
        there.map(|(number, _)| number).collect()
    };
    let group = cells.iter().map(on).find(|group| group.len() > 1)?;
    Some((group, time))
}
