//! What each rule costs, while it is asked for and afterwards.

use std::rc::Rc;

use giveway_model::tr;
use giveway_solve::Limits;
use giveway_solve::price::{Price, PriceAnswer, PriceRequest, RulePrice, words};

use crate::{Draft, State, Task};

/// What the rules of a scene cost, as far as it is known.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Pricing {
    /// The scene whose rules they are.
    pub(crate) draft: Rc<Draft>,
    /// What was answered so far.
    pub(crate) told: Option<Rc<PriceAnswer>>,
}

/// The price of a rule, as its row shows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tag {
    /// In a few words: `+2 steps`.
    pub text: String,
    /// Its class: `cost`, `free`, `none`, `some`, `busy` or `off`.
    pub class: &'static str,
    /// Whether both sides are proved.
    pub is_proved: bool,
    /// The costs of the best plan without it, as a sentence.
    pub without: Option<String>,
}

/// What is asked of the solver.
pub(crate) fn request(state: &State) -> PriceRequest {
    let document = &state.document;
    PriceRequest {
        scene: document.draft.scene().clone(),
        objective: None,
        within: document.within,
        start: document.plan().cloned(),
        limits: Limits {
            seconds: Some(f64::from(state.settings.seconds)),
            ..Limits::default()
        },
    }
}

impl State {
    /// Whether it is being found out what the rules cost.
    pub fn is_pricing(&self) -> bool {
        matches!(self.work.task(), Some(Task::Price(..)))
    }

    /// What is known of the prices of the rules of the scene on the board.
    pub(crate) fn prices(&self) -> Option<&Pricing> {
        let prices = self.view.rules.prices.as_deref();
        let draft = &self.document.draft;
        prices.filter(|prices| Rc::ptr_eq(&prices.draft, draft) || prices.draft == *draft)
    }
}

/// The price of a rule, by its index; nothing where nobody asked.
pub(super) fn tag(state: &State, index: usize, is_off: bool) -> Option<Tag> {
    let plain = |text: &str, class| Tag {
        text: text.to_owned(),
        class,
        is_proved: false,
        without: None,
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
        Some((told, told.prices.get(place)?, place < known))
    });
    match price {
        Some((told, price, true)) => Some(known(told, price)),
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
    let without = told.objective.costs().iter().filter_map(|cost| {
        let value = *price.without.get(cost)?;
        Some(giveway_model::words::value(*cost, value))
    });
    let without: Vec<String> = without.collect();
    Tag {
        text: words::tag(&told.objective, price),
        class,
        is_proved: price.exact,
        without: (!without.is_empty())
            .then(|| tr!("Without it: {costs}.", costs = without.join(", "))),
    }
}
