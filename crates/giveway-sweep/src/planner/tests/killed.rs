//! Planners that are ended: with their children, for their time and their memory.

use std::fs;
use std::time::{Duration, SystemTime};

use giveway_solve::{Host, Limits, Progress};

use super::{Case, STEPS, Until};
use crate::planner::row;
use crate::{Clock, Failure, RowStatus};

/// The clock on the wall.
struct Wall(SystemTime);

impl Host for Wall {
    fn wall_seconds(&self) -> f64 {
        self.0.elapsed().unwrap_or_default().as_secs_f64()
    }

    fn progress(&self, _: &Progress) {}
}

/// Whether a process is at work. One that was killed is there until it is waited for.
fn is_alive(process: &str) -> bool {
    let words = ["-o", "stat=", "-p", process.trim()];
    let output = std::process::Command::new("ps")
        .args(words)
        .output()
        .unwrap();
    let state = String::from_utf8_lossy(&output.stdout).trim().to_owned();
    !state.is_empty() && !state.starts_with('Z')
}

/// Killing takes a moment.
fn is_soon_gone(process: &str) -> bool {
    (0..600).any(|_| {
        std::thread::sleep(Duration::from_millis(50));
        !is_alive(process)
    })
}

#[test]
fn one_that_hangs_is_killed_with_its_child() {
    let case = Case::script("sleep 900 & echo $! >made; mv made child; sleep 900");
    for cancels in [false, true] {
        let file = &case.path("child");
        let row = row(
            &case.task,
            &case.spec,
            &case.loaded,
            &Until { file, cancels },
        );
        assert_eq!(row.failure, Some(Failure::Time), "{row:?}");
        if !cancels {
            assert_eq!(row.reason.as_deref(), Some("no plan within 2.5 s"));
        }
        assert!(is_soon_gone(&fs::read_to_string(file).unwrap()));
        fs::remove_file(file).unwrap();
    }
}

#[test]
fn a_child_that_is_left_behind_is_killed_too() {
    let script = format!("sleep 900 & echo $! >child; printf \"{STEPS}\" >\"$2\"");
    let case = Case::script(&script);
    assert_eq!(case.row().status, RowStatus::Feasible);
    assert!(is_soon_gone(
        &fs::read_to_string(case.path("child")).unwrap()
    ));
}

#[cfg(target_os = "linux")]
#[test]
fn one_that_eats_memory_is_killed() {
    let mut case = Case::script("x=$(head -c 90000000 /dev/zero | tr \"\\0\" x); sleep 900");
    case.task.limits = Limits {
        memory_bytes: Some(30_000_000),
        ..Limits::default()
    };
    let row = row(
        &case.task,
        &case.spec,
        &case.loaded,
        &Wall(SystemTime::now()),
    );
    assert_eq!(row.failure, Some(Failure::Memory), "{row:?}");
    let reason = row.reason.unwrap();
    assert!(reason.starts_with("held more than 30 MB"), "{reason}");
    assert!(row.took.peak_bytes.unwrap() > 30_000_000);
}

#[cfg(target_os = "linux")]
#[test]
fn a_limit_of_cpu_seconds_counts_those_of_its_children() {
    let mut case = Case::script("while :; do :; done & wait");
    case.task.clock = Clock::Cpu;
    case.task.limits.seconds = Some(0.2);
    let row = row(
        &case.task,
        &case.spec,
        &case.loaded,
        &Wall(SystemTime::now()),
    );
    assert_eq!(row.failure, Some(Failure::Time), "{row:?}");
    assert!(row.took.cpu_seconds >= 0.2, "{row:?}");
}
