//! The parts of an answer, one after the other, each told as it becomes known.

use giveway_model::{Costs, Plan, Scene, sorting::map};

use super::{
    FreedomAnswer, FreedomPart, Hold, Slack,
    backbone::Backbone,
    count::Count,
    critical::Critical,
    every::Every,
    farthest::Distance,
    formula::{BestPlans, caps, names, ways_of},
    hold::Holding,
    later::Latest,
};
use crate::{
    Progress,
    budget::Stop,
    judged::told,
    problem::{Problem, ProblemError},
    search::Reach,
    solve::Task,
};

/// A best plan, and what is asked of all of them.
pub(super) struct Subject<'a, 'h> {
    pub(super) task: &'a Task<'h>,
    pub(super) scene: &'a Scene,
    pub(super) plan: &'a Plan,
    pub(super) costs: Costs,
    /// How far it is proved to be a best one.
    pub(super) optimum: Reach,
    /// The number of plans up to which is counted.
    pub(super) count: u32,
}

/// Serves the parts that are pending, as far as the budget allows.
///
/// # Errors
/// When the budget is spent; what is known until then is in the answer.
pub(super) fn serve(subject: &Subject, answer: &mut FreedomAnswer) -> Result<(), Stop> {
    let task = subject.task;
    let problem = match Problem::new(&task.instance, &task.budget) {
        Ok(problem) => problem,
        Err(ProblemError::Stopped(stop)) => return Err(stop),
        Err(_) => return Err(Stop::Contradiction), // there is a plan
    };
    let best = (&task.objective, &subject.costs);
    let horizon = task
        .within
        .unwrap_or_else(|| problem.default_horizon(task.instance.grid()));
    let horizon = horizon.max(subject.costs.makespan);
    let caps = caps(&problem, best, horizon, subject.optimum);
    (answer.complete, answer.within) = told(Some(caps.reach));
    let formula = BestPlans::new(&problem, &caps, best, &task.budget)?;
    let own = ways_of(&problem, &task.instance, subject.plan).ok_or(Stop::Contradiction)?;
    let mut every = Every::new(&problem, &task.instance, best, formula, own);
    let mut all_found = false;
    for part in answer.pending.clone() {
        match part {
            FreedomPart::Backbone => backbone(&mut every, answer)?,
            FreedomPart::Slack => slack(subject, &mut every, answer)?,
            FreedomPart::Plans => all_found = plans(subject, &mut every, answer)?,
            FreedomPart::Critical => critical(subject, &mut every, answer)?,
            FreedomPart::Farthest => farthest(&mut every, all_found, answer)?,
        }
        answer.pending.retain(|&pending| pending != part);
        if !answer.pending.is_empty() {
            tell(task, answer);
        }
    }
    Ok(())
}

/// Tells the host what is known so far.
fn tell(task: &Task, answer: &mut FreedomAnswer) {
    answer.stats = task.budget.stats();
    let answer = Box::new(answer.clone());
    task.budget.report(&Progress::Freedom { answer });
}

fn backbone(every: &mut Every, answer: &mut FreedomAnswer) -> Result<(), Stop> {
    let mut backbone = Backbone::new(every);
    let ended = backbone.settle(every);
    answer.backbone = Some(backbone.told(every));
    ended
}

fn slack(subject: &Subject, every: &mut Every, answer: &mut FreedomAnswer) -> Result<(), Stop> {
    let holding = Holding {
        instance: every.instance,
        objective: every.objective,
        plan: subject.plan,
    };
    let names = names(every.instance);
    let mut holds: Vec<Vec<Hold>> = Vec::new();
    for name in &names {
        holds.push(holding.of(name, &subject.task.budget)?);
    }
    let mut latest = Latest::new(every);
    let ended = latest.settle(every);
    let each = names.into_iter().zip(latest.told(every)).zip(holds);
    let slacks = each.map(|((name, arrival), hold)| (name, Slack { arrival, hold }));
    answer.slack = Some(map(slacks));
    ended
}

/// Whether all best plans were found.
fn plans(subject: &Subject, every: &mut Every, answer: &mut FreedomAnswer) -> Result<bool, Stop> {
    let mut count = Count::new(every, subject.count);
    let ended = count.settle(every);
    answer.plans = Some(count.told(every));
    ended.map(|()| count.is_exact())
}

fn critical(subject: &Subject, every: &mut Every, answer: &mut FreedomAnswer) -> Result<(), Stop> {
    let task = subject.task;
    let mut critical = Critical::new((task, subject.scene), (subject.optimum, subject.costs));
    let ended = critical.sort_out(every);
    answer.critical = Some(critical.told());
    ended?;
    let mut number = 0;
    while let Some(next) = critical.next(number) {
        tell(task, answer);
        let ended = critical.solve(next);
        answer.critical = Some(critical.told());
        ended?;
        number = next + 1;
    }
    Ok(())
}

fn farthest(every: &mut Every, all_found: bool, answer: &mut FreedomAnswer) -> Result<(), Stop> {
    let mut distance = Distance::new(all_found);
    let ended = distance.settle(every);
    answer.farthest = Some(distance.told(every));
    ended
}
