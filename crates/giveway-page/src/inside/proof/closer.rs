//! A step of the proof looked at more closely: what was found out about its robots, and
//! the same search for them alone.

use std::rc::Rc;

use giveway_model::{Cost, tr};
use giveway_solve::together::TogetherAnswer;
use giveway_solve::trace::{AgentLimit, Core, SearchEvent, SearchTrace};

use super::{chosen, chosen_event, is_running};
use crate::State;
use crate::inside::AloneView;

/// The core that the chosen step tells of.
pub(super) fn chosen_core(state: &State) -> Option<&Core> {
    match &chosen_event(state)?.event {
        SearchEvent::Core(core) => Some(core),
        _ => None,
    }
}

/// The core of the chosen step, where nothing is known of its robots yet.
pub(crate) fn unknown_core(state: &State) -> Option<&Core> {
    let core = chosen_core(state).filter(|_| !is_running(state))?;
    let looked = state.looked();
    let is_known = looked.is_some_and(|looked| looked.closer(core).is_some());
    (!is_known).then_some(core)
}

/// What was found out about the robots of the chosen step.
pub(super) fn told(state: &State) -> Option<&Rc<TogetherAnswer>> {
    let core = chosen_core(state)?;
    state.looked()?.closer(core)?.as_ref().ok()
}

/// The robots that are looked at alone, and what was found out about them.
pub(crate) fn alone(state: &State) -> Option<(&AloneView, &TogetherAnswer)> {
    let view = state.inside.alone.as_ref()?;
    let told = state.looked()?.closer(&view.core)?.as_ref().ok()?;
    Some((view, told))
}

/// Their trace.
pub(super) fn alone_trace(state: &State) -> Option<&SearchTrace> {
    alone(state)?.1.alone.as_ref()?.solved.trace.as_ref()
}

/// The view of the robots of the chosen step alone; `None` where they are too many, or
/// where that proves nothing.
pub(crate) fn view_alone(state: &State) -> Option<AloneView> {
    let alone = told(state)?.alone.as_ref()?;
    let has_proof = alone.refuted == Some(true) && alone.solved.trace.is_some();
    let (back, _) = chosen(state).filter(|_| has_proof && state.inside.alone.is_none())?;
    Some(AloneView {
        core: Rc::new(chosen_core(state)?.clone()),
        back,
    })
}

/// What each robot of a core is asked for: its own limit; where the core counts late
/// steps of all together, one less than they need.
pub(super) fn limits(core: &Core) -> Vec<AgentLimit> {
    match &core.together {
        Some(together) if !core.sums.is_empty() => {
            let own = together.agents.iter();
            let limit = own.map(|own| AgentLimit {
                agent: own.agent.clone(),
                least: own.least,
                at_most: own.least.saturating_add(together.more.saturating_sub(1)),
            });
            limit.collect()
        }
        _ => core.limits.clone(),
    }
}

/// What a limit asks, after "to" and "cannot": `be on time`.
pub(super) fn keep(cost: Cost, limit: &AgentLimit) -> String {
    let more = limit.at_most.saturating_sub(limit.least);
    match (cost, more) {
        (Cost::Makespan, _) => tr!("arrive by time {time}", time = limit.at_most),
        (Cost::SumOfCosts, 0) => tr!("be on time").to_owned(),
        (Cost::SumOfCosts, more) => {
            tr!("be at most {n} step late" | "be at most {n} steps late" % more)
        }
        (Cost::Waits, 0) => tr!("do without waiting").to_owned(),
        (cost, _) => tr!(
            "do with {value}",
            value = giveway_model::words::value(cost, limit.at_most)
        ),
    }
}
