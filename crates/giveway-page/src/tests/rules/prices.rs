//! Prices that time left open: they say how much is known, and go on from there.

use giveway_solve::price::{Price, PriceRequest};
use giveway_solve::{Request, Response, SilentHost, serve};

use super::{act, marked, solved};
use crate::reduce::tests::after;
use crate::rules::{RuleAction, list};
use crate::{Action, Edit, State, WorkerAction};

/// What is asked for with the number of its job.
fn asked(state: &State) -> (u64, PriceRequest) {
    match state.work.request() {
        Some((job, Request::Price(request))) => (job, request),
        other => panic!("{other:?}"),
    }
}

/// The answer to a request that may do so much work.
fn answered_with(state: &State, work: Option<u64>) -> State {
    let (job, mut request) = asked(state);
    request.limits.work = work;
    let response = serve(&Request::Price(request), &SilentHost);
    assert!(matches!(response, Response::Priced(_)));
    let response = Box::new(response);
    after(
        state,
        [Action::Worker(WorkerAction::Respond { job, response })],
    )
}

fn texts(state: &State) -> Vec<String> {
    let rows = list(state).unwrap().rows.into_iter();
    rows.filter_map(|row| Some(row.price?.text)).collect()
}

#[test]
fn prices_that_are_left_open_go_on() {
    let added = solved(&after(&marked(), [act(RuleAction::Add)]));
    let asking = after(&added, [act(RuleAction::Price)]);
    let (_, first) = asked(&asking);
    let known = first.known.unwrap();
    assert!(known.with.is_some(), "the plan on the board is proved");
    assert!(known.prices.is_empty());

    let open = answered_with(&asking, Some(1));
    let why = list(&open).unwrap().left_open.unwrap();
    assert_eq!(
        why,
        "Not every price could be proved within 30 seconds and the memory that the page takes."
    );
    assert_eq!(texts(&open).len(), 2);
    assert_eq!(
        list(&open).unwrap().summary,
        None,
        "not every price is known"
    );

    let again = after(&open, [act(RuleAction::Price)]);
    assert_eq!(list(&again).unwrap().left_open, None);
    let (_, second) = asked(&again);
    assert_eq!(second.known.unwrap().prices.len(), 2);
    assert_eq!(list(&again).unwrap().summary, None);
    let still = answered_with(&again, Some(1));
    let why = list(&still).unwrap().left_open.unwrap();
    assert!(why.ends_with("Going on has brought nothing new; more time may."));
    assert_eq!(list(&open).unwrap().longer, None);
    assert_eq!(list(&still).unwrap().longer, Some(120));
    let longer = after(&still, [act(RuleAction::Price)]);
    assert_eq!(asked(&longer).1.limits.seconds, Some(120.0));
    let why = list(&answered_with(&longer, Some(1))).unwrap().left_open;
    assert!(why.unwrap().contains("within 120 seconds"));
    let priced = answered_with(&again, None);
    assert_eq!(
        texts(&priced),
        ["costs nothing", "costs 2 steps of the makespan"]
    );
    assert_eq!(list(&priced).unwrap().left_open, None);
    let summary = list(&priced).unwrap().summary;
    assert_eq!(summary.as_deref(), Some("1 of 2 rules costs something."));
}

#[test]
fn what_is_proved_of_a_price_stays_while_the_others_are_asked_for() {
    let added = solved(&after(&marked(), [act(RuleAction::Add)]));
    let priced = answered_with(&after(&added, [act(RuleAction::Price)]), None);
    // As if the first had been left open.
    let mut half = priced;
    let prices = half.document.found_prices.as_mut().unwrap();
    let told = std::rc::Rc::make_mut(prices).told.as_mut().unwrap();
    let first = &mut std::rc::Rc::make_mut(told).prices[0];
    (first.price, first.exact) = (Price::Unknown, false);
    (first.at_least, first.at_most) = (Some(1), Some(4));
    assert_eq!(
        texts(&half),
        [
            "costs 1 to 4 steps of the makespan",
            "costs 2 steps of the makespan"
        ]
    );
    let again = after(&half, [act(RuleAction::Price)]);
    assert_eq!(list(&again).unwrap().asking, Some((1, 2)));
    assert_eq!(
        texts(&again),
        [
            "costs 1 to 4 steps of the makespan",
            "costs 2 steps of the makespan"
        ]
    );
    let priced = answered_with(&again, None);
    assert_eq!(texts(&priced)[0], "costs nothing");
}

#[test]
fn prices_within_another_horizon_are_other_prices() {
    let added = solved(&after(&marked(), [act(RuleAction::Add)]));
    let priced = answered_with(&after(&added, [act(RuleAction::Price)]), None);
    assert_eq!(texts(&priced).len(), 2);
    let bounded = after(&priced, [Action::Edit(Edit::Within(Some(12)))]);
    assert_eq!(texts(&bounded), [""; 0], "they were asked for any horizon");
    let (_, request) = asked(&after(&bounded, [act(RuleAction::Price)]));
    assert_eq!(request.within, Some(12));
    let known = request.known.unwrap();
    assert!(known.with.is_none() && known.prices.is_empty());
    let back = after(&bounded, [Action::Undo]);
    assert_eq!(texts(&back).len(), 2);
}

#[test]
fn prices_are_there_after_a_reload() {
    let added = solved(&after(&marked(), [act(RuleAction::Add)]));
    let priced = answered_with(&after(&added, [act(RuleAction::Price)]), None);
    let kept = crate::link::keep(&priced);
    let again = crate::link::kept(&kept).unwrap();
    assert_eq!(texts(&again), texts(&priced));
    assert_eq!(texts(&again).len(), 2);
    assert_eq!(crate::link::keep(&again), kept);
    let before = crate::link::keep(&added);
    assert!(!added.is_kept_alike(&priced) && before != kept);
    let bounded = after(&again, [Action::Edit(Edit::Within(Some(12)))]);
    assert_eq!(texts(&bounded), [""; 0]);
}

#[test]
fn prices_of_a_scene_that_is_left_are_told_of_no_other() {
    let added = solved(&after(&marked(), [act(RuleAction::Add)]));
    let priced = answered_with(&after(&added, [act(RuleAction::Price)]), None);
    // Asked again, for another horizon, and taken back before the answer came.
    let bounded = after(&priced, [Action::Edit(Edit::Within(Some(12)))]);
    let asking = after(&bounded, [act(RuleAction::Price)]);
    let (job, request) = asked(&asking);
    let back = after(&asking, [Action::Undo]);
    let response = Box::new(serve(&Request::Price(request), &SilentHost));
    let told = after(
        &back,
        [Action::Worker(WorkerAction::Respond { job, response })],
    );
    assert_eq!(texts(&told), texts(&priced));
    let prices = told.document.prices().unwrap();
    assert_eq!(prices.within, None);
}
