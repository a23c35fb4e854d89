//! The parts of an answer, one after the other, each told as it becomes known.

use giveway_model::{Costs, Plan, Scene, sorting::map};

use super::{
    FreedomAnswer, FreedomPart, Hold, Plans, Slack,
    backbone::Backbone,
    count::PlanCounter,
    critical::Critical,
    every::Every,
    farthest::Distance,
    formula::{BestPlans, caps, names, ways_of},
    hold::Holding,
    later::Latest,
    ways::Choices,
};
use crate::{
    Progress,
    budget::Stop,
    problem::{Problem, ProblemError},
    search::{LatestArrivals, Proved},
    solve::SolveTask,
};

/// A best plan, and what is asked of all of them.
pub(super) struct BestPlan<'a, 'h> {
    pub(super) task: &'a SolveTask<'h>,
    pub(super) scene: &'a Scene,
    pub(super) plan: &'a Plan,
    pub(super) costs: Costs,
    /// How far it is proved to be a best one.
    pub(super) optimum: Proved,
    /// The latest arrivals that the proof leaves, where it leaves such.
    pub(super) latest: Option<LatestArrivals>,
    /// The number of plans up to which is counted.
    pub(super) count: u32,
}

/// Serves the parts that are pending, as far as the budget allows.
///
/// # Errors
/// When the budget is spent; what is known until then is in the answer.
pub(super) fn serve(subject: &BestPlan, answer: &mut FreedomAnswer) -> Result<(), Stop> {
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
    let proof = (subject.optimum, subject.latest.as_ref());
    let caps = caps(&problem, best, horizon, proof);
    answer.reach = caps.reach.into();
    let formula = BestPlans::new(&problem, &caps, best, &task.budget)?;
    let own = ways_of(&problem, &task.instance, subject.plan).ok_or(Stop::Contradiction)?;
    let mut every = Every::new(&problem, &task.instance, best, formula, own);
    let mut counting = Counting {
        count: PlanCounter::new(subject.count),
        choices: Choices::new(&every),
    };
    for part in answer.pending.clone() {
        match part {
            FreedomPart::Backbone => backbone(&mut every, answer)?,
            FreedomPart::Slack => slack(subject, &mut every, answer)?,
            FreedomPart::Plans => counting.begin(subject, &mut every, answer)?,
            FreedomPart::Critical => critical(subject, &mut every, answer)?,
            FreedomPart::Farthest => farthest(&mut every, counting.count.is_exact(), answer)?,
        }
        if part != FreedomPart::Plans || counting.count.is_exact() {
            answer.pending.retain(|&pending| pending != part);
        }
        if !answer.pending.is_empty() {
            tell(task, answer);
        }
    }
    if answer.pending.contains(&FreedomPart::Plans) {
        counting.finish(subject, &mut every, answer)?;
        answer.pending.clear();
    }
    Ok(())
}

/// Tells the host what is known so far.
fn tell(task: &SolveTask, answer: &mut FreedomAnswer) {
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

fn slack(subject: &BestPlan, every: &mut Every, answer: &mut FreedomAnswer) -> Result<(), Stop> {
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

/// How many best plans there are, and what agents can choose from: begun in its turn,
/// and finished after all other parts, as that may take longest.
struct Counting {
    count: PlanCounter,
    choices: Choices,
}

impl Counting {
    fn begin(
        &mut self,
        subject: &BestPlan,
        every: &mut Every,
        answer: &mut FreedomAnswer,
    ) -> Result<(), Stop> {
        let ended = self.count.begin(every, &subject.task.budget);
        if self.count.is_exact() {
            self.choices.close(every);
        }
        self.tell(every, answer);
        ended
    }

    fn finish(
        &mut self,
        subject: &BestPlan,
        every: &mut Every,
        answer: &mut FreedomAnswer,
    ) -> Result<(), Stop> {
        let counted = self.count.settle(every, &subject.task.budget);
        let ended = counted.and_then(|()| {
            if self.count.is_exact() {
                self.choices.close(every);
                return Ok(());
            }
            self.choices.settle(every, subject.count)
        });
        self.tell(every, answer);
        ended
    }

    fn tell(&mut self, every: &Every, answer: &mut FreedomAnswer) {
        self.choices.learn(every);
        answer.plans = Some(Plans {
            number: self.count.told(every),
            ways: self.choices.told(every),
        });
    }
}

fn critical(subject: &BestPlan, every: &mut Every, answer: &mut FreedomAnswer) -> Result<(), Stop> {
    let task = subject.task;
    let mut critical = Critical::new((task, subject.scene), (subject.optimum, subject.costs));
    let ended = critical.sort_out(every);
    answer.critical = Some(critical.told());
    ended?;
    loop {
        tell(task, answer);
        let ended = critical.solve_next();
        answer.critical = Some(critical.told());
        if !ended? {
            return Ok(());
        }
    }
}

fn farthest(every: &mut Every, all_found: bool, answer: &mut FreedomAnswer) -> Result<(), Stop> {
    let mut distance = Distance::new(all_found);
    let ended = distance.settle(every);
    answer.farthest = Some(distance.told(every));
    ended
}
