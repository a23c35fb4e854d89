//! Which errands each robot has done: they are what it visits.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Display;

use super::fields::{Event, Fields, Part};
use crate::{Pair, WrittenAt, WrittenCell};
use giveway_model::{Fault, tr};

/// The cells of the errands that each robot has done, by the numbers of their tasks.
pub(super) fn done(fields: &Fields<'_>) -> Result<Vec<Vec<WrittenCell>>, Fault> {
    let tasks = tasks(&fields.tasks)?;
    let robots = fields.start.len();
    let mut done: Vec<BTreeSet<(i64, usize)>> = vec![BTreeSet::new(); robots];
    for (i, event) in fields.events.iter().enumerate() {
        if let &[
            Event::Number(_),
            Event::Number(robot),
            Event::Number(task),
            Event::Number(so_far),
        ] = event.as_slice()
        {
            let own = usize::try_from(robot).ok().and_then(|it| done.get_mut(it));
            let own = own.ok_or_else(|| no_robot(format!("events[{i}][1]"), robot, robots))?;
            if let Some(errand) = usize::try_from(so_far)
                .ok()
                .and_then(|it| it.checked_sub(1))
            {
                own.insert((task, errand));
            }
            continue;
        }
        for event in event {
            match event {
                Event::OfTask(task, what) => {
                    let own = done.get_mut(i);
                    let own = own.ok_or_else(|| no_robot(format!("events[{i}]"), i, robots))?;
                    if what == "finished" {
                        own.insert((*task, 0));
                    }
                }
                Event::Number(_) => {
                    let found = tr!("an event of other than four numbers");
                    let expected = tr!("[time, robot, task, errands done]");
                    return Err(Fault::at(format!("events[{i}]"), found, expected));
                }
            }
        }
    }
    let cells = |own: BTreeSet<(i64, usize)>| {
        let cell = |(task, errand)| tasks.get(&task).and_then(|it| it.get(errand)).copied();
        own.into_iter().filter_map(cell).collect()
    };
    Ok(done.into_iter().map(cells).collect())
}

fn no_robot(place: String, robot: impl Display, robots: usize) -> Fault {
    let expected = tr!("one of the {robots} robots, from 0", robots);
    Fault::at(place, tr!("robot {robot}", robot), expected)
}

/// The errands of each task.
fn tasks(written: &[Vec<Part>]) -> Result<BTreeMap<i64, Vec<WrittenCell>>, Fault> {
    let mut tasks = BTreeMap::new();
    for (i, task) in written.iter().enumerate() {
        let (id, errands) = match task.as_slice() {
            &[Part::Number(id), Part::Number(row), Part::Number(column)] => {
                let side = |number| i32::try_from(number).ok();
                (id, side(row).zip(side(column)).map(|cell| vec![cell]))
            }
            [Part::Number(id), Part::Number(_), Part::Errands(numbers)]
                if numbers.len().is_multiple_of(2) =>
            {
                let (pairs, _) = numbers.as_chunks::<2>();
                let cells = pairs.iter().map(|&[row, column]| (row, column)).collect();
                (*id, Some(cells))
            }
            _ => (0, None),
        };
        let Some(errands) = errands else {
            let expected = tr!("[id, row, column] or [id, release, [row, column, ..]]");
            let found = tr!("a task written in another way");
            return Err(Fault::at(format!("tasks[{i}]"), found, expected));
        };
        let cells = errands.into_iter().map(|(row, column)| WrittenCell {
            pair: Pair::new(row, column),
            at: WrittenAt::Entry("tasks", i),
        });
        tasks.insert(id, cells.collect());
    }
    Ok(tasks)
}
