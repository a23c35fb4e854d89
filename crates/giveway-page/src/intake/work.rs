//! What the reader does: it reads, writes and reports. It runs in a program of
//! its own, so that the page need not hold a reader for every format.

use std::collections::BTreeMap;

use giveway_formats::{Combined, Format, Held, Missing, Options, Refused, Source};
use giveway_model::format::{decode, read_text};
use giveway_model::{Cost, Fault, Instance, Plan, Scene, tr};
use giveway_proof::bundle::archive::pack;
use giveway_solve::ExportAnswer;

use super::protocol::{Found, Read, Reply, ReportKind, Run, Task};
use crate::State;
use crate::audit::{report, told as told_of};
use crate::files::{self, Opened, Reading, Together};
use crate::link::kept_moment;

/// The most faults that are told of one file.
const TOLD: usize = 5;

/// Does a task.
pub(crate) fn work(task: Task) -> Reply {
    match task {
        Task::Read(read) => reading(read),
        Task::Write {
            format,
            stem,
            scene,
            plan,
        } => writing(format, &stem, scene, plan.as_ref()),
        Task::Pack { answer, .. } => packing(answer),
        Task::Freedom { name, told } => match serde_json::to_string_pretty(&told) {
            Ok(text) => Reply::Drawn(name, (text + "\n").into_bytes()),
            Err(error) => Reply::Refused(error.to_string(), Vec::new()),
        },
        Task::Report {
            kind,
            kept,
            bounds,
            link,
        } => reporting(kind, &kept, &bounds, &link),
        // A film is more than one task.
        Task::Picture { .. } | Task::Pixels(_) => Reply::Refused(
            tr!("The reader was asked for a picture twice.").to_owned(),
            Vec::new(),
        ),
    }
}

/// Reads the files by themselves; where they lack something, with those that
/// waited, then on the scene of the board.
fn reading(read: Read) -> Reply {
    if are_own(&read) {
        return own(read);
    }
    let options = Options {
        conventions: read.conventions,
        agents: None,
        ..Options::default()
    };
    let alone = combined(&read.files, &options);
    let is_whole = alone.as_ref().is_ok_and(|found| !found.plans.is_empty());
    let mut together = None;
    if !is_whole && !read.waiting.is_empty() {
        let mut files = read.waiting.clone();
        files.extend(read.files.iter().cloned());
        let joined = combined(&files, &options);
        if let Ok(found) = joined.as_ref()
            && (fits(found) || alone.is_err())
        {
            return reply(joined, &files);
        }
        if let Err(Refused::Missing { .. }) = joined {
            together = Some((joined, files));
        }
    }
    match alone {
        Ok(found) if found.plans.is_empty() && all_own(&read.files) => Reply::Own,
        Err(Refused::Missing { .. }) => {
            let (missing, files) = together.unwrap_or((alone, read.files));
            lacking(missing, files, read.board, &options)
        }
        alone => reply(alone, &read.files),
    }
}

/// Reads the project's own JSON; what lacks a scene with that of the board.
fn own(read: Read) -> Reply {
    let mut files = read.files;
    if let (false, Some(board)) = (files.iter().any(is_scene), read.board) {
        let are_changes = files.iter().all(are_changes);
        files.insert(0, board);
        files.extend(read.plan.filter(|_| are_changes));
    }
    match files::read(&files) {
        Ok(Reading::Scene(scene)) => Reply::Found(Box::new(Found {
            scene: *scene,
            plans: Vec::new(),
            notes: encodings(&files),
            files,
        })),
        Ok(Reading::Linked(together)) => Reply::Run(Box::new(run(*together, &files))),
        // A plan that breaks a rule is audited, and so are several plans.
        Ok(Reading::Illegal(files)) => reply(combined(&files, &Options::default()), &files),
        Ok(Reading::Scenario(_) | Reading::Lesson(_)) => Reply::Own,
        Err(notice) => Reply::Refused(notice.sentence(), notice.details()),
    }
}

/// Whether files are all JSON of the project's own.
fn are_own(read: &Read) -> bool {
    let is_own = |file: &Opened| {
        read_text(&file.bytes)
            .is_ok_and(|text| giveway_formats::recognise(&text) == Ok(Format::Giveway))
    };
    read.waiting.is_empty() && !read.files.is_empty() && read.files.iter().all(is_own)
}

/// Whether a file holds a scene of the project's own, or anything that is wrong.
fn is_scene(file: &Opened) -> bool {
    let text = read_text(&file.bytes).unwrap_or_default();
    !matches!(
        giveway_formats::read(&text),
        Ok((
            _,
            Held::OwnPlan(..) | Held::NoPlan(_) | Held::Changes(_) | Held::Asked(_)
        ))
    )
}

/// Whether a file holds what changes while a plan runs.
fn are_changes(file: &Opened) -> bool {
    let text = read_text(&file.bytes).unwrap_or_default();
    matches!(giveway_formats::read(&text), Ok((_, Held::Changes(_))))
}

/// What was read, as the page reads it again: it need not trust it.
fn run(Together { linked, mut notes }: Together, files: &[Opened]) -> Run {
    let answer = linked.document.answer.as_ref();
    let course = answer.and_then(|answer| answer.course.as_ref());
    notes.extend(encodings(files));
    Run {
        scene: linked.document.draft.scene().clone(),
        plan: answer.and_then(|answer| answer.plan()).cloned(),
        changes: course.map(|course| course.changes.clone()),
        listed: linked.document.mode.changing().map(|it| it.listed()),
        question: linked.question,
        notes,
    }
}

/// What a person should know of how the bytes of files were read.
fn encodings(files: &[Opened]) -> Vec<String> {
    let note = |file: &Opened| decode(&file.bytes).ok()?.1.note(&file.name);
    files.iter().filter_map(note).collect()
}

/// Whether at least half of the robots of some plan fit the scene.
fn fits(found: &Combined) -> bool {
    let plans = found.plans.iter();
    plans
        .filter(|plan| plan.format != Format::Giveway)
        .any(|plan| plan.fit.fitting * 2 >= plan.fit.agents.max(1))
}

/// Files that lack something: what it is, and what they hold on the board's scene.
fn lacking(
    missing: Result<Combined, Refused>,
    files: Vec<Opened>,
    board: Option<Opened>,
    options: &Options,
) -> Reply {
    let Err(Refused::Missing { what, sentence, .. }) = missing else {
        return reply(missing, &files);
    };
    let on_board = board.and_then(|board| {
        let mut with = files.clone();
        with.push(board);
        let found = combined(&with, options).ok().filter(fits)?;
        Some(Box::new(told(found, &with)))
    });
    Reply::Missing {
        sentence,
        map: match what {
            Missing::Map(name) => name,
            Missing::Scenario | Missing::Problem | Missing::Files(_) => None,
        },
        files,
        on_board,
    }
}

/// Whether files hold only what the page reads by itself: a map, a map with a scenario.
fn all_own(files: &[Opened]) -> bool {
    files.iter().all(|file| {
        let text = read_text(&file.bytes).unwrap_or_default();
        giveway_formats::recognise(&text) == Ok(Format::MovingAi)
    })
}

fn combined(files: &[Opened], options: &Options) -> Result<Combined, Refused> {
    let mut texts = Vec::with_capacity(files.len());
    for file in files {
        let text = read_text(&file.bytes).map_err(|fault| Refused::File {
            file: file.name.clone(),
            faults: vec![fault],
        })?;
        texts.push((file.name.as_str(), text));
    }
    let sources = texts.iter();
    let sources: Vec<Source<'_>> = sources.map(|(name, text)| Source { name, text }).collect();
    let mut combined = giveway_formats::combine(&sources, options)?;
    combined.notes.extend(encodings(files));
    Ok(combined)
}

fn reply(result: Result<Combined, Refused>, files: &[Opened]) -> Reply {
    match result {
        Ok(found) => Reply::Found(Box::new(told(found, files))),
        Err(Refused::File { file, faults }) => {
            let (sentence, details) = faulty(&file, &faults);
            Reply::Refused(sentence, details)
        }
        Err(Refused::Missing { sentence, .. } | Refused::Apart(sentence)) => Reply::Refused(
            tr!("The files cannot be opened; the scene stays as it is.").to_owned(),
            vec![sentence],
        ),
    }
}

fn told(found: Combined, files: &[Opened]) -> Found {
    Found {
        scene: found.instance.to_scene(),
        plans: found.plans,
        notes: found.notes,
        files: files.to_vec(),
    }
}

fn faulty(file: &str, faults: &[Fault]) -> (String, Vec<String>) {
    let told = faults.iter().take(TOLD);
    let mut details: Vec<String> = told.map(|fault| format!("{file}, {fault}")).collect();
    if let more @ 1.. = faults.len().saturating_sub(TOLD) {
        details.push(tr!("and {n} more fault" | "and {n} more faults" % more));
    }
    let sentence = tr!("{file} cannot be opened; the scene stays as it is.", file);
    (sentence, details)
}

/// Packs certificates into one file.
fn packing(answer: ExportAnswer) -> Reply {
    let bundles = answer.certificates.into_iter().map(|(name, it)| {
        let files = it.files.into_iter();
        (
            name,
            files.map(|(file, text)| (file, text.into())).collect(),
        )
    });
    match pack(&bundles.collect()) {
        Ok(bytes) => Reply::Packed(bytes),
        Err(fault) => Reply::Refused(
            tr!("The certificates cannot be saved.").to_owned(),
            vec![fault.to_string()],
        ),
    }
}

/// Writes a report of the audit in a kept document.
fn reporting(kind: ReportKind, kept: &str, bounds: &BTreeMap<Cost, u32>, link: &str) -> Reply {
    let state = kept_moment(kept).map(|moment| State::of(moment.document));
    let told = state.ok().and_then(|state| told_of(&state, bounds));
    match told {
        Some(told) => {
            let (name, text) = report::write(kind, &told, link);
            Reply::Written(vec![(name, text)], Vec::new())
        }
        None => Reply::Refused(tr!("There is nothing to report.").to_owned(), Vec::new()),
    }
}

fn writing(format: Format, stem: &str, scene: Scene, plan: Option<&Plan>) -> Reply {
    let refused = |faults: &[Fault]| {
        let details = faults.iter().map(ToString::to_string).collect();
        Reply::Refused(
            tr!("This cannot be written in that format.").to_owned(),
            details,
        )
    };
    let instance = match Instance::new(scene) {
        Ok(instance) => instance,
        Err(faults) => return refused(&faults),
    };
    match giveway_formats::write(format, stem, Some(&instance), plan) {
        Ok(written) => Reply::Written(written.files, written.losses),
        Err(fault) => refused(&[fault]),
    }
}
