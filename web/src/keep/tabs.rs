//! Each tab keeps its own document, under a number of its own: so that no tab
//! overwrites what another one has. A new tab opens what was kept last.
//!
//! The number is remembered beside the tab while the page is away (left, hidden) and
//! taken back as it comes: so a tab that is duplicated gets a number of its own.
//! What closed tabs leave behind is bounded: beyond [`MOST`] the oldest goes, first
//! what nobody ever touched; what was touched is kept on under Scenes. What a newer
//! version of the page wrote stays.

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::link::{self, Kin};

use super::{lost, scenes, storage};
use crate::held::Held;

/// The documents of tabs are kept under names that begin so.
pub(super) const TAB: &str = "tab.";
/// The numbers of tabs, the one that kept something last first.
const ORDER: &str = "tabs";
/// Where a tab remembers its number while the page is away.
const OWN: &str = "tab";
/// Where the version before kept the document of all tabs.
const FORMER: &str = "page";
/// The most documents of tabs that are kept.
const MOST: usize = 12;

thread_local! {
    static NUMBER: Held<String> = const { Held::new(String::new()) };
}

/// The name of the text that this tab opens, if there is one. From then on the tab
/// has a number.
pub(super) fn begin() -> Option<String> {
    let own = storage::remembered(OWN).map(|number| format!("{TAB}{number}"));
    storage::forget_here(OWN);
    let is_there = |name: &String| !lost::is_lost(name) && storage::load(name).is_some();
    if let Some(own) = own.filter(is_there) {
        NUMBER.with(|number| number.set(own.trim_start_matches(TAB).to_owned()));
        return Some(own);
    }
    renew();
    let tabs = order().into_iter().map(|number| format!("{TAB}{number}"));
    tabs.chain([FORMER.to_owned()]).find(is_there)
}

/// Takes another number.
pub(super) fn renew() {
    // By chance: no two tabs of a browser have the same.
    let bits = js_sys::Math::random().to_bits();
    NUMBER.with(|own| own.set(format!("{bits:016x}")));
}

/// The number of this tab.
pub(super) fn number() -> String {
    NUMBER.with(Held::get)
}

/// The name under which this tab keeps its document.
pub(super) fn own() -> String {
    format!("{TAB}{}", number())
}

/// The page goes away: the tab remembers its number.
pub(super) fn leave() {
    storage::remember(OWN, &number());
}

/// The page is shown again.
pub(super) fn come_back() {
    storage::forget_here(OWN);
}

/// This tab kept something: it is the last one that did.
pub(super) fn was_last() {
    let own = number();
    let told = storage::load(ORDER).unwrap_or_default();
    if told.split(' ').next() == Some(&own) {
        return;
    }
    let mut order = order();
    order.retain(|number| *number != own);
    order.insert(0, own);
    // Where it is refused, a new tab opens another of the documents.
    let _ = storage::store(ORDER, &order.join(" "));
    tidy(order);
}

/// Frees the room of a tab that left something behind; whether there was one.
pub(super) fn make_room() -> bool {
    let order = order();
    order.len() > 1 && drop_oldest(&order).is_some()
}

/// The numbers of all tabs that keep something, the last one first.
fn order() -> Vec<String> {
    let mut kept = storage::names(TAB);
    giveway_model::sorting::sort(&mut kept);
    let told = storage::load(ORDER).unwrap_or_default();
    let mut order: Vec<String> = Vec::new();
    for number in told.split(' ').map(str::to_owned) {
        if kept.contains(&number) && !order.contains(&number) {
            order.push(number);
        }
    }
    kept.retain(|number| !order.contains(number));
    order.extend(kept);
    order
}

fn tidy(mut order: Vec<String>) {
    while order.len() > MOST {
        let Some(gone) = drop_oldest(&order) else {
            return;
        };
        order.retain(|number| *number != gone);
    }
}

/// Drops the oldest document that nobody touched, or else the oldest one, which is
/// kept on under Scenes; gives its number.
fn drop_oldest(order: &[String]) -> Option<String> {
    let own = number();
    let kept = |number: &String| {
        let name = format!("{TAB}{number}");
        let text = storage::load(&name).filter(|text| !link::is_newer(text))?;
        (!lost::is_lost(&name) && *number != own).then_some((name, text))
    };
    let oldest: Vec<(String, String)> = order.iter().rev().filter_map(kept).collect();
    let untouched = oldest.iter().find(|(_, text)| !link::is_touched(text));
    let mut touched = oldest.iter();
    let gone = untouched.or_else(|| touched.find(|(name, text)| moves(name, text)));
    let (name, _) = gone?;
    storage::forget(name);
    name.strip_prefix(TAB).map(str::to_owned)
}

/// Whether the document of a tab is kept in another place: in what this tab keeps, or
/// from now on under Scenes, where it takes less room.
fn moves(name: &str, text: &str) -> bool {
    let here = storage::load(&own()).unwrap_or_default();
    if matches!(link::kin(&here, text), Kin::Same | Kin::Behind) {
        return true;
    }
    let Ok(moment) = link::kept_moment(text) else {
        // Damage is not made worse.
        return false;
    };
    storage::forget(name);
    let has_moved = scenes::keep_beside(&moment, tr!("from another tab"));
    if !has_moved {
        // There was room for it, so there is.
        let _ = storage::store(name, text);
    }
    has_moved
}

/// What other tabs keep that is not here, too: the number of each and the name of its
/// scene.
pub(crate) fn others(here: &str) -> Vec<(String, String)> {
    let (own, mut seen) = (number(), vec![here.to_owned()]);
    let mut others = Vec::new();
    for number in order().into_iter().filter(|number| *number != own) {
        let text = storage::load(&format!("{TAB}{number}")).unwrap_or_default();
        let is_seen = |seen: &String| matches!(link::kin(seen, &text), Kin::Same | Kin::Behind);
        if !link::is_touched(&text) || seen.iter().any(is_seen) {
            continue;
        }
        if let Some(title) = link::title(&text) {
            others.push((number, title));
            seen.push(text);
        }
    }
    others
}

/// Opens the document of another tab.
pub(crate) fn other(number: &str) -> Action {
    scenes::open(&storage::load(&format!("{TAB}{number}")).unwrap_or_default())
}
