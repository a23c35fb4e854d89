//! Who arrives last, and why: its way alone, and whom it waits for.

use giveway_model::words::and;
use giveway_model::{Cell, sorting, tr};

use super::subject::Robot;
use super::{Known, RobotRow, Subject};

/// At most so many robots are told of that arrive last.
const MOST_ROBOTS: usize = 3;
/// At most so many waits of a robot are told.
const MOST_WAITS: usize = 4;

/// Who is last and why, a sentence each.
pub(super) fn told(subject: &Subject<'_>, rows: &[RobotRow], known: &Known) -> Vec<String> {
    let Some(time) = rows.iter().filter_map(|row| row.arrives).max() else {
        return Vec::new();
    };
    let all = subject.robots.iter().zip(rows);
    let last: Vec<_> = all.filter(|(_, row)| row.arrives == Some(time)).collect();
    let mut names: Vec<String> = last.iter().map(|(_, row)| row.name.clone()).collect();
    let more = names.len().saturating_sub(MOST_ROBOTS);
    if more > 0 {
        names.truncate(MOST_ROBOTS);
        names.push(tr!("robots" => "{n} other" | "{n} others" % more));
    }
    let mut told = vec![tr!(
        "{names} arrives last, at {time}." | "{names} arrive last, at {time}." % last.len(),
        names = and(&names),
        time
    )];
    for (robot, row) in last.into_iter().take(MOST_ROBOTS) {
        told.extend(alone(row, known));
        told.extend(charges(subject, robot));
        told.extend(waits(subject, robot));
    }
    told
}

/// What the robot would do alone, and whom it lets pass.
fn alone(row: &RobotRow, known: &Known) -> Vec<String> {
    let name = &row.name;
    let mut delays = known.delays.iter();
    match delays.find(|delay| delay.robot == *name) {
        None => Vec::new(),
        Some(lone) if lone.delay == 0 => vec![tr!(
            "Alone, {name} would arrive at {alone}, too: no other robot makes it late.",
            name,
            alone = lone.alone
        )],
        Some(lone) => vec![
            tr!(
                "Alone, {name} would arrive at {alone}.",
                name,
                alone = lone.alone
            ),
            lone.why.clone(),
        ],
    }
}

/// Where the robot charges without a stay.
fn charges(subject: &Subject<'_>, robot: &Robot) -> Vec<String> {
    let name = &robot.agent.name;
    let way = subject.way(robot);
    let stays = stays(&way);
    let times = subject.plan.charges(name).iter();
    let passing = times.filter(|&&time| !stays.iter().any(|it| (it.from..it.to).contains(&time)));
    let told = passing.filter_map(|&time| {
        let (_, cell) = way.iter().find(|(at, _)| *at == time)?;
        Some(tr!(
            "{name} charges as it passes {cell}, at {time}.",
            name,
            cell,
            time
        ))
    });
    told.collect()
}

/// A time that a robot stays in a cell on its way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Stay {
    cell: Cell,
    from: u32,
    to: u32,
    /// Where it goes then.
    next: Option<Cell>,
}

/// Where the robot waits, and for whom: the longest waits, by time.
fn waits(subject: &Subject<'_>, robot: &Robot) -> Vec<String> {
    let name = &robot.agent.name;
    let mut stays = stays(&subject.way(robot));
    if stays.is_empty() {
        return vec![tr!("{name} never waits on its way.", name)];
    }
    let more = stays.len().saturating_sub(MOST_WAITS);
    sorting::sort_by_key(&mut stays, |stay| std::cmp::Reverse(stay.to - stay.from));
    stays.truncate(MOST_WAITS);
    sorting::sort_by_key(&mut stays, |stay| stay.from);
    let mut told: Vec<String> = stays
        .iter()
        .map(|stay| sentence(subject, robot, stay))
        .collect();
    if more > 0 {
        told.push(tr!(
            "{name} waits {n} more time, no longer than these."
                | "{name} waits {n} more times, no longer than these." % more,
            name
        ));
    }
    told
}

fn stays(way: &[(u32, Cell)]) -> Vec<Stay> {
    let mut stays: Vec<Stay> = Vec::new();
    for group in way.chunk_by(|(_, one), (_, other)| one == other) {
        if let (Some(before), Some(&(_, cell))) = (stays.last_mut(), group.first()) {
            before.next = before.next.or(Some(cell));
        }
        if let [(from, cell), .., (to, _)] = *group {
            stays.push(Stay {
                cell,
                from,
                to,
                next: None,
            });
        }
    }
    stays
}

fn sentence(subject: &Subject<'_>, robot: &Robot, stay: &Stay) -> String {
    let Stay { cell, from, to, .. } = *stay;
    let name = &robot.agent.name;
    let mut held = robot.held.iter();
    if held.any(|&(begin, end)| begin < to && from < end) {
        return tr!(
            "{name} is broken down at {cell} between {from} and {to}.",
            name,
            cell,
            from,
            to
        );
    }
    let mut charges = subject.plan.charges(name).iter();
    if charges.any(|time| (from..to).contains(time)) {
        return tr!(
            "{name} charges at {cell} between {from} and {to}.",
            name,
            cell,
            from,
            to
        );
    }
    let there = who_is_ahead(subject, robot, stay);
    let n = to - from;
    match stay.next.filter(|_| !there.is_empty()) {
        Some(next) => tr!(
            "{name} waits {n} step at {cell} from {from} on, for {others} to pass {next}."
                | "{name} waits {n} steps at {cell} from {from} on, for {others} to pass {next}."
                    % n,
            name,
            cell,
            from,
            others = and(&there),
            next
        ),
        None => tr!(
            "{name} waits {n} step at {cell} from {from} on."
                | "{name} waits {n} steps at {cell} from {from} on." % n,
            name,
            cell,
            from
        ),
    }
}

/// The robots in the next cell while this one waits.
fn who_is_ahead<'a>(subject: &'a Subject<'_>, robot: &Robot, stay: &Stay) -> Vec<&'a str> {
    let others = subject.robots.iter();
    let others = others.filter(|other| other.agent.name != robot.agent.name);
    let is_ahead = |other: &&Robot| {
        let mut stops = subject.stops(other);
        stops.any(|(time, cell)| {
            Some(cell) == stay.next
                && (stay.from + 1..=stay.to).contains(&time)
                && other.removed.is_none_or(|end| time < end)
        })
    };
    others
        .filter(is_ahead)
        .map(|it| it.agent.name.as_str())
        .collect()
}
