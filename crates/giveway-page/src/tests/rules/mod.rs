//! Rules on the page: marked, written, judged, added, priced, and taken back.

mod change;
mod clash;
mod faces;
mod loosen;
mod lost;
mod marks;
mod outdated;
mod prices;
mod slots;
mod tightened;
mod times;
mod twins;
mod why;

use giveway_model::condition::Times;
use giveway_model::{Cell, Scene};
use giveway_solve::Request;

use super::answered;
use crate::reduce::tests::{after, stroke};
use crate::rules::{RuleAction, Ruling, Slot, Value, card, list};
use crate::{Action, BoardAction, Draft, SolveAction, State, Tool};

/// Two robots that pass a short aisle one behind the other: (2, 1) to (2, 3).
fn scene() -> Scene {
    serde_json::from_str(
        r###"{ "giveway": 1,
          "map": [".......", "##.#.##", "##.#.##", "##.#.##", "......."],
          "agents": [{ "name": "A1", "start": [0, 0], "goal": [0, 4] },
                     { "name": "A2", "start": [1, 0], "goal": [3, 4] },
                     { "name": "A3", "start": [6, 4], "goal": [5, 0] }],
          "constraints": [{ "kind": "one-way", "lane": [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0]] }] }"###,
    )
    .unwrap()
}

fn act(action: RuleAction) -> Action {
    Action::Rules(action)
}

pub(super) fn solved(state: &State) -> State {
    answered(&after(state, [Action::Solve(SolveAction::Solve)]))
}

pub(super) fn fresh() -> State {
    State::new(Draft::new(scene()).unwrap())
}

const AISLE: [(u32, u32); 3] = [(2, 1), (2, 2), (2, 3)];

fn marked() -> State {
    after(&solved(&fresh()), stroke(Tool::Zone, &AISLE))
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
    let both = [
        Some("costs nothing".to_owned()),
        Some("costs 2 steps of the makespan".to_owned()),
    ];
    assert_eq!(texts(&priced), both);
    let row = &list(&priced).unwrap().rows[1];
    let costs = row.price.as_ref().unwrap().costs.iter();
    let costs: Vec<_> = costs
        .map(|cost| (cost.title, cost.with, cost.without))
        .collect();
    assert_eq!(
        costs[..2],
        [("Makespan", Some(10), 8), ("Sum of costs", Some(23), 21)]
    );
    let more = after(&priced, stroke(Tool::Obstacle, &[(6, 0)]));
    assert_eq!(texts(&more), [None, None], "they go");
    assert_eq!(texts(&after(&more, [Action::Undo])), both, "and come back");
    let stopped = after(&asking, [act(RuleAction::Price)]);
    assert!(stopped.work.is_idle() && !stopped.is_pricing());
    assert_eq!(texts(&stopped), [None, None]);
    let edited = after(&asking, stroke(Tool::Obstacle, &[(6, 0)]));
    assert!(edited.work.is_idle(), "an edit ends it");
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
    assert_eq!(shown.words, "no robots at all", "what was typed stays");
    let words = RuleAction::Read("at most 2 robots in zone 1 from 3 to 6".into());
    let unquoted = card(&after(&wrong, [act(words)])).unwrap();
    assert_eq!((unquoted.misread, unquoted.icon), (None, "capacity"));
    let words = RuleAction::Read("at most 1 of all robots but A1 in zone 1".into());
    let rest = after(&wrong, [act(words)]);
    let rule = &rest.view.rules.writing.as_ref().unwrap().rule;
    assert_eq!(rule.sentence(), "At most 1 of A2 and A3 in 'zone 1'");
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
    use crate::keys::{Command, Key, command};
    let escape = |state: &State| {
        let key = Key {
            name: "Escape",
            ..Key::default()
        };
        match command(key, state) {
            Some(Command::Act(action)) => after(state, [action]),
            other => panic!("{other:?}"),
        }
    };
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
    let slot_closed = escape(&state);
    assert!(card(&slot_closed).unwrap().open.is_none(), "the slot first");
    assert!(card(&escape(&slot_closed)).is_none(), "then the card");
    let closed = after(
        &state,
        [act(RuleAction::OpenSlot(None)), select(Selection::Agent(0))],
    );
    assert!(card(&closed).is_none());
}
