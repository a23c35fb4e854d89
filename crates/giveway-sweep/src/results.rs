//! A folder of rows, a file a shard: read to know what is done, appended to row by row.
//!
//! A row is written whole, with the end of its line, in one write at the end of the file.
//! What a process that was killed left of a row has no end of a line: it is not read, and
//! cut off before the next row is written.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use crate::read::{read, whole};
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
        let rows = read(&[folder.to_owned()]).map_err(|wrong| wrong.to_string())?;
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

/// What is wrong with a file.
fn at(path: &Path, error: &io::Error) -> String {
    format!("{}: {error}", path.display())
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::tests::row;

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
        let wrong = read(std::slice::from_ref(&path)).unwrap_err();
        assert_eq!((&*wrong.file, wrong.fault.line), (path.as_path(), Some(1)));
    }

    #[test]
    fn a_file_that_was_taken_away_is_made_again() {
        let folder = tempfile::tempdir().unwrap();
        let mut results = Results::open(folder.path(), Shard::ALL).unwrap();
        assert!(results.is_locked());
        results.add(row("a")).unwrap();
        fs::remove_file(folder.path().join(Shard::ALL.file())).unwrap();
        results.add(row("b")).unwrap();
        let rows = read(&[folder.path().to_owned()]).unwrap();
        assert_eq!(rows[0].instance, "b");
    }

    #[test]
    fn a_file_system_without_locks_is_told_from_a_second_process() {
        let path = Path::new("results-1-of-1.jsonl");
        let none = TryLockError::Error(io::Error::from(io::ErrorKind::Unsupported));
        assert_eq!(is_locked(&Err(none), path), Ok(false));
        assert_eq!(is_locked(&Ok(()), path), Ok(true));
        let second = is_locked(&Err(TryLockError::WouldBlock), path).unwrap_err();
        assert!(second.contains("another process"), "{second}");
    }

    /// Every write to this device fails, as on a disk that is full.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_told_and_leaves_no_half_row() {
        let folder = tempfile::tempdir().unwrap();
        let mut results = Results::open(folder.path(), Shard::ALL).unwrap();
        let path = folder.path().join(Shard::ALL.file());
        fs::remove_file(&path).unwrap();
        std::os::unix::fs::symlink("/dev/full", &path).unwrap();
        let full = results.add(row("a")).unwrap_err();
        assert!(full.contains("results-1-of-1.jsonl: No space"), "{full}");
        assert!(results.of(&row("a").task).is_none());
    }
}
