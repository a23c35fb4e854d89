//! An answer in words, as a table or a list shows it.

use giveway_model::words::and;
use giveway_model::{Agent, Cell, Ground, Scene, tr};

use super::{Answer, Edits};
use crate::judge::Mark;
use crate::lesson::{Lesson, Task, Value};

/// An answer to the task of a step, from 0, in a few plain words: what was said or picked,
/// in the lesson's own words where it has some, or what was done on the board.
pub fn answer_words(answer: &Answer, step: usize, lesson: &Lesson) -> String {
    let task = lesson.steps.get(step).and_then(|step| step.task.as_ref());
    match answer {
        Answer::Value { value } => said(value, task),
        Answer::Shown {} => tr!("asked for the answer").to_owned(),
        Answer::Marks { marks } if marks.is_empty() => tr!("no conflict marked").to_owned(),
        Answer::Marks { marks } => listed(marks.iter().map(mark)),
        Answer::Choice { choice } => picked(*choice, task),
        Answer::Order { order } => order.join(", "),
        Answer::NoOrder {} => tr!("no order works").to_owned(),
        Answer::Method { method } => method.to_string(),
        Answer::Edits(edits) => edited(edits, lesson.scene(step)),
        Answer::Paths { paths, .. } => listed(paths.iter().map(|(name, path)| {
            let steps = path.len().saturating_sub(1);
            let end = path.iter().rev().flatten().next();
            let place = end.map_or_else(String::new, Cell::to_string);
            tr!(
                "{robot} in {n} step to {place}" | "{robot} in {n} steps to {place}" % steps,
                robot = name,
                place
            )
        })),
    }
}

fn listed(parts: impl Iterator<Item = String>) -> String {
    parts.collect::<Vec<_>>().join("; ")
}

fn said(value: &Value, task: Option<&Task>) -> String {
    let words = match task {
        Some(Task::Predict(task)) => {
            let mut answers = task.answers.iter();
            answers.find(|guess| guess.value == *value)
        }
        _ => None,
    };
    match words {
        Some(guess) => guess.text.plain(),
        None => value.to_string(),
    }
}

fn picked(choice: usize, task: Option<&Task>) -> String {
    let answer = match task {
        Some(Task::Choose(task)) => task.answers.get(choice),
        _ => None,
    };
    let number = || tr!("answer {number}", number = choice + 1);
    answer.map_or_else(number, |answer| answer.text.plain())
}

fn mark(mark: &Mark) -> String {
    let robots = and(&mark.robots);
    tr!("{robots} at time {time}", robots, time = mark.time)
}

fn edited(edits: &Edits, scene: Option<&Scene>) -> String {
    let cells = edits.cells.iter().map(|edit| {
        let cell = edit.cell;
        match edit.ground {
            Ground::Free => tr!("{cell} free", cell),
            Ground::Obstacle => tr!("{cell} an obstacle", cell),
            Ground::Slow => tr!("{cell} slow", cell),
            Ground::Charger => tr!("{cell} a charger", cell),
            Ground::SlowCharger => tr!("{cell} a charger in the slow zone", cell),
        }
    });
    let gone = edits
        .gone
        .iter()
        .map(|name| tr!("{robot} removed", robot = name));
    let was = |name: &str| -> Option<&Agent> {
        let mut agents = scene?.agents.iter();
        agents.find(|agent| agent.name == name)
    };
    let robots = edits.robots.iter().map(|agent| {
        let (robot, start) = (&agent.name, agent.start);
        let goal = agent
            .goal
            .map_or_else(|| "-".to_owned(), |goal| goal.to_string());
        let is_new = was(robot).is_none();
        if is_new {
            tr!("{robot} new at {start}, goal {goal}", robot, start, goal)
        } else {
            tr!("{robot} at {start}, goal {goal}", robot, start, goal)
        }
    });
    listed(cells.chain(gone).chain(robots))
}
