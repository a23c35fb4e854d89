//! Ctrl-C: the first one ends a search, whose best plan is then told; the second one ends the
//! command at once.

use std::process;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::exit::Exit;

/// Whether Ctrl-C was pressed while something could still be told.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Listens to Ctrl-C from now on. Where that is not possible, it ends the command at once, as
/// it does before.
pub(crate) fn listen() {
    let _ = ctrlc::set_handler(|| {
        if heard(&INTERRUPTED) == Heard::End {
            process::exit(Exit::Interrupted.code().into());
        }
    });
}

/// Whether Ctrl-C was pressed.
pub(crate) fn happened() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}

/// What a Ctrl-C asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Heard {
    /// The search ends, and its best plan is told.
    Stop,
    /// All ends at once.
    End,
}

fn heard(interrupted: &AtomicBool) -> Heard {
    if interrupted.swap(true, Ordering::Relaxed) {
        Heard::End
    } else {
        Heard::Stop
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_one_ends_at_once() {
        let interrupted = AtomicBool::new(false);
        assert_eq!(heard(&interrupted), Heard::Stop);
        assert!(interrupted.load(Ordering::Relaxed));
        assert_eq!(heard(&interrupted), Heard::End);
        assert_eq!(heard(&interrupted), Heard::End);
    }
}
