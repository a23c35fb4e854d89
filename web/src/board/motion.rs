//! Moving by hand: attributes set in every frame, past the page's rendering.

use web_sys::Element;
use yew::prelude::*;

use crate::Clock;
use crate::held::Held;

/// An attribute of an element that is set only where it changes.
pub(super) struct Attribute {
    element: Element,
    name: &'static str,
    value: Held<Option<String>>,
}

impl Attribute {
    /// An attribute, as the element has it: it may be one that showed another
    /// agent before.
    pub(super) fn new(element: Element, name: &'static str) -> Self {
        let value = Held::new(element.get_attribute(name));
        Self {
            element,
            name,
            value,
        }
    }

    /// The attribute of the first part of an element with a class.
    pub(super) fn of_part(element: &Element, class: &str, name: &'static str) -> Option<Self> {
        let part = element.get_elements_by_class_name(class).item(0)?;
        Some(Self::new(part, name))
    }

    /// Sets it.
    pub(super) fn set(&self, value: &str) {
        let old = self.value.take();
        if old.as_deref() == Some(value) {
            self.value.set(old);
            return;
        }
        self.value.set(Some(value.to_owned()));
        // The names are valid, so that it cannot fail.
        let _ = self.element.set_attribute(self.name, value);
    }

    /// Sets it to something, or takes it away.
    pub(super) fn toggle(&self, on: bool) {
        let old = self.value.take();
        if old.is_some() == on {
            self.value.set(old);
            return;
        }
        self.value.set(on.then(String::new));
        let _ = if on {
            self.element.set_attribute(self.name, "")
        } else {
            self.element.remove_attribute(self.name)
        };
    }
}

/// The children of a layer, in order.
pub(super) fn children(layer: &NodeRef) -> Vec<Element> {
    let Some(layer) = layer.cast::<Element>() else {
        return Vec::new();
    };
    children_of(&layer)
}

/// The children of an element, in order.
pub(super) fn children_of(element: &Element) -> Vec<Element> {
    std::iter::successors(element.first_element_child(), Element::next_element_sibling).collect()
}

/// After each rendering of the component, makes a function of what it rendered
/// and calls it with the time of every frame.
#[hook]
pub(super) fn use_motion<M>(make: impl FnOnce() -> M + 'static)
where
    M: Fn(f64) + 'static,
{
    let clock = use_context::<Clock>();
    use_effect(move || {
        let listening = clock.map(|clock| clock.listen(make()));
        move || drop(listening)
    });
}
