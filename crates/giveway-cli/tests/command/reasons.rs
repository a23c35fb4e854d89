//! `giveway explain`: what a minimal set claims, which of its facts help when they
//! alone are left out, and further sets.

use serde_json::{Value, json};

use crate::run::Folder;

/// Two walls, each of which is enough.
pub(crate) const TWO_WALLS: &str = r#"{"giveway": 1, "map": ["..##.."], "agents": [{"name": "A", "start": [0, 0], "goal": [5, 0]}]}"#;
/// A lane with a closed row beside it, in which nine obstacles exclude a plan.
const WALLED: &str = r############"{"giveway": 1, "name": "walled", "map": ["###########", "..........."], "agents": [{"name": "A", "start": [0, 1], "goal": [3, 1]}, {"name": "B", "start": [10, 1], "goal": [1, 1]}, {"name": "C", "start": [8, 1], "goal": [2, 1]}]}"############;
/// R3 cannot reach the charger; R1 and R2 both need it at the same time.
const CHARGER_TOO_FAR: &str = r####"{"giveway": 1, "name": "cannot reach the charger", "map": ["###+###", ".......", "......."], "agents": [{"name": "R1", "start": [0, 1], "goal": [6, 1], "battery": {"capacity": 12, "initial": 5}}, {"name": "R2", "start": [6, 1], "goal": [0, 1], "battery": {"capacity": 12, "initial": 5}}, {"name": "R3", "start": [0, 2], "goal": [6, 2], "battery": {"capacity": 12, "initial": 3}}]}"####;
/// A round trip of as many steps as the battery holds, above a floor.
const RESERVE: &str = r#"{"giveway": 1, "name": "round with a reserve", "map": ["+....", ".###.", "....."], "rules": {"battery_floor": 3}, "agents": [{"name": "R", "start": [0, 0], "goal": [0, 0], "waypoints": [[4, 0], [4, 2]], "battery": {"capacity": 12, "initial": 12}}]}"#;

fn explain(scene: &str, question: &str) -> Value {
    let folder = Folder::with(&[("scene.json", scene)]);
    folder
        .run(&format!("explain scene.json {question} --format json"))
        .json()
}

fn text(scene: &str, question: &str) -> String {
    let folder = Folder::with(&[("scene.json", scene)]);
    folder
        .run(&format!("explain scene.json {question}"))
        .answer()
        .to_owned()
}

/// The facts of the first set, then of each further one, and whether they help.
fn sets(answer: &Value) -> Vec<Vec<(String, Value)>> {
    let core = &answer["core"];
    let further = core["further"].as_array().cloned().unwrap_or_default();
    let facts = |set: &Value| {
        let facts = set["facts"].as_array().unwrap().iter();
        facts
            .map(|fact| {
                (
                    fact["text"].as_str().unwrap().to_owned(),
                    fact["helps"].clone(),
                )
            })
            .collect()
    };
    std::iter::once(core).chain(&further).map(facts).collect()
}

fn fact(text: &str, helps: bool) -> (String, Value) {
    (text.to_owned(), json!(helps))
}

/// The kinds of facts of the first set.
fn kinds(answer: &Value) -> Vec<&str> {
    let facts = answer["core"]["facts"].as_array().unwrap().iter();
    facts.map(|fact| fact["kind"].as_str().unwrap()).collect()
}

#[test]
fn of_two_walls_both_are_named_and_neither_helps() {
    let task = || fact("A must go from (0, 0) to (5, 0)", true);
    let mut walls = sets(&explain(TWO_WALLS, "unsolvable"));
    walls.sort_by_key(|set| set[1].0.clone());
    assert_eq!(
        walls,
        [
            [task(), fact("(2, 0) is an obstacle", false)],
            [task(), fact("(3, 0) is an obstacle", false)],
        ]
    );
    let said = text(TWO_WALLS, "unsolvable");
    assert!(
        said.contains("A must go from (0, 0) to (5, 0) (without it there is a plan)."),
        "{said}"
    );
    let claim = "These facts alone rule it out, and each of them is needed for that. \
                 Leaving out only the other one does not help, since other facts rule it out, too.";
    assert_eq!(said.matches(claim).count(), 2, "{said}");
    assert!(!said.contains("becomes possible"), "{said}");
}

#[test]
fn facts_that_help_have_a_mark_and_obstacles_are_joined() {
    let answer = explain(WALLED, "unsolvable");
    let sets = sets(&answer);
    assert_eq!(sets.len(), 1, "one obstacle less is enough");
    for x in 1..=9 {
        let obstacle = fact(&format!("({x}, 0) is an obstacle"), (2..=8).contains(&x));
        assert!(sets[0].contains(&obstacle), "{obstacle:?}");
    }
    let words = answer["words"].as_str().unwrap();
    let joined = "(1, 0) to (9, 0) are obstacles";
    assert!(words.contains(joined), "{words}");
    assert!(!words.contains("(3, 0) is an obstacle"), "{words}");
}

#[test]
fn where_no_fact_helps_the_next_cause_is_given() {
    let sets = sets(&explain(CHARGER_TOO_FAR, "unsolvable"));
    assert_eq!(
        sets[0],
        [
            fact("R3 must go from (0, 2) to (6, 2)", false),
            fact("the battery of R3 holds 12 and starts at 3", false),
        ]
    );
    assert_eq!(sets.len(), 2);
    for text in [
        "the battery of R1 holds 12 and starts at 5",
        "the battery of R2 holds 12 and starts at 5",
        "R1 and R2 must not collide",
    ] {
        assert!(sets[1].contains(&fact(text, false)), "{text}");
    }
}

#[test]
fn two_batteries_are_two_causes() {
    let scene = r#####"{ "giveway": 1, "map": ["....", "####", "...."], "agents": [
        { "name": "A", "start": [0, 0], "goal": [3, 0], "battery": { "capacity": 9, "initial": 2 } },
        { "name": "B", "start": [0, 2], "goal": [3, 2], "battery": { "capacity": 9, "initial": 2 } }] }"#####;
    let mut causes = sets(&explain(scene, "unsolvable"));
    causes.sort_by_key(|set| set[1].0.clone());
    let of = |name: &str, y: u32| {
        [
            fact(&format!("{name} must go from (0, {y}) to (3, {y})"), false),
            fact(
                &format!("the battery of {name} holds 9 and starts at 2"),
                false,
            ),
        ]
    };
    assert_eq!(causes, [of("A", 0), of("B", 2)]);
}

#[test]
fn two_pairs_that_swap_are_two_causes() {
    let scene = r####"{ "giveway": 1, "map": ["...", "###", "###", "..."], "agents": [
        { "name": "A", "start": [0, 0], "goal": [2, 0] }, { "name": "B", "start": [2, 0], "goal": [0, 0] },
        { "name": "C", "start": [0, 3], "goal": [2, 3] }, { "name": "D", "start": [2, 3], "goal": [0, 3] }] }"####;
    let causes = sets(&explain(scene, "unsolvable"));
    assert_eq!(causes.len(), 2);
    assert!(causes[0].iter().all(|fact| !causes[1].contains(fact)));
    assert!(
        causes
            .iter()
            .flatten()
            .all(|(_, helps)| *helps == json!(false))
    );
}

#[test]
fn two_bars_across_the_way_are_two_causes() {
    let scene = r#"{ "giveway": 1, "map": [".#.#.", ".#.#."], "agents": [
        { "name": "A", "start": [0, 0], "goal": [4, 0] }] }"#;
    let mut bars = sets(&explain(scene, "unsolvable"));
    bars.sort_by_key(|set| set[1].0.clone());
    let bar = |x: u32| {
        let task = fact("A must go from (0, 0) to (4, 0)", true);
        let [one, other] = [0, 1].map(|y| fact(&format!("({x}, {y}) is an obstacle"), false));
        [task, one, other]
    };
    assert_eq!(bars, [bar(1), bar(3)]);
}

#[test]
fn the_battery_floor_is_a_fact() {
    let answer = explain(RESERVE, "unsolvable");
    assert_eq!(kinds(&answer), ["task", "waypoint", "battery", "floor"]);
    assert!(sets(&answer)[0].contains(&fact("no battery may fall below 3", true)));
    let said = text(RESERVE, "unsolvable");
    assert!(
        said.contains("Without any one of them there is a plan."),
        "{said}"
    );
}

#[test]
fn the_battery_floor_is_a_fact_beside_a_charger_too() {
    let scene = r#"{ "giveway": 1, "map": ["..+...."], "rules": { "battery_floor": 2 }, "agents": [
        { "name": "A", "start": [0, 0], "goal": [6, 0], "battery": { "capacity": 4, "initial": 4 } }] }"#;
    assert_eq!(
        kinds(&explain(scene, "unsolvable")),
        ["task", "battery", "floor"]
    );
}

#[test]
fn the_battery_floor_is_a_fact_of_a_question() {
    let scene = r#"{ "giveway": 1, "map": ["..+..."], "rules": { "battery_floor": 1 }, "agents": [
        { "name": "A", "start": [0, 0], "goal": [5, 0], "battery": { "capacity": 5, "initial": 5 } }] }"#;
    let answer = explain(scene, "charge A");
    assert_eq!(answer["verdict"], "necessary");
    assert_eq!(kinds(&answer), ["battery", "floor"]);
}

#[test]
fn without_a_battery_the_floor_is_no_fact() {
    let scene = r#"{ "giveway": 1, "map": ["..#.."], "rules": { "battery_floor": 3 }, "agents": [
        { "name": "A", "start": [0, 0], "goal": [4, 0] }] }"#;
    assert_eq!(kinds(&explain(scene, "unsolvable")), ["task", "obstacle"]);
}
