//! Cells out of what a plan writes, under some conventions, and how well they fit
//! a map and the tasks of its agents.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use super::{Action, CellOrder, Conventions, Origin, Pair, Up, Walk, WrittenAgent};
use giveway_model::{Cell, Grid, Path};

/// Where an agent that turns looks, `y` down.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Heading {
    /// To `x + 1`.
    East,
    /// To `y + 1`.
    South,
    /// To `x - 1`.
    West,
    /// To `y - 1`.
    North,
}

impl Heading {
    /// After a quarter turn clockwise, as the map is drawn.
    #[must_use]
    pub const fn clockwise(self) -> Self {
        match self {
            Self::East => Self::South,
            Self::South => Self::West,
            Self::West => Self::North,
            Self::North => Self::East,
        }
    }

    /// After a quarter turn counterclockwise.
    #[must_use]
    pub const fn counterclockwise(self) -> Self {
        self.clockwise().clockwise().clockwise()
    }

    const fn ahead(self) -> (i32, i32) {
        match self {
            Self::East => (1, 0),
            Self::South => (0, 1),
            Self::West => (-1, 0),
            Self::North => (0, -1),
        }
    }
}

/// How well a reading of a plan fits: of how many agents the whole path does,
/// and the first thing that does not.
#[derive(
    Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct Fit {
    /// Agents whose path starts at the start, ends at the goal, and takes only
    /// moves and waits on the map.
    pub fitting: usize,
    /// All agents.
    pub agents: usize,
    /// Steps, starts and goals that do not fit, all agents together.
    pub misfits: usize,
    /// The first of them, without a full stop: `A1 would start at (4, 11), outside the map`.
    pub first: Option<String>,
}

impl Fit {
    /// Whether everything fits.
    pub const fn is_perfect(&self) -> bool {
        self.misfits == 0
    }

    fn add(&mut self, misfit: impl FnOnce() -> String) {
        self.misfits += 1;
        if self.first.is_none() {
            self.first = Some(misfit());
        }
    }
}

/// The cell of a pair. A cell left of or above the map wraps around, so that it
/// is on no map; [`Cell`] writes such a number as the negative that it was.
pub(super) fn cell(pair: Pair, conventions: Conventions) -> Cell {
    let (x, y) = match conventions.cells {
        CellOrder::RowColumn => (pair.second, pair.first),
        CellOrder::ColumnRow => (pair.first, pair.second),
    };
    let from = match conventions.origin {
        Origin::Zero => 0,
        Origin::One => 1,
    };
    Cell::new(
        x.wrapping_sub(from).cast_unsigned(),
        y.wrapping_sub(from).cast_unsigned(),
    )
}

/// The path of an agent, and where it looks at each time if it turns.
///
/// `start` is where it starts by its task, where that is known.
pub(super) fn path(
    agent: &WrittenAgent,
    start: Option<Cell>,
    conventions: Conventions,
) -> (Path, Option<Vec<Heading>>) {
    let own = agent.start.map(|start| cell(start.pair, conventions));
    let from = own.or(start);
    match (&agent.walk, from) {
        (Walk::Cells(cells), _) => (
            cells
                .iter()
                .map(|&pair| Some(cell(pair, conventions)))
                .collect(),
            None,
        ),
        (_, None) => (Path::new(), None),
        (walk @ (Walk::Moves(moves) | Walk::Fixed(moves)), Some(from)) => {
            let is_raised = matches!((walk, conventions.up), (Walk::Moves(_), Up::Raises));
            let steps = moves.iter().map(|step| {
                let (x, y) = step.offset();
                (x, if is_raised { -y } else { y })
            });
            (walked(from, steps), None)
        }
        (Walk::Turns(heading, actions), Some(from)) => {
            let mut headings = vec![*heading];
            let mut looks = *heading;
            let steps = actions.iter().map(|action| {
                let step = match action {
                    Action::Forward => looks.ahead(),
                    Action::Wait => (0, 0),
                    Action::Clockwise => {
                        looks = looks.clockwise();
                        (0, 0)
                    }
                    Action::Counterclockwise => {
                        looks = looks.counterclockwise();
                        (0, 0)
                    }
                };
                headings.push(looks);
                step
            });
            let path = walked(from, steps);
            (path, Some(headings))
        }
    }
}

fn walked(from: Cell, steps: impl Iterator<Item = (i32, i32)>) -> Path {
    let mut at = from;
    let mut path = Path::with_capacity(steps.size_hint().0 + 1);
    path.push(Some(at));
    for (x, y) in steps {
        at = Cell::new(at.x.wrapping_add_signed(x), at.y.wrapping_add_signed(y));
        path.push(Some(at));
    }
    path
}

/// The task of an agent, as far as it is known.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Known {
    pub(super) start: Option<Cell>,
    pub(super) goal: Option<Cell>,
}

/// Counts what of an agent's path does not fit.
pub(super) fn judge(fit: &mut Fit, name: &str, path: &[Option<Cell>], known: Known, grid: &Grid) {
    let before = fit.misfits;
    fit.agents += 1;
    let first = path.first().copied().flatten();
    match (first, known.start) {
        (None, _) => fit.add(|| format!("{name} has no path")),
        (Some(at), Some(start)) if at != start => {
            fit.add(|| format!("{name} would start at {at} instead of {start}"));
        }
        _ => {}
    }
    let mut last = None;
    for (time, at) in path.iter().enumerate() {
        let Some(at) = *at else { continue };
        if !grid.is_vertex(at) {
            fit.add(|| {
                let (doing, when) = match time {
                    0 => ("start", String::new()),
                    _ => ("be", format!(" at time {time}")),
                };
                let what = match grid.ground(at) {
                    None => "outside the map",
                    Some(_) => "an obstacle",
                };
                format!("{name} would {doing} at {at}{when}, {what}")
            });
        }
        if let Some(last) = last
            && last != at
            && !Cell::touches(last, at)
        {
            fit.add(|| format!("{name} would jump from {last} to {at} at time {time}"));
        }
        last = Some(at);
    }
    if let (Some(at), Some(goal)) = (last, known.goal)
        && at != goal
    {
        fit.add(|| format!("{name} would end at {at} instead of {goal}"));
    }
    if fit.misfits == before {
        fit.fitting += 1;
    }
}
