//! What the page has to say, until its turn comes.

use std::collections::BTreeSet;
use std::rc::Rc;

use crate::Moment;

/// The page has something to say by itself, or was heard.
#[derive(Clone, Debug, PartialEq)]
pub enum SlotAction {
    /// What the browser kept could not be opened.
    Lose(Lost),
    /// What could not be opened was downloaded, or need not be told any longer.
    Settle,
    /// The browser does not keep the document.
    Unkept(Unkept),
    /// The browser keeps the document again.
    Kept,
    /// Another tab keeps something else of this scene.
    Differ(Box<Elsewhere>),
    /// The other tab has what is here again.
    Agree,
    /// Takes what the other tab has.
    TakeTheirs,
    /// Stays with what is here.
    KeepMine,
    /// What is said was heard.
    Close,
}

/// What the page has to say, until its turn comes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Waiting {
    /// What the browser kept could not be opened.
    pub lost: Option<Lost>,
    /// The browser does not keep the document.
    pub unkept: Option<Unkept>,
    /// What another tab did.
    pub other: Option<Other>,
    /// A link without a check was opened: nobody can see whether it was cut.
    pub unchecked: bool,
    /// The link inside another page was refused: nothing else is shown there.
    pub refused: bool,
    /// It is a first visit, and nobody has done anything yet.
    pub welcome: bool,
    /// The tabs that a person does not want to hear of.
    pub(crate) declined: BTreeSet<String>,
}

impl Waiting {
    /// The document has changed: who changed it needs no welcome, and what another tab
    /// did to the one before is old news.
    pub(crate) fn go_on(&mut self) {
        self.welcome = false;
        self.unchecked = false;
        if let Some(Other::Taken { .. }) = self.other {
            self.other = None;
        }
    }
}

/// Why kept data was not opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lost {
    /// A newer version of the page wrote it.
    Newer,
    /// It is damaged.
    Damaged,
    /// The page broke down as it opened it.
    Breaks,
}

/// Why the browser does not keep the document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unkept {
    /// There is no room.
    Full,
    /// It keeps nothing at all.
    Refused,
}

/// What another tab keeps.
#[derive(Clone, Debug, PartialEq)]
pub struct Elsewhere {
    /// Which tab.
    pub tab: String,
    /// Its document.
    pub moment: Moment,
    /// Whether it goes on from what is here.
    pub is_ahead: bool,
}

/// What another tab did.
#[derive(Clone, Debug, PartialEq)]
pub enum Other {
    /// It changed the scene, and so did this one.
    Apart {
        /// Which tab.
        tab: String,
        /// What it has.
        moment: Rc<Moment>,
    },
    /// It changed the scene, and this one has taken that.
    Taken {
        /// What it changed, as a sentence.
        change: String,
    },
}
