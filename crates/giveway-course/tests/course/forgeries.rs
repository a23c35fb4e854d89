//! Hand-ins that were tampered with: none counts as solved unless its answer truly is.

use std::collections::BTreeMap;

use fastrand::Rng;
use giveway_course::grade::{Claim, Class};
use giveway_course::handin::{Answer, Work, write};
use giveway_course::judge::Did;
use giveway_course::lesson::{Lesson, Task};
use giveway_model::{Cell, Grid, Plan, Scene};
use serde_json::{Value as Json, json};

use super::grading::{course, judge};
use super::handins::{handed, work};
use super::shipped;
use super::tasks::{answers, judged};

const FORGERIES: usize = 400;

/// Lessons whose boards are small, with each kind of task among them.
const LESSONS: [&str; 9] = [
    "room-to-pass",
    "two-robots-one-cell",
    "all-move-on-at-once",
    "batteries",
    "one-after-the-other",
    "what-would-help",
    "when-the-world-changes",
    "last-home-or-all-together",
    "no-plan-is-better",
];

/// A hand-in of random answers, right and wrong, as JSON; all claimed to be solved.
fn honest(name: &str, lesson: &Lesson, who: &str, rng: &mut Rng) -> Json {
    let mut works: BTreeMap<usize, Work> = BTreeMap::new();
    let mut answers = answers(name, lesson);
    rng.shuffle(&mut answers);
    for answered in &answers {
        works.insert(answered.step, work(lesson, answered, true));
    }
    let made = handed(name, lesson, who, works.into_values().collect());
    let text = write(&made);
    serde_json::from_str(&text).unwrap_or_else(|_| serde_json::to_value(&made).unwrap())
}

fn number(json: &mut Json, rng: &mut Rng) {
    match json {
        Json::Number(_) => *json = json!(rng.u32(0..12)),
        Json::Array(list) if !list.is_empty() => {
            let place = rng.usize(0..list.len());
            number(&mut list[place], rng);
        }
        Json::Object(map) if !map.is_empty() => {
            let place = rng.usize(0..map.len());
            number(map.values_mut().nth(place).unwrap(), rng);
        }
        _ => {}
    }
}

/// Everybody jumps to where they have to be.
fn jump(answer: &mut Json, scene: &Scene) {
    if let Some(paths) = answer["paths"].as_object_mut() {
        for (name, path) in paths {
            let agent = scene.agents.iter().find(|agent| agent.name == *name);
            if let Some(goal) = agent.and_then(|agent| agent.goal) {
                let first = path[0].clone();
                *path = json!([first, [goal.x, goal.y]]);
            }
        }
    }
}

/// Tampers with a hand-in.
fn forge(json: &mut Json, lesson: &Lesson, rng: &mut Rng) {
    let count = json["tasks"].as_array().unwrap().len();
    let place = rng.usize(0..count);
    let step = json["tasks"][place]["step"].as_u64().unwrap() as usize - 1;
    let scene = lesson.scene(step).unwrap();
    let robot = rng.choice(&scene.agents).unwrap();
    let (width, height) = (scene.map[0].len() as u32, scene.map.len() as u32);
    let cell = (rng.u32(0..width), rng.u32(0..height));
    let ground = *rng.choice(&["#", ".", "+", "~"]).unwrap();
    let other = *rng.choice(&["C", "D", "B1"]).unwrap();
    let task = &mut json["tasks"][place];
    match rng.u8(0..18) {
        0 => number(&mut task["answer"], rng),
        1 => jump(&mut task["answer"], scene),
        2 => task["answer"] = json!({ "is": "value", "value": rng.u32(0..30) }),
        3 => task["answer"] = json!({ "is": "choice", "choice": rng.u32(1..5) }),
        4 => task["answer"] = json!({ "is": "no-order" }),
        5 => task["step"] = json!(rng.u32(1..31)),
        6 => {
            let edits = json!({ "cells": [[cell.0, cell.1, ground]] });
            task["board"] = edits;
        }
        7 => {
            task["answer"] = json!({ "is": "edits", "cells": [[cell.0, cell.1, ground]] });
        }
        8 => {
            task["answer"] = json!({ "is": "edits", "gone": [robot.name] });
        }
        9 => {
            let mut robot = serde_json::to_value(robot).unwrap();
            robot["goal"] = robot["start"].clone();
            let key = if rng.bool() { "answer" } else { "board" };
            task[key] = json!({ "robots": [robot] });
            if key == "answer" {
                task[key]["is"] = json!("edits");
            }
        }
        10 => {
            let mut robot = serde_json::to_value(robot).unwrap();
            robot["battery"] = json!({ "capacity": 99, "initial": 99 });
            task["answer"] =
                json!({ "is": "edits", "robots": [robot], "cells": [[cell.0, cell.1, ground]] });
        }
        11 => {
            let robot =
                json!({ "name": other, "start": [cell.0, cell.1], "goal": [cell.0, cell.1] });
            task["answer"] = json!({ "is": "edits", "robots": [robot] });
        }
        12 => {
            let here = [robot.start.x, robot.start.y];
            task["answer"]["paths"][&robot.name] = json!([here, here]);
        }
        13 => task["answer"] = json!({ "is": "marks", "marks": [] }),
        14 => {
            let twice = task.clone();
            json["tasks"].as_array_mut().unwrap().push(twice);
        }
        15 => json["hand-in"]["sum"] = json!(format!("{:016x}", rng.u64(..))),
        16 => json["hand-in"]["lesson"] = json!("batteries"),
        _ => {
            let key = *rng.choice(&["scene", "plan", "lesson", "verdict"]).unwrap();
            json["tasks"][place][key] = serde_json::to_value(scene).unwrap();
        }
    }
}

/// The scene of the lesson with the edits of an answer, by this test alone; `None` where
/// they do not fit.
fn edited(lesson: &Lesson, work: &Work) -> Option<Scene> {
    let mut scene = lesson.scene(work.step)?.clone();
    let Some(Answer::Edits(edits)) = &work.answer else {
        return Some(scene);
    };
    for edit in &edits.cells {
        let row = scene.map.get_mut(edit.cell.y as usize)?;
        let mut cells: Vec<char> = row.chars().collect();
        *cells.get_mut(edit.cell.x as usize)? = edit.ground.to_char();
        *row = cells.into_iter().collect();
    }
    scene
        .agents
        .retain(|agent| !edits.gone.contains(&agent.name));
    for robot in &edits.robots {
        match scene
            .agents
            .iter_mut()
            .find(|agent| agent.name == robot.name)
        {
            Some(agent) => *agent = robot.clone(),
            None => scene.agents.push(robot.clone()),
        }
    }
    let grid = Grid::from_rows(&scene.map).ok()?;
    let is_on = |cell: Cell| grid.ground(cell).is_some();
    edits
        .cells
        .iter()
        .all(|edit| is_on(edit.cell))
        .then_some(scene)
}

/// Whether an answer is right, by the judge of the lesson and this test's own way to it.
fn is_right(lesson: &Lesson, work: &Work) -> bool {
    let step = lesson.steps.get(work.step);
    let (Some(task), Some(scene)) = (step.and_then(|it| it.task.as_ref()), edited(lesson, work))
    else {
        return false;
    };
    // No step of the course goes on with a board that the steps before can edit.
    let board = Work {
        answer: Some(Answer::Edits(work.board.clone())),
        ..work.clone()
    };
    if edited(lesson, &board).as_ref() != lesson.scene(work.step) {
        return false;
    }
    let did = match (task, work.answer.clone()) {
        (Task::Paint(_), Some(Answer::Edits(_))) => Did::Edits,
        (Task::Predict(_), Some(Answer::Value { value })) => Did::Guessed(value),
        (Task::Spot(_), Some(Answer::Marks { marks })) => Did::Marked(marks),
        (Task::Choose(_), Some(Answer::Choice { choice })) => Did::Chose(choice),
        (Task::Order(_), Some(Answer::Order { order })) => Did::Ordered(order),
        (Task::Order(_), Some(Answer::NoOrder {})) => Did::NoOrder,
        (Task::Change(_), Some(Answer::Method { method })) => Did::Went(method),
        (Task::Lead(lead), Some(Answer::Paths { paths, charges })) => {
            if paths.keys().any(|name| !lead.robots.contains(name)) {
                return false;
            }
            let mut plan = step.and_then(|it| it.plan.clone()).unwrap_or_default();
            for agent in &scene.agents {
                let stands = || vec![Some(agent.start)];
                plan.paths.entry(agent.name.clone()).or_insert_with(stands);
            }
            plan.paths.extend(paths);
            plan.charges.extend(charges);
            Did::Led(Plan { ..plan })
        }
        _ => return false,
    };
    judged(lesson, work.step, &scene, &did).is_solved()
}

#[test]
fn no_forgery_counts_as_solved() {
    let mut rng = Rng::with_seed(400);
    let mut class = Class::new(course());
    let lessons: Vec<(&str, Lesson)> = LESSONS.map(|name| (name, shipped::lesson(name))).into();
    let mut of = Vec::new();
    for number in 0..FORGERIES {
        let place = rng.usize(0..lessons.len());
        let (name, lesson) = &lessons[place];
        let mut json = honest(name, lesson, &format!("Forger {number}"), &mut rng);
        for _ in 0..rng.usize(1..3) {
            forge(&mut json, lesson, &mut rng);
        }
        class.add(&number.to_string(), None, &json.to_string());
        of.push(place);
    }
    judge(&mut class);
    let (mut solved, mut refused, mut lies) = (0, 0, 0);
    for (file, place) in class.files().iter().zip(&of) {
        let (name, lesson) = &lessons[*place];
        if file.unread().is_some() {
            refused += 1;
        }
        for task in file.tasks() {
            lies += usize::from(task.claim() == Claim::False);
            if task.is_solved() {
                let work = task.work.as_ref().unwrap();
                assert!(is_right(lesson, work), "{name}, {}: {work:?}", file.file);
                solved += 1;
            }
        }
    }
    assert!(
        refused > 50 && lies > 200 && solved > 50,
        "{refused} {lies} {solved}"
    );
}
