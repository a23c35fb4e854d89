//! What a report says beside its figures: who is left out, what is proved, where robots wait.

use giveway_model::format::native::{read_changes, read_instance, read_plan};
use giveway_model::{Cell, Cost, check};

use super::super::{Known, Proved, Report, Subject};
use super::{report, scene};

#[test]
fn costs_beside_those_before_a_change_say_who_is_left_out() {
    let (instance, plan) = scene();
    let changes = |what: &str| {
        let changes = format!(r#"{{ "giveway": 1, "changes": [{{ "at": 4, {what} }}] }}"#);
        read_changes(&changes).unwrap()
    };
    let told = |what: &str, has_before: bool| {
        let changes = changes(what);
        let subject = Subject::new(&instance, &plan, Some(&changes)).unwrap();
        let known = Known {
            before: check::check(&instance, &plan).costs.filter(|_| has_before),
            ..Known::default()
        };
        Report::of(&subject, known).html()
    };
    let removed = r#""change": "remove-agent", "agent": "A2""#;
    let without = "Without A2, whose task is not done.";
    assert!(told(removed, true).contains(without));
    assert!(
        !told(removed, false).contains(without),
        "nothing stands beside"
    );
    let obstacle = r#""change": "add-obstacle", "cell": [3, 1]"#;
    assert!(!told(obstacle, true).contains("Without"));
}

#[test]
fn what_is_proved_of_the_costs_is_said_cost_by_cost() {
    let told = |bounds: &[(Cost, u32)]| {
        let known = Known {
            bounds: bounds.to_vec(),
            proved: Proved::Bounded,
            ..Known::default()
        };
        report(known).objective.join(" ")
    };
    let (last, sum) = (Cost::Makespan, Cost::SumOfCosts);
    assert_eq!(
        told(&[(last, 6), (sum, 8)]),
        "What counts first is the last arrival: 6 is proved to be the least. Then the sum of costs: \
         10, where less than 8 is proved impossible. Then the number of charges."
    );
    assert_eq!(
        told(&[(last, 5)]),
        "What counts first is the last arrival: 6, where less than 5 is proved impossible. Then the \
         sum of costs, then the number of charges."
    );
    assert_eq!(
        told(&[(last, 6), (sum, 10), (Cost::Charges, 0)]),
        "What counts first is the last arrival: 6 is proved to be the least. Then the sum of costs: \
         10 is proved to be the least with that. Then the number of charges."
    );
    // Bounds that hold for some plans only are not said of all.
    let of_some = Known {
        bounds: vec![(last, 6)],
        ..Known::default()
    };
    assert_eq!(report(of_some).objective.join(" "), told(&[]));
    assert_eq!(
        told(&[]),
        "What counts first is the last arrival, then the sum of costs, then the number of charges."
    );
}

#[test]
fn where_robots_wait_longest_is_told_and_where_the_last_one_charges() {
    let told = report(Known::default());
    let waited = [(Cell::new(2, 0), 1), (Cell::new(3, 1), 1)];
    assert_eq!(told.waited, waited);
    let html = told.html();
    assert!(html.contains("Robots wait longest at 2, 0 (1 step) and 3, 1 (1 step)."));
    let alone = read_instance(
        r#"{ "giveway": 1, "map": [".+."], "agents": [{ "name": "A1", "start": [0, 0],
        "goal": [2, 0], "battery": { "capacity": 5, "initial": 1 } }] }"#,
    )
    .unwrap();
    let plan = r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [1, 0], [2, 0]] }, "charges": { "A1": [1] } }"#;
    let plan = read_plan(plan).unwrap();
    let subject = Subject::new(&alone, &plan, None).unwrap();
    let last = Report::of(&subject, Known::default()).last;
    assert!(
        last.contains(&"A1 charges as it passes (1, 0), at 1.".to_owned()),
        "{last:?}"
    );
}
