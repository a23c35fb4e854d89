//! The last line that a planner says on standard error.

use std::io::Read;
use std::process::ChildStderr;
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::Duration;

/// So many bytes at the end are kept.
const KEPT: usize = 2000;
/// So many letters of a line are told.
const TOLD: usize = 200;
/// So often, and so long each time, the rest is waited for once the planner has ended.
const LOOKS: u32 = 20;
const LOOK: Duration = Duration::from_millis(5);

/// What a planner says on standard error, read in a thread: however much it is, the planner
/// never waits for a reader.
pub(super) struct Errors {
    last: Arc<Mutex<Vec<u8>>>,
    reader: Option<JoinHandle<()>>,
}

impl Errors {
    pub(super) fn read(stderr: Option<ChildStderr>) -> Self {
        let last = Arc::new(Mutex::new(Vec::new()));
        let kept = Arc::clone(&last);
        let reader = stderr.map(|mut stderr| {
            thread::spawn(move || {
                let mut bytes = [0; 4096];
                while let Ok(length @ 1..) = stderr.read(&mut bytes) {
                    if let (Ok(mut kept), Some(new)) = (kept.lock(), bytes.get(..length)) {
                        kept.extend_from_slice(new);
                        let over = kept.len().saturating_sub(KEPT);
                        kept.drain(..over);
                    }
                }
            })
        });
        Self { last, reader }
    }

    /// The last line that is not empty. A process that left the group may hold the other
    /// end for ever, so nobody waits long for it.
    pub(super) fn last_line(self) -> Option<String> {
        for _ in 0..LOOKS {
            if self.reader.as_ref().is_none_or(JoinHandle::is_finished) {
                break;
            }
            thread::sleep(LOOK);
        }
        let bytes = self.last.lock().ok()?;
        let text = String::from_utf8_lossy(&bytes);
        let line = text.lines().map(str::trim).rfind(|line| !line.is_empty())?;
        let is_text = |c: &char| !c.is_control();
        Some(line.chars().filter(is_text).take(TOLD).collect())
    }
}
