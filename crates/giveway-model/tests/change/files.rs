//! Changes as files: read, written, and refused with line and column.

use giveway_model::change::{Changes, ConstraintRef, What};
use giveway_model::format::native::read_changes;

use super::changes;

#[track_caller]
fn fault(list: &str, expected: &str) {
    let text = format!("{{ \"giveway\": 1,\n  \"changes\": [{list}] }}");
    let fault = read_changes(&text).unwrap_err();
    assert_eq!(fault.to_string(), expected);
}

#[test]
fn every_kind_is_read_and_written_again() {
    let all = "0 add-agent A 00 10 battery 3/4; 1 remove-agent B; 1 add-obstacle 00; \
        2 remove-obstacle 00; 2 move-obstacle 00 10; 3 set-slow 00 10; 3 set-normal 00; \
        4 add-charger 00; 4 remove-charger 00; 5 set-goal A 10; 5 add-waypoint A 10; \
        6 drop-waypoint A 10; 6 set-battery A 2; 7 delay-agent A 3; 8 stop-agent A";
    let changes = changes(all);
    assert_eq!(changes.changes.len(), 15);
    let text = serde_json::to_string(&changes).unwrap();
    assert_eq!(read_changes(&text).unwrap(), changes);
    let last = &changes.changes[13];
    let delay = What::DelayAgent {
        agent: "A".into(),
        steps: 3,
    };
    assert_eq!((last.at, &last.what), (7, &delay));
}

#[test]
fn changes_of_one_time_are_together_in_the_order_of_the_file() {
    let changes = changes("2 add-obstacle 00; 1 add-obstacle 10; 2 remove-obstacle 00");
    let times: Vec<(u32, Vec<usize>)> = changes
        .by_time()
        .into_iter()
        .map(|(at, list)| (at, list.into_iter().map(|(index, _)| index).collect()))
        .collect();
    assert_eq!(times, [(1, vec![1]), (2, vec![0, 2])]);
    assert_eq!(Changes::default().by_time(), []);
}

#[test]
fn what_is_wrong_with_a_file_has_a_place() {
    fault(
        r#"{ "at": -1, "change": "remove-agent", "agent": "A" }"#,
        "line 2, column 23: changes[0].at: found the number -1, expected a whole number from 0 to 4294967295",
    );
    fault(
        r#"{ "at": 1, "change": "remove-agent" }"#,
        "line 2, column 15: changes[0]: found no key \"agent\", expected one here",
    );
    fault(
        r#"{ "at": 1, "change": "remove-agent", "agent": "A", "cell": [0, 0] }"#,
        "line 2, column 66: changes[0]: found the unknown key \"cell\", expected the keys of remove-agent",
    );
    fault(
        r#"{ "at": 1, "change": "add-agent", "agent": "A" }"#,
        "line 2, column 15: changes[0]: found the name of a robot, expected the robot as an object",
    );
    fault(
        r#"{ "at": 1, "change": "add-agent", "agent": { "name": "A", "start": [0], "goal": [0, 0] } }"#,
        "line 2, column 82: changes[0].agent.start: found a list of one, expected a cell [x, y]",
    );
    fault(
        r#"{ "at": 1, "change": "grow" }"#,
        "line 2, column 36: changes[0].change: found \"grow\", expected one of add-agent remove-agent \
         add-obstacle remove-obstacle move-obstacle set-slow set-normal add-charger remove-charger \
         set-goal add-waypoint drop-waypoint set-battery delay-agent stop-agent add-constraint \
         remove-constraint",
    );
}

#[test]
fn rules_are_read_and_written_again() {
    let text = r#"{ "giveway": 1, "changes": [
        { "at": 1, "change": "add-constraint",
          "constraint": { "kind": "gap", "steps": 2, "name": "room" } },
        { "at": 2, "change": "remove-constraint", "name": "room" },
        { "at": 3, "change": "remove-constraint", "index": 4 }
    ] }"#;
    let changes = read_changes(text).unwrap();
    assert!(
        matches!(&changes.changes[0].what, What::AddConstraint { constraint }
        if constraint.name.as_deref() == Some("room"))
    );
    let which = |name: &str| What::RemoveConstraint {
        constraint: ConstraintRef::Name(name.to_owned()),
    };
    assert_eq!(changes.changes[1].what, which("room"));
    let index = What::RemoveConstraint {
        constraint: ConstraintRef::Index(4),
    };
    assert_eq!(changes.changes[2].what, index);
    let again = serde_json::to_string(&changes).unwrap();
    assert_eq!(read_changes(&again).unwrap(), changes);
    for bad in [
        r#"{ "at": 1, "change": "remove-constraint" }"#,
        r#"{ "at": 1, "change": "remove-constraint", "name": "a", "index": 1 }"#,
        r#"{ "at": 1, "change": "add-constraint", "name": "a" }"#,
        r#"{ "at": 1, "change": "add-constraint", "constraint": { "kind": "gap" } }"#,
    ] {
        let text = format!(r#"{{ "giveway": 1, "changes": [{bad}] }}"#);
        assert!(read_changes(&text).is_err(), "{bad}");
    }
}
