//! What is said of a learner's changes.

use giveway_course::judge::words::made;
use giveway_model::{Cell, Scene};

use super::shipped;

fn start() -> Scene {
    shipped::lesson("room-to-pass").steps[0]
        .scene
        .clone()
        .unwrap()
}

fn told(change: impl FnOnce(&mut Scene)) -> Option<String> {
    let start = start();
    let mut scene = start.clone();
    change(&mut scene);
    made(&start, &scene).map(|text| text.plain())
}

#[test]
fn changes_are_told_as_a_person_would() {
    let set = |x: usize, y: usize, ground: &'static str| {
        move |scene: &mut Scene| scene.map[y].replace_range(x..=x, ground)
    };
    assert_eq!(told(|_| {}), None);
    assert_eq!(told(set(4, 0, "#")).unwrap(), "You blocked (4, 0).");
    assert_eq!(told(set(4, 1, ".")).unwrap(), "You freed (4, 1).");
    assert_eq!(
        told(set(3, 1, "+")).unwrap(),
        "You put a charger on (3, 1)."
    );
    assert_eq!(told(set(3, 1, "~")).unwrap(), "You made (3, 1) slow.");
    let two = told(|scene| {
        set(4, 0, "#")(scene);
        set(5, 0, "#")(scene);
    });
    assert_eq!(two.unwrap(), "You blocked (4, 0) and blocked (5, 0).");
    let four = told(|scene| scene.map[0] = "#......#".into());
    assert_eq!(four.unwrap(), "You freed (1, 0) and freed (6, 0).");
    let many = told(|scene| scene.map[0] = "........".into());
    assert_eq!(many.unwrap(), "You made 4 changes.");
}

#[test]
fn changes_of_robots_are_told_by_name() {
    let gone = told(|scene| drop(scene.agents.remove(0)));
    assert_eq!(gone.unwrap(), "You took A1 away.");
    let moved = told(|scene| scene.agents[0].start = Cell::new(1, 2));
    assert_eq!(moved.unwrap(), "You moved A1 to (1, 2).");
    let goal = told(|scene| scene.agents[0].goal = Some(Cell::new(6, 2)));
    assert_eq!(goal.unwrap(), "You gave A1 another flag, (6, 2).");
    let added = told(|scene| {
        let mut agent = scene.agents[0].clone();
        agent.name = "A3".into();
        scene.agents.push(agent);
    });
    assert_eq!(added.unwrap(), "You added A3.");
}
