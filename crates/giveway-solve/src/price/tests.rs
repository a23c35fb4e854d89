//! Prices of small scenes, and which rules exclude each other.

mod known;

use giveway_model::{Cost, Scene, format::native};

use super::{Loosened, Price, PriceAnswer, PriceRequest, serve};
use crate::{SilentHost, Status};

fn scene(rules: &str) -> Scene {
    let text = format!(
        r##"{{ "giveway": 1, "map": ["...", "#.#", "..."],
            "agents": [{{ "name": "A1", "start": [0, 0], "goal": [0, 2] }},
                       {{ "name": "A2", "start": [2, 0], "goal": [2, 2] }}],
            "zones": [{{ "name": "aisle", "rect": [1, 0, 1, 2] }}], "constraints": [{rules}] }}"##
    );
    native::read_scene(&text).unwrap()
}

fn price(rules: &str) -> PriceAnswer {
    let request = PriceRequest {
        scene: scene(rules),
        ..PriceRequest::default()
    };
    serve(&request, &SilentHost).unwrap()
}

fn prices(answer: &PriceAnswer) -> Vec<(u32, Price, bool)> {
    let prices = answer.prices.iter();
    prices.map(|it| (it.index, it.price, it.exact)).collect()
}

#[test]
fn a_rule_costs_what_the_best_plan_without_it_saves() {
    let answer = price(
        r#"{ "kind": "capacity", "zone": "aisle", "most": 1 },
           { "kind": "closed", "zone": "aisle", "from": 90 },
           { "kind": "gap", "steps": 1, "off": true }"#,
    );
    assert_eq!(answer.status, Status::Optimal);
    assert_eq!(
        prices(&answer),
        [(0, Price::Costs, true), (1, Price::Free, true)]
    );
    let first = &answer.prices[0];
    // Alone in the aisle: 3 steps later than right behind the other.
    assert_eq!(first.without[&Cost::Makespan], 5);
    assert_eq!(first.difference[&Cost::Makespan], 2);
    let with = answer.costs.unwrap().makespan;
    assert_eq!(with, 7);
    assert_eq!(answer.conflict, None);
    assert_eq!(
        answer.words,
        "At most 1 robot in 'aisle': costs 2 steps of the makespan. No robot in 'aisle' from 90 on: costs nothing."
    );
}

#[test]
fn rules_that_exclude_each_other_are_told_with_the_fewest_to_switch_off() {
    let answer = price(
        r#"{ "kind": "arrive", "by": 5 },
           { "kind": "capacity", "zone": "aisle", "most": 1, "name": "narrow" },
           { "kind": "depart", "from": 1 },
           { "kind": "gap", "steps": 1 }"#,
    );
    assert_eq!(answer.status, Status::Impossible);
    // Three rules each make it take longer than 5 steps; only the deadline decides.
    let all = prices(&answer);
    assert_eq!(all[0], (0, Price::Decides, true));
    assert!(
        all[1..]
            .iter()
            .all(|&(_, price, exact)| (price, exact) == (Price::None, true))
    );
    assert_eq!(answer.switch_off.switch_off, [[0]]);
    assert!(answer.switch_off.switch_off_settled);
    let core = answer.conflict.unwrap();
    let rules: Vec<u32> = core.facts.iter().filter_map(|fact| fact.index).collect();
    assert!(core.minimal);
    assert_eq!(rules.len(), 2, "{rules:?}");
    assert!(rules.contains(&0));
}

#[test]
fn where_rules_do_not_matter_none_is_to_be_switched_off() {
    let mut scene = scene(r#"{ "kind": "gap", "steps": 1 }"#);
    scene.map = vec!["...".into(), "###".into(), "...".into()];
    let request = PriceRequest {
        scene,
        ..PriceRequest::default()
    };
    let answer = serve(&request, &SilentHost).unwrap();
    assert_eq!(prices(&answer), [(0, Price::None, true)]);
    assert_eq!(answer.switch_off.switch_off, Vec::<Vec<u32>>::new());
    assert!(answer.switch_off.switch_off_settled);
    assert!(
        answer
            .words
            .contains("Even without any of these rules there is no plan.")
    );
}

#[test]
fn a_budget_that_is_spent_is_told_as_not_known() {
    let mut request = PriceRequest {
        scene: scene(r#"{ "kind": "gap", "steps": 1 }"#),
        ..PriceRequest::default()
    };
    request.limits.work = Some(1);
    let answer = serve(&request, &SilentHost).unwrap();
    assert_eq!(prices(&answer), [(0, Price::Unknown, false)]);
    assert!(!answer.is_settled());
}

/// The feeder of docs/rules.md.
#[test]
fn the_conflict_of_a_small_scene_is_minimal() {
    let text = r###"{ "giveway": 1,
        "map": [".......", "##.#.##", "##.#.##", "##.#.##", "......."],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [0, 4] },
                   { "name": "A2", "start": [1, 0], "goal": [3, 4] },
                   { "name": "A3", "start": [6, 4], "goal": [5, 0] }],
        "zones": [{ "name": "feeder", "rect": [2, 1, 2, 3] }],
        "constraints": [{ "kind": "capacity", "zone": "feeder", "most": 1, "name": "narrow" },
            { "kind": "one-way", "lane": [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0]] },
            { "kind": "arrive", "by": 8 }] }"###;
    let request = PriceRequest {
        scene: native::read_scene(text).unwrap(),
        ..PriceRequest::default()
    };
    let answer = serve(&request, &SilentHost).unwrap();
    let conflict = answer.conflict.unwrap();
    assert!(conflict.minimal, "{conflict:?}");
    let unknown = |fact: &&crate::explain::Fact| fact.helps == crate::explain::Helps::Unknown;
    assert_eq!(conflict.facts.iter().find(unknown), None, "{conflict:?}");
    assert_eq!(answer.switch_off.switch_off, [vec![0], vec![2]]);
}

fn loosen(scene: Scene, rule: u32) -> (PriceAnswer, Loosened) {
    let request = PriceRequest {
        scene,
        loosen: Some(rule),
        ..PriceRequest::default()
    };
    let answer = serve(&request, &SilentHost).unwrap();
    let loosened = answer.loosened.clone().unwrap();
    (answer, loosened)
}

/// The looser rules, with the first cost and what it saves.
fn looser(loosened: &Loosened) -> Vec<(String, u32, Option<i64>)> {
    let rules = loosened.looser.iter();
    let first = Cost::Makespan;
    rules
        .map(|it| {
            assert!(it.exact && it.least, "{it:?}");
            let saved = it.difference.get(&first).copied();
            (it.rule.sentence(), it.costs[&first], saved)
        })
        .collect()
}

#[test]
fn a_limit_is_loosened_by_the_least_that_changes_the_costs() {
    let rules = r#"{ "kind": "capacity", "zone": "aisle", "most": 0 },
        { "kind": "capacity", "zone": "aisle", "most": 1 }"#;
    let (answer, loosened) = loosen(scene(rules), 1);
    assert_eq!(answer.status, Status::Impossible);
    assert_eq!(answer.prices.len(), 1, "this rule alone is priced");
    assert!(loosened.settled && loosened.looser.is_empty());
    assert!(
        answer
            .words
            .ends_with("No looser form of this rule leaves a plan.")
    );
    let rules = r#"{ "kind": "capacity", "zone": "aisle", "most": 0 }"#;
    let (_, loosened) = loosen(scene(rules), 0);
    let told = looser(&loosened);
    assert_eq!(told, [("At most 1 robot in 'aisle'".to_owned(), 7, None)]);
    let rules = r#"{ "kind": "capacity", "zone": "aisle", "most": 1 }"#;
    let (answer, loosened) = loosen(scene(rules), 0);
    let told = looser(&loosened);
    assert_eq!(
        told,
        [("At most 2 robots in 'aisle'".to_owned(), 5, Some(2))]
    );
    assert!(
        answer.words.contains(
            "Loosened by the least that helps: At most 2 robots in 'aisle'. Then makespan 5"
        ),
        "{}",
        answer.words
    );
}

#[test]
fn times_are_loosened_at_both_ends() {
    let closed = |times: &str| {
        scene(&format!(
            r#"{{ "kind": "closed", "zone": "aisle"{times} }}"#
        ))
    };
    // Without the rule it takes 5 steps, in the aisle from 1 to 4.
    let (answer, loosened) = loosen(closed(r#", "from": 0, "to": 9"#), 0);
    assert_eq!(answer.costs.unwrap().makespan, 14);
    let told = looser(&loosened);
    assert_eq!(
        told,
        [
            ("No robot in 'aisle' up to 8".to_owned(), 13, Some(1)),
            // One of them passes before.
            ("No robot in 'aisle' from 4 to 9".to_owned(), 13, Some(1)),
        ]
    );
    let (answer, loosened) = loosen(closed(""), 0);
    assert_eq!(answer.status, Status::Impossible);
    assert_eq!(loosened.looser.len(), 2, "{loosened:?}");
    assert!(!loosened.looser[0].least, "any end would do");
    let from = &loosened.looser[1];
    assert_eq!(from.rule.sentence(), "No robot in 'aisle' from 5 on");
    assert!(from.least && from.exact);
}

#[test]
fn a_rule_that_is_free_or_only_on_or_off_has_nothing_looser() {
    let (answer, loosened) = loosen(scene(r#"{ "kind": "depart", "from": 0 }"#), 0);
    assert!(!loosened.can_loosen && loosened.settled);
    assert!(
        answer
            .words
            .ends_with("This rule has no number and no times to loosen.")
    );
    let (answer, loosened) = loosen(scene(r#"{ "kind": "arrive", "by": 9 }"#), 0);
    assert!(loosened.can_loosen && loosened.settled && loosened.looser.is_empty());
    assert!(
        answer
            .words
            .ends_with("No looser form of this rule changes the costs.")
    );
    let mut request = PriceRequest {
        scene: scene(r#"{ "kind": "gap", "steps": 2, "off": true }"#),
        loosen: Some(0),
        ..PriceRequest::default()
    };
    assert!(serve(&request, &SilentHost).is_err(), "it is off");
    request.loosen = Some(7);
    assert!(serve(&request, &SilentHost).is_err(), "there is none");
}

#[test]
fn a_spent_budget_leaves_it_open() {
    let mut request = PriceRequest {
        scene: scene(r#"{ "kind": "capacity", "zone": "aisle", "most": 1 }"#),
        loosen: Some(0),
        ..PriceRequest::default()
    };
    request.limits.work = Some(1);
    let answer = serve(&request, &SilentHost).unwrap();
    assert!(
        answer
            .loosened
            .is_none_or(|it| !it.settled && it.looser.is_empty())
    );
}
