//! A price request, from the scene to the answer, rule after rule.

use std::rc::Rc;

use giveway_model::{Fault, Instance, Objective, Plan, Version, check::check, sorting::map};

use super::{
    Price, PriceAnswer, PriceRequest, RulePrice, SwitchOff,
    compared::{compared, difference, known_so_far, narrow},
    conflict::{Unsolved, conflict},
    loosen::loosen,
    words,
};
use crate::{
    Host, Limits, Progress, Refusal, SolveAnswer, Status,
    budget::Budget,
    solve::{self, SolveTask, Solved},
};

/// One of so many equal parts of what is left of the budget is for the plan with all rules.
const PARTS: u32 = 2;
/// The host is told of each of so many prices; of more, about so many times.
const OFTEN: usize = 100;

/// Serves a price request, and tells the host of every price.
///
/// # Errors
/// When the scene is no instance.
pub(crate) fn serve(request: &PriceRequest, host: &dyn Host) -> Result<PriceAnswer, Refusal> {
    let scene = request.scene.clone();
    let instance = Instance::new(scene).map_err(|faults| Refusal::Scene { faults })?;
    let objective = request.objective.clone();
    let objective = instance.in_force(objective.unwrap_or_else(|| instance.objective().clone()));
    let instance = instance.with_objective(objective.clone());
    let budget = Rc::new(Budget::new(host, request.limits));
    let mut rules: Vec<usize> = instance
        .constraints_in_force()
        .map(|rule| rule.index)
        .collect();
    if let Some(loosened) = request.loosen {
        rules.retain(|&rule| rule == loosened as usize);
        if rules.is_empty() {
            let fault = Fault::at(
                "loosen",
                loosened.to_string(),
                "the number of a rule that is in force",
            );
            return Err(Refusal::Request { fault });
        }
    }
    let known = request.known.as_deref();
    let exact = |&rule: &usize| {
        let price = known.and_then(|known| known.price(rule));
        price.filter(|price| price.exact).cloned()
    };
    let open = |rules: &[usize]| rules.iter().filter(|rule| exact(rule).is_none()).count() as u32;
    let parts = if open(&rules) == 0 { 1 } else { PARTS };
    let pricing = Pricing {
        instance: &instance,
        within: request.within,
        budget: &budget,
    };
    let best = known.and_then(|known| known.with.as_ref());
    let all = match best.filter(|best| pricing.is_best(best)) {
        Some(best) => Solved {
            answer: best.clone(),
            reach: None,
            clash: Vec::new(),
            latest: None,
        },
        None => pricing.solve(&instance, request.start.as_ref(), parts),
    };
    let mut answer = begun(&all, objective);
    let before = |rule: usize| known.and_then(|known| known.price(rule)).cloned();
    let unpriced = |&rule: &usize| before(rule).unwrap_or_else(|| pricing.unpriced(rule));
    answer.prices = rules.iter().map(unpriced).collect();
    answer.pending = rules.len() as u32;
    let tell = |answer: &mut PriceAnswer| {
        answer.words = words::all(answer, &instance);
        answer.stats = budget.stats();
        if answer.pending > 0 {
            let answer = Box::new(answer.clone());
            host.progress(&Progress::Priced { answer });
        }
    };
    tell(&mut answer);
    for (place, &rule) in rules.iter().enumerate() {
        answer.pending -= 1;
        if exact(&rule).is_none() {
            if budget.check().is_err() {
                answer.pending += 1;
                break;
            }
            let from = known.into_iter().flat_map(|known| {
                let earlier = known.price(rule).and_then(|price| price.plan.as_ref());
                earlier.into_iter().chain(&known.plans)
            });
            let mut side = pricing.price(rule, &all.answer, from, open(&rules[place..]));
            if let Some(before) = before(rule) {
                narrow(&mut side, &before);
            }
            answer.prices[place] = side;
        }
        if request.loosen.is_some() {
            let price = &answer.prices[place];
            answer.loosened = Some(loosen(&pricing, rule, &all.answer, price));
        }
        if place < OFTEN || place.is_multiple_of(rules.len() / OFTEN) {
            tell(&mut answer);
        }
    }
    answer.pending = 0;
    tell(&mut answer);
    if let (Status::Impossible, Some(reach), None) = (all.answer.status, all.reach, request.loosen)
    {
        let unsolved = Unsolved {
            instance: &instance,
            within: request.within,
            reach,
            clash: &all.clash,
        };
        let (core, switch_off) = conflict(&unsolved, &answer.prices, &budget);
        (answer.conflict, answer.switch_off) = (core, switch_off);
        tell(&mut answer);
    }
    Ok(answer)
}

/// The answer when the search with all rules has ended.
fn begun(all: &Solved, objective: Objective) -> PriceAnswer {
    let answer = &all.answer;
    PriceAnswer {
        giveway: Version,
        status: answer.status,
        objective,
        costs: answer.costs,
        reach: answer.reach,
        reason: answer.reason.clone(),
        plan: answer.plan.clone(),
        prices: Vec::new(),
        conflict: None,
        switch_off: SwitchOff::default(),
        loosened: None,
        pending: 0,
        words: String::new(),
        stats: answer.stats,
    }
}

/// The scene whose rules are priced; it has the objective that is in force with all rules.
pub(super) struct Pricing<'a, 'h> {
    pub(super) instance: &'a Instance,
    /// The horizon, where a person set one.
    pub(super) within: Option<u32>,
    pub(super) budget: &'a Rc<Budget<'h>>,
}

impl Pricing<'_, '_> {
    /// The best plan of a variant, with one of so many equal parts of what is left of the
    /// budget.
    pub(super) fn solve(&self, instance: &Instance, start: Option<&Plan>, parts: u32) -> Solved {
        let limits = Limits {
            seconds: self.budget.seconds_left().map(|it| it / f64::from(parts)),
            work: self.budget.work_left().map(|work| work / u64::from(parts)),
            ..Limits::default()
        };
        let budget = Rc::new(self.budget.part(limits));
        let task = SolveTask {
            instance: instance.clone(),
            objective: self.instance.objective().clone(),
            within: self.within,
            start: start.cloned(),
            as_found: false,
            budget: Rc::clone(&budget),
        };
        let solved = solve::solve(&task);
        self.budget.absorb(&budget);
        solved
    }

    /// Whether an answer that is handed on has a plan that is proved best, with its costs.
    fn is_best(&self, answer: &SolveAnswer) -> bool {
        let report = answer.plan.as_ref().map(|plan| check(self.instance, plan));
        let costs = report
            .filter(giveway_model::check::Report::is_valid)
            .and_then(|it| it.costs);
        answer.status == Status::Optimal && costs.is_some() && costs == answer.costs
    }

    /// A rule whose price is not known yet.
    fn unpriced(&self, rule: usize) -> RulePrice {
        let constraint = self.instance.constraints().get(rule);
        RulePrice {
            index: rule as u32,
            kind: constraint.map_or(String::new(), |rule| rule.kind_name().to_owned()),
            name: constraint.and_then(|rule| rule.name.clone()),
            price: Price::Unknown,
            exact: false,
            without: map(std::iter::empty()),
            difference: map(std::iter::empty()),
            range_of: None,
            at_least: None,
            at_most: None,
            plan: None,
        }
    }

    /// The price of a rule: the best plan without it beside the best with it.
    ///
    /// The search begins with the best plan without it that is known; that which keeps all rules
    /// keeps the others, too.
    fn price<'p>(
        &self,
        rule: usize,
        with: &'p SolveAnswer,
        from: impl Iterator<Item = &'p Plan>,
        parts: u32,
    ) -> RulePrice {
        let mut instance = self.instance.clone();
        instance.switch_off(|other| other == rule);
        let objective = self.instance.objective();
        let start = from.chain(&with.plan).filter_map(|plan| {
            let report = check(&instance, plan);
            let costs = report.costs.filter(|_| report.violations.is_empty())?;
            Some((costs.vector(objective), plan))
        });
        let start = start.min_by(|(a, _), (b, _)| a.cmp(b));
        let Solved {
            answer: without, ..
        } = self.solve(&instance, start.map(|(_, plan)| plan), parts);
        let mut price = self.unpriced(rule);
        (price.price, price.exact) = compared(objective, with, &without);
        if let Some(costs) = without.costs.filter(|_| price.price != Price::Unknown) {
            let own = objective.costs().iter();
            price.without = map(own.map(|&cost| (cost, costs.get(cost))));
        }
        if let (Some(with), Some(without)) = (with.costs, without.costs)
            && price.price != Price::Unknown
        {
            let own = objective.costs().iter();
            price.difference = map(own.map(|&cost| (cost, difference(with, without, cost))));
        }
        if price.price == Price::Unknown {
            (price.range_of, price.at_least, price.at_most) =
                known_so_far(objective, with, &without);
        }
        price.plan = without.plan;
        price
    }
}
