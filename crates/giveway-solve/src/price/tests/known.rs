//! Prices of which a front knows a part.

use giveway_model::Costs;

use super::{price, prices, scene};
use crate::price::{KnownPrices, Price, PriceRequest, RulePrice, serve};
use crate::{Request, Response, SilentHost, SolveRequest};

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
        prices: open,
    });
    assert_eq!(prices(&told), prices(&first));
    assert_eq!(told.costs, first.costs);
    assert!(told.stats.work > 0);
}
