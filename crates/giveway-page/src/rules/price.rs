//! What each rule costs, while it is asked for and afterwards.

use std::rc::Rc;

use giveway_model::check::check;
use giveway_model::{Plan, tr};
use giveway_solve::price::{KnownPrices, Price, PriceAnswer, PriceRequest, RulePrice, words};
use giveway_solve::{Limits, SolveAnswer, SolveRequest};

use crate::audit::unproved;
use crate::{Answer, Document, Draft, State, Task};

/// So many plans of scenes before are handed on.
const MOST_PLANS: usize = 8;

/// What the rules of a scene cost, as far as it is known.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Pricing {
    /// The scene whose rules they are.
    pub(crate) draft: Rc<Draft>,
    /// The horizon within which they were asked for.
    pub(crate) within: Option<u32>,
    /// What was answered so far.
    pub(crate) told: Option<Rc<PriceAnswer>>,
    /// What had been answered before this time, where it goes on.
    pub(crate) before: Option<Rc<PriceAnswer>>,
    /// For so long they may be looked for, in seconds.
    pub(crate) seconds: u32,
}

/// The price of a rule, as its row shows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tag {
    /// In a few words: `costs 2 steps of the makespan`.
    pub text: String,
    /// Its class: `cost`, `free`, `none`, `some`, `busy` or `off`.
    pub class: &'static str,
    /// Whether both sides are proved.
    pub is_proved: bool,
    /// Each cost of the objective with the rule and without it.
    pub costs: Vec<CostsOfRule>,
    /// Whether that plan can be shown beside.
    pub has_plan: bool,
}

/// A cost with a rule and without it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CostsOfRule {
    /// Its name, as it stands in a table.
    pub title: &'static str,
    /// That of the best plan with the rule; `None` where no plan keeps it, or none is known.
    pub with: Option<u32>,
    /// That of the best plan without it.
    pub without: u32,
}

/// What is asked of the solver.
pub(crate) fn request(state: &State) -> PriceRequest {
    let document = &state.document;
    PriceRequest {
        scene: document.draft.scene().clone(),
        objective: None,
        within: document.within,
        start: document.plan().cloned(),
        loosen: None,
        known: Some(Box::new(known_prices(state))),
        limits: Limits {
            seconds: Some(f64::from(super::left_open::seconds(state))),
            ..Limits::default()
        },
    }
}

/// What earlier answers about the scene on the board say.
fn known_prices(state: &State) -> KnownPrices {
    let answer = state.document.fresh_answer();
    let within = state.document.within;
    let proved =
        answer.filter(|answer| answer.request.within == within && answer.proved_here().is_some());
    let told = state.prices().and_then(|prices| prices.told.as_deref());
    KnownPrices {
        with: proved.map(|answer| SolveAnswer {
            trace: None,
            ..answer.solved.clone()
        }),
        plans: earlier_plans(state),
        prices: told.map_or_else(Vec::new, |told| told.prices.clone()),
    }
}

/// The last plans of scenes before, which had other rules perhaps.
fn earlier_plans(state: &State) -> Vec<Plan> {
    let mut answers: Vec<&Rc<Answer>> = Vec::new();
    for moment in state.history.past().iter().rev() {
        let answer = moment.document.answer.as_ref();
        let answer = answer.filter(|answer| answer.course.is_none());
        if let Some(answer) = answer
            && !answers.iter().any(|other| Rc::ptr_eq(other, answer))
            && answers.len() < MOST_PLANS
        {
            answers.push(answer);
        }
    }
    let plans = answers.into_iter().filter_map(|answer| answer.plan());
    plans.cloned().collect()
}

/// The best plan without a rule, which is shown beside the plan.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Without {
    /// The rule, by its index in the scene.
    pub(crate) rule: usize,
    /// Its plan, of the scene in which the rule is off.
    pub(crate) answer: Rc<Answer>,
    /// The scene with the rule.
    of: Rc<Draft>,
}

/// The best plan without a rule, as far as its price is known.
pub(crate) fn without(state: &State, rule: usize) -> Option<Without> {
    best_without(state, rule, price(state, rule)?.plan.clone()?)
}

/// A plan without a rule, to be shown beside the one on the board, or alone where there is none;
/// `None` where it is not legal in the scene without the rule.
pub(crate) fn best_without(state: &State, rule: usize, plan: Plan) -> Option<Without> {
    let of = Rc::clone(&state.document.draft);
    let mut scene = of.scene().clone();
    scene.constraints.get_mut(rule)?.off = true;
    let draft = Rc::new(Draft::new(scene).ok()?);
    let costs = check(draft.instance().ok()?, &plan).costs?;
    let solved = SolveAnswer {
        costs: Some(costs),
        plan: Some(plan),
        ..unproved()
    };
    let about = state.document.fresh_answer();
    let request = about.map_or_else(SolveRequest::default, |about| (*about.request).clone());
    let request = SolveRequest {
        scene: draft.scene().clone(),
        ..request
    };
    let answer = Rc::new(Answer::new(draft, Rc::new(request), solved));
    Some(Without { rule, answer, of })
}

/// Whether it is proved that there is a plan without a rule, and none with it.
pub(super) fn decides(state: &State, rule: usize) -> bool {
    price(state, rule).is_some_and(|price| price.exact && price.price == Price::Decides)
}

/// The price of a rule, as far as it is known.
fn price(state: &State, rule: usize) -> Option<&RulePrice> {
    let told = state.prices()?.told.as_deref()?;
    told.prices
        .iter()
        .find(|price| price.index as usize == rule)
}

impl Document {
    /// What is known of the prices of the rules of the draft on the board.
    pub(crate) fn prices(&self) -> Option<&Pricing> {
        let prices = self.found_prices.as_deref();
        prices.filter(|prices| {
            let is_same = Rc::ptr_eq(&prices.draft, &self.draft) || prices.draft == self.draft;
            is_same && prices.within == self.within
        })
    }
}

impl State {
    /// The best plan without a rule, where it is opened beside this one.
    pub(crate) fn plan_without(&self) -> Option<&Without> {
        let without = self.view.rules.without.as_ref()?;
        let is_open = self.can_write_rules() && self.document.mode.asking().is_none();
        // A lesson gives the plan itself. Where there is one board, that is of the plan with it.
        let has_place = self.view.is_wide || self.document.answer.is_none();
        let is_same = Rc::ptr_eq(&without.of, &self.document.draft);
        let is_given = self.lesson().is_some() && is_same && has_place;
        let is_priced = self.prices().is_some() && self.document.fresh_answer().is_some();
        Some(without).filter(|_| is_open && (is_given || is_priced))
    }

    /// The plan without a rule where no plan keeps it: it has the place of the plan.
    pub(crate) fn plan_in_place(&self) -> Option<&Without> {
        let without = self.plan_without()?;
        Some(without).filter(|_| self.document.answer.is_none())
    }

    /// Whether it is being found out what the rules cost.
    pub fn is_pricing(&self) -> bool {
        matches!(self.work.task(), Some(Task::Price(_, request)) if request.loosen.is_none())
    }

    /// What is known of the prices of the rules of the scene on the board.
    pub(crate) fn prices(&self) -> Option<&Pricing> {
        self.document.prices()
    }
}

/// The price of a rule, by its index; nothing where nobody asked.
pub(super) fn tag(state: &State, index: usize, is_off: bool) -> Option<Tag> {
    let plain = |text: &str, class| Tag {
        text: text.to_owned(),
        class,
        is_proved: false,
        costs: Vec::new(),
        has_plan: false,
    };
    if is_off {
        return Some(plain(tr!("a rule" => "off"), "off"));
    }
    let prices = state.prices()?;
    let asking = || plain(tr!("a price" => "asking …"), "busy");
    let told = prices.told.as_deref();
    let price = told.and_then(|told| {
        let place = told
            .prices
            .iter()
            .position(|price| price.index as usize == index)?;
        let known = told.prices.len().saturating_sub(told.pending as usize);
        let price = told.prices.get(place)?;
        Some((told, price, price.exact || place < known))
    });
    match price {
        Some((told, price, true)) => Some(known(told, price)),
        // What was proved before stays while the search goes on.
        Some((told, price, false))
            if state.is_pricing() && (price.at_least, price.at_most) != (None, None) =>
        {
            Some(Tag {
                class: "busy",
                ..known(told, price)
            })
        }
        Some(_) | None if state.is_pricing() => Some(asking()),
        Some((told, price, false)) => Some(known(told, price)),
        None => None,
    }
}

fn known(told: &PriceAnswer, price: &RulePrice) -> Tag {
    let class = match price.price {
        Price::Free => "free",
        Price::Costs => "cost",
        Price::Decides | Price::None => "none",
        Price::Unknown => "some",
    };
    let costs = told.objective.costs().iter();
    let costs = costs.filter_map(|cost| {
        Some(CostsOfRule {
            title: crate::words::title(*cost),
            with: told.costs.map(|costs| costs.get(*cost)),
            without: *price.without.get(cost)?,
        })
    });
    Tag {
        text: words::tag(&told.objective, price),
        class,
        is_proved: price.exact,
        costs: costs.collect(),
        has_plan: price.plan.is_some(),
    }
}
