//! Whether a statement holds: what must be asked, and what the answers say.

use giveway_model::{Cost, Objective};
use giveway_solve::{Request, Response, Status, explain};

use super::proved::{self, Proved};
use super::{Situation, Why, ask, audited, rules};
use crate::lesson::Statement;
use crate::port::Evidence;

/// Whether a statement holds. What the solver does not know holds neither way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// It holds.
    Yes,
    /// It does not.
    No,
    /// The solver does not know.
    Unknown,
}

/// Whether it holds, why, and what shows it.
pub(crate) struct Outcome {
    pub(crate) held: Held,
    pub(crate) why: Why,
    pub(super) evidence: Evidence,
}

impl Outcome {
    pub(super) fn of(holds: bool, why: Why, evidence: Evidence) -> Self {
        let held = if holds { Held::Yes } else { Held::No };
        Self {
            held,
            why,
            evidence,
        }
    }
}

/// What must be asked.
///
/// # Errors
/// Where there is nothing to ask about.
pub(crate) fn requests(
    statement: &Statement,
    situation: Situation<'_>,
) -> Result<Vec<Request>, Why> {
    let Situation { step, start, scene } = situation;
    Ok(match statement {
        Statement::Impossible { each_alone: false }
        | Statement::Solvable {}
        | Statement::Cost { .. } => vec![ask::solve(scene, None)],
        Statement::Impossible { each_alone: true } => {
            let alone = (0..scene.agents.len()).map(|index| ask::alone(scene, index));
            std::iter::once(ask::solve(scene, None))
                .chain(alone)
                .collect()
        }
        Statement::Raised { .. } => vec![ask::solve(scene, None), ask::solve(start, None)],
        Statement::Verdict { question, .. } => {
            // The step's plan is one of the scene that it began with.
            let plan = step.plan.as_ref().filter(|_| scene == start);
            vec![ask::explain(scene, plan, question.clone())]
        }
        Statement::Apart { costs } => match Objective::new(costs.to_vec()) {
            Ok(objective) => vec![ask::front(scene, objective)],
            Err(error) => return Err(Why::Refused(error.to_string())),
        },
        Statement::Price { rule, .. } => rules::ask_price(scene, *rule),
        Statement::Legal {}
        | Statement::Broken { .. }
        | Statement::Best {}
        | Statement::Beaten {} => match &step.plan {
            Some(plan) => vec![ask::audit(scene, plan)],
            None => return Err(Why::Untouched),
        },
    })
}

/// What the answers say.
pub(crate) fn decide(
    statement: &Statement,
    situation: Situation<'_>,
    responses: &[Response],
) -> Outcome {
    let outcome = match statement {
        Statement::Impossible { .. } => impossible(situation, responses),
        Statement::Solvable {} => solvable(responses),
        Statement::Cost {
            cost,
            compare,
            value,
        } => best(responses.first()).map(|found| match found {
            None => Outcome::of(false, Why::NoPlan, Evidence::default()),
            Some((costs, evidence)) => {
                let found = costs.get(*cost);
                let why = Why::Cost {
                    cost: *cost,
                    value: found,
                    compare: *compare,
                    wanted: *value,
                };
                Outcome::of(compare.holds(found, *value), why, evidence)
            }
        }),
        Statement::Raised { cost, by } => raised(*cost, *by, responses),
        Statement::Verdict { verdict, .. } => answered(*verdict, responses.first()),
        Statement::Apart { costs } => apart(*costs, responses.first()),
        Statement::Price {
            rule,
            compare,
            value,
        } => rules::price(situation.scene, *rule, responses).map(|price| {
            Outcome::of(
                compare.holds(price.steps, *value),
                price.why,
                price.evidence,
            )
        }),
        Statement::Legal {} => audited::legal(responses.first()),
        Statement::Broken { rule } => audited::broken(*rule, responses.first()),
        Statement::Best {} => audited::best_of_all(responses.first(), true),
        Statement::Beaten {} => audited::best_of_all(responses.first(), false),
    };
    outcome.unwrap_or_else(|why| Outcome {
        held: Held::Unknown,
        why,
        evidence: Evidence::default(),
    })
}

type Best = Option<(giveway_model::Costs, Evidence)>;

fn best(response: Option<&Response>) -> Result<Best, Why> {
    Ok(match proved::solved(response)? {
        Proved::Best(costs, plan) => Some((costs, proved::best_plan(plan))),
        Proved::NoPlan => None,
    })
}

fn impossible(situation: Situation<'_>, responses: &[Response]) -> Result<Outcome, Why> {
    let alone = responses.iter().skip(1).zip(&situation.scene.agents);
    for (response, agent) in alone {
        if best(Some(response))?.is_none() {
            let why = Why::AloneStuck(agent.name.clone());
            return Ok(Outcome::of(false, why, Evidence::default()));
        }
    }
    Ok(match best(responses.first())? {
        None => Outcome::of(true, Why::NoPlan, Evidence::default()),
        Some((costs, evidence)) => Outcome::of(false, Why::Plan(costs), evidence),
    })
}

fn solvable(responses: &[Response]) -> Result<Outcome, Why> {
    // A plan is enough, the best or not.
    if let Some(Response::Solved(answer)) = responses.first()
        && let (Some(costs), Some(plan)) = (answer.costs, &answer.plan)
    {
        let evidence = Evidence {
            plan: Some(plan.clone()),
            proved: answer.status == Status::Optimal && answer.reach.is_complete(),
            ..Evidence::default()
        };
        return Ok(Outcome::of(true, Why::Plan(costs), evidence));
    }
    best(responses.first())?;
    Ok(Outcome::of(false, Why::NoPlan, Evidence::default()))
}

fn raised(cost: Cost, by: u32, responses: &[Response]) -> Result<Outcome, Why> {
    let now = best(responses.first())?;
    let before = best(responses.get(1))?;
    let (Some((now, evidence)), Some((before, _))) = (now, before) else {
        return Ok(Outcome::of(false, Why::NoPlan, Evidence::default()));
    };
    let (before, now) = (before.get(cost), now.get(cost));
    let why = Why::Raised {
        cost,
        before,
        now,
        by,
    };
    let holds = before.checked_add(by) == Some(now);
    Ok(Outcome::of(holds, why, evidence))
}

fn answered(wanted: explain::Verdict, response: Option<&Response>) -> Result<Outcome, Why> {
    let Some(Response::Explained(answer)) = response else {
        return Err(proved::unexpected(response));
    };
    let verdict = answer.verdict;
    if verdict == explain::Verdict::Unknown || !answer.reach.is_complete() {
        return Err(Why::Unknown(None));
    }
    let evidence = Evidence {
        plan: answer.alternative.clone(),
        ..Evidence::default()
    };
    let why = Why::Answered { verdict, wanted };
    Ok(Outcome::of(verdict == wanted, why, evidence))
}

fn apart(costs: [Cost; 2], response: Option<&Response>) -> Result<Outcome, Why> {
    let Some(Response::Front(front)) = response else {
        return Err(proved::unexpected(response));
    };
    // Two plans, each better in one cost than the other, are enough where each is best
    // in its own; one plan alone must be the whole front.
    if front.status == Status::Impossible && front.reach.is_complete() {
        return Ok(Outcome::of(false, Why::NoPlan, Evidence::default()));
    }
    if front.status != Status::Optimal || !front.reach.is_complete() {
        return Err(Why::Unknown(None));
    }
    let count = front.front.len();
    let evidence = Evidence {
        plan: front.front.first().and_then(|answer| answer.plan.clone()),
        ..Evidence::default()
    };
    Ok(Outcome::of(
        count > 1,
        Why::Points { count, costs },
        evidence,
    ))
}

/// The first cost in which one plan differs from another.
pub(super) fn first_better(
    costs: &[Cost],
    one: &giveway_model::Costs,
    other: &giveway_model::Costs,
) -> Option<Cost> {
    costs
        .iter()
        .copied()
        .find(|cost| one.get(*cost) != other.get(*cost))
}
