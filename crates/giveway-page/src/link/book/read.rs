//! What the browser kept is read again: whole where it kept it itself, and without its
//! past and its claims where it comes from elsewhere.

use std::rc::Rc;

use giveway_model::{Cell, tr, tr_data};

use super::{DISPLACED, HEAD};
use crate::history::Moment;
use crate::link::kin::is_newer;
use crate::link::read::{Reader, is_public};
use crate::link::{From, Linked, Source};
use crate::state::{By, Displaced};
use crate::{History, Notice, Selection, State};

/// Reads what [`keep`](super::keep) wrote, or what the first version kept: the page as it was
/// left. Of the past, what cannot be read is left out with all before it.
///
/// # Errors
/// Why it cannot be read, in sentences.
pub fn kept(text: &str) -> Result<State, Notice> {
    read(text).map_err(unread)
}

/// Reads a document that this browser kept, without its past.
///
/// # Errors
/// As [`kept`].
pub fn kept_moment(text: &str) -> Result<Moment, Notice> {
    kept(text).map(|state| state.moment())
}

/// Reads a kept document that comes from anywhere, as a file does: without its
/// past, and without what it claims of its plan.
///
/// # Errors
/// As [`kept`].
pub fn kept_elsewhere(text: &str) -> Result<Linked, Notice> {
    let mut lines = text.lines();
    let document = match lines.next() {
        Some(HEAD) => first(lines).ok_or(tr!("It holds no document.").to_owned()),
        Some(line) if line.starts_with("giveway=") => Ok(line.to_owned()),
        _ => Err(newer(text)),
    };
    let shared = document.map(|document| {
        let parts = document.split('&').filter(|part| is_public(part));
        parts.collect::<Vec<_>>().join("&")
    });
    let linked = shared.and_then(|text| Reader::default().read(&text, From::Anywhere));
    let linked = linked.map_err(unread)?;
    Ok(Linked {
        source: Source::File,
        ..linked
    })
}

fn read(text: &str) -> Result<State, String> {
    let mut lines = text.lines();
    let mut reader = Reader::default();
    match lines.next() {
        Some(HEAD) => {}
        // The first version kept one document.
        Some(line) if line.starts_with("giveway=") => {
            let linked = reader.read(line, From::Here)?;
            let moment = Moment {
                document: linked.document,
                time: linked.time,
                selection: Selection::Nothing,
            };
            return Ok(State::resumed(moment, History::of(Vec::new())));
        }
        _ => return Err(newer(text)),
    }
    let (mut parts, mut moments) = (Vec::new(), Vec::new());
    let (mut touched, mut displaced) = (false, false);
    for line in lines {
        if let Some(part) = line.strip_prefix('=') {
            parts.push(part);
        } else if let Some(moment) = line.strip_prefix('+') {
            match read_moment(&mut reader, moment, &parts) {
                Ok(moment) => moments.push(moment),
                Err(why) if moments.is_empty() => return Err(why),
                Err(_) => break,
            }
        } else {
            touched |= line == "touched";
            displaced |= line == DISPLACED;
        }
    }
    let mut moments = moments.into_iter();
    let present = moments.next().ok_or(tr!("It holds no document."))?;
    let mut past: Vec<Moment> = moments.collect();
    past.reverse();
    let history = if touched {
        History::of(past)
    } else {
        History::default()
    };
    let last = history.past().last().filter(|_| displaced).cloned();
    let mut state = State::resumed(present, history);
    state.displaced = last.map(|moment| Displaced {
        moment: Rc::new(moment),
        by: By::Link,
    });
    Ok(state)
}

fn read_moment(reader: &mut Reader, line: &str, parts: &[&str]) -> Result<Moment, String> {
    let broken = || tr!("Its list of documents is broken.").to_owned();
    let mut words = line.split('.');
    let time = words.next().and_then(|time| time.parse().ok());
    let selection = words.next().and_then(read_selection);
    let mut text = String::new();
    for place in words {
        let place: usize = place.parse().map_err(|_| broken())?;
        if !text.is_empty() {
            text.push('&');
        }
        text += parts.get(place).ok_or_else(broken)?;
    }
    Ok(Moment {
        time: time.ok_or_else(broken)?,
        selection: selection.ok_or_else(broken)?,
        document: reader.read(&text, From::Here)?.document,
    })
}

fn read_selection(text: &str) -> Option<Selection> {
    if text == "-" {
        return Some(Selection::Nothing);
    }
    if let Some(agent) = text.strip_prefix('a') {
        return agent.parse().ok().map(Selection::Agent);
    }
    let (x, y) = text.strip_prefix('c')?.split_once(':')?;
    Some(Selection::Cell(Cell::new(x.parse().ok()?, y.parse().ok()?)))
}

/// The text of the document that stands first.
fn first(lines: std::str::Lines<'_>) -> Option<String> {
    let mut parts = Vec::new();
    for line in lines {
        if let Some(part) = line.strip_prefix('=') {
            parts.push(part);
        } else if let Some(moment) = line.strip_prefix('+') {
            let places = moment.split('.').skip(2);
            let own = places.map(|place| parts.get(place.parse::<usize>().ok()?).copied());
            return Some(own.collect::<Option<Vec<_>>>()?.join("&"));
        }
    }
    None
}

/// Why a text is none that this page reads.
fn newer(text: &str) -> String {
    if is_newer(text) {
        tr!("A newer version of this page has written it.").to_owned()
    } else {
        tr!("It is no document of Giveway.").to_owned()
    }
}

fn unread(why: String) -> Notice {
    Notice::refusal(tr_data!("What this browser kept cannot be read.")).with([why])
}
