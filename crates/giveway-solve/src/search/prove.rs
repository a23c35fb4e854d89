//! The proof that no plan is better: the optima of all costs, one stage each.

use std::rc::Rc;

use giveway_model::{Cost, sorting};

use super::{
    aim::{Aim, Bounded, Verdict},
    bound::Bound,
    counting::Counting,
    deadlines::Keeping,
    earlier::EarlierOptima,
    for_ever::{self, ForEver, Least, LeastForEver, NoPlan, OfOptima},
    incumbent::Incumbent,
    latest::LatestArrivals,
    makespan,
    stage::{End, Search, Subject},
    sum::SumStage,
};
use crate::{
    Limits,
    budget::{Budget, Stop},
    joint,
    problem::Problem,
    trace::{Restart, SearchEvent},
    walk::Walk,
};

/// The fixed input of a search.
#[derive(Clone, Copy)]
pub(super) struct SearchInput<'a, 'h> {
    pub(super) problem: &'a Problem,
    pub(super) bounded: &'a Bounded,
    pub(super) aim: &'a Aim,
    pub(super) earlier: Option<&'a EarlierOptima>,
    pub(super) budget: &'a Rc<Budget<'h>>,
}

/// How a search ended.
#[derive(Clone, Copy, Debug)]
pub(super) enum SearchEnd {
    /// No more than the plan at hand, which is all that was looked for.
    Plan,
    /// There is no plan: within the horizon, or at any by this token.
    NoPlan(Option<ForEver<NoPlan>>),
    /// No plan is better than the one at hand, likewise.
    Best(Option<ForEver<Least>>),
}

/// Whether the plan at hand already meets the aim, so that nothing is left to prove.
pub(super) fn is_met(aim: &Aim, incumbent: &Incumbent) -> bool {
    let vector = incumbent.costs().map(|c| c.vector(incumbent.objective()));
    vector.is_some_and(|vector| aim.is_met(&vector))
}

/// The optima of all costs, one after the other.
pub(super) fn prove(
    given: SearchInput,
    walks: &[Walk],
    incumbent: &mut Incumbent,
    verdict: &mut Verdict,
) -> Result<SearchEnd, Stop> {
    let by_sat = |given: SearchInput, incumbent: &mut Incumbent, verdict: &mut Verdict| {
        prove_by_sat(given, walks, incumbent, verdict)
    };
    or_exhausted(given, incumbent, verdict, by_sat, |shown| shown)
}

/// The proof by SAT. Where that is hard and there are few joint states, these are exhausted instead: they
/// give the best plan, so that nothing is left to prove.
pub(super) fn or_exhausted<T>(
    given: SearchInput,
    incumbent: &mut Incumbent,
    verdict: &mut Verdict,
    by_sat: impl Fn(SearchInput, &mut Incumbent, &mut Verdict) -> Result<T, Stop>,
    all_shown: impl FnOnce(SearchEnd) -> T,
) -> Result<T, Stop> {
    let SearchInput {
        problem, budget, ..
    } = given;
    if !joint::is_rather_small(problem, budget)? {
        return by_sat(given, incumbent, verdict);
    }
    let patience = Limits {
        conflicts: Some(budget.thresholds().patience),
        ..Limits::default()
    };
    let most = budget.thresholds().patience_clauses;
    // Where little may be derived, half of it is left for what comes after.
    let part = Rc::new(
        budget
            .part(patience)
            .with_derived(budget.derived_left() / 2)
            .with_clauses(most.min(budget.clauses_left() / 2)),
    );
    let patient = SearchInput {
        budget: &part,
        ..given
    };
    let shown = by_sat(patient, incumbent, verdict);
    budget.absorb(&part);
    if !matches!(shown, Err(Stop::Conflicts)) {
        return shown;
    }
    budget.check()?;
    if let Some(optima) = for_ever::best(problem, given.bounded, incumbent, budget)? {
        verdict.bounds = optima.bounds;
        let bounds = verdict.bounds.clone();
        budget.record(|_| SearchEvent::Exhausted { bounds });
        return Ok(all_shown(match incumbent.costs() {
            Some(_) => SearchEnd::Best(optima.reason.map(ForEver::from)),
            None => SearchEnd::NoPlan(optima.reason.map(ForEver::from)),
        }));
    }
    let why = Restart::MoreTime;
    budget.record(|_| SearchEvent::Restarted { why });
    by_sat(given, incumbent, verdict)
}

/// The stages, one for each cost of the objective.
fn prove_by_sat(
    given: SearchInput,
    walks: &[Walk],
    incumbent: &mut Incumbent,
    verdict: &mut Verdict,
) -> Result<SearchEnd, Stop> {
    let SearchInput {
        problem,
        bounded,
        budget,
        ..
    } = given;
    if let Some((cost, known)) = for_ever::known_for_ever(problem, bounded, incumbent, budget)? {
        let bounds = sorting::map([(cost, known.least)]);
        budget.record(|_| SearchEvent::Exhausted { bounds });
        let mut limited = bounded.clone();
        limited.limits.insert(cost, known.least);
        let limited = SearchInput {
            bounded: &limited,
            ..given
        };
        if let Some(shown) = stages(limited, walks, Some(known), incumbent, verdict)? {
            return Ok(shown);
        }
        // Its plans all need more time than the horizon allows.
        verdict.bounds.clear();
        verdict.latest = None;
        let why = Restart::Horizon;
        budget.record(|_| SearchEvent::Restarted { why });
    }
    let shown = stages(given, walks, None, incumbent, verdict)?;
    shown.ok_or(Stop::Contradiction) // a plan is at hand, so there is one
}

/// One stage after the other; `None` where there is no plan. The optimum of the
/// first cost may be `known`, and a limit.
fn stages(
    given: SearchInput,
    walks: &[Walk],
    mut known: Option<LeastForEver>,
    incumbent: &mut Incumbent,
    verdict: &mut Verdict,
) -> Result<Option<SearchEnd>, Stop> {
    let SearchInput {
        problem, bounded, ..
    } = given;
    let objective = incumbent.objective().clone();
    let subject = Subject {
        problem,
        walks,
        bounded,
    };
    let budget = Rc::clone(given.budget);
    let mut search = Search::new(subject, Keeping::Hard, incumbent, budget);
    search.keep_limits(bounded)?;
    let mut for_ever = OfOptima::new(problem, bounded);
    let mut optima = Vec::new();
    let mut counting = None;
    for (i, &cost) in objective.costs().iter().enumerate() {
        let known = known.take();
        let last = i + 1 == objective.costs().len();
        let mut bound = Bound::new(cost, search.team.lone_bound(cost)?);
        let mut counted = None;
        let earlier = given.earlier;
        let earlier = earlier.and_then(|earlier| earlier.next(&optima));
        if let Some(earlier) = earlier {
            bound.take_earlier(earlier);
        }
        if bound.met(&search).is_none() {
            let within = search.claim.optima().get(&Cost::Makespan);
            let within = within.or(bounded.limits.get(&Cost::Makespan)).copied();
            let counting = match &mut counting {
                Some(counting) => counting,
                counting => counting.insert(Counting::of(problem, &search.budget)?),
            };
            if let Some((shown, bottleneck)) = counting.bound(problem, cost, within) {
                bound.take_counted(shown);
                search.tell_counted(bound, bottleneck);
                verdict.bounds.insert(cost, bound.at_least());
                search.approach(bound, bottleneck.orders(cost, within))?;
                counted = Some(shown);
            }
        }
        let end = if cost == Cost::Makespan {
            makespan::run(&mut search, &mut bound)
        } else {
            SumStage::run(&mut search, &mut bound, known, last)
        };
        verdict.bounds.insert(cost, bound.at_least());
        let End::Least(optimum) = end? else {
            return Ok(None);
        };
        search.claim.finish(optimum);
        if !last {
            search.tell_met();
        }
        if i == 0 && cost == Cost::Makespan {
            search = search.afresh(optimum, walks);
            search.keep_limits(bounded)?;
        }
        let counted = counted.and_then(|counted| counted.shows(cost, optimum.least()));
        let known = known.map(|known| known.reason);
        let known = known.or(counted.map(ForEver::from));
        let earlier = earlier.and_then(|earlier| earlier.shows(optimum.least()));
        let known = known.or(earlier.map(ForEver::from));
        for_ever.and(&mut search, optimum, known, bounded)?;
        // (The stage of the last cost excludes plans that are no better than the best one.)
        if cost == Cost::SumOfCosts && !last {
            verdict.latest = LatestArrivals::left_by(&search, optimum, bounded.horizon);
        }
        optima.push(optimum.least());
        if given.aim.is_missed(&optima) || is_met(given.aim, search.incumbent) {
            break;
        }
    }
    Ok(Some(SearchEnd::Best(for_ever.reason())))
}
