//! Shared data that is compared by being the same object.

use std::ops::Deref;
use std::rc::Rc;

/// Shared data; two are equal if they are the same object, so that to compare
/// a long plan takes no time.
pub(crate) struct Same<T>(Rc<T>);

impl<T> Same<T> {
    pub(crate) const fn new(data: Rc<T>) -> Self {
        Self(data)
    }
}

impl<T> Clone for Same<T> {
    fn clone(&self) -> Self {
        Self(Rc::clone(&self.0))
    }
}

impl<T> PartialEq for Same<T> {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.0, &other.0)
    }
}

impl<T> Deref for Same<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.0
    }
}
