//! What was found out about a scene and its plan, as only this browser keeps it: what rules
//! cost, who costs whom, the questions that were answered.

use std::fmt::Write as _;
use std::rc::Rc;

use giveway_solve::Limits;

use super::text::{escape, unescape};
use super::{answers, ask};
use crate::ledger::Ledger;
use crate::rules::Pricing;
use crate::{Answer, Asking, Document};

/// Between two questions.
const NEXT: char = '~';
/// Between a question and its answer, or a mark and what it is about.
const TOLD: char = '!';

/// What was found out, as parts of the document's text. A ledger that is still added up is not: it is
/// asked for again.
pub(super) fn write(document: &Document) -> String {
    let mut text = String::new();
    let prices = document.prices();
    if let Some((prices, told)) = prices.and_then(|prices| Some((prices, prices.told.as_deref()?)))
    {
        text += "&prices=";
        // Writing to a string cannot fail.
        let _ = write!(text, "{}{TOLD}{}", prices.seconds, answers::write(told));
    }
    let ledger = document.ledger();
    if let Some((ledger, told)) = ledger.and_then(|ledger| Some((ledger, ledger.told.as_deref()?)))
        && !told.pending
    {
        let is_of_report = if ledger.is_of_report { '1' } else { '0' };
        text += "&ledger=";
        text.extend([is_of_report, TOLD]);
        text += &answers::write(told);
    }
    let past = questions(document);
    if !past.is_empty() {
        text += "&past=";
        text += &past;
    }
    text
}

/// The prices of the rules of a document; `Some(None)` where they are of another form.
#[expect(clippy::option_option, reason = "broken is not the same as left out")]
pub(super) fn prices(document: &Document, text: &str) -> Option<Option<Pricing>> {
    let (seconds, told) = text.split_once(TOLD)?;
    let seconds = seconds.parse().ok()?;
    let told = answers::read(told)?;
    Some(told.map(|told| Pricing {
        draft: Rc::clone(&document.draft),
        within: document.within,
        told: Some(Rc::new(told)),
        before: None,
        seconds,
    }))
}

/// The ledger of a plan; `Some(None)` where it is of another form.
#[expect(clippy::option_option, reason = "broken is not the same as left out")]
pub(super) fn ledger(about: &Rc<Answer>, text: &str) -> Option<Option<Ledger>> {
    let (is_of_report, told) = text.split_once(TOLD)?;
    let begun = match is_of_report {
        "0" => Ledger::about(about, Limits::default())?,
        "1" => Ledger::of_report(about)?,
        _ => return None,
    };
    let told = answers::read(told)?;
    Some(told.map(|told| Ledger {
        told: Some(Rc::new(told)),
        ..begun
    }))
}

/// The questions that were asked of the plan on the board, and answered.
fn questions(document: &Document) -> String {
    let Some(about) = document.fresh_answer() else {
        return String::new();
    };
    let changes = about.course.as_ref().map(|course| &course.changes);
    let kept = document.asked.iter().filter_map(|asking| {
        let is_of = Rc::ptr_eq(&asking.about, about) && asking.request.changes.as_ref() == changes;
        let told = asking.told.as_deref().filter(|_| is_of)?;
        let question = escape(&ask::write(asking.question()));
        Some(format!("{question}{TOLD}{}", answers::write(told)))
    });
    let kept: Vec<String> = kept.collect();
    kept.join(&NEXT.to_string())
}

/// The questions that were answered; those whose answers are of another form are left out.
pub(super) fn past(about: &Rc<Answer>, text: &str) -> Option<Vec<Rc<Asking>>> {
    let mut past = Vec::new();
    for part in text.split(NEXT) {
        let (question, told) = part.split_once(TOLD)?;
        let question = ask::read(&unescape(question)?)?;
        if let Some(told) = answers::read(told)? {
            let mut asking = Asking::about(about, question, Limits::default());
            asking.learn(told);
            past.push(Rc::new(asking));
        }
    }
    Some(past)
}
