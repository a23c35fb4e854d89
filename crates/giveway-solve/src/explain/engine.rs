//! A question answered, part after part: the verdict with an other plan first,
//! then what makes it plain why.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::tr;
use giveway_model::{
    Instance, Objective, Plan, Question,
    check::{self, Report, check_history},
    question::{Misfit, names_exist},
};

use super::{
    ExplainAnswer, ExplainRequest, Layer, Part,
    ask::{Ask, any},
    changed::{ChangedWorld, asked, counting},
    fitting::FittingQuestion,
    own_plan::OwnPlanReport,
    reasons,
    telling::{Reporter, tell_best, tell_nearby, tell_verdict},
    whole::WholePlan,
    words,
};
use crate::{
    Host, ProvedBest, Refusal, Status,
    budget::Budget,
    problem::Relaxed,
    solve::{self, SolveTask, Solved},
};

/// Answers a question, and tells the host of every part.
///
/// # Errors
/// Where the scene, the plan, the changes or the question is wrong.
pub(crate) fn explain(request: &ExplainRequest, host: &dyn Host) -> Result<ExplainAnswer, Refusal> {
    let mut instance =
        Instance::new(request.scene.clone()).map_err(|faults| Refusal::Scene { faults })?;
    if let Some(objective) = &request.objective {
        instance = instance.with_objective(objective.clone());
    }
    let budget = Rc::new(Budget::new(host, request.limits));
    let Some(changes) = counting(request.changes.as_ref(), request.at) else {
        let asked = PlanQuestion {
            instance: with_penalty(instance),
            plan: request.plan.clone(),
            question: request.question.clone(),
            within: request.within,
            whole: WholePlan::default(),
            layers: &request.layers,
            proved: request.proved.as_ref(),
            known: request.known.as_ref(),
        };
        return answered(&asked, &budget, host);
    };
    let world = ChangedWorld::new(&instance, &changes, request.plan.as_ref())?;
    let solvable = !matches!(request.question, Question::Unsolvable);
    if solvable {
        let report = check_history(&world.after, &world.plan);
        if !report.is_valid() && matches!(request.question, Question::Plan) {
            let in_force = with_penalty(world.snapshot(&instance).instance);
            return Ok(broken(report, in_force.objective(), &budget));
        }
        if !report.is_valid() {
            let violations = report.violations;
            return Err(Refusal::Plan { violations });
        }
    }
    let snapshot = world.snapshot(&instance);
    let mut instance = snapshot.instance.clone();
    let (question, within) = asked(request, &snapshot, &mut instance)?;
    let asked = PlanQuestion {
        instance: with_penalty(instance),
        plan: solvable.then(|| snapshot.rest()),
        question,
        within,
        whole: WholePlan {
            running: Some((&snapshot, &request.question)),
        },
        layers: &request.layers,
        // The claim is about the plan without changes.
        proved: None,
        known: None,
    };
    answered(&asked, &budget, host)
}

/// An instance with its objective as it is in force.
fn with_penalty(instance: Instance) -> Instance {
    let in_force = instance.in_force(instance.objective().clone());
    instance.with_objective(in_force)
}

/// A question about an instance and its plan.
struct PlanQuestion<'a> {
    instance: Instance,
    /// The plan that is asked about; `None` where none was given, or the
    /// question is why there is none.
    plan: Option<Plan>,
    question: Question,
    /// The horizon, where a person set one.
    within: Option<u32>,
    whole: WholePlan<'a>,
    /// The layers that the answer has; those of a request without layers where there are none.
    layers: &'a [Layer],
    /// What is proved already: that no plan is better.
    proved: Option<&'a ProvedBest>,
    /// A plan that may be as asked for.
    known: Option<&'a Plan>,
}

/// The answer for a plan that breaks rules while the world changes.
fn broken(report: Report, objective: &Objective, budget: &Rc<Budget>) -> ExplainAnswer {
    let costs = report.costs.unwrap_or_default();
    let judged = OwnPlanReport::new(report.violations, report.costs);
    ExplainAnswer {
        costs: report.costs,
        valid: Some(false),
        words: words::own_plan(&judged, objective, &costs, None, None),
        violations: Some(judged.violations),
        stats: budget.stats(),
        ..ExplainAnswer::empty(&Question::Plan)
    }
}

/// The answer to what is asked.
fn answered(
    asked: &PlanQuestion,
    budget: &Rc<Budget>,
    host: &dyn Host,
) -> Result<ExplainAnswer, Refusal> {
    let PlanQuestion {
        instance,
        plan,
        question,
        within,
        whole,
        layers,
        proved,
        known,
    } = asked;
    let (within, whole) = (*within, *whole);
    let costs = plan.as_ref();
    let costs = costs.and_then(|plan| whole.costs_of(instance, plan));
    let telling = Reporter {
        budget,
        host,
        whole,
        costs,
    };
    let refused = |misfit| Refusal::Question { misfit };
    names_exist(whole.asked(question), instance).map_err(refused)?;
    let mut answer = ExplainAnswer::empty(question);
    if matches!(question, Question::Unsolvable) {
        no_plan(instance, within, layers, &mut answer, &telling)?;
        return Ok(whole.answer(answer, costs));
    }
    let solved = match plan {
        Some(_) => None,
        None => Some(solved(instance, within, budget)?),
    };
    let best = solved.as_ref().and_then(|it| it.answer.plan.clone());
    let Some(plan) = plan.clone().or_else(|| best.clone()) else {
        answer.words.push_str(tr!(
            "The search ended before there was a plan to ask about."
        ));
        answer.stats = budget.stats();
        return Ok(answer);
    };
    if matches!(question, Question::Plan) {
        reasons::of_own_plan(instance, &plan, within, whole, &mut answer, budget);
        answer.plan = best;
        answer.stats = budget.stats();
        return Ok(whole.answer(answer, costs));
    }
    let violations = whole.check(instance, &plan);
    let Some(costs) = check::costs(instance, &plan).filter(|_| violations.is_empty()) else {
        return Err(Refusal::Plan { violations });
    };
    whole.fits(question, instance, &plan).map_err(refused)?;
    answer.plan = best;
    let mut case = FittingQuestion::new(instance, question, &plan, costs, within, whole);
    (case.optimal, case.latest) = match (solved, proved) {
        (Some(solved), _) => (solved.reach, solved.latest),
        (None, Some(proved)) => proved.handed_on(),
        (None, None) => (None, None),
    };
    if let Some(plan) = known {
        case.hand_on(plan);
    }
    answer.pending = Layer::parts(layers);
    tell_nearby(&case, &mut answer, &telling);
    if answer.pending.contains(&Part::Verdict) {
        tell_verdict(&mut case, &mut answer, &telling);
    }
    let mut about = String::new();
    if answer.pending.contains(&Part::Witness) {
        about = reasons::of_case(&case, &mut answer, budget, &mut |answer, part| {
            telling.tell(answer, part);
        });
    }
    if case.open.is_some() {
        tell_best(&mut case, &about, &mut answer, &telling);
    }
    answer.stats = budget.stats();
    Ok(whole.answer(answer, telling.costs))
}

/// Why there is no plan.
fn no_plan(
    instance: &Instance,
    within: Option<u32>,
    layers: &[Layer],
    answer: &mut ExplainAnswer,
    telling: &Reporter,
) -> Result<(), Refusal> {
    let found = any(
        &Ask {
            instance,
            relaxed: &Relaxed::default(),
            conditions: &[],
            objective: instance.objective(),
            caps: &BTreeMap::new(),
            within,
            at_least_within: 0,
        },
        telling.budget,
    );
    if let (Some(costs), Some(plan)) = (found.costs, &found.plan) {
        let costs = telling.whole.costs(costs, plan);
        let misfit = Misfit::NotSo {
            is_so: tr!(
                "There is a plan, with a makespan of {makespan}.",
                makespan = costs.makespan
            ),
            ask: Some(Question::Makespan),
        };
        return Err(Refusal::Question { misfit });
    }
    if found.status == Status::Unknown {
        answer.words.push_str(tr!(
            "The search ended early. There may be a plan; none was found yet."
        ));
        answer.stats = telling.budget.stats();
        return Ok(());
    }
    // Without a plan there is nothing to show, and none is near.
    answer.pending = Layer::parts(layers);
    let needs_plan = [Part::Here, Part::Near, Part::Closest];
    answer.pending.retain(|part| !needs_plan.contains(part));
    let tell = &mut |answer: &mut ExplainAnswer, part| telling.tell(answer, part);
    let (whole, budget) = (telling.whole, telling.budget);
    reasons::of_no_plan(instance, within, &found, whole, answer, budget, tell);
    Ok(())
}

/// The plan that is asked about, where none was given: the best one.
pub(crate) fn solved(
    instance: &Instance,
    within: Option<u32>,
    budget: &Rc<Budget>,
) -> Result<Solved, Refusal> {
    let task = SolveTask {
        instance: instance.clone(),
        objective: instance.objective().clone(),
        within,
        start: None,
        as_found: false,
        budget: Rc::clone(budget),
    };
    let solved = solve::solve(&task);
    if solved.answer.status == Status::Impossible {
        let misfit = Misfit::NotSo {
            is_so: match solved.answer.reach.within() {
                None => tr!("There is no plan to ask about.").to_owned(),
                Some(n) => tr!("There is no plan of makespan at most {n} to ask about.", n),
            },
            ask: Some(Question::Unsolvable),
        };
        return Err(Refusal::Question { misfit });
    }
    Ok(solved)
}
