//! Reports: every figure counted a second time, and names that cannot be markup or formulas.

mod last;
mod marks;
mod told;

use giveway_model::change::Changes;
use giveway_model::format::native::{read_changes, read_instance, read_plan};
use giveway_model::{Cell, Cost, Instance, Plan, check};

use super::{Known, Report, Sign, Subject};

/// Two robots with a battery, a charger, a slow cell and an obstacle; the first one waits once.
fn scene() -> (Instance, Plan) {
    let instance = read_instance(
        r#"{ "giveway": 1, "name": "<Floor>", "map": ["..+.", ".#~."],
        "units": { "cell": 0.8, "step": 1.5 },
        "agents": [
          { "name": "=A1", "start": [0, 0], "goal": [3, 0], "waypoints": [[1, 0]],
            "battery": { "capacity": 9, "initial": 5 } },
          { "name": "A2", "start": [3, 1], "goal": [0, 1] }
        ] }"#,
    );
    let plan = read_plan(
        r#"{ "giveway": 1, "paths": {
          "=A1": [[0, 0], [1, 0], [2, 0], [2, 0], [3, 0]],
          "A2": [[3, 1], [3, 1], [3, 0], [2, 0], [1, 0], [0, 0], [0, 1]] },
        "charges": { "=A1": [2] } }"#,
    );
    (instance.unwrap(), plan.unwrap())
}

fn report(known: Known) -> Report {
    let (instance, plan) = scene();
    let subject = Subject::new(&instance, &plan, None).unwrap();
    Report::of(&subject, known)
}

#[test]
fn costs_are_those_of_the_judge() {
    let (instance, plan) = scene();
    let costs = check::costs(&instance, &plan).unwrap();
    let told = report(Known {
        bounds: vec![(Cost::Makespan, 5)],
        ..Known::default()
    });
    assert_eq!(told.costs.len(), 5);
    for row in &told.costs {
        assert_eq!(row.value, costs.get(row.cost), "{:?}", row.cost);
        let least = (row.cost == Cost::Makespan).then_some(5);
        assert_eq!(row.at_least, least);
    }
    assert_eq!(
        told.costs_told,
        "The last robot arrives at 6, after 9 s. The arrivals add up to 10 steps, with 1 charge."
    );
    assert_eq!(
        told.facts,
        [
            "4 \u{d7} 2 cells, 2 robots, 1 obstacle, 1 charger, 1 slow cell",
            "A cell is 0.8 m, a step 1.5 s: the floor is 3.2 m \u{d7} 1.6 m"
        ]
    );
}

#[test]
fn robots_have_their_visits_waits_and_levels() {
    let (instance, plan) = scene();
    let told = report(Known::default());
    let [first, second] = &told.robots[..] else {
        panic!("{:?}", told.robots)
    };
    assert_eq!(first.waypoints, [(Cell::new(1, 0), Some(1))]);
    assert_eq!((first.arrives, first.waits), (Some(4), 1));
    assert_eq!(first.charges, [(Cell::new(2, 0), 2)]);
    let levels = check::levels(&instance, 0, &plan);
    assert_eq!(first.lowest, levels.iter().min().copied());
    let battery = first.battery.clone().unwrap();
    assert_eq!((battery.capacity, battery.initial), (9, 5));
    assert_eq!(Some(battery.least), first.lowest);
    let (cell, time) = battery.least_at.unwrap();
    assert_eq!(levels[time as usize], battery.least);
    assert_eq!(plan.path("=A1")[time as usize], Some(cell));
    assert_eq!(battery.at_goal, levels.get(4).copied(), "it arrives at 4");
    assert_eq!(second.battery, None);
    assert_eq!((second.arrives, second.waits), (Some(6), 1));
    assert_eq!((second.lowest, second.goal), (None, Some(Cell::new(0, 1))));
}

#[test]
fn the_busiest_cell_is_that_of_most_passes() {
    let told = report(Known::default());
    let cells: Vec<_> = told
        .busiest
        .iter()
        .map(|busy| (busy.letter.as_str(), busy.cell, busy.passes, busy.robots))
        .collect();
    // Both robots pass (0, 0), (1, 0), (2, 0) and (3, 0); at (2, 0) one waits.
    let expected = [
        ("a", Cell::new(2, 0), 2, 2),
        ("b", Cell::new(0, 0), 2, 2),
        ("c", Cell::new(1, 0), 2, 2),
        ("d", Cell::new(3, 0), 2, 2),
    ];
    assert_eq!(cells, expected);
    assert_eq!(told.busiest[0].waits, 1);
}

#[test]
fn names_are_neither_markup_nor_formulas() {
    let told = report(Known {
        claim: "a < b".to_owned(),
        ..Known::default()
    });
    let html = told.page("en");
    assert!(html.contains("<h1>&lt;Floor&gt;</h1>"), "{html}");
    assert!(html.contains("<b>a &lt; b</b>"));
    assert!(!html.contains("<Floor>"));
    let (instance, plan) = scene();
    let subject = Subject::new(&instance, &plan, None).unwrap();
    let csv = subject.csv();
    let lines: Vec<&str> = csv.split("\r\n").collect();
    assert_eq!(lines[0], "\u{feff}Robot,Time,x,y,Level");
    assert_eq!(lines[1], "'=A1,0,0,0,5");
    assert_eq!(lines[4], "'=A1,3,2,0,9", "charged");
    assert_eq!(lines[6], "A2,0,3,1,");
    // Five times of the first robot, seven of the second.
    assert_eq!(lines.len(), 1 + 5 + 7 + 1);
    let robots = told.csv();
    let lines: Vec<&str> = robots.split("\r\n").collect();
    assert_eq!(
        lines[0],
        "\u{feff}Robot,Start,Waypoints,Goal,Arrives,\"Arrives, seconds\",Waits,Charges,Lowest level,Level at the goal"
    );
    assert!(
        lines[1].starts_with("'=A1,\"0, 0\",\"1, 0\",\"3, 0\",4,6,1,1,"),
        "{robots}"
    );
}

#[test]
fn columns_are_summed_and_the_day_is_told() {
    let html = report(Known {
        date: Some("30 <Nov>".to_owned()),
        ..Known::default()
    });
    let html = html.html();
    let (_, total) = html.split_once("<tbody class=\"total\">").unwrap();
    let (total, _) = total.split_once("</tbody>").unwrap();
    // 4 and 6 steps; each robot waits once.
    assert_eq!(
        total,
        "<tr><th scope=\"row\">Sum</th><td colspan=\"3\"></td><td class=\"n\">10</td><td></td><td class=\"n\">2</td></tr>\n"
    );
    assert!(html.contains("<p class=\"brand\">Giveway</p><p>30 &lt;Nov&gt;</p>"));
    assert!(!report(Known::default()).html().contains("</p><p>30"));
}

#[test]
fn the_page_is_well_formed_and_tells_every_row() {
    let told = report(Known::default());
    let html = told.html();
    let parsed = roxmltree::Document::parse(&html).unwrap();
    let rows = |class: &str| {
        let table = parsed
            .descendants()
            .find(|node| node.attribute("class") == Some(class))
            .unwrap_or_else(|| panic!("{class}"));
        let body = table.children().find(|node| node.has_tag_name("tbody"));
        let body = body.unwrap();
        body.children()
            .filter(|node| node.has_tag_name("tr"))
            .count()
    };
    assert_eq!(rows("report-robots"), 2);
    assert_eq!(rows("report-costs"), 5);
    assert_eq!(rows("report-busiest"), 4);
    assert_eq!(rows("report-batteries"), 1, "one robot has a battery");
    assert_eq!(
        told.signs,
        [
            Sign::Start,
            Sign::Goal,
            Sign::Busy,
            Sign::Obstacle,
            Sign::Slow,
            Sign::Charger
        ]
    );
}

#[test]
fn changes_are_told_by_time() {
    let (instance, plan) = scene();
    let changes: Changes = read_changes(
        r#"{ "giveway": 1, "changes": [
          { "at": 4, "change": "add-obstacle", "cell": [3, 1] },
          { "at": 2, "change": "delay-agent", "agent": "=A1", "steps": 1 } ] }"#,
    )
    .unwrap();
    let subject = Subject::new(&instance, &plan, Some(&changes)).unwrap();
    let told = Report::of(
        &subject,
        Known {
            methods: vec![(2, "New times".to_owned())],
            ..Known::default()
        },
    );
    let rows: Vec<_> = told
        .changes
        .iter()
        .map(|row| (row.at, row.what.as_str(), row.method.as_deref()))
        .collect();
    assert_eq!(
        rows,
        [
            (2, "=A1 breaks down for 1 step", Some("New times")),
            (4, "New obstacle at (3, 1)", None)
        ]
    );
    assert!(told.signs.contains(&Sign::Breakdown));
    assert_eq!(told.robots[0].arrives, Some(4));
}
