//! Pictures as SVG: well formed, the same every time, and true to the plan.
#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    reason = "a test may panic, and what is drawn is compared with what is exact in binary"
)]

use std::collections::BTreeMap;

use giveway_model::format::native;
use giveway_model::{Instance, Plan};
use giveway_picture::{Letters, Look, Looks, Theme, moving, robot, still};
use roxmltree::{Document, Node};

const SCENE: &str = r#"{
    "giveway": 1,
    "name": "a <b> & \"c\"",
    "map": ["..~..", ".#+#.", "....."],
    "agents": [
        { "name": "A1", "start": [0, 0], "goal": [4, 0], "waypoints": [[2, 0]],
          "battery": { "capacity": 9, "initial": 3 } },
        { "name": "</text><script>", "start": [4, 2], "goal": [0, 2] }
    ]
}"#;

const PLAN: &str = r#"{
    "giveway": 1,
    "paths": {
        "A1": [[0, 0], [1, 0], null, [2, 0], [2, 1], [2, 1], [2, 0], null, [3, 0], [4, 0]],
        "</text><script>": [[4, 2], [3, 2], [2, 2], [2, 2], [1, 2], [0, 2]]
    },
    "charges": { "A1": [4] }
}"#;

fn scene() -> (Instance, Plan, Look) {
    let instance = native::read_instance(SCENE).unwrap();
    let plan = native::read_plan(PLAN).unwrap();
    let look = Look::fitting(instance.grid(), 1000);
    (instance, plan, look)
}

/// The groups that stand for agents: those that hold a title, by that.
fn places(svg: &str) -> BTreeMap<String, (f64, f64)> {
    let document = Document::parse(svg).unwrap();
    let titles = document
        .descendants()
        .filter(|node| node.has_tag_name("title"));
    let agents = titles.filter(|title| title.parent().is_some_and(|it| it.has_tag_name("g")));
    let place = |title: Node<'_, '_>| {
        let moved = title.parent().unwrap().parent().unwrap();
        let numbers = moved.attribute("transform").unwrap();
        let numbers = numbers
            .strip_prefix("translate(")
            .unwrap()
            .strip_suffix(')')
            .unwrap();
        let (x, y) = numbers.split_once(' ').unwrap();
        (
            title.text().unwrap().to_owned(),
            (x.parse().unwrap(), y.parse().unwrap()),
        )
    };
    agents.map(place).collect()
}

#[test]
fn agents_are_where_the_plan_has_them() {
    let (instance, plan, look) = scene();
    let at = |time: f64| places(&still(&instance, &plan, time, &look))["A1"];
    assert_eq!(at(0.0), (50.0, 50.0));
    assert_eq!(at(0.5), (100.0, 50.0));
    // Half way along a slow move, and on the charger.
    assert_eq!(at(2.0), (200.0, 50.0));
    assert_eq!(at(4.0), (250.0, 150.0));
    // After the end it stays, and before the start it stands there.
    assert_eq!((at(9.0), at(99.0)), ((450.0, 50.0), (450.0, 50.0)));
    assert_eq!((at(-1.0), at(f64::NAN)), ((50.0, 50.0), (50.0, 50.0)));
    let other = places(&still(&instance, &plan, 2.5, &look))["</text><script>"];
    assert_eq!(other, (250.0, 250.0));
}

/// All that can be drawn of the scene.
fn pictures() -> Vec<String> {
    let (instance, plan, look) = scene();
    let mut pictures = Vec::new();
    for theme in [Theme::Light, Theme::Dark] {
        for letters in [Letters::Text, Letters::Strokes] {
            for cell in [2, 13, 14, 28, 48, 200] {
                let look = Look {
                    theme,
                    cell,
                    letters,
                    ..look.clone()
                };
                pictures.push(moving(&instance, &plan, &look));
                for time in [0.0, 2.0, 2.5, 4.0, 9.0] {
                    pictures.push(still(&instance, &plan, time, &look));
                }
            }
        }
    }
    pictures
}

#[test]
fn all_pictures_are_well_formed_and_hold_no_script() {
    for svg in pictures() {
        let document = Document::parse(&svg).unwrap();
        let root = document.root_element();
        assert_eq!(root.attribute("role"), Some("img"));
        let text = |name: &str| {
            let child = root
                .children()
                .find(|node| node.has_tag_name((root.tag_name().namespace().unwrap(), name)));
            child.unwrap().text().unwrap().to_owned()
        };
        assert!(
            text("title").starts_with("a <b> & \"c\""),
            "{}",
            text("title")
        );
        assert!(text("desc").contains("2 robots on a map of 5 x 3 cells."));
        assert!(
            !document
                .descendants()
                .any(|node| node.tag_name().name() == "script")
        );
        let numbers = svg.replace("linear infinite", "");
        assert!(
            !numbers.contains("NaN") && !numbers.contains("inf"),
            "{svg}"
        );
        // Nothing is fetched from elsewhere.
        let links = svg.replace("http://www.w3.org/2000/svg", "");
        assert!(!links.contains("//") && !links.contains("href"), "{links}");
    }
}

#[test]
fn the_same_plan_gives_the_same_picture() {
    assert_eq!(pictures(), pictures());
}

/// The keys of every animation: its class, and from percent to style.
fn animations(svg: &str) -> BTreeMap<String, Vec<(f64, String)>> {
    let mut all = BTreeMap::new();
    for rule in svg.split("@keyframes ").skip(1) {
        let (name, keys) = rule.split_once('{').unwrap();
        let keys = keys.split_once("}}").unwrap().0;
        let mut read = Vec::new();
        for key in keys.split('}') {
            let (percents, style) = key.split_once('{').unwrap();
            for percent in percents.split(',') {
                let percent = percent.strip_suffix('%').unwrap();
                read.push((percent.parse().unwrap(), style.to_owned()));
            }
        }
        all.insert(name.to_owned(), read);
    }
    all
}

#[test]
fn every_animation_covers_the_whole_plan() {
    let (instance, plan, look) = scene();
    let svg = moving(&instance, &plan, &look);
    let animations = animations(&svg);
    for (name, keys) in &animations {
        assert!(svg.contains(&format!("class=\"{name}\"")), "{name}");
        assert_eq!(keys.first().unwrap().0, 0.0, "{name}: {keys:?}");
        assert_eq!(keys.last().unwrap().0, 100.0, "{name}: {keys:?}");
        let sorted = keys.windows(2).all(|pair| pair[0].0 <= pair[1].0);
        assert!(sorted, "{name}: {keys:?}");
    }
    // A1 starts, is on the charger in the middle, and ends at its goal. Nine steps of
    // 0.48 seconds, 0.6 before and 1.8 after them.
    let seconds = 0.6 + 9.0 * 0.48 + 1.8;
    let percent = |step: f64| (0.6 + step * 0.48) / seconds * 100.0;
    let goes = |keys: &&Vec<(f64, String)>| keys[0].1 == "transform:translate(50px,50px)";
    let keys = animations.values().find(goes).unwrap();
    let at = |step: f64| {
        let near = keys
            .iter()
            .find(|key| (key.0 - percent(step)).abs() < 0.001);
        near.map(|key| key.1.as_str())
    };
    assert_eq!(at(1.0), Some("transform:translate(150px,50px)"));
    assert_eq!(at(4.0), Some("transform:translate(250px,150px)"));
    assert_eq!(at(5.0), Some("transform:translate(250px,150px)"));
    assert_eq!(at(9.0), Some("transform:translate(450px,50px)"));
    // On a straight way there is no key; nor is there one in transit.
    assert_eq!((at(2.0), at(7.0)), (None, None));
    assert_eq!(keys.last().unwrap().1, "transform:translate(450px,50px)");
}

#[test]
fn it_stands_still_for_those_who_want_less_motion() {
    let (instance, plan, look) = scene();
    let svg = moving(&instance, &plan, &look);
    let rule = "@media(prefers-reduced-motion:reduce){";
    let (before, after) = svg.split_once(rule).unwrap();
    assert!(after.contains("{animation:none}"));
    // It is the last rule, so that no other one wins over it.
    assert!(!after.contains("@keyframes") && before.contains("@keyframes"));
    assert_eq!(places(&svg)["A1"], (50.0, 50.0));
}

#[test]
fn a_long_plan_is_a_small_file() {
    let row = ".".repeat(100);
    let scene = format!(
        r#"{{ "giveway": 1, "map": ["{row}", "{row}"], "agents": [
            {{ "name": "A", "start": [0, 0], "goal": [99, 0] }},
            {{ "name": "B", "start": [99, 1], "goal": [0, 1] }}] }}"#
    );
    let path = |y: u32, cells: &mut dyn Iterator<Item = u32>| {
        let cells: Vec<String> = cells.map(|x| format!("[{x},{y}]")).collect();
        cells.join(",")
    };
    let plan = format!(
        r#"{{ "giveway": 1, "paths": {{ "A": [{}], "B": [{}] }} }}"#,
        path(0, &mut (0..100)),
        path(1, &mut (0..100).rev())
    );
    let instance = native::read_instance(&scene).unwrap();
    let plan = native::read_plan(&plan).unwrap();
    let svg = moving(&instance, &plan, &Look::fitting(instance.grid(), 6400));
    assert!(svg.len() < 20_000, "{}", svg.len());
    assert!(animations(&svg).len() < 12);
}

#[test]
fn two_pictures_of_one_page_do_not_share_names() {
    let (instance, plan, look) = scene();
    let dark = Look {
        theme: Theme::Dark,
        ..look.clone()
    };
    let names = |look| {
        let all = animations(&moving(&instance, &plan, look)).into_keys();
        all.collect::<Vec<String>>()
    };
    let other = names(&dark);
    assert!(names(&look).iter().all(|name| !other.contains(name)));
}

#[test]
fn a_plan_that_breaks_rules_is_drawn_as_it_is() {
    let (instance, _, look) = scene();
    for plan in [
        r#"{ "giveway": 1, "paths": {} }"#,
        r#"{ "giveway": 1, "paths": { "A1": [] } }"#,
        r#"{ "giveway": 1, "paths": { "A1": [null, null] } }"#,
        r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [4294967295, 9]], "X": [[1, 1]] }, "charges": { "A1": [7, 3] } }"#,
    ] {
        let plan = native::read_plan(plan).unwrap();
        for svg in [
            still(&instance, &plan, 0.7, &look),
            moving(&instance, &plan, &look),
        ] {
            assert_eq!(places(&svg).len(), 2);
        }
    }
}

#[test]
fn an_agent_is_drawn_with_its_own_look() {
    let (instance, plan, look) = scene();
    let other = Look {
        looks: Looks::from_numbers(vec![7, 8]),
        ..look.clone()
    };
    let ink = |own| robot(look.theme, look.colours, own).0.to_string();
    let (usual, own) = (
        still(&instance, &plan, 0.0, &look),
        still(&instance, &plan, 0.0, &other),
    );
    assert!(usual.contains(&ink(0)) && !usual.contains(&ink(7)));
    assert!(own.contains(&ink(7)) && !own.contains(&ink(0)));
    let moves = moving(&instance, &plan, &other);
    assert!(moves.contains(&ink(7)) && !moves.contains(&ink(0)));
}

/// Names whose letters cannot be drawn without a font: numbers stand for them, each its own.
#[test]
fn letters_that_cannot_be_drawn_become_numbers() {
    let picture = |names: [&str; 3]| {
        let agents = (0..3).zip(names);
        let agents = agents.map(|(x, name)| {
            format!(r#"{{ "name": "{name}", "start": [{x}, 0], "goal": [{x}, 0] }}"#)
        });
        let agents: Vec<String> = agents.collect();
        let scene = format!(
            r#"{{ "giveway": 1, "map": ["..."], "agents": [{}] }}"#,
            agents.join(", ")
        );
        let instance = native::read_instance(&scene).unwrap();
        let mut look = Look::fitting(instance.grid(), 1000);
        look.letters = Letters::Strokes;
        let svg = still(&instance, &Plan::default(), 0.0, &look);
        let shapes = svg.split("<path transform=").skip(1);
        shapes
            .map(|shape| shape.split("/>").next().unwrap().to_owned())
            .collect::<Vec<_>>()
    };
    let numbers = picture(["1", "2", "3"]);
    assert_eq!(picture(["\u{8f66}1", "\u{410}1", "\u{2603}"]), numbers);
    assert_eq!(picture(["\u{5d0}", "\u{5d1}", "\u{1f916}"]), numbers);
    assert_eq!(
        picture(["\u{8f66}", "1", "\u{2603}"]),
        picture(["4", "1", "3"]),
        "the name of another robot is no number"
    );
    assert_ne!(
        picture(["A1", "B1", "\u{2603}"]),
        numbers,
        "letters are kept"
    );
}
