//! What was typed or pasted for robots, checked against the floor and each other.

use std::collections::BTreeMap;

use giveway_model::{Agent, AtGoal, Cell, tr};

use super::Column;
use super::battery::battery;
use super::fault::{Fault, fault, unread};
use super::read::numbers;
use crate::Draft;
use crate::words::at;

/// What was given for a robot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Given {
    pub(crate) target: Target,
    /// The text of each column that was given.
    pub(crate) cells: BTreeMap<Column, String>,
}

/// Which robot something was given for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Target {
    /// One of the scene, by its index.
    Old(usize),
    /// One that comes.
    New,
}

/// What becomes of the robots.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Taken {
    /// All robots, with those that were given and fit.
    pub(crate) agents: Vec<Agent>,
    /// What does not fit, of each that was given.
    pub(crate) faults: Vec<Vec<Fault>>,
}

/// Takes what was given, one after the other: each is checked against all that fit before it,
/// and against those that stay as they are: nothing was given for them, or it did not fit.
pub(crate) fn take(draft: &Draft, given: &[Given]) -> Taken {
    let mut faults = vec![Vec::new(); given.len()];
    loop {
        let (agents, found) = pass(draft, given, &faults);
        if found.is_empty() {
            return Taken { agents, faults };
        }
        for (index, told) in found {
            if let Some(place) = faults.get_mut(index) {
                *place = told;
            }
        }
    }
}

/// All robots with those given that have no faults yet, and the faults that are found of these.
fn pass(
    draft: &Draft,
    given: &[Given],
    faults: &[Vec<Fault>],
) -> (Vec<Agent>, Vec<(usize, Vec<Fault>)>) {
    let old = draft.agents();
    let is_tried = |(given, faults): (&Given, &Vec<Fault>), index: usize| {
        given.target == Target::Old(index) && faults.is_empty()
    };
    let changes = |index: usize| given.iter().zip(faults).any(|pair| is_tried(pair, index));
    let firm = old.iter().enumerate().filter(|(index, _)| !changes(*index));
    let mut checked = Checked {
        draft,
        agents: firm.map(|(_, agent)| agent.clone()).collect(),
    };
    let mut names = giveway_model::fleet::fresh_names(draft.agents(), given.len()).into_iter();
    let mut agents: Vec<Agent> = old.to_vec();
    let mut found = Vec::new();
    let tried = given
        .iter()
        .zip(faults)
        .enumerate()
        .filter(|(_, (_, faults))| faults.is_empty());
    for (index, (given, _)) in tried {
        let before = match given.target {
            Target::Old(index) => old.get(index).cloned(),
            Target::New => None,
        };
        let is_new = before.is_none();
        let before = before.unwrap_or_else(|| Agent {
            name: names.next().unwrap_or_default(),
            start: Cell::new(0, 0),
            goal: None,
            waypoints: Vec::new(),
            battery: old.last().and_then(|agent| agent.battery),
            heading: None,
        });
        match checked.read(given, before, is_new) {
            Ok(agent) => {
                checked.agents.push(agent.clone());
                match given.target {
                    Target::Old(index) => {
                        if let Some(place) = agents.get_mut(index) {
                            *place = agent;
                        }
                    }
                    Target::New => agents.push(agent),
                }
            }
            Err(told) => found.push((index, told)),
        }
    }
    (agents, found)
}

/// The floor, and the robots that fit so far.
struct Checked<'a> {
    draft: &'a Draft,
    agents: Vec<Agent>,
}

impl Checked<'_> {
    /// A robot as it was given.
    fn read(&self, given: &Given, mut agent: Agent, is_new: bool) -> Result<Agent, Vec<Fault>> {
        let mut faults = Vec::new();
        let old = agent.clone();
        let text = |column| given.cells.get(&column).map(|text| text.trim());
        if let Some(name) = text(Column::Name).filter(|name| !name.is_empty()) {
            if self.agents.iter().any(|other| other.name == name) {
                faults.push(fault(
                    Column::Name,
                    tr!("There is another robot of this name."),
                    None,
                ));
            }
            name.clone_into(&mut agent.name);
        }
        match text(Column::Start) {
            Some(text) => {
                match self.place(Column::Start, text, Some(old.start).filter(|_| !is_new)) {
                    Ok(Some(cell)) => agent.start = cell,
                    Ok(None) => faults.push(unread(Column::Start)),
                    Err(found) => faults.push(found),
                }
            }
            None if is_new => faults.push(unread(Column::Start)),
            None => {}
        }
        if let Some(text) = text(Column::Goal) {
            match self.place(Column::Goal, text, old.goal) {
                Ok(goal) => agent.goal = goal,
                Err(found) => faults.push(found),
            }
        }
        if let Some(text) = text(Column::Waypoints) {
            match self.waypoints(text) {
                Ok(waypoints) => agent.waypoints = waypoints,
                Err(found) => faults.push(found),
            }
        }
        match battery(text(Column::Battery), text(Column::Level), agent.battery) {
            Ok(battery) => agent.battery = battery,
            Err(found) => faults.push(found),
        }
        if faults.is_empty() {
            Ok(agent)
        } else {
            Err(faults)
        }
    }

    /// A start or a goal; an empty one is none.
    fn place(&self, column: Column, text: &str, old: Option<Cell>) -> Result<Option<Cell>, Fault> {
        if text.is_empty() {
            return Ok(None);
        }
        let &[x, y] = &*numbers(text).unwrap_or_default() else {
            return Err(unread(column));
        };
        let cell = Cell::new(x, y);
        let other = match column {
            Column::Start => self.agents.iter().find(|agent| agent.start == cell),
            // Where robots vanish at their goals, several may share one.
            _ if self.draft.scene().rules.at_goal == AtGoal::Vanish => None,
            _ => self.agents.iter().find(|agent| agent.goal == Some(cell)),
        };
        let why = match (self.blocked(cell), other) {
            (Some(why), _) => why,
            (None, None) => return Ok(Some(cell)),
            (None, Some(other)) => {
                let (place, name) = (at(cell), &other.name);
                match column {
                    Column::Start => tr!("{place} is the start of {name} already.", place, name),
                    _ => tr!("{place} is the goal of {name} already.", place, name),
                }
            }
        };
        let is_free = |cell: Cell| match column {
            Column::Start => self.agents.iter().all(|agent| agent.start != cell),
            _ => self.agents.iter().all(|agent| agent.goal != Some(cell)),
        };
        let kept = old.filter(|&old| old != cell && is_free(old) && self.blocked(old).is_none());
        let remedy = match kept {
            Some(old) => Some((tr!("Keep {place}", place = at(old)), old)),
            None => self.nearest(cell, &is_free).map(|near| {
                (
                    tr!("Use {place}, the nearest free cell", place = at(near)),
                    near,
                )
            }),
        };
        Err(Fault {
            column,
            why,
            remedy: remedy.map(|(offer, cell)| (offer, written(cell))),
            place: Some(cell),
        })
    }

    fn waypoints(&self, text: &str) -> Result<Vec<Cell>, Fault> {
        let column = Column::Waypoints;
        let numbers = numbers(text).filter(|numbers| numbers.len() % 2 == 0);
        let numbers = numbers.ok_or_else(|| unread(column))?;
        let mut cells: Vec<Cell> = Vec::new();
        for pair in numbers.chunks(2) {
            let &[x, y] = pair else { continue };
            let cell = Cell::new(x, y);
            if let Some(why) = self.blocked(cell) {
                return Err(Fault {
                    column,
                    why,
                    remedy: None,
                    place: Some(cell),
                });
            }
            if !cells.contains(&cell) {
                cells.push(cell);
            }
        }
        Ok(cells)
    }

    /// Why nobody can be on a cell.
    fn blocked(&self, cell: Cell) -> Option<String> {
        match self.draft.grid().ground(cell) {
            None => Some(tr!("{place} is not on the map.", place = at(cell))),
            Some(ground) if !ground.is_vertex() => {
                Some(tr!("{place} is an obstacle.", place = at(cell)))
            }
            Some(_) => None,
        }
    }

    fn nearest(&self, cell: Cell, is_free: &dyn Fn(Cell) -> bool) -> Option<Cell> {
        let far = |other: &Cell| {
            other
                .x
                .abs_diff(cell.x)
                .saturating_add(other.y.abs_diff(cell.y))
        };
        let grid = self.draft.grid();
        let cells = grid
            .cells()
            .map(|(cell, _)| cell)
            .filter(|&cell| grid.is_vertex(cell));
        let mut near: Vec<Cell> = cells.collect();
        near.sort_by_key(far);
        near.into_iter().find(|&cell| is_free(cell))
    }
}

/// A cell as the table writes it.
pub(super) fn written(cell: Cell) -> String {
    format!("{}, {}", cell.x, cell.y)
}
