//! What each robot does, in a row.

use giveway_model::Cell;

use super::subject::Robot;
use super::{Known, RobotRow, Subject, batteries};
use crate::form;

/// The robots, in the order of the scene.
pub(super) fn rows(subject: &Subject<'_>, known: &Known) -> Vec<RobotRow> {
    let names = subject.robots.iter();
    let names: Vec<&str> = names.map(|robot| robot.agent.name.as_str()).collect();
    let numbers = form::numbers(&names);
    let robots = subject.robots.iter().zip(numbers);
    robots
        .map(|(robot, number)| row(subject, known, robot, number))
        .collect()
}

fn row(subject: &Subject<'_>, known: &Known, robot: &Robot, number: String) -> RobotRow {
    let way = subject.way(robot);
    let waits = way
        .windows(2)
        .filter(|pair| matches!(pair, [(_, from), (_, to)] if from == to))
        .count();
    let visit = |&cell: &Cell| {
        let first = way.iter().find(|&&(_, at)| at == cell);
        (cell, first.map(|&(time, _)| time))
    };
    let mut waypoints: Vec<_> = robot.agent.waypoints.iter().map(visit).collect();
    giveway_model::sorting::sort_by_key(&mut waypoints, |&(_, time)| time.unwrap_or(u32::MAX));
    let mut delays = known.delays.iter();
    let alone = delays.find(|delay| delay.robot == robot.agent.name);
    RobotRow {
        name: robot.agent.name.clone(),
        number,
        start: robot.agent.start,
        begins: subject.begins(robot),
        waypoints,
        goal: robot.agent.goal,
        arrives: robot.arrives,
        removed: robot.removed,
        waits: u32::try_from(waits).unwrap_or(u32::MAX),
        charges: charges(subject, robot, &way),
        lowest: robot.levels.iter().min().copied(),
        battery: batteries::row(subject, robot),
        alone: alone.cloned(),
    }
}

/// Where and when a robot charges.
fn charges(subject: &Subject<'_>, robot: &Robot, way: &[(u32, Cell)]) -> Vec<(Cell, u32)> {
    let times = subject.plan.charges(&robot.agent.name).iter();
    let at = |&time: &u32| {
        let mut stops = way.iter();
        let stop = stops.find(|&&(stop, _)| stop == time);
        stop.map(|&(_, cell)| (cell, time))
    };
    times.filter_map(at).collect()
}
