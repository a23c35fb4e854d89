//! What is wrong with how a plan is written: its paths, their ends, the times of its charges.

use crate::tr;

pub(in crate::check) fn no_path(agent: &str) -> String {
    tr!("The plan has no path for {agent}.", agent)
}

pub(in crate::check) fn empty_path(agent: &str) -> String {
    tr!(
        "The path of {agent} is empty; even a robot that never moves has one cell.",
        agent
    )
}

pub(in crate::check) fn only_transit(agent: &str) -> String {
    tr!(
        "The path of {agent} is in transit all the time and names no cell.",
        agent
    )
}

pub(in crate::check) fn begins_in_transit(agent: &str, from: u32) -> String {
    tr!(
        "The path of {agent} begins in transit; at time {from} it must be at its start.",
        agent,
        from
    )
}

pub(in crate::check) fn ends_in_transit(agent: &str, time: usize) -> String {
    tr!(
        "The path of {agent} ends in transit at time {time}; it must end at a cell.",
        agent,
        time
    )
}

pub(in crate::check) fn stranger(agent: &str, what: &str) -> String {
    tr!(
        "The plan has {what} for {agent}, but there is no robot of that name.",
        what,
        agent
    )
}

pub(in crate::check) fn needs_changes(agent: &str, what: &str) -> String {
    tr!(
        "In this plan {agent} {what}, so it can only be checked together with its changes.",
        agent,
        what
    )
}

pub(in crate::check) fn wrong_from(agent: &str, found: u32, from: u32) -> String {
    tr!(
        "The path of {agent} begins at time {found}, but it is there from time {from} on.",
        agent,
        found,
        from
    )
}

pub(in crate::check) fn wrong_until(agent: &str, found: Option<u32>, until: Option<u32>) -> String {
    match (found, until) {
        (Some(found), Some(until)) => {
            tr!(
                "The plan says that {agent} is gone from time {found} on, but it is removed at time {until}.",
                agent,
                found,
                until
            )
        }
        (Some(found), None) => {
            tr!(
                "The plan says that {agent} is gone from time {found} on, but it is not removed.",
                agent,
                found
            )
        }
        (None, Some(until)) => tr!(
            "{agent} is removed at time {until}, but the plan has no time for it in \"until\".",
            agent,
            until
        ),
        (None, None) => String::new(), // nothing differs
    }
}

pub(in crate::check) fn wrong_end(agent: &str, last: u32, until: u32) -> String {
    tr!(
        "The path of {agent} ends at time {last}, but it is removed at time {until}, so its last entry must be one step earlier.",
        agent,
        last,
        until
    )
}

pub(in crate::check) fn wrong_stand(agent: &str, last: u32, due: u32) -> String {
    tr!(
        "The path of {agent} ends at time {last}, but it has broken down for good and stands from time {due} on, so its last entry must be that.",
        agent,
        last,
        due
    )
}

pub(in crate::check) fn charge_repeated(agent: &str, time: u32) -> String {
    tr!(
        "The charges of {agent} list time {time} twice.",
        agent,
        time
    )
}

pub(in crate::check) fn charges_unsorted(agent: &str, before: u32, time: u32) -> String {
    tr!(
        "The charges of {agent} list time {time} after time {before}; they must be in ascending order.",
        agent,
        time,
        before
    )
}
