//! What holds in the plan itself and in another one.

use giveway_model::check::check;
use giveway_model::format::native;
use giveway_model::question::holds;
use giveway_model::{Instance, Plan};

use super::{instance, plan, question};

/// A1 goes through at once and charges at the end; A2 steps aside and back, so
/// that it arrives late.
fn other() -> Plan {
    native::read_plan(
        r#"{ "giveway": 1, "charges": { "A1": [0, 4] }, "paths": {
            "A1": [[0, 0], [1, 0], null, [2, 0], [3, 0], [3, 1], [3, 0]],
            "A2": [[3, 1], [2, 1], [1, 1], [0, 1], [0, 0], [0, 1]] } }"#,
    )
    .unwrap()
}

#[track_caller]
fn judged(words: &str, instance: &Instance, other: &Plan) -> bool {
    holds(&question(words), instance, &plan(), other).unwrap()
}

/// In the plan itself what is asked about is so: no contrast holds. In the
/// other one it does, or not.
#[test]
fn each_kind() {
    let instance = instance();
    assert!(check(&instance, &plan()).is_valid());
    assert!(check(&instance, &other()).is_valid());
    for (words, there) in [
        ("wait A1", true),
        ("wait A1 --at 0,0", true),
        ("wait A1 --at 0,0 --from 0 --to 1", true),
        ("wait A1 --from 1 --to 2", true),
        ("wait A1 --at-least 2", true),
        ("wait A2 --at 2,1", true),
        ("charge A1", false),
        ("charge A1 --at 0,0", false),
        ("charge A1 --at 0,0 --time 1", true),
        ("no-charge A1 --at 3,0", true),
        ("visit A1 --at 0,0 --time 2", true),
        ("visit A1 --at 1,0", false),
        ("visit A1 --at 3,0 --time 6", false),
        ("visit A2 --at 0,1 --time 4", true),
        ("visit A2 --at 0,1 --time 6", false),
        ("no-visit A1 --at 3,1", true),
        ("no-visit A1 --at 2,1", false),
        ("no-visit A2 --at 0,0", true),
        ("move A1 --from-cell 0,0 --to-cell 1,0", false),
        ("move A1 --from-cell 0,0 --to-cell 1,0 --time 2", true),
        ("no-move A1 --from-cell 0,0 --to-cell 1,0 --time 0", true),
        ("no-move A1 --from-cell 1,0 --to-cell 2,0 --time 1", true),
        ("no-move A1 --from-cell 2,0 --to-cell 1,0", false),
        ("slow A1", false),
        ("slow A1 --from-cell 2,0 --to-cell 1,0", false),
        ("order A1 --first 1,0 --second 2,0", false),
        ("order A1 --first 0,0 --second 1,0", false),
        ("arrival A1", false),
        ("arrival A2", false),
        ("length A1", false),
        ("length A2 --fewer-than 3", false),
        ("makespan", false),
        ("sum-of-costs", false),
        ("charges A1", false),
        ("charges", false),
        ("moves A2", false),
        ("waits", true),
        ("waits A2", true),
    ] {
        assert!(!judged(words, &instance, &plan()), "{words} in the plan");
        assert_eq!(judged(words, &instance, &other()), there, "{words}");
    }
}

#[test]
fn an_interval_holds_whole_steps() {
    let instance = instance();
    for (words, contrast) in [
        ("wait A1 --from 0 --to 2 --at-least 2", false),
        ("wait A1 --from 0 --to 2 --at-least 3", true),
        ("wait A1 --from 1 --to 9 --at-least 2", true),
        ("wait A1 --from 2 --to 9", true),
        ("wait A2 --from 2 --to 3", true),
        ("wait A2 --from 1 --to 2", false),
    ] {
        assert_eq!(judged(words, &instance, &plan()), contrast, "{words}");
    }
}

#[test]
fn who_gives_way() {
    let instance = native::read_instance(
        r#"{ "giveway": 1, "map": ["...", "..."], "agents": [
            { "name": "A", "start": [0, 0], "goal": [2, 0] },
            { "name": "B", "start": [2, 0], "goal": [1, 1] } ] }"#,
    )
    .unwrap();
    let read = |paths: &str| {
        native::read_plan(&format!(r#"{{ "giveway": 1, "paths": {paths} }}"#)).unwrap()
    };
    let yields = read(r#"{ "A": [[0,0],[0,0],[1,0],[2,0]], "B": [[2,0],[1,0],[1,1]] }"#);
    let first = read(r#"{ "A": [[0,0],[1,0],[0,0]], "B": [[2,0],[2,0],[1,0],[1,1]] }"#);
    let never = read(r#"{ "A": [[0,0]], "B": [[2,0],[1,0],[1,1]] }"#);
    let why = question("yield A B --at 1,0");
    for (other, contrast) in [(&yields, false), (&first, true), (&never, false)] {
        assert_eq!(holds(&why, &instance, &yields, other), Some(contrast));
    }
    let other_way = question("yield B A --at 1,0");
    assert_eq!(holds(&other_way, &instance, &first, &never), Some(true));
}

#[test]
fn resting_is_being_there_only_where_agents_stay() {
    let stays = instance();
    let mut scene = stays.to_scene();
    scene.rules.at_goal = giveway_model::AtGoal::Vanish;
    let vanishes = Instance::new(scene).unwrap();
    let why = "visit A2 --at 0,1 --time 9";
    assert!(!judged(why, &stays, &plan()));
    assert!(judged(why, &vanishes, &plan()));
    assert!(!judged("visit A2 --at 0,1 --time 4", &vanishes, &plan()));
}

#[test]
fn no_contrast() {
    let instance = instance();
    for words in ["unsolvable", "plan", "arrival A9"] {
        let judged = holds(&question(words), &instance, &plan(), &plan());
        assert_eq!(judged, None, "{words}");
    }
}
