//! Variants of an instance: no check finds a fault in them.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use giveway_model::format::native;
use giveway_model::{Battery, Cell, Instance};

#[test]
fn every_variant_keeps_the_promises_of_an_instance() {
    type Change<'a> = &'a dyn Fn(&mut Instance);
    let whole = native::read_instance(
        r#"{ "giveway": 1, "map": [".#~+", "*..#"], "agents": [
            { "name": "A", "start": [0, 0], "goal": [3, 0], "waypoints": [[2, 0], [1, 1]],
              "battery": { "capacity": 9, "initial": 4 } },
            { "name": "B", "start": [0, 1], "goal": [2, 1] }] }"#,
    )
    .unwrap();
    let cell = Cell::new(2, 0);
    let battery = |capacity, initial| Battery { capacity, initial };
    let changes: [(&str, Change); 11] = [
        ("agents", &|it| it.retain_agents(|agent| agent.name == "B")),
        ("first", &|it| it.truncate_agents(1)),
        ("nobody", &|it| it.truncate_agents(0)),
        ("waypoint", &|it| it.drop_waypoint(0, cell)),
        ("no battery", &|it| it.drop_battery(0)),
        ("battery", &|it| it.replace_battery(1, battery(7, 7))),
        ("too large", &|it| {
            it.replace_battery(0, battery(u32::MAX, u32::MAX));
        }),
        ("too full", &|it| it.replace_battery(0, battery(3, 4))),
        ("vanish", &|it| it.let_agents_vanish()),
        ("map", &|it| {
            it.remove_obstacles(|_| true);
            it.make_normal(|it| it.y == 0);
            it.add_chargers(|it| it.x == 1);
        }),
        ("off the map", &|it| {
            it.drop_waypoint(7, cell);
            it.replace_battery(7, battery(1, 2));
        }),
    ];
    for (what, change) in changes {
        let mut variant = whole.clone();
        change(&mut variant);
        assert_eq!(variant == whole, what == "off the map", "{what}");
        let checked = Instance::new(variant.to_scene());
        assert_eq!(checked, Ok(variant), "{what}");
    }
    assert_eq!(whole.alone("B").unwrap().agents(), &whole.agents()[1..]);
    assert_eq!(whole.alone("C"), None);
}

#[test]
fn a_variant_opens_only_what_it_is_told_to() {
    let text = r#"{ "giveway": 1, "map": [".#~", "*+#"], "agents": [] }"#;
    let mut instance = native::read_instance(text).unwrap();
    instance.add_chargers(|cell| cell.y == 0);
    assert_eq!(instance.grid().rows(), ["+#*", "*+#"]);
    instance.make_normal(|cell| cell.x == 0);
    assert_eq!(instance.grid().rows(), ["+#*", "++#"]);
    instance.remove_obstacles(|cell| cell.y == 1);
    assert_eq!(instance.grid().rows(), ["+#*", "++."]);
}
