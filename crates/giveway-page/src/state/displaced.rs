//! A document that another one took the place of.

use std::rc::Rc;

use crate::history::Moment;

/// A document that another one was opened in the place of.
#[derive(Clone, Debug, PartialEq)]
pub struct Displaced {
    /// That document.
    pub moment: Rc<Moment>,
    /// What took its place: a link, or what a person went back to.
    pub by: By,
}

/// What took the place of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// The document of a link.
    Link,
    /// A person's own one, after they went back to it from that of a link.
    Own,
}
