//! What the rules of the scene's own cost: asked one by one.

use std::rc::Rc;

use giveway_model::tr_data;
use giveway_solve::price::PriceAnswer;

use super::ask;
use crate::rules::{Pricing, request};
use crate::{State, Task};

/// Asks what each rule costs.
pub(super) fn price(state: &mut State) {
    if !state.can_write_rules() || state.document.draft.instance().is_err() {
        let why = tr_data!("What the rules cost cannot be found out for this scene.");
        return ask::refuse(state, why);
    }
    ask::close(state);
    state.view.notice = None;
    let request = request(state);
    let draft = Rc::clone(&state.document.draft);
    state.view.rules.prices = Some(Rc::new(Pricing {
        draft: Rc::clone(&draft),
        told: None,
    }));
    state.work.start(Task::Price(draft, Rc::new(request)));
}

/// More became known of the prices.
pub(super) fn learn(state: &mut State, told: PriceAnswer) {
    if let Some(prices) = &mut state.view.rules.prices {
        Rc::make_mut(prices).told = Some(Rc::new(told));
    }
}
