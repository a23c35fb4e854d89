//! An agent that cannot do its task even alone, whatever the horizon.

use giveway_model::Cell;

use super::Reserve;
use crate::terrain::{Terrain, Vertex};

/// The proof that an agent has no plan even alone. Only what looks at one agent
/// alone makes it: nothing there knows a horizon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoPlanAlone(());

impl NoPlanAlone {
    /// Exact tables, and the states of the times that they do not know, have no
    /// way to the end of the task.
    pub(super) const fn by_exact_tables() -> Self {
        Self(())
    }
}

/// The vertex of a cell where an agent has to be.
///
/// # Errors
/// Where there is none, so that nobody can be there.
pub fn has_to_be_at(cell: Cell, terrain: &Terrain) -> Result<Vertex, NoPlanAlone> {
    terrain.vertex(cell).ok_or(NoPlanAlone(()))
}

impl Reserve {
    /// A battery of this capacity at this level, with the floor taken off.
    ///
    /// # Errors
    /// Where it is below the floor, which no agent on its way may be.
    pub fn above(floor: u32, capacity: u32, level: u32) -> Result<Self, NoPlanAlone> {
        let levels = capacity.checked_sub(floor).zip(level.checked_sub(floor));
        let (full, initial) = levels.ok_or(NoPlanAlone(()))?;
        Ok(Self { full, initial })
    }
}
