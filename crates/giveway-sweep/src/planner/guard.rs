//! Ends a planner whose sweep is gone.
//!
//! A planner has a process group of its own, so that all of it can be killed. The price:
//! nothing ends it when the sweep itself is killed, by a second Ctrl-C or by a cluster. So a
//! small shell waits at a pipe beside it. When the sweep is gone, the system closes the
//! other end, and the shell kills the group.

use std::os::unix::process::CommandExt;
use std::process::{Child, Command, Stdio};

use rustix::process::Pid;

/// What the shell does: it reads until the pipe is closed. This is how POSIX writes it; with
/// `-KILL` some shells take no `--`.
const SCRIPT: &str = "read -r line; kill -s KILL -- \"-$1\"";

/// The shell that waits beside a planner; it ends when this is dropped.
pub(super) struct Guard(Option<Child>);

impl Guard {
    /// Guards a process group. Without a shell there is no guard, and the planner runs all
    /// the same.
    pub(super) fn of(group: Pid) -> Self {
        let mut shell = Command::new("/bin/sh");
        shell
            .args(["-c", SCRIPT, "sh", &group.as_raw_pid().to_string()])
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .process_group(0);
        Self(shell.spawn().ok())
    }
}

impl Drop for Guard {
    /// The shell is killed before its pipe is closed. Drop it before the planner is waited
    /// for: until then no other group has the number of the planner's.
    fn drop(&mut self) {
        if let Some(mut shell) = self.0.take() {
            let pipe = shell.stdin.take();
            let _ = shell.kill();
            let _ = shell.wait();
            drop(pipe);
        }
    }
}
