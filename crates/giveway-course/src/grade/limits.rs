//! How much the solver may do for one question of a judge.

use giveway_solve::{Limits, Request};

/// Units of work for a question at first, as [`Limits::work`] counts them: some seconds on
/// the largest boards.
pub const FIRST_WORK: u64 = 4_000_000;
/// How much more each time that undecided tasks are gone on with.
pub(super) const MORE: u64 = 10;

/// The same request with a limit of work alone: its answer depends on no clock.
pub(super) fn limited(mut request: Request, work: u64) -> Request {
    let limits = match &mut request {
        Request::Solve(request) => &mut request.limits,
        Request::Explain(request) => &mut request.limits,
        Request::Audit(request) => &mut request.limits,
        Request::Freedom(request) => &mut request.limits,
        Request::Plan(request) => &mut request.limits,
        Request::Change(request) => &mut request.limits,
        Request::Price(request) => &mut request.limits,
        Request::Delays(request) => &mut request.limits,
        // No judge asks these.
        Request::Check(_)
        | Request::Certify(_)
        | Request::Export(_)
        | Request::Together(_)
        | Request::Order(_)
        | Request::Sizing(_) => return request,
    };
    *limits = Limits {
        work: Some(work),
        ..Limits::default()
    };
    request
}
