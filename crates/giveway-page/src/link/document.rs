//! A document as text: what a link shares of it, or all that the browser keeps.

use std::fmt::Write as _;
use std::rc::Rc;

use super::text::escape;
use super::{From, answers, ask, audit, change, claim, found, knowledge, plan, scene, steering};
use crate::{Answer, Colours, Document, Looks};

/// The document as parts joined by `&`. What is written for anywhere holds no
/// claims, as nobody there would believe them.
pub(super) fn write(document: &Document, whom: From) -> String {
    let mut text = scene::write(document.draft.scene());
    // Writing to a string cannot fail.
    if let Some(within) = document.within {
        let _ = write!(text, "&within={within}");
    }
    if document.colours != Colours::default() {
        let numbers = document.colours.numbers().map(|n| n.to_string());
        let _ = write!(text, "&colours={}", numbers.join("."));
    }
    if document.looks != Looks::default() {
        let numbers = document.looks.numbers().iter().map(ToString::to_string);
        let numbers: Vec<String> = numbers.collect();
        let _ = write!(text, "&looks={}", numbers.join("."));
    }
    if let Some(answer) = document.fresh_answer() {
        text += &answered(answer, whom);
    }
    if let Some(about) = document.mode.audit() {
        text += "&audit=";
        text += &audit::write(about, document.plan());
    }
    if whom == From::Here {
        text += &kept(document);
    }
    text
}

/// An answer: its plan with the changes around it, and what is claimed.
fn answered(answer: &Answer, whom: From) -> String {
    let mut text = String::new();
    let written = answer.plan();
    let written = written.and_then(|plan| plan::write(answer.agents(), plan));
    if let Some(written) = &written {
        if let Some(course) = &answer.course {
            text += "&changes=";
            text += &change::write(&course.changes.changes);
        }
        text += "&plan=";
        text += written;
        if let Some(plan) = answer.plan() {
            text += &knowledge::write(answer.agents(), plan);
        }
    }
    if whom == From::Here && (written.is_some() || answer.plan().is_none()) {
        text += "&claim=";
        text += &claim::write(&answer.solved);
        if let Some(course) = &answer.course {
            text += "&steps=";
            text += &change::write_steps(&course.steps);
        }
        if let Some(within) = answer.request.within {
            let _ = write!(text, "&asked-within={within}");
        }
        if let Some(planner) = answer.by {
            let _ = write!(text, "&planner={planner}");
        }
    }
    text
}

/// What only this browser keeps.
fn kept(document: &Document) -> String {
    let mut text = found::write(document);
    if let Some(stale) = document.answer.as_ref().filter(|_| document.is_stale()) {
        let whole = Document::answered(stale.draft.clone(), Some(stale.clone()));
        text += "&stale=";
        text += &escape(&write(&whole, From::Here));
    }
    let ours = document.mode.audit().and_then(|audit| audit.ours.as_ref());
    if let Some(ours) = ours {
        let whole = Document::answered(Rc::clone(&ours.draft), Some(Rc::clone(ours)));
        text += "&ours=";
        text += &escape(&write(&whole, From::Here));
    }
    if let Some(front) = document.found_front.as_deref()
        && document.front().is_some()
    {
        text += "&front=";
        text += &answers::write(front.told());
    }
    if let Some(report) = document.report() {
        text += "&report=";
        text += &answers::write(report);
    }
    if let Some(changing) = document.mode.changing() {
        let changes = changing.changes().changes;
        let listed = changes.len().saturating_sub(changing.list.len());
        let listed = change::write(changes.get(listed..).unwrap_or_default());
        let _ = write!(text, "&listed={}!{listed}", changing.at);
    }
    if let Some(comparing) = document.mode.comparing() {
        let chosen = comparing.chosen.map_or(0, |chosen| chosen + 1);
        let told = answers::write(&*comparing.told);
        let _ = write!(text, "&compared={chosen}!{told}");
    }
    if let Some(own) = document
        .mode
        .steering()
        .and_then(|own| steering::write(own))
    {
        text += "&own=";
        text += &own;
    }
    if let Some(asking) = document.mode.asking() {
        text += "&asked=";
        text += &ask::write(asking.question());
        if let Some(told) = &asking.told {
            let _ = write!(text, "&shows-other={}", u32::from(asking.shows_other));
            text += "&told=";
            text += &answers::write(&**told);
        }
        if let Some(report) = &asking.report {
            text += "&told-report=";
            text += &answers::write(&**report);
        }
    }
    text
}
