//! Steps and cells in the units of the world, where a scene has them.

use super::grouped;
use crate::{Cell, Cost, Units, tr};

/// So many steps as a time: `2 min 9 s`; `None` where a scene has no units.
pub fn duration(units: Option<Units>, steps: u32) -> Option<String> {
    let milliseconds = u64::from(units?.step.thousandths()) * u64::from(steps);
    let tenths = (milliseconds + 50) / 100;
    if tenths < 600 && !tenths.is_multiple_of(10) {
        let (whole, tenth) = (tenths / 10, tenths % 10);
        return Some(tr!("a time" => "{whole}.{tenth} s", whole, tenth));
    }
    let seconds = (milliseconds + 500) / 1000;
    let (hours, minutes, seconds) = (seconds / 3600, seconds / 60 % 60, seconds % 60);
    Some(match (hours, minutes) {
        (0, 0) => tr!("a time" => "{seconds} s", seconds),
        (0, _) if seconds == 0 => tr!("a time" => "{minutes} min", minutes),
        (0, _) => tr!("a time" => "{minutes} min {seconds} s", minutes, seconds),
        _ => tr!("a time" => "{hours} h {minutes} min", hours = grouped(hours), minutes),
    })
}

/// So many steps, and the time that they take where a scene has units: `86 (2 min 9 s)`.
pub fn timed(units: Option<Units>, steps: u32) -> String {
    match duration(units, steps) {
        Some(duration) => format!("{steps} ({duration})"),
        None => steps.to_string(),
    }
}

/// A value of a cost, with the time that it is where it counts steps.
pub fn measured(units: Option<Units>, cost: Cost, value: u32) -> String {
    match cost {
        Cost::Makespan | Cost::SumOfCosts | Cost::Waits => timed(units, value),
        Cost::Charges | Cost::Moves | Cost::Penalty => value.to_string(),
    }
}

/// How far two cells are apart along rows and columns: `12.8 m`; `None` where a scene has no units.
pub fn distance(units: Option<Units>, from: Cell, to: Cell) -> Option<String> {
    let cells = from.x.abs_diff(to.x) + from.y.abs_diff(to.y);
    Some(length(units?, cells))
}

/// So many cells as a length: `12.8 m`.
pub fn length(units: Units, cells: u32) -> String {
    let millimetres = u64::from(units.cell.thousandths()) * u64::from(cells);
    let decimetres = (millimetres + 50) / 100;
    let (whole, tenth) = (grouped(decimetres / 10), decimetres % 10);
    if tenth == 0 {
        tr!("a length" => "{whole} m", whole)
    } else {
        tr!("a length" => "{whole}.{tenth} m", whole, tenth)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Measure;

    fn units(cell: u32, step: u32) -> Units {
        let measure = |thousandths| Measure::from_thousandths(thousandths).unwrap();
        Units {
            cell: measure(cell),
            step: measure(step),
        }
    }

    #[test]
    fn steps_as_a_time() {
        let of = |step, steps| duration(Some(units(800, step)), steps).unwrap();
        assert_eq!(of(1500, 86), "2 min 9 s");
        assert_eq!(of(1500, 1), "1.5 s");
        assert_eq!(of(1500, 2), "3 s");
        assert_eq!(of(1000, 60), "1 min");
        assert_eq!(of(59_980, 1), "1 min");
        assert_eq!(of(60_000, 61), "1 h 1 min");
        assert_eq!(of(1, 0), "0 s");
        assert_eq!(timed(Some(units(800, 1500)), 86), "86 (2 min 9 s)");
        assert_eq!(
            (timed(None, 86), duration(None, 86)),
            ("86".to_owned(), None)
        );
        assert_eq!(measured(Some(units(800, 1500)), Cost::Charges, 9), "9");
        assert_eq!(measured(Some(units(800, 1500)), Cost::Waits, 2), "2 (3 s)");
    }

    #[test]
    fn cells_as_a_length() {
        let of = |x, y| distance(Some(units(800, 1500)), Cell::new(1, 1), Cell::new(x, y)).unwrap();
        assert_eq!([of(17, 1), of(0, 3), of(1, 1)], ["12.8 m", "2.4 m", "0 m"]);
        assert_eq!(of(6, 1), "4 m");
        assert_eq!(distance(None, Cell::new(0, 0), Cell::new(1, 0)), None);
    }
}
