//! The reader of lines and the parser of all of YAML read the same.

use std::fmt::Write as _;

use proptest::prelude::*;
use proptest::sample::{Index, select};

use super::{lines, read::parsed};
use crate::{Held, Walk};
use giveway_model::compare::Claimed;

/// What both read; `None` for the reader of lines where it leaves a text alone.
fn both(text: &str) -> (Option<Held>, Option<Held>) {
    let by_line =
        lines::read(text).map(|(agents, claimed, note)| super::read::plan(agents, claimed, note));
    (by_line.map(Held::Plan), parsed(text).ok())
}

const PRINTED: &str = "\
statistics:
  cost: 12
  makespan: 7
  runtime: 1.5e-05
schedule:
  agent0:
    - x: 0
      y: -1
      t: 0
    - x: 1
      y: -1
      t: 3
  agent10:
    - x: 2
      y: 0
      t: 0
";

#[test]
fn what_the_library_prints_is_read_by_line() {
    let (by_line, by_parser) = both(PRINTED);
    assert_eq!(by_line, by_parser);
    let Some(Held::Plan(plan)) = by_line else {
        panic!("no plan")
    };
    let claimed = Claimed {
        makespan: Some(7),
        sum_of_costs: Some(12),
    };
    assert_eq!(plan.claimed, claimed);
    let names: Vec<_> = plan.agents.iter().map(|it| it.name.as_deref()).collect();
    assert_eq!(names, [Some("agent0"), Some("agent10")]);
    assert!(matches!(&plan.agents[0].walk, Walk::Cells(cells) if cells.len() == 4));
}

#[test]
fn anything_else_is_left_to_the_parser() {
    let key = format!("agent{}", "1".repeat(2_000));
    let others = [
        (":\n", ":\r\n"),
        ("- x: 0", "-  x: 0"),
        ("y: -1", "y: +1"),
        ("t: 3", "t: 3 # late"),
        ("t: 3\n", "t: 3\n\n"),
        ("agent10", "b"),
        ("agent10", &key),
        ("t: 3\n  agent10", "t: 3"),
        ("  agent10:", "  agent0:"),
        ("t: 3", "t: 0"),
        ("t: 3", "t: 99999999"),
        ("x: 2", "x: 2147483648"),
        ("    - x: 2\n      y: 0\n      t: 0\n", ""),
        ("  cost: 12\n  makespan: 7\n  runtime: 1.5e-05\n", ""),
        ("statistics:", "others:"),
    ];
    for (from, to) in others {
        let text = PRINTED.replacen(from, to, 1);
        assert_ne!(text, PRINTED, "{from}");
        assert_eq!(lines::read(&text), None, "{text}");
    }
}

/// A schedule as the library prints it.
fn schedule() -> impl Strategy<Value = String> {
    let state = (-3..9, 0..9, 0..3_u32);
    let agents = prop::collection::vec(prop::collection::vec(state, 1..4), 1..4);
    (agents, any::<bool>()).prop_map(|(agents, has_statistics)| {
        let mut text = String::new();
        if has_statistics {
            text += "statistics:\n  cost: 12\n  makespan: 7\n  lowLevelExpanded: 3\n";
        }
        text += "schedule:\n";
        for (i, states) in agents.iter().enumerate() {
            let _ = writeln!(text, "  agent{i}:");
            let mut time = 0;
            for (x, y, waits) in states {
                time += waits;
                let _ = writeln!(text, "    - x: {x}\n      y: {y}\n      t: {time}");
                time += 1;
            }
        }
        text
    })
}

/// A text instead of a part of another: where it begins, how long that is.
fn damage() -> impl Strategy<Value = (Index, usize, &'static str)> {
    let bits = vec![
        "",
        "",
        " ",
        "  ",
        "\n",
        "-",
        "0",
        "9",
        ":",
        ": ",
        "- ",
        "#",
        "x",
        "t: 4",
        "e",
        ".",
        "\r",
        "agent0",
        "cost: 1",
        "    - x: 1\n",
        "[",
        "'",
        "|",
        "~",
    ];
    (any::<Index>(), 0..12_usize, select(bits))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn printed_schedules_are_read_the_same(text in schedule()) {
        let (by_line, by_parser) = both(&text);
        prop_assert!(by_line.is_some(), "{text}");
        prop_assert_eq!(by_line, by_parser);
    }

    #[test]
    fn of_damaged_schedules_nothing_else_is_read(
        mut text in schedule(),
        damages in prop::collection::vec(damage(), 1..3),
    ) {
        for (place, length, bit) in damages {
            let from = place.index(text.len());
            let to = (from + length).min(text.len());
            text.replace_range(from..to, bit);
        }
        let (by_line, by_parser) = both(&text);
        if by_line.is_some() {
            prop_assert_eq!(by_line, by_parser, "{}", text);
        }
    }
}
