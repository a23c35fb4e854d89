//! What sets of robots alone need, as sentences.

use giveway_model::words::{and, name};
use giveway_model::{Cost, tr};

use crate::explain::SubsetBound;

/// What a set of robots alone needs, as a sentence.
///
/// ```
/// use giveway_model::Cost;
/// use giveway_solve::explain::{SubsetBound, alone_sentence};
/// let bound = SubsetBound {
///     agents: vec!["A1".into(), "A14".into()],
///     cost: Cost::SumOfCosts, own: 100, least: 106, here: 109,
/// };
/// assert_eq!(
///     alone_sentence(&bound),
///     "These 2 robots alone lose 6 of the 9 steps that they lose here: A1 and A14."
/// );
/// ```
pub fn alone_sentence(bound: &SubsetBound) -> String {
    let robots = and(&bound.agents);
    match (bound.cost, bound.agents.as_slice()) {
        (Cost::Makespan, [agent]) => tr!(
            "{agent} alone needs {n} step." | "{agent} alone needs {n} steps." % bound.least,
            agent
        ),
        (Cost::Makespan, _) => tr!(
            "{robots} alone need {n} step." | "{robots} alone need {n} steps." % bound.least,
            robots
        ),
        (Cost::SumOfCosts, [_, _, ..]) if bound.least > bound.own => tr!(
            "These {count} robots alone lose {lost} of the {here} steps that they lose here: {robots}.",
            count = bound.agents.len(),
            lost = bound.lost(),
            here = bound.here.saturating_sub(bound.own),
            robots
        ),
        (Cost::SumOfCosts | Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty, _) => tr!(
            "Of {robots} alone, the {cost} is at least {least}; here it is {here}.",
            robots,
            cost = name(bound.cost),
            least = bound.least,
            here = bound.here
        ),
    }
}

/// The sentences of an answer about what sets of robots alone need: the first set, and that no
/// small reason was found where there is none.
pub(crate) fn alone(bounds: &[SubsetBound], has_core: bool) -> Vec<String> {
    let first = bounds.first().map(alone_sentence);
    let no_core = tr!("No small reason was found yet.").to_owned();
    let no_core = (!has_core && first.is_some()).then_some(no_core);
    no_core.into_iter().chain(first).collect()
}
