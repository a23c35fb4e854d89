//! How large the parts of a hand-in may be.

use giveway_model::{Fault, tr};

use super::{Answer, Edits, HandIn, Work};
use crate::lesson::Value;
use crate::lesson::read::{MAX_CELLS, MAX_STEPS, MAX_TIME, MAX_TITLE};

/// The most bytes of a file.
pub const MAX_BYTES: usize = 200_000;
/// The most characters of a person's name.
pub const MAX_NAME: usize = 60;
/// The most tries that a file may tell.
pub const MAX_TRIES: u32 = 1_000_000;
/// The most letters of the answers to one task that a browser keeps.
pub(super) const MAX_WORK: usize = 20_000;
/// The most brackets within each other.
pub(super) const MAX_DEPTH: usize = 12;
/// The most characters of a robot's name.
const MAX_ROBOT: usize = 200;
/// The most robots and marks of an answer.
const MAX_ROBOTS: usize = 2_000;

/// Whether a character may stand in a name: no control character, and none that turns the
/// direction of what follows.
pub(crate) fn is_plain(c: char) -> bool {
    let turns = matches!(
        c,
        '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}'
    );
    let hides = matches!(c, '\u{2028}' | '\u{2029}' | '\u{feff}' | '\u{200b}');
    !c.is_control() && !turns && !hides
}

/// What is wrong with a hand-in that is of the right form.
pub(super) fn faults(hand_in: &HandIn) -> Option<Fault> {
    let name = hand_in.name.as_deref();
    let title = hand_in.hand_in.title.as_str();
    name.and_then(|name| word("name", name, MAX_NAME))
        .or_else(|| word("hand-in.title", title, MAX_TITLE))
        .or_else(|| few("tasks", hand_in.tasks.len(), MAX_STEPS))
        .or_else(|| {
            let mut tasks = hand_in.tasks.iter().enumerate();
            tasks.find_map(|(index, work)| Some(check(work)?.of_part(&format!("tasks[{index}]"))))
        })
        .or_else(|| twice(hand_in))
}

/// Steps follow each other, each once.
fn twice(hand_in: &HandIn) -> Option<Fault> {
    let mut pairs = hand_in.tasks.windows(2).enumerate();
    pairs.find_map(|(index, pair)| match pair {
        [one, two] if one.step >= two.step => {
            let place = format!("tasks[{}].step", index + 1);
            let (found, before) = (two.step + 1, one.step + 1);
            let found = tr!("step {step} after step {before}", step = found, before);
            Some(Fault::at(place, found, tr!("each step once, in order")))
        }
        _ => None,
    })
}

/// What is wrong with what was done for one task.
pub(super) fn check(work: &Work) -> Option<Fault> {
    let most = MAX_STEPS as u32;
    number("step", work.step as u32 + 1, most)
        .or_else(|| number("tries", work.tries, MAX_TRIES))
        .or_else(|| Some(edits(&work.board)?.of_part("board")))
        .or_else(|| Some(answer(work.answer.as_ref()?)?.of_part("answer")))
        .or_else(|| Some(answer(work.first.as_ref()?)?.of_part("first")))
}

fn answer(answer: &Answer) -> Option<Fault> {
    match answer {
        Answer::Value { value } => match value {
            Value::Robot(name) => word("value", name, MAX_ROBOT),
            Value::Number(_) | Value::Cell(_) | Value::Rule { .. } => None,
        },
        Answer::Shown {} | Answer::NoOrder {} | Answer::Choice { .. } | Answer::Method { .. } => {
            None
        }
        Answer::Marks { marks } => few("marks", marks.len(), MAX_ROBOTS).or_else(|| {
            marks.iter().find_map(|mark| {
                few("marks", mark.cells.len(), 4)
                    .or_else(|| few("marks", mark.robots.len(), 4))
                    .or_else(|| words("marks", &mark.robots))
                    .or_else(|| number("marks", mark.time, MAX_TIME))
            })
        }),
        Answer::Order { order } => words("order", order),
        Answer::Edits(edits) => self::edits(edits),
        Answer::Paths { paths, charges } => {
            let names = paths.keys().chain(charges.keys());
            let most = MAX_TIME as usize + 1;
            let long = paths.values().map(Vec::len);
            let long = long.chain(charges.values().map(Vec::len)).max();
            let names: Vec<String> = names.cloned().collect();
            words("paths", &names).or_else(|| few("paths", long.unwrap_or(0), most))
        }
    }
}

fn edits(edits: &Edits) -> Option<Fault> {
    let names: Vec<String> = edits
        .robots
        .iter()
        .map(|agent| agent.name.clone())
        .collect();
    let waypoints = edits.robots.iter().map(|agent| agent.waypoints.len()).max();
    few("cells", edits.cells.len(), MAX_CELLS)
        .or_else(|| words("robots", &names))
        .or_else(|| words("gone", &edits.gone))
        .or_else(|| few("robots", waypoints.unwrap_or(0), MAX_CELLS))
}

fn few(place: &str, count: usize, most: usize) -> Option<Fault> {
    let found = || tr!("{n} entry" | "{n} entries" % count);
    (count > most).then(|| Fault::at(place, found(), tr!("at most {most}", most)))
}

fn number(place: &str, number: u32, most: u32) -> Option<Fault> {
    (number > most).then(|| Fault::at(place, number.to_string(), tr!("at most {most}", most)))
}

fn words(place: &str, all: &[String]) -> Option<Fault> {
    let bad = || all.iter().find_map(|one| word(place, one, MAX_ROBOT));
    few(place, all.len(), MAX_ROBOTS).or_else(bad)
}

/// A name must be short, and be read as it is written.
fn word(place: &str, word: &str, most: usize) -> Option<Fault> {
    let count = word.chars().count();
    if word.trim().is_empty() {
        return Some(Fault::at(
            place,
            tr!("an empty name"),
            tr!("a name, or none at all"),
        ));
    }
    if count > most {
        let found = tr!("{n} character" | "{n} characters" % count);
        return Some(Fault::at(place, found, tr!("at most {most}", most)));
    }
    word.chars().find(|c| !is_plain(*c)).map(|c| {
        let found = tr!(
            "the character U+{code}",
            code = format!("{:04X}", u32::from(c))
        );
        Fault::at(
            place,
            found,
            tr!("letters that are read as they are written"),
        )
    })
}
