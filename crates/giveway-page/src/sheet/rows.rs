//! Which rows the plan table has on paper: a long time in which nothing changes is one row,
//! so that a breakdown of 5,000 steps does not fill 100 pages.

use crate::table::{level, place};
use crate::timeline::Lane;

/// The fewest times in which nothing changes that are one row.
const FEWEST: u32 = 3;

/// A row of the plan table on paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Row {
    /// Where the robots are at a time.
    Time(u32),
    /// From one time to another, both included, all is as in the row above.
    Still(u32, u32),
}

/// The rows of a plan up to a time.
pub(super) fn rows(lanes: &[Lane], last: u32) -> Vec<Row> {
    let mut rows = Vec::new();
    let mut time = 0;
    let changes = changes(lanes, last);
    let is_still = |time: u32| changes.get(time as usize) == Some(&false);
    while time <= last {
        let still = (time..=last).take_while(|&time| is_still(time)).count();
        // At most the times up to the last one.
        let still = u32::try_from(still).unwrap_or(0);
        if still >= FEWEST {
            rows.push(Row::Still(time, time + still - 1));
            time += still;
        } else {
            rows.push(Row::Time(time));
            time += 1;
        }
    }
    rows
}

/// Whether a row at each time would be another one than the row before it.
fn changes(lanes: &[Lane], last: u32) -> Vec<bool> {
    let mut changes = vec![false; last as usize + 1];
    if let Some(first) = changes.first_mut() {
        *first = true;
    }
    for lane in lanes {
        let entry = |time: u32| (place(lane, time), level(lane, time));
        // Nothing stands in a row before a robot comes and after it arrived.
        let until = lane.arrival.saturating_add(1).min(last);
        for time in lane.begins.max(1)..=until {
            if let Some(changes) = changes.get_mut(time as usize)
                && !*changes
            {
                *changes = entry(time) != entry(time - 1);
            }
        }
    }
    changes
}

#[cfg(test)]
mod tests {
    use giveway_model::Cell;

    use super::*;
    use crate::sample::solved;
    use crate::table::lanes;

    /// A robot that waits for so many steps, and then goes on.
    fn broken_down(steps: u32) -> Lane {
        let state = solved();
        let mut lane = lanes(state.shown().unwrap(), &state.document.draft).remove(0);
        let first = *lane.steps.first().unwrap();
        let wait = lane.steps.iter().find(|step| step.from == step.to).copied();
        let here = |begins: u32| crate::timeline::Step {
            begins,
            ends: begins + 1,
            from: first.from,
            to: first.from,
            ..wait.unwrap_or(first)
        };
        lane.steps = (0..steps).map(here).collect();
        lane.steps.push(crate::timeline::Step {
            begins: steps,
            ends: steps + 1,
            ..first
        });
        lane.arrival = steps + 1;
        (lane.capacity, lane.levels, lane.charges) = (None, Vec::new(), Vec::new());
        lane
    }

    #[test]
    fn a_long_wait_is_one_row() {
        let lane = broken_down(5_000);
        assert_eq!(lane.entry, Cell::new(0, 0));
        let found = rows(&[lane], 5_001);
        let expected = [Row::Time(0), Row::Still(1, 5_000), Row::Time(5_001)];
        assert_eq!(found, expected);
    }

    #[test]
    fn a_short_wait_and_one_in_which_another_moves_are_not() {
        let lane = broken_down(2);
        let each: Vec<Row> = (0..=3).map(Row::Time).collect();
        assert_eq!(rows(&[lane], 3), each);
        let state = solved();
        let mut both = lanes(state.shown().unwrap(), &state.document.draft);
        both.push(broken_down(18));
        let each: Vec<Row> = (0..=18).map(Row::Time).collect();
        assert_eq!(rows(&both, 18), each);
    }

    #[test]
    fn the_time_after_all_arrived_is_one_row() {
        let found = rows(&[broken_down(0)], 9);
        assert_eq!(
            found,
            [Row::Time(0), Row::Time(1), Row::Time(2), Row::Still(3, 9)]
        );
    }
}
