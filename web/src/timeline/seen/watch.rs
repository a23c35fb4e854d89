//! What is seen is looked at again when the plan or its places change their size.

use std::rc::Rc;

use giveway_page::Tab;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{Element, ResizeObserver};
use yew::prelude::*;

use super::{Extent, Seen};
use crate::held::use_held;

/// What is seen, and a function that looks again.
#[hook]
pub(in crate::timeline) fn use_seen(
    extent: Extent,
    lanes: &NodeRef,
    table: &NodeRef,
    tab: Tab,
    open: bool,
) -> (Seen, Rc<dyn Fn()>) {
    let seen = use_state_eq(Seen::default);
    // The function stays the same, so that the observer need not change.
    let latest = use_held(|| extent);
    latest.set(extent);
    let look = {
        let (lanes, table, setter) = (lanes.clone(), table.clone(), seen.setter());
        use_memo((), move |()| {
            let look: Rc<dyn Fn()> = Rc::new(move || {
                setter.set(Seen::look(latest.get(), &lanes, &table));
            });
            look
        })
    };
    let look: Rc<dyn Fn()> = (*look).clone();
    {
        let look = Rc::clone(&look);
        use_effect_with((extent, tab, open), move |_| look());
    }
    {
        let (look, places) = (Rc::clone(&look), [lanes.clone(), table.clone()]);
        use_effect_with((), move |()| {
            let resized = Closure::<dyn FnMut()>::new(move || look());
            let observer = ResizeObserver::new(resized.as_ref().unchecked_ref()).ok();
            if let Some(observer) = &observer {
                for place in places.iter().filter_map(NodeRef::cast::<Element>) {
                    observer.observe(&place);
                }
            }
            move || {
                if let Some(observer) = observer {
                    observer.disconnect();
                }
                drop(resized);
            }
        });
    }
    ((*seen).clone(), look)
}
