//! What is told of three robots, one of which has no choice.

use giveway_model::Cell;
use giveway_solve::Status;
use giveway_solve::freedom::FreedomPart;

use super::{SHOW, THREE, act, known, on_the_way, page, solved, told, told_of};
use crate::board::{Kind, legend};
use crate::freedom::{
    Chip, FreedomAction, Number, Section, Weight, chip, lane, late, lines, notes, numbers, part,
    pressed,
};
use crate::intake::{Save, work};
use crate::reduce::tests::after;
use crate::tests::{answer, answered, saying, select};
use crate::timeline::{Axis, Row};
use crate::{
    Action, BoardAction, Edit, IntakeAction, Point, Selection, SolveAction, ViewAction, board,
    reduce, table,
};

#[test]
fn the_column_tells_ways_lateness_cells_and_another_plan() {
    let state = told();
    assert_eq!(chip(&state), Chip::On);
    assert!(saying(&state).ends_with(" There are 15 such plans."));
    let column = told_of(&state);
    assert_eq!(
        column.lead,
        "11 of 19 steps are the same in every best plan."
    );
    assert_eq!((column.doing, column.stopped), (None, None));
    let ways = known(column.ways.unwrap());
    assert_eq!(ways.sum, "3 \u{d7} 1 \u{d7} 5 = 15 best plans");
    let values: Vec<&str> = ways.rows.iter().map(|row| row.value.as_str()).collect();
    assert_eq!(values, ["3 ways", "1 way", "5 ways"]);
    assert_eq!(ways.rows[1].detail, "every step is fixed");
    let late = known(column.late);
    let last = late.rows.last().unwrap();
    assert_eq!(last.title, "A2 decides the makespan");
    assert_eq!(last.detail, "one step late makes it 9");
    let cells = known(column.cells);
    let titles: Vec<&str> = cells.rows.iter().map(|row| row.title.as_str()).collect();
    assert_eq!(
        titles,
        [
            "Close (1, 3): no plan is left",
            "Close (5, 2): makespan 10, not 8",
            "Close (3, 1): sum of costs 21, not 19"
        ]
    );
    assert_eq!(
        cells.rows[1].detail,
        "and 4 more cells that cost 2 steps of the makespan"
    );
    let other = known(column.other.unwrap());
    assert_eq!(
        other.sentence,
        "In it robots are elsewhere 6 times. No best plan differs in more."
    );
}

#[test]
fn numbers_stand_on_cells_and_in_their_names() {
    let state = told();
    let all = numbers(&state);
    let on = |x, y| all.iter().find(|number| number.cell == Cell::new(x, y));
    assert_eq!(on(5, 2).map(|number| number.text.as_str()), Some("+2"));
    assert_eq!(on(3, 1).map(|number| number.text.as_str()), Some("sum +2"));
    let lost = on(1, 3).unwrap();
    assert_eq!(
        (lost.weight, lost.text.as_str()),
        (Weight::NoPlan, "no plan")
    );
    assert_eq!(on(2, 1), None, "nobody minds");
    assert_eq!(on(7, 2), None, "where a robot starts");
    assert!(all.iter().all(|number| number.width() <= 86.0));
    let notes = notes(&state);
    assert!(notes.contains(&(
        Cell::new(5, 2),
        "closing it costs 2 steps of the makespan".to_owned()
    )));
    assert!(notes.contains(&(Cell::new(1, 3), "closing it leaves no plan".to_owned())));

    // Pressed on the number, and beside it.
    let press = |x, y| pressed(&state, Point { x, y });
    let (left, low) = (
        (Number::LEFT + 10.0) / 100.0 - 0.5,
        (Number::TOP + 10.0) / 100.0 - 0.5,
    );
    assert_eq!(press(5.0 + left, 2.0 + low), Some(Cell::new(5, 2)));
    assert_eq!(press(5.0, 2.0), None, "the middle of the cell");
    assert_eq!(press(2.0 + left, 1.0 + low), None, "no number there");
}

#[test]
fn lines_are_solid_where_every_best_plan_goes_and_dotted_elsewhere() {
    let state = told();
    let all = lines(&state);
    assert_eq!(all.len(), 3);
    let edges = |path: &str| path.matches('M').count();
    let counted: Vec<[usize; 3]> = all
        .iter()
        .map(|line| [edges(&line.must), edges(&line.may), edges(&line.open)])
        .collect();
    assert_eq!(counted, [[2, 4, 0], [8, 0, 0], [1, 13, 0]]);
    let kinds = legend(&state, &board::Cast::of(&state));
    assert_eq!(kinds, [Kind::Must, Kind::May, Kind::Price, Kind::Late]);
}

#[test]
fn moves_of_this_plan_alone_have_a_line_of_their_own() {
    let state = page(
        &["...", "...", "..."],
        &[[(0, 1), (2, 1)], [(1, 0), (1, 2)]],
    );
    let state = answered(&after(&state, [Action::Solve(SolveAction::Solve)]));
    let state = answered(&after(&state, [SHOW]));
    assert!(saying(&state).ends_with(" There are 2 such plans."));
    let all = lines(&state);
    assert!(all.iter().any(|line| !line.only.is_empty()));
    let middle = Action::Board(BoardAction::Select(Selection::Cell(Cell::new(1, 1))));
    let facts = part(&after(&state, [middle])).unwrap().facts;
    let is_alone = |fact: &&String| fact.ends_with(" in this plan alone.");
    assert_eq!(facts.iter().filter(is_alone).count(), 2, "{facts:?}");
}

#[test]
fn where_only_charges_differ_it_says_so() {
    let state = answered(&after(&crate::sample::solved(), [SHOW]));
    assert!(saying(&state).ends_with(" There are 2 such plans."));
    let column = told_of(&state);
    assert_eq!(
        column.lead,
        "All 35 steps are the same in every best plan, but not when robots charge."
    );
    let ways = known(column.ways.unwrap());
    assert_eq!(
        ways.rows[0].detail,
        "every step is fixed, but not when it charges"
    );
}

#[test]
fn lanes_tell_what_is_fixed_and_how_late_a_robot_may_be() {
    let state = told();
    let answer = state.shown().unwrap();
    let lanes = table::lanes(answer, &state.document.draft);
    let row = Row::of(3, 0);
    let axis = Axis {
        times: 9,
        column: 50.0,
    };
    let marks = |name: &str| lane(&state, name).unwrap();
    let drawn = |index: usize| {
        let lane = &lanes[index];
        marks(&lane.name).shapes(lane, axis, row, &(0..9), true)
    };
    assert_eq!(late(&state, "A2").as_deref(), Some("no slack"));
    assert!(drawn(1).free.is_empty() && drawn(1).late.is_empty());
    assert!(!drawn(2).free.is_empty() && !drawn(2).late.is_empty());
    assert!(
        marks("A2")
            .sentence(&lanes[1])
            .ends_with("8 of 8 steps in every best plan")
    );
    assert!(
        marks("A3")
            .sentence(&lanes[2])
            .ends_with("1 of 6 steps in every best plan")
    );
    // Of the other plan it is another question.
    let narrow = Action::View(ViewAction::SetWide(false));
    let other = after(&state, [narrow, act(FreedomAction::ShowOther(true))]);
    assert_eq!(late(&other, "A3"), None);
}

#[test]
fn of_a_robot_or_a_cell_it_is_asked_and_told() {
    let ready = solved();
    assert_eq!(chip(&ready), Chip::Ready);
    let robot = after(&ready, [select(0)]);
    assert_eq!(part(&robot).unwrap().asks, ["Could A1 be later?"]);
    let cell = Action::Board(BoardAction::Select(Selection::Cell(Cell::new(5, 2))));
    let cell = after(&ready, [cell]);
    assert_eq!(
        part(&cell).unwrap().asks,
        ["Must A1 pass here?", "Must A2 pass here?"]
    );
    let told = answered(&after(&cell, [act(FreedomAction::Ask)]));
    assert_eq!(told.view.selection, Selection::Cell(Cell::new(5, 2)));
    let part = part(&told).unwrap();
    assert_eq!(
        part.facts,
        ["A1 must be here at time 3.", "A2 must be here at time 2."]
    );
    let closing = part.closing.unwrap();
    assert_eq!(closing.1, "Close (5, 2): makespan 10, not 8");
}

#[test]
fn each_part_appears_as_it_is_done() {
    let mut state = after(&solved(), [SHOW]);
    assert!(!state.is_laid_over());
    assert_eq!(told_of(&state).late, Section::Coming);
    let mut parts = on_the_way(&state, usize::MAX);
    parts.push(answer(&state));
    assert!(parts.len() >= FreedomPart::ALL.len(), "{}", parts.len());
    let (mut seen, mut before) = (Vec::new(), 0);
    for part in parts {
        state = after(&state, [part]);
        let column = told_of(&state);
        let is_known = [
            state.is_laid_over(),
            matches!(column.late, Section::Known(_)),
            matches!(column.ways, Some(Section::Known(_))),
            matches!(column.cells, Section::Known(_)),
            matches!(column.other, Some(Section::Known(_))),
        ];
        let count = is_known.iter().filter(|known| **known).count();
        assert!(count >= before, "what is known stays");
        before = count;
        seen.push(count);
    }
    assert_eq!(seen.last(), Some(&5));
    assert!(seen.contains(&2), "one after the other: {seen:?}");
}

#[test]
fn the_file_holds_what_is_told() {
    let save = Action::Intake(IntakeAction::Save(Save::Freedom));
    let asked = after(&told(), [save.clone()]);
    let job = asked.intake.job().unwrap();
    let reply = std::rc::Rc::new(work((*job.task).clone()));
    let saved = Action::Intake(IntakeAction::Reply { job: job.id, reply });
    let saved = reduce(&asked, saved).intake.packed.unwrap();
    assert_eq!(saved.name, "three-ways-freedom.json");
    let json: serde_json::Value = serde_json::from_slice(&saved.bytes).unwrap();
    assert_eq!(json["plans"]["count"], 15);
    assert_eq!(json["status"], "optimal");
    assert_eq!(after(&solved(), [save]).intake.job(), None);
}

#[test]
fn the_only_best_plan_leaves_no_choice() {
    let alone = page(&["...."], &[[(0, 0), (3, 0)]]);
    let alone = answered(&after(&alone, [Action::Solve(SolveAction::Solve)]));
    let state = answered(&after(&alone, [SHOW]));
    assert!(saying(&state).ends_with(" No other plan is as good."));
    let column = told_of(&state);
    assert_eq!(
        column.lead,
        "This plan is the only best one: every step of it must be so."
    );
    assert_eq!((column.ways, column.other), (None, None));
    assert!(lines(&state).iter().all(|line| line.may.is_empty()));
}

#[test]
fn where_it_cannot_be_told_it_says_why() {
    let empty = page(&THREE, &[[(6, 1), (4, 3)]]);
    let is_off = |state, word: &str| match chip(state) {
        Chip::Off(why) => assert!(why.contains(word), "{why}"),
        other => panic!("{other:?}"),
    };
    is_off(&empty, "Solve first");
    let swap = page(&["...."], &[[(0, 0), (3, 0)], [(3, 0), (0, 0)]]);
    let swap = answered(&after(&swap, [Action::Solve(SolveAction::Solve)]));
    is_off(&swap, "There is no plan");
    let refused = after(&empty, [SHOW]);
    assert!(
        refused
            .view
            .notice
            .unwrap()
            .sentence()
            .contains("Solve first")
    );
    assert_eq!(refused.work.request(), None);
    let stale = after(&solved(), [Action::Edit(Edit::RemoveAgent(0))]);
    is_off(&stale, "changed since");
    let mut unproved = solved();
    let mut answer = (**unproved.document.answer.as_ref().unwrap()).clone();
    answer.solved.status = Status::Feasible;
    unproved.document.answer = Some(answer.into());
    is_off(&unproved, "not proved");
}
