//! Rows that are kept, killed, damaged and read again.

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
