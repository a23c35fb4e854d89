//! A solve request, from the scene to the answer.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cost, Costs, Instance, Objective, Plan, Version, check::check, sorting};

use crate::{
    Ended, Host, Limits, Progress, Reason, SolveAnswer, Status,
    budget::Budget,
    calmed::calmed,
    judged::Judged,
    problem::{Problem, ProblemError},
    search::{self, Aim, Bounded, Contact, Horizon, LatestArrivals, Proved, Verdict},
    shut_in::shut_in_by,
    trace::{Cannot, Recorder, SearchEvent, Stopped, name_rules},
    walk::{Walk, to_plan, walks_of_plan},
};

/// The parts of a request that have been checked.
pub(crate) struct SolveTask<'h> {
    pub(crate) instance: Instance,
    pub(crate) objective: Objective,
    /// The horizon, where a person set one.
    pub(crate) within: Option<u32>,
    /// A plan that is known already, as it was handed in.
    pub(crate) start: Option<Plan>,
    /// Whether the plan stays as the search found it, and is not made calm.
    pub(crate) as_found: bool,
    pub(crate) budget: Rc<Budget<'h>>,
}

impl<'h> SolveTask<'h> {
    pub(crate) fn new(
        instance: Instance,
        objective: Option<Objective>,
        within: Option<u32>,
        limits: Limits,
        host: &'h dyn Host,
    ) -> Self {
        Self {
            objective: instance.in_force(objective.unwrap_or_else(|| instance.objective().clone())),
            instance,
            within,
            start: None,
            as_found: false,
            budget: Rc::new(Budget::new(host, limits)),
        }
    }

    /// The same, told as a trace, under a budget that nothing was spent of.
    pub(crate) fn traced(mut self, budget: Budget<'h>) -> Self {
        let recorder = Recorder::new(names(&self), self.objective.clone());
        self.budget = Rc::new(budget.traced(recorder));
        self
    }

    /// The horizon: what the person set, or the default of the problem's rules.
    pub(crate) fn horizon(&self, problem: &Problem) -> Horizon {
        Horizon::of(problem, self.instance.grid(), self.within, 0)
    }
}

/// The lexicographic optimum, with its trace where the budget writes one.
pub(crate) fn solve(task: &SolveTask) -> Solved {
    let mut solved = solve_unreported(task);
    task.budget.record(|_| end(task, &solved));
    solved.answer.trace = task.budget.trace();
    if let Some(trace) = &mut solved.answer.trace {
        trace.latest.clone_from(&solved.latest);
        name_rules(&task.instance, &task.objective, trace, &task.budget);
    }
    solved
}

/// The last event of a trace: what is known in the end.
fn end(task: &SolveTask, Solved { answer, clash, .. }: &Solved) -> SearchEvent {
    match answer.status {
        Status::Optimal => {
            let costs = answer.costs.unwrap_or_default();
            let known = task.objective.costs().iter();
            SearchEvent::Met {
                costs: sorting::map(known.map(|&cost| (cost, costs.get(cost)))),
                within: answer.reach.within(),
            }
        }
        Status::Impossible => SearchEvent::Impossible(Cannot {
            agents: clash.clone(),
            within: answer.reach.within(),
        }),
        Status::Feasible | Status::Unknown => SearchEvent::Stopped(Stopped {
            reason: answer.reason.clone(),
            costs: answer.costs,
            bounds: answer.bounds.clone(),
        }),
    }
}

fn solve_unreported(task: &SolveTask) -> Solved {
    match Problem::new(&task.instance, &task.budget) {
        Ok(problem) => {
            let bounded = Bounded {
                horizon: task.horizon(&problem),
                limits: BTreeMap::new(),
            };
            tell_alone(task, &problem);
            let verdict = best(task, &problem, &bounded);
            answer(task, &problem, verdict)
        }
        Err(error) => {
            let mut solved = without_search(task, &error);
            let answer = &mut solved.answer;
            if answer.status == Status::Unknown
                && let Some((plan, costs)) = start(task)
                && task.within.is_none_or(|within| costs.makespan <= within)
            {
                answer.status = Status::Feasible;
                (answer.plan, answer.costs) = (Some(plan), Some(costs));
            }
            solved
        }
    }
}

/// Reports the least that each agent needs alone, where that is known at once.
fn tell_alone(task: &SolveTask, problem: &Problem) {
    let budget = &task.budget;
    match task.objective.costs().first() {
        Some(Cost::Makespan) => budget.record_alone(Cost::Makespan, &problem.optima),
        Some(Cost::SumOfCosts) if budget.is_traced() => {
            let least = (0..problem.agents()).map(|agent| problem.least_cost(agent));
            budget.record_alone(Cost::SumOfCosts, &least.collect::<Vec<u32>>());
        }
        _ => {}
    }
}

/// An answer, with how far its claim reaches.
pub(crate) struct Solved {
    pub(crate) answer: SolveAnswer,
    pub(crate) reach: Option<Proved>,
    /// Agents that cannot all arrive, where there is no plan.
    pub(crate) clash: Vec<String>,
    /// The latest arrivals that the proof leaves, where the plan is proved to be the best.
    pub(crate) latest: Option<LatestArrivals>,
}

/// The search for the best plan: it begins with the plan that is known, and
/// tells the host of each better one.
pub(crate) fn best(task: &SolveTask, problem: &Problem, bounded: &Bounded) -> Verdict {
    let names = names(task);
    let start = start(task).and_then(|(plan, _)| walks_of_plan(problem, &names, &plan));
    let on_better = |walks: &[Walk], by| {
        let plan = to_plan(problem, &names, walks);
        let report = check(&task.instance, &plan);
        if let (true, Some(costs)) = (report.is_valid(), report.costs) {
            task.budget.report(&Progress::Plan { costs, plan });
            task.budget.record(|_| SearchEvent::Plan { costs, by });
        }
    };
    let contact = Contact {
        start: start.as_deref(),
        earlier: None,
        on_better: &on_better,
    };
    search::solve(problem, &task.objective, bounded, &contact, &task.budget)
}

/// The plan that is known already, where the judge passes it.
pub(crate) fn start(task: &SolveTask) -> Option<(Plan, Costs)> {
    let mut plan = task.start.clone()?;
    plan.cut_trailing_goals(&task.instance);
    let report = check(&task.instance, &plan);
    let costs = report.costs.filter(|_| report.violations.is_empty())?;
    Some((plan, costs))
}

/// The agents' names, in the order of the instance.
pub(crate) fn names(task: &SolveTask) -> Vec<String> {
    let agents = task.instance.agents().iter();
    agents.map(|agent| agent.name.clone()).collect()
}

/// The answer where an agent alone decides it.
pub(crate) fn without_search(task: &SolveTask, error: &ProblemError) -> Solved {
    let name = |i: usize| {
        task.instance
            .agents()
            .get(i)
            .map_or("", |a| a.name.as_str())
    };
    let (status, reach, ended, reason) = match *error {
        ProblemError::Alone(i, reason) => (
            Status::Impossible,
            Some(Proved::no_plan(reason)),
            Ended::Proof,
            Reason::Alone {
                agent: name(i).to_owned(),
                rules: shut_in_by(&task.instance, i, &task.budget),
            },
        ),
        ProblemError::TooManyWaypoints(i) => (
            Status::Unknown,
            None,
            Ended::Size,
            Reason::ManyWaypoints {
                agent: name(i).to_owned(),
            },
        ),
        ProblemError::Stopped(stop) => (Status::Unknown, None, stop.into(), stop.into()),
    };
    let clash = match *error {
        ProblemError::Alone(agent, _) => vec![name(agent).to_owned()],
        _ => Vec::new(),
    };
    let answer = SolveAnswer::without_plan(status, reach, (ended, reason), task.budget.stats());
    Solved {
        answer,
        reach,
        clash,
        latest: None,
    }
}

/// A verdict as an answer; its plan is judged before it is given away.
pub(crate) fn answer(task: &SolveTask, problem: &Problem, verdict: Verdict) -> Solved {
    let names = names(task);
    let claim = (verdict.reach, verdict.stop);
    let judged = Judged::new(verdict.best, &Aim::Best, claim, |(walks, costs)| {
        let plan = to_plan(problem, &names, &walks);
        let report = check(&task.instance, &plan);
        let passes = report.violations.is_empty() && report.costs == Some(costs);
        let is_proved = claim.1.is_none();
        passes.then(|| calmed(task, problem, &walks, (plan, costs), is_proved))
    });
    let (status, reach) = (judged.status, judged.reach);
    let clash = verdict.clash.iter().filter_map(|&i| names.get(i));
    let clash: Vec<String> = clash.cloned().collect();
    let reason = judged.stop.map(Reason::from).or_else(|| {
        let agents = clash.clone();
        (status == Status::Impossible).then_some(Reason::Clash { agents })
    });
    let (plan, costs) = judged.plan.unzip();
    let answer = SolveAnswer {
        giveway: Version,
        status,
        costs,
        bounds: verdict.bounds,
        reach: reach.into(),
        ended: Some(Ended::by(judged.stop)),
        reason,
        plan,
        stats: task.budget.stats(),
        trace: None,
    };
    Solved {
        answer,
        reach,
        clash,
        latest: verdict.latest.filter(|_| status == Status::Optimal),
    }
}
