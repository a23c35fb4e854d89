//! Stays: the waits that a rule asks for.

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, Cell, Constraint};
use giveway_picture::first_stay;

use super::{Step, Way};

/// Marks the waits that are part of a stay that a rule in force asks of an agent: the first that
/// is long enough, as the board counts it down.
pub(super) fn mark(steps: &mut [Step], rules: &[Constraint], agent: &Agent, path: &[Option<Cell>]) {
    for rule in rules.iter().filter(|rule| !rule.off) {
        let ConstraintKind::Visit { cell, stay, times } = &rule.kind else {
            continue;
        };
        let names = rule.agents.as_ref();
        if names.is_some_and(|names| !names.contains(&agent.name)) {
            continue;
        }
        let Some(from) = first_stay(path, *cell, *stay, *times) else {
            continue;
        };
        let to = from.saturating_add(*stay);
        for step in steps.iter_mut() {
            let is_in = from <= step.begins && step.ends <= to;
            if is_in && step.way == Way::Wait {
                step.way = Way::Stay;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The steps along a row of cells, under a stay of so many steps at cell 1.
    fn ways(stay: u32, names: &str, row: &str) -> String {
        let cell = |c: char| Cell::new(c.to_digit(10).unwrap(), 0);
        let cells: Vec<Cell> = row.chars().map(cell).collect();
        let step = |(begins, pair): (u32, &[Cell])| Step {
            way: if pair[0] == pair[1] {
                Way::Wait
            } else {
                Way::Move
            },
            begins,
            ends: begins + 1,
            from: pair[0],
            to: pair[1],
        };
        let mut steps: Vec<Step> = (0..).zip(cells.windows(2)).map(step).collect();
        let rule = format!(
            r#"{{ "kind": "visit", "cell": [1, 0], "stay": {stay}, "agents": [{names}] }}"#
        );
        let rules = [serde_json::from_str(&rule).unwrap()];
        let agent: Agent =
            serde_json::from_str(r#"{ "name": "A1", "start": [0, 0], "goal": [0, 0] }"#).unwrap();
        let path: Vec<Option<Cell>> = cells.into_iter().map(Some).collect();
        mark(&mut steps, &rules, &agent, &path);
        let letter = |step: &Step| match step.way {
            Way::Move => 'm',
            Way::Slow => 's',
            Way::Wait => 'w',
            Way::Broken => 'b',
            Way::Turn(_) => 't',
            Way::Stay => 'y',
        };
        steps.iter().map(letter).collect()
    }

    #[test]
    fn the_first_wait_that_is_long_enough_is_the_stay() {
        assert_eq!(ways(2, r#""A1""#, "01112"), "myym");
        assert_eq!(ways(2, r#""A1""#, "011112"), "myywm", "it waits on");
        assert_eq!(ways(2, r#""A1""#, "0110111"), "mwmmyy");
        assert_eq!(ways(3, r#""A1""#, "01112"), "mwwm", "too short");
        assert_eq!(ways(2, r#""A2""#, "01112"), "mwwm", "of another one");
        assert_eq!(ways(0, r#""A1""#, "01112"), "mwwm", "it only comes by");
    }
}
