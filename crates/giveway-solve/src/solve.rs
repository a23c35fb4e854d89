//! A solve request, from the scene to the answer.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Costs, Instance, Objective, Plan, Version, check::check, words};

use crate::{
    Host, Limits, Progress, SolveAnswer, Status,
    budget::Budget,
    judged::{Judged, told},
    problem::{Problem, ProblemError},
    search::{self, Aim, Bounded, Contact, Horizon, Reach, Verdict},
    walk::{Walk, of_plan, to_plan},
};

/// The parts of a request that have been checked.
pub(crate) struct Task<'h> {
    pub(crate) instance: Instance,
    pub(crate) objective: Objective,
    /// The horizon, where a person set one.
    pub(crate) within: Option<u32>,
    /// A plan that is known already, as it was handed in.
    pub(crate) start: Option<Plan>,
    pub(crate) budget: Rc<Budget<'h>>,
}

impl<'h> Task<'h> {
    pub(crate) fn new(
        instance: Instance,
        objective: Option<Objective>,
        within: Option<u32>,
        limits: Limits,
        host: &'h dyn Host,
    ) -> Self {
        Self {
            objective: objective.unwrap_or_else(|| instance.objective().clone()),
            instance,
            within,
            start: None,
            budget: Rc::new(Budget::new(host, limits)),
        }
    }

    /// The horizon: what the person set, or the default of the problem's rules.
    pub(crate) fn horizon(&self, problem: &Problem) -> Horizon {
        Horizon::of(problem, self.instance.grid(), self.within, 0)
    }
}

/// The lexicographic optimum.
pub(crate) fn solve(task: &Task) -> Solved {
    match Problem::new(&task.instance, &task.budget) {
        Ok(problem) => {
            let bounded = Bounded {
                horizon: task.horizon(&problem),
                limits: BTreeMap::new(),
            };
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

/// An answer, with how far its claim reaches.
pub(crate) struct Solved {
    pub(crate) answer: SolveAnswer,
    pub(crate) reach: Option<Reach>,
}

/// The search for the best plan: it begins with the plan that is known, and
/// tells the host of each better one.
pub(crate) fn best(task: &Task, problem: &Problem, bounded: &Bounded) -> Verdict {
    let names = names(task);
    let start = start(task).and_then(|(plan, _)| of_plan(problem, &names, &plan));
    let on_better = |walks: &[Walk]| {
        let plan = to_plan(problem, &names, walks);
        let report = check(&task.instance, &plan);
        if let (true, Some(costs)) = (report.is_valid(), report.costs) {
            task.budget.report(&Progress::Plan { costs, plan });
        }
    };
    let contact = Contact {
        start: start.as_deref(),
        on_better: &on_better,
    };
    search::solve(problem, &task.objective, bounded, &contact, &task.budget)
}

/// The plan that is known already, where the judge passes it.
fn start(task: &Task) -> Option<(Plan, Costs)> {
    let mut plan = task.start.clone()?;
    plan.cut_trailing_goals(&task.instance);
    let report = check(&task.instance, &plan);
    let costs = report.costs.filter(|_| report.violations.is_empty())?;
    Some((plan, costs))
}

/// The agents' names, in the order of the instance.
fn names(task: &Task) -> Vec<String> {
    let agents = task.instance.agents().iter();
    agents.map(|agent| agent.name.clone()).collect()
}

/// The answer where an agent alone decides it.
pub(crate) fn without_search(task: &Task, error: &ProblemError) -> Solved {
    let name = |i: usize| {
        task.instance
            .agents()
            .get(i)
            .map_or("", |a| a.name.as_str())
    };
    let (status, reach, reason) = match *error {
        ProblemError::Alone(i, reason) => (
            Status::Impossible,
            Some(Reach::ForEver(reason)),
            format!("{} cannot do its task, even alone.", name(i)),
        ),
        ProblemError::TooManyWaypoints(i) => (
            Status::Unknown,
            None,
            format!("{} has more waypoints than can be planned for.", name(i)),
        ),
        ProblemError::Stopped(stop) => (Status::Unknown, None, stop.sentence().to_owned()),
    };
    let answer = SolveAnswer::without_plan(status, reach, reason, task.budget.stats());
    Solved { answer, reach }
}

/// A verdict as an answer; its plan is judged before it is given away.
pub(crate) fn answer(task: &Task, problem: &Problem, verdict: Verdict) -> Solved {
    let names = names(task);
    let claim = (verdict.reach, verdict.stop);
    let judged = Judged::new(verdict.best, &Aim::Best, claim, |(walks, costs)| {
        let plan = to_plan(problem, &names, &walks);
        let report = check(&task.instance, &plan);
        let passes = report.violations.is_empty() && report.costs == Some(costs);
        passes.then_some((plan, costs))
    });
    let (status, reach) = (judged.status, judged.reach);
    let (complete, within) = told(reach);
    let reason = judged
        .stop
        .map(|stop| stop.sentence().to_owned())
        .or_else(|| {
            let clash: Vec<&str> = verdict
                .clash
                .iter()
                .filter_map(|&i| names.get(i))
                .map(String::as_str)
                .collect();
            (status == Status::Impossible).then(|| clash_sentence(&clash))
        });
    let (plan, costs) = judged.plan.unzip();
    let answer = SolveAnswer {
        giveway: Version,
        status,
        costs,
        bounds: verdict.bounds,
        within,
        complete,
        reason,
        plan,
        stats: task.budget.stats(),
        trace: None,
    };
    Solved { answer, reach }
}

/// Whom it concerns; the claim itself says at which horizon it holds.
pub(crate) fn clash_sentence(agents: &[&str]) -> String {
    match agents {
        [] => "The robots cannot all arrive.".to_owned(),
        [one] => format!("{one} cannot arrive."),
        [one, two] => format!("{one} and {two} cannot both arrive."),
        names => format!("{} cannot all arrive.", words::and(names)),
    }
}
