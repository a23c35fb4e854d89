//! Rows read again: those of files and folders, whole lines only.

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use giveway_model::Fault;

use crate::{Row, RowStatus};

/// A file of rows that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The file, or the folder.
    pub file: Box<Path>,
    /// What is wrong with it, with its line where it is a line.
    pub fault: Fault,
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.file.display(), self.fault)
    }
}

impl Unreadable {
    fn new(file: &Path, error: &io::Error) -> Self {
        let expected = "a file or a folder of results";
        let found = match error.kind() {
            io::ErrorKind::NotFound => "no file of this name".to_owned(),
            _ => format!("\"{error}\" on reading"),
        };
        Self {
            file: file.into(),
            fault: Fault::at("", found, expected),
        }
    }
}

/// The rows of files and folders, those of one task once, in the order of their tasks'
/// names.
///
/// # Errors
/// When something cannot be read, or a line is no row.
pub fn read(paths: &[PathBuf]) -> Result<Vec<Row>, Unreadable> {
    let mut rows: BTreeMap<String, Row> = BTreeMap::new();
    for path in paths {
        for path in files_of(path)? {
            for row in rows_of(&path)? {
                let known = rows.get(&row.task);
                if known.is_none_or(|known| replaces(&row, known)) {
                    rows.insert(row.task.clone(), row);
                }
            }
        }
    }
    Ok(rows.into_values().collect())
}

/// Whether a row says more than another one of its task: what was skipped may have been
/// tried since, and what could not be read may have been there later.
fn replaces(row: &Row, known: &Row) -> bool {
    let rank = |row: &Row| match row.status {
        RowStatus::Skipped => 0,
        RowStatus::Error => 1,
        _ => 2,
    };
    rank(known) < 2 && rank(row) >= rank(known)
}

/// The rows of a file.
fn rows_of(path: &Path) -> Result<Vec<Row>, Unreadable> {
    let bytes = fs::read(path).map_err(|error| Unreadable::new(path, &error))?;
    let wrong = |index: usize, why: &str| {
        let found = format!("what is no row ({why})");
        let expected = "a row of a sweep; without this line its task is done again";
        let mut fault = Fault::at("", found, expected);
        fault.line = Some(index + 1);
        Unreadable {
            file: path.into(),
            fault,
        }
    };
    let mut rows = Vec::new();
    for (index, line) in whole(&bytes).split(|&byte| byte == b'\n').enumerate() {
        let line =
            std::str::from_utf8(line).map_err(|_| wrong(index, "its letters are not UTF-8"))?;
        let line = line.trim_start_matches('\u{feff}').trim();
        if line.is_empty() {
            continue;
        }
        let row: Row = serde_json::from_str(line).map_err(|error| {
            let error = error.to_string();
            wrong(index, &error.replace(" at line 1 column", " at column"))
        })?;
        rows.push(row);
    }
    Ok(rows)
}

/// The files of a folder that hold rows, or the file itself. Hidden ones, which editors and
/// other systems leave, hold none.
fn files_of(path: &Path) -> Result<Vec<PathBuf>, Unreadable> {
    if !path.is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let entries = fs::read_dir(path).map_err(|error| Unreadable::new(path, &error))?;
    let mut files = Vec::new();
    for entry in entries {
        let entry = entry.map_err(|error| Unreadable::new(path, &error))?;
        let is_hidden = entry.file_name().to_string_lossy().starts_with('.');
        let path = entry.path();
        if !is_hidden && path.extension().is_some_and(|ending| ending == "jsonl") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// What ends with an end of a line. What follows may end within a letter.
pub(crate) fn whole(bytes: &[u8]) -> &[u8] {
    let last = bytes.iter().rposition(|&byte| byte == b'\n');
    last.map_or(&[], |last| &bytes[..=last])
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::{Method, Results, Shard, Task, line};

    /// A row of an instance of this name.
    pub(crate) fn row(name: &str) -> Row {
        let task = Task {
            instance: name.to_owned(),
            agents: None,
            objective: None,
            planner: Method::Search,
            command: None,
            limits: giveway_solve::Limits::default(),
            clock: crate::Clock::Wall,
            certificate: None,
        };
        Row::bare(&task, RowStatus::Unknown, None)
    }

    fn ended(name: &str, status: RowStatus, reason: &str) -> Row {
        Row {
            status,
            reason: Some(reason.to_owned()),
            ..row(name)
        }
    }

    #[test]
    fn half_a_row_of_another_shard_that_ends_within_a_letter_stops_nobody() {
        let folder = tempfile::tempdir().unwrap();
        let mut text = line(&row("a")).unwrap().into_bytes();
        let next = line(&row("ü")).unwrap();
        for length in 0..next.len() {
            text.truncate(line(&row("a")).unwrap().len());
            text.extend(&next.as_bytes()[..length]);
            let other = folder.path().join("results-1-of-2.jsonl");
            fs::write(&other, &text).unwrap();
            assert_eq!(read(&[folder.path().to_owned()]).unwrap().len(), 1);
            if next.as_bytes()[..length].ends_with("ü".as_bytes()) {
                Results::open(folder.path(), Shard::new(2, 2).unwrap()).unwrap();
                assert_eq!(fs::read(&other).unwrap(), text, "its own shard cuts it off");
            }
        }
    }

    #[test]
    fn rows_are_read_as_editors_and_other_systems_leave_them() {
        let folder = tempfile::tempdir().unwrap();
        let lines = [line(&row("a")).unwrap(), line(&row("b")).unwrap()].concat();
        let text = format!("\u{feff}{}\r\n \r\n", lines.replace('\n', "\r\n"));
        fs::write(folder.path().join("results-1-of-1.jsonl"), text).unwrap();
        fs::write(folder.path().join("._results-1-of-1.jsonl"), "\0\n").unwrap();
        let rows = read(&[folder.path().to_owned()]).unwrap();
        assert_eq!(rows.len(), 2);
    }

    #[test]
    fn what_a_row_says_stays_and_the_last_error_is_told() {
        use RowStatus::{Error, Skipped, Unknown};
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("results-1-of-1.jsonl");
        let said = |rows: &[Row]| {
            let lines = rows.iter().map(|row| line(row).unwrap());
            fs::write(&path, lines.collect::<String>()).unwrap();
            let row = read(std::slice::from_ref(&path)).unwrap().remove(0);
            (row.status, row.reason.unwrap_or_default())
        };
        let [first, second] = ["first", "second"].map(|reason| ended("a", Error, reason));
        let skipped = ended("a", Skipped, "");
        let tried = ended("a", Unknown, "");
        let rows = [skipped.clone(), first, second, skipped];
        assert_eq!(said(&rows), (Error, "second".to_owned()));
        let rows = [&rows[..], &[tried], &rows].concat();
        assert_eq!(said(&rows), (Unknown, String::new()));
    }
}
