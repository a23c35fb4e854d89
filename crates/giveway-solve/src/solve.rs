//! A solve request, from the scene to the answer.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Costs, Instance, Objective, Plan, Version, check::check};

use crate::{
    Host, Limits, Progress, SolveAnswer, Status,
    meter::{Meter, Stop},
    problem::{Problem, Setback},
    search::{self, Bounded, Contact, Verdict},
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
    pub(crate) meter: Rc<Meter<'h>>,
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
            meter: Rc::new(Meter::new(host, limits)),
        }
    }

    /// The horizon: what the person set, or the default of the problem's rules.
    pub(crate) fn horizon(&self, problem: &Problem) -> u32 {
        let default = problem.default_horizon(self.instance.grid());
        self.within.unwrap_or(default)
    }
}

/// The lexicographic optimum.
pub(crate) fn solve(task: &Task) -> SolveAnswer {
    match Problem::new(&task.instance, &task.meter) {
        Ok(problem) => {
            let bounded = Bounded {
                horizon: task.horizon(&problem),
                limits: BTreeMap::new(),
            };
            let verdict = best(task, &problem, &bounded);
            answer(task, &problem, bounded.horizon, verdict)
        }
        Err(setback) => {
            let mut answer = without_search(task, &setback);
            if answer.status == Status::Unknown
                && let Some((plan, costs)) = start(task)
                && task.within.is_none_or(|within| costs.makespan <= within)
            {
                answer.status = Status::Feasible;
                (answer.plan, answer.costs) = (Some(plan), Some(costs));
            }
            answer
        }
    }
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
            task.meter.report(&Progress::Plan { costs, plan });
        }
    };
    let contact = Contact {
        start: start.as_deref(),
        on_better: &on_better,
    };
    search::solve(problem, &task.objective, bounded, &contact, &task.meter)
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
pub(crate) fn without_search(task: &Task, setback: &Setback) -> SolveAnswer {
    let name = |i: usize| {
        task.instance
            .agents()
            .get(i)
            .map_or("", |a| a.name.as_str())
    };
    let (status, reason) = match *setback {
        Setback::Alone(i) => (
            Status::Impossible,
            format!("{} cannot do its task even alone.", name(i)),
        ),
        Setback::TooManyWaypoints(i) => (
            Status::Unknown,
            format!("{} has more waypoints than can be planned for.", name(i)),
        ),
        Setback::Stopped(stop) => (Status::Unknown, stop.sentence().to_owned()),
    };
    SolveAnswer {
        giveway: Version,
        status,
        costs: None,
        bounds: BTreeMap::new(),
        within: None,
        complete: status == Status::Impossible,
        reason: Some(reason),
        plan: None,
        stats: task.meter.stats(),
    }
}

/// A verdict as an answer; its plan is judged before it is given away.
pub(crate) fn answer(
    task: &Task,
    problem: &Problem,
    horizon: u32,
    verdict: Verdict,
) -> SolveAnswer {
    let names = names(task);
    let mut stop = verdict.stop;
    let mut found = verdict
        .best
        .map(|(walks, costs)| (to_plan(problem, &names, &walks), costs));
    if let Some((plan, costs)) = &found {
        let report = check(&task.instance, plan);
        if !report.violations.is_empty() || report.costs != Some(*costs) {
            // Never trust the solver: a plan that the judge refuses is no plan.
            found = None;
            stop = Some(Stop::Contradiction);
        }
    }
    let status = match (&found, stop) {
        (Some(_), None) => Status::Optimal,
        (Some(_), Some(_)) => Status::Feasible,
        (None, None) => Status::Impossible,
        (None, Some(_)) => Status::Unknown,
    };
    let settled = stop.is_none();
    let complete = settled && verdict.complete;
    let reason = stop.map(|stop| stop.sentence().to_owned()).or_else(|| {
        let clash: Vec<&str> = verdict
            .clash
            .iter()
            .filter_map(|&i| names.get(i))
            .map(String::as_str)
            .collect();
        (status == Status::Impossible).then(|| clash_sentence(&clash))
    });
    let (plan, costs) = found.unzip();
    SolveAnswer {
        giveway: Version,
        status,
        costs,
        bounds: verdict.bounds,
        within: (settled && !complete).then_some(horizon),
        complete,
        reason,
        plan,
        stats: task.meter.stats(),
    }
}

/// Whom it concerns; the claim itself says at which horizon it holds.
pub(crate) fn clash_sentence(agents: &[&str]) -> String {
    match agents {
        [] => "The agents cannot all arrive.".to_owned(),
        [one] => format!("{one} cannot arrive."),
        [one, two] => format!("{one} and {two} cannot both arrive."),
        [init @ .., last] => format!("{} and {last} cannot all arrive.", init.join(", ")),
    }
}
