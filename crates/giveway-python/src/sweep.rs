//! Sweeps: the tasks of a spec, one of them done, tables of what came out.

use std::path::{Path, PathBuf};

use giveway_model::Fault;
use giveway_model::format::read_text;
use giveway_solve::Host;
use giveway_sweep::table::{Show, Written, write};
use giveway_sweep::{Folder, Row, Spec, Task, Unreadable, read};
use serde::{Deserialize, Serialize};

use crate::call::{Code, Failure};

/// The spec whose tasks are wanted.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SpecRequest {
    spec: PathBuf,
    /// The folder from which its paths start, where it is not its own.
    #[serde(default)]
    files: Option<PathBuf>,
}

/// The tasks of a spec.
#[derive(Serialize)]
pub(crate) struct Listed {
    folder: PathBuf,
    skip_after: Option<usize>,
    tasks: Vec<NamedTask>,
}

/// A task with its names.
#[derive(Serialize)]
pub(crate) struct NamedTask {
    name: String,
    series: String,
    task: Task,
}

/// A task, and the folder of its spec.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TaskRequest {
    folder: PathBuf,
    task: Task,
}

/// The tables that can be made.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TableRequest {
    results: Vec<PathBuf>,
    show: Show,
    to: Written,
}

/// Files and folders of rows.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct RowsRequest {
    results: Vec<PathBuf>,
}

/// Lists the tasks.
pub(crate) fn tasks(request: &SpecRequest) -> Result<Listed, Failure> {
    let path = &request.spec;
    let wrong = |fault: Fault| {
        let fault = fault.in_file(&path.to_string_lossy());
        Failure::new(Code::BadText, vec![fault])
    };
    let bytes = std::fs::read(path).map_err(|error| {
        wrong(Fault::at(
            "",
            format!("\"{error}\" on reading"),
            "a readable file",
        ))
    })?;
    let spec = read_text(&bytes)
        .and_then(|text| Spec::read(&text))
        .map_err(wrong)?;
    let own = || path.parent().map(Path::to_owned).unwrap_or_default();
    let place = request.files.clone().unwrap_or_else(own);
    let folder = Folder::new(&place);
    let most = |path: &str| folder.agents(path);
    let tasks = spec.tasks(&|pattern| folder.files(pattern), &most);
    let tasks = tasks.map_err(wrong)?;
    let named = tasks.into_iter().map(|task| NamedTask {
        name: task.name(),
        series: task.series(),
        task,
    });
    Ok(Listed {
        folder: place,
        skip_after: spec.skip_after,
        tasks: named.collect(),
    })
}

/// Does a task. Where it was stopped there is a row that says no more: what stopped it is
/// raised instead.
pub(crate) fn row(request: &TaskRequest, host: &dyn Host) -> Row {
    let task = &request.task;
    let row = Folder::new(&request.folder).row(task, host);
    row.unwrap_or_else(|| Row::error(task, "It was stopped.".to_owned()))
}

/// The row of a task that is not tried.
pub(crate) fn skipped(request: &TaskRequest) -> Row {
    Row::skipped(&request.task)
}

/// The rows of files and folders, those of one task once.
pub(crate) fn rows(request: &RowsRequest) -> Result<Vec<Row>, Failure> {
    known(&request.results)
}

fn known(results: &[PathBuf]) -> Result<Vec<Row>, Failure> {
    read(results).map_err(|Unreadable { file, fault }| {
        let fault = fault.in_file(&file.to_string_lossy());
        Failure::new(Code::BadText, vec![fault])
    })
}

/// Makes a table or a plot.
pub(crate) fn table(request: &TableRequest) -> Result<String, Failure> {
    let rows = known(&request.results)?;
    write(&rows, request.show, request.to).map_err(|sentence| {
        let found = sentence.trim_end_matches('.').to_owned();
        Failure::input(Fault::at("to", found, "markdown, csv, svg or html"))
    })
}
