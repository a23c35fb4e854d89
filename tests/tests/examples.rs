//! The examples of the page keep what their lines promise.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use giveway_model::format::native;
use giveway_model::{Cell, Cost, Instance};
use giveway_solve::price::{Price, PriceRequest};
use giveway_solve::{Request, Response, SilentHost, SolveAnswer, Status, serve};
use giveway_tests::ask;
use giveway_tests::rules_random::KINDS;

/// What is known of an example: its file; makespan, sum of costs and charges of
/// the best plan, or that there is none.
type Promise = (&'static str, Option<[u32; 3]>);

const PROMISES: [Promise; 34] = [
    ("warehouse", Some([18, 35, 3])),
    ("scenario-1", Some([4, 7, 0])),
    ("scenario-6", None),
    ("nine-cells", Some([4, 8, 0])),
    ("siding", Some([10, 19, 0])),
    ("swap", None),
    ("crossing", Some([5, 9, 0])),
    ("roundabout", Some([8, 32, 0])),
    ("ring", Some([1, 8, 0])),
    ("last-in", Some([10, 29, 0])),
    ("door", Some([11, 47, 0])),
    ("short-cut", Some([8, 15, 0])),
    ("detour", Some([15, 30, 1])),
    ("one-charger", Some([13, 35, 3])),
    ("ten-robots", Some([31, 254, 10])),
    ("crowd", Some([11, 132, 0])),
    ("shelves", Some([34, 458, 0])),
    ("random-32", Some([48, 637, 0])),
    ("rooms", Some([47, 569, 0])),
    ("maze", Some([92, 526, 0])),
    ("large-warehouse", Some([174, 3196, 0])),
    ("rule-capacity", Some([10, 23, 0])),
    ("rule-closed", Some([10, 16, 0])),
    ("rule-one-way", Some([11, 18, 0])),
    ("rule-gap", Some([7, 20, 0])),
    ("rule-apart", Some([7, 13, 0])),
    ("rule-sequence", Some([14, 22, 0])),
    ("rule-visit", Some([8, 10, 0])),
    ("rule-arrive", Some([8, 20, 0])),
    ("rule-depart", Some([8, 16, 0])),
    ("rule-before", Some([8, 16, 0])),
    ("rule-no-waiting", Some([7, 15, 0])),
    ("rule-turns", Some([11, 19, 0])),
    ("rule-avoid", Some([8, 16, 0])),
];

/// Examples of one rule each: its kind; makespan and sum of costs of the best plan
/// without it.
const RULES: [(&str, [u32; 2]); 13] = [
    ("capacity", [8, 21]),
    ("closed", [7, 10]),
    ("one-way", [7, 10]),
    ("gap", [6, 17]),
    ("apart", [6, 12]),
    ("sequence", [8, 16]),
    ("visit", [6, 8]),
    ("arrive", [7, 20]),
    ("depart", [5, 9]),
    ("before", [8, 14]),
    ("no-waiting", [7, 14]),
    ("turns", [8, 13]),
    ("avoid", [6, 12]),
];

/// Examples whose lines tell how many waits there are.
const WAITS: [(&str, u32); 5] = [
    ("siding", 1),
    ("crossing", 1),
    ("roundabout", 0),
    ("ring", 0),
    ("shelves", 3),
];

/// The one whose proof takes longer than most will wait.
const OPEN: &str = "thirty-robots";

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../static/examples")
}

fn example(name: &str) -> Instance {
    let text = fs::read_to_string(folder().join(name).with_extension("json")).unwrap();
    native::read_instance(&text).unwrap()
}

fn solved(name: &str) -> SolveAnswer {
    ask::best(&example(name), None)
}

#[test]
fn each_is_solved_as_its_line_says() {
    for (name, expected) in PROMISES {
        let answer = solved(name);
        assert!(answer.reach.is_complete(), "{name}");
        let expected_status = match expected {
            Some(_) => Status::Optimal,
            None => Status::Impossible,
        };
        assert_eq!(answer.status, expected_status, "{name}");
        let costs = answer.costs;
        let found = costs.map(|c| [c.makespan, c.sum_of_costs, c.charges]);
        assert_eq!(found, expected, "{name}");
        if let Some((_, waits)) = WAITS.iter().find(|(waiting, _)| *waiting == name) {
            assert_eq!(costs.map(|c| c.waits), Some(*waits), "{name}");
        }
    }
}

/// Each kind of rule has an example, whose rule is not free.
#[test]
fn each_rule_costs_what_its_line_says() {
    // A late arrival is one of kind `arrive`, with a weight.
    let kinds = KINDS.into_iter().filter(|&kind| kind != "late");
    let seen = RULES.into_iter().map(|(kind, _)| kind);
    assert_eq!(seen.collect::<Vec<_>>(), kinds.collect::<Vec<_>>());
    for (kind, without) in RULES {
        let request = PriceRequest {
            scene: example(&format!("rule-{kind}")).to_scene(),
            ..PriceRequest::default()
        };
        let Response::Priced(answer) = serve(&Request::Price(request), &SilentHost) else {
            panic!("no prices of {kind}");
        };
        let [price] = answer.prices.as_slice() else {
            panic!("{kind}: {:?}", answer.prices);
        };
        assert_eq!((price.kind.as_str(), price.price), (kind, Price::Costs));
        assert!(price.exact, "{kind}");
        let found = [Cost::Makespan, Cost::SumOfCosts].map(|cost| price.without[&cost]);
        assert_eq!(found, without, "{kind}");
    }
}

#[test]
fn each_is_looked_at() {
    let listed: BTreeSet<String> = fs::read_dir(folder())
        .unwrap()
        .map(|file| file.unwrap().path())
        .filter(|path| path.extension().is_some_and(|end| end == "json"))
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .filter(|name| name != "index")
        .collect();
    let looked_at = PROMISES.iter().map(|(name, _)| (*name).to_owned());
    assert_eq!(
        looked_at.chain([OPEN.to_owned()]).collect::<BTreeSet<_>>(),
        listed
    );
}

/// In the roundabout everybody leaves the pillar on the same side.
#[test]
fn the_roundabout_goes_one_way_round() {
    let plan = solved("roundabout").plan.unwrap();
    let pillar = (3_i64, 3_i64);
    let mut turns = BTreeSet::new();
    for path in plan.paths.values() {
        let cells: Vec<Cell> = path.iter().copied().flatten().collect();
        let turn = |pair: &[Cell]| {
            let [a, b] =
                [pair[0], pair[1]].map(|c| (i64::from(c.x) - pillar.0, i64::from(c.y) - pillar.1));
            (a.0 * b.1 - a.1 * b.0).signum()
        };
        turns.extend(cells.windows(2).map(turn).filter(|&turn| turn != 0));
    }
    assert_eq!(turns.len(), 1);
}
