//! The least looser form of a rule that changes the costs, or with which there is a plan.
//!
//! The less a rule asks for, the more plans keep it, and no cost of the best one rises. So
//! the least that helps is found by doubling and halving; each step is a search of its own.

use std::collections::BTreeMap;

use giveway_model::constraint::LooserWay;
use giveway_model::{Cost, Instance, sorting::map};

use super::compared::{compared, difference};
use super::serve::Pricing;
use super::{Loosened, LooserRule, Price, RulePrice};
use crate::{SolveAnswer, Status};

/// A search for a looser rule may use one of so many equal parts of what is left of the budget.
const PARTS: u32 = 3;

/// How a rule can be loosened, by the best plan with it and its price.
pub(super) fn loosen(
    pricing: &Pricing,
    rule: usize,
    with: &SolveAnswer,
    price: &RulePrice,
) -> Loosened {
    let kind = pricing.instance.constraints().get(rule);
    let ways = kind.map_or_else(Vec::new, |rule| {
        rule.kind.looser_ways(last_time(pricing, with))
    });
    let mut loosened = Loosened {
        index: rule as u32,
        can_loosen: !ways.is_empty(),
        looser: Vec::new(),
        settled: true,
    };
    // What changes nothing where it is off changes nothing where it is looser.
    if price.exact && matches!(price.price, Price::Free | Price::None) {
        return loosened;
    }
    for way in ways {
        let mut search = Search {
            pricing,
            rule,
            with,
            way,
            found: BTreeMap::new(),
        };
        match search.least() {
            Some(Some((steps, is_least))) => loosened.looser.extend(search.rule(steps, is_least)),
            Some(None) => {}
            None => loosened.settled = false,
        }
    }
    loosened
}

/// A time after which a plan that is better is not looked for: the horizon, as far as it is known.
fn last_time(pricing: &Pricing, with: &SolveAnswer) -> u32 {
    let grid = pricing.instance.grid();
    let around = 4 * (grid.width() + grid.height()) + 10;
    let known = with.costs.map_or(0, |costs| costs.makespan);
    let reach = with.reach.within().unwrap_or(0);
    let rules = pricing.instance.constraints_in_force();
    let named = rules.filter_map(|rule| rule.constraint.kind.last_chance());
    let named = named.max().unwrap_or(0);
    let default = known.max(named).saturating_add(around).max(reach);
    pricing.within.unwrap_or(default)
}

/// The search for the least looser form in one way.
struct Search<'a, 'b, 'h> {
    pricing: &'a Pricing<'b, 'h>,
    rule: usize,
    with: &'a SolveAnswer,
    way: LooserWay,
    /// The best plans of those that help, by how far the rule is loosened.
    found: BTreeMap<u32, SolveAnswer>,
}

impl Search<'_, '_, '_> {
    /// The least steps from today's number that help, and whether fewer are proved not to.
    /// `Some(None)` where not even the loosest helps; `None` where that is open.
    #[expect(
        clippy::option_option,
        reason = "nothing helps is an answer, and not knowing is none"
    )]
    fn least(&mut self) -> Option<Option<(u32, bool)>> {
        let all = self.way.steps();
        match self.helps(all) {
            Some(false) => return Some(None),
            None if self.pricing.budget.check().is_err() => return None,
            Some(true) | None => {}
        }
        let (mut low, mut step, mut is_least) = (0, 1, true);
        let mut high = all;
        while low + step < all {
            match self.helps(low + step) {
                Some(true) => {
                    high = low + step;
                    break;
                }
                outcome => is_least &= outcome.is_some(),
            }
            low += step;
            step = step.saturating_mul(2);
        }
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            match self.helps(middle) {
                Some(true) => high = middle,
                outcome => {
                    is_least &= outcome.is_some();
                    low = middle;
                }
            }
        }
        // Times without an end are looser from the first number on.
        let is_least = is_least && !(self.way.is_open && high == 1);
        self.found
            .contains_key(&high)
            .then_some(Some((high, is_least)))
    }

    /// Whether the rule that is loosened by so many steps changes something.
    fn helps(&mut self, steps: u32) -> Option<bool> {
        if self.found.contains_key(&steps) {
            return Some(true);
        }
        self.pricing.budget.check().ok()?;
        let instance = self.loosened(steps)?;
        // What keeps the rule as it is keeps it looser, too.
        let start = self.with.plan.as_ref();
        let looser = self.pricing.solve(&instance, start, PARTS).answer;
        let helps = self.changes(&looser);
        if helps == Some(true) {
            self.found.insert(steps, looser);
        }
        helps
    }

    /// The instance with the rule loosened by so many steps.
    fn loosened(&self, steps: u32) -> Option<Instance> {
        let mut instance = self.pricing.instance.clone();
        let kind = &instance.constraints().get(self.rule)?.kind;
        let kind = kind.loosened(self.way.loosens, self.way.number(steps))?;
        instance.weaken_rule(self.rule, kind);
        Some(instance)
    }

    /// Whether a looser rule leads to a better plan, or to one at all.
    fn changes(&self, looser: &SolveAnswer) -> Option<bool> {
        let objective = self.pricing.instance.objective();
        let vector = |answer: &SolveAnswer| answer.costs.map(|costs| costs.vector(objective));
        match (self.with.status, looser.status) {
            (Status::Optimal, Status::Optimal) => Some(vector(looser) < vector(self.with)),
            (Status::Optimal, Status::Feasible) => {
                (vector(looser) < vector(self.with)).then_some(true)
            }
            (Status::Impossible, Status::Optimal | Status::Feasible) => {
                (compared(objective, self.with, looser).0 == Price::Decides).then_some(true)
            }
            (Status::Impossible, Status::Impossible) => Some(false),
            (
                Status::Optimal | Status::Feasible | Status::Impossible | Status::Unknown,
                Status::Optimal | Status::Feasible | Status::Impossible | Status::Unknown,
            ) => None,
        }
    }

    /// The rule that is loosened by so many steps, with its best plan.
    fn rule(&mut self, steps: u32, is_least: bool) -> Option<LooserRule> {
        let answer = self.found.remove(&steps)?;
        let mut rule = self.pricing.instance.constraints().get(self.rule)?.clone();
        rule.kind = rule
            .kind
            .loosened(self.way.loosens, self.way.number(steps))?;
        let costs = answer.costs?;
        let own = || self.pricing.instance.objective().costs().iter();
        let value = |&cost: &Cost| (cost, costs.get(cost));
        let differences = self.with.costs.map(|with| {
            let pair = |&cost: &Cost| (cost, difference(with, costs, cost));
            map(own().map(pair))
        });
        Some(LooserRule {
            rule,
            costs: map(own().map(value)),
            difference: differences.unwrap_or_default(),
            exact: answer.status == Status::Optimal,
            least: is_least,
            plan: answer.plan,
        })
    }
}
