//! Turns: the waits in which a robot turns before it goes on.

use giveway_model::constraint::{Heading, quarter_turn};
use giveway_model::{Agent, Constraint};

use super::{Step, Way};

/// Which way a robot turns, by the shorter side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// A quarter turn to the left.
    Left,
    /// A quarter turn to the right.
    Right,
    /// Half a turn.
    Back,
}

impl Turn {
    /// The turn from one direction to another; `None` straight on.
    const fn of(from: Heading, to: Heading) -> Option<Self> {
        match (4 + to as u32 - from as u32) % 4 {
            1 => Some(Self::Right),
            2 => Some(Self::Back),
            3 => Some(Self::Left),
            _ => None,
        }
    }
}

/// Marks the waits in which a robot turns: as late as it can before the move, as the board
/// shows it, and as many as the rules ask for.
pub(super) fn mark(steps: &mut [Step], rules: &[Constraint], agent: &Agent) {
    let quarter = quarter_turn(rules, &agent.name);
    if quarter == 0 {
        return;
    }
    let heading_of = |step: &Step| Heading::of(step.from, step.to);
    let first = steps.iter().find_map(heading_of);
    let Some(mut facing) = agent.heading.or(first) else {
        return;
    };
    for index in 0..steps.len() {
        let Some(heading) = steps.get(index).and_then(heading_of) else {
            continue;
        };
        if let (Some(turn), Some(before)) = (Turn::of(facing, heading), steps.get_mut(..index)) {
            let needed = quarter.saturating_mul(facing.quarters_to(heading)) as usize;
            let waits = before.iter_mut().rev();
            let waits = waits.take_while(|step| step.way == Way::Wait).take(needed);
            waits.for_each(|step| step.way = Way::Turn(turn));
        }
        facing = heading;
    }
}

#[cfg(test)]
mod tests {
    use giveway_model::Cell;

    use super::*;

    /// Steps from cells like `00 10 10 11`, marked under a rule of so many steps a quarter.
    fn ways(quarter: u32, heading: Option<Heading>, cells: &str) -> String {
        let cell = |at: &str| {
            let digit = |n: usize| u32::from(at.as_bytes()[n] - b'0');
            Cell::new(digit(0), digit(1))
        };
        let cells: Vec<Cell> = cells.split(' ').map(cell).collect();
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
        let rule = format!(r#"{{ "kind": "turns", "quarter": {quarter}, "agents": ["A1"] }}"#);
        let rules = [serde_json::from_str(&rule).unwrap()];
        let agent: Agent =
            serde_json::from_str(r#"{ "name": "A1", "start": [0, 0], "goal": [0, 0] }"#).unwrap();
        let agent = Agent { heading, ..agent };
        mark(&mut steps, &rules, &agent);
        let letter = |step: &Step| match step.way {
            Way::Move => 'm',
            Way::Slow => 's',
            Way::Wait => 'w',
            Way::Broken => 'b',
            Way::Stay => 'y',
            Way::Turn(Turn::Left) => 'l',
            Way::Turn(Turn::Right) => 'r',
            Way::Turn(Turn::Back) => 'u',
        };
        steps.iter().map(letter).collect()
    }

    #[test]
    fn it_turns_right_before_it_goes_on() {
        assert_eq!(ways(1, None, "00 10 10 10 11"), "mwrm");
        assert_eq!(ways(2, None, "00 10 10 10 11"), "mrrm");
        assert_eq!(ways(1, None, "01 11 11 10"), "mlm");
        assert_eq!(ways(1, None, "00 10 10 10 00"), "muum");
        assert_eq!(ways(1, None, "00 10 10 20 20"), "mwmw", "straight on");
    }

    #[test]
    fn at_its_start_it_turns_from_its_heading() {
        assert_eq!(ways(1, Some(Heading::North), "00 00 10"), "rm");
        assert_eq!(ways(1, None, "00 00 10"), "wm", "the first move is free");
    }

    #[test]
    fn a_plan_that_turns_too_fast_is_marked_as_far_as_it_waits() {
        assert_eq!(ways(3, None, "00 10 10 11"), "mrm");
        assert_eq!(ways(1, None, "00 10 11"), "mm");
    }
}
