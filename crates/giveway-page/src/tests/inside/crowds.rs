//! PIBT step by step, and the configurations of `LaCAM`.

use super::*;

/// Two robots behind each other in a corridor: the first one to choose is the one behind.
fn behind() -> State {
    page(&["ab.AB"], &[Cost::Makespan, Cost::SumOfCosts])
}

fn open(state: &State, method: Method) -> State {
    settled(&inside(state, [InsideAction::By(method)]))
}

fn words(state: &State) -> String {
    shown(state).verdict.unwrap().word
}

#[test]
fn pibt_is_stepped_through_with_priorities_and_pushes() {
    let state = open(&solved(&behind()), Method::Pibt);
    let first = steps(&state).unwrap();
    assert_eq!((first.at.as_str(), first.has_before), ("0", false));
    let column = shown(&state);
    assert_eq!(column.title, "The step from 0 to 1");
    assert_eq!(column.verdict.unwrap().word, "A chooses first");
    let (title, pushes) = &column.facts[0];
    assert_eq!(title, "Who pushed whom");
    assert_eq!(
        pushes[0].text,
        "A wants (1, 0), where B stands: B chooses next."
    );
    assert_eq!(pushes[0].small, "B goes to (2, 0).");
    // It is seen on the board, at the time of the step.
    let drawn = overlay(&state);
    assert_eq!(drawn.lit, Some(vec![0, 1]));
    assert_eq!(drawn.bans[0].text, "pushes B");
    assert_eq!(drawn.bans[0].line, Some([(50.0, 50.0), (150.0, 50.0)]));
    let next = inside(&state, [InsideAction::Next]);
    assert_eq!(next.view.playback.time, 1);
    let last = inside(&state, [InsideAction::Last]);
    assert_eq!(words(&last), "All have arrived");
    assert!(!steps(&last).unwrap().has_after);
    let remark = shown(&last).remark.unwrap();
    assert!(
        remark.starts_with("PIBT found a plan: makespan 3"),
        "{remark}"
    );
    // It says that the plan on the board is another planner's.
    assert!(column.about.unwrap().contains("PIBT"));
    let closed = inside(&last, [InsideAction::Show(false)]);
    assert_eq!(
        closed.shown().unwrap().solved.status,
        giveway_solve::Status::Optimal
    );
}

#[test]
fn lacam_shows_its_configurations_and_how_deep_they_are() {
    let state = open(&solved(&crossing()), Method::Lacam);
    assert_eq!(shown(&state).title, "The start");
    assert_eq!(words(&state), "All robots are at their starts");
    let one = inside(&state, [InsideAction::Next]);
    assert_eq!(words(&one), "New");
    assert_eq!(shown(&one).title, "Configuration 1, after 1 step");
    assert_eq!(one.view.playback.time, 1, "the board stands there");
    let answer = one.inside_answer().unwrap();
    assert_eq!(answer.makespan(), 1);
    // Each step is one of these; some come again, and all are counted at the end.
    let mut state = state;
    let mut seen = std::collections::BTreeSet::new();
    loop {
        seen.insert(words(&state));
        if !steps(&state).unwrap().has_after {
            break;
        }
        state = inside(&state, [InsideAction::Next]);
    }
    assert!(
        seen.contains("New") && seen.contains("Known already"),
        "{seen:?}"
    );
    let column = shown(&state);
    let (_, so_far) = column.facts.last().unwrap();
    assert!(
        so_far[0].text.contains("configurations, depth at most "),
        "{so_far:?}"
    );
    assert!(
        column
            .remark
            .unwrap()
            .starts_with("LaCAM found a plan: sum of costs 5")
    );
}

#[test]
fn what_a_planner_cannot_plan_for_is_said() {
    let scene = r#"{ "giveway": 1, "map": ["..."],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0], "waypoints": [[1, 0]] }] }"#;
    for method in [Method::Pibt, Method::Lacam] {
        let state = open(&State::new(draft(scene)), method);
        assert!(column(&state).is_none());
        let said = nothing(&state);
        assert!(said.text.contains("waypoints"), "{said:?}");
    }
}

#[test]
fn another_planner_begins_at_its_start() {
    let last = inside(&open(&behind(), Method::Pibt), [InsideAction::Last]);
    assert_ne!(steps(&last).unwrap().at, "0");
    let other = open(&last, Method::Lacam);
    assert_eq!(steps(&other).unwrap().at, "0");
    let again = open(&other, Method::Pibt);
    assert!(again.work.is_idle(), "what is known is not asked again");
    assert_eq!(steps(&again).unwrap().at, "0");
}
