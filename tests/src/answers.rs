//! Answers to questions against the oracle and the judges.

use std::cell::Cell;

use giveway_model::question::{holds, to_words};
use giveway_model::{Path, Plan};
use giveway_solve::explain::{ExplainAnswer, ExplainRequest, Part, Verdict};
use giveway_solve::{Host, Limits, Progress, Reach, Request, Response, SilentHost, serve};

use crate::compare::{Comparison, judge};
use crate::oracle::{self, Contrast};
use crate::questions::Case;
use crate::recount;

/// Labels that the oracle may make.
const CAP: usize = 400_000;
/// Far more conflicts than a test needs.
const CONFLICTS: u64 = 300_000;

/// Asks the solver for the verdict and the closest plan.
pub fn explained(case: &Case, within: Option<u32>) -> ExplainAnswer {
    let limits = Limits {
        conflicts: Some(CONFLICTS),
        ..Limits::default()
    };
    ask(case, within, limits)
}

/// Asks the solver, which may hold no memory for it.
pub fn without_budget(case: &Case) -> ExplainAnswer {
    let limits = Limits {
        memory_bytes: Some(0),
        ..Limits::default()
    };
    ask(case, None, limits)
}

/// A host that stops the rest once the verdict and the closest plan are known.
#[derive(Default)]
struct Hurried {
    done: Cell<bool>,
}

impl Host for Hurried {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn cancelled(&self) -> bool {
        self.done.get()
    }

    fn progress(&self, event: &Progress) {
        if let Progress::Explained { answer } = event {
            let open = |part: Part| answer.pending.contains(&part);
            self.done.set(!open(Part::Verdict) && !open(Part::Closest));
        }
    }
}

/// Asks the solver for the whole answer.
pub fn in_full(case: &Case) -> ExplainAnswer {
    let limits = Limits {
        conflicts: Some(CONFLICTS),
        ..Limits::default()
    };
    ask_in(&SilentHost, case, None, limits)
}

fn ask(case: &Case, within: Option<u32>, limits: Limits) -> ExplainAnswer {
    ask_in(&Hurried::default(), case, within, limits)
}

fn ask_in(host: &dyn Host, case: &Case, within: Option<u32>, limits: Limits) -> ExplainAnswer {
    let request = Request::Explain(ExplainRequest {
        scene: case.instance.to_scene(),
        plan: Some(case.plan.clone()),
        question: case.question.clone(),
        changes: None,
        at: None,
        objective: None,
        within,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits,
    });
    match serve(&request, host) {
        Response::Explained(answer) => *answer,
        other => panic!("expected an answer, got {other:?}"),
    }
}

/// Compares the solver's verdict with the oracle's, and tells both.
pub fn compare(case: &Case, within: Option<u32>) -> (Comparison, ExplainAnswer) {
    let answer = explained(case, within);
    let contrast = Contrast {
        question: &case.question,
        plan: &case.plan,
    };
    let asked = oracle::Question {
        instance: &case.instance,
        within: answer.reach.within(),
        cap: CAP,
    };
    let truth = asked.best_with(contrast);
    let mut faults = plan_faults(case, &answer);
    faults.extend(horizon_faults(case, within, &answer));
    // The plan that stands beside them is one of what these agents alone can do.
    let more_than_here = answer.alone.iter().filter(|it| it.least > it.here);
    faults
        .extend(more_than_here.map(|it| format!("more needed than in the plan beside it: {it:?}")));
    let objective = case.instance.objective();
    let before = recount::costs(&case.plan).vector(objective);
    let (expected, after) = match &truth {
        oracle::Verdict::Capped => return (Comparison::TooLarge, answer),
        oracle::Verdict::Impossible => (Verdict::Necessary, None),
        oracle::Verdict::Best(point) => {
            let verdict = match point.vector.cmp(&before) {
                std::cmp::Ordering::Less => Verdict::Improvable,
                std::cmp::Ordering::Equal => Verdict::Needless,
                std::cmp::Ordering::Greater => Verdict::Costly,
            };
            (verdict, Some(point.vector.clone()))
        }
    };
    if answer.verdict != expected {
        let said = answer.verdict;
        faults.push(format!("{said:?}, the oracle says {expected:?}"));
    }
    let deltas: Vec<i64> = match &after {
        Some(after) => after
            .iter()
            .zip(&before)
            .map(|(&after, &before)| i64::from(after) - i64::from(before))
            .collect(),
        None => Vec::new(),
    };
    let found: Vec<i64> = objective
        .costs()
        .iter()
        .filter_map(|cost| answer.deltas.get(cost).copied())
        .collect();
    if found != deltas {
        faults.push(format!("deltas {found:?}, the oracle has {deltas:?}"));
    }
    if answer.closest
        && let Some(other) = &answer.alternative
    {
        let makespan = recount::costs(&case.plan).makespan;
        let reach = within.or(oracle::default_horizon(&case.instance));
        let reach = reach.map_or(makespan, |reach| reach.max(makespan));
        let least = oracle::least_distance(&case.instance, contrast, reach, CAP);
        let found = distance(case, other);
        // What is about no one agent is more than this search follows.
        if case.question.agent().is_some() && least.is_some_and(|least| least != found) {
            faults.push(format!("closest at {found:?}, the oracle has {least:?}"));
        }
    }
    if faults.is_empty() {
        return (Comparison::Agreed, answer);
    }
    faults.push(to_words(&case.question));
    faults.push(serde_json::to_string(&case.plan).unwrap());
    faults.push(serde_json::to_string(&answer).unwrap());
    faults.push(format!("{truth:?}"));
    (Comparison::Differ(faults), answer)
}

/// What is wrong with the other plan, whatever the verdict.
fn plan_faults(case: &Case, answer: &ExplainAnswer) -> Vec<String> {
    let needs = answer.verdict != Verdict::Necessary;
    let (Some(other), Some(costs)) = (&answer.alternative, &answer.costs) else {
        let missing = format!("{:?} without an other plan", answer.verdict);
        return Vec::from_iter(needs.then_some(missing));
    };
    let mut faults = judge(&case.instance, other, costs);
    if holds(&case.question, &case.instance, &case.plan, other) != Some(true) {
        faults.push("the other plan is not what is asked for".to_owned());
    }
    if !needs {
        faults.push("necessary, but there is an other plan".to_owned());
    }
    faults
}

/// How far another plan is from the one asked about.
fn distance(case: &Case, other: &Plan) -> oracle::Distance {
    let (mut agents, mut entries) = (0, 0);
    for agent in case.instance.agents() {
        let [a, b] = [&case.plan, other].map(|plan| &plan.paths[&agent.name]);
        let at =
            |path: &Path, time: usize| path.get(time).or(path.last()).copied().unwrap_or_default();
        let times = 0..a.len().max(b.len());
        let differ = times.filter(|&t| at(a, t) != at(b, t)).count() as u32;
        let [c, d] = [&case.plan, other].map(|plan| plan.charges(&agent.name));
        agents += u32::from(differ > 0 || c != d);
        entries += differ;
    }
    (agents, entries)
}

/// What is wrong with the reach of the claim.
fn horizon_faults(case: &Case, asked: Option<u32>, answer: &ExplainAnswer) -> Vec<String> {
    let makespan = recount::costs(&case.plan).makespan;
    let default = oracle::default_horizon(&case.instance).map(|default| default.max(makespan));
    let expected = asked.map_or(default, |asked| Some(asked.max(makespan)));
    let mut faults = Vec::new();
    if answer.reach == Reach::default() {
        faults.push("nothing is claimed".to_owned());
    }
    if answer.reach.within().is_some() && answer.reach.within() != expected {
        faults.push(format!(
            "within {:?}, not {expected:?}",
            answer.reach.within()
        ));
    }
    let bounded = matches!(
        case.question,
        giveway_model::Question::Makespan | giveway_model::Question::SumOfCosts
    );
    if asked.is_none()
        && bounded
        && !answer.reach.is_complete()
        && answer.verdict == Verdict::Necessary
    {
        faults.push("necessary is not complete, though a cost is bounded".to_owned());
    }
    faults
}
