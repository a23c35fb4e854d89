//! What the hand does on the board, and what it could take hold of.

use giveway_model::Cell;

use crate::area::Hand;
use crate::gesture::{Gesture, Placing, Stroke, Thing};
use crate::{Activity, Draft, State};

impl State {
    /// The stroke that is not finished.
    pub(crate) fn stroke(&self) -> Option<&Stroke> {
        match &self.view.gesture {
            Gesture::Stroke(stroke) => Some(stroke),
            Gesture::None | Gesture::Placing(_) | Gesture::Row | Gesture::Area(_) => None,
        }
    }

    /// The agent that is being placed.
    pub const fn placing(&self) -> Option<Placing> {
        match &self.view.gesture {
            Gesture::Placing(placing) => Some(*placing),
            Gesture::None | Gesture::Stroke(_) | Gesture::Row | Gesture::Area(_) => None,
        }
    }

    /// The hand on an area.
    pub(crate) fn hand(&self) -> Option<&Hand> {
        match &self.view.gesture {
            Gesture::Area(hand) => Some(hand),
            Gesture::None | Gesture::Stroke(_) | Gesture::Placing(_) | Gesture::Row => None,
        }
    }

    /// Whether a stroke is being made: the board shows what it does so far, and
    /// nothing else has changed.
    pub fn has_stroke(&self) -> bool {
        self.stroke().is_some()
    }

    /// Whether a stroke or a row is being made: the arrows stretch it.
    pub(crate) fn is_drawing(&self) -> bool {
        matches!(self.view.gesture, Gesture::Stroke(_) | Gesture::Row)
    }

    /// Whether the hand is doing something on the board.
    pub fn has_gesture(&self) -> bool {
        self.view.gesture != Gesture::None
    }

    /// Whether there is something on a cell that the tool `Select` moves.
    pub fn can_move(&self, cell: Cell) -> bool {
        self.thing_at(cell).is_some()
    }

    /// What the tool `Select` takes hold of on a cell.
    pub(crate) fn thing_at(&self, cell: Cell) -> Option<Thing> {
        let is_still = match self.lesson() {
            Some(lesson) => !lesson.allows_moving(),
            // Before a room a hand only points.
            None => self.is_presented(),
        };
        if is_still {
            return None;
        }
        match &self.document.mode.activity {
            Activity::Steering(_) => return None,
            Activity::Changing(changing) => return self.thing_in(changing.draft(), cell),
            Activity::Comparing(comparing) => {
                return self.thing_in(comparing.changing.draft(), cell);
            }
            Activity::Editing | Activity::Auditing(_) => {}
        }
        let draft = &self.document.draft;
        // What the scene is made of can only be moved where it is shown.
        if self.world().grid() != draft.grid() {
            return None;
        }
        let standing = self.agent_at(cell);
        let starts = |agent: usize| draft.agents().get(agent).is_some_and(|a| a.start == cell);
        let start = standing.filter(|&agent| starts(agent)).map(Thing::Start);
        start.or_else(|| Thing::lying(draft, cell, self.selected_agent()))
    }

    /// The same in the world that changes: where agents are is settled, and what
    /// waypoints they had, too.
    fn thing_in(&self, world: &Draft, cell: Cell) -> Option<Thing> {
        if self.agent_at(cell).is_some() {
            return None;
        }
        let mut agents = world.agents().iter().enumerate();
        let goal =
            agents.position(|(index, agent)| self.is_there(index) && agent.goal == Some(cell));
        goal.map(Thing::Goal)
            .or_else(|| Thing::painted(world, cell))
    }

    /// Whether something is being made whose next step stands in the column: robots, cells of a
    /// floor plan, or a rule.
    pub fn is_making(&self) -> bool {
        self.view.fleet.is_some() || self.open_plan().is_some() || self.is_writing_rule()
    }
}
