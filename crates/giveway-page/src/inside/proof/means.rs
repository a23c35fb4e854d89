//! What a kind of step means for the proof, in a sentence or two.

use giveway_model::tr;
use giveway_solve::trace::SearchEvent;

/// What a step means; nothing of one that is explained by its robots.
pub(super) fn means(event: &SearchEvent) -> Option<&'static str> {
    Some(match event {
        SearchEvent::Alone { .. } => {
            tr!(
                "No robot does better than with the floor to itself. So this bounds every plan, before \
             anybody has to give way."
            )
        }
        SearchEvent::Plan { .. } => {
            tr!(
                "This plan breaks no rule, so the best plan is at most as costly. The proof is done \
             when the bound from below comes up to it."
            )
        }
        SearchEvent::Entered { .. } => {
            tr!(
                "At first each robot takes a best way of its own. These ways collide, so from now on \
             the solver looks at all ways that these robots can take."
            )
        }
        SearchEvent::Phase { .. } => {
            tr!(
                "Only plans that are the best so far are compared now: among them the next cost decides."
            )
        }
        SearchEvent::Closed { .. } => {
            tr!(
                "The solver looked for a plan that is better than the best one so far, and proved that \
             there is none."
            )
        }
        SearchEvent::Met { .. } => {
            tr!(
                "The bound says that no plan has less, and this plan has no more. So it is the best."
            )
        }
        SearchEvent::Stopped(_) => {
            tr!(
                "The gap between the bound and the best plan stays open. Go on, or raise the time limit."
            )
        }
        SearchEvent::Counted { .. } => {
            tr!(
                "Only so many robots can be there at once. So however they are planned, the last one \
             comes through only after all others."
            )
        }
        SearchEvent::Exhausted { .. } => tr!("The robots are few enough to look at every case."),
        SearchEvent::Impossible(_) => {
            tr!("The facts that rule out every plan can be asked for below.")
        }
        SearchEvent::Core(_) | SearchEvent::Restarted { .. } | SearchEvent::Round { .. } => {
            return None;
        }
    })
}
