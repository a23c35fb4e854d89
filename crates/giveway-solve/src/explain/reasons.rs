//! The parts of an answer that say why, in their order, each with limits of its
//! own: what would happen, what together makes it impossible, what would help.

use std::rc::Rc;

use giveway_model::sorting::sort_by_key;

mod no_plan;
mod own_plan;
mod small;

pub(crate) use no_plan::of_no_plan;
pub(crate) use own_plan::of_own_plan;

use super::{
    ExplainAnswer, Part, Verdict, WitnessEntry,
    answer::Helps,
    contrasted::ContrastSearch,
    fact_groups::tell_tightest,
    fitting::FittingQuestion,
    group::Group,
    group_mus::CoreFound,
    own_way,
    repairs::{TriedEdits, Unsolved, repairs, suspects, try_each},
    words,
};
use crate::{Limits, budget::Budget, search::Proved};

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

/// Why, where the verdict is known; whom the witness is about.
pub(crate) fn of_case(
    case: &FittingQuestion,
    answer: &mut ExplainAnswer,
    budget: &Rc<Budget>,
    tell: Tell,
) -> String {
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
        let forcing = small::forcing_set(case, answer, budget);
        if let Some(forcing) = &forcing {
            answer.alone = small::forcing_needs(case, answer, forcing, budget);
            word(case, &about, answer);
            tell(answer, Part::Witness);
        }
        let agents = forcing.as_ref().map(|it| it.agents.clone());
        let found = small::reason_of_case(case, answer, forcing, budget);
        if agents.is_none() {
            answer.alone = found.alone;
        }
        let mut core = found.core;
        if let Some(core) = &mut core {
            core.is_of_another = another_could(case, &core.groups);
            for further in &mut core.further {
                further.is_of_another = another_could(case, &further.groups);
            }
        }
        let deadline = case.within.map(|time| case.whole.time(time));
        let told = |core: &CoreFound| {
            let mut told = core.core(case.instance, deadline);
            if found.is_unmarked {
                tell_tightest(case, &mut told);
            }
            told
        };
        answer.core = core.as_ref().map(told);
        word(case, &about, answer);
        tell(answer, Part::Core);
        let mut tried = TriedEdits::default();
        if let Some(core) = core.as_mut().filter(|_| found.is_unmarked) {
            // First those who decide, so that what is told first is the same whenever the search ends.
            let deciding = agents.iter().flatten().map(|&agent| Group::Task(agent));
            tried = help_of_facts(case, &deciding.collect::<Vec<_>>(), (answer, tried), budget);
            word(case, &about, answer);
            tell(answer, Part::Core);
            let alone = small::needs(case, answer, agents.as_ref(), budget);
            // Where the time ran out, what was told of the set before it stays.
            if !alone.is_empty() {
                answer.alone = alone;
            }
            small::mark_near(case, core, answer, budget);
            answer.core = Some(told(core));
            word(case, &about, answer);
            tell(answer, Part::Core);
            tried = help_of_facts(case, &core.helping(), (answer, tried), budget);
            word(case, &about, answer);
            tell(answer, Part::Core);
            small::mark(case, core, (answer, &tried), budget);
            answer.core = Some(told(core));
            word(case, &about, answer);
            tell(answer, Part::Core);
        }
        if can_help(answer) {
            help_case(case, core.as_ref(), (answer, tried), budget);
            word(case, &about, answer);
        }
    } else {
        tell(answer, Part::Core);
    }
    tell(answer, Part::Repairs);
    about
}

/// The answer in words, as far as it is known; `about` is whom the witness is about.
pub(crate) fn word(case: &FittingQuestion, about: &str, answer: &mut ExplainAnswer) {
    answer.words = words::verdict(&words::KnownSoFar {
        instance: case.instance,
        question: case.question,
        objective: case.objective(),
        plan: case.plan,
        verdict: answer.verdict,
        is_open: case.open.is_some(),
        alternative: answer.alternative.as_ref(),
        within: answer.reach.within().map(|time| case.whole.time(time)),
        whole: case.whole,
        here: answer.here.as_ref(),
        witness: (about, &answer.witness),
        core: answer.core.as_ref(),
        alone: &answer.alone,
        repairs: &case.whole.repairs(&answer.repairs, case.question),
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

/// Whether it is asked what would help.
fn can_help(answer: &ExplainAnswer) -> bool {
    answer.pending.contains(&Part::Repairs)
}

/// Tries to leave out each of these facts, where it is asked what would help.
fn help_of_facts(
    case: &FittingQuestion,
    facts: &[Group],
    (answer, tried): (&mut ExplainAnswer, TriedEdits),
    budget: &Rc<Budget>,
) -> TriedEdits {
    let Some(reach) = case.shown.filter(|_| can_help(answer)) else {
        return tried;
    };
    let asked = asked(case);
    let broken = unsolved(case, (&asked, reach), budget);
    let mut inquiry = helping(case, answer, budget);
    let tried = try_each(&broken, facts, tried, &mut inquiry);
    budget.absorb(&inquiry.budget);
    answer.repairs = tried.repairs(case.objective());
    tried
}

/// The repairs; where no set of facts is known, on a large floor only. Some were tried before.
fn help_case(
    case: &FittingQuestion,
    core: Option<&CoreFound>,
    (answer, tried): (&mut ExplainAnswer, TriedEdits),
    budget: &Rc<Budget>,
) {
    let Some(reach) = case.shown else { return };
    if core.is_none() && !small::is_large(case.instance, budget) {
        return;
    }
    let asked = asked(case);
    let has_deadline = case.within.is_some();
    let suspects = || suspects(case.instance, &asked, has_deadline, (answer, &[]));
    let mut inquiry = helping(case, answer, budget);
    let broken = Unsolved {
        cores: core.map_or_else(Vec::new, |core| {
            let mut sets: Vec<Vec<Group>> = core.sets().map(<[Group]>::to_vec).collect();
            // What is known to help is tried first.
            if let Some(first) = sets.first_mut() {
                sort_by_key(first, |fact| core.helps.get(fact) != Some(&Helps::Yes));
            }
            sets
        }),
        suspects: core.map_or_else(suspects, |_| Vec::new()),
        ..unsolved(case, (&asked, reach), budget)
    };
    let found = repairs(&broken, tried, &mut inquiry);
    budget.absorb(&inquiry.budget);
    let is_of_another = |core: &CoreFound| another_could(case, &core.groups);
    answer.exhaustive = found.exhaustive && !core.is_some_and(is_of_another);
    (answer.repairs, answer.further_repairs) = (found.first, found.further);
}

/// The search for what would help.
fn helping<'a, 'h>(
    case: &'a FittingQuestion<'a>,
    answer: &'a ExplainAnswer,
    budget: &Rc<Budget<'h>>,
) -> ContrastSearch<'a, 'h> {
    ContrastSearch {
        budget: part_of(budget, REPAIRS),
        ..contrasted(case, answer, budget)
    }
}

/// The instance that has no plan as asked for, without sets of facts.
fn unsolved<'a>(
    case: &'a FittingQuestion<'a>,
    (asked, reach): (&'a [usize], Proved),
    budget: &Budget,
) -> Unsolved<'a> {
    Unsolved {
        instance: case.instance,
        is_large: small::is_large(case.instance, budget),
        within: case.within,
        objective: case.objective(),
        plan: Some(case.plan),
        asked,
        arriving: case.question.arriving(),
        charging: case.charging(),
        reach,
        cores: Vec::new(),
        suspects: Vec::new(),
        whole: case.whole,
    }
}
