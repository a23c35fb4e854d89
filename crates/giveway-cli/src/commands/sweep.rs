//! `giveway sweep`: many tasks, one result each; and `giveway table`: what came out.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use giveway_solve::{Host, Progress};
use giveway_sweep::table::write;
use giveway_sweep::{Folder, Patience, Results, Row, RowStatus, Spec, Task, read};
use serde::Serialize;

use crate::{
    args::{Common, Sweep, Table},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input::Source,
    interrupt,
    output::{plain, stream},
};

/// A task with its name.
#[derive(Serialize)]
struct Listed<'a> {
    task: String,
    #[serde(flatten)]
    rest: &'a Task,
}

pub(crate) fn run(args: &Sweep, common: &Common) -> Result<Exit, Failure> {
    let source = Source::read(&args.spec)?;
    let spec = Spec::read(&source.text).map_err(|fault| source.fault(fault))?;
    let folder = match &args.files {
        Some(files) => Folder::new(files),
        None => Folder::of(&args.spec),
    };
    let most = |path: &str| folder.agents(path);
    let tasks = spec.tasks(&|pattern| folder.files(pattern), &most);
    let tasks = tasks.map_err(|fault| source.fault(fault))?;
    let tasks = spec.part(&tasks, args.shard);
    if args.list {
        let lines = tasks.iter().map(listed);
        return stream::file(lines.collect::<Result<String, _>>()?.as_bytes())
            .map(|()| Exit::Answered);
    }
    let place = args.results.clone().unwrap_or_else(|| beside(&args.spec));
    let mut results = Results::open(&place, args.shard).map_err(refused)?;
    if !results.is_locked() {
        stream::note(&format!(
            "{}: this file system has no locks; run each shard only once at a time.",
            place.display()
        ));
    }
    let mut patience = Patience::of(&spec);
    let mut counts: BTreeMap<RowStatus, usize> = BTreeMap::new();
    interrupt::listen();
    for (index, task) in tasks.iter().enumerate() {
        let known = results.of(&task.name()).cloned();
        let row = match known {
            Some(row) if patience.accepts(task, &row) => row,
            known => {
                let Some(row) = done(task, &folder, &patience) else {
                    stream::note("Stopped. The same command goes on with this task.");
                    break;
                };
                if !common.quiet {
                    stream::error_lines(&[told(index + 1, tasks.len(), &row)]);
                }
                if known.is_none_or(|known| !known.says(&row)) {
                    results.add(row.clone()).map_err(refused)?;
                }
                row
            }
        };
        patience.note(task, &row);
        *counts.entry(row.status).or_default() += 1;
    }
    let place = plain::text(&place.to_string_lossy());
    let text = format!("{}\nResults are in {place}.\n", counted(&counts));
    stream::result(&text)?;
    Ok(Exit::Answered)
}

/// How many tasks ended how, as a sentence.
fn counted(counts: &BTreeMap<RowStatus, usize>) -> String {
    let count = match counts.values().sum() {
        0 => return "There are no tasks to do.".to_owned(),
        1 => "1 task".to_owned(),
        count => format!("{count} tasks"),
    };
    let ends = counts
        .iter()
        .map(|(status, count)| format!("{count} {}", status.word()));
    format!("{count}: {}.", ends.collect::<Vec<_>>().join(", "))
}

/// The row of a task, done now if it is to be done at all; `None` where Ctrl-C ended it.
fn done(task: &Task, folder: &Folder, patience: &Patience) -> Option<Row> {
    if patience.skips(task) {
        return Some(Row::skipped(task));
    }
    folder.row(task, &TaskHost::start())
}

fn listed(task: &Task) -> Result<String, Failure> {
    let listed = Listed {
        task: task.name(),
        rest: task,
    };
    let text = serde_json::to_string(&listed);
    text.map(|text| text + "\n")
        .map_err(|error| refused(error.to_string()))
}

fn told(number: usize, count: usize, row: &Row) -> String {
    let (task, status) = (plain::text(&row.task), row.status.word());
    let seconds = row.took.wall_seconds;
    match &row.reason {
        Some(reason) if matches!(row.status, RowStatus::Error | RowStatus::Failed) => {
            let reason = plain::text(reason);
            format!("{number} of {count}: {task}: {status}: {reason}")
        }
        _ => format!("{number} of {count}: {task}: {status} in {seconds:.2} s"),
    }
}

fn refused(sentence: impl AsRef<str>) -> Failure {
    Failure::Refused(vec![plain::text(sentence.as_ref())])
}

/// `NAME-results` beside `NAME.toml`.
fn beside(spec: &Path) -> PathBuf {
    let stem = spec.file_stem().unwrap_or_default().to_string_lossy();
    spec.with_file_name(format!("{stem}-results"))
}

/// Writes tables and plots.
pub(crate) fn table(args: &Table) -> Result<Exit, Failure> {
    let rows = read(&args.results).map_err(|wrong| refused(wrong.to_string()))?;
    if rows.is_empty() {
        return Err(refused(
            "There are no results in it; giveway sweep writes them into files that end in .jsonl.",
        ));
    }
    let text = write(&rows, args.show, args.to).map_err(refused)?;
    stream::file(text.as_bytes())?;
    Ok(Exit::Answered)
}

/// The surroundings of one task: its clocks begin with it.
struct TaskHost {
    clock: Clock,
    cpu_before: f64,
}

impl TaskHost {
    fn start() -> Self {
        let clock = Clock::start();
        Self {
            clock,
            cpu_before: clock.cpu_seconds(),
        }
    }
}

impl Host for TaskHost {
    fn wall_seconds(&self) -> f64 {
        self.clock.wall_seconds()
    }

    fn cpu_seconds(&self) -> f64 {
        self.clock.cpu_seconds() - self.cpu_before
    }

    fn cancelled(&self) -> bool {
        interrupt::happened()
    }

    fn progress(&self, _: &Progress) {}
}
