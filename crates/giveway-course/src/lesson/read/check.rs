//! What a file must keep beside the types of its values.

use giveway_model::{Instance, Plan, Scene};

use super::bounds::{
    Faults, MAX_CELLS, MAX_EDITS, MAX_HINTS, MAX_LESSONS, MAX_MINUTES, MAX_PARAGRAPHS, MAX_STEPS,
    MAX_TERMS, MAX_TIME, MAX_TITLE,
};
use super::links::{Targets, is_on};
use super::{Flaw, Things, tasks};
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
        faults.add("steps", Flaw::NoSteps);
    }
    faults.few("steps", lesson.steps.len(), MAX_STEPS, Things::Steps);
    for (index, step) in lesson.steps.iter().take(MAX_STEPS).enumerate() {
        let targets = Targets {
            glossary,
            scene: lesson.scene(index),
            joining: step.joining().map(|agent| agent.name.as_str()).collect(),
        };
        faults.step = Some(index);
        if index == 0 && step.scene.is_none() {
            faults.add("scene", Flaw::NoScene);
        }
        self::step(step, &targets, faults);
    }
    faults.step = None;
}

fn step(step: &Step, targets: &Targets<'_>, faults: &mut Faults) {
    faults.title("title", &step.title);
    if step.text.is_empty() {
        faults.add("text", Flaw::NoParagraphs);
    }
    faults.few("text", step.text.len(), MAX_PARAGRAPHS, Things::Paragraphs);
    faults.few("hints", step.hints.len(), MAX_HINTS, Things::Hints);
    faults.few("tools", step.tools.len(), 8, Things::Tools);
    for (index, text) in step.text.iter().enumerate() {
        targets.check(&format!("text[{index}]"), text, faults);
    }
    for (index, text) in step.hints.iter().enumerate() {
        targets.check(&format!("hints[{index}]"), text, faults);
    }
    if let Some(reason) = &step.reason {
        targets.check("reason", reason, faults);
    }
    if let Some(scene) = &step.scene {
        self::scene("scene", scene, faults);
    }
    if let Some(plan) = &step.plan {
        self::plan(plan, targets, faults);
        if step.solved {
            faults.add("solved", Flaw::TwoPlans);
        }
    }
    faults.range("time", step.time, 0, MAX_TIME);
    if let Some(edits) = step.edits {
        faults.range("edits", edits, 1, MAX_EDITS);
    }
    let cells = step.cells.iter().flatten();
    faults.few("cells", cells.clone().count(), MAX_CELLS, Things::Cells);
    for (index, cell) in cells.enumerate().take(MAX_CELLS) {
        if !targets.has_cell(*cell) {
            faults.add(format!("cells[{index}]"), Flaw::UnknownCell(*cell));
        }
    }
    match &step.task {
        Some(task) => {
            if step.hints.is_empty() && !has_replies(task) {
                faults.add("hints", Flaw::NoHints);
            }
            if step.reason.is_none() {
                faults.add("reason", Flaw::NoReason);
            }
            tasks::check(step, task, targets, faults);
        }
        None if !step.hints.is_empty() || step.reason.is_some() => {
            faults.add("task", Flaw::NoTask);
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
            faults.add(place, Flaw::BadScene(fault));
        }
    }
}

fn plan(plan: &Plan, targets: &Targets<'_>, faults: &mut Faults) {
    for (name, path) in &plan.paths {
        if !targets.has_robot(name) {
            faults.add("plan.paths", Flaw::UnknownRobot(name.clone()));
        }
        faults.few("plan.paths", path.len(), MAX_TIME as usize, Things::Cells);
    }
}

pub(super) fn course(course: &Course, faults: &mut Faults) {
    faults.title("title", &course.title);
    faults.few(
        "chapters",
        course.lessons().count(),
        MAX_LESSONS,
        Things::Lessons,
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
                let twice = Flaw::Twice(entry.lesson.to_string());
                faults.add(format!("{place}.lesson"), twice);
            }
            seen.push(&entry.lesson);
            picture(&format!("{place}.picture"), &entry.picture, faults);
        }
    }
}

pub(super) fn glossary(glossary: &Glossary, faults: &mut Faults) {
    faults.few("terms", glossary.terms.len(), MAX_TERMS, Things::Terms);
    let mut seen = Vec::new();
    for (index, term) in glossary.terms.iter().take(MAX_TERMS).enumerate() {
        let place = format!("terms[{index}]");
        faults.title(&format!("{place}.name"), &term.name);
        if seen.contains(&&term.term) {
            faults.add(format!("{place}.term"), Flaw::Twice(term.term.to_string()));
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
            faults.few(&format!("{place}.source"), length, most, Things::Characters);
        }
    }
}

fn picture(place: &str, picture: &Picture, faults: &mut Faults) {
    scene(&format!("{place}.scene"), &picture.scene, faults);
    faults.range(&format!("{place}.time"), picture.time, 0, MAX_TIME);
    let cells = picture.plan.iter().flat_map(|plan| plan.paths.values());
    for cell in cells.flatten().flatten() {
        if !is_on(&picture.scene, *cell) {
            faults.add(format!("{place}.plan"), Flaw::UnknownCell(*cell));
        }
    }
}
