//! Other people's files come in: what the reader tells, heard in one place.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_formats::{Conventions, Format};
use giveway_model::{Plan, tr_data};
use giveway_picture::Look;

use super::{audit, file, stroke};
use crate::action::IntakeAction;
use crate::files::{self, Opened};
use crate::intake::protocol::{Found, PictureKind, Read, Reply, Run, Task};
use crate::intake::{self, Job, Packed, Save, Written, beside};
use crate::link::{self, Linked, Source, keep_moment};
use crate::{Document, FileAction, Notice, State, certificate};

/// The longest sides of pictures that move, in pixels: a GIF has many frames.
const LONGEST_SVG: u32 = 2048;
const LONGEST_GIF: u32 = 960;

#[inline(never)]
pub(super) fn intake(state: &mut State, action: IntakeAction) {
    match action {
        IntakeAction::Read(files) => {
            let task = Task::Read(intake::read(state, files));
            begin(state, task);
        }
        IntakeAction::Fetched { job, files } => state.intake.fetched(job, files),
        IntakeAction::Progress { job, sentence } => {
            if let Some(job) = state.intake.at(job) {
                job.sentence = sentence;
            }
        }
        IntakeAction::Reply { job, reply } => {
            if state.intake.at(job).is_some()
                && let Some(job) = state.intake.end()
            {
                // Nobody else has it.
                if let Some(reply) = Rc::into_inner(reply) {
                    replied(state, job, reply);
                }
            }
        }
        IntakeAction::Crash {
            job,
            had_started,
            details,
        } => {
            if state.intake.at(job).is_some()
                && let Some(job) = state.intake.end()
            {
                state.view.notice = Some(Notice::refusal(job.crashed(had_started)).with(details));
            }
        }
        IntakeAction::Save(what) => save(state, what),
        IntakeAction::Saved => {
            state.intake.written = None;
            state.intake.packed = None;
        }
    }
}

pub(super) fn begin(state: &mut State, task: Task) {
    stroke::release(state);
    state.view.notice = None;
    state.intake.written = None;
    state.intake.packed = None;
    state.intake.start(task);
}

/// Reads files again, by conventions that a person chose.
pub(super) fn read_as(state: &mut State, files: Vec<Opened>, conventions: Conventions) {
    if files.is_empty() {
        state.view.notice = Some(Notice::refusal(tr_data!(
            "The browser does not keep the file. Open it again to read it in another way."
        )));
        return;
    }
    let read = Read {
        files,
        conventions: Some(conventions),
        ..Read::default()
    };
    begin(state, Task::Read(read));
}

/// Has the scene and its plan written, or a report of the audit.
fn save(state: &mut State, what: Save) {
    let scene = state.document.draft.scene().clone();
    let name = crate::files::scene_file(state).name;
    let stem = giveway_model::format::stem(&name).to_owned();
    let task = match what {
        Save::As(format) => Task::Write {
            format,
            stem,
            plan: plan_for(state, format),
            scene,
        },
        Save::Picture(kind, theme) => {
            let Some(plan) = plan_to_draw(state) else {
                return;
            };
            let longest = match kind {
                PictureKind::Svg => LONGEST_SVG,
                PictureKind::Gif => LONGEST_GIF,
            };
            let look = Look {
                theme,
                looks: state.document.looks.clone(),
                colours: state.document.colours,
                ..Look::fitting(state.document.draft.grid(), longest)
            };
            Task::Picture {
                kind,
                stem,
                scene,
                plan,
                look,
            }
        }
        Save::Freedom => {
            let told = state.freedom().and_then(|freedom| freedom.told.clone());
            let Some(told) = told else { return };
            Task::Freedom {
                name: files::freedom_name(state),
                told: (*told).clone(),
            }
        }
        Save::Report(kind, link) => {
            let run = state.work.solving();
            Task::Report {
                kind,
                kept: keep_moment(&state.moment()),
                bounds: run.map_or_else(BTreeMap::new, |run| run.bounds.clone()),
                link,
            }
        }
    };
    begin(state, task);
}

/// The plan that is shown, where the format holds plans.
fn plan_for(state: &State, format: Format) -> Option<Plan> {
    plan_to_draw(state).filter(|_| format != Format::MovingAi)
}

/// The plan that is shown, where it is one for the scene, which does not change.
fn plan_to_draw(state: &State) -> Option<Plan> {
    let answer = state.shown().filter(|_| !state.shows_stale())?;
    answer.plan().filter(|_| answer.course.is_none()).cloned()
}

impl State {
    /// Whether the plan that is shown can be saved as a picture that moves.
    pub fn can_be_drawn(&self) -> bool {
        plan_to_draw(self).is_some()
    }
}

/// The reader is done.
fn replied(state: &mut State, job: Job, reply: Reply) {
    match reply {
        Reply::Found(found) => opened(state, *found),
        Reply::Run(run) => ran(state, *run),
        Reply::Own => {}
        Reply::Drawn(name, bytes) => state.intake.packed = Some(Rc::new(Packed { name, bytes })),
        Reply::Missing {
            sentence,
            files,
            map,
            on_board,
        } => {
            let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
            let fetches = beside(map.as_deref(), &names);
            let has = |name: &String| files.iter().any(|file| file.name == *name);
            let fetches = fetches.into_iter().filter(|name| !has(name)).collect();
            if state.intake.fetch(job, fetches) {
                return;
            }
            if let Some(found) = on_board {
                return opened(state, *found);
            }
            state.intake.wait(files);
            state.view.notice =
                Some(Notice::information(tr_data!("One file more is needed.")).with([sentence]));
        }
        Reply::Refused(sentence, details) => written_or_told(state, &job, sentence, details),
        Reply::Packed(bytes) => packed(state, &job, bytes),
        Reply::Written(files, losses) => {
            let format = match &*job.task {
                Task::Write { format, .. } => Some(*format),
                _ => None,
            };
            state.intake.written = Some(Rc::new(Written {
                format,
                files,
                losses,
            }));
        }
    }
}

/// Certificates are one file now.
fn packed(state: &mut State, job: &Job, bytes: Vec<u8>) {
    if let Task::Pack { name, answer } = &*job.task {
        state.view.notice = Some(certificate::saved(name, answer));
        let name = name.clone();
        state.intake.packed = Some(Rc::new(Packed { name, bytes }));
    }
}

/// A scene with its plan, what changed and a question was read: the plan is judged.
fn ran(state: &mut State, run: Run) {
    let Run {
        scene,
        plan,
        changes,
        listed,
        question,
        notes,
    } = run;
    state.intake.wait(Vec::new());
    let linked = file::drafted(scene).and_then(|draft| match plan {
        None => Ok(Linked {
            document: Document::new(draft),
            time: 0,
            question: None,
            source: Source::File,
            was_impossible: false,
            is_checked: true,
        }),
        Some(plan) => match listed {
            None => link::judged(draft, plan, changes),
            Some(listed) => link::changing(draft, plan, &listed),
        }
        .map_err(|why| {
            Notice::refusal(tr_data!(
                "The plan cannot be opened; the scene stays as it is."
            ))
            .with([why])
        }),
    });
    let action = linked.map_or_else(FileAction::Tell, |linked| {
        FileAction::OpenLink(Box::new(Linked { question, ..linked }))
    });
    file::file(state, action);
    if state.view.notice.is_none() && !notes.is_empty() {
        state.view.notice = Some(Notice::information(tr_data!("The files were read.")).with(notes));
    }
}

/// What cannot be read is told as a notice, what cannot be written where it was asked.
fn written_or_told(state: &mut State, job: &Job, sentence: String, details: Vec<String>) {
    if let Task::Write { format, .. } = &*job.task {
        state.intake.written = Some(Rc::new(Written {
            format: Some(*format),
            files: Vec::new(),
            losses: details,
        }));
        return;
    }
    state.view.notice = Some(Notice::refusal(sentence).with(details));
}

/// A scene with its plans was read.
fn opened(state: &mut State, found: Found) {
    state.intake.wait(Vec::new());
    let Found {
        scene,
        plans,
        notes,
        files,
    } = found;
    if plans.is_empty() {
        file::open(state, scene);
        if state.view.notice.is_none() && !notes.is_empty() {
            state.view.notice =
                Some(Notice::information(tr_data!("The scene was read.")).with(notes));
        }
        return;
    }
    if let Err(notice) = audit::open(state, scene, plans, notes, files) {
        state.view.notice = Some(notice);
    }
}
