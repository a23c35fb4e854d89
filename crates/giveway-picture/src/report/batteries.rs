//! The battery of a robot on its way: the least level, and what is left at the goal.

use giveway_model::tr;

use super::subject::Robot;
use super::{BatteryRow, Subject};

/// How batteries are told; `None` where no robot has one.
pub(super) fn rule(subject: &Subject<'_>) -> Option<String> {
    let mut robots = subject.robots.iter();
    robots.find(|robot| robot.agent.battery.is_some())?;
    Some(match subject.instance.rules().battery_floor {
        0 => tr!(
            "A battery loses 1 with each step until its robot arrives. A charge takes no time of its own: at the next step the battery is full."
        )
        .to_owned(),
        floor => tr!(
            "A battery loses 1 with each step until its robot arrives, and may not fall below {floor}. A charge takes no time of its own: at the next step the battery is full.",
            floor
        ),
    })
}

/// The battery of a robot; `None` without one.
pub(super) fn row(subject: &Subject<'_>, robot: &Robot) -> Option<BatteryRow> {
    let battery = robot.agent.battery?;
    let begins = subject.begins(robot);
    let end = robot.arrives.or(robot.removed);
    let steps = end.map_or(usize::MAX, |end| end.saturating_sub(begins) as usize);
    let on_way = || robot.levels.iter().copied().take(steps.saturating_add(1));
    let least = on_way().min()?;
    let time = on_way().zip(begins..).find(|&(level, _)| level == least)?.1;
    // In transit it is on its way from the last cell.
    let stops = subject.way(robot).into_iter();
    let at = stops.take_while(|&(stop, _)| stop <= time).last();
    Some(BatteryRow {
        capacity: battery.capacity,
        initial: battery.initial,
        least,
        least_at: at.map(|(_, cell)| (cell, time)),
        at_goal: robot.arrives.and_then(|_| on_way().next_back()),
    })
}
