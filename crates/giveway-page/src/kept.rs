//! What of the state the browser keeps.

use std::rc::Rc;

use crate::{Document, State};

impl State {
    /// Whether another state has the same to be kept. Takes no time: what is the same
    /// object is the same. While a plan plays, the time shown is not looked at.
    pub fn is_kept_alike(&self, other: &Self) -> bool {
        let (one, two) = (&self.view, &other.view);
        let is_same_look = one.theme == two.theme
            && one.layers == two.layers
            && one.table == two.table
            && one.selection == two.selection;
        let is_same_time = two.playback.playing || one.playback == two.playback;
        is_same_look
            && is_same_time
            && self.settings == other.settings
            && self.history.past().len() == other.history.past().len()
            && same_document(self.own_document(), other.own_document())
    }
}

fn same_document(one: &Document, two: &Document) -> bool {
    one.within == two.within
        && one.colours == two.colours
        && one.looks == two.looks
        && Rc::ptr_eq(&one.draft, &two.draft)
        && same(one.answer.as_ref(), two.answer.as_ref())
        && same(one.found_front.as_ref(), two.found_front.as_ref())
        && same(one.found_prices.as_ref(), two.found_prices.as_ref())
        && same(one.found_ledger.as_ref(), two.found_ledger.as_ref())
        && Rc::ptr_eq(&one.asked, &two.asked)
        && same(
            one.checked.as_ref().map(|(_, report)| report),
            two.checked.as_ref().map(|(_, report)| report),
        )
        && one.mode.is_same(&two.mode)
}

fn same<T>(one: Option<&Rc<T>>, two: Option<&Rc<T>>) -> bool {
    match (one, two) {
        (None, None) => true,
        (Some(one), Some(two)) => Rc::ptr_eq(one, two),
        _ => false,
    }
}
