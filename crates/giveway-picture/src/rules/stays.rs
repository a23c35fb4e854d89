//! The stays that rules ask for, as a plan makes them: when each begins and ends.

use giveway_model::condition::Times;
use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, Cell, Constraint, Plan};

/// A stay that a rule asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stay {
    /// The cell.
    pub cell: Cell,
    /// The time at which it begins.
    pub from: u32,
    /// The time at which it ends.
    pub to: u32,
}

impl Stay {
    /// How many steps of it are left at a time; nothing before it and from its end on.
    ///
    /// ```
    /// use giveway_model::Cell;
    /// use giveway_picture::Stay;
    /// let stay = Stay { cell: Cell::new(0, 0), from: 3, to: 5 };
    /// let left: Vec<_> = (2..=5).map(|time| stay.left_at(time)).collect();
    /// assert_eq!(left, [None, Some(2), Some(1), None]);
    /// ```
    pub fn left_at(self, time: u32) -> Option<u32> {
        (self.from <= time && time < self.to).then(|| self.to - time)
    }
}

/// The stays that a plan makes for the rules in force.
pub fn stays(rules: &[Constraint], agents: &[Agent], plan: &Plan) -> Vec<Stay> {
    let rules = rules.iter().filter(|rule| !rule.off);
    let made = rules.flat_map(|rule| {
        let ConstraintKind::Visit { cell, stay, times } = &rule.kind else {
            return Vec::new();
        };
        let names = rule.agents.as_ref();
        let bound = agents
            .iter()
            .filter(|agent| names.is_none_or(|names| names.contains(&agent.name)));
        let made = |agent: &Agent| {
            let path = plan.path(&agent.name);
            let from = first_stay(path, *cell, *stay, *times)?;
            Some(Stay {
                cell: *cell,
                from,
                to: from.saturating_add(*stay),
            })
        };
        bound.filter_map(made).collect()
    });
    made.collect()
}

/// When the first stay of so many steps begins at a cell that lies within some times.
pub fn first_stay(path: &[Option<Cell>], cell: Cell, stay: u32, times: Times) -> Option<u32> {
    let mut begun = None;
    for (at, time) in path.iter().zip(0_u32..) {
        if *at != Some(cell) || !times.contains(time) {
            begun = None;
            continue;
        }
        let first = *begun.get_or_insert(time);
        if time - first >= stay {
            return Some(first);
        }
    }
    // It rests there: the path ends, the stay goes on.
    begun.filter(|_| path.last() == Some(&Some(cell)))
}
