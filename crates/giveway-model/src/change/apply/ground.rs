//! Obstacles, the slow zone and chargers that changes put and take away.

use super::{Reason, Timeline, World, refuse};
use crate::{Cell, Ground};

impl World<'_> {
    pub(super) fn ground(&self, cell: Cell) -> Result<Ground, Reason> {
        let off = || refuse::off_map(cell, &self.grid);
        self.grid.ground(cell).ok_or_else(off)
    }

    pub(super) fn block(&mut self, index: usize, cell: Cell) -> Result<(), Reason> {
        if self.ground(cell)? == Ground::Obstacle {
            return Err(refuse::blocked(cell));
        }
        self.grid.set_ground(cell, Ground::Obstacle);
        self.obstacles.insert(cell, index);
        Ok(())
    }

    pub(super) fn unblock(&mut self, cell: Cell) -> Result<(), Reason> {
        if self.ground(cell)? != Ground::Obstacle {
            return Err(refuse::no_obstacle(cell));
        }
        let mut timelines = self.after.timelines.iter();
        let stands = |timeline: &&Timeline| timeline.stands().is_some_and(|it| it.cell == cell);
        if let Some(timeline) = timelines.find(stands) {
            return Err(refuse::stands_at(cell, timeline.name()));
        }
        self.grid.set_ground(cell, Ground::Free);
        self.obstacles.remove(&cell);
        Ok(())
    }

    /// Changes whether vertices are chargers, and in the slow zone.
    pub(super) fn pave(
        &mut self,
        cells: &[Cell],
        make: impl Fn(bool, bool) -> (bool, bool),
    ) -> Result<(), Reason> {
        for &cell in cells {
            let ground = self.ground(cell)?;
            if !ground.is_vertex() {
                return Err(refuse::in_obstacle(cell));
            }
            let (charger, slow) = make(ground.is_charger(), ground.is_slow());
            self.grid.set_ground(cell, Ground::vertex(charger, slow));
        }
        Ok(())
    }

    pub(super) fn charger(&mut self, cell: Cell, is_there: bool) -> Result<(), Reason> {
        let ground = self.ground(cell)?;
        if ground.is_vertex() && ground.is_charger() == is_there {
            return Err(refuse::charger(cell, is_there));
        }
        self.pave(&[cell], |_, slow| (is_there, slow))
    }
}
