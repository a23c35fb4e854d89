//! Requests that are refused, each with its place.

use giveway_solve::SilentHost;

use super::*;

fn refused(function: &str, request: &str) -> (Code, String) {
    let failure = call(function, request, &SilentHost).unwrap_err();
    (failure.code, failure.faults[0].place.clone())
}

#[test]
fn what_is_wrong_is_told_with_its_place() {
    let map = r#""giveway": 1, "map": ["..#"]"#;
    let goal = |goal: &str| {
        let agent = format!(r#"{{ "name": "A", "start": [0, 0], "goal": {goal} }}"#);
        format!(r#"{{ "scene": {{ {map}, "agents": [{agent}] }} }}"#)
    };
    let place = "scene.agents[0].goal".to_owned();
    let input = refused("solve", &goal("[0, \"x\"]"));
    assert_eq!(input, (Code::BadInput, format!("{place}[1]")));
    assert_eq!(refused("solve", &goal("[2, 0]")), (Code::BadScene, place));
    assert_eq!(refused("sing", "{}"), (Code::BadInput, String::new()));
    assert_eq!(
        refused("read-question", r#"{ "words": ["sing"] }"#).1,
        "question"
    );
    let (code, _) = refused("read-scene", "{");
    assert_eq!(code, Code::BadText);
}

#[test]
fn what_is_no_text_has_no_line() {
    let cases = [
        (
            "scene-of-object",
            r#"{ "giveway": 1, "map": [3] }"#,
            Code::BadInput,
        ),
        (
            "scene-of-object",
            r#"{ "giveway": 1, "map": [""], "agents": [] }"#,
            Code::BadScene,
        ),
        (
            "plan-of-object",
            r#"{ "giveway": 1, "paths": { "A": 3 } }"#,
            Code::BadInput,
        ),
    ];
    for (function, request, code) in cases {
        let failure = call(function, request, &SilentHost).unwrap_err();
        assert_eq!(failure.code, code);
        assert!(failure.faults.iter().all(|fault| fault.line.is_none()));
        assert!(!failure.faults[0].place.is_empty());
    }
    assert!(
        call(
            "plan-of-object",
            r#"{ "giveway": 1, "paths": {} }"#,
            &SilentHost
        )
        .is_ok()
    );
}

#[test]
fn files_that_are_no_certificate_are_rejected_in_a_report() {
    let report = call("verify", r#"{ "files": {} }"#, &SilentHost).unwrap();
    assert!(report.contains(r#""accepted":false"#), "{report}");
}
