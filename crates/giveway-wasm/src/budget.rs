//! What a request may use where it says nothing.

use giveway_solve::Request;

/// Bytes of linear memory up to which a request may make it grow, where it does
/// not say so itself.
///
/// Linear memory never shrinks, and the last growth before a request notices
/// may nearly double it. So this is well under half of what a tab can stand.
pub const MEMORY_BYTES: u64 = 224 << 20;

/// The request with the default memory limit where it has none.
pub(crate) fn within_budget(mut request: Request) -> Request {
    let limits = match &mut request {
        Request::Solve(solve) => &mut solve.limits,
        Request::Explain(explain) => &mut explain.limits,
        Request::Certify(certify) => &mut certify.limits,
        Request::Export(export) => &mut export.limits,
        Request::Change(change) => &mut change.limits,
        Request::Audit(audit) => &mut audit.limits,
        Request::Plan(plan) => &mut plan.limits,
        Request::Together(together) => &mut together.limits,
        Request::Freedom(freedom) => &mut freedom.limits,
        Request::Price(price) => &mut price.limits,
        Request::Delays(delays) => &mut delays.limits,
        Request::Order(order) => &mut order.limits,
        Request::Sizing(sizing) => &mut sizing.limits,
        Request::Check(_) => return request,
    };
    limits.memory_bytes.get_or_insert(MEMORY_BYTES);
    request
}
