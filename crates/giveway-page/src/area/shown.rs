//! What the board and the inspector show of an area.

use std::collections::BTreeSet;

use giveway_model::words::Sentence;
use giveway_model::{Cell, Ground, tr};

use super::drawn::{content, outline};
use super::{Area, Clip, Doing, Repeat, Way, ground};
use crate::edit::{AreaEdit, Sketch};
use crate::words::at;
use crate::{Edit, State};

/// An area on the board.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// Its first and last column and row: `[x0, y0, x1, y1]`.
    pub frame: [u32; 4],
    /// Its outline, as SVG path data in units of the map.
    pub outline: String,
    /// Whether it can be stretched.
    pub has_handles: bool,
    /// What comes and goes, until it is made.
    pub ghosts: Vec<Ghost>,
    /// How much comes.
    pub pill: Option<String>,
}

/// Something of an area that is not so yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Ghost {
    /// Its class: `comes`, `goes` or `refused`.
    pub class: &'static str,
    /// What is on the area, as SVG path data in units.
    pub path: String,
    /// How far it stands from there: cells right and down.
    pub by: (i32, i32),
}

/// An area in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Card {
    /// Its size: `25 × 2 cells`.
    pub size: String,
    /// Its size aloud, with what is on it.
    pub name: String,
    /// Where it is.
    pub place: String,
    /// What is on it: a name and a text each.
    pub facts: Vec<(&'static str, String)>,
    /// What making its ghost does, or why it cannot be.
    pub told: Option<String>,
    /// Whether something stands in the way.
    pub is_refused: bool,
    /// Its copies, where it is to be repeated.
    pub repeat: Option<Repeat>,
    /// Whether something was copied.
    pub can_paste: bool,
}

/// The area on the board; `None` where there is none.
pub fn shown(state: &State) -> Option<Shown> {
    let area = state.area()?;
    let ghost = |class, by, clip: &Clip| Ghost {
        class,
        path: content(clip),
        by,
    };
    let draft = &state.document.draft;
    let (ghosts, pill) = match &area.doing {
        Doing::Moves if area.by == (0, 0) => (Vec::new(), None),
        Doing::Moves => {
            let clip = Clip::of(&area.cells, draft);
            let class = if can_be(state, area).is_ok() {
                "comes"
            } else {
                "refused"
            };
            (
                vec![ghost("goes", (0, 0), &clip), ghost(class, area.by, &clip)],
                None,
            )
        }
        Doing::Pastes(clip) => {
            let class = if can_be(state, area).is_ok() {
                "comes"
            } else {
                "refused"
            };
            (vec![ghost(class, area.by, clip)], None)
        }
        Doing::Repeats(repeat) => {
            let clip = Clip::of(&area.cells, draft);
            let copies = crate::reduce::copies(state, area, *repeat);
            let class = |is_ok| if is_ok { "comes" } else { "refused" };
            let places = repeat.places().zip(&copies);
            let ghosts = places.map(|(by, copy)| ghost(class(copy.is_ok()), by, &clip));
            (ghosts.collect(), Some(more(state, area, *repeat, &copies)))
        }
    };
    Some(Shown {
        frame: area.frame(),
        outline: outline(area),
        has_handles: area.is_rectangle() && !area.has_ghost(),
        ghosts,
        pill,
    })
}

/// Whether the ghost of an area can be made.
fn can_be(state: &State, area: &Area) -> Result<(), Sentence> {
    let edit = match &area.doing {
        Doing::Moves => AreaEdit::Move(area.cells.clone(), Way::by(area.by)),
        Doing::Pastes(clip) => AreaEdit::Put(clip.clone(), area.by),
        Doing::Repeats(_) => return Ok(()),
    };
    Sketch::of(&state.document.draft).make(&Edit::Area(edit))
}

/// The area in words; `None` where there is none.
pub fn card(state: &State) -> Option<Card> {
    let area = state.area()?;
    let draft = &state.document.draft;
    let here: Vec<Ground> = match &area.doing {
        Doing::Pastes(clip) => clip.ground.iter().map(|&(_, ground)| ground).collect(),
        Doing::Moves | Doing::Repeats(_) => ground(&area.cells, draft.grid())
            .map(|(_, ground)| ground)
            .collect(),
    };
    let [x0, y0, x1, y1] = area.frame();
    let (width, height, cells) = (x1 - x0 + 1, y1 - y0 + 1, area.cells.len());
    let size = if area.is_rectangle() {
        tr!("{width} \u{d7} {height} cells", width, height)
    } else {
        tr!("{n} cell" | "{n} cells" % cells)
    };
    let count = |is: fn(Ground) -> bool| here.iter().filter(|&&ground| is(ground)).count();
    let obstacles = count(|ground| ground == Ground::Obstacle);
    let of = |n: usize| tr!("{n} of {cells} cells", n, cells);
    let mut facts = vec![(tr!("Obstacles"), of(obstacles))];
    let rest = [
        (tr!("Chargers"), count(Ground::is_charger)),
        (tr!("Slow cells"), count(Ground::is_slow)),
    ];
    facts.extend(
        rest.into_iter()
            .filter(|&(_, n)| n > 0)
            .map(|(name, n)| (name, of(n))),
    );
    facts.push((tr!("Robots"), robots(state, area)));
    let (told, is_refused) = told(state, area);
    Some(Card {
        name: tr!(
            "{width} by {height} cells, {n} obstacle"
                | "{width} by {height} cells, {n} obstacles" % obstacles,
            width,
            height
        ),
        size,
        place: tr!(
            "{from} to {to}",
            from = at(Cell::new(x0, y0)),
            to = at(Cell::new(x1, y1))
        ),
        facts,
        told,
        is_refused,
        repeat: match area.doing {
            Doing::Repeats(repeat) => Some(repeat),
            Doing::Moves | Doing::Pastes(_) => None,
        },
        can_paste: state.view.clip.is_some(),
    })
}

/// How many robots have something there.
fn robots(state: &State, area: &Area) -> String {
    let agents = || match &area.doing {
        Doing::Pastes(clip) => clip.agents.iter(),
        Doing::Moves | Doing::Repeats(_) => state.document.draft.agents().iter(),
    };
    let is_there = |cell: &Cell| area.cells.contains(cell);
    let starts = agents().filter(|agent| is_there(&agent.start)).count();
    let goals = agents()
        .filter(|agent| agent.goal.as_ref().is_some_and(is_there))
        .count();
    let waypoints = agents()
        .flat_map(|agent| &agent.waypoints)
        .filter(|&cell| is_there(cell))
        .count();
    let named = [
        (starts, tr!("{n} start" | "{n} starts" % starts)),
        (goals, tr!("{n} goal" | "{n} goals" % goals)),
        (waypoints, tr!("{n} waypoint" | "{n} waypoints" % waypoints)),
    ];
    let there: Vec<String> = named
        .into_iter()
        .filter(|&(n, _)| n > 0)
        .map(|(_, words)| words)
        .collect();
    if there.is_empty() {
        tr!("none starts, ends or has a waypoint here").to_owned()
    } else {
        there.join(", ")
    }
}

/// What making the ghost does, or why it cannot be.
fn told(state: &State, area: &Area) -> (Option<String>, bool) {
    if !area.has_ghost() {
        return (None, false);
    }
    let Doing::Repeats(repeat) = &area.doing else {
        return match can_be(state, area) {
            Err(why) => (Some(why.to_string()), true),
            Ok(()) => (
                Some(tr!("Enter makes it so, Esc drops it.").to_owned()),
                false,
            ),
        };
    };
    let copies = crate::reduce::copies(state, area, *repeat);
    let count = copies.iter().filter(|copy| copy.is_ok()).count();
    match copies.iter().find_map(|copy| copy.as_ref().err()) {
        Some(why) => {
            let left = copies.len() - count;
            let left = tr!(
                "{n} copy is left out: {why}" | "{n} copies are left out: {why}" % left,
                why
            );
            (Some(left), true)
        }
        None => (
            Some(tr!(
                "Repeated: {more}, nothing in their way",
                more = more(state, area, *repeat, &copies)
            )),
            false,
        ),
    }
}

/// What the copies that can be made add. An obstacle on an obstacle adds nothing.
fn more(state: &State, area: &Area, repeat: Repeat, copies: &[Result<Edit, Sentence>]) -> String {
    let draft = &state.document.draft;
    let clip = Clip::of(&area.cells, draft);
    let made = repeat.places().zip(copies).filter(|(_, copy)| copy.is_ok());
    let places: Vec<(i32, i32)> = made.map(|(by, _)| by).collect();
    let obstacles = clip.ground.iter();
    let obstacles = obstacles.filter(|(_, ground)| *ground == Ground::Obstacle);
    let mut new = BTreeSet::new();
    for (cell, _) in obstacles {
        new.extend(places.iter().filter_map(|&(right, down)| {
            let (x, y) = (
                cell.x.checked_add_signed(right)?,
                cell.y.checked_add_signed(down)?,
            );
            let ground = draft.grid().ground(Cell::new(x, y))?;
            (ground != Ground::Obstacle).then_some((x, y))
        }));
    }
    match (new.len(), clip.agents.len() * places.len()) {
        (0, 0) => tr!("{n} cell more" | "{n} cells more" % clip.cells.len() * places.len()),
        (0, robots) => tr!("{n} robot more" | "{n} robots more" % robots),
        (obstacles, _) => tr!("{n} obstacle more" | "{n} obstacles more" % obstacles),
    }
}
