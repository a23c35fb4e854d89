//! An answer of the solver against the oracle and the judge.

use giveway_model::check::check;
use giveway_model::{Costs, Instance, Plan};
use giveway_solve::{FrontAnswer, Reach, SolveAnswer, Status};

use crate::oracle::{self, Question, Verdict};
use crate::{ask, recount};

/// What a comparison found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// No difference.
    Agreed,
    /// The instance is too large for the oracle.
    TooLarge,
    /// Where the two differ, as sentences.
    Differ(Vec<String>),
}

/// The largest number of labels that the oracle may make.
const CAP: usize = 200_000;

/// Asks the solver and the oracle for the best plan.
pub fn best(instance: &Instance, within: Option<u32>) -> Comparison {
    answered(instance, within, || ask::best(instance, within))
}

/// The same with a solver that is asked in another way.
pub fn answered(
    instance: &Instance,
    within: Option<u32>,
    ask: impl FnOnce() -> SolveAnswer,
) -> Comparison {
    let oracle = Oracle { instance };
    let Some(Truth(asked)) = oracle.best(within) else {
        return Comparison::TooLarge;
    };
    let answer = ask();
    let mut faults = Vec::new();
    faults.extend(plan_faults(instance, within, &answer));
    let claim = Claim {
        status: answer.status,
        reach: answer.reach,
    };
    faults.extend(claim.faults(instance, within));
    if claim.can_be_judged() {
        let Some(truth) = oracle.best(claim.reach.within()) else {
            return Comparison::TooLarge;
        };
        faults.extend(best_faults(instance, &answer, &truth));
    }
    // Of a front this cannot be said: a longer plan may be another point of it.
    let by_objective = oracle::objective_is_complete(instance) && within.is_none();
    if by_objective && answer.status == Status::Optimal && !answer.reach.is_complete() {
        faults.push("optimal is not complete, though its first cost makes it so".to_owned());
    }
    Comparison::of(faults, &answer, &asked)
}

/// Asks the solver and the oracle for the Pareto front.
pub fn front(instance: &Instance, within: Option<u32>) -> Comparison {
    let oracle = Oracle { instance };
    let Some(asked) = oracle.front(within) else {
        return Comparison::TooLarge;
    };
    let answer = ask::front(instance, within);
    let mut faults = Vec::new();
    for point in &answer.front {
        faults.extend(plan_faults(instance, within, point));
    }
    let claim = Claim {
        status: answer.status,
        reach: answer.reach,
    };
    faults.extend(claim.faults(instance, within));
    if claim.can_be_judged() {
        let Some(truth) = oracle.front(claim.reach.within()) else {
            return Comparison::TooLarge;
        };
        faults.extend(front_faults(instance, &answer, &truth));
    }
    Comparison::of(faults, &answer, &asked)
}

impl Comparison {
    fn of(
        mut faults: Vec<String>,
        answer: &impl serde::Serialize,
        oracle: &impl std::fmt::Debug,
    ) -> Self {
        if faults.is_empty() {
            return Self::Agreed;
        }
        let answer = serde_json::to_string(answer).unwrap();
        faults.push(format!("the answer of the solver in full: {answer}"));
        faults.push(format!("the answer of the oracle: {oracle:?}"));
        Self::Differ(faults)
    }
}

/// The best vector, if there is a plan.
struct Truth(Option<Vec<u32>>);

/// The oracle for one instance.
struct Oracle<'a> {
    instance: &'a Instance,
}

impl Oracle<'_> {
    fn question(&self, within: Option<u32>) -> Question<'_> {
        Question {
            instance: self.instance,
            within,
            cap: CAP,
        }
    }

    /// `None` where the instance is too large.
    fn best(&self, within: Option<u32>) -> Option<Truth> {
        let free = match self.question(None).best() {
            Verdict::Best(point) => point,
            Verdict::Impossible => return Some(Truth(None)),
            Verdict::Capped => return None,
        };
        // The best of all plans is the best within a horizon too, if it fits.
        let fits = within.is_none_or(|within| recount::costs(&free.plan).makespan <= within);
        if fits {
            return Some(Truth(Some(free.vector)));
        }
        match self.question(within).best() {
            Verdict::Best(point) => Some(Truth(Some(point.vector))),
            Verdict::Impossible => Some(Truth(None)),
            Verdict::Capped => None,
        }
    }

    /// The vectors of the front; `None` where the instance is too large.
    fn front(&self, within: Option<u32>) -> Option<Vec<Vec<u32>>> {
        let free = self.question(None).front()?;
        let fits = within.is_none_or(|within| {
            let mut plans = free.iter().map(|point| &point.plan);
            plans.all(|plan| recount::costs(plan).makespan <= within)
        });
        let points = if fits {
            free
        } else {
            self.question(within).front()?
        };
        Some(points.into_iter().map(|point| point.vector).collect())
    }
}

/// What an answer claims, and how far.
struct Claim {
    status: Status,
    reach: Reach,
}

impl Claim {
    /// Whether this is a claim that the oracle can judge.
    fn can_be_judged(&self) -> bool {
        matches!(self.status, Status::Optimal | Status::Impossible)
            && self.reach != Reach::default()
    }

    /// What is wrong with the form of the claim.
    fn faults(&self, instance: &Instance, asked: Option<u32>) -> Vec<String> {
        let mut faults = Vec::new();
        let Self { status, reach } = *self;
        if !matches!(status, Status::Optimal | Status::Impossible) {
            faults.push(format!("{status:?}, expected optimal or impossible"));
            return faults;
        }
        if reach == Reach::default() {
            faults.push("it is not said how far the claim reaches".to_owned());
        }
        let default = oracle::default_horizon(instance);
        if let Some(within) = reach.within()
            && asked.or(default) != Some(within)
        {
            faults.push(format!(
                "the claim is made within {within}, expected {asked:?}, or by default {default:?}"
            ));
        }
        if !reach.is_complete() && status == Status::Impossible && default.is_none() {
            faults.push(
                "impossible is not complete, though an agent cannot do its task even alone"
                    .to_owned(),
            );
        }
        faults
    }
}

fn best_faults(instance: &Instance, answer: &SolveAnswer, truth: &Truth) -> Vec<String> {
    let found = answer.costs.map(|costs| costs.vector(instance.objective()));
    if found != truth.0 {
        return vec![format!(
            "{:?} with {found:?} for {}, the oracle has {:?}",
            answer.status,
            instance.objective(),
            truth.0
        )];
    }
    Vec::new()
}

fn front_faults(instance: &Instance, answer: &FrontAnswer, truth: &[Vec<u32>]) -> Vec<String> {
    let vector = |point: &SolveAnswer| point.costs.unwrap().vector(instance.objective());
    let found: Vec<Vec<u32>> = answer.front.iter().map(vector).collect();
    if found != truth || (answer.status == Status::Impossible) != truth.is_empty() {
        return vec![format!(
            "{:?} with {found:?} for {}, the oracle has {truth:?}",
            answer.status,
            instance.objective(),
        )];
    }
    Vec::new()
}

/// What is wrong with an answer in itself: its plan, costs and bounds.
fn plan_faults(instance: &Instance, within: Option<u32>, answer: &SolveAnswer) -> Vec<String> {
    let mut faults = Vec::new();
    match (answer.status, &answer.plan, &answer.costs) {
        (Status::Optimal, Some(plan), Some(costs)) => {
            faults.extend(judge(instance, plan, costs));
            if within.is_some_and(|within| costs.makespan > within) {
                faults.push(format!("the plan is longer than {within:?}"));
            }
            let bounds = instance.objective().costs().iter();
            if answer.bounds != bounds.map(|&c| (c, costs.get(c))).collect() {
                faults.push(format!(
                    "optimal with bounds {:?}, expected those of the costs {costs:?}",
                    answer.bounds
                ));
            }
        }
        (Status::Optimal, _, _) => faults.push("optimal without a plan or costs".to_owned()),
        (Status::Impossible, None, None) => {}
        (Status::Impossible, _, _) => faults.push("impossible, but there is a plan".to_owned()),
        _ => {}
    }
    faults
}

/// What the judge has against a plan and its stated costs.
pub fn judge(instance: &Instance, plan: &Plan, stated: &Costs) -> Vec<String> {
    let report = check(instance, plan);
    let mut faults: Vec<String> = report
        .violations
        .iter()
        .map(|v| format!("the plan breaks a rule: {}", v.message))
        .collect();
    if report.costs != Some(*stated) {
        faults.push(format!(
            "the judge counts {:?}, not {stated:?}",
            report.costs
        ));
    }
    if faults.is_empty() && recount::costs(plan) != *stated {
        let counted = recount::costs(plan);
        faults.push(format!("the plan costs {counted:?}, not {stated:?}"));
    }
    faults
}
