//! Which costs count, in their order, and what is proved of them.

use giveway_model::words::grouped;
use giveway_model::{Cost, Costs, tr};

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
        (Proved::Bounded, _) => open(&plan, costs, &known.bounds),
        (Proved::No, _) => open(&plan, costs, &[]),
    }
}

/// The costs of a plan of which not all is proved: a sentence for each of which something is
/// known, then the rest.
fn open(plan: &Costs, costs: &[Cost], bounds: &[(Cost, u32)]) -> Vec<String> {
    // That nothing costs less than nothing need not be said.
    let says = |&&(of, least): &&(Cost, u32)| least > 0 || plan.get(of) == 0;
    let bound = |cost: Cost| {
        let mut bounds = bounds.iter().filter(says);
        bounds.find(|(of, _)| *of == cost)
    };
    let bounded = costs.iter().take_while(|cost| bound(**cost).is_some());
    let mut told = Vec::new();
    for (index, &cost) in bounded.enumerate() {
        let (n, least) = (plan.get(cost), bound(cost).map_or(0, |&(_, least)| least));
        let is_least = n == least;
        let (n, least, cost) = (grouped(n.into()), grouped(least.into()), name(cost));
        told.push(match (index, is_least) {
            (0, true) => tr!(
                "What counts first is {cost}: {n} is proved to be the least.",
                cost,
                n
            ),
            (0, false) => tr!(
                "What counts first is {cost}: {n}, where less than {least} is proved impossible.",
                cost,
                n,
                least
            ),
            (_, true) => tr!(
                "Then {cost}: {n} is proved to be the least with that.",
                cost,
                n
            ),
            (_, false) => tr!(
                "Then {cost}: {n}, where less than {least} is proved impossible.",
                cost,
                n,
                least
            ),
        });
        if !is_least {
            break;
        }
    }
    let rest: Vec<&str> = costs
        .iter()
        .skip(told.len())
        .map(|&cost| name(cost))
        .collect();
    match (told.is_empty(), rest.as_slice()) {
        (_, []) => {}
        (true, [only]) => told.push(tr!("What counts is {cost}.", cost = only)),
        (true, [first, others @ ..]) => told.push(tr!(
            "What counts first is {cost}, then {others}.",
            cost = first,
            others = in_order(others)
        )),
        (false, others) => told.push(tr!("Then {others}.", others = in_order(others))),
    }
    told
}

/// Costs that count one after the other.
fn in_order(costs: &[&str]) -> String {
    costs.join(tr!("between costs that count in this order" => ", then "))
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
