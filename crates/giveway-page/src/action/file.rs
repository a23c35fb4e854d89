//! Documents come and go.

use giveway_model::Scene;

use crate::link::Linked;
use crate::{Moment, Notice};

/// Documents come and go.
#[derive(Clone, Debug, PartialEq)]
pub enum FileAction {
    /// A scene was opened: it takes the place of the one on the board.
    Open(Box<Scene>),
    /// A link, a file, or what the browser kept was opened.
    OpenLink(Box<Linked>),
    /// Back to the document that another one was opened in the place of.
    Back,
    /// What was displaced need not be told any longer.
    Keep,
    /// A document that the browser kept takes the place of the one on the board.
    Resume(Box<Moment>),
    /// What became of something that was copied, opened or saved; the document stays.
    Tell(Notice),
    /// Tells why a link is not opened.
    RefuseLink(Notice),
}
