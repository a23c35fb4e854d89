//! A bound that was proved of a scene stands beside the plan of any planner, and is no proof of that
//! planner.

use super::*;

#[test]
fn a_proved_bound_stands_beside_the_plan_of_another_planner() {
    let state = planned(&crossing(&BOTH), Planner::Pibt);
    let at_least = |state: &State| inspect::whole(state).costs[0].at_least;
    assert_eq!(at_least(&state), None, "nothing is proved yet");
    assert!(!saying(&state).contains("Proved"), "{}", saying(&state));

    let state = planned(&solved(&crossing(&BOTH)), Planner::Pibt);
    let said = saying(&state);
    assert!(
        said.ends_with("Proved: no plan has a sum of costs under 5."),
        "{said}"
    );
    assert_eq!(at_least(&state), Some(5));
    // Of the second cost only plans that are best in the first one are known.
    assert_eq!(inspect::whole(&state).costs[1].at_least, None);
    let rows = rows(&state);
    let row = rows.iter().find(|row| row.by == By::Planner(Planner::Pibt));
    let told = row.unwrap().plan.as_ref().unwrap();
    assert_eq!(told.proved, Proved::Nothing, "it did not prove it");
    assert_eq!(words::standing(&state).badge, words::Badge::Found);
}

#[test]
fn an_edit_takes_the_bound_away() {
    let state = planned(&solved(&crossing(&BOTH)), Planner::Pibt);
    let state = after(&state, [Action::Edit(Edit::Within(Some(9)))]);
    assert_eq!(crate::planners::least(&state.document), None);
}
