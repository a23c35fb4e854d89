//! Weakens the claim of an answer where its scene has assumptions.
//!
//! Leaving out a rule gives a relaxation: bounds and impossibility hold with the rule, too, but
//! no judge heeds it: a plan that is found may break it. A bound of a later cost speaks of the
//! plans that reach the bounds before it, which of a rule that is left out nobody knows: only
//! that of the first cost is kept. A key of unknown meaning may change anything, so nothing is
//! called proved, and no bound is kept. Goals that were chosen are part of the question,
//! as every answer says; that there is no plan for them says nothing of other goals.

mod others;
#[cfg(test)]
mod tests;

use giveway_model::{Assumption, Costs, Fault, Instance, Objective, Scene, tr};

pub(crate) use others::{
    weaken_changed, weaken_delays, weaken_explained, weaken_freedom, weaken_planned, weaken_priced,
};

use crate::{Ended, FrontAnswer, Reach, Reason, Refusal, SolveAnswer, Status};

/// Whether a scene has an obstacle that moves.
fn has_moving(assumptions: &[Assumption]) -> bool {
    let mut all = assumptions.iter();
    all.any(|one| matches!(one, Assumption::MovingObstacle { .. }))
}

/// Whether a rule of the problem is left out.
fn has_left_out(assumptions: &[Assumption]) -> bool {
    let mut all = assumptions.iter();
    all.any(|one| matches!(one, Assumption::RuleLeftOut { .. }))
}

/// Keeps the bound of the first cost alone, which is one of the problem, too: those of later
/// costs speak of plans that reach the bounds before them.
fn keep_first(objective: &Objective, answer: &mut SolveAnswer) {
    let first = objective.costs().first();
    answer.bounds.retain(|cost, _| Some(cost) == first);
}

/// Whether goals were chosen of those that a file leaves open.
fn has_chosen(assumptions: &[Assumption]) -> bool {
    assumptions.contains(&Assumption::GoalsChosen)
}

/// Whether a scene has a key that may change anything.
fn has_unknown(assumptions: &[Assumption]) -> bool {
    let mut all = assumptions.iter();
    all.any(|one| matches!(one, Assumption::UnknownKey { .. }))
}

/// Refuses certificates of a scene with moving obstacles: their formula has no clauses for them.
///
/// # Errors
/// When the scene has one.
pub(crate) fn refuse_moving(scene: &Scene) -> Result<(), Refusal> {
    if !has_moving(&scene.assumptions) {
        return Ok(());
    }
    let found = tr!("obstacles that move, for which certificates have no clauses");
    let expected = tr!("a scene without them");
    let faults = vec![Fault::at("assumptions", found, expected)];
    Err(Refusal::Scene { faults })
}

/// Refuses what compares all best plans of a scene with agents that have no goal.
///
/// # Errors
/// When an agent has none.
pub(crate) fn refuse_goalless(scene: &Scene) -> Result<(), Refusal> {
    let goalless = scene.agents.iter().position(|agent| agent.goal.is_none());
    let Some(agent) = goalless else { return Ok(()) };
    let found = tr!("a robot that may rest anywhere");
    let expected = tr!("a goal for each robot: best plans are compared by how robots reach them");
    let faults = vec![Fault::at(format!("agents[{agent}].goal"), found, expected)];
    Err(Refusal::Scene { faults })
}

/// Weakens the answer of a search for the scene as it is posed.
pub(crate) fn weaken_solved(
    (instance, objective): (&Instance, &Objective),
    answer: &mut SolveAnswer,
) {
    weaken((instance.assumptions(), objective), answer);
}

/// The same, of some assumptions.
fn weaken((assumptions, objective): (&[Assumption], &Objective), answer: &mut SolveAnswer) {
    if has_left_out(assumptions) && answer.plan.is_some() {
        keep_first(objective, answer);
        answer.status = Status::Feasible;
        end(answer, Reason::LeftOutRules);
    }
    if has_chosen(assumptions) && answer.status == Status::Impossible {
        answer.status = Status::Unknown;
        end(answer, Reason::ChosenGoals);
    }
    if has_unknown(assumptions) {
        claim_nothing(assumptions, answer);
    }
}

/// Weakens a search that is compared with a plan of these costs: a plan that may break a rule
/// that is left out is no better one.
pub(crate) fn weaken_beside(
    instance: &Instance,
    (own, objective): (Option<&Costs>, &Objective),
    answer: &mut SolveAnswer,
) {
    let is_better =
        |found: &Costs| own.is_none_or(|own| found.vector(objective) < own.vector(objective));
    if has_left_out(instance.assumptions()) && answer.costs.as_ref().is_some_and(is_better) {
        (answer.plan, answer.costs) = (None, None);
        answer.status = Status::Unknown;
        keep_first(objective, answer);
        end(answer, Reason::BetterLeftOutRules);
    }
    if has_chosen(instance.assumptions()) && own.is_none() {
        (answer.plan, answer.costs, answer.status) = (None, None, Status::Unknown);
        answer.bounds.clear();
        end(answer, Reason::OpenGoals);
    }
    if has_unknown(instance.assumptions()) {
        claim_nothing(instance.assumptions(), answer);
    }
}

/// Weakens a front. A bound of a point speaks of plans that keep to the limits of that point,
/// so that where a rule is left out nothing of it is kept.
pub(crate) fn weaken_front(
    (instance, objective): (&Instance, &Objective),
    answer: &mut FrontAnswer,
) {
    let assumptions = instance.assumptions();
    let has_left_out = has_left_out(assumptions) && !answer.front.is_empty();
    let has_other_goals = has_chosen(assumptions) && answer.status == Status::Impossible;
    if has_unknown(assumptions) || has_left_out || has_other_goals {
        answer.status = weaker(answer.status);
        answer.ended = Some(Ended::Assumptions);
        answer.reach = Reach::default();
        for point in &mut answer.front {
            weaken_solved((instance, objective), point);
            if has_left_out {
                point.bounds.clear();
            }
        }
    }
}

/// The status that remains of a proof.
const fn weaker(status: Status) -> Status {
    match status {
        Status::Optimal | Status::Feasible => Status::Feasible,
        Status::Impossible | Status::Unknown => Status::Unknown,
    }
}

/// The claim is gone; bounds that are left hold within the makespan that the answer names.
fn end(answer: &mut SolveAnswer, reason: Reason) {
    answer.ended = Some(Ended::Assumptions);
    answer.reason = Some(reason);
    answer.reach = answer.reach.of_bounds();
}

/// Leaves the plan alone of an answer, where a key of unknown meaning may change anything.
fn claim_nothing(assumptions: &[Assumption], answer: &mut SolveAnswer) {
    answer.status = weaker(answer.status);
    answer.bounds.clear();
    answer.reach = Reach::default();
    end(answer, unknown(assumptions));
}

/// Which keys may change anything.
fn unknown(assumptions: &[Assumption]) -> Reason {
    let mut keys = assumptions.to_vec();
    keys.retain(|one| matches!(one, Assumption::UnknownKey { .. }));
    Reason::UnknownKeys { keys }
}
