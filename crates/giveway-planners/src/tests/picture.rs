//! Instances drawn as text.
//!
//! Cells with blanks between them, each its ground (`. # ~ + *`, free where it
//! is left out) and the marks of agents: `a` is the start of the agent a, `A`
//! its goal, `a!` a waypoint. Lines of settings may follow: `battery a 2/5`
//! (initial 2 of capacity 5), `floor 1`, `vanish`.

use std::collections::BTreeMap;

use giveway_model::{Agent, AtGoal, Battery, Cell, Instance, Scene};

/// The instance that a picture shows.
pub(crate) fn instance(picture: &str) -> Instance {
    let mut scene = Scene::default();
    let mut agents: BTreeMap<char, Agent> = BTreeMap::new();
    for line in picture.lines().map(str::trim).filter(|l| !l.is_empty()) {
        match line.split_whitespace().collect::<Vec<_>>().as_slice() {
            ["battery", name, levels] => {
                let (initial, capacity) = levels.split_once('/').unwrap();
                let agent = name.chars().next().and_then(|c| agents.get_mut(&c));
                agent.unwrap().battery = Some(Battery {
                    capacity: capacity.parse().unwrap(),
                    initial: initial.parse().unwrap(),
                });
            }
            ["floor", level] => scene.rules.battery_floor = level.parse().unwrap(),
            ["vanish"] => scene.rules.at_goal = AtGoal::Vanish,
            cells => {
                let y = scene.map.len() as u32;
                let row = (0..).zip(cells);
                let row = row.map(|(x, text)| read_cell(text, Cell::new(x, y), &mut agents));
                scene.map.push(row.collect());
            }
        }
    }
    scene.agents = agents.into_values().collect();
    Instance::new(scene).unwrap_or_else(|faults| panic!("{faults:?} in\n{picture}"))
}

/// Reads the text of a cell: notes its marks, returns its ground.
fn read_cell(text: &str, cell: Cell, agents: &mut BTreeMap<char, Agent>) -> char {
    let mut chars = text.chars().peekable();
    let ground = chars.next_if(|c| !c.is_ascii_alphabetic()).unwrap_or('.');
    while let Some(mark) = chars.next() {
        let name = mark.to_ascii_lowercase();
        let agent = agents.entry(name).or_insert_with(|| Agent {
            name: name.to_string(),
            start: cell,
            goal: Some(cell),
            waypoints: Vec::new(),
            battery: None,
            heading: None,
        });
        if chars.next_if_eq(&'!').is_some() {
            agent.waypoints.push(cell);
        } else if mark.is_ascii_uppercase() {
            agent.goal = Some(cell);
        } else {
            agent.start = cell;
        }
    }
    ground
}

#[test]
fn a_picture_shows_grounds_marks_and_settings() {
    let shown = instance(
        "aA  +b  ~B
         #   *a! .
         battery b 2/5
         floor 1
         vanish",
    );
    assert_eq!(shown.grid().rows(), [".+~", "#*."]);
    assert!(!shown.stays());
    assert_eq!(shown.rules().battery_floor, 1);
    let [a, b] = shown.agents() else {
        panic!("{:?}", shown.agents());
    };
    assert_eq!((a.start, a.goal), (Cell::new(0, 0), Some(Cell::new(0, 0))));
    assert_eq!(
        (a.waypoints.as_slice(), a.battery),
        (&[Cell::new(1, 1)][..], None)
    );
    assert_eq!((b.start, b.goal), (Cell::new(1, 0), Some(Cell::new(2, 0))));
    let battery = Battery {
        capacity: 5,
        initial: 2,
    };
    assert_eq!(b.battery, Some(battery));
}
