//! The files of a certificate checked again, under the limits of a request.

use giveway_proof::{Budget, Bundle, Claim, Report};

use crate::{Host, Limits, Progress};

/// Checks the files of a certificate again. One that does not hold is no error: its
/// report says so, as does one whose check was stopped.
pub fn verify(files: &Bundle, limits: Limits, host: &dyn Host) -> Report {
    let start = host.wall_seconds();
    let go_on = || {
        let in_time = limits
            .seconds
            .is_none_or(|limit| host.wall_seconds() - start < limit);
        let in_memory = limits
            .memory_bytes
            .is_none_or(|limit| host.memory_bytes() <= limit);
        in_time && in_memory && !host.cancelled()
    };
    let tell = |claim: &Claim| {
        let (claim, checking) = (claim.sentence(), true);
        host.progress(&Progress::Certifying { claim, checking });
    };
    let budget = Budget {
        go_on: &go_on,
        tell: &tell,
        ..Budget::default()
    };
    giveway_proof::verify(files, &budget)
}
