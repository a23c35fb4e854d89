//! The first layers of an answer about a plan, each told to the host as soon as it is there: what
//! the plan shows, what is near, the verdict, and the closest other plan.

use std::rc::Rc;

use giveway_model::{Costs, check};

use super::{
    ExplainAnswer, Part, Verdict,
    closest::closest,
    fitting::FittingQuestion,
    here::here,
    how::{differences, how},
    near::near,
    reasons,
    verdict::{Compared, StillOpen, compare, compare_all_costs},
    whole::WholePlan,
    words,
};
use crate::{Host, Progress, budget::Budget, search::Proved};

/// What the plan shows, and small variations of it, where these layers are asked for.
pub(super) fn tell_nearby(case: &FittingQuestion, answer: &mut ExplainAnswer, telling: &Reporter) {
    if answer.pending.contains(&Part::Here) {
        answer.here = here(case, telling.budget);
        words::nearby(answer);
        telling.tell(answer, Part::Here);
    }
    if answer.pending.contains(&Part::Near) {
        near(case, telling.budget, &mut |near, best| {
            answer.near = Some(near);
            if let Some((plan, costs)) = best {
                (answer.alternative, answer.costs) = (Some(plan), Some(costs));
                answer.deltas = case.deltas(&costs);
                compare_agents(case, answer);
            }
            words::nearby(answer);
            telling.tell_more(answer);
        });
        telling.tell(answer, Part::Near);
    }
}

/// The verdict with an other plan.
pub(super) fn tell_verdict(
    case: &mut FittingQuestion,
    answer: &mut ExplainAnswer,
    telling: &Reporter,
) {
    let near = answer.alternative.take().zip(answer.costs.take());
    let compared = compare(case, case.cheapest_known(near), telling.budget);
    let (is_proved, closest) = (compared.reach.is_some(), compared.closest);
    case.open = compared.open;
    if case.open.is_some() && answer.pending.contains(&Part::Closest) {
        // The best other plan comes last: what is pending stands in the order in which it comes.
        answer.pending.retain(|&part| part != Part::Closest);
        answer.pending.push(Part::Closest);
    }
    take(case, compared, answer);
    reasons::word(case, "", answer);
    telling.tell(answer, Part::Verdict);
    if case.open.is_some() {
        return;
    }
    if let Some(is_closest) = closest {
        answer.closest = is_closest;
    } else if is_proved {
        tell_closest(case, "", answer, telling);
    }
    telling.tell(answer, Part::Closest);
}

/// The best other plan, where the verdict was told without it, and the closest of these; `about`
/// is whom the witness is about.
pub(super) fn tell_best(
    case: &mut FittingQuestion,
    about: &str,
    answer: &mut ExplainAnswer,
    telling: &Reporter,
) {
    let known = answer.alternative.clone().zip(answer.costs);
    let least = case.open.and_then(StillOpen::optima);
    let compared = compare_all_costs(case, known, least.as_ref(), telling.budget);
    let covers = |reach: Proved| case.shown.is_none_or(|shown| reach.covers(shown));
    if compared.verdict == answer.verdict && compared.reach.is_some_and(covers) {
        take(case, compared, answer);
        case.open = None;
        reasons::word(case, about, answer);
        telling.tell_more(answer);
        tell_closest(case, about, answer, telling);
    } else if let Some((plan, costs)) = compared.other {
        answer.deltas = case.deltas(&costs);
        (answer.alternative, answer.costs) = (Some(plan), Some(costs));
        compare_agents(case, answer);
        reasons::word(case, about, answer);
    }
    telling.tell(answer, Part::Closest);
}

/// Takes a verdict over into the answer.
fn take(case: &mut FittingQuestion, compared: Compared, answer: &mut ExplainAnswer) {
    answer.verdict = compared.verdict;
    let is_bound = |open: StillOpen| open.least.is_none();
    answer.at_most = compared.verdict == Verdict::Costly && compared.open.is_some_and(is_bound);
    answer.deltas = compared.deltas;
    case.shown = compared.reach;
    answer.reach = compared.reach.into();
    let (alternative, costs) = compared.other.unzip();
    (answer.alternative, answer.costs) = (alternative, costs);
    (answer.pays, answer.how) = (Vec::new(), Vec::new());
    compare_agents(case, answer);
}

/// How the other plan that is at hand differs.
fn compare_agents(case: &FittingQuestion, answer: &mut ExplainAnswer) {
    let Some(other) = &answer.alternative else {
        return;
    };
    let plans = (case.plan, other);
    answer.pays = differences(case.instance, plans, case.whole);
    answer.how = match answer.verdict {
        Verdict::Needless => how(case.question, case.instance, plans, &answer.pays),
        Verdict::Improvable | Verdict::Costly | Verdict::Necessary | Verdict::Unknown => Vec::new(),
    };
}

/// The closest other plan, where the one at hand is proved best.
fn tell_closest(
    case: &FittingQuestion,
    about: &str,
    answer: &mut ExplainAnswer,
    telling: &Reporter,
) {
    if let (Some(other), Some(costs)) = (&answer.alternative, answer.costs) {
        let (plan, proved) = closest(case, (other, costs), telling.budget);
        answer.costs = check::costs(case.instance, &plan);
        answer.alternative = Some(plan);
        answer.closest = proved;
        compare_agents(case, answer);
        reasons::word(case, about, answer);
    }
}

/// Sends each part of the answer to the host.
pub(super) struct Reporter<'a, 'h> {
    pub(super) budget: &'a Rc<Budget<'h>>,
    pub(super) host: &'a dyn Host,
    pub(super) whole: WholePlan<'a>,
    /// The costs of the whole plan that is asked about.
    pub(super) costs: Option<Costs>,
}

impl Reporter<'_, '_> {
    /// Tells that a part of the answer is there.
    pub(super) fn tell(&self, answer: &mut ExplainAnswer, part: Part) {
        let is_first = answer.pending.contains(&part);
        answer.pending.retain(|&pending| pending != part);
        // It takes a while until it is known which facts of a reason help.
        let has_reason = part == Part::Core && is_first && answer.core.is_some();
        if has_reason || !answer.pending.is_empty() {
            self.tell_more(answer);
        }
    }

    /// Tells that more of a part is there.
    fn tell_more(&self, answer: &mut ExplainAnswer) {
        answer.stats = self.budget.stats();
        let answer = Box::new(self.whole.answer(answer.clone(), self.costs));
        self.host.progress(&Progress::Explained { answer });
    }
}
