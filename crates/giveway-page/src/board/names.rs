//! What is said of a cell, and which cells are said at all.

use std::collections::BTreeMap;

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Cell, Grid, Ground, Scene, tr};

use super::{Badge, Cast, Frame, Track};
use crate::Problem;
use crate::rules::zone_of;

/// The most cells a side that have a name at once.
const SIDE: u32 = 32;
/// A window moves in steps of so many cells, so that it seldom does.
const STEP: u32 = 8;

/// The part of the map whose cells have names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// The first column and row.
    pub first: Cell,
    /// Columns and rows.
    pub size: (u32, u32),
}

impl Window {
    /// The window around a cell: all of a small map, else what lies around the
    /// cell, and as much as may be of what is in sight.
    pub fn around(cursor: Cell, frame: &Frame, board: (u32, u32)) -> Self {
        let (columns, rows) = frame.cells(board);
        let part = |at: u32, seen: (u32, u32), side: u32| {
            if side <= SIDE {
                return (0, side);
            }
            let middle = u32::midpoint(seen.0, seen.1);
            // Where the cell is in sight the middle of the screen is best.
            let reach = SIDE / 2 - STEP;
            let middle = middle.clamp(at.saturating_sub(reach), at + reach);
            let first = middle.saturating_sub(SIDE / 2) / STEP * STEP;
            (first.min(side - SIDE), SIDE)
        };
        let (x, width) = part(cursor.x, columns, board.0);
        let (y, height) = part(cursor.y, rows, board.1);
        Self {
            first: Cell::new(x, y),
            size: (width, height),
        }
    }

    /// This window as long as it reaches around a cell, else one with that in its middle: a hand
    /// that goes over the map does not rename what it passes.
    #[must_use]
    pub fn reaching(self, cursor: Cell, board: (u32, u32)) -> Self {
        let reaches = |at: u32, first: u32, size: u32, side: u32| {
            let end = first + size;
            let is_before_end = at + 1 < end || (end >= side && at < end);
            (at > first || (first == 0 && at == 0)) && is_before_end && end <= side
        };
        let part = |at: u32, first: u32, size: u32, side: u32| {
            if reaches(at, first, size, side) {
                (first, size)
            } else if side <= SIDE {
                (0, side)
            } else {
                (at.saturating_sub(SIDE / 2).min(side - SIDE), SIDE)
            }
        };
        let (x, width) = part(cursor.x, self.first.x, self.size.0, board.0);
        let (y, height) = part(cursor.y, self.first.y, self.size.1, board.1);
        Self {
            first: Cell::new(x, y),
            size: (width, height),
        }
    }

    /// The rows, by their number in the map.
    pub fn rows(&self) -> std::ops::Range<u32> {
        self.first.y..self.first.y + self.size.1
    }

    /// The columns, by their number in the map.
    pub fn columns(&self) -> std::ops::Range<u32> {
        self.first.x..self.first.x + self.size.0
    }
}

fn is_broken(track: &Track, time: u32) -> bool {
    let pose = track.pose(f64::from(time));
    pose.is_some_and(|pose| pose.badge == Some(Badge::Broken))
}

/// What is on each cell at a time, in words.
#[derive(Clone, Debug, Default)]
pub struct CellNames {
    parts: BTreeMap<Cell, Vec<String>>,
    notes: Vec<(Cell, String)>,
}

impl CellNames {
    /// What the agents have to do with each cell at a whole time, and what is
    /// wrong there.
    pub fn new(cast: &Cast, time: u32, problems: &[Problem]) -> Self {
        let mut names = Self::default();
        let agents = || {
            let agents = cast.agents.iter().zip(&cast.tracks).zip(&cast.is_there);
            let there = agents.filter(|(_, is_there)| **is_there);
            there.map(|(agent, _)| agent)
        };
        for (agent, _) in agents() {
            names.add(agent.start, tr!("start of {agent}", agent = agent.name));
        }
        for (agent, _) in agents() {
            if let Some(goal) = agent.goal {
                names.add(goal, tr!("goal of {agent}", agent = agent.name));
            }
        }
        for (agent, track) in agents() {
            for &cell in &agent.waypoints {
                let path = track.path().iter().take(time as usize + 1);
                let is_visited = cast.has_plan() && path.into_iter().any(|&at| at == Some(cell));

                names.add(
                    cell,
                    if is_visited {
                        tr!("waypoint of {agent}, visited", agent = agent.name)
                    } else {
                        tr!("waypoint of {agent}", agent = agent.name)
                    },
                );
            }
        }
        for (agent, track) in agents() {
            match track.cells_at(time)[..] {
                [from, to] => {
                    names.add(from, tr!("{agent} leaves", agent = agent.name));
                    names.add(to, tr!("{agent} comes", agent = agent.name));
                }
                [cell] if is_broken(track, time) => {
                    names.add(
                        cell,
                        tr!("{agent} is here, broken down", agent = agent.name),
                    );
                }
                // Where it starts it is at first: that need not be said twice.
                [cell] if time > 0 || cell != agent.start => {
                    names.add(cell, tr!("{agent} is here", agent = agent.name));
                }
                _ => {}
            }
        }
        for problem in problems {
            if let Some(cell) = problem.cell {
                let sentence = problem.sentence();
                let sentence = sentence.trim_end_matches('.');
                names.add(cell, tr!("problem: {sentence}", sentence));
            }
        }
        names
    }

    /// The same, with what some names end with.
    #[must_use]
    pub fn noting(self, notes: &[(Cell, String)]) -> Self {
        let notes = notes.to_vec();
        Self { notes, ..self }
    }

    /// The same with the rules of the scene's own, of the cells in a window.
    #[must_use]
    pub fn ruled(mut self, scene: &Scene, time: u32, window: &Window) -> Self {
        let holds = giveway_picture::in_force(&scene.constraints, time);
        let is_seen =
            |cell: &Cell| window.rows().contains(&cell.y) && window.columns().contains(&cell.x);
        for zone in &scene.zones {
            let rules = scene.constraints.iter().zip(&holds);
            let is_closed = rules.into_iter().any(|(rule, &holds)| {
                let is_it = matches!(rule.kind, ConstraintKind::Closed { .. });
                holds && is_it && zone_of(&rule.kind) == Some(&zone.name)
            });
            for cell in zone.cells().filter(is_seen) {
                self.add(
                    cell,
                    if is_closed {
                        tr!("{zone}, closed now", zone = zone.name)
                    } else {
                        tr!("what a cell is part of" => "zone {zone}", zone = zone.name)
                    },
                );
            }
        }
        for rule in scene.constraints.iter().filter(|rule| !rule.off) {
            if let ConstraintKind::OneWay { lane } = &rule.kind {
                for step in lane.windows(2) {
                    if let [from, to] = step {
                        self.add(*from, tr!("one way to {cell}", cell = to));
                    }
                }
            }
        }
        self
    }

    fn add(&mut self, cell: Cell, part: String) {
        self.parts.entry(cell).or_default().push(part);
    }

    /// The name of a cell: its column and row, then what is on it.
    pub fn name(&self, grid: &Grid, cell: Cell) -> String {
        let ground = grid.ground(cell).unwrap_or(Ground::Obstacle);
        let parts = self.parts.get(&cell).map_or(&[][..], Vec::as_slice);
        let ground = match ground {
            Ground::Free if parts.is_empty() => tr!("a cell is" => "free"),
            Ground::Free => "",
            Ground::Obstacle => tr!("what a cell is" => "obstacle"),
            Ground::Slow => tr!("slow zone"),
            Ground::Charger => tr!("what a cell is" => "charger"),
            Ground::SlowCharger => tr!("charger in the slow zone"),
        };
        let mut name = format!("{}, {}: {ground}", cell.x, cell.y);
        for (index, part) in parts.iter().enumerate() {
            if index > 0 || !ground.is_empty() {
                name += ", ";
            }
            name += part;
        }
        for (_, note) in self.notes.iter().filter(|(noted, _)| *noted == cell) {
            name += ", ";
            name += note;
        }
        name
    }
}
