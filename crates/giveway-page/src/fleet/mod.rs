//! Several robots at once: a row of starts, a row of goals, and what they have in common. They
//! come onto the board in one step, and stand there as a preview before.

mod card;
#[cfg(test)]
mod tests;

use giveway_model::{Battery, Cell};

use crate::draw::Measure;
use crate::{Draft, State};

pub use card::{Card, card};

/// What a person says of robots that are to come onto the board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FleetAction {
    /// So many robots, instead of one every few cells; `None` takes that back.
    Count(Option<u32>),
    /// As many the other way, or not.
    Back(bool),
    /// So many waypoints each, at random beside obstacles.
    Waypoints(u32),
    /// Waypoints are drawn again.
    DrawAgain,
    /// How much a battery holds; `None` is unlimited.
    Battery(Option<u32>),
    /// The level that a battery begins with.
    Level(u32),
    /// They come onto the board.
    Add,
    /// They do not.
    Cancel,
}

/// The most robots that are added at once.
pub const MOST: u32 = 500;
/// The most waypoints that each gets at random.
pub const MOST_WAYPOINTS: u32 = 8;

/// Robots that are to come onto the board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Fleet(giveway_model::fleet::Fleet);

impl Fleet {
    /// Robots that start along a row; they have the battery of the last robot.
    pub(crate) fn begin(cell: Cell, every: u32, draft: &Draft) -> Self {
        Self(giveway_model::fleet::Fleet {
            every,
            battery: draft.agents().last().and_then(|agent| agent.battery),
            ..giveway_model::fleet::Fleet::along(cell, cell)
        })
    }

    /// What is said of them.
    pub(crate) const fn said(&self) -> &giveway_model::fleet::Fleet {
        &self.0
    }

    /// The robots, as many as there are free starts and goals for.
    pub(crate) fn agents(&self, draft: &Draft) -> Vec<giveway_model::Agent> {
        self.0.agents(draft.grid(), draft.agents())
    }

    /// The same with another distance from one to the next, in cells.
    pub(crate) fn with_every(mut self, every: u32) -> Self {
        self.0.every = every;
        self
    }

    /// Whether it is known where they go.
    pub(crate) const fn has_goals(&self) -> bool {
        self.0.goals.is_some()
    }

    /// The row of goals begins.
    pub(crate) const fn begin_goals(&mut self, cell: Cell) {
        self.0.goals = Some((cell, cell));
    }

    /// The row that was begun last goes to a cell.
    pub(crate) const fn stretch(&mut self, to: Cell) {
        match &mut self.0.goals {
            Some(goals) => goals.1 = to,
            None => self.0.starts.1 = to,
        }
    }

    /// Takes the row of goals back; `None` where there is none yet.
    pub(crate) fn without_goals(mut self) -> Option<Self> {
        self.0.goals.take().is_some().then_some(self)
    }

    /// The same, said in another way.
    pub(crate) fn with(self, action: FleetAction) -> Self {
        let mut said = self.0;
        match action {
            FleetAction::Count(count) => said.count = count.map(|count| count.clamp(1, MOST)),
            FleetAction::Back(back) => said.back = back,
            FleetAction::Waypoints(each) => said.waypoints = each.min(MOST_WAYPOINTS),
            FleetAction::DrawAgain => said.draw = said.draw.wrapping_add(1),
            FleetAction::Battery(capacity) => {
                said.battery = capacity.map(|capacity| resized(said.battery, capacity));
            }
            FleetAction::Level(level) => {
                if let Some(battery) = &mut said.battery {
                    battery.initial = level.min(battery.capacity);
                }
            }
            FleetAction::Add | FleetAction::Cancel => {}
        }
        Self(said)
    }
}

/// A battery that holds so much; it begins with its level, as far as that fits.
pub(crate) fn resized(battery: Option<Battery>, capacity: u32) -> Battery {
    let level = battery.map(|battery| battery.initial);
    Battery {
        capacity,
        initial: level.unwrap_or(capacity).min(capacity),
    }
}

impl State {
    /// The robots that are to come onto the board, as far as it is known where they go.
    pub fn fleet_agents(&self) -> Vec<giveway_model::Agent> {
        let fleet = self.view.fleet.as_ref().filter(|_| self.can_place_fleet());
        fleet.map_or_else(Vec::new, |fleet| fleet.agents(&self.document.draft))
    }

    /// Whether several robots can be placed: on the scene itself.
    pub(crate) fn can_place_fleet(&self) -> bool {
        self.can_pick_shapes() && self.can_write_rules()
    }

    /// From one robot of a row to the next, in cells.
    pub(crate) fn robot_every(&self) -> u32 {
        self.view.drawing.measure(Measure::RobotEvery)
    }
}
