//! The plan on the board, asked how good it is: it is audited like one of elsewhere.

use giveway_model::words::Later;
use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_formats::{Conventions, Fit, ForeignPlan, Format};
use giveway_model::compare::{Claimed, ClaimedBounds};
use giveway_model::{Plan, tr, tr_later};
use giveway_solve::Status;

use super::{Audit, Dropped};
use crate::{Answer, Draft, State};

/// What its file is called where there is none.
const NAME: Later = tr_later!("This plan");
/// What is asked of it.
const QUESTION: Later = tr_later!("How good is this plan?");

/// The plan on the board, where it can be asked how good that is: nothing is proved
/// of it yet, or not enough.
pub(super) fn plan(state: &State) -> Option<&Rc<Answer>> {
    let document = &state.document;
    let answer = document.fresh_answer()?;
    let is_open = answer.solved.status == Status::Feasible;
    let is_one = answer.course.is_none() && document.own_front().is_none();
    let is_shown = document.mode.is_editing();
    (is_open && is_one && is_shown && answer.plan().is_some()).then_some(answer)
}

/// The question that begins the audit of the plan on the board; `None` where that
/// cannot be asked.
pub fn question(state: &State) -> Option<&'static str> {
    plan(state).map(|_| QUESTION.text())
}

impl Audit {
    /// The audit of the plan on the board, with what is known of it.
    pub(crate) fn of_own(state: &State) -> Option<Self> {
        let answer = plan(state)?;
        let dropped = Rc::new(Dropped::own(&answer.draft, answer.plan()?)?);
        let audit = Self::new(vec![dropped], Vec::new(), Rc::default())?;
        Some(Self {
            ours: (!answer.is_shared).then(|| Rc::clone(answer)),
            ..audit
        })
    }
}

impl Dropped {
    /// A plan that no file holds, judged; `None` where the draft is no valid scene.
    pub(crate) fn own(draft: &Rc<Draft>, plan: &Plan) -> Option<Self> {
        let file = ForeignPlan {
            file: NAME.text().to_owned(),
            format: Format::Giveway,
            words: Vec::new(),
            conventions: Conventions::OWN,
            why: String::new(),
            alternatives: Vec::new(),
            fit: Fit::default(),
            claimed: Claimed::default(),
            written: Claimed::default(),
            headings: BTreeMap::new(),
            notes: Vec::new(),
            plan: plan.clone(),
            bounds: ClaimedBounds::default(),
        };
        Self::new(draft, file)
    }

    /// Whether it was on the board before: then no file says anything of it.
    pub(super) fn is_own(&self) -> bool {
        self.file.format == Format::Giveway && self.file.file == NAME.text()
    }

    /// What its audit is called.
    pub(super) fn title(&self) -> &'static str {
        if self.is_own() {
            QUESTION.text()
        } else {
            tr!("A plan from elsewhere")
        }
    }
}
