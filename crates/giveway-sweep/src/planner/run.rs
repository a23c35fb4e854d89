//! One run of a command within limits, in a process group of its own.

use std::ffi::OsString;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};
use std::thread;
use std::time::Duration;

use giveway_solve::{Host, Limits};
use rustix::process::{Pid, Signal, WaitId, WaitIdOptions, kill_process_group, waitid};
use wait4::Wait4;

use super::errors::Errors;
use super::guard::Guard;
use super::output;
use super::usage::{self, Usage};
use crate::{Clock, Task};

/// Between two looks whether it has ended: short at first, for planners that are done soon.
const FIRST_NAP: Duration = Duration::from_micros(500);
const LAST_NAP: Duration = Duration::from_millis(20);
/// Wall seconds between two looks at what it uses, and how many times longer than such a
/// look: it costs more on a machine with many processes.
const BETWEEN_LOOKS: f64 = 0.04;
const LOOK_SHARE: f64 = 20.0;
/// Where the limit is one of CPU seconds: a planner that sleeps uses none. It is ended after
/// so many times its limit on the wall, and some seconds more.
const WALL_FACTOR: f64 = 10.0;
const WALL_MORE: f64 = 60.0;

/// Why a planner was ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    /// The time was over.
    Time,
    /// It held too much memory.
    Memory,
    /// It wrote too much.
    Output,
    /// Whoever runs the sweep ended it.
    Cancelled,
}

/// How a planner ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ended {
    /// By itself.
    Exit(ExitStatus),
    /// It was killed with its group.
    Stopped(Stop),
}

/// A run that is over.
#[derive(Debug)]
pub(super) struct Ran {
    pub(super) ended: Ended,
    /// CPU seconds of the planner and its children.
    pub(super) cpu_seconds: f64,
    pub(super) wall_seconds: f64,
    /// The most memory that they held at once, in bytes, where it is known.
    pub(super) peak_bytes: Option<u64>,
    /// The last line of its standard error.
    pub(super) last_line: Option<String>,
}

/// What is run, and where.
pub(super) struct Job<'a> {
    /// The program and its arguments.
    pub(super) words: &'a [OsString],
    /// The folder in which it runs.
    pub(super) folder: &'a Path,
    /// The file that it writes.
    pub(super) out: &'a Path,
    pub(super) limits: Limits,
    pub(super) clock: Clock,
}

impl<'a> Job<'a> {
    pub(super) fn new(task: &Task, words: &'a [OsString], folder: &'a Path, out: &'a Path) -> Self {
        let (limits, clock) = (task.limits, task.clock);
        Self {
            words,
            folder,
            out,
            limits,
            clock,
        }
    }

    /// Runs it to its end.
    ///
    /// # Errors
    /// Why it cannot be run, as a sentence.
    pub(super) fn run(&self, host: &dyn Host) -> Result<Ran, String> {
        let begin = host.wall_seconds();
        let before = usage::own_peak();
        let mut child = self.command()?.spawn().map_err(|error| {
            let program = self.words.first().map(|word| word.to_string_lossy());
            format!("{} cannot be run: {error}.", program.unwrap_or_default())
        })?;
        let group = Pid::from_child(&child);
        let guard = Guard::of(group);
        let errors = Errors::read(child.stderr.take());
        let mut most = Usage::default();
        let stop = self.watch(group, begin, &mut most, host);
        // What is left of the group, too. Its first process is not waited for yet, so that
        // no other group can have its number.
        let _ = kill_process_group(group, Signal::KILL);
        drop(guard);
        let used = child
            .wait4()
            .map_err(|error| format!("It cannot be waited for: {error}."))?;
        let ended = stop.map_or(Ended::Exit(used.status), Ended::Stopped);
        let rusage = used.rusage;
        let cpu_seconds = (rusage.utime + rusage.stime).as_secs_f64();
        Ok(Ran {
            ended,
            cpu_seconds: cpu_seconds.max(most.cpu_seconds),
            wall_seconds: host.wall_seconds() - begin,
            peak_bytes: peak(rusage.maxrss, before, most.bytes),
            last_line: errors.last_line(),
        })
    }

    fn command(&self) -> Result<Command, String> {
        let [program, arguments @ ..] = self.words else {
            return Err("There is no command.".to_owned());
        };
        let mut command = Command::new(self.program(Path::new(program))?);
        command
            .args(arguments)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .process_group(0);
        if !self.folder.as_os_str().is_empty() {
            command.current_dir(self.folder);
        }
        Ok(command)
    }

    /// The program: one with a folder in its name starts from the folder in which it runs,
    /// another one is looked for as everywhere.
    fn program(&self, program: &Path) -> Result<PathBuf, String> {
        if program.is_absolute() || program.components().count() < 2 && !program.starts_with(".") {
            return Ok(program.to_owned());
        }
        std::path::absolute(self.folder.join(program))
            .map_err(|error| format!("{} cannot be run: {error}.", program.display()))
    }

    /// Waits until it has ended, or must be. It is not reaped.
    fn watch(&self, group: Pid, begin: f64, most: &mut Usage, host: &dyn Host) -> Option<Stop> {
        let mut nap = FIRST_NAP;
        let mut next_look = begin;
        loop {
            let options = WaitIdOptions::EXITED | WaitIdOptions::NOWAIT | WaitIdOptions::NOHANG;
            if !matches!(
                waitid(WaitId::Pid(group), options),
                Ok(None) | Err(rustix::io::Errno::INTR)
            ) {
                return None;
            }
            if host.cancelled() {
                return Some(Stop::Cancelled);
            }
            let now = host.wall_seconds();
            if now >= next_look {
                let used = usage::of_group(group);
                if let Some(used) = used {
                    most.cpu_seconds = most.cpu_seconds.max(used.cpu_seconds);
                    most.bytes = most.bytes.max(used.bytes);
                }
                let took = host.wall_seconds() - now;
                next_look = now + BETWEEN_LOOKS.max(LOOK_SHARE * took);
                if let Some(stop) = self.exceeded(*most) {
                    return Some(stop);
                }
            }
            if self
                .seconds_on_the_wall()
                .is_some_and(|limit| now - begin >= limit)
            {
                return Some(Stop::Time);
            }
            thread::sleep(nap);
            nap = (nap * 2).min(LAST_NAP);
        }
    }

    /// The limit that what it uses has reached.
    fn exceeded(&self, used: Usage) -> Option<Stop> {
        let Limits {
            seconds,
            memory_bytes,
            ..
        } = self.limits;
        if memory_bytes.is_some_and(|limit| used.bytes > limit) {
            return Some(Stop::Memory);
        }
        let seconds = seconds.filter(|_| self.clock == Clock::Cpu);
        if seconds.is_some_and(|limit| used.cpu_seconds >= limit) {
            return Some(Stop::Time);
        }
        output::is_too_long(self.out).then_some(Stop::Output)
    }

    /// After so many seconds on the wall it is ended, whatever it used.
    fn seconds_on_the_wall(&self) -> Option<f64> {
        let limit = self.limits.seconds?;
        // Elsewhere nothing tells what it uses while it runs.
        let is_of_cpu = self.clock == Clock::Cpu && usage::own_peak().is_some();
        Some(if is_of_cpu {
            WALL_FACTOR * limit + WALL_MORE
        } else {
            limit
        })
    }
}

/// The most memory that a planner held. The system begins the figure of a child with that of
/// its parent: only where it is more it is surely the child's own.
fn peak(told: u64, before: Option<u64>, seen: u64) -> Option<u64> {
    let own = Some(told).filter(|&told| before.is_none_or(|before| told > before));
    own.into_iter().chain((seen > 0).then_some(seen)).max()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_peak_of_a_child_is_not_that_of_its_parent() {
        assert_eq!(peak(50, Some(50), 20), Some(20));
        assert_eq!(peak(50, Some(50), 0), None);
        assert_eq!(peak(60, Some(50), 20), Some(60));
        assert_eq!(peak(60, None, 0), Some(60));
    }
}
