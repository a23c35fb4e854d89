//! Prices that were left open: why, and for how long the search goes on.

use giveway_model::tr;
use giveway_solve::price::PriceAnswer;

use super::price::Pricing;
use crate::State;

/// So many times as long it goes on after a search that brought nothing.
const LONGER: u32 = 4;

/// The longest that it goes on by itself, in seconds.
const LONGEST: u32 = 3600;

impl Pricing {
    /// Whether it went on, and nothing came of that.
    fn is_as_before(&self) -> bool {
        let known = |answer: &PriceAnswer| -> Vec<_> {
            let prices = answer.prices.iter();
            prices
                .map(|price| (price.price, price.at_least, price.at_most))
                .collect()
        };
        let before = self.before.as_deref();
        let told = self.told.as_deref();
        let is_done = told.is_some_and(|told| told.pending == 0);
        is_done && before.is_some() && before.map(known) == told.map(known)
    }
}

/// For how long prices are looked for next, in seconds: as Settings say, and longer after a search
/// that brought nothing.
pub(crate) fn seconds(state: &State) -> u32 {
    let longer = longer(state);
    longer.unwrap_or(state.settings.seconds)
}

/// The time of the next search where it is longer than that of Settings, in seconds.
pub(super) fn longer(state: &State) -> Option<u32> {
    let prices = state.prices().filter(|prices| prices.is_as_before())?;
    let longer = prices.seconds.saturating_mul(LONGER).min(LONGEST);
    (longer > state.settings.seconds).then_some(longer)
}

/// Why not every price is known, as a sentence; nothing while they are asked for.
pub(super) fn left_open(state: &State) -> Option<String> {
    let prices = state.prices()?;
    let told = prices.told.as_deref()?;
    let is_open = told.prices.iter().any(|price| !price.exact);
    if !is_open || state.is_pricing() {
        return None;
    }
    if told.pending > 0 {
        return Some(tr!("It was stopped before every price was known.").to_owned());
    }
    let why = tr!(
        "Not every price could be proved within {n} second and the memory that the page takes."
            | "Not every price could be proved within {n} seconds and the memory that the page takes."
                % prices.seconds
    );
    Some(if prices.is_as_before() {
        let nothing = tr!("Going on has brought nothing new; more time may.");
        format!("{why} {nothing}")
    } else {
        why
    })
}
