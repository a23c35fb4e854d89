//! What a file must keep beside the types of its values.

use giveway_model::{Instance, Plan, Scene, tr};

use super::bounds::{
    Faults, MAX_CELLS, MAX_EDITS, MAX_HINTS, MAX_LESSONS, MAX_MINUTES, MAX_PARAGRAPHS, MAX_STEPS,
    MAX_TERMS, MAX_TIME, MAX_TITLE,
};
use super::links::{Targets, is_on};
use super::tasks;
use crate::lesson::{Course, Glossary, Lesson, Picture, Step, Task};

pub(super) fn lesson(lesson: &Lesson, glossary: &Glossary, faults: &mut Faults) {
    faults.title("title", &lesson.title);
    faults.range("minutes", lesson.minutes, 1, MAX_MINUTES);
    let nowhere = Targets {
        glossary,
        scene: None,
        joining: Vec::new(),
    };
    nowhere.check("about", &lesson.about, faults);
    if lesson.steps.is_empty() {
        faults.add("steps", tr!("no steps"), tr!("at least one"));
    }
    faults.few(
        "steps",
        lesson.steps.len(),
        MAX_STEPS,
        tr!("counted" => "steps"),
    );
    if let Some(first) = lesson.steps.first()
        && first.scene.is_none()
    {
        faults.add(
            "steps[0]",
            tr!("no scene"),
            tr!("a scene in the first step"),
        );
    }
    for (index, step) in lesson.steps.iter().take(MAX_STEPS).enumerate() {
        let targets = Targets {
            glossary,
            scene: lesson.scene(index),
            joining: step.joining().map(|agent| agent.name.as_str()).collect(),
        };
        self::step(&format!("steps[{index}]"), step, &targets, faults);
    }
}

fn step(place: &str, step: &Step, targets: &Targets<'_>, faults: &mut Faults) {
    let at = |part: &str| format!("{place}.{part}");
    faults.title(&at("title"), &step.title);
    if step.text.is_empty() {
        faults.add(at("text"), tr!("no paragraphs"), tr!("at least one"));
    }
    faults.few(
        &at("text"),
        step.text.len(),
        MAX_PARAGRAPHS,
        tr!("counted" => "paragraphs"),
    );
    faults.few(
        &at("hints"),
        step.hints.len(),
        MAX_HINTS,
        tr!("counted" => "hints"),
    );
    faults.few(&at("tools"), step.tools.len(), 8, tr!("counted" => "tools"));
    for (index, text) in step.text.iter().enumerate() {
        targets.check(&format!("{place}.text[{index}]"), text, faults);
    }
    for (index, text) in step.hints.iter().enumerate() {
        targets.check(&format!("{place}.hints[{index}]"), text, faults);
    }
    if let Some(reason) = &step.reason {
        targets.check(&at("reason"), reason, faults);
    }
    if let Some(scene) = &step.scene {
        self::scene(&at("scene"), scene, faults);
    }
    if let Some(plan) = &step.plan {
        self::plan(&at("plan"), plan, targets, faults);
        if step.solved {
            faults.add(
                at("solved"),
                tr!("true beside a plan"),
                tr!("one of the two"),
            );
        }
    }
    faults.range(&at("time"), step.time, 0, MAX_TIME);
    if let Some(edits) = step.edits {
        faults.range(&at("edits"), edits, 1, MAX_EDITS);
    }
    let cells = step.cells.iter().flatten();
    faults.few(
        &at("cells"),
        cells.clone().count(),
        MAX_CELLS,
        tr!("counted" => "cells"),
    );
    for (index, cell) in cells.enumerate().take(MAX_CELLS) {
        if !targets.has_cell(*cell) {
            let found = tr!("the cell {cell}", cell);
            faults.add(
                format!("{place}.cells[{index}]"),
                found,
                tr!("a cell of the map"),
            );
        }
    }
    match &step.task {
        Some(task) => {
            if step.hints.is_empty() && !has_replies(task) {
                faults.add(at("hints"), tr!("no hints"), tr!("at least one"));
            }
            if step.reason.is_none() {
                faults.add(
                    place,
                    tr!("a task without \"reason\""),
                    tr!("why it is so, once solved"),
                );
            }
            tasks::check(place, step, task, targets, faults);
        }
        None if !step.hints.is_empty() || step.reason.is_some() => {
            faults.add(
                place,
                tr!("hints or a reason without a task"),
                tr!("a task"),
            );
        }
        None => {}
    }
}

/// Whether each answer says by itself what to think of.
const fn has_replies(task: &Task) -> bool {
    matches!(task, Task::Predict(_) | Task::Choose(_))
}

fn scene(place: &str, scene: &Scene, faults: &mut Faults) {
    if let Err(found) = Instance::new(scene.clone()) {
        for fault in found {
            faults.push(fault.of_part(place));
        }
    }
}

fn plan(place: &str, plan: &Plan, targets: &Targets<'_>, faults: &mut Faults) {
    for (name, path) in &plan.paths {
        if !targets.has_robot(name) {
            let found = tr!("the robot {name}", name = format!("{name:?}"));
            faults.add(format!("{place}.paths"), found, tr!("a robot of the scene"));
        }
        let most = MAX_TIME as usize;
        faults.few(
            &format!("{place}.paths"),
            path.len(),
            most,
            tr!("counted" => "cells"),
        );
    }
}

pub(super) fn course(course: &Course, faults: &mut Faults) {
    faults.title("title", &course.title);
    faults.few(
        "chapters",
        course.lessons().count(),
        MAX_LESSONS,
        tr!("counted" => "lessons"),
    );
    let mut seen = Vec::new();
    for (c, chapter) in course.chapters.iter().enumerate() {
        faults.title(&format!("chapters[{c}].title"), &chapter.title);
        for (l, entry) in chapter.lessons.iter().take(MAX_LESSONS).enumerate() {
            let place = format!("chapters[{c}].lessons[{l}]");
            faults.title(&format!("{place}.title"), &entry.title);
            faults.range(&format!("{place}.minutes"), entry.minutes, 1, MAX_MINUTES);
            let most = MAX_STEPS as u32;
            faults.range(&format!("{place}.steps"), entry.steps, 1, most);
            if seen.contains(&&entry.lesson) {
                let found = tr!("\"{name}\" twice", name = entry.lesson);
                faults.add(format!("{place}.lesson"), found, tr!("each lesson once"));
            }
            seen.push(&entry.lesson);
            picture(&format!("{place}.picture"), &entry.picture, faults);
        }
    }
}

pub(super) fn glossary(glossary: &Glossary, faults: &mut Faults) {
    faults.few(
        "terms",
        glossary.terms.len(),
        MAX_TERMS,
        tr!("counted" => "terms"),
    );
    let mut seen = Vec::new();
    for (index, term) in glossary.terms.iter().take(MAX_TERMS).enumerate() {
        let place = format!("terms[{index}]");
        faults.title(&format!("{place}.name"), &term.name);
        if seen.contains(&&term.term) {
            let found = tr!("\"{name}\" twice", name = term.term);
            faults.add(format!("{place}.term"), found, tr!("each term once"));
        }
        seen.push(&term.term);
        for (other, words) in term.also.iter().enumerate() {
            faults.title(&format!("{place}.also[{other}]"), words);
        }
        let targets = Targets {
            glossary,
            scene: term.picture.as_ref().map(|picture| &picture.scene),
            joining: Vec::new(),
        };
        targets.check(&format!("{place}.text"), &term.text, faults);
        if let Some(picture) = &term.picture {
            self::picture(&format!("{place}.picture"), picture, faults);
        }
        if let Some(source) = &term.source {
            let most = 4 * MAX_TITLE;
            let length = source
                .title
                .chars()
                .count()
                .max(source.authors.chars().count());
            faults.few(
                &format!("{place}.source"),
                length,
                most,
                tr!("counted" => "characters"),
            );
        }
    }
}

fn picture(place: &str, picture: &Picture, faults: &mut Faults) {
    scene(&format!("{place}.scene"), &picture.scene, faults);
    faults.range(&format!("{place}.time"), picture.time, 0, MAX_TIME);
    let cells = picture.plan.iter().flat_map(|plan| plan.paths.values());
    for cell in cells.flatten().flatten() {
        if !is_on(&picture.scene, *cell) {
            let found = tr!("the cell {cell}", cell);
            faults.add(format!("{place}.plan"), found, tr!("a cell of the map"));
        }
    }
}
