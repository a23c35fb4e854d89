//! What pointing at the board does for a task: a value that is said, a conflict that is
//! marked.

use giveway_model::{Cell, Plan, tr};

use super::Open;
use crate::judge::{Did, Mark, Why, is_same_conflict};
use crate::lesson::quantity::ValueKind;
use crate::lesson::task::Predict;
use crate::lesson::{Task, Value};
use crate::port::Pick;

/// What pointing at something does.
pub(super) enum Pointed {
    /// It is something for the task.
    Did(Did),
    /// It is a part of something: the exercise says what else is needed.
    Part,
    /// It does nothing, and this says why.
    Nothing(String),
}

/// What pointing at something does for the task.
pub(super) fn picked(open: &mut Open, pick: Pick) -> Pointed {
    let task = open.step().and_then(|step| step.task.as_ref());
    match task {
        Some(Task::Predict(task)) => predicted(task, &pick),
        Some(Task::Spot(_)) => marked(open, pick),
        _ => Pointed::Part,
    }
}

fn predicted(task: &Predict, pick: &Pick) -> Pointed {
    let value = match (task.what.kind(), pick.robots.first()) {
        (ValueKind::Cell, _) => Value::Cell(pick.cell),
        (ValueKind::Robot, Some(name)) => Value::Robot(name.clone()),
        (ValueKind::Robot, None) => return Pointed::Nothing(nobody(pick)),
        (ValueKind::Number | ValueKind::Rule, _) => return Pointed::Part,
    };
    let is_listed = task.answers.iter().any(|guess| guess.value == value);
    if task.answers.is_empty() || is_listed {
        return Pointed::Did(Did::Guessed(value));
    }
    let what = match value {
        Value::Robot(name) => name,
        Value::Number(_) | Value::Cell(_) | Value::Rule { .. } => pick.cell.to_string(),
    };
    Pointed::Nothing(tr!("{what} is not one of the answers.", what))
}

/// A robot was to be clicked, and there is none.
fn nobody(pick: &Pick) -> String {
    let (cell, time) = (pick.cell, pick.time);
    tr!("No robot is at {cell} at time {time}.", cell, time)
}

/// Where two robots share the second cell, the one of them is meant that changes places
/// with the robot of the first.
fn swapping(plan: &Plan, before: &Pick, mut pick: Pick) -> Pick {
    let [first] = before.robots.as_slice() else {
        return pick;
    };
    let is_at = |name: &str, time: u32, cell: Cell| {
        let path = plan.path(name);
        let stands = path.get(time as usize).or(path.last());
        stands.copied().flatten() == Some(cell)
    };
    let swaps = |name: &&String| {
        let times = [pick.time.checked_add(1), pick.time.checked_sub(1)];
        let mut times = times.into_iter().flatten();
        times.any(|time| is_at(name, time, before.cell) && is_at(first, time, pick.cell))
    };
    let meant: Vec<String> = pick.robots.iter().filter(swaps).cloned().collect();
    if before.cell != pick.cell && meant.len() == 1 {
        pick.robots = meant;
    }
    pick
}

/// Two robots at one time make a mark: both at once, or one after the other.
fn marked(open: &mut Open, pick: Pick) -> Pointed {
    if pick.robots.is_empty() {
        return Pointed::Nothing(nobody(&pick));
    }
    let mut marks = match &open.did {
        Did::Marked(marks) => marks.clone(),
        _ => Vec::new(),
    };
    let before = open
        .pointed
        .take()
        .filter(|before| before.time == pick.time);
    let plan = open.step().and_then(|step| step.plan.as_ref());
    let pick = match (&before, plan) {
        (Some(before), Some(plan)) => swapping(plan, before, pick),
        _ => pick,
    };
    let mut mark = Mark {
        time: pick.time,
        robots: Vec::new(),
        cells: Vec::new(),
    };
    for part in before.iter().chain([&pick]) {
        for name in &part.robots {
            if !mark.robots.contains(name) {
                mark.robots.push(name.clone());
            }
        }
        if !part.robots.is_empty() && !mark.cells.contains(&part.cell) {
            mark.cells.push(part.cell);
        }
    }
    if mark.robots.len() < 2 {
        let is_again = before.is_some_and(|before| before.robots == pick.robots);
        let again = pick.robots.first().filter(|_| is_again);
        let said = again.map(|name| {
            tr!(
                "Now click the robot that {name} gets into conflict with.",
                name
            )
        });
        open.pointed = Some(pick);
        return said.map_or(Pointed::Part, Pointed::Nothing);
    }
    // A mark that is of no conflict does not stay beside the next one.
    let verdict = open.judge.verdict();
    let is_wrong = verdict.is_some_and(|verdict| matches!(verdict.why, Why::NoConflict(_)));
    if is_wrong {
        marks.pop();
    }
    let is_same = |other: &Mark| {
        let situation = open.situation();
        *other == mark || situation.is_some_and(|now| is_same_conflict(now, other, &mark))
    };
    if marks.iter().any(is_same) {
        // (Where all of them are marked, it is solved, now as before.)
        if is_wrong || open.is_solved() {
            return Pointed::Did(Did::Marked(marks));
        }
        return Pointed::Nothing(tr!("You have marked this conflict already.").to_owned());
    }
    marks.push(mark);
    Pointed::Did(Did::Marked(marks))
}
