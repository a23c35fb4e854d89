//! Instances drawn as text.
//!
//! A picture is a map of cells with blanks between them. A cell is its ground
//! (`. # ~ + *`, free where it is left out) and the marks of agents:
//!
//! - `a` is the start of the agent a, `A` its goal, `a!` a waypoint of a;
//! - `aA` is start and goal at once, `aB` the start of a and the goal of b;
//! - `+a` is the start of a on a charger, `~B` the goal of b in the slow zone.
//!
//! Lines of settings, each beginning with its word, may follow the map:
//!
//! ```text
//! a   +   ~   ~   A
//! battery a 2/5            initial 2 of capacity 5
//! floor 1                  the battery floor
//! vanish                   agents vanish at their goals
//! minimise charges,waits   the objective
//! ```
//!
//! Agents are ordered by their letters.

use std::collections::BTreeMap;

use giveway_model::{Agent, AtGoal, Battery, Cell, Instance, Scene};

/// The agents while they are put together from their marks.
type Marks = BTreeMap<char, (Option<Cell>, Option<Cell>, Vec<Cell>)>;

/// The instance that a picture shows.
pub fn instance(picture: &str) -> Instance {
    Instance::new(scene(picture)).unwrap_or_else(|faults| panic!("{faults:?} in\n{picture}"))
}

/// The scene that a picture shows, which may be wrong.
pub fn scene(picture: &str) -> Scene {
    let mut scene = Scene::default();
    let mut marks = Marks::new();
    let mut batteries = BTreeMap::new();
    for line in picture.lines().map(str::trim).filter(|l| !l.is_empty()) {
        match line.split_whitespace().collect::<Vec<_>>().as_slice() {
            ["battery", name, levels] => {
                batteries.insert((*name).to_owned(), battery(levels));
            }
            ["floor", level] => scene.rules.battery_floor = level.parse().unwrap(),
            ["vanish"] => scene.rules.at_goal = AtGoal::Vanish,
            ["minimise", costs] => scene.objective = costs.parse().unwrap(),
            cells => {
                let y = scene.map.len() as u32;
                let row = (0..).zip(cells);
                let row = row.map(|(x, text)| read_cell(text, Cell::new(x, y), &mut marks));
                scene.map.push(row.collect());
            }
        }
    }
    for (name, (start, goal, waypoints)) in marks {
        scene.agents.push(Agent {
            name: name.to_string(),
            start: start.unwrap_or_else(|| panic!("{name} has no start in\n{picture}")),
            goal,
            waypoints,
            battery: batteries.remove(&name.to_string()),
            heading: None,
        });
    }
    assert!(
        batteries.is_empty(),
        "a battery without an agent in\n{picture}"
    );
    scene
}

/// Reads the text of a cell: notes its marks, returns its ground.
fn read_cell(text: &str, cell: Cell, marks: &mut Marks) -> char {
    let mut chars = text.chars().peekable();
    let ground = chars.next_if(|c| !c.is_ascii_alphabetic()).unwrap_or('.');
    while let Some(mark) = chars.next() {
        assert!(
            mark.is_ascii_alphabetic(),
            "\"{text}\" is no cell of a picture"
        );
        let agent = marks.entry(mark.to_ascii_lowercase()).or_default();
        if chars.next_if_eq(&'!').is_some() {
            agent.2.push(cell);
        } else if mark.is_ascii_lowercase() {
            agent.0 = Some(cell);
        } else {
            agent.1 = Some(cell);
        }
    }
    ground
}

/// Reads `initial/capacity`.
fn battery(levels: &str) -> Battery {
    let (initial, capacity) = levels.split_once('/').unwrap();
    Battery {
        initial: initial.parse().unwrap(),
        capacity: capacity.parse().unwrap(),
    }
}

#[cfg(test)]
mod tests {
    use super::instance;

    #[test]
    fn a_picture_shows_grounds_marks_and_settings() {
        let shown = instance(
            "
            aA  +b  ~B
            #   *a! .
            battery b 2/5
            floor 1
            vanish
            minimise waits,moves
            ",
        );
        let json = serde_json::to_value(shown.to_scene()).unwrap();
        let expected = serde_json::json!({
            "giveway": 1,
            "name": "",
            "map": [".+~", "#*."],
            "rules": { "at_goal": "vanish", "battery_floor": 1 },
            "objective": ["waits", "moves"],
            "agents": [
                { "name": "a", "start": [0, 0], "goal": [0, 0], "waypoints": [[1, 1]] },
                { "name": "b", "start": [1, 0], "goal": [2, 0], "battery": { "capacity": 5, "initial": 2 } },
            ],
        });
        assert_eq!(json, expected);
    }
}
