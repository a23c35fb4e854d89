//! The size of the floor: rows and columns at its four sides, counted before they come or go.

mod ghost;
mod lines;
mod room;
mod side;
#[cfg(test)]
mod tests;

use giveway_model::words::and;
use giveway_model::{Agent, Cell, Ground, tr};

use crate::edit::{Lines, Lost, Reshape, Sides, Sketch};
use crate::words::at;
use crate::{Edit, State};

pub use ghost::Strip;
pub use lines::{LineOffer, offers, offers_of_lines};
pub use room::Room;
pub use side::Side;

/// What a person says of the size of the floor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GrowAction {
    /// It is to be changed.
    Open,
    /// So many rows or columns more at a side, or less.
    Side(Side, i32),
    /// So many rows or columns more at a side than now, or less; as far as possible.
    Step(Side, i32),
    /// A side is taken hold of.
    Hold,
    /// The side that is held is dragged, so many rows or columns more or less; as far as possible.
    Drag(Side, i32),
    /// It is let go where it is.
    Release,
    /// It goes back to where it was taken hold of.
    Abandon,
    /// So many columns and rows; at once, where nothing is lost.
    To(u32, u32),
    /// Columns or rows come or go where they are named; at once, where nothing is lost.
    Lines(Lines),
    /// What becomes of robots on cells that go.
    Lost(Lost),
    /// It is so.
    Make,
    /// It stays as it is.
    Cancel,
}

/// A size on its way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Growing {
    pub(crate) to: Reshape,
    pub(crate) lost: Lost,
    /// What was at the sides when one of them was taken hold of.
    pub(crate) held: Option<Sides>,
}

impl Growing {
    /// A size on its way where what robots lose moves.
    pub(crate) const fn new(to: Reshape) -> Self {
        Self {
            to,
            lost: Lost::Move,
            held: None,
        }
    }

    /// What is at the sides of the floor.
    pub(crate) fn sides(self) -> Sides {
        match self.to {
            Reshape::Sides(sides) => sides,
            Reshape::Lines(_) => Sides::default(),
        }
    }

    /// The same with so many rows or columns at a side.
    pub(crate) fn with(self, side: Side, more: i32) -> Self {
        let sides = self.sides();
        let sides = match side {
            Side::Left => Sides {
                left: more,
                ..sides
            },
            Side::Top => Sides { top: more, ..sides },
            Side::Right => Sides {
                right: more,
                ..sides
            },
            Side::Bottom => Sides {
                bottom: more,
                ..sides
            },
        };
        Self {
            to: Reshape::Sides(sides),
            ..self
        }
    }
}

/// The size of the floor as it is to be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Card {
    /// Columns and rows as they are.
    pub before: String,
    /// As they will be.
    pub after: String,
    /// What is at each side; `None` where columns or rows between them go.
    pub sides: Option<Sides>,
    /// What would be lost, a sentence each.
    pub losses: Vec<String>,
    /// What becomes of robots on cells that go; `None` where there are none.
    pub lost: Option<Lost>,
    /// Which cell becomes which.
    pub moved: Option<String>,
    /// The button that makes it so; `None` where nothing changes.
    pub make: Option<String>,
}

/// The size of the floor as it is to be; `None` where it stays.
pub fn card(state: &State) -> Option<Card> {
    let growing = state.growing()?;
    let (grid, to) = (state.document.draft.grid(), growing.to);
    let (width, height) = to.size(grid);
    let losses = losses(state, to);
    let first = match to {
        Reshape::Sides(sides) => Cell::new(
            sides.left.unsigned_abs().min(grid.width() - 1),
            sides.top.unsigned_abs().min(grid.height() - 1),
        ),
        Reshape::Lines(lines) => lines.behind(),
    };
    let moved = to
        .moved(first, (width, height))
        .filter(|&to| to != first && grid.ground(first).is_some());
    Some(Card {
        before: size(grid.width(), grid.height()),
        after: size(width, height),
        sides: match to {
            Reshape::Sides(sides) => Some(sides),
            Reshape::Lines(_) => None,
        },
        lost: has_robots(state, to).then_some(growing.lost),
        losses,
        moved: moved.map(|to| {
            tr!(
                "{from} becomes {to}, and so on.",
                from = at(first),
                to = at(to)
            )
        }),
        make: (to != Reshape::Sides(Sides::default()))
            .then(|| tr!("Make it {size}", size = size(width, height))),
    })
}

fn size(width: u32, height: u32) -> String {
    format!("{width} \u{d7} {height}")
}

/// Whether a robot has something on cells that go.
fn has_robots(state: &State, to: Reshape) -> bool {
    let draft = &state.document.draft;
    let size = to.size(draft.grid());
    let is_lost = |cell: &Cell| to.moved(*cell, size).is_none();
    draft.agents().iter().any(|agent| {
        is_lost(&agent.start)
            || agent.goal.as_ref().is_some_and(is_lost)
            || agent.waypoints.iter().any(is_lost)
    })
}

/// What is on cells that go, a sentence each.
pub(crate) fn losses(state: &State, to: Reshape) -> Vec<String> {
    let draft = &state.document.draft;
    let (grid, size) = (draft.grid(), to.size(draft.grid()));
    let is_lost = |cell: &Cell| to.moved(*cell, size).is_none();
    let names = |is: &dyn Fn(&Agent) -> bool| -> Vec<&str> {
        let agents = draft.agents().iter().filter(|agent| is(agent));
        agents.map(|agent| agent.name.as_str()).collect()
    };
    let starts = names(&|agent| is_lost(&agent.start));
    let goals = names(&|agent| !is_lost(&agent.start) && agent.goal.as_ref().is_some_and(is_lost));
    let waypoints = draft.agents().iter().flat_map(|agent| &agent.waypoints);
    let waypoints = waypoints.filter(|&cell| is_lost(cell)).count();
    let gone = || grid.cells().filter(|(cell, _)| is_lost(cell));
    let count = |is: fn(Ground) -> bool| gone().filter(|&(_, ground)| is(ground)).count();
    let obstacles = count(|ground| ground == Ground::Obstacle);
    let chargers = count(Ground::is_charger);
    let slow = count(Ground::is_slow);
    let rules = rules_lost(state, to);
    let told = [
        (
            starts.len(),
            tr!(
                "{n} robot starts there: {names}"
                    | "{n} robots start there: {names}" % starts.len(),
                names = starts.join(", ")
            ),
        ),
        (
            goals.len(),
            tr!(
                "{n} has its goal there: {names}"
                    | "{n} have their goals there: {names}" % goals.len(),
                names = goals.join(", ")
            ),
        ),
        (waypoints, tr!("{n} waypoint" | "{n} waypoints" % waypoints)),
        (obstacles, tr!("{n} obstacle" | "{n} obstacles" % obstacles)),
        (chargers, tr!("{n} charger" | "{n} chargers" % chargers)),
        (slow, tr!("{n} slow cell" | "{n} slow cells" % slow)),
        (
            rules,
            tr!("{n} rule whose place goes" | "{n} rules whose place goes" % rules),
        ),
    ];
    told.into_iter()
        .filter(|&(n, _)| n > 0)
        .map(|(_, words)| words)
        .collect()
}

/// What the size on its way means, in a sentence: first what robots lose. `None` where the floor
/// stays, or nothing of it is known to be lost.
pub(crate) fn sentence(state: &State) -> Option<String> {
    let to = state.growing()?.to;
    let draft = &state.document.draft;
    let size = to.size(draft.grid());
    let is_lost = |cell: &Cell| to.moved(*cell, size).is_none();
    let robots = draft
        .agents()
        .iter()
        .filter(|agent| is_lost(&agent.start) || agent.goal.as_ref().is_some_and(is_lost));
    match robots.count() {
        0 => {
            let losses = losses(state, to);
            (!losses.is_empty()).then(|| {
                tr!(
                    "A smaller floor would lose {losses}.",
                    losses = and(&losses)
                )
            })
        }
        robots => Some(tr!(
            "A smaller floor: {n} robot would lose its start or goal."
                | "A smaller floor: {n} robots would lose their start or goal." % robots
        )),
    }
}

/// How many rules have no place any longer.
fn rules_lost(state: &State, to: Reshape) -> usize {
    let draft = &state.document.draft;
    let before = draft.scene().constraints.len();
    if before == 0 {
        return 0;
    }
    let mut sketch = Sketch::of(draft);
    match sketch.make(&Edit::Grow(to, Lost::Move)) {
        Ok(()) => before.saturating_sub(sketch.into_scene().constraints.len()),
        Err(_) => 0,
    }
}

impl State {
    /// The size on its way.
    pub(crate) fn growing(&self) -> Option<Growing> {
        self.view.growing.filter(|_| self.can_grow())
    }

    /// Whether the size of the floor can be changed: the scene itself is on the board.
    pub fn can_grow(&self) -> bool {
        self.can_place_fleet()
    }
}
