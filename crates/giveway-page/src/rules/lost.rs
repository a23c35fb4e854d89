//! Rules that go with a robot, a zone or a part of the map.

use giveway_model::words::Sentence;
use giveway_model::{Constraint, tr_data};

use crate::{Draft, Notice};

/// What a person must be told of the rules that went with a robot, a zone or a part of the
/// map; nothing where none did.
pub(crate) fn lost(before: &Draft, after: &Draft) -> Option<Notice> {
    let mut kept = after.scene().constraints.iter().peekable();
    let is_of = |names: &Option<Vec<String>>, of: &Option<Vec<String>>| match (names, of) {
        (Some(names), Some(of)) => names.iter().all(|name| of.contains(name)),
        (names, of) => names == of,
    };
    let mut lost: Vec<String> = Vec::new();
    for rule in &before.scene().constraints {
        // A rule stays with fewer robots, and perhaps under another name of one.
        let is_it = |other: &&Constraint| {
            other.kind == rule.kind && other.name == rule.name && is_of(&other.agents, &rule.agents)
        };
        if kept.next_if(is_it).is_none() {
            lost.push(rule.sentence());
        }
    }
    let count = before.scene().constraints.len();
    let is_fewer = after.scene().constraints.len() + lost.len() == count;
    (is_fewer && !lost.is_empty()).then(|| {
        let said = tr_data!(
            "{n} rule went with it. Undo brings it back."
                | "{n} rules went with it. Undo brings them back." % lost.len()
        );
        Notice::information(said).with(lost.into_iter().map(Sentence::from))
    })
}
