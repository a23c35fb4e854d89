//! How a rule can be loosened so that something changes, while it is looked for and afterwards.

use std::rc::Rc;

use giveway_model::{Agent, Cost, Instance, tr};
use giveway_solve::price::{LooserRule, PriceAnswer, PriceRequest, words};

use super::card::plain;
use super::{pieces, request};
use crate::{Draft, State, Task};

/// How a rule of a scene can be loosened, as far as it is known.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Loosening {
    /// The scene whose rule it is.
    pub(crate) draft: Rc<Draft>,
    /// The rule, by its index in the scene.
    pub(crate) rule: usize,
    /// What was answered so far.
    pub(crate) told: Option<Rc<PriceAnswer>>,
}

/// How a rule can be loosened, as its row shows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LooserPart {
    /// Whether it is still being looked for.
    pub is_looking: bool,
    /// The looser rules that can be taken, each the least of its way.
    pub looser: Vec<LooserRow>,
    /// Why there is none, once that is known.
    pub nothing: Option<&'static str>,
}

/// A looser rule that can be taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LooserRow {
    /// Its sentence.
    pub sentence: String,
    /// What the best plan under it costs.
    pub costs: String,
    /// What that saves: `\u{2212}2 steps`; nothing where there is no plan with the rule as it is.
    pub saves: Option<String>,
    /// Whether no plan under it is better, and nothing tighter changes anything.
    pub is_proved: bool,
    /// What is open, where it is not.
    pub open: Option<&'static str>,
}

/// What is asked of the solver.
pub(crate) fn loosen_request(state: &State, rule: usize) -> PriceRequest {
    PriceRequest {
        loosen: Some(rule as u32),
        ..request(state)
    }
}

/// Whether a rule has a number or times, so that it can ask for less.
pub(crate) fn can_loosen(rule: &giveway_model::Constraint) -> bool {
    // Which times end is asked, not when they do.
    !rule.off && !rule.kind.looser_ways(0).is_empty()
}

/// The looser rule of so many found, with the rule that it takes the place of.
pub(crate) fn looser(state: &State, place: usize) -> Option<(usize, &LooserRule)> {
    let loosening = state.loosening()?;
    let told = loosening.told.as_deref()?.loosened.as_ref()?;
    Some((loosening.rule, told.looser.get(place)?))
}

impl State {
    /// What is known of how a rule of the scene on the board can be loosened.
    pub(crate) fn loosening(&self) -> Option<&Loosening> {
        let loosening = self.view.rules.loosening.as_deref();
        let draft = &self.document.draft;
        loosening.filter(|it| Rc::ptr_eq(&it.draft, draft) || it.draft == *draft)
    }

    /// The rule of which it is looked for how it can be loosened.
    pub(crate) fn loosens_rule(&self) -> Option<usize> {
        match self.work.task() {
            Some(Task::Price(_, request)) => request.loosen.map(|rule| rule as usize),
            Some(_) | None => None,
        }
    }
}

/// How a rule can be loosened; nothing where nobody asked.
pub(super) fn part(state: &State, rule: usize) -> Option<LooserPart> {
    let loosening = state.loosening().filter(|it| it.rule == rule)?;
    let is_looking = state.loosens_rule() == Some(rule);
    let told = loosening.told.as_deref();
    let found = told.and_then(|told| Some((told, told.loosened.as_ref()?)));
    let Some((told, found)) = found else {
        return is_looking.then_some(LooserPart {
            is_looking,
            looser: Vec::new(),
            nothing: None,
        });
    };
    let agents = &state.document.draft.scene().agents;
    let rows = found.looser.iter().map(|looser| row(told, looser, agents));
    Some(LooserPart {
        is_looking,
        looser: rows.collect(),
        nothing: words::nothing_looser(told.status, found),
    })
}

fn row(told: &PriceAnswer, looser: &LooserRule, agents: &[Agent]) -> LooserRow {
    let costs = told.objective.costs().iter();
    let saved = |cost: &Cost| Some((*cost, *looser.difference.get(cost)?));
    let mut saved = costs.filter_map(saved);
    LooserRow {
        sentence: plain(&pieces(&looser.rule, agents, false)),
        costs: words::looser_costs(&told.objective, looser),
        saves: saved
            .find(|(_, by)| *by != 0)
            .map(|(cost, by)| less(cost, by)),
        is_proved: looser.exact && looser.least,
        open: match (looser.least, looser.exact) {
            (true, true) => None,
            (false, _) => Some(tr!("Perhaps less would do.")),
            (true, false) => Some(tr!("There may be a better plan under it.")),
        },
    }
}

/// What is saved of a cost: `\u{2212}2 in the makespan`.
fn less(cost: Cost, by: i64) -> String {
    let n = by.unsigned_abs();
    let cost = giveway_model::words::name(cost);
    format!(
        "\u{2212}{}",
        tr!("what is saved" => "{n} in the {cost}", n, cost)
    )
}

/// The full costs of the best plan under a looser rule.
pub(crate) fn costs(instance: &Instance, looser: &LooserRule) -> Option<giveway_model::Costs> {
    giveway_model::check::check(instance, looser.plan.as_ref()?).costs
}
