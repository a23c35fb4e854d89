//! Violations as sentences for a person.

mod table;

use super::charges::NoCharge;
use super::steps::Broken;
use crate::words::and;
use crate::{Cell, Constraint, tr};

pub(super) use table::{
    begins_in_transit, charge_repeated, charges_unsorted, empty_path, ends_in_transit,
    needs_changes, no_path, only_transit, stranger, wrong_end, wrong_from, wrong_stand,
    wrong_until,
};

pub(super) fn no_slow_edge(agent: &str, from: Cell, time: u32) -> String {
    tr!(
        "{agent} is in transit after time {time}, but no edge of {from} is slow.",
        agent,
        time,
        from
    )
}

pub(super) fn held(agent: &str, from: Cell, time: u32) -> String {
    tr!(
        "{agent} leaves {from} at time {time}, but a breakdown keeps it there.",
        agent,
        from,
        time
    )
}

pub(super) fn early(agent: &str, to: Cell, begin: u32) -> String {
    tr!(
        "{agent} sets off to {to} at time {begin}, when an obstacle is still there.",
        agent,
        to,
        begin
    )
}

pub(super) fn late_waypoint(agent: &str, waypoint: Cell, since: u32, end: u32) -> String {
    tr!(
        "{agent} does not visit {waypoint} after it became a waypoint at time {since}; its path ends at time {end}.",
        agent,
        waypoint,
        since,
        end
    )
}

pub(super) fn start(agent: &str, found: Cell, start: Cell) -> String {
    tr!(
        "{agent} begins at {found}, but its start is {start}.",
        agent,
        found,
        start
    )
}

pub(super) fn goal(agent: &str, found: Cell, goal: Cell, time: usize) -> String {
    tr!(
        "{agent} ends at {found} at time {time}, but its goal is {goal}.",
        agent,
        found,
        time,
        goal
    )
}

pub(super) fn waypoint(agent: &str, waypoint: Cell, arrival: usize) -> String {
    tr!(
        "{agent} does not visit its waypoint {waypoint} by the end of its path at time {arrival}.",
        agent,
        waypoint,
        arrival
    )
}

pub(super) fn obstacle(agent: &str, cell: Cell, time: usize, on_map: bool) -> String {
    if on_map {
        tr!(
            "{agent} is in the obstacle {cell} at time {time}.",
            agent,
            cell,
            time
        )
    } else {
        tr!(
            "{agent} is at {cell} at time {time}, which is off the map.",
            agent,
            cell,
            time
        )
    }
}

pub(super) fn broken_step(agent: &str, from: Cell, to: Cell, time: usize, why: Broken) -> String {
    match why {
        Broken::Jump => tr!(
            "{agent} goes from {from} to {to} at time {time}, but the two cells share no side.",
            agent,
            from,
            to,
            time
        ),
        Broken::TooFast => tr!(
            "{agent} crosses the slow edge from {from} to {to} at time {time} in one step; it takes two.",
            agent,
            from,
            to,
            time
        ),
        Broken::TooSlow => tr!(
            "{agent} is in transit from {from} to {to} after time {time}, but that edge is not slow.",
            agent,
            from,
            to,
            time
        ),
        Broken::TurnBack => tr!(
            "{agent} is in transit after time {time} and then at {from} again; a robot cannot turn back during a slow move.",
            agent,
            time,
            from
        ),
        Broken::LongTransit => tr!(
            "{agent} is in transit from {from} to {to} after time {time} for more than one step; a robot cannot stop during a slow move.",
            agent,
            from,
            to,
            time
        ),
    }
}

pub(super) fn vertex(a: &str, b: &str, cell: Cell, time: usize) -> String {
    tr!(
        "{a} and {b} are both at {cell} at time {time}.",
        a,
        b,
        cell,
        time
    )
}

pub(super) fn resting(a: &str, rests: &str, cell: Cell, time: usize, since: usize) -> String {
    tr!(
        "{a} is at {cell} at time {time}, where {rests} stays since time {since}.",
        a,
        cell,
        time,
        rests,
        since
    )
}

pub(super) fn swap(a: &str, b: &str, from: Cell, to: Cell, time: usize) -> String {
    tr!(
        "{a} goes from {from} to {to} at time {time} while {b} comes the other way.",
        a,
        from,
        to,
        time,
        b
    )
}

/// Two agents, each with the time at which it leaves; the edge as the first goes.
pub(super) fn slow_swap(a: (&str, usize), b: (&str, usize), edge: (Cell, Cell)) -> String {
    let ((a, a_left), (b, b_left), (from, to)) = (a, b, edge);
    if a_left == b_left {
        tr!(
            "{a} enters the slow edge from {from} to {to} at time {time} while {b} comes the other way.",
            a,
            from,
            to,
            time = a_left,
            b
        )
    } else {
        tr!(
            "{a} enters the slow edge from {from} to {to} at time {a_left}, and {b} comes the other way at time {b_left}.",
            a,
            from,
            to,
            a_left,
            b,
            b_left
        )
    }
}

pub(super) fn battery(agent: &str, level: i64, floor: i64, time: usize) -> String {
    tr!(
        "The battery of {agent} is at {level} at time {time}, below the floor of {floor}.",
        agent,
        level,
        time,
        floor
    )
}

pub(super) fn charge(agent: &str, time: usize, arrival: usize, why: NoCharge) -> String {
    match why {
        NoCharge::NoBattery => {
            tr!(
                "{agent} charges at time {time}, but it has no battery.",
                agent,
                time
            )
        }
        NoCharge::Arrived => tr!(
            "{agent} charges at time {time}, but it arrives at time {arrival} and may only charge before that.",
            agent,
            time,
            arrival
        ),
        NoCharge::Absent => tr!(
            "{agent} charges at time {time}, when it is not there.",
            agent,
            time
        ),
        NoCharge::InTransit => {
            tr!(
                "{agent} charges at time {time}, when it is in transit.",
                agent,
                time
            )
        }
        NoCharge::NoCharger(cell) => {
            tr!(
                "{agent} charges at time {time}, but there is no charger at {cell}.",
                agent,
                time,
                cell
            )
        }
    }
}

pub(super) fn moving(agent: &str, obstacle: &str, cell: Cell, time: u32) -> String {
    tr!(
        "{agent} is at {cell} at time {time}, where the moving obstacle {obstacle} is.",
        agent,
        cell,
        time,
        obstacle
    )
}

pub(super) fn moving_swap(
    agent: &str,
    obstacle: &str,
    (from, to): (Cell, Cell),
    time: u32,
) -> String {
    tr!(
        "{agent} and the moving obstacle {obstacle} exchange {from} and {to} from time {time} to {next}.",
        agent,
        obstacle,
        from,
        to,
        time,
        next = time + 1
    )
}

pub(super) fn constraint(rule: &Constraint, agents: &[String], time: u32) -> String {
    let rule = rule.called();
    match agents {
        [agent] => tr!("{agent} breaks {rule} at time {time}.", agent, rule, time),
        _ => tr!(
            "{agents} break {rule} at time {time}.",
            agents = and(agents),
            rule,
            time
        ),
    }
}
