//! The sentence of a rule in pieces: words, and slots that can be filled.
//!
//! The sentence is the one of the model in the language that is spoken. Each part that can be
//! changed is replaced by a mark that no sentence has; where the marks stand in the sentence,
//! there are the slots. So one piece of code serves all kinds and all languages.

use giveway_model::condition::Times;
use giveway_model::constraint::{ConstraintKind, meant};
use giveway_model::words::{and, capital};
use giveway_model::{Agent, Cell, Constraint, tr};

use super::parts;
use super::who::{all_robots, said_of_all};

/// A part of a rule that can be changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slot {
    /// A number, by its place in the kind.
    Number(usize),
    /// The robots that it binds.
    Who,
    /// The zone.
    Zone,
    /// When it holds.
    When,
    /// A cell, by its place in the kind.
    Cell(usize),
    /// A robot of its own, by its place in the kind.
    Agent(usize),
}

/// A piece of a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Words.
    Text(String),
    /// Something that can be changed, with what stands there.
    Slot(Slot, String),
}

/// The name that stands for a zone; letters only, so that it needs no quotes of its own.
const ZONE: &str = "qzqz";
/// Two names in the place of all robots, or of several.
const WHO: [&str; 2] = ["qaqa", "qbqb"];
/// Numbers in the place of times, of cells and of other numbers.
const FROM: u32 = 700_001;
const TO: u32 = 700_002;
const CELLS: u32 = 710_000;
const NUMBERS: u32 = 720_000;
/// Quotes of all languages.
const QUOTES: &[char] = &['\'', '"', '„', '“', '”', '‚', '‘', '’', '«', '»'];

/// A mark in a sentence, and the slot that it stands for.
struct Mark {
    begin: String,
    /// Where it ends, where that is another mark.
    end: Option<&'static str>,
    slot: Slot,
    text: String,
}

/// The sentence of a rule in pieces, in a scene with these robots. While it is written, all that
/// can be changed is a slot; else its zone is one.
pub fn pieces(rule: &Constraint, agents: &[Agent], is_written: bool) -> Vec<Piece> {
    let (marked, marks) = marked(rule, agents, is_written);
    let mut pieces = apart(&marked.sentence(), &marks);
    if !is_written {
        without_slots_of_robots(&mut pieces);
    }
    if is_written {
        number_alone(&marked.kind, &mut pieces);
        unsaid(rule, &mut pieces);
    }
    pieces
}

/// The rule with marks in the place of what can be changed.
fn marked(rule: &Constraint, agents: &[Agent], is_written: bool) -> (Constraint, Vec<Mark>) {
    let mut marked = rule.clone();
    let mut marks = Vec::new();
    let mut mark = |begin: String, slot, text| {
        marks.push(Mark {
            begin,
            end: None,
            slot,
            text,
        });
    };
    let all = all_robots(&rule.kind);
    let says_all = said_of_all(&rule.kind);
    let is_said = rule.agents.is_none() && rule.sentence().contains(says_all);
    let parts = parts(&mut marked.kind);
    if let Some(zone) = parts.zone {
        mark(
            ZONE.to_owned(),
            Slot::Zone,
            std::mem::replace(zone, ZONE.to_owned()),
        );
    }
    let brief = rule.who_among(agents, all);
    if !is_written {
        if let (true, Some(brief)) = (parts.has_who, brief) {
            marks.push(several(&mut marked, brief));
        }
        return (marked, marks);
    }
    let last = parts.numbers.len().saturating_sub(1);
    for (index, number) in parts.numbers.into_iter().enumerate().take(last) {
        let stands_for = NUMBERS + index as u32;
        let text = std::mem::replace(number, stands_for).to_string();
        mark(stands_for.to_string(), Slot::Number(index), text);
    }
    if let Some(times) = parts.times {
        for (time, stands_for) in [(&mut times.from, FROM), (&mut times.to, TO)] {
            if let Some(time) = time {
                let text = std::mem::replace(time, stands_for).to_string();
                mark(stands_for.to_string(), Slot::When, text);
            }
        }
    }
    for (index, cell) in parts.cells.into_iter().enumerate() {
        let stands_for = Cell::new(CELLS + index as u32, 0);
        let text = std::mem::replace(cell, stands_for).to_string();
        mark(stands_for.to_string(), Slot::Cell(index), text);
    }
    for (name, (index, agent)) in WHO.into_iter().zip(parts.agents.into_iter().enumerate()) {
        let text = std::mem::replace(agent, name.to_owned());
        mark(name.to_owned(), Slot::Agent(index), text);
    }
    if parts.has_who && is_said {
        marks.push(Mark {
            begin: says_all.to_owned(),
            end: None,
            slot: Slot::Who,
            text: says_all.to_owned(),
        });
    } else if parts.has_who {
        marks.push(match (rule.agents.as_deref(), brief) {
            (Some([one]), _) => {
                let [begin, _] = WHO;
                marked.agents = Some(vec![begin.to_owned()]);
                Mark {
                    begin: begin.to_owned(),
                    end: None,
                    slot: Slot::Who,
                    text: one.clone(),
                }
            }
            (_, Some(brief)) => several(&mut marked, brief),
            (Some(names), None) => several(&mut marked, and(names)),
            (None, None) => several(&mut marked, all.to_owned()),
        });
    }
    (marked, marks)
}

/// Puts the mark of several robots into a rule.
fn several(marked: &mut Constraint, text: String) -> Mark {
    let [begin, end] = WHO;
    marked.agents = Some(WHO.map(str::to_owned).to_vec());
    Mark {
        begin: begin.to_owned(),
        end: Some(end),
        slot: Slot::Who,
        text,
    }
}

/// Makes the robots of a sentence words like the others.
fn without_slots_of_robots(pieces: &mut Vec<Piece>) {
    let mut plain = Vec::new();
    for piece in pieces.drain(..) {
        match (plain.last_mut(), piece) {
            (Some(Piece::Text(before)), Piece::Text(text) | Piece::Slot(Slot::Who, text)) => {
                before.push_str(&text);
            }
            (_, Piece::Slot(Slot::Who, text)) => plain.push(Piece::Text(text)),
            (_, piece) => plain.push(piece),
        }
    }
    *pieces = plain;
}

/// Takes a sentence apart where its marks stand.
fn apart(sentence: &str, marks: &[Mark]) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut rest = sentence;
    loop {
        let found = marks.iter().filter_map(|mark| {
            let (before, after) = rest.split_once(mark.begin.as_str())?;
            let after = match mark.end {
                Some(end) => after.split_once(end)?.1,
                None => after,
            };
            Some((before, after, mark))
        });
        let Some((before, after, mark)) = found.min_by_key(|(before, ..)| before.len()) else {
            break;
        };
        let (mut before, mut after) = (before, after);
        // The outline of the zone stands for its quotes.
        if let Some((left, right)) = before.strip_suffix(QUOTES).zip(after.strip_prefix(QUOTES)) {
            (before, after) = (left, right);
        }
        words(before, &mut pieces);
        let is_first = pieces.is_empty() && mark.slot == Slot::Who && mark.end.is_some();
        let text = if is_first {
            capital(&mark.text)
        } else {
            mark.text.clone()
        };
        pieces.push(Piece::Slot(mark.slot, text));
        rest = after;
    }
    words(rest, &mut pieces);
    pieces
}

fn words(text: &str, pieces: &mut Vec<Piece>) {
    if !text.is_empty() {
        pieces.push(Piece::Text(text.to_owned()));
    }
}

/// Makes a slot of the number that stands among the words, with its own plural.
fn number_alone(kind: &ConstraintKind, pieces: &mut Vec<Piece>) {
    let mut kind = kind.clone();
    let numbers = parts(&mut kind).numbers;
    let Some((index, number)) = numbers.iter().enumerate().next_back() else {
        return;
    };
    let (slot, number) = (Slot::Number(index), number.to_string());
    let found = pieces
        .iter()
        .enumerate()
        .find_map(|(place, piece)| match piece {
            Piece::Text(text) => {
                let (before, after) = text.split_once(&number)?;
                Some((place, before.to_owned(), after.to_owned()))
            }
            Piece::Slot(..) => None,
        });
    let Some((place, before, after)) = found else {
        return;
    };
    let parts = [
        Piece::Text(before),
        Piece::Slot(slot, number),
        Piece::Text(after),
    ];
    let is_there = |piece: &Piece| !matches!(piece, Piece::Text(text) if text.is_empty());
    pieces.splice(place..=place, parts.into_iter().filter(is_there));
}

/// Adds slots for what the sentence does not say: that a rule always holds, that nobody stays.
fn unsaid(rule: &Constraint, pieces: &mut Vec<Piece>) {
    let mut kind = rule.kind.clone();
    let parts = parts(&mut kind);
    let has = |slot: Slot, pieces: &[Piece]| {
        let mut slots = pieces.iter();
        slots.any(|piece| matches!(piece, Piece::Slot(of, _) if *of == slot))
    };
    let mut add = |slot: Slot, text: &str| {
        pieces.push(Piece::Text(" ".to_owned()));
        pieces.push(Piece::Slot(slot, text.to_owned()));
    };
    if let ConstraintKind::NoWaiting { most: 0, .. } = rule.kind {
        add(Slot::Number(0), tr!("no robot waits" => "at all"));
    }
    if let ConstraintKind::Visit { stay: 0, .. } = rule.kind {
        add(
            Slot::Number(0),
            tr!("a robot is there" => "without staying"),
        );
    }
    if parts.times.is_some_and(|times| is_always(*times)) && !has(Slot::When, pieces) {
        pieces.push(Piece::Text(" ".to_owned()));
        pieces.push(Piece::Slot(
            Slot::When,
            tr!("a rule holds" => "always").to_owned(),
        ));
    }
}

/// Whether a rule with these times always holds.
pub(super) fn is_always(times: Times) -> bool {
    times.first() == 0 && meant(times).to.is_none()
}
