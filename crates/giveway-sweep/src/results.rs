//! A folder of rows, a file a shard: read to know what is done, appended to row by row.
//!
//! A row is written whole, with the end of its line, in one write at the end of the file.
//! What a process that was killed left of a row has no end of a line: it is not read, and
//! cut off before the next row is written.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use crate::{Row, RowStatus, Shard};

/// The rows of a sweep.
#[derive(Debug)]
pub struct Results {
    path: PathBuf,
    lock: File,
    is_locked: bool,
    done: BTreeMap<String, Row>,
}

impl Results {
    /// Opens a folder, made if there is none, for one shard to write to. Nobody else may
    /// write to the same shard's file at the same time: a file beside it is locked, since on
    /// some systems nobody can read what is locked.
    ///
    /// # Errors
    /// When a file cannot be read or written, holds what is no row, or is locked.
    pub fn open(folder: &Path, shard: Shard) -> Result<Self, String> {
        fs::create_dir_all(folder).map_err(|error| match error.kind() {
            io::ErrorKind::AlreadyExists | io::ErrorKind::NotADirectory => format!(
                "{}: found a file, expected a folder of results",
                folder.display()
            ),
            _ => at(folder, &error),
        })?;
        let path = folder.join(shard.file());
        let lock_path = path.with_extension("lock");
        let mut options = OpenOptions::new();
        options.create(true).truncate(false).read(true).write(true);
        let lock = options.open(&lock_path);
        let lock = lock.map_err(|error| at(&lock_path, &error))?;
        let is_locked = is_locked(&lock.try_lock(), &path)?;
        let own = options.open(&path);
        own.and_then(|mut own| cut_off(&mut own))
            .map_err(|error| at(&path, &error))?;
        let rows = read(&[folder.to_owned()])?;
        let done = rows
            .into_iter()
            .map(|row| (row.task.clone(), row))
            .collect();
        Ok(Self {
            path,
            lock,
            is_locked,
            done,
        })
    }

    /// Whether the shard's file is locked; some file systems of clusters have no locks.
    pub const fn is_locked(&self) -> bool {
        self.is_locked
    }

    /// The row of a task, if it is done, by whichever shard.
    pub fn of(&self, task: &str) -> Option<&Row> {
        self.done.get(task)
    }

    /// Adds a row. When it returns, the row has reached the disk.
    ///
    /// # Errors
    /// When it cannot be written; then nothing of it is.
    pub fn add(&mut self, row: Row) -> Result<(), String> {
        let line = line(&row)?;
        // A skipped task is known again in no time, so that nobody waits for the disk.
        let wait = row.status != RowStatus::Skipped;
        append(&self.path, line.as_bytes(), wait).map_err(|error| at(&self.path, &error))?;
        self.done.insert(row.task.clone(), row);
        Ok(())
    }
}

impl Drop for Results {
    fn drop(&mut self) {
        // A process that was just begun may hold the file open for a moment more.
        let _ = self.lock.unlock();
    }
}

fn at(path: &Path, error: &io::Error) -> String {
    format!("{}: {error}", path.display())
}

/// Whether there is a lock now; a file system that has none is no fault of anybody.
fn is_locked(lock: &Result<(), TryLockError>, path: &Path) -> Result<bool, String> {
    match lock {
        Ok(()) => Ok(true),
        Err(TryLockError::Error(_)) => Ok(false),
        Err(TryLockError::WouldBlock) => Err(format!(
            "{}: found a file that another process writes to, expected this shard to run once",
            path.display()
        )),
    }
}

/// Appends a line, and waits until it is on the disk: only then do disks over a network say
/// that they are full. A file that somebody took away is made again.
fn append(path: &Path, line: &[u8], wait: bool) -> io::Result<()> {
    let mut file = OpenOptions::new().create(true).append(true).open(path)?;
    let length = file.metadata()?.len();
    let written = file.write_all(line);
    let written = written.and_then(|()| if wait { file.sync_data() } else { Ok(()) });
    if written.is_err() {
        // Half a row in the middle of a file would be no row.
        let _ = file.set_len(length);
    }
    written
}

/// A row as a line, with its end.
///
/// # Errors
/// When JSON cannot hold it.
pub fn line(row: &Row) -> Result<String, String> {
    let text = serde_json::to_string(row).map_err(|error| error.to_string())?;
    Ok(text + "\n")
}

/// Cuts off what follows the last end of a line.
fn cut_off(file: &mut File) -> io::Result<()> {
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    let length = whole(&bytes).len();
    if length < bytes.len() {
        file.set_len(length as u64)?;
    }
    Ok(())
}

/// What ends with an end of a line. What follows may end within a letter.
fn whole(bytes: &[u8]) -> &[u8] {
    let last = bytes.iter().rposition(|&byte| byte == b'\n');
    last.map_or(&[], |last| &bytes[..=last])
}

/// The rows of files and folders, those of one task once, in the order of their tasks'
/// names.
///
/// # Errors
/// When something cannot be read, or a line is no row.
pub fn read(paths: &[PathBuf]) -> Result<Vec<Row>, String> {
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
fn rows_of(path: &Path) -> Result<Vec<Row>, String> {
    let bytes = fs::read(path).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => format!(
            "{}: found no file of this name, expected a file or a folder of results",
            path.display()
        ),
        _ => at(path, &error),
    })?;
    let wrong = |number: usize, found: String| {
        format!(
            "{}: line {number}: found what is no row ({found}), expected a row of a sweep; \
            without this line its task is done again",
            path.display()
        )
    };
    let mut rows = Vec::new();
    for (index, line) in whole(&bytes).split(|&byte| byte == b'\n').enumerate() {
        let line = std::str::from_utf8(line)
            .map_err(|_| wrong(index + 1, "its letters are not UTF-8".to_owned()))?;
        let line = line.trim_start_matches('\u{feff}').trim();
        if line.is_empty() {
            continue;
        }
        let row: Row = serde_json::from_str(line).map_err(|error| {
            let error = error.to_string();
            wrong(index + 1, error.replace(" at line 1 column", " at column"))
        })?;
        rows.push(row);
    }
    Ok(rows)
}

/// The files of a folder that hold rows, or the file itself. Hidden ones, which editors and
/// other systems leave, hold none.
fn files_of(path: &Path) -> Result<Vec<PathBuf>, String> {
    if !path.is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let entries = fs::read_dir(path).map_err(|error| at(path, &error))?;
    let mut files = Vec::new();
    for entry in entries {
        let entry = entry.map_err(|error| at(path, &error))?;
        let is_hidden = entry.file_name().to_string_lossy().starts_with('.');
        let path = entry.path();
        if !is_hidden && path.extension().is_some_and(|ending| ending == "jsonl") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

#[cfg(test)]
mod tests;
