//! Which costs count, in their order, and what is proved of them.

use giveway_model::words::{and, grouped};
use giveway_model::{Cost, tr};

use super::{Known, Proved, Subject};

/// The costs of the objective, a sentence each where they are proved, else one for all.
pub(super) fn told(subject: &Subject<'_>, known: &Known) -> Vec<String> {
    let Some(plan) = subject.costs else {
        return Vec::new();
    };
    let costs = subject.instance.objective().costs();
    let least = |(index, &cost): (usize, &Cost)| {
        let (n, cost) = (grouped(plan.get(cost).into()), name(cost));
        match (index, known.proved) {
            (0, Proved::OfThese) => tr!(
                "What counts first is {cost}: {n} is the least of these plans.",
                cost,
                n
            ),
            (0, _) => tr!(
                "What counts first is {cost}: {n} is the least of all plans.",
                cost,
                n
            ),
            _ => tr!("Then {cost}: {n} is the least of those.", cost, n),
        }
    };
    match (known.proved, costs) {
        (_, []) => Vec::new(),
        (Proved::OfAll | Proved::OfThese, _) => costs.iter().enumerate().map(least).collect(),
        (Proved::No, [only]) => vec![tr!("What counts is {cost}.", cost = name(*only))],
        (Proved::No, [first, rest @ ..]) => {
            let rest: Vec<&str> = rest.iter().map(|&cost| name(cost)).collect();
            vec![tr!(
                "What counts first is {cost}, then {others}.",
                cost = name(*first),
                others = and(&rest)
            )]
        }
    }
}

/// What a cost is called within a sentence.
fn name(cost: Cost) -> &'static str {
    match cost {
        Cost::Makespan => tr!("what counts" => "the last arrival"),
        Cost::SumOfCosts => tr!("what counts" => "the sum of costs"),
        Cost::Charges => tr!("what counts" => "the number of charges"),
        Cost::Moves => tr!("what counts" => "the number of moves"),
        Cost::Waits => tr!("what counts" => "the number of waits"),
        Cost::Penalty => tr!("what counts" => "the penalty"),
    }
}
