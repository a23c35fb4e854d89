//! The card of the rule that is being written, as the inspector shows it.

use giveway_model::condition::Times;
use giveway_model::words::and;
use giveway_model::{Cell, Zone, tr};

use super::counts::{counts, times_in};
use super::judge::judge;
use super::never::but_some;
use super::pieces::is_always;
use super::{Count, Judged, Piece, Slot, Writing, icon, parts, pieces, ranges};
use crate::State;

/// At most so many stretches of time are told of a robot.
const STRETCHES: usize = 6;

/// The rule that is being written.
#[derive(Clone, Debug, PartialEq)]
#[allow(
    clippy::struct_excessive_bools,
    reason = "each is of its own: it shows a part of the card"
)]
pub struct Card {
    /// The zone that it is about, by its name.
    pub zone: Option<String>,
    /// Where that is: `8 cells, (9, 4) to (12, 5)`.
    pub place: String,
    /// Whether it takes the place of a rule of the scene.
    pub is_edited: bool,
    /// Whether it is asked why it is not so.
    pub asks: bool,
    /// Whether a place can be marked for another rule instead.
    pub marks: bool,
    /// The icon of its kind.
    pub icon: &'static str,
    /// Its sentence.
    pub pieces: Vec<Piece>,
    /// Its sentence as plain words.
    pub sentence: String,
    /// The slot that is open, with its editor.
    pub open: Option<(Slot, Editor)>,
    /// What the plan on the board is under it.
    pub judged: Judged,
    /// Why the words typed last are no rule.
    pub misread: Option<String>,
    /// The rule in words that can be typed over; those that were typed last, where they are no rule.
    pub words: String,
    /// What can be written as well.
    pub offers: Vec<Offer>,
    /// How many robots are in its zone at each time, equal ones on end as one.
    pub counts: Vec<Count>,
    /// Who is in its zone when.
    pub stays: Vec<Stay>,
}

/// Another rule that can be written.
#[derive(Clone, Debug, PartialEq)]
pub struct Offer {
    /// The icon of its kind.
    pub icon: &'static str,
    /// Its sentence.
    pub sentence: String,
    /// The rule.
    pub rule: giveway_model::Constraint,
}

/// When a robot is in a zone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stay {
    /// The robot, by its index in the scene.
    pub agent: usize,
    /// Its name.
    pub name: String,
    /// When: `from 4 to 5 and at 9`.
    pub when: String,
}

/// What fills a slot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Editor {
    /// A number that is at least so much.
    Number {
        /// The number.
        value: u32,
        /// The least that it can be.
        least: u32,
    },
    /// Names to choose from, each with whether it is chosen. Of robots that it binds, none
    /// chosen is all.
    Names {
        /// The names.
        names: Vec<(String, bool)>,
        /// Whether several can be chosen.
        several: bool,
    },
    /// Times; `None` where it always holds.
    When(Option<Times>),
    /// A cell, which is pressed on the board.
    Cell(Cell),
}

/// The card of the rule that is being written; nothing where none is.
pub fn card(state: &State) -> Option<Card> {
    let writing = state.view.rules.writing.as_deref()?;
    if !state.is_writing_rule() {
        return None;
    }
    let scene = state.document.draft.scene();
    let zone = writing.zone();
    let cells = zone.and_then(|name| scene.zones.iter().find(|zone| zone.name == name));
    let judged = judge(state, writing);
    let counts = counts(state, &writing.rule, &judged.times);
    let offer = |rule: &giveway_model::Constraint| Offer {
        icon: icon(rule),
        sentence: plain(&pieces(rule, &scene.agents, false)),
        rule: rule.clone(),
    };
    let others = writing.offers.iter();
    let others = others.filter(|rule| icon(rule) != icon(&writing.rule));
    let for_some = but_some(scene, &writing.rule).map(|(rule, left_out)| Offer {
        icon: icon(&rule),
        sentence: tr!(
            "The same for all robots but {robots}",
            robots = and(&left_out)
        ),
        rule,
    });
    Some(Card {
        zone: zone.map(str::to_owned),
        place: cells.map_or_else(String::new, place),
        is_edited: writing.index.is_some(),
        asks: writing.asks,
        marks: zone.is_none()
            && writing.index.is_none()
            && !writing.asks
            && state.can_write_rules(),
        icon: icon(&writing.rule),
        pieces: pieces(&writing.rule, &scene.agents, true),
        sentence: plain(&pieces(&writing.rule, &scene.agents, false)),
        open: writing
            .open
            .and_then(|slot| Some((slot, editor(state, writing, slot)?))),
        words: match &writing.misread {
            Some((words, _)) => words.clone(),
            None => writing.rule.sentence(),
        },
        misread: writing.misread.as_ref().map(|(_, why)| why.clone()),
        offers: for_some.into_iter().chain(others.map(offer)).collect(),
        stays: zone.map_or_else(Vec::new, |zone| stays(state, zone)),
        counts,
        judged,
    })
}

/// A sentence without slots.
pub(super) fn plain(pieces: &[Piece]) -> String {
    let text = |piece: &Piece| match piece {
        Piece::Text(text) | Piece::Slot(_, text) => text.clone(),
    };
    pieces.iter().map(text).collect()
}

/// How large a zone is, and where.
fn place(zone: &Zone) -> String {
    let cells = zone.cell_set();
    let corner = |pick: fn(u32, u32) -> u32| {
        let all = cells.iter().copied();
        all.reduce(|a, b| Cell::new(pick(a.x, b.x), pick(a.y, b.y)))
            .unwrap_or(Cell::new(0, 0))
    };
    tr!(
        "{n} cell, {first} to {last}" | "{n} cells, {first} to {last}" % cells.len(),
        first = corner(u32::min),
        last = corner(u32::max)
    )
}

/// What fills a slot of the rule; nothing where the rule has no such slot.
fn editor(state: &State, writing: &Writing, slot: Slot) -> Option<Editor> {
    let mut kind = writing.rule.kind.clone();
    let parts = parts(&mut kind);
    let scene = state.document.draft.scene();
    let robots = |is_on: &dyn Fn(&String) -> bool| {
        let agents = scene.agents.iter();
        agents
            .map(|agent| (agent.name.clone(), is_on(&agent.name)))
            .collect()
    };
    Some(match slot {
        Slot::Number(index) => Editor::Number {
            value: *parts.numbers.into_iter().nth(index)?,
            least: parts.least,
        },
        Slot::Who => {
            let chosen = writing.rule.agents.as_ref();
            let is_on = |name: &String| chosen.is_some_and(|names| names.contains(name));
            Editor::Names {
                names: parts.has_who.then(|| robots(&is_on))?,
                several: true,
            }
        }
        Slot::Agent(index) => {
            let agent: &String = parts.agents.into_iter().nth(index)?;
            Editor::Names {
                names: robots(&|name| name == agent),
                several: false,
            }
        }
        Slot::Zone => {
            let own: &String = parts.zone?;
            let zones = scene.zones.iter().map(|zone| zone.name.clone());
            Editor::Names {
                names: zones.map(|name| (name.clone(), name == *own)).collect(),
                several: false,
            }
        }
        Slot::When => {
            let times = *parts.times?;
            Editor::When((!is_always(times)).then_some(times))
        }
        Slot::Cell(index) => Editor::Cell(*parts.cells.into_iter().nth(index)?),
    })
}

/// Who is in a zone when, by the plan on the board.
fn stays(state: &State, zone: &str) -> Vec<Stay> {
    let Some(answer) = state.document.fresh_answer() else {
        return Vec::new();
    };
    let Some(plan) = answer.plan() else {
        return Vec::new();
    };
    let agents = state.document.agents().iter().enumerate();
    let stay = |(agent, who): (usize, &giveway_model::Agent)| {
        let times = times_in(state, plan, zone, &who.name, answer.makespan());
        (!times.is_empty()).then(|| Stay {
            agent,
            name: who.name.clone(),
            when: ranges(&times, STRETCHES),
        })
    };
    agents.filter_map(stay).collect()
}
