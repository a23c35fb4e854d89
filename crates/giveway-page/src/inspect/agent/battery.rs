//! The battery of an agent, as a picture of a few cells.

use crate::Reserve;

/// What the inspector tells of a battery.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BatteryFacts {
    /// The level.
    pub level: u32,
    /// The level after a charge.
    pub capacity: u32,
    /// Whether the agent charges at the time shown.
    pub charges: bool,
    /// How full it is.
    pub reserve: Reserve,
}

impl BatteryFacts {
    /// The most cells of the picture.
    const CELLS: u32 = 12;

    /// How many cells of the picture are full, and how many there are: a cell a
    /// step, if there are not too many.
    pub const fn cells(&self) -> (u32, u32) {
        if self.capacity <= Self::CELLS {
            return (self.level, self.capacity);
        }
        let full = self.level as u64 * Self::CELLS as u64;
        // Only an empty battery is shown as empty.
        (full.div_ceil(self.capacity as u64) as u32, Self::CELLS)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_large_battery_is_drawn_with_a_few_cells() {
        let cells = |level| {
            let reserve = Reserve::Enough;
            let (capacity, charges) = (1_000_000, false);
            BatteryFacts {
                level,
                capacity,
                charges,
                reserve,
            }
            .cells()
        };
        assert_eq!(cells(1_000_000), (12, 12));
        assert_eq!(cells(1), (1, 12));
        assert_eq!(cells(0), (0, 12));
    }
}
