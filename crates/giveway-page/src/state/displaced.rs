//! A document that another one replaced.

use std::rc::Rc;

use crate::history::Moment;

/// A document that another one replaced.
#[derive(Clone, Debug, PartialEq)]
pub struct Displaced {
    /// That document.
    pub moment: Rc<Moment>,
    /// What replaced it: a link, or the document that a person went back to.
    pub by: By,
}

/// What replaced a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// The document of a link.
    Link,
    /// A person's own one, after they went back to it from that of a link.
    Own,
}
