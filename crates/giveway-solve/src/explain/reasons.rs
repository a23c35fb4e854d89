//! The parts of an answer that say why, in their order, each with limits of its
//! own: what would happen, what together makes it impossible, what would help.

use std::rc::Rc;

use giveway_model::{Cost, Costs, Instance, Plan, sorting};

mod small;

use super::{
    ExplainAnswer, Part, Verdict, WitnessEntry,
    ask::Found,
    causes::Refuted,
    contrasted::ContrastSearch,
    group::Group,
    group_mus::CoreFound,
    own_plan::{OwnPlanReport, judge},
    own_way,
    repairs::{Unsolved, repairs},
    unsolvable::{self, AnyPlan},
    verdict::FittingQuestion,
    whole::WholePlan,
    words,
};
use crate::{Limits, Status, budget::Budget, search::Proved};

/// Clauses that one part may derive and write, and joint steps that it may take.
const DERIVED: u64 = 15_000;
const CLAUSES: u64 = 1_200_000;
const JOINT_STEPS: u64 = 600_000;
/// The share of the remaining seconds, and of the remaining work, for one part.
const SHARE: f64 = 0.4;

/// So many times the work of another part may go into repairs: they are a person's next
/// step, and the least battery that helps takes long searches.
const REPAIRS: u64 = 6;

/// The budget of one part.
fn part<'h>(budget: &Budget<'h>) -> Rc<Budget<'h>> {
    part_of(budget, 1)
}

/// The budget of a part that may do so many times the work of another.
fn part_of<'h>(budget: &Budget<'h>, times: u64) -> Rc<Budget<'h>> {
    let limits = Limits {
        seconds: budget.seconds_left().map(|seconds| seconds * SHARE),
        work: budget.work_left().map(|work| work / 5 * 2),
        ..Limits::default()
    };
    Rc::new(
        budget
            .part(limits)
            .with_derived(DERIVED * times)
            .with_work(CLAUSES * times, JOINT_STEPS * times),
    )
}

/// Called when a part of the answer is there.
pub(crate) type Tell<'a> = &'a mut dyn FnMut(&mut ExplainAnswer, Part);

/// Why, where the verdict is known.
pub(crate) fn of_case(
    case: &FittingQuestion,
    answer: &mut ExplainAnswer,
    budget: &Rc<Budget>,
    tell: Tell,
) {
    let mut about = String::new();
    let own = part(budget);
    if let Some((agent, violations)) = own_way::witness(case, &own) {
        about = agent;
        let entries = violations.into_iter().map(|violation| WitnessEntry {
            violation,
            class: None,
        });
        answer.witness = entries.collect();
    }
    budget.absorb(&own);
    word(case, &about, answer);
    tell(answer, Part::Witness);

    let refuted = matches!(answer.verdict, Verdict::Necessary | Verdict::Costly);
    if refuted {
        let found = small::reason_of_case(case, answer, budget);
        answer.alone = found.alone;
        let core = found.core;
        let deadline = case.within.map(|time| case.whole.time(time));
        answer.core = core.as_ref().map(|core| core.core(case.instance, deadline));
        word(case, &about, answer);
        tell(answer, Part::Core);
        if let Some(core) = &core
            && answer.pending.contains(&Part::Repairs)
        {
            help_case(case, core, answer, budget);
            word(case, &about, answer);
        }
    } else {
        tell(answer, Part::Core);
    }
    tell(answer, Part::Repairs);
}

/// The answer in words, as far as it is known; `about` is whom the witness is about.
pub(crate) fn word(case: &FittingQuestion, about: &str, answer: &mut ExplainAnswer) {
    answer.words = words::verdict(&words::KnownSoFar {
        instance: case.instance,
        question: case.question,
        objective: case.objective(),
        plan: case.plan,
        verdict: answer.verdict,
        alternative: answer.alternative.as_ref(),
        within: answer.reach.within().map(|time| case.whole.time(time)),
        whole: case.whole,
        witness: (about, &answer.witness),
        core: answer.core.as_ref(),
        alone: &answer.alone,
        repairs: &case.whole.repairs(&answer.repairs),
    });
}

/// The agents that are never left out.
fn asked(case: &FittingQuestion) -> Vec<usize> {
    let agents = case.instance.agents().iter();
    let asked = |name: &str| case.question.agent() == Some(name);
    let asked = agents.enumerate().filter(|(_, agent)| asked(&agent.name));
    asked.map(|(index, _)| index).collect()
}

/// Whether what is asked for could be done by an agent of which the facts say
/// nothing. Then an edit may help it that weakens none of the facts.
fn another_could(case: &FittingQuestion, facts: &[Group]) -> bool {
    let agents = case.instance.agents().iter().enumerate();
    let mut unsaid = agents.filter(|(index, _)| !facts.contains(&Group::Task(*index)));
    unsaid.any(|(_, agent)| {
        let mut conditions = case.conditions();
        let could = conditions.any(|condition| condition.agent() == Some(&agent.name));
        could && case.question.agent() != Some(&agent.name)
    })
}

/// The search for what would contradict the verdict, with one part's budget.
fn contrasted<'a, 'h>(
    case: &'a FittingQuestion<'a>,
    answer: &'a ExplainAnswer,
    budget: &Rc<Budget<'h>>,
) -> ContrastSearch<'a, 'h> {
    let costly = answer.verdict == Verdict::Costly;
    ContrastSearch {
        case,
        most: costly.then(|| case.costs.vector(case.objective())),
        near: answer.alternative.as_ref().filter(|_| costly),
        horizon: answer.reach.within().unwrap_or(case.costs.makespan),
        budget: part(budget),
    }
}

fn help_case(
    case: &FittingQuestion,
    core: &CoreFound,
    answer: &mut ExplainAnswer,
    budget: &Rc<Budget>,
) {
    let Some(reach) = case.shown else { return };
    let asked = asked(case);
    let mut inquiry = ContrastSearch {
        budget: part_of(budget, REPAIRS),
        ..contrasted(case, answer, budget)
    };
    let broken = Unsolved {
        instance: case.instance,
        within: case.within,
        objective: case.objective(),
        asked: &asked,
        reach,
        cores: core.sets().map(<[Group]>::to_vec).collect(),
        whole: case.whole,
    };
    let found = repairs(&broken, &mut inquiry);
    budget.absorb(&inquiry.budget);
    answer.exhaustive = found.exhaustive && !another_could(case, &core.groups);
    (answer.repairs, answer.further_repairs) = (found.first, found.further);
}

/// Why there is no plan, where `found` says so.
pub(crate) fn of_no_plan(
    instance: &Instance,
    within: Option<u32>,
    found: &Found,
    whole: WholePlan,
    answer: &mut ExplainAnswer,
    budget: &Rc<Budget>,
    tell: Tell,
) {
    answer.verdict = Verdict::Necessary;
    answer.reach = found.reach.into();
    tell_no_plan(answer, whole, Part::Verdict, tell);
    if !answer.pending.contains(&Part::Witness) {
        return;
    }
    let searching = |times| AnyPlan {
        objective: instance.objective(),
        horizon: found.horizon,
        budget: part_of(budget, times),
        whole,
    };
    let mut any_plan = searching(1);
    (answer.witness, _) = unsolvable::witness(instance, within, &mut any_plan);
    budget.absorb(&any_plan.budget);
    tell_no_plan(answer, whole, Part::Witness, tell);

    let core = found.reach.and_then(|reach| {
        let refuted = Refuted {
            instance,
            asked: &[],
            deadline: within,
            reach,
        };
        small::reason_of_no_plan(&refuted, found, searching, budget)
    });
    let deadline = within.map(|time| whole.time(time));
    answer.core = core.as_ref().map(|core| core.core(instance, deadline));
    tell_no_plan(answer, whole, Part::Core, tell);

    let help = answer.pending.contains(&Part::Repairs);
    let helped = core.as_ref().zip(found.reach).filter(|_| help);
    if let Some((core, reach)) = helped {
        let mut any_plan = searching(REPAIRS);
        let broken = Unsolved {
            instance,
            within,
            objective: instance.objective(),
            asked: &[],
            reach,
            cores: core.sets().map(<[Group]>::to_vec).collect(),
            whole,
        };
        let found = repairs(&broken, &mut any_plan);
        budget.absorb(&any_plan.budget);
        answer.exhaustive = found.exhaustive;
        (answer.repairs, answer.further_repairs) = (found.first, found.further);
    }
    tell_no_plan(answer, whole, Part::Repairs, tell);
}

fn tell_no_plan(answer: &mut ExplainAnswer, whole: WholePlan, part: Part, tell: Tell) {
    answer.words = words::unsolvable(
        answer.reach.within().map(|time| whole.time(time)),
        &answer.witness,
        answer.core.as_ref(),
        &whole.repairs(&answer.repairs),
    );
    tell(answer, part);
}

/// The findings about a person's own plan.
pub(crate) fn of_own_plan(
    instance: &Instance,
    plan: &Plan,
    within: Option<u32>,
    whole: WholePlan,
    answer: &mut ExplainAnswer,
    budget: &Rc<Budget>,
) {
    let objective = instance.objective();
    let judged: OwnPlanReport = judge(instance, plan, objective, within, whole, budget);
    let costs_of = |plan: &Plan| whole.costs_of(instance, plan).unwrap_or_default();
    let better = judged.better.as_ref().map(|(better, _)| costs_of(better));
    let reach = judged.found.as_ref().and_then(|found| found.reach);
    let latest = reach.and_then(Proved::within).map(|time| whole.time(time));
    let costs = costs_of(plan);
    answer.words = words::own_plan(&judged, objective, &costs, better.as_ref(), latest);
    answer.valid = Some(judged.violations.is_empty());
    answer.optimal = judged.optimal;
    answer.violations = Some(judged.violations);
    answer.verdict = match judged.optimal {
        Some(true) => Verdict::Needless,
        Some(false) => Verdict::Improvable,
        None => Verdict::Unknown,
    };
    answer.excess = judged.excess;
    if let Some(found) = &judged.found {
        let proved = found.status == Status::Optimal;
        answer.reach = found.reach.filter(|_| proved).into();
    }
    let own = judged.costs.filter(|_| answer.valid == Some(true));
    let least: Option<Costs> = judged.better.as_ref().map(|(_, costs)| *costs).or(own);
    if let (Some(least), Some(own)) = (least, own) {
        let more = |cost: Cost| i64::from(least.get(cost)) - i64::from(own.get(cost));
        let costs = objective.costs().iter();
        answer.deltas = sorting::map(costs.map(|&cost| (cost, more(cost))));
    }
    answer.costs = least.or(judged.costs);
    answer.alternative = judged.better.map(|(plan, _)| plan);
}
