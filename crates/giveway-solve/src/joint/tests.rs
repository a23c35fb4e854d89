//! The limits of exhausting joint states.

use giveway_model::format::native;

use super::{Exhaustion, any};
use crate::{
    Limits, SilentHost,
    budget::{Budget, Stop},
    problem::Problem,
};

/// A corridor of so many cells in which two agents cannot pass each other.
fn corridor(cells: usize) -> Problem {
    let (map, last) = (".".repeat(cells), cells - 1);
    let scene = format!(
        r#"{{ "giveway": 1, "map": ["{map}"], "agents": [
            {{ "name": "A", "start": [0, 0], "goal": [{last}, 0] }},
            {{ "name": "B", "start": [{last}, 0], "goal": [0, 0] }}] }}"#
    );
    let budget = Budget::new(&SilentHost, Limits::default());
    let instance = native::read_instance(&scene).unwrap();
    let Ok(problem) = Problem::new(&instance, &budget) else {
        panic!("the corridor is a problem");
    };
    problem
}

#[test]
fn joint_states_count_as_memory() {
    let problem = corridor(40);
    let exhaust = |memory_bytes| {
        let limits = Limits {
            memory_bytes,
            ..Limits::default()
        };
        any(&problem, &[0, 1], &Budget::new(&SilentHost, limits))
    };
    assert!(matches!(exhaust(None), Ok(Exhaustion::None(_))));
    assert!(matches!(exhaust(Some(10_000_000)), Ok(Exhaustion::None(_))));
    assert_eq!(exhaust(Some(20_000)), Err(Stop::Memory));
}
