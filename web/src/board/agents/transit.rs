//! The capsule over both cells of a slow move.

use giveway_model::Cell;
use web_sys::Element;

use crate::board::motion::Attribute;
use crate::held::Held;

/// The capsule over both cells of a slow move.
pub(super) struct Transit {
    element: Element,
    off: Attribute,
    over: Held<Option<(Cell, Cell)>>,
}

impl Transit {
    pub(super) fn new(element: Element) -> Self {
        let off = Attribute::new(element.clone(), "data-off");
        Self {
            element,
            off,
            over: Held::new(None),
        }
    }

    pub(super) fn show(&self, over: Option<(Cell, Cell)>) {
        self.off.toggle(over.is_none());
        let Some((from, to)) = over else { return };
        if self.over.get() == over {
            return;
        }
        self.over.set(over);
        let (left, top) = (from.x.min(to.x), from.y.min(to.y));
        let (across, down) = (from.x.abs_diff(to.x), from.y.abs_diff(to.y));
        let sides = [
            ("x", 100 * left + 8),
            ("y", 100 * top + 8),
            ("width", 100 * across + 84),
            ("height", 100 * down + 84),
        ];
        for (name, value) in sides {
            // The names are valid, so that it cannot fail.
            let _ = self.element.set_attribute(name, &value.to_string());
        }
    }
}
