//! A folder of rows, a file a shard: read to know what is done, appended to row by row.
//!
//! A row is written whole, with the end of its line, in one write. What a process that was
//! killed left of a row has no end of a line: it is not read, and cut off before the next
//! row is written.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use crate::{Row, RowStatus, Shard};

/// The rows of a sweep.
#[derive(Debug)]
pub struct Results {
    own: File,
    path: PathBuf,
    done: BTreeMap<String, Row>,
}

impl Results {
    /// Opens a folder, made if there is none, for one shard to write to. Nobody else may
    /// write to the same shard's file at the same time, which is locked.
    ///
    /// # Errors
    /// When a file cannot be read or written, holds what is no row, or is locked.
    pub fn open(folder: &Path, shard: Shard) -> Result<Self, String> {
        let at = |path: &Path, error: &io::Error| format!("{}: {error}", path.display());
        fs::create_dir_all(folder).map_err(|error| at(folder, &error))?;
        let path = folder.join(shard.file());
        let mut own = OpenOptions::new()
            .create(true)
            .truncate(false)
            .read(true)
            .write(true)
            .open(&path)
            .map_err(|error| at(&path, &error))?;
        own.try_lock().map_err(|_| {
            format!(
                "{}: found a file that another process writes to, expected this shard to run once",
                path.display()
            )
        })?;
        cut_off(&mut own).map_err(|error| at(&path, &error))?;
        let rows = read(&[folder.to_owned()])?;
        let done = rows
            .into_iter()
            .map(|row| (row.task.clone(), row))
            .collect();
        Ok(Self { own, path, done })
    }

    /// The row of a task, if it is done, by whichever shard.
    pub fn of(&self, task: &str) -> Option<&Row> {
        self.done.get(task)
    }

    /// Adds a row.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn add(&mut self, row: Row) -> Result<(), String> {
        let line = line(&row)?;
        self.own
            .write_all(line.as_bytes())
            .and_then(|()| self.own.flush())
            .map_err(|error| format!("{}: {error}", self.path.display()))?;
        self.done.insert(row.task.clone(), row);
        Ok(())
    }
}

/// A row as a line, with its end.
///
/// # Errors
/// When JSON cannot hold it.
pub fn line(row: &Row) -> Result<String, String> {
    let text = serde_json::to_string(row).map_err(|error| error.to_string())?;
    Ok(text + "\n")
}

/// Cuts off what follows the last end of a line, and goes to the end.
fn cut_off(file: &mut File) -> io::Result<()> {
    use std::io::{Seek, SeekFrom};
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    let whole = bytes.iter().rposition(|&byte| byte == b'\n');
    let length = whole.map_or(0, |last| last + 1) as u64;
    file.set_len(length)?;
    file.seek(SeekFrom::Start(length)).map(|_| ())
}

/// The rows of files and folders, those of one task once, in the order of their tasks'
/// names.
///
/// # Errors
/// When something cannot be read, or a line is no row.
pub fn read(paths: &[PathBuf]) -> Result<Vec<Row>, String> {
    let mut rows = BTreeMap::new();
    for path in paths {
        for path in lines_of(path)? {
            let text = fs::read_to_string(&path).map_err(|error| match error.kind() {
                io::ErrorKind::NotFound => format!(
                    "{}: found no file of this name, expected a file or a folder of results",
                    path.display()
                ),
                _ => format!("{}: {error}", path.display()),
            })?;
            let whole = text.rfind('\n').map_or("", |last| &text[..last]);
            for (number, line) in whole
                .lines()
                .enumerate()
                .filter(|(_, line)| !line.is_empty())
            {
                let row: Row = serde_json::from_str(line).map_err(|error| {
                    format!(
                        "{}: line {}: found what is no row ({error}), expected a row of a sweep",
                        path.display(),
                        number + 1
                    )
                })?;
                // What was skipped may have been tried since.
                let known: Option<&Row> = rows.get(&row.task);
                if known.is_none_or(|known| known.status == RowStatus::Skipped) {
                    rows.insert(row.task.clone(), row);
                }
            }
        }
    }
    Ok(rows.into_values().collect())
}

/// The files of a folder that hold rows, or the file itself.
fn lines_of(path: &Path) -> Result<Vec<PathBuf>, String> {
    if !path.is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let entries = fs::read_dir(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut files = Vec::new();
    for entry in entries {
        let path = entry
            .map_err(|error| format!("{}: {error}", path.display()))?
            .path();
        if path.extension().is_some_and(|ending| ending == "jsonl") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Method, Task};

    fn row(name: &str) -> Row {
        let task = Task {
            instance: name.to_owned(),
            agents: None,
            objective: None,
            planner: Method::Search,
            limits: giveway_solve::Limits::default(),
            clock: crate::Clock::Wall,
            certificate: None,
        };
        Row::bare(&task, RowStatus::Unknown, None)
    }

    #[test]
    fn what_is_done_is_known_and_half_a_row_is_cut_off() {
        let folder = tempfile::tempdir().unwrap();
        let shard = Shard::new(1, 2).unwrap();
        let other = Shard::new(2, 2).unwrap();
        let mut results = Results::open(folder.path(), shard).unwrap();
        results.add(row("a")).unwrap();
        let locked = Results::open(folder.path(), shard).unwrap_err();
        assert!(locked.contains("another process"), "{locked}");
        drop(results);
        let path = folder.path().join(shard.file());
        let whole = fs::read_to_string(&path).unwrap();
        fs::write(&path, format!("{whole}{}", &line(&row("b")).unwrap()[..20])).unwrap();

        let mut results = Results::open(folder.path(), shard).unwrap();
        assert!(results.of(&row("a").task).is_some());
        assert!(results.of(&row("b").task).is_none());
        results.add(row("b")).unwrap();
        let mut others = Results::open(folder.path(), other).unwrap();
        assert!(
            others.of(&row("b").task).is_some(),
            "done by the other shard"
        );
        others.add(row("c")).unwrap();
        let rows = read(&[folder.path().to_owned(), path.clone()]).unwrap();
        let names: Vec<&str> = rows.iter().map(|row| row.instance.as_str()).collect();
        assert_eq!(names, ["a", "b", "c"]);

        others
            .add(Row {
                status: RowStatus::Skipped,
                ..row("d")
            })
            .unwrap();
        others.add(row("d")).unwrap();
        let rows = read(&[folder.path().to_owned()]).unwrap();
        assert_eq!(rows[3].status, RowStatus::Unknown, "tried since");

        fs::write(&path, "{}\n").unwrap();
        let wrong = read(&[path]).unwrap_err();
        assert!(wrong.contains("line 1"), "{wrong}");
    }
}
