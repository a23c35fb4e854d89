//! Plans of elsewhere in a text: what their files tell as the bytes of a message, then
//! each plan, joined by `!`. A plan is the letters of [`plan`], or bytes where it cannot
//! be written so; nothing where it is the one that the text has already.

use borsh::{BorshDeserialize, BorshSerialize};

mod before_bounds;

use crate::ForeignPlan;
use giveway_model::format::link::{message, plan};
use giveway_model::{Agent, Plan};

/// Before the letters of a plan, and before its bytes.
const LETTERS: char = 'l';
const BYTES: char = 'b';

/// Plans of elsewhere, and which of them is looked at.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct AuditedPlans {
    /// The reading of each file, with its plan.
    pub files: Vec<ForeignPlan>,
    /// The notes on the scene.
    pub notes: Vec<String>,
    /// The number of the plan that is looked at.
    pub chosen: u32,
    /// How it is looked at: a number of the page's.
    pub beside: u8,
}

/// The plans as text; `own` is the one that the text has already.
pub fn write(agents: &[Agent], mut audited: AuditedPlans, own: Option<&Plan>) -> String {
    let plans: Vec<Plan> = audited
        .files
        .iter_mut()
        .map(|file| std::mem::take(&mut file.plan))
        .collect();
    let mut text = message::write(&audited);
    for plan in &plans {
        text.push('!');
        if own != Some(plan) {
            text += &one(agents, plan);
        }
    }
    text
}

/// A plan in letters, where these tell it wholly; else in bytes.
fn one(agents: &[Agent], own: &Plan) -> String {
    let letters = plan::write(agents, own);
    let letters =
        letters.filter(|text| plan::read(agents, text, Plan::default()).as_ref() == Some(own));
    match letters {
        Some(letters) => format!("{LETTERS}{letters}"),
        None => format!("{BYTES}{}", message::write(own)),
    }
}

/// The plans that a text tells; `None` where it is broken. They may break any rule.
pub fn read(agents: &[Agent], own: Option<&Plan>, text: &str) -> Option<AuditedPlans> {
    let mut parts = text.split('!');
    let first = parts.next()?;
    let mut audited: AuditedPlans = message::read(first).or_else(|| before_bounds::read(first))?;
    let mut files = Vec::new();
    for (mut file, text) in audited.files.into_iter().zip(parts) {
        file.plan = match text.chars().next() {
            None => own?.clone(),
            Some(LETTERS) => plan::read(agents, text.get(1..)?, Plan::default())?,
            Some(BYTES) => message::read(text.get(1..)?)?,
            Some(_) => return None,
        };
        files.push(file);
    }
    audited.files = files;
    Some(audited)
}
