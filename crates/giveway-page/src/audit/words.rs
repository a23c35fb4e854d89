//! The status of a plan of elsewhere, in one sentence.

use giveway_model::words::capital;
use giveway_model::{Cost, tr};

use super::Audit;
use crate::words::{Badge, value, values};

/// Its badge.
pub(crate) fn badge(audit: &Audit) -> Badge {
    if audit.plan.is_legal() {
        Badge::Legal
    } else {
        Badge::Illegal
    }
}

/// `paths.txt breaks rules 3 times. As it stands it would cost 79.`
pub(crate) fn sentence(audit: &Audit) -> String {
    let (plan, file) = (&audit.plan, &audit.plan.file.file);
    let objective = audit.objective();
    let costs = plan.answer.solved.costs;
    if plan.is_legal() {
        let costs = costs.map_or_else(String::new, |costs| capital(&values(objective, &costs)));
        return tr!("{file} keeps every rule. {costs}.", file, costs);
    }

    let first = objective.costs().first().copied();
    let cost = costs.zip(first).map_or_else(String::new, |(costs, first)| {
        let n = costs.get(first);
        match first {
            Cost::SumOfCosts => tr!(" As it stands it would cost {n}.", n),
            _ => tr!(
                " As it stands it would have {value}.",
                value = value(first, n)
            ),
        }
    });
    let times = plan.violations.len();
    tr!(
        "{file} breaks a rule once.{cost}" | "{file} breaks rules {n} times.{cost}" % times,
        file,
        cost
    )
}
