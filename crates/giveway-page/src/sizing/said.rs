//! The sentence of how many robots: from, to, how they go, and what stands beside it.

use std::collections::BTreeMap;
use std::ops::RangeBounds;

use giveway_model::fleet::Fleet;
use giveway_model::{Cell, Grid, Ground, Scene};

use super::SizingAction;
use crate::fleet::{MOST_WAYPOINTS, resized};
use crate::{Draft, State};

/// The most robots that are asked about.
pub const MOST_ROBOTS: u32 = 500;
/// The longest time limit of each solve, in seconds.
pub const MOST_SECONDS: u32 = 600;
/// The most numbers of robots of one run.
const MOST_NUMBERS: u32 = 60;

/// How the floor that is compared differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beside {
    /// A charger more at a cell, or one less where there is one.
    Charger(Cell),
    /// A rule that is in force is off, or the other way round; by its number in the scene.
    Rule(usize),
}

/// What is asked.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Said {
    pub(crate) from: u32,
    pub(crate) to: u32,
    pub(crate) by: u32,
    /// Where they start and go, and what they have.
    pub(crate) fleet: Fleet,
    pub(crate) beside: Option<Beside>,
    pub(crate) seconds: u32,
}

impl Said {
    /// What is asked first: rows at the left and the right side of the floor, with the battery of
    /// the last robot and as many waypoints; or those of robots that were drawn in rows.
    pub(crate) fn begin(state: &State) -> Self {
        let draft = &state.document.draft;
        let drawn = state.view.fleet.as_ref().map(|fleet| fleet.said().clone());
        let fleet = drawn.filter(|fleet| fleet.goals.is_some());
        let fleet = fleet.unwrap_or_else(|| at_both_sides(draft));
        let mut said = Self {
            from: 4,
            to: 4,
            by: 4,
            fleet: Fleet {
                every: 1,
                count: None,
                ..fleet
            },
            beside: None,
            seconds: 5,
        };
        let most = said.most(draft);
        said.from = most.clamp(1, 4);
        said.to = (most / 4 * 4).clamp(said.from, 44);
        said
    }

    /// How many robots there is room for in both rows.
    pub(crate) fn most(&self, draft: &Draft) -> u32 {
        let most = self.fleet.mixed(draft.grid()).len();
        u32::try_from(most).unwrap_or(MOST_ROBOTS).min(MOST_ROBOTS)
    }

    /// The numbers of robots, as far as there is room.
    pub(crate) fn counts(&self, draft: &Draft) -> Vec<u32> {
        let most = self.most(draft).min(self.to);
        let counts = (self.from..=most).step_by(self.by.max(1) as usize);
        counts.take(MOST_NUMBERS as usize).collect()
    }

    /// The same, said in another way.
    pub(crate) fn say(&mut self, action: SizingAction) {
        let fleet = &mut self.fleet;
        match action {
            SizingAction::From(from) => {
                self.from = from.clamp(1, MOST_ROBOTS);
                self.to = self.to.max(self.from);
            }
            SizingAction::To(to) => {
                self.to = to.clamp(1, MOST_ROBOTS);
                self.from = self.from.min(self.to);
            }
            SizingAction::By(by) => self.by = by.clamp(1, MOST_ROBOTS),
            SizingAction::Back(back) => fleet.back = back,
            SizingAction::Waypoints(each) => fleet.waypoints = each.min(MOST_WAYPOINTS),
            SizingAction::Battery(capacity) => {
                fleet.battery = capacity.map(|capacity| resized(fleet.battery, capacity));
            }
            SizingAction::Level(level) => {
                if let Some(battery) = &mut fleet.battery {
                    battery.initial = level.min(battery.capacity);
                }
            }
            SizingAction::Seconds(seconds) => self.seconds = seconds.clamp(1, MOST_SECONDS),
            SizingAction::DrawAgain => fleet.draw = fleet.draw.wrapping_add(1),
            SizingAction::Beside(beside) => self.beside = beside,
            SizingAction::Picked(cell) => self.beside = Some(Beside::Charger(cell)),
            SizingAction::Show(_)
            | SizingAction::Pick(_)
            | SizingAction::Solve
            | SizingAction::Cancel
            | SizingAction::Look(_)
            | SizingAction::Take => {}
        }
    }
}

impl Beside {
    /// The floor with this difference; `None` where it cannot be.
    pub(crate) fn of(self, mut scene: Scene) -> Option<Scene> {
        match self {
            Self::Charger(cell) => {
                let mut grid = Grid::from_rows(&scene.map).ok()?;
                let ground = match grid.ground(cell)? {
                    Ground::Free => Ground::Charger,
                    Ground::Slow => Ground::SlowCharger,
                    Ground::Charger => Ground::Free,
                    Ground::SlowCharger => Ground::Slow,
                    Ground::Obstacle => return None,
                };
                grid.set_ground(cell, ground);
                scene.map = grid.rows();
            }
            Self::Rule(rule) => {
                let rule = scene.constraints.get_mut(rule)?;
                rule.off = !rule.off;
            }
        }
        Some(scene)
    }
}

/// Rows at the left and the right side: the columns nearest to both that have most free cells.
fn at_both_sides(draft: &Draft) -> Fleet {
    let grid = draft.grid();
    let (width, height) = (grid.width(), grid.height());
    let free = |x: u32| {
        let cells = (0..height).map(|y| Cell::new(x, y));
        let is_plain = |cell: &Cell| grid.ground(*cell) == Some(Ground::Free);
        cells.filter(is_plain).count()
    };
    let quarter = (width / 4).max(1);
    let fullest = |columns: &mut dyn Iterator<Item = u32>| {
        let mut best = (0, 0);
        for x in columns {
            let count = free(x);
            if count > best.1 {
                best = (x, count);
            }
        }
        best.0
    };
    // Where robots stand in columns already, others start and go there, too.
    let agents = draft.agents();
    let starts = most_common(agents.iter().map(|agent| agent.start.x), ..width / 2);
    let goals = agents
        .iter()
        .filter_map(|agent| agent.goal)
        .map(|goal| goal.x);
    let goals = most_common(goals, width / 2..);
    let left = starts.unwrap_or_else(|| fullest(&mut (0..quarter)));
    let right = goals.unwrap_or_else(|| fullest(&mut (width - quarter..width).rev()));
    let last = height.saturating_sub(1);
    Fleet {
        goals: Some((Cell::new(right, 0), Cell::new(right, last))),
        back: true,
        waypoints: agents.last().map_or(0, |agent| {
            u32::try_from(agent.waypoints.len()).map_or(MOST_WAYPOINTS, |n| n.min(MOST_WAYPOINTS))
        }),
        battery: draft.agents().last().and_then(|agent| agent.battery),
        ..Fleet::along(Cell::new(left, 0), Cell::new(left, last))
    }
}

/// The column that occurs most in a part of the floor, at least three times.
fn most_common(columns: impl Iterator<Item = u32>, part: impl RangeBounds<u32>) -> Option<u32> {
    let mut counts = BTreeMap::new();
    for x in columns.filter(|x| part.contains(x)) {
        *counts.entry(x).or_insert(0) += 1;
    }
    let most = counts.values().max().copied().filter(|&most| most >= 3)?;
    counts.into_iter().find(|&(_, n)| n == most).map(|(x, _)| x)
}
