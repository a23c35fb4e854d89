//! Questions about times far beyond what a plan needs.

use giveway_model::{Cell, Question};

use super::{few_states::asked, read};
use crate::explain::Verdict;

/// A robot without a goal, and a plan of many more steps than there are joint states, since its
/// waits cost nothing where moves count: a shorter counterpart of the plan costs no more, but
/// it is not as close.
#[test]
fn a_horizon_that_suffices_for_costs_proves_nothing_of_closeness() {
    let instance = r#"{ "giveway": 1, "map": ["...."],
        "agents": [{ "name": "A", "start": [0, 0] }] }"#;
    let waits = "[0, 0], ".repeat(41);
    let plan = format!(r#"{{ "giveway": 1, "paths": {{ "A": [{waits}[1, 0]] }} }}"#);
    let (instance, plan) = read(instance, &plan);
    let question = Question::NoVisit {
        agent: Some("A".into()),
        at: Cell::new(2, 0),
    };
    let answer = asked(&instance, (Some(plan.clone()), question), "moves", None);
    assert_eq!(
        (answer.verdict, answer.reach.is_complete()),
        (Verdict::Costly, true)
    );
    let path = answer.alternative.unwrap().paths["A"].clone();
    let own = &plan.paths["A"];
    let at = |path: &[Option<Cell>], time: usize| *path.get(time).or(path.last()).unwrap();
    let differs = (0..path.len().max(own.len())).filter(|&time| at(&path, time) != at(own, time));
    let entries = differs.count();
    // Waiting as long as before and then going on differs at the end only.
    assert!(entries == 1 || !answer.closest, "{entries} entries differ");
}

/// Later than times are followed step by step, what an agent needs is only bounded from below:
/// no arrival, and so no plan.
#[test]
fn a_lower_bound_is_no_arrival() {
    let instance = r#"{ "giveway": 1, "map": ["..."],
        "agents": [{ "name": "A", "start": [0, 0], "goal": [2, 0] }] }"#;
    let plan = r#"{ "giveway": 1, "paths": { "A": [[0, 0], [1, 0], [2, 0]] } }"#;
    let (instance, plan) = read(instance, plan);
    let late = |time| {
        let question = Question::NoMove {
            agent: "A".into(),
            from_cell: Cell::new(1, 0),
            to_cell: Cell::new(0, 0),
            time: Some(time),
        };
        let known = (Some(plan.clone()), question);
        asked(&instance, known, "makespan", Some(30_000)).verdict
    };
    assert_eq!(late(25_000), Verdict::Unknown);
    assert_eq!(late(50), Verdict::Costly);
}
