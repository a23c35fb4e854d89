//! Rules on the page: marked, written, judged, added, priced, and taken back.

use giveway_model::condition::{Times, Visit};
use giveway_model::constraint::ConstraintKind;
use giveway_model::{Cell, Constraint, Scene};
use giveway_solve::{Request, Response, SilentHost, serve};

use super::{Editor, Piece, RuleAction, Ruling, Slot, Value, card, list, pieces};
use crate::reduce::tests::{after, stroke};
use crate::{Action, BoardAction, Draft, SolveAction, State, Tool, WorkerAction};

/// Two robots that pass a short aisle one behind the other: (2, 1) to (2, 3).
fn scene() -> Scene {
    serde_json::from_str(
        r####"{ "giveway": 1,
          "map": [".......", "##.#.##", "##.#.##", "##.#.##", "......."],
          "agents": [{ "name": "A1", "start": [0, 0], "goal": [0, 4] },
                     { "name": "A2", "start": [1, 0], "goal": [3, 4] },
                     { "name": "A3", "start": [6, 4], "goal": [5, 0] }],
          "constraints": [{ "kind": "one-way", "lane": [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0]] }] }"####,
    )
    .unwrap()
}

fn act(action: RuleAction) -> Action {
    Action::Rules(action)
}

fn answered(state: &State) -> State {
    let (job, request) = state.work.request().expect("it works");
    let response = Box::new(serve(&request, &SilentHost));
    after(
        state,
        [Action::Worker(WorkerAction::Respond { job, response })],
    )
}

fn solved(state: &State) -> State {
    answered(&after(state, [Action::Solve(SolveAction::Solve)]))
}

fn fresh() -> State {
    State::new(Draft::new(scene()).unwrap())
}

const AISLE: [(u32, u32); 3] = [(2, 1), (2, 2), (2, 3)];

fn marked() -> State {
    after(&solved(&fresh()), stroke(Tool::Zone, &AISLE))
}

fn rule(kind: ConstraintKind) -> Constraint {
    Constraint {
        kind,
        agents: None,
        name: None,
        off: false,
    }
}

/// One rule of each kind.
fn all_kinds() -> Vec<Constraint> {
    let (zone, cell) = (|| "aisle 1".to_owned(), Cell::new(2, 2));
    let times = Times {
        from: Some(3),
        to: Some(5),
    };
    let visit = |agent: &str| Visit {
        agent: agent.to_owned(),
        cell,
    };
    [
        ConstraintKind::Capacity {
            zone: zone(),
            most: 1,
            times,
        },
        ConstraintKind::Capacity {
            zone: zone(),
            most: 2,
            times: Times::default(),
        },
        ConstraintKind::Closed {
            zone: zone(),
            times,
        },
        ConstraintKind::OneWay {
            lane: vec![cell, Cell::new(2, 3)],
        },
        ConstraintKind::Gap { steps: 1 },
        ConstraintKind::Apart { distance: 2, times },
        ConstraintKind::Sequence {
            agent: "A1".into(),
            cells: vec![cell, Cell::new(9, 9)],
        },
        ConstraintKind::Visit {
            cell,
            stay: 2,
            times,
        },
        ConstraintKind::Visit {
            cell,
            stay: 0,
            times: Times::default(),
        },
        ConstraintKind::Arrive { times },
        ConstraintKind::Late { by: 12, weight: 2 },
        ConstraintKind::Depart { from: 5 },
        ConstraintKind::Before {
            first: visit("A1"),
            second: visit("A2"),
        },
        ConstraintKind::NoWaiting {
            zone: zone(),
            most: 0,
        },
        ConstraintKind::NoWaiting {
            zone: zone(),
            most: 2,
        },
        ConstraintKind::Turns { quarter: 1 },
        ConstraintKind::Avoid {
            zone: zone(),
            weight: 3,
        },
    ]
    .map(rule)
    .into()
}

/// A sentence with its slots in brackets.
fn bracketed(rule: &Constraint, is_written: bool) -> String {
    let piece = |piece: Piece| match piece {
        Piece::Text(text) => text,
        Piece::Slot(_, text) => format!("[{text}]"),
    };
    pieces(rule, is_written).into_iter().map(piece).collect()
}

#[test]
fn each_kind_is_a_sentence_with_slots() {
    let told: Vec<String> = all_kinds()
        .iter()
        .map(|rule| bracketed(rule, true))
        .collect();
    assert_eq!(
        told,
        [
            "At most [1] of [all robots] in [aisle 1] from [3] to [5]",
            "At most [2] of [all robots] in [aisle 1] [always]",
            "None of [all robots] in [aisle 1] from [3] to [5]",
            "One way from (2, 2) to (2, 3) for [all robots]",
            "Each cell stays free for [1] step behind any of [all robots]",
            "[All robots] keep [2] apart from [3] to [5]",
            "[A1] goes to [(2, 2)], then to [(9, 9)]",
            "Each of [all robots] stays [2] steps at [(2, 2)] from [3] to [5]",
            "Each of [all robots] is at [(2, 2)] once [without staying] [always]",
            "Each of [all robots] arrives by [5], not before [3]",
            "Each step after [12] until each of [all robots] arrives costs [2]",
            "Each of [all robots] starts from [5] on",
            "[A1] is at [(2, 2)] before [A2] is at [(2, 2)]",
            "None of [all robots] waits in [aisle 1] [at all]",
            "None of [all robots] waits more than [2] steps on end in [aisle 1]",
            "Each of [all robots] needs [1] step for each quarter turn",
            "Each step of [all robots] in [aisle 1] costs [3]",
        ]
    );
    for mut rule in all_kinds() {
        let lit = bracketed(&rule, false).replace(['[', ']'], "'");
        assert_eq!(lit, rule.sentence(), "the zone alone is a piece");
        if super::parts(&mut rule.kind).has_who {
            rule.agents = Some(vec!["A7".into()]);
            assert!(bracketed(&rule, true).contains("[A7]"), "{rule:?}");
            rule.agents = Some(vec!["A7".into(), "A 8".into()]);
            assert!(bracketed(&rule, true).contains("[A7 and A 8]"), "{rule:?}");
        }
    }
}

#[test]
fn each_slot_can_be_opened_and_filled() {
    for mut rule in all_kinds() {
        if let Some(zone) = super::parts(&mut rule.kind).zone {
            "zone 1".clone_into(zone);
        }
        let state = after(&marked(), [act(RuleAction::Write(rule.clone()))]);
        for piece in pieces(&rule, true) {
            let Piece::Slot(slot, _) = piece else {
                continue;
            };
            let opened = after(&state, [act(RuleAction::OpenSlot(Some(slot)))]);
            let shown = card(&opened).unwrap();
            let (open, editor) = shown.open.expect("an editor");
            assert_eq!(open, slot);
            let value = match (slot, editor) {
                (Slot::Number(index), Editor::Number { value, least }) => {
                    assert!(value >= least);
                    Value::Number(index, 77)
                }
                (Slot::Who, Editor::Names { several: true, .. }) => {
                    Value::Who(Some(vec!["A3".into()]))
                }
                (Slot::Agent(index), Editor::Names { several: false, .. }) => {
                    Value::Agent(index, "A3".into())
                }
                (Slot::Zone, Editor::Names { names, .. }) => {
                    assert_eq!(names, [("zone 1".to_owned(), true)]);
                    continue;
                }
                (Slot::When, Editor::When(_)) => Value::When(Times {
                    from: Some(71),
                    to: Some(72),
                }),
                (Slot::Cell(index), Editor::Cell(_)) => Value::Cell(index, Cell::new(6, 0)),
                (slot, editor) => panic!("{slot:?} {editor:?}"),
            };
            let filled = after(&opened, [act(RuleAction::Fill(value))]);
            let told = filled.view.rules.writing.as_ref().unwrap().rule.sentence();
            let has = |text: &str| told.contains(text);
            assert!(
                has("77") || has("A3") || has("71") || has("(6, 0)"),
                "{slot:?}: {told}"
            );
        }
    }
}

#[test]
fn a_zone_is_marked_and_gets_a_rule_that_is_judged_at_once() {
    let state = marked();
    let zones = &state.document.draft.scene().zones;
    assert_eq!(zones.len(), 1);
    assert_eq!((&*zones[0].name, zones[0].cells().count()), ("zone 1", 3));
    assert!(!state.document.is_stale(), "a zone alone forbids nothing");
    let shown = card(&state).unwrap();
    assert_eq!(shown.place, "3 cells, (2, 1) to (2, 3)");
    assert_eq!(shown.judged.ruling, Ruling::Breaks, "{shown:?}");
    assert!(
        shown.judged.title.starts_with("This plan breaks it "),
        "{shown:?}"
    );
    assert_eq!(shown.judged.details, ["A1 and A2 are in zone 1 then."]);
    let over: Vec<bool> = shown.counts.iter().map(|count| count.is_over).collect();
    let two: Vec<bool> = shown.counts.iter().map(|count| count.robots > 1).collect();
    assert_eq!(over, two, "the counts say the same as the judge");
    assert!(over.contains(&true));
    let icons: Vec<&str> = shown.offers.iter().map(|offer| offer.icon).collect();
    assert_eq!(icons, ["closed", "no-waiting", "avoid"]);
    assert_eq!(shown.stays.len(), 2, "{:?}", shown.stays);
}

#[test]
fn a_rule_that_the_plan_keeps_leaves_the_plan_the_best() {
    let two = act(RuleAction::Fill(Value::Number(0, 2)));
    let state = after(&marked(), [two]);
    let shown = card(&state).unwrap();
    assert_eq!(shown.judged.ruling, Ruling::Keeps, "{:?}", shown.judged);
    assert_eq!(shown.judged.details, ["Added, it stays the best plan."]);
    let added = after(&state, [act(RuleAction::Add)]);
    assert!(!added.document.is_stale() && card(&added).is_none());
    let costs = |state: &State| state.document.fresh_answer().unwrap().solved.costs.unwrap();
    let anew = solved(&added);
    assert_eq!(
        costs(&added).makespan,
        costs(&anew).makespan,
        "as a search says"
    );
    assert_eq!(costs(&added).sum_of_costs, costs(&anew).sum_of_costs);
}

#[test]
fn a_rule_that_the_plan_breaks_makes_it_stale_and_undo_fresh_again() {
    let added = after(&marked(), [act(RuleAction::Add)]);
    assert!(added.document.is_stale());
    assert_eq!(added.view.tool, Tool::Select);
    let shown = list(&added).unwrap();
    assert_eq!(shown.count, "2 in force");
    assert!(shown.rows[1].is_lit && !shown.rows[0].is_lit);
    let undone = after(&added, [Action::Undo]);
    assert!(!undone.document.is_stale(), "the zone is there still");
    assert_eq!(undone.document.draft.scene().zones.len(), 1);
    let undone = after(&undone, [Action::Undo]);
    assert!(undone.document.draft.scene().zones.is_empty() && undone.lit_rule().is_none());
    let solved = solved(&added);
    let costs = solved
        .document
        .fresh_answer()
        .unwrap()
        .solved
        .costs
        .unwrap();
    assert_eq!((costs.makespan, costs.sum_of_costs), (10, 23));
}

#[test]
fn a_rule_off_and_on_again() {
    let added = solved(&after(&marked(), [act(RuleAction::Add)]));
    let off = after(&added, [act(RuleAction::Switch(1))]);
    assert!(
        off.document.is_stale(),
        "a plan without the rule may be better"
    );
    let shown = list(&off).unwrap();
    assert_eq!(shown.count, "1 in force, 1 off");
    assert_eq!(shown.rows[1].price.as_ref().unwrap().text, "off");
    let on = after(&off, [act(RuleAction::Switch(1))]);
    assert!(!on.document.is_stale(), "as it was");
    let gone = after(&on, [act(RuleAction::Remove(1))]);
    assert_eq!(gone.document.draft.scene().constraints.len(), 1);
    assert!(gone.document.is_stale());
}

#[test]
fn what_rules_cost_is_asked_and_goes_when_the_scene_changes() {
    let added = after(&marked(), [act(RuleAction::Add)]);
    let asking = after(&added, [act(RuleAction::Price)]);
    assert!(matches!(
        asking.work.request(),
        Some((_, Request::Price(_)))
    ));
    let shown = list(&asking).unwrap();
    assert_eq!(shown.asking, Some((0, 2)));
    assert_eq!(shown.rows[1].price.as_ref().unwrap().text, "asking …");
    let priced = answered(&asking);
    let texts = |state: &State| -> Vec<Option<String>> {
        let rows = list(state).unwrap().rows.into_iter();
        rows.map(|row| row.price.map(|price| price.text)).collect()
    };
    let both = [Some("free".to_owned()), Some("+2 steps".to_owned())];
    assert_eq!(texts(&priced), both);
    let row = &list(&priced).unwrap().rows[1];
    let without = row.price.as_ref().unwrap().without.clone().unwrap();
    assert!(
        without.starts_with("Without it: makespan 8, sum of costs 21"),
        "{without}"
    );
    let more = after(&priced, stroke(Tool::Obstacle, &[(6, 0)]));
    assert_eq!(texts(&more), [None, None], "they go");
    assert_eq!(texts(&after(&more, [Action::Undo])), both, "and come back");
    let stopped = after(&asking, [act(RuleAction::Price)]);
    assert!(stopped.work.is_idle() && !stopped.is_pricing());
    assert_eq!(texts(&stopped), [None, None]);
    let edited = after(&asking, stroke(Tool::Obstacle, &[(6, 0)]));
    assert!(edited.work.is_idle(), "an edit ends it");
    let refused = serve(
        &Request::Solve(giveway_solve::SolveRequest::default()),
        &SilentHost,
    );
    assert!(!matches!(refused, Response::Priced(_)));
}

#[test]
fn a_zone_goes_on_is_taken_away_and_has_a_name() {
    let press = Action::Board(BoardAction::Press(Cell::new(2, 4)));
    let state = after(&marked(), [press, Action::Board(BoardAction::Release)]);
    assert_eq!(state.document.draft.scene().zones[0].cells().count(), 4);
    let state = after(
        &state,
        [
            Action::Board(BoardAction::Mark {
                cell: Cell::new(2, 4),
                takes: true,
                is_rect: false,
            }),
            Action::Board(BoardAction::Release),
            act(RuleAction::RenameZone("middle aisle".into())),
        ],
    );
    let zone = &state.document.draft.scene().zones[0];
    assert_eq!((&*zone.name, zone.cells().count()), ("middle aisle", 3));
    let shown = card(&state).unwrap();
    assert_eq!(shown.sentence, "At most 1 robot in 'middle aisle'");
    let added = after(
        &state,
        [
            act(RuleAction::Add),
            act(RuleAction::OfZone("middle aisle".into())),
        ],
    );
    let renamed = after(&added, [act(RuleAction::RenameZone("x".into()))]);
    let told = renamed.document.draft.scene().constraints[1].sentence();
    assert_eq!(told, "At most 1 robot in 'x'", "its rules follow");
    let gone = after(&renamed, [act(RuleAction::RemoveZone)]);
    let scene = gone.document.draft.scene();
    assert!(scene.zones.is_empty() && scene.constraints.len() == 1 && card(&gone).is_none());
}

#[test]
fn a_rectangle_is_drawn_and_a_second_zone_begins() {
    let rect = |from, to| {
        vec![
            Action::Board(BoardAction::PickTool(Tool::Zone)),
            Action::Board(BoardAction::Mark {
                cell: from,
                takes: false,
                is_rect: true,
            }),
            Action::Board(BoardAction::Drag(vec![Cell::new(6, 4), to])),
            Action::Board(BoardAction::Release),
        ]
    };
    let state = after(&fresh(), rect(Cell::new(4, 1), Cell::new(5, 3)));
    assert_eq!(
        state.document.draft.scene().zones[0].cells().count(),
        6,
        "the last corner counts"
    );
    let state = after(&state, rect(Cell::new(0, 4), Cell::new(1, 4)));
    let names: Vec<&str> = state
        .document
        .draft
        .scene()
        .zones
        .iter()
        .map(|zone| &*zone.name)
        .collect();
    assert_eq!(names, ["zone 1", "zone 2"], "the tool was picked again");
}

#[test]
fn a_lane_is_led_taken_back_turned_and_ends_at_obstacles() {
    let lanes = |state: &State| -> Vec<String> {
        let rules = state.document.draft.scene().constraints.iter();
        rules.map(Constraint::sentence).collect()
    };
    let turned = after(&fresh(), stroke(Tool::OneWay, &[(3, 0), (2, 0)]));
    assert_eq!(lanes(&turned), ["One way from (5, 0) to (0, 0)"]);
    let same = after(&fresh(), stroke(Tool::OneWay, &[(2, 0), (3, 0)]));
    assert_eq!(same.document.draft, fresh().document.draft);
    let new = after(&fresh(), stroke(Tool::OneWay, &[(4, 4), (6, 4), (5, 4)]));
    assert_eq!(
        lanes(&new)[1],
        "One way from (4, 4) to (5, 4)",
        "taken back"
    );
    let ended = after(
        &fresh(),
        stroke(Tool::OneWay, &[(2, 0), (2, 4), (2, 3), (3, 3)]),
    );
    assert_eq!(lanes(&ended)[1], "One way from (2, 0) to (2, 3)");
    let none = after(&fresh(), stroke(Tool::OneWay, &[(4, 4)]));
    assert_eq!(none.document.draft, fresh().document.draft);
    assert!(!none.history.can_undo());
}

#[test]
fn keys_mark_and_lead() {
    let step = |right, down, carries| {
        Action::Board(BoardAction::StepCursor {
            by: (right, down),
            carries,
        })
    };
    let at = |x, y| Action::Board(BoardAction::MoveCursor(Cell::new(x, y)));
    let pick = |tool| Action::Board(BoardAction::PickTool(tool));
    let lane = after(
        &fresh(),
        [
            pick(Tool::OneWay),
            at(4, 4),
            Action::Board(BoardAction::UseTool),
            step(1, 0, false),
            step(1, 0, false),
            Action::Board(BoardAction::UseTool),
        ],
    );
    let told = lane.document.draft.scene().constraints[1].sentence();
    assert_eq!(told, "One way from (4, 4) to (6, 4)");
    assert!(!lane.has_stroke());
    let zone = after(
        &fresh(),
        [
            pick(Tool::Zone),
            at(2, 1),
            step(0, 1, true),
            step(0, 1, true),
            Action::Board(BoardAction::UseTool),
        ],
    );
    assert_eq!(zone.document.draft.scene().zones[0].cells().count(), 3);
    assert!(card(&zone).is_some() && !zone.has_stroke());
    let dropped = after(
        &fresh(),
        [
            pick(Tool::OneWay),
            at(4, 4),
            Action::Board(BoardAction::UseTool),
            step(1, 0, false),
            Action::Board(BoardAction::Abandon),
        ],
    );
    assert_eq!(dropped.document.draft, fresh().document.draft);
}

#[test]
fn a_rule_is_edited_in_place_and_read_from_words() {
    let added = after(&marked(), [act(RuleAction::Add), act(RuleAction::Edit(1))]);
    assert!(card(&added).unwrap().is_edited);
    let read = after(
        &added,
        [act(RuleAction::Read(
            "no robot in 'zone 1' from 2 to 4".into(),
        ))],
    );
    assert_eq!(card(&read).unwrap().icon, "closed");
    let wrong = after(&read, [act(RuleAction::Read("no robots at all".into()))]);
    let shown = card(&wrong).unwrap();
    assert!(
        shown.misread.is_some() && shown.icon == "closed",
        "{shown:?}"
    );
    let put = after(&read, [act(RuleAction::Add)]);
    let rules = &put.document.draft.scene().constraints;
    assert_eq!((rules.len(), rules[1].kind_name()), (2, "closed"));
    let lost = after(
        &added,
        [act(RuleAction::Read("no robot in 'elsewhere'".into()))],
    );
    assert_eq!(card(&lost).unwrap().judged.ruling, Ruling::Fault);
}

#[test]
fn a_fault_is_said_in_the_card() {
    let times = Times {
        from: Some(9),
        to: Some(3),
    };
    let state = after(&marked(), [act(RuleAction::Fill(Value::When(times)))]);
    let shown = card(&state).unwrap();
    assert_eq!(shown.judged.ruling, Ruling::Fault);
    assert!(!shown.judged.details.is_empty() && !shown.judged.details[0].contains("constraints"));
}

#[test]
fn what_is_selected_decides_what_is_offered() {
    use crate::Selection;
    let begun = |selection| {
        let select = Action::Board(BoardAction::Select(selection));
        let state = after(&solved(&fresh()), [select, act(RuleAction::Begin)]);
        card(&state).unwrap()
    };
    let robot = begun(Selection::Agent(2));
    assert!(
        robot.sentence.starts_with("A3 arrives by "),
        "{}",
        robot.sentence
    );
    assert_eq!(robot.judged.ruling, Ruling::Keeps);
    assert_eq!(begun(Selection::Nothing).icon, "gap");
    let cell = begun(Selection::Cell(Cell::new(2, 2)));
    assert_eq!(cell.sentence, "A1 stays 1 step at (2, 2)");
}

#[test]
fn a_cell_is_pressed_for_its_slot_and_escape_closes() {
    use crate::Selection;
    let select = |selection| Action::Board(BoardAction::Select(selection));
    let state = after(
        &fresh(),
        [
            select(Selection::Cell(Cell::new(2, 2))),
            act(RuleAction::Begin),
        ],
    );
    let state = after(
        &state,
        [
            act(RuleAction::OpenSlot(Some(Slot::Cell(0)))),
            select(Selection::Cell(Cell::new(4, 4))),
        ],
    );
    assert_eq!(card(&state).unwrap().sentence, "A1 stays 1 step at (4, 4)");
    let closed = after(
        &state,
        [act(RuleAction::OpenSlot(None)), select(Selection::Agent(0))],
    );
    assert!(card(&closed).is_none());
}
