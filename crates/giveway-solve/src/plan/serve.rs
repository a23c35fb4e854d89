//! A request for a plan, from the scene to the answer.

use std::collections::BTreeMap;

use giveway_model::{Constraint, Costs, Fault, Instance, Objective, Plan, Version, check::check};
use giveway_planners::{
    budget::Stop,
    planner::{self, Asked, Halt, Inability, Outcome, Planner, Report},
    prioritised::Order,
    problem::{Problem, ProblemError},
    walk::{Walk, to_plan},
};

use super::{Lack, PlanAnswer, PlanEnd, PlanRequest, PlanStats, teller::Teller};
use crate::{Host, Progress, Reason, Refusal, budget::Budget, shut_in::shut_in_by};

/// Serves a request for a plan.
///
/// # Errors
/// When the scene is no instance, or the order names an agent that is none.
pub(crate) fn serve(request: &PlanRequest, host: &dyn Host) -> Result<PlanAnswer, Refusal> {
    let instance =
        Instance::new(request.scene.clone()).map_err(|faults| Refusal::Scene { faults })?;
    let instance = match &request.objective {
        Some(objective) => instance.with_objective(objective.clone()),
        None => instance,
    };
    if let (Some(_), planner) = (&request.by_hand, request.planner)
        && planner != Planner::Cbs
    {
        let found = format!("beside the planner \"{}\"", planner.name());
        let fault = Fault::at("by_hand", found, "the planner \"cbs\", whose tree it is");
        return Err(Refusal::Request { fault });
    }
    let task = PlanTask {
        request,
        order: order(request, &instance)?,
        names: names(&instance),
        objective: instance.in_force(instance.objective().clone()),
        instance,
        budget: Budget::new(host, request.limits),
    };
    Ok(match Problem::new(&task.instance, &task.budget) {
        Ok(problem) => match &request.by_hand {
            Some(by_hand) => task.by_hand(&problem, by_hand)?,
            None => task.plan(&problem),
        },
        Err(error) => task.answer(task.without_problem(&error)),
    })
}

fn names(instance: &Instance) -> Vec<String> {
    let agents = instance.agents().iter();
    agents.map(|agent| agent.name.clone()).collect()
}

fn order(request: &PlanRequest, instance: &Instance) -> Result<Order, Refusal> {
    let Some(order) = &request.order else {
        return Ok(Order::default());
    };
    let numbers = order.iter().map(|name| {
        let number = instance
            .agents()
            .iter()
            .position(|agent| agent.name == *name);
        number.ok_or_else(|| Refusal::Request {
            fault: Fault::at("order", format!("\"{name}\""), "the name of a robot"),
        })
    });
    Ok(Order::Given(numbers.collect::<Result<_, _>>()?))
}

/// A request that was checked.
pub(super) struct PlanTask<'a> {
    pub(super) request: &'a PlanRequest,
    order: Order,
    pub(super) names: Vec<String>,
    /// The objective as it is in force.
    objective: Objective,
    instance: Instance,
    pub(super) budget: Budget<'a>,
}

impl PlanTask<'_> {
    fn plan(&self, problem: &Problem) -> PlanAnswer {
        let asked = self.asked(problem);
        let mut on_better = |walks: &[Walk]| {
            if let Some((plan, costs)) = self.judge(problem, walks) {
                self.budget.report(&Progress::Plan { costs, plan });
            }
        };
        let planner = self.request.planner;
        let report = planner::plan(planner, &asked, &mut on_better, &self.budget);
        let teller = self.teller(problem);
        let mut answer = self.answer(end(&report.outcome, &teller));
        answer.stats.steps = report.steps;
        answer.trace = report.trace.as_ref().map(|trace| teller.trace(trace));
        self.add_plan(&mut answer, problem, &report);
        answer
    }

    pub(super) fn asked<'p>(&'p self, problem: &'p Problem) -> Asked<'p> {
        Asked {
            problem,
            objective: &self.objective,
            within: self.request.within,
            default_horizon: problem.default_horizon(self.instance.grid()),
            order: self.order.clone(),
            traced: self.request.trace,
        }
    }

    pub(super) fn teller<'p>(&'p self, problem: &'p Problem) -> Teller<'p> {
        Teller {
            problem,
            names: &self.names,
            unkept: self.unkept(),
        }
    }

    /// The rules of the scene's own that the planner does not keep: those between agents,
    /// or all of them.
    fn unkept(&self) -> Vec<Constraint> {
        let keeps_alone = self.request.planner == Planner::Cbs;
        let rules = self.instance.constraints_in_force();
        let unkept = rules.filter(|rule| !keeps_alone || rule.constraint.is_between());
        unkept.map(|rule| rule.constraint.clone()).collect()
    }

    /// Adds the plan and what is proved. Never trust a planner: what the judge
    /// refuses is no plan, and shows that no claim can be made.
    pub(super) fn add_plan(&self, answer: &mut PlanAnswer, problem: &Problem, report: &Report) {
        let walks = report.outcome.walks();
        let judged = walks.map(|walks| self.judge(problem, walks));
        let bound = report.outcome.bound();
        let contradicts = match (&judged, bound) {
            (Some(None), _) => true,
            (Some(Some((_, costs))), Some(bound)) => costs.get(bound.cost()) < bound.at_least(),
            _ => false,
        };
        if contradicts {
            answer.ended = PlanEnd::Stopped {
                reason: Stop::Contradiction.into(),
            };
            return;
        }
        let bounds = bound.map(|bound| (bound.cost(), bound.at_least()));
        answer.bounds = bounds.into_iter().collect();
        (answer.plan, answer.costs) = judged.flatten().unzip();
    }

    fn judge(&self, problem: &Problem, walks: &[Walk]) -> Option<(Plan, Costs)> {
        let plan = to_plan(problem, &self.names, walks);
        let report = check(&self.instance, &plan);
        let costs = report.costs.filter(|_| report.is_valid())?;
        Some((plan, costs))
    }

    /// The answer without a plan.
    pub(super) fn answer(&self, ended: PlanEnd) -> PlanAnswer {
        PlanAnswer {
            giveway: Version,
            planner: self.request.planner,
            objective: self.objective.clone(),
            ended,
            costs: None,
            bounds: BTreeMap::new(),
            plan: None,
            stats: PlanStats {
                cpu_seconds: self.budget.stats().cpu_seconds,
                steps: 0,
            },
            trace: None,
        }
    }

    fn without_problem(&self, error: &ProblemError) -> PlanEnd {
        let name = |agent: usize| self.names.get(agent).cloned().unwrap_or_default();
        match *error {
            ProblemError::Alone(agent, _) => PlanEnd::Alone {
                rules: shut_in_by(&self.instance, agent, &self.budget),
                agent: name(agent),
            },
            ProblemError::TooManyWaypoints(agent) => PlanEnd::Refused {
                lack: Lack::ManyWaypoints { agent: name(agent) },
            },
            ProblemError::Stopped(stop) => stopped(stop),
        }
    }
}

fn stopped(stop: Stop) -> PlanEnd {
    PlanEnd::Stopped {
        reason: stop.into(),
    }
}

pub(super) fn end(outcome: &Outcome, teller: &Teller) -> PlanEnd {
    match outcome {
        Outcome::Best { proved, .. } => PlanEnd::Best {
            reach: (*proved).into(),
        },
        Outcome::Found { .. } => PlanEnd::Found,
        Outcome::NoOrderWorks {
            tried,
            within,
            stuck,
        } => PlanEnd::NoOrderWorks {
            tried: *tried,
            within: *within,
            stuck: teller.stuck(stuck),
        },
        Outcome::Stopped { halt, .. } => match *halt {
            Halt::Budget(stop) => stopped(stop),
            Halt::Horizon(within) => PlanEnd::Horizon { within },
            Halt::Stuck { arrived, steps } => PlanEnd::Stopped {
                reason: Reason::StepsOver {
                    steps,
                    arrived: arrived as u32,
                    of: teller.names.len() as u32,
                },
            },
            Halt::Effort => PlanEnd::Stopped {
                reason: Reason::SearchEnded,
            },
        },
        Outcome::Refused { lack } => PlanEnd::Refused {
            lack: told(*lack, teller),
        },
    }
}

fn told(lack: Inability, teller: &Teller) -> Lack {
    let name = |agent| teller.name(agent);
    match lack {
        Inability::NoGoal(agent) => Lack::NoGoal { agent: name(agent) },
        Inability::Battery(agent) => Lack::Batteries { agent: name(agent) },
        Inability::Waypoints(agent) => Lack::Waypoints { agent: name(agent) },
        Inability::SlowZones => Lack::SlowZones,
        Inability::Rules => Lack::Rules {
            rules: teller.unkept.clone(),
        },
        Inability::SharedGoal(a, b) => Lack::SharedGoals {
            agents: [name(a), name(b)],
        },
        Inability::Condition(_) | Inability::Relaxed => Lack::Questions,
        Inability::Cost(cost) => Lack::Cost { cost },
    }
}
