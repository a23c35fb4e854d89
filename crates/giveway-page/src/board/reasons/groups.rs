//! Where the groups of facts are that force an answer.

use std::rc::Rc;

use giveway_model::Cell;
use giveway_solve::explain::{ExplainAnswer, FactGroupKind};

use super::super::place::place_in;
use super::super::star::middle;
use super::{Place, Reasons, Spot, SpotSign, apart, corner};
use crate::ask::GroupMark;
use crate::{Answer, Asking, Lit, State};

/// Numbers of the groups of facts; the cells and robots of the one that is lit up, and the robots
/// of all of them where nothing is.
pub(super) fn in_groups(
    reasons: &mut Reasons,
    asking: &Asking,
    told: &ExplainAnswer,
    state: &State,
    plan: Option<&Rc<Answer>>,
) {
    let Some(core) = &told.core else { return };
    let agents = state.world().agents();
    let index = |name: &String| agents.iter().position(|agent| agent.name == *name);
    for (number, group) in core.groups.iter().enumerate() {
        let is_lit = asking.lit == Some(Lit::Group(number));
        let middle_of = |cells: &[Cell]| cells.get(cells.len() / 2).copied();
        let robot = group.agents.first().and_then(index);
        let at = match (middle_of(&group.cells), robot) {
            (Some(cell), _) => Some(middle(cell)),
            (None, Some(robot)) if group.kind == FactGroupKind::Agent => {
                place_in(state, plan, robot).map(|cell| corner(middle(cell)))
            }
            (None, _) => None,
        };
        if let Some(at) = at {
            reasons.spots.push(Spot {
                number: number + 1,
                at: apart(&reasons.spots, at),
                is_lit,
                sign: match group.mark() {
                    GroupMark::Helps => SpotSign::Helps,
                    GroupMark::Needed | GroupMark::Open => SpotSign::Reason,
                },
            });
        }
        if is_lit {
            let cells = group.cells.iter();
            let cells = cells.map(|&cell| Place { cell, is_lit });
            reasons.places.extend(cells);
            reasons.agents = group.agents.iter().filter_map(index).collect();
        }
    }
    if asking.lit.is_none() && !asking.shows_other {
        let named = core.groups.iter().flat_map(|group| &group.agents);
        for robot in named.filter_map(index) {
            if !reasons.agents.contains(&robot) {
                reasons.agents.push(robot);
            }
        }
    }
}
