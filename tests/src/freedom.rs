//! What is said of all best plans, compared with all of them.

mod critical;
mod latest;
mod plans;
mod ruled;
mod visits;

use giveway_model::{Cell, Cost, Instance, Plan};
use giveway_solve::freedom::{FreedomAnswer, FreedomRequest, PlanCount};
use giveway_solve::{Limits, Proofs, Request, Response, SilentHost, SolveRequest, Status, serve};

use crate::oracle::{Every, Question, Verdict, Where};
use crate::recount;
use critical::critical;
pub use latest::{Latest, compare_latest};
use plans::{farthest, ways};
pub use ruled::compare_ruled;
use visits::{backbone, slack};

/// Labels and moments that the oracle may make.
const CAP: usize = 60_000;
/// Plans up to which is counted, and up to which the oracle looks at each.
const COUNT: u32 = 300;

/// What came of a comparison.
pub enum Compared {
    /// Both say the same.
    Agreed(Box<FreedomAnswer>),
    /// They contradict each other.
    Differ(Vec<String>),
    /// The oracle cannot say.
    TooLarge,
}

/// Which plan the service is asked about.
#[derive(Clone, Copy)]
pub enum Asked<'a> {
    /// One that it finds.
    Own,
    /// A plan that is handed in.
    Given(&'a Plan),
    /// One that it found before; the proof is handed on.
    Proved,
}

/// The service's answer.
pub fn ask(instance: &Instance, asked: Asked, within: Option<u32>) -> FreedomAnswer {
    let limits = Limits {
        conflicts: Some(300_000),
        ..Limits::default()
    };
    let mut proofs = Proofs::new();
    let plan = match asked {
        Asked::Own => None,
        Asked::Given(plan) => Some(plan.clone()),
        Asked::Proved => solved(instance, within, limits, &mut proofs),
    };
    let request = proofs.completed(Request::Freedom(FreedomRequest {
        scene: instance.to_scene(),
        plan,
        within,
        count: Some(COUNT),
        limits,
        ..FreedomRequest::default()
    }));
    match serve(&request, &SilentHost) {
        Response::Freedom(answer) => *answer,
        other => panic!("expected an answer, got {other:?}"),
    }
}

/// The plan that the service finds; its proof is kept.
fn solved(
    instance: &Instance,
    within: Option<u32>,
    limits: Limits,
    proofs: &mut Proofs,
) -> Option<Plan> {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        within,
        trace: true,
        limits,
        ..SolveRequest::default()
    });
    let response = serve(&request, &SilentHost);
    proofs.keep(request, &response);
    match response {
        Response::Solved(answer) => answer.plan,
        other => panic!("expected a plan, got {other:?}"),
    }
}

/// Compares all parts of an answer. Where no cost of the objective counts time, plans
/// may be as long as the horizon allows, so there it is short.
pub fn compare(instance: &Instance, within: Option<u32>) -> Compared {
    let within = limited(instance, within);
    let question = Question {
        instance,
        within,
        cap: CAP,
    };
    let best = match question.best() {
        Verdict::Capped => return Compared::TooLarge,
        Verdict::Impossible => None,
        Verdict::Best(point) => Some(point),
    };
    let Some(best) = best else {
        let answer = ask(instance, Asked::Own, within);
        return match answer.status {
            Status::Impossible if answer.is_settled() => Compared::Agreed(Box::new(answer)),
            status => Compared::Differ(vec![format!("{status:?}, and there is no plan")]),
        };
    };
    let Some((every, latest)) = all_best(instance, within, &best.vector) else {
        return Compared::TooLarge;
    };
    let asked = match best.vector.iter().sum::<u32>() % 3 {
        0 => Asked::Given(&best.plan),
        1 => Asked::Proved,
        _ => Asked::Own,
    };
    let answer = ask(instance, asked, within);
    let mut faults = Vec::new();
    let mut expect = |holds: bool, what: String| {
        if !holds {
            faults.push(what);
        }
    };
    expect(
        answer.status == Status::Optimal && answer.is_settled(),
        format!("{:?}, pending {:?}", answer.status, answer.pending),
    );
    let Some(plan) = &answer.plan else {
        return Compared::Differ(faults);
    };
    let vector = recount::costs(plan).vector(instance.objective());
    expect(
        vector == best.vector,
        format!("{vector:?}, not {:?}", best.vector),
    );
    let number = u64::from(COUNT);
    let counted = if every.count() > number {
        PlanCount::MoreThan(COUNT)
    } else {
        PlanCount::Exactly(every.count() as u32)
    };
    let said = answer.plans.as_ref().map(|plans| plans.number);
    expect(
        said == Some(counted),
        format!("{said:?} plans, not {}", every.count()),
    );
    faults.extend(backbone(instance, plan, &every, &answer));
    faults.extend(slack(instance, plan, &every, &answer));
    if every.count() <= number {
        faults.extend(ways(instance, &every.courses(), &answer));
        faults.extend(farthest(instance, plan, latest, &every.courses(), &answer));
    }
    match critical(instance, within, &best.vector, &answer) {
        Some(more) => faults.extend(more),
        None => return Compared::TooLarge,
    }
    if faults.is_empty() {
        Compared::Agreed(Box::new(answer))
    } else {
        faults.push(serde_json::to_string(&answer).unwrap());
        Compared::Differ(faults)
    }
}

/// A horizon that keeps plans short: that which is asked for, or a short one where no cost of the
/// objective counts time.
fn limited(instance: &Instance, within: Option<u32>) -> Option<u32> {
    let timed = |cost: &Cost| matches!(cost, Cost::Makespan | Cost::SumOfCosts);
    let counts_time = instance.objective().costs().iter().any(timed);
    within.or((!counts_time).then_some(7))
}

/// All plans of the best costs, and the makespan that none of them exceeds; `None` where the
/// oracle cannot say.
fn all_best(instance: &Instance, within: Option<u32>, best: &[u32]) -> Option<(Every, u32)> {
    let costs = instance.objective().costs();
    let value = |cost| {
        let place = costs.iter().position(|&it| it == cost);
        place.map(|place| best[place])
    };
    let latest = [value(Cost::Makespan), value(Cost::SumOfCosts), within];
    let latest = latest.into_iter().flatten().min()?;
    Some((Every::of(instance, best, latest, CAP)?, latest))
}

/// Where a path has an agent at a time; `None` after its arrival.
fn at(path: &[Option<Cell>], time: usize) -> Option<Where> {
    let cell = |time: usize| path.get(time).copied().flatten();
    match path.get(time)? {
        Some(cell) => Some(Where::At(*cell)),
        None => Some(Where::Between(cell(time - 1)?, cell(time + 1)?)),
    }
}
