//! A plan of elsewhere in a text: what its file tells as the bytes of a message,
//! then each plan, joined by `!`. A plan is the letters of [`plan`], or bytes
//! where it cannot be written so; nothing where it is the document's own.

use std::rc::Rc;

use giveway_model::Plan;
use giveway_model::format::foreign::ForeignPlan;

use super::{extras, plan};
use crate::audit::{Audit, Beside, Dropped};
use crate::{Answer, Draft};

/// Before the letters of a plan, and before its bytes.
const LETTERS: char = 'l';
const BYTES: char = 'b';

/// What is told beside the plans: what their files tell, and the number of the one
/// that is looked at, and how.
type Told = (Vec<ForeignPlan>, Vec<String>, u32, u8);

/// The audit as text.
pub(super) fn write(audit: &Audit, own: Option<&Plan>) -> String {
    let empty = |dropped: &Rc<Dropped>| ForeignPlan {
        plan: Plan::default(),
        ..dropped.file.clone()
    };
    let plans = audit.plans.iter();
    let chosen = plans.clone().position(|one| Rc::ptr_eq(one, &audit.plan));
    let told: Told = (
        plans.clone().map(empty).collect(),
        audit.notes.clone(),
        chosen.and_then(|at| u32::try_from(at).ok()).unwrap_or(0),
        match audit.beside {
            Beside::Nothing => 0,
            Beside::Other => 1,
            Beside::InPlace => 2,
        },
    );
    let mut text = extras::write(&told);
    for dropped in plans {
        text.push('!');
        let plan = &dropped.file.plan;
        if own != Some(plan) {
            text += &one(dropped.answer.draft.as_ref(), plan);
        }
    }
    text
}

/// A plan in letters, where these tell it wholly; else in bytes.
fn one(draft: &Draft, own: &Plan) -> String {
    let agents = draft.agents();
    let letters = plan::write(agents, own);
    let letters =
        letters.filter(|text| plan::read(agents, text, Plan::default()).as_ref() == Some(own));
    match letters {
        Some(letters) => format!("{LETTERS}{letters}"),
        None => format!("{BYTES}{}", extras::write(own)),
    }
}

/// The audit that a text tells, judged anew; `None` where it is broken.
pub(super) fn read(draft: &Rc<Draft>, own: Option<&Rc<Answer>>, text: &str) -> Option<Audit> {
    let mut parts = text.split('!');
    let (files, notes, chosen, beside): Told = extras::read(parts.next()?)?;
    let mut plans = Vec::new();
    for (mut file, text) in files.into_iter().zip(parts) {
        file.plan = match text.chars().next() {
            None => own?.plan()?.clone(),
            Some(LETTERS) => plan::read(draft.agents(), text.get(1..)?, Plan::default())?,
            Some(BYTES) => extras::read(text.get(1..)?)?,
            Some(_) => return None,
        };
        plans.push(Rc::new(Dropped::new(draft, file)?));
    }
    let plan = plans.get(chosen as usize).cloned()?;
    let audit = Audit::new(plans, notes, Rc::default())?;
    Some(Audit {
        plan,
        beside: match beside {
            1 => Beside::Other,
            2 => Beside::InPlace,
            _ => Beside::Nothing,
        },
        ..audit
    })
}
