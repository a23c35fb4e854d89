//! An answer while it comes: what the plan shows and small variations of it, before the verdict.

use std::collections::BTreeMap;

use giveway_model::{Cell, Cost, Costs};
use giveway_solve::explain::{
    AgentDifference, Core, ExplainAnswer, Fact, FactGroup, FactGroupKind, FactKind, Helps, Here,
    Near, Part, Variation, VariationKind, Verdict,
};

use super::{asked, hear, told};
use crate::ask::{GroupMark, Piece, card};
use crate::board::{SpotSign, reasons};
use crate::reduce::tests::after;
use crate::sample::reach;
use crate::{Action, AskAction, SolveAction, State};

/// A wait elsewhere that makes A2 so much later.
pub(super) fn slide(state: &State, cell: Cell, more: u32) -> Variation {
    let about = &state.document.mode.asking().unwrap().about;
    let before = about.solved.costs.unwrap();
    let plan = about.plan().unwrap();
    let mut moved = giveway_model::Plan::default();
    let path = plan.path("A2").to_vec();
    moved.paths.insert("A2".to_owned(), path);
    Variation {
        kind: VariationKind::Elsewhere,
        other: None,
        cell: Some(cell),
        from: Some(3),
        costs: Costs {
            makespan: before.makespan + more,
            ..before
        },
        deltas: BTreeMap::from([(Cost::Makespan, i64::from(more))]),
        pays: vec![AgentDifference {
            agent: "A2".to_owned(),
            arrival: 18,
            other: 18 + more,
            more_waits: 1,
            other_way: false,
        }],
        plan: moved,
        text: String::new(),
    }
}

/// What is known before the verdict: a plan that costs so much more makespan.
fn near(state: &State, more: u32, variations: Vec<Variation>) -> ExplainAnswer {
    let costs = state
        .document
        .answer
        .as_ref()
        .unwrap()
        .solved
        .costs
        .unwrap();
    ExplainAnswer {
        verdict: Verdict::Unknown,
        reach: reach(Some(0)),
        costs: Some(Costs {
            makespan: costs.makespan + more,
            ..costs
        }),
        deltas: BTreeMap::from([(Cost::Makespan, i64::from(more))]),
        here: Some(Here {
            agent: "A1".to_owned(),
            passing: Vec::new(),
            violations: Vec::new(),
            words: "Going on, A1 would meet A2 at (6, 1) at time 10.".to_owned(),
        }),
        near: Some(Near {
            variations,
            at_most: None,
            words: String::new(),
        }),
        repairs: Vec::new(),
        pending: vec![
            Part::Verdict,
            Part::Closest,
            Part::Witness,
            Part::Core,
            Part::Repairs,
        ],
        ..told(state)
    }
}

fn title(state: &State) -> String {
    card(state).unwrap().verdict.unwrap().title
}

#[test]
fn the_bound_only_falls() {
    let state = hear(&asked(), near(&asked(), 4, Vec::new()));
    assert_eq!(title(&state), "At most 4 steps more until all are done");
    let shown = card(&state).unwrap();
    let verdict = shown.verdict.unwrap();
    assert_eq!(verdict.claim.as_deref(), Some("so far"));
    let robot = Piece::Robot(1, "A2".to_owned());
    assert!(verdict.pieces.contains(&robot), "{:?}", verdict.pieces);
    assert!(verdict.pieces.contains(&Piece::Cell(Cell::new(6, 1))));
    let summary = shown.pays.unwrap().summary;
    assert_eq!(summary.as_deref(), Some("the best found so far"));

    let state = hear(&state, near(&asked(), 6, Vec::new()));
    assert_eq!(title(&state), "At most 4 steps more until all are done");
    let state = hear(&state, near(&asked(), 2, Vec::new()));
    assert_eq!(title(&state), "At most 2 steps more until all are done");
    let state = hear(&state, told(&asked()));
    assert_eq!(title(&state), "It would cost 1 charge");
}

#[test]
fn what_was_cut_off_stands_while_it_goes_on() {
    let state = hear(&asked(), near(&asked(), 4, Vec::new()));
    let state = after(&state, [Action::Solve(SolveAction::Cancel)]);
    assert!(!card(&state).unwrap().coming.unwrap().is_looking);
    let state = after(&state, [Action::Ask(AskAction::Again)]);
    assert!(card(&state).unwrap().coming.unwrap().is_looking);
    assert_eq!(title(&state), "At most 4 steps more until all are done");
    // It begins with what the plan shows: that is no step back.
    let here = ExplainAnswer {
        alternative: None,
        costs: None,
        near: None,
        ..near(&asked(), 0, Vec::new())
    };
    let state = hear(&state, here);
    assert_eq!(title(&state), "At most 4 steps more until all are done");

    // A verdict stands while its reasons are looked for again.
    let state = hear(&state, told(&asked()));
    let state = after(&state, [Action::Solve(SolveAction::Cancel)]);
    let state = after(&state, [Action::Ask(AskAction::Again)]);
    let state = hear(&state, near(&asked(), 9, Vec::new()));
    assert_eq!(title(&state), "It would cost 1 charge");
}

#[test]
fn a_row_of_what_it_could_do_is_the_other_plan() {
    let start = asked();
    let all = vec![
        slide(&start, Cell::new(3, 1), 0),
        slide(&start, Cell::new(4, 2), 0),
        slide(&start, Cell::new(8, 0), 3),
        Variation {
            kind: VariationKind::Swapped,
            other: Some("A2".to_owned()),
            cell: None,
            ..slide(&start, Cell::new(8, 0), 5)
        },
    ];
    let state = hear(&start, near(&start, 4, all.clone()));
    let could = card(&state).unwrap().could;
    let rows: Vec<_> = could
        .iter()
        .map(|row| (row.text.as_str(), row.difference.as_str()))
        .collect();
    assert_eq!(
        rows,
        [
            ("Wait at any of 2 cells", "same"),
            (
                "Go first, and A2 waits instead",
                "at most +5 in the makespan"
            )
        ]
    );
    let cells: Vec<Cell> = reasons(&state).instead.iter().map(|it| it.cell).collect();
    assert_eq!(cells, [Cell::new(3, 1), Cell::new(4, 2)]);

    let chosen = after(&state, [Action::Ask(AskAction::Choose(Some(3)))]);
    let makespan = |state: &State| card(state).unwrap().pays.unwrap().costs[0].other;
    assert_eq!((makespan(&state), makespan(&chosen)), (22, 23));
    // Where it goes first instead, it waits at none of these cells.
    assert_eq!(reasons(&chosen).instead, []);
    // It stays chosen where more become known before it.
    let more = [vec![slide(&start, Cell::new(5, 2), 0)], all].concat();
    let later = hear(&chosen, near(&start, 4, more));
    assert_eq!(makespan(&later), 23);
    assert!(card(&later).unwrap().could[1].is_chosen);
    let back = after(&later, [Action::Ask(AskAction::Choose(None))]);
    assert_eq!(makespan(&back), 22);
}

#[test]
fn groups_of_facts_are_numbered_and_open() {
    let fact = |cell| Fact {
        kind: FactKind::Obstacle,
        agents: Vec::new(),
        cell: Some(cell),
        index: None,
        time: None,
        until: None,
        text: format!("{cell} is an obstacle"),
        helps: Helps::Unknown,
    };
    let group = |cells: Vec<Cell>, facts: Vec<u32>, helps| FactGroup {
        kind: FactGroupKind::Shelf,
        agents: Vec::new(),
        cells,
        facts,
        text: "a shelf".to_owned(),
        needed: true,
        helps,
        price: None,
    };
    let cells = [Cell::new(1, 1), Cell::new(2, 1), Cell::new(5, 1)];
    let core = Core {
        facts: cells.iter().map(|&cell| fact(cell)).collect(),
        groups: vec![
            group(cells[..2].to_vec(), vec![0, 1], Helps::Yes),
            group(cells[2..].to_vec(), vec![2], Helps::No),
        ],
        prices: Vec::new(),
        minimal: true,
        reach: reach(None),
        further: Vec::new(),
    };
    let answer = ExplainAnswer {
        core: Some(core),
        pending: vec![Part::Repairs],
        ..told(&asked())
    };
    let state = hear(&asked(), answer);
    let open = |state: &State| -> Vec<bool> {
        let groups = &card(state).unwrap().cores[0].groups;
        groups.iter().map(|group| group.is_open).collect()
    };
    let groups = &card(&state).unwrap().cores[0].groups;
    assert_eq!(groups[0].mark, GroupMark::Helps);
    assert_eq!(groups[1].mark, GroupMark::Needed);
    assert_eq!(open(&state), [true, false], "the deciding one first");
    let signs: Vec<_> = reasons(&state)
        .spots
        .iter()
        .map(|it| (it.number, it.sign))
        .collect();
    assert_eq!(signs, [(1, SpotSign::Helps), (2, SpotSign::Reason)]);
    assert!(
        reasons(&state).places.is_empty(),
        "numbers, not a frame at every fact"
    );

    let press = |state: &State, index| after(state, [Action::Ask(AskAction::Group(index))]);
    let second = press(&state, 1);
    assert_eq!(open(&second), [false, true]);
    let places: Vec<Cell> = reasons(&second).places.iter().map(|it| it.cell).collect();
    assert_eq!(places, [Cell::new(5, 1)]);
    assert_eq!(open(&press(&second, 1)), [false, false]);
    assert_eq!(open(&press(&state, 0)), [false, false]);
}

#[test]
fn a_search_goes_on_with_the_better_plan_that_is_open() {
    let better = |state: &State| {
        let told = told(state);
        let costs = told.costs.unwrap();
        ExplainAnswer {
            verdict: Verdict::Improvable,
            costs: Some(Costs {
                makespan: costs.makespan - 1,
                ..costs
            }),
            deltas: BTreeMap::from([(Cost::Makespan, -1)]),
            ..told
        }
    };
    let state = hear(&asked(), better(&asked()));
    assert!(card(&state).unwrap().other.unwrap().is_better);
    let from = |state: &State| {
        let state = after(state, [Action::Solve(SolveAction::Solve)]);
        let run = state.work.solving().unwrap();
        run.from
            .as_ref()
            .map(|from| from.solved.costs.unwrap().makespan)
    };
    assert_eq!(from(&state), None, "it was not looked at");
    let opened = after(&state, [Action::Ask(AskAction::ShowOther(true))]);
    assert_eq!(from(&opened), Some(17));
}
