//! What was being done with a plan, as only this browser keeps it.

use std::rc::Rc;

use giveway_solve::Limits;

use super::parts::Parts;
use crate::asking::Asking;
use crate::changing::{Changing, Comparing};
use crate::link::{answers, ask, change, steering};
use crate::{Activity, Answer, Mode};

/// What was being done with the plan.
///
/// # Errors
/// Which part is broken, as a sentence.
pub(super) fn mode(about: &Rc<Answer>, parts: &Parts<'_>) -> Result<Mode, String> {
    let own = parts.read("own", |text| steering::read(about, text))?;
    let own = own.map(Rc::new);
    let changing = parts.read("listed", |text| listed(about, text))?;
    let changing = changing.map(Rc::new);
    let comparing = match &changing {
        Some(changing) => parts.read("compared", |text| compared(changing, text))?,
        None => None,
    }
    .flatten();
    let comparing = comparing.map(Rc::new);
    let asking = match parts.read("asked", ask::read)? {
        Some(question) => {
            let limits = Limits::default();
            let asking = match (&own, &changing) {
                (Some(own), _) => Asking::about(&own.answer, question, limits),
                (None, Some(changing)) => Asking::stuck(changing, limits),
                (None, None) => Asking::about(about, question, limits),
            };
            Some(Rc::new(told(asking, parts)?))
        }
        None => None,
    };
    let activity = match (own, comparing, changing) {
        (Some(own), _, _) => Activity::Steering(own),
        (None, Some(comparing), _) => Activity::Comparing(comparing),
        // Nothing is asked while changes are being listed.
        (None, None, Some(changing)) => return Ok(Activity::Changing(changing).into()),
        (None, None, None) => Activity::Editing,
    };
    Ok(Mode::from(activity).with(asking))
}

/// The question that was asked about an answer.
///
/// # Errors
/// That it is broken.
pub(super) fn asking(about: &Rc<Answer>, parts: &Parts<'_>) -> Result<Option<Rc<Asking>>, String> {
    let Some(question) = parts.read("asked", ask::read)? else {
        return Ok(None);
    };
    let asking = Asking::about(about, question, Limits::default());
    Ok(Some(Rc::new(told(asking, parts)?)))
}

/// What was being listed.
fn listed(about: &Rc<Answer>, text: &str) -> Option<Changing> {
    let (at, list) = text.split_once('!')?;
    let changing = Changing::begin(about, at.parse().ok()?)?;
    let list = change::read(list, about.agents().len())?.changes;
    let list = list.into_iter().map(|change| change.what).collect();
    changing.with(list).ok()
}

/// The methods' answers, and which of them was chosen; `Some(None)` where they are of
/// another form.
#[expect(clippy::option_option, reason = "broken is not the same as left out")]
fn compared(changing: &Rc<Changing>, text: &str) -> Option<Option<Comparing>> {
    let (chosen, told) = text.split_once('!')?;
    let chosen: usize = chosen.parse().ok()?;
    let Some(told) = answers::read(told)? else {
        return Some(None);
    };
    let mut comparing = Comparing::new(changing, told)?;
    comparing.chosen = chosen.checked_sub(1);
    Some(Some(comparing))
}

/// A question with what was told of it.
fn told(mut asking: Asking, parts: &Parts<'_>) -> Result<Asking, String> {
    if let Some(told) = parts.read("told", answers::read)?.flatten() {
        asking.learn(told);
    }
    if let Some(report) = parts.read("told-report", answers::read)?.flatten() {
        asking.report = Some(Rc::new(report));
    }
    asking.shows_other = parts.get("shows-other") == Some("1") && asking.other.is_some();
    Ok(asking)
}
