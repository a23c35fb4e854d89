//! What an agent does in a step, in words.

use giveway_model::tr;

use crate::timeline::{Lane, Turn, Way};
use crate::words::at;

/// What an agent does in the step that begins at a time.
pub(super) fn doing(lane: &Lane, time: u32) -> String {
    if time < lane.begins {
        return tr!(
            "Joins at {time} on {cell}",
            time = lane.begins,
            cell = at(lane.entry)
        );
    }
    let Some(step) = lane.step_at(time) else {
        let end = at(lane.end());
        if let Some((from, cell)) = lane.stopped {
            return if time < from {
                tr!("Half way from {from} to {to}", from = end, to = at(cell))
            } else {
                tr!(
                    "Broken down for good at {cell} since {time}",
                    cell = at(cell),
                    time = from
                )
            };
        }
        if let Some(until) = lane.removed {
            return if time < until {
                tr!("At {end}, gone from time {until} on", end, until)
            } else {
                tr!("Removed at time {until}", until)
            };
        }
        if !lane.arrives {
            return tr!("At {end}, not led any further", end);
        }
        return if lane.stays || time == lane.arrival {
            tr!("Arrived at {end}", end)
        } else {
            tr!("Arrived at {end}, and gone", end)
        };
    };
    let (from, to) = (at(step.from), at(step.to));
    let charges = lane.charges.contains(&time);
    match step.way {
        _ if step.begins < time => tr!("Half way from {from} to {to}", from, to),
        Way::Move if charges => tr!("Charging at {from}, then to {to}", from, to),
        Way::Slow if charges => tr!("Charging at {from}, then slowly to {to}", from, to),
        Way::Wait | Way::Turn(_) | Way::Stay | Way::Broken if charges => {
            tr!("Charging at {from}, and waiting there", from)
        }
        Way::Move => tr!("Going from {from} to {to}", from, to),
        Way::Slow => tr!("Going slowly from {from} to {to}", from, to),
        Way::Wait => {
            let until = until(lane, time, step.way);
            tr!("Waiting at {from} until {until}", from, until)
        }
        Way::Stay => {
            let until = until(lane, time, step.way);
            tr!(
                "Staying at {from} until {until}, as a rule asks",
                from,
                until
            )
        }
        Way::Turn(turn) => {
            let until = until(lane, time, step.way);
            match turn {
                Turn::Left => tr!("Turning left at {from} until {until}", from, until),
                Turn::Right => tr!("Turning right at {from} until {until}", from, until),
                Turn::Back => tr!("Turning back at {from} until {until}", from, until),
            }
        }
        Way::Broken => {
            let until = until(lane, time, step.way);
            tr!("Broken down at {from} until {until}", from, until)
        }
    }
}

/// The time up to which an agent goes on with what it does in the step at a time.
fn until(lane: &Lane, time: u32, way: Way) -> u32 {
    let later = lane.steps.iter().filter(|step| step.begins >= time);
    let same = later.take_while(|step| step.way == way);
    same.last().map_or(time, |step| step.ends)
}

#[cfg(test)]
mod tests {
    use giveway_model::Cell;

    use super::*;

    #[test]
    fn a_wait_tells_its_end() {
        let lane = |charges| Lane {
            agent: 0,
            name: "A1".to_owned(),
            entry: Cell::new(0, 0),
            begins: 0,
            arrival: 3,
            arrives: true,
            stays: false,
            removed: None,
            stopped: None,
            steps: [(0, 1, 0), (1, 2, 0), (2, 3, 1)]
                .map(|(begins, ends, x)| crate::timeline::Step {
                    way: if x == 0 { Way::Wait } else { Way::Move },
                    begins,
                    ends,
                    from: Cell::new(0, 0),
                    to: Cell::new(x, 0),
                })
                .to_vec(),
            charges,
            capacity: None,
            levels: Vec::new(),
        };
        assert_eq!(doing(&lane(vec![]), 0), "Waiting at (0, 0) until 2");
        assert_eq!(
            doing(&lane(vec![1]), 1),
            "Charging at (0, 0), and waiting there"
        );
        let mut broken = lane(vec![]);
        broken.steps[0].way = Way::Broken;
        assert_eq!(doing(&broken, 0), "Broken down at (0, 0) until 1");
        assert_eq!(doing(&broken, 1), "Waiting at (0, 0) until 2");
        assert_eq!(doing(&lane(vec![]), 3), "Arrived at (1, 0)");
        assert_eq!(doing(&lane(vec![]), 4), "Arrived at (1, 0), and gone");
    }
}
