//! What the rules of the scene's own cost, asked one by one; and by how little one has to be
//! loosened so that something changes.

use std::rc::Rc;

use giveway_model::tr_data;
use giveway_solve::price::{PriceAnswer, PriceRequest};

use super::{ask, document, rules, solve};
use crate::rules::{Lit, Loosening, Pricing, loosen_request, looser, looser_costs, request};
use crate::{Draft, Edit, RuleEdit, State, Task};

/// Asks what each rule costs.
pub(super) fn price(state: &mut State) {
    if !can_ask(state) {
        return;
    }
    ask::close(state);
    state.view.notice = None;
    let request = request(state);
    let seconds = crate::rules::seconds(state);
    let draft = Rc::clone(&state.document.draft);
    // What is proved of an answer before stays.
    let before = state.prices().and_then(|prices| prices.told.clone());
    let told = before.clone();
    let told = told.map(|mut told| {
        let open = told.prices.iter().filter(|price| !price.exact).count();
        Rc::make_mut(&mut told).pending = open as u32;
        told
    });
    state.document.found_prices = Some(Rc::new(Pricing {
        draft: Rc::clone(&draft),
        within: state.document.within,
        told,
        before,
        seconds,
    }));
    state.work.start(Task::Price(draft, Rc::new(request)));
}

/// Whether the rules of the scene on the board can be priced; else a notice says that they cannot.
fn can_ask(state: &mut State) -> bool {
    let can_ask = state.can_write_rules() && state.document.draft.instance().is_ok();
    if !can_ask {
        let why = tr_data!("What the rules cost cannot be found out for this scene.");
        ask::refuse(state, why);
    }
    can_ask
}

/// Asks by how little a rule has to be loosened, and shows it in the list.
pub(super) fn loosen(state: &mut State, rule: usize) {
    let rules = &state.document.draft.scene().constraints;
    let is_in_force = rules.get(rule).is_some_and(|rule| !rule.off);
    if !is_in_force || !can_ask(state) {
        return;
    }
    rules::list(state);
    state.view.notice = None;
    state.view.rules.open = Some(rule);
    state.view.rules.lit = Some(Lit::Rule(rule));
    let request = loosen_request(state, rule);
    let draft = Rc::clone(&state.document.draft);
    state.view.rules.loosening = Some(Rc::new(Loosening {
        draft: Rc::clone(&draft),
        rule,
        told: None,
    }));
    state.work.start(Task::Price(draft, Rc::new(request)));
}

/// Puts a looser rule in the place of the one that was asked about, as one step of undo, and
/// shows its plan while the scene is solved again.
pub(super) fn take_looser(state: &mut State, place: usize) {
    let Some((rule, looser)) = looser(state, place) else {
        return;
    };
    let looser = looser.clone();
    let put = Edit::Rules(RuleEdit::Put(Some(rule), looser.rule.clone()));
    if let Err(notice) = document::edit_scene(state, &[put]) {
        state.view.notice = Some(notice);
        return;
    }
    solve::start(state, solve::Start::quiet());
    let costs = state.document.draft.instance().ok();
    let costs = costs.and_then(|instance| looser_costs(instance, &looser));
    if let (Some(costs), Some(plan)) = (costs, looser.plan) {
        ask::show(state, costs, plan);
    }
}

/// More became known of the prices, or of how a rule can be loosened. The draft on the board may
/// be another one by now.
pub(super) fn learn(
    state: &mut State,
    draft: &Rc<Draft>,
    request: &PriceRequest,
    told: PriceAnswer,
) {
    let found = state.document.found_prices.as_mut();
    let found =
        found.filter(|prices| Rc::ptr_eq(&prices.draft, draft) && prices.within == request.within);
    if request.loosen.is_some() {
        if let Some(loosening) = &mut state.view.rules.loosening {
            Rc::make_mut(loosening).told = Some(Rc::new(told));
        }
    } else if let Some(prices) = found {
        Rc::make_mut(prices).told = Some(Rc::new(told));
    }
}
