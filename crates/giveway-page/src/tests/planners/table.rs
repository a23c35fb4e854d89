//! The table of planners: whose plan is shown, and what is dropped.

use giveway_solve::plan::Planner;

use super::{BOTH, By, Place, crossing, planned, rows, solved, table};
use crate::reduce::tests::{after, stroke};
use crate::{Action, Edit, SolveAction, State, Tool, ViewAction, words};

#[test]
fn planners_are_side_by_side_until_the_scene_changes() {
    let both = planned(
        &planned(&solved(&crossing(&BOTH)), Planner::Lacam),
        Planner::Cbs,
    );
    let by: Vec<By> = rows(&both).iter().map(|row| row.by).collect();
    let [cbs, lacam] = [Planner::Cbs, Planner::Lacam].map(By::Planner);
    assert_eq!(by, [By::Search, cbs, lacam]);
    let is_shown = |state: &State| {
        let shown = rows(state).into_iter();
        let mut shown = shown.filter(|row| {
            row.plan
                .as_ref()
                .is_ok_and(|plan| plan.place == Place::Board)
        });
        shown.next().map(|row| row.by)
    };
    for by in by {
        let state = after(&both, [Action::Solve(SolveAction::ShowPlan(by))]);
        assert_eq!(is_shown(&state), Some(by));
        assert!(state.playing().is_some() && rows(&state).len() == 3);
    }
    let undone = after(&both, [Action::Undo]);
    assert_eq!((rows(&undone).len(), is_shown(&undone)), (2, Some(lacam)));
    let undone = after(&undone, [Action::Undo]);
    assert_eq!(words::standing(&undone).badge, words::Badge::Proved);
    assert_eq!(table(&undone), None, "no planner was run");

    let edited = after(&both, stroke(Tool::Obstacle, &[(0, 0)]));
    assert_eq!(table(&edited), None);
    assert_eq!(rows(&planned(&edited, Planner::Pibt)).len(), 1);
    let within = after(&both, [Action::Edit(Edit::Within(Some(9)))]);
    assert_eq!(table(&within), None, "other plans count");
}

#[test]
fn a_second_plan_is_beside_the_first_where_there_is_room() {
    let both = planned(&planned(&crossing(&BOTH), Planner::Lacam), Planner::Cbs);
    let beside = |planner| Action::Solve(SolveAction::ShowBeside(By::Planner(planner)));
    let narrow = after(&both, [beside(Planner::Lacam)]);
    assert_eq!(narrow.beside(), None);
    let wide = after(&narrow, [Action::View(ViewAction::SetWide(true))]);
    assert_eq!(wide.beside().unwrap().by, Some(Planner::Lacam));
    let row = rows(&wide).pop().unwrap();
    assert_eq!(row.plan.unwrap().place, Place::Beside);
    assert_eq!(after(&wide, [beside(Planner::Lacam)]).beside(), None);
    let same = after(&wide, [beside(Planner::Cbs)]);
    assert_eq!(same.beside(), None, "it is the one on the board");
    let edited = after(&wide, stroke(Tool::Obstacle, &[(0, 0)]));
    assert_eq!(edited.beside(), None);
}
