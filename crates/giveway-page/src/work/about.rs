//! What a task of the worker is about: it is ended where the document no longer holds that.

use std::rc::Rc;

use giveway_solve::explain::ExplainRequest;

use super::{Certifies, Task};
use crate::{Activity, Document, Draft, Mode};

impl Task {
    /// Whether a document still holds what the task is about.
    pub(super) fn is_about(&self, document: &Document) -> bool {
        match self {
            Self::Solve(solving) => {
                Rc::ptr_eq(&solving.draft, &document.draft)
                    && solving.request.within == document.within
                    && is_search_of(&document.mode)
            }
            Self::Explain(request) => asks(document, request),
            Self::Certify(run) => run.about.is_in(document),
            Self::Export(run) => run.about.is_in(document),
            Self::Look(looking) => is_of(&looking.draft, looking.within, document),
            Self::Change(run) => {
                let changing = document.mode.changing();
                changing.is_some_and(|changing| Rc::ptr_eq(changing, &run.changing))
            }
            Self::Freedom(request) => Certifies::Freedom(Rc::clone(request)).is_in(document),
            // The reducer ends it where its floor is another one.
            Self::Sizing(_) => true,
            Self::Price(draft, request) => is_of(draft, request.within, document),
            Self::Delays(request) => {
                let ledger = document.ledger();
                // A report tells an open question, too.
                ledger.is_some_and(|ledger| Rc::ptr_eq(&ledger.request, request))
                    && document.mode.activity == Activity::Editing
            }
            Self::Order(request) => {
                let order = document.order();
                order.is_some_and(|order| Rc::ptr_eq(&order.request, request))
                    && document.mode.is_editing()
            }
        }
    }
}

/// Whether a draft with a horizon is that of a document, and nothing else is done with it.
fn is_of(draft: &Rc<Draft>, within: Option<u32>, document: &Document) -> bool {
    Rc::ptr_eq(draft, &document.draft) && within == document.within && document.mode.is_editing()
}

impl Certifies {
    /// Whether a document still holds it.
    fn is_in(&self, document: &Document) -> bool {
        match self {
            Self::Question(request) => asks(document, request),
            Self::Answer(about) => {
                let answer = document.answer.as_ref();
                answer.is_some_and(|answer| Rc::ptr_eq(answer, about)) && document.mode.is_editing()
            }
            Self::Freedom(request) => {
                let freedom = document.freedom();
                freedom.is_some_and(|freedom| Rc::ptr_eq(&freedom.request, request))
                    && document.mode.is_editing()
            }
        }
    }
}

/// Whether a search for the best plan goes on in this mode: of the scene, or beside a plan
/// of elsewhere.
fn is_search_of(mode: &Mode) -> bool {
    let goes_on = match mode.activity {
        Activity::Editing | Activity::Auditing(_) => true,
        Activity::Changing(_) | Activity::Comparing(_) | Activity::Steering(_) => false,
    };
    goes_on && mode.asking().is_none()
}

/// Whether it is asked what a request asks.
fn asks(document: &Document, request: &Rc<ExplainRequest>) -> bool {
    let asking = document.mode.asking();
    asking.is_some_and(|asking| Rc::ptr_eq(&asking.request, request))
}
