//! The sentence of a rule with slots, for each kind.

use giveway_model::condition::{Times, Visit};
use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, Cell, Constraint};

use super::{act, marked};
use crate::reduce::tests::after;
use crate::rules::{Editor, Piece, RuleAction, Slot, Value, card, parts, pieces};

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
    pieces(rule, &[], is_written)
        .into_iter()
        .map(piece)
        .collect()
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
            "[No robot] in [aisle 1] from [3] to [5]",
            "One way from (2, 2) to (2, 3) for [all robots]",
            "Each cell stays free for [1] step behind [any robot]",
            "[All robots] keep [2] apart from [3] to [5]",
            "[A1] goes to [(2, 2)], then to [(9, 9)]",
            "[Each robot] stays [2] steps at [(2, 2)] from [3] to [5]",
            "[Each robot] is at [(2, 2)] once [without staying] [always]",
            "[Each robot] arrives by [5], not before [3]",
            "Each step after [12] until [each robot] arrives costs [2]",
            "[Each robot] starts from [5] on",
            "[A1] is at [(2, 2)] before [A2] is at [(2, 2)]",
            "[No robot] waits in [aisle 1] [at all]",
            "[No robot] waits more than [2] steps on end in [aisle 1]",
            "[Each robot] needs [1] step for each quarter turn",
            "Each step of [all robots] in [aisle 1] costs [3]",
        ]
    );
    for mut rule in all_kinds() {
        let lit = bracketed(&rule, false).replace(['[', ']'], "'");
        assert_eq!(lit, rule.sentence(), "the zone alone is a piece");
        if parts(&mut rule.kind).has_who {
            rule.agents = Some(vec!["A7".into()]);
            assert!(bracketed(&rule, true).contains("[A7]"), "{rule:?}");
            rule.agents = Some(vec!["A7".into(), "A 8".into()]);
            assert!(bracketed(&rule, true).contains("[A7 and A 8]"), "{rule:?}");
        }
    }
}

#[test]
fn many_robots_are_told_in_few_words() {
    let names: Vec<String> = (1..=9).map(|n| format!("A{n}")).collect();
    let agent = |name: &String| Agent::new(name.as_str(), Cell::new(0, 0), None);
    let agents: Vec<Agent> = names.iter().map(agent).collect();
    let told = |bound: &[String], is_written| {
        let rule = Constraint {
            agents: Some(bound.to_vec()),
            ..rule(ConstraintKind::Apart {
                distance: 2,
                times: Times::default(),
            })
        };
        let pieces = pieces(&rule, &agents, is_written).into_iter();
        pieces
            .map(|piece| match piece {
                Piece::Text(text) => text,
                Piece::Slot(_, text) => format!("[{text}]"),
            })
            .collect::<String>()
    };
    let (but_two, five, four) = (&names[2..], &names[..5], &names[..4]);
    assert_eq!(
        told(but_two, false),
        "All robots but A1 and A2 keep 2 apart"
    );
    assert_eq!(
        told(but_two, true),
        "[All robots but A1 and A2] keep [2] apart [always]"
    );
    assert_eq!(told(five, false), "A1, A2, A3 and 2 more keep 2 apart");
    assert_eq!(told(four, false), "A1, A2, A3 and A4 keep 2 apart");
    assert_eq!(told(&names, false), "A1, A2, A3 and 6 more keep 2 apart");
}

#[test]
fn each_slot_can_be_opened_and_filled() {
    for mut rule in all_kinds() {
        if let Some(zone) = parts(&mut rule.kind).zone {
            "zone 1".clone_into(zone);
        }
        let state = after(&marked(), [act(RuleAction::Write(rule.clone()))]);
        for piece in pieces(&rule, &[], true) {
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
fn times_that_end_before_they_begin_are_told_plainly() {
    let state = after(&marked(), [act(RuleAction::OfZone("zone 1".to_owned()))]);
    let times = Times {
        from: Some(10),
        to: Some(4),
    };
    let closed = rule(ConstraintKind::Closed {
        zone: "zone 1".to_owned(),
        times,
    });
    let state = after(&state, [act(RuleAction::Write(closed))]);
    let judged = card(&state).unwrap().judged;
    assert_eq!(judged.title, "This rule cannot be");
    assert_eq!(
        judged.details,
        ["It would end at time 4, before it begins at time 10."]
    );
}
