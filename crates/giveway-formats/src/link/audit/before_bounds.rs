//! Readings of files as links had them before claimed bounds were kept: such links still open.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};

use super::AuditedPlans;
use crate::{Alternative, Conventions, Fit, ForeignPlan, Format, Heading};
use giveway_model::Plan;
use giveway_model::compare::{Claimed, ClaimedBounds};
use giveway_model::format::link::message;

/// [`AuditedPlans`] as it was.
#[derive(BorshSerialize, BorshDeserialize)]
struct Before {
    files: Vec<Earlier>,
    notes: Vec<String>,
    chosen: u32,
    beside: u8,
}

/// A [`ForeignPlan`] as it was.
#[derive(BorshSerialize, BorshDeserialize)]
struct Earlier {
    file: String,
    format: Format,
    words: Vec<(String, String)>,
    conventions: Conventions,
    why: String,
    alternatives: Vec<Alternative>,
    fit: Fit,
    claimed: Claimed,
    written: Claimed,
    headings: BTreeMap<String, Vec<Heading>>,
    notes: Vec<String>,
    plan: Plan,
}

/// Reads what files tell; `None` where it is of no such form.
pub(super) fn read(text: &str) -> Option<AuditedPlans> {
    let before: Before = message::read(text)?;
    Some(AuditedPlans {
        files: before.files.into_iter().map(Earlier::now).collect(),
        notes: before.notes,
        chosen: before.chosen,
        beside: before.beside,
    })
}

impl Earlier {
    /// The same without bounds.
    fn now(self) -> ForeignPlan {
        ForeignPlan {
            file: self.file,
            format: self.format,
            words: self.words,
            conventions: self.conventions,
            why: self.why,
            alternatives: self.alternatives,
            fit: self.fit,
            claimed: self.claimed,
            written: self.written,
            headings: self.headings,
            notes: self.notes,
            plan: self.plan,
            bounds: ClaimedBounds::default(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_written_before_is_read() {
        let file = Earlier {
            file: "a.csv".to_owned(),
            format: Format::Tracker,
            words: Vec::new(),
            conventions: Conventions::OWN,
            why: String::new(),
            alternatives: Vec::new(),
            fit: Fit::default(),
            claimed: Claimed {
                makespan: None,
                sum_of_costs: Some(7),
            },
            written: Claimed::default(),
            headings: BTreeMap::new(),
            notes: vec!["It was so.".to_owned()],
            plan: Plan::default(),
        };
        let before = Before {
            files: vec![file],
            notes: Vec::new(),
            chosen: 0,
            beside: 1,
        };
        let text = message::write(&before);
        assert_eq!(message::read::<AuditedPlans>(&text), None);
        let audited = read(&text).unwrap_or_else(|| unreachable!("{text}"));
        assert_eq!(audited.files[0].claimed.sum_of_costs, Some(7));
        assert_eq!((audited.beside, &*audited.files[0].file), (1, "a.csv"));
    }
}
