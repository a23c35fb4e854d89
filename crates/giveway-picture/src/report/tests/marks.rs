//! The map: starts and goals that share a cell are both to be read.

use giveway_model::format::native::{read_instance, read_plan};

use crate::report::{Known, Report, Subject};

/// The texts of the map with their places.
fn texts(map: &str) -> Vec<(String, i64, i64)> {
    let parsed = roxmltree::Document::parse(map).unwrap();
    let texts = parsed.descendants().filter(|it| it.has_tag_name("text"));
    let place = |node: roxmltree::Node<'_, '_>, name: &str| -> i64 {
        node.attribute(name).unwrap().parse().unwrap()
    };
    texts
        .map(|it| {
            let text = it.text().unwrap().to_owned();
            (text, place(it, "x"), place(it, "y"))
        })
        .collect()
}

#[test]
fn a_start_hides_no_goal() {
    let instance = read_instance(
        r#"{ "giveway": 1, "map": ["....", "...."],
        "agents": [
          { "name": "A1", "start": [0, 0], "goal": [1, 0] },
          { "name": "A2", "start": [1, 0], "goal": [0, 0] },
          { "name": "A3", "start": [3, 1], "goal": [3, 1] },
          { "name": "A4", "start": [2, 1], "goal": [2, 0] }
        ] }"#,
    )
    .unwrap();
    let plan = read_plan(
        r#"{ "giveway": 1, "paths": {
          "A1": [[0, 0], [0, 1], [1, 1], [1, 0]],
          "A2": [[1, 0], [0, 0]],
          "A3": [[3, 1]],
          "A4": [[2, 1], [2, 0]] } }"#,
    )
    .unwrap();
    let subject = Subject::new(&instance, &plan, None).unwrap();
    let told = Report::of(&subject, Known::default());
    let texts = texts(&told.map);
    for robot in &told.robots {
        let own = texts.iter().filter(|(text, x, y)| {
            // The numbers of columns and rows are outside the floor.
            *text == robot.number && *x > 0 && *y > 0
        });
        assert_eq!(own.count(), 2, "its start and its goal: {texts:?}");
    }
    let inside = |column: i64, row: i64| {
        let here = texts.iter().filter(move |&&(_, x, y)| {
            (100 * column..100 * column + 100).contains(&x)
                && (100 * row..100 * row + 100).contains(&y)
        });
        here.filter(|(text, ..)| text.parse::<u32>().is_ok())
            .map(|&(_, x, y)| (x, y))
            .collect::<Vec<_>>()
    };
    for (column, row) in [(0, 0), (1, 0), (3, 1)] {
        let [one, other] = inside(column, row)[..] else {
            panic!("{column}, {row}: {texts:?}");
        };
        let apart = (one.0 - other.0).abs().max((one.1 - other.1).abs());
        assert!(apart >= 35, "{one:?} and {other:?} cover each other");
    }
    assert_eq!(inside(2, 0).len(), 1, "alone in the middle");
}
