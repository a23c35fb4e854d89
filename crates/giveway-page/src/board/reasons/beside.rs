//! Where the reasons of an answer are on the board of the other plan.

use super::in_groups;
use super::{Place, Reasons, marked};
use crate::ask::numbers_groups;
use crate::{Lit, State};

/// What to draw on the board of a question's other plan: the groups of facts, which are the same
/// for all plans, at the robots where that plan has them, and what is lit up. What would go wrong,
/// and where a robot could wait instead, is about this plan alone.
pub fn reasons_beside(state: &State) -> Reasons {
    let mut reasons = Reasons::default();
    let asking = state.document.mode.asking();
    let (Some(asking), Some(other)) = (asking, state.beside()) else {
        return reasons;
    };
    let Some(told) = asking.told.as_deref() else {
        return reasons;
    };
    reasons.agents = marked(state, asking);
    match asking.lit {
        Some(Lit::Cell(cell)) => reasons.places.push(Place { cell, is_lit: true }),
        Some(Lit::Robot(_) | Lit::Witness(_) | Lit::Fact(_) | Lit::Group(_)) | None => {}
    }
    if numbers_groups(asking) {
        in_groups(&mut reasons, asking, told, state, Some(other));
    }
    reasons
}
