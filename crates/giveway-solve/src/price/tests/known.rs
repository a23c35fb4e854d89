//! Prices of which a front knows a part.

use giveway_model::{Cost, Costs, Objective, Plan};

use super::{price, prices, scene};
use crate::price::{
    KnownPrices, Price, PriceRequest, RulePrice, compared::known_so_far, serve, words::tag,
};
use crate::{Request, Response, SilentHost, SolveAnswer, SolveRequest, Status};

/// What a front knows already is not looked for again, and changes no price.
#[test]
fn what_is_known_is_not_looked_for_again() {
    let rules = r#"{ "kind": "capacity", "zone": "aisle", "most": 1 },
                   { "kind": "closed", "zone": "aisle", "from": 90 }"#;
    let first = price(rules);
    let solve = SolveRequest {
        scene: scene(rules),
        ..SolveRequest::default()
    };
    let Response::Solved(best) = crate::serve(&Request::Solve(solve), &SilentHost) else {
        panic!("no plan");
    };
    let again = |known: KnownPrices| {
        let request = PriceRequest {
            scene: scene(rules),
            known: Some(Box::new(known)),
            ..PriceRequest::default()
        };
        serve(&request, &SilentHost).unwrap()
    };
    let all = again(KnownPrices {
        with: Some(best.clone()),
        plans: Vec::new(),
        prices: first.prices.clone(),
    });
    assert_eq!(all.prices, first.prices);
    assert_eq!((all.costs, all.words), (first.costs, first.words.clone()));
    assert!(first.stats.work > 0);
    assert_eq!(all.stats.work, 0, "nothing was left to find out");

    // An open price goes on; a plan that breaks a rule, or other costs, are no proof.
    let mut open = first.prices.clone();
    open[0] = RulePrice {
        price: Price::Unknown,
        exact: false,
        ..open[0].clone()
    };
    let mut wrong = best.clone();
    wrong.costs = wrong.costs.map(|costs| Costs {
        makespan: costs.makespan - 1,
        ..costs
    });
    let told = again(KnownPrices {
        with: Some(wrong),
        plans: Vec::new(),
        prices: open,
    });
    assert_eq!(prices(&told), prices(&first));
    assert_eq!(told.costs, first.costs);
    assert!(told.stats.work > 0);
}

/// A plan that a front knows of is where the search without a rule begins; plans that break another
/// rule are not.
#[test]
fn plans_that_are_known_begin_the_search() {
    let rule = r#"{ "kind": "capacity", "zone": "aisle", "most": 1 }"#;
    let first = price(rule);
    let best = first.prices[0].plan.clone().unwrap();
    let solved = SolveAnswer {
        plan: first.plan.clone(),
        costs: first.costs,
        status: Status::Optimal,
        ..answer_of(rule)
    };
    let told = |plans: Vec<Plan>| {
        let mut request = PriceRequest {
            scene: scene(rule),
            known: Some(Box::new(KnownPrices {
                with: Some(solved.clone()),
                plans,
                prices: Vec::new(),
            })),
            ..PriceRequest::default()
        };
        request.limits.work = Some(1);
        serve(&request, &SilentHost).unwrap().prices.remove(0)
    };
    // The work is not enough for a search.
    assert_eq!(told(Vec::new()).plan, first.plan, "no better one is known");
    let price = told(vec![Plan::default(), best.clone()]);
    assert_eq!(price.plan, Some(best));
    assert_eq!(price.price, Price::Unknown);
}

fn answer_of(rules: &str) -> SolveAnswer {
    let solve = SolveRequest {
        scene: scene(rules),
        ..SolveRequest::default()
    };
    match crate::serve(&Request::Solve(solve), &SilentHost) {
        Response::Solved(answer) => answer,
        _ => panic!("no plan"),
    }
}

/// The range of a price is one of the first cost in which both sides are not proved equal.
#[test]
fn the_range_is_of_the_cost_that_is_open() {
    let objective: Objective = "makespan,sum-of-costs".parse().unwrap();
    let side = |makespan: [u32; 2], sum: [u32; 2]| SolveAnswer {
        status: Status::Feasible,
        costs: Some(Costs {
            makespan: makespan[1],
            sum_of_costs: sum[1],
            ..Costs::default()
        }),
        bounds: [(Cost::Makespan, makespan[0]), (Cost::SumOfCosts, sum[0])].into(),
        ..answer_of("")
    };
    let range = |with: &SolveAnswer, without: &SolveAnswer| known_so_far(&objective, with, without);
    let (with, without) = (side([86, 86], [1002, 1002]), side([86, 86], [990, 1000]));
    let sum = Some(Cost::SumOfCosts);
    assert_eq!(range(&with, &without), (sum, Some(2), Some(12)));
    let longer = side([86, 88], [990, 1000]);
    assert_eq!(range(&with, &longer), (None, Some(0), Some(0)));
    assert_eq!(
        range(&side([90, 90], [9, 9]), &longer),
        (None, Some(2), Some(4))
    );
    let price = RulePrice {
        range_of: sum,
        at_least: Some(2),
        at_most: Some(12),
        price: Price::Unknown,
        ..price(r#"{ "kind": "gap", "steps": 1 }"#).prices.remove(0)
    };
    assert_eq!(tag(&objective, &price), "costs 2 to 12 steps in all");
}
