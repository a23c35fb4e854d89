//! Splits by hand, as a part of the page's state: where there are none it holds nothing, so that
//! a first visit, which clones and compares the state, needs nothing of them.

use std::ops::Deref;
use std::rc::Rc;

use giveway_solve::plan::HandSplit;

/// Some splits, the first of them first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Splits(Option<Rc<Vec<HandSplit>>>);

impl Deref for Splits {
    type Target = [HandSplit];

    fn deref(&self) -> &[HandSplit] {
        self.0.as_ref().map_or(&[], |splits| splits.as_slice())
    }
}

impl Splits {
    pub(crate) fn push(&mut self, split: HandSplit) {
        Rc::make_mut(self.0.get_or_insert_default()).push(split);
    }

    /// Takes the last one out.
    pub(crate) fn pop(&mut self) -> Option<HandSplit> {
        let splits = Rc::make_mut(self.0.as_mut()?);
        let last = splits.pop();
        if splits.is_empty() {
            self.clear();
        }
        last
    }

    pub(crate) fn clear(&mut self) {
        self.0 = None;
    }
}
