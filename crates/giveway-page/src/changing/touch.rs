//! The tools while the world changes: each stroke becomes listed changes.

use giveway_model::change::What;
use giveway_model::{Cell, Ground};

use super::{Changing, listed};
use crate::Tool;
use crate::ground::line;

/// What a stroke does to the world.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Touch {
    /// Paints obstacles, chargers or slow cells; erases ground.
    Paint(Tool),
    /// Moves an obstacle from the first cell to the last.
    Obstacle,
    /// Moves a charger.
    Charger,
    /// Gives an agent its goal at the last cell.
    Goal(String),
    /// One change, wherever the stroke goes on to.
    Once(What),
}

/// A stroke on its way over the board.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stroke {
    pub(crate) touch: Touch,
    /// The cells that it came over, each once.
    pub(crate) cells: Vec<Cell>,
    pub(crate) at: Cell,
    /// The changes before it: a stroke is one step of undo.
    pub(crate) before: Changing,
    /// Why a part of it was refused.
    pub(crate) refused: Option<String>,
}

impl Stroke {
    pub(crate) fn new(touch: Touch, cell: Cell, before: &Changing) -> Self {
        Self {
            touch,
            cells: vec![cell],
            at: cell,
            before: before.clone(),
            refused: None,
        }
    }

    /// Goes on to a cell.
    pub(crate) fn go(&mut self, cell: Cell) {
        for cell in line(self.at, cell) {
            if !self.cells.contains(&cell) {
                self.cells.push(cell);
            }
        }
        self.at = cell;
    }

    /// What is listed after the stroke, as far as the world allows it.
    pub(crate) fn after(&mut self) -> Changing {
        let mut after = self.before.clone();
        after.stroke = None;
        self.refused = None;
        let parts = self.changes();
        let mut all = after.list.clone();
        for part in parts.iter().flatten() {
            listed::add(&mut all, part.clone());
        }
        if let Ok(after) = after.with(all) {
            return after;
        }
        // Not all of it can be: then what can.
        for what in parts {
            let mut list = after.list.clone();
            for part in what {
                listed::add(&mut list, part);
            }
            match after.with(list) {
                Ok(next) => after = next,
                Err(faults) => {
                    let sentences = faults.iter().map(super::facts::contradiction);
                    self.refused = self.refused.take().or(sentences.into_iter().next());
                }
            }
        }
        after
    }

    /// The changes that the stroke asks for; those of one part go together.
    fn changes(&self) -> Vec<Vec<What>> {
        let (Some(&from), to) = (self.cells.first(), self.at) else {
            return Vec::new();
        };
        match &self.touch {
            Touch::Once(what) => vec![vec![what.clone()]],
            Touch::Goal(agent) => vec![vec![What::SetGoal {
                agent: agent.clone(),
                cell: to,
            }]],
            Touch::Obstacle | Touch::Charger if from == to => Vec::new(),
            Touch::Obstacle => vec![vec![What::MoveObstacle { from, to }]],
            Touch::Charger => vec![vec![
                What::RemoveCharger { cell: from },
                What::AddCharger { cell: to },
            ]],
            Touch::Paint(tool) => self.painted(*tool),
        }
    }

    fn painted(&self, tool: Tool) -> Vec<Vec<What>> {
        let grid = self.before.draft().grid();
        let is = |cell: &Cell, test: fn(Ground) -> bool| grid.ground(*cell).is_some_and(test);
        let cells = |test: fn(Ground) -> bool| -> Vec<Cell> {
            let cells = self.cells.iter().filter(|cell| is(cell, test));
            cells.copied().collect()
        };
        let each = |cells: Vec<Cell>, make: fn(Cell) -> What| -> Vec<Vec<What>> {
            cells.into_iter().map(|cell| vec![make(cell)]).collect()
        };
        match tool {
            Tool::Obstacle => each(cells(Ground::is_vertex), |cell| What::AddObstacle { cell }),
            Tool::Charger => {
                let free = cells(|ground| ground.is_vertex() && !ground.is_charger());
                each(free, |cell| What::AddCharger { cell })
            }
            Tool::SlowZone => {
                let cells = cells(|ground| ground.is_vertex() && !ground.is_slow());
                let slow = (!cells.is_empty()).then(|| vec![What::SetSlow { cells }]);
                slow.into_iter().collect()
            }
            Tool::Erase => {
                let obstacles = cells(|ground| !ground.is_vertex());
                let mut parts = each(obstacles, |cell| What::RemoveObstacle { cell });
                let chargers = cells(Ground::is_charger);
                parts.extend(each(chargers, |cell| What::RemoveCharger { cell }));
                let cells = cells(Ground::is_slow);
                if !cells.is_empty() {
                    parts.push(vec![What::SetNormal { cells }]);
                }
                parts
            }
            Tool::Select | Tool::Agent | Tool::Goal | Tool::Waypoint => Vec::new(),
        }
    }
}

impl Changing {
    /// The list with a further change.
    ///
    /// # Errors
    /// How it contradicts the world, as a sentence.
    pub(crate) fn adding(&self, what: What) -> Result<Self, String> {
        let mut list = self.list.clone();
        listed::add(&mut list, what);
        let after = self.with(list);
        after.map_err(|faults| {
            let first = faults.first().map(super::facts::contradiction);
            first.unwrap_or_default()
        })
    }

    /// The list without one change, and without those that then contradict the
    /// world; with the number of these.
    pub(crate) fn without(&self, index: usize) -> (Self, usize) {
        let mut after = match self.with(Vec::new()) {
            Ok(after) => after,
            Err(_) => self.clone(),
        };
        let mut lost = 0;
        let taken = self.list.get(index);
        let joins = match taken {
            Some(What::AddAgent { agent }) => Some(agent.name.as_str()),
            _ => None,
        };
        for (other, what) in self.list.iter().enumerate() {
            let goes = joins.is_some() && listed::whose(what) == joins;
            if other == index || goes {
                continue;
            }
            let mut list = after.list.clone();
            list.push(what.clone());
            match after.with(list) {
                Ok(next) => after = next,
                Err(_) => lost += 1,
            }
        }
        (after, lost)
    }
}
