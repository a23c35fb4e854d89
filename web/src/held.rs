//! What a component holds from one rendering to the next, and what the page's
//! parts hold between two events.
//!
//! It is handed out whole and never lent: while the browser is called, no borrow
//! is open. A browser may lack what is called, and an exception leaves Rust without
//! ending borrows: one that was open then would stay open, and the next event
//! would find what it needs locked for ever. `web/clippy.toml` forbids to borrow
//! from a `RefCell` anywhere else.

use std::cell::RefCell;
use std::rc::Rc;

use web_sys::HtmlElement;
use yew::prelude::*;

/// A value that is taken, set and copied, but never borrowed.
#[derive(Default)]
pub(crate) struct Held<T>(RefCell<T>);

impl<T> Held<T> {
    /// Holds a value.
    pub(crate) const fn new(value: T) -> Self {
        Self(RefCell::new(value))
    }

    /// Holds this from now on; what was held is dropped afterwards.
    pub(crate) fn set(&self, value: T) {
        drop(self.0.replace(value));
    }
}

impl<T: Clone> Held<T> {
    /// A copy of what is held. To copy must not call the browser.
    #[expect(
        clippy::disallowed_methods,
        reason = "the borrow ends before this returns"
    )]
    pub(crate) fn get(&self) -> T {
        self.0.borrow().clone()
    }
}

impl<T: Default> Held<T> {
    /// What is held; from now on that is nothing.
    pub(crate) fn take(&self) -> T {
        self.0.take()
    }
}

/// Holds a value for a component, from its first rendering on.
#[hook]
pub(crate) fn use_held<T: 'static>(first: impl FnOnce() -> T) -> Rc<Held<T>> {
    use_memo((), |()| Held::new(first()))
}

/// The height of an element before it was held, in pixels. It is looked at while a component is
/// rendered anew: the page still shows what was there before.
#[hook]
pub(crate) fn use_height_before(
    is_held: bool,
    element: impl FnOnce() -> Option<HtmlElement>,
) -> Option<i32> {
    let before = use_held(|| (is_held, None));
    let (was_held, height) = before.get();
    let height = if is_held && !was_held {
        element().map(|element| element.offset_height())
    } else {
        height
    };
    before.set((is_held, height));
    height
}

/// Properties of [`HeldPlace`].
#[derive(Clone, PartialEq, Properties)]
pub(crate) struct HeldPlaceProps {
    /// Whether what stands in it is out of date, or on its way.
    pub(crate) is_held: bool,
    /// What stands in it.
    pub(crate) content: Html,
}

/// A place that keeps its height while it is held: what stands below does not move.
#[component]
pub(crate) fn HeldPlace(props: &HeldPlaceProps) -> Html {
    let place = use_node_ref();
    let is_held = props.is_held;
    let height = use_height_before(is_held, || place.cast());
    {
        let place = place.clone();
        use_effect_with((is_held, height), move |&(is_held, height)| {
            let Some(place) = place.cast::<HtmlElement>() else {
                return;
            };
            let height = height.filter(|_| is_held);
            let height = height.map_or(String::new(), |height| format!("{height}px"));
            // Without it, things move.
            let _ = place.style().set_property("min-height", &height);
        });
    }
    html! { <div class="held-place" ref={place}>{ props.content.clone() }</div> }
}
