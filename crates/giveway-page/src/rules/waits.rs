//! For which rule a robot waits: one that it would break if it went on a step sooner.

use giveway_model::check::{Rule, check};

use super::zone_of;
use crate::State;

/// Among more places in a plan nothing is looked at while it plays.
const PLACES: usize = 200_000;

/// The rules for which a robot waits at a time, by their indices and in words: their zone, or
/// their sentence. They are those that the plan would break, and does not break now, if the
/// robot made the rest of its way a step sooner.
pub fn waits_for(state: &State, agent: usize, time: u32) -> Vec<(usize, String)> {
    let found = || {
        let answer = state.shown().filter(|answer| answer.course.is_none())?;
        let instance = answer.draft.instance().ok()?;
        let name = &answer
            .agents()
            .get(answer.agent(state.world(), agent)?)?
            .name;
        let rules = &answer.draft.scene().constraints;
        if rules.iter().all(|rule| rule.off) {
            return None;
        }
        let mut plan = answer.plan()?.clone();
        if plan.paths.values().map(Vec::len).sum::<usize>() > PLACES {
            return None;
        }
        let path = plan.paths.get_mut(name)?;
        let (now, next) = (time as usize, time as usize + 1);
        let is_wait = path.get(now)?.is_some() && path.get(now) == path.get(next);
        // Once it has arrived there is nothing to do sooner.
        if !is_wait || path.get(next..)?.iter().all(|at| path.get(now) == Some(at)) {
            return None;
        }
        path.remove(now);
        let report = check(instance, &plan);
        let own = report
            .violations
            .iter()
            .filter(|it| it.rule == Rule::Constraint);
        let mut broken: Vec<usize> = own
            .filter_map(|it| Some(it.broken.as_ref()?.index as usize))
            .collect();
        broken.sort_unstable();
        broken.dedup();
        let said = |index: usize| {
            let rule = rules.get(index)?;
            let zone = zone_of(&rule.kind).map(str::to_owned);
            Some((index, zone.unwrap_or_else(|| rule.sentence())))
        };
        Some(broken.into_iter().filter_map(said).collect())
    };
    found().unwrap_or_default()
}
