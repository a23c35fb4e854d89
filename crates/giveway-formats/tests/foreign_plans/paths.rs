//! A line for each robot, as CBSH2-RTC, EECBS, PBS and MAPF-LNS2 write it.

use std::fmt::Write as _;

use giveway_formats::{CellOrder, Format, Origin, Walk, recognise};
use giveway_model::check::costs;

use crate::support::{
    anywhere, assert_comes_back, assert_fault, data, faulty, one, opened, plan, violations,
    with_small,
};

#[test]
fn a_plan_is_read_rows_first_and_is_legal() {
    let text = data("plans/small-paths.txt");
    assert_eq!(recognise(&text), Ok(Format::Paths));
    let combined = with_small("out.log", &text);
    let read = one(&combined);
    assert_eq!(read.conventions.cells, CellOrder::RowColumn);
    assert!(read.fit.is_perfect());
    assert_eq!(violations(&combined), []);
    let costs = costs(&combined.instance, &read.plan).unwrap();
    assert_eq!((costs.sum_of_costs, costs.makespan), (11, 5));
    assert_comes_back(Format::Paths, &combined);
}

#[test]
fn a_faulty_plan_is_read_as_it_is_and_every_violation_is_found() {
    let combined = with_small("paths.txt", &data("plans/small-faulty-paths.txt"));
    assert_eq!(one(&combined).conventions.cells, CellOrder::RowColumn);
    assert_eq!(violations(&combined), faulty());
}

#[test]
fn columns_first_and_cells_from_1_are_found_out() {
    let text = data("plans/small-paths.txt");
    let turned = |turn: fn(i32, i32) -> (i32, i32)| {
        let mut written = String::new();
        for (i, agent) in plan(&text).agents.iter().enumerate() {
            let Walk::Cells(cells) = &agent.walk else {
                panic!("{agent:?}")
            };
            let _ = write!(written, "Agent {i}: ");
            for cell in cells {
                let (first, second) = turn(cell.first, cell.second);
                let _ = write!(written, "({first},{second})->");
            }
            written.push('\n');
        }
        written
    };
    let expected = with_small("paths.txt", &text);
    let columns = with_small("paths.txt", &turned(|row, column| (column, row)));
    assert_eq!(one(&columns).conventions.cells, CellOrder::ColumnRow);
    assert_eq!(one(&columns).plan, one(&expected).plan);
    let from_one = with_small("paths.txt", &turned(|row, column| (row + 1, column + 1)));
    assert_eq!(one(&from_one).conventions.origin, Origin::One);
    assert_eq!(one(&from_one).plan, one(&expected).plan);
}

#[test]
fn a_plan_with_a_map_alone_has_its_ends_as_tasks() {
    let (map, text) = (data("plans/small.map"), data("plans/small-paths.txt"));
    let combined = opened(&[("small.map", &map), ("paths.txt", &text)]);
    let whole = with_small("paths.txt", &text);
    assert_eq!(combined.instance.agents(), whole.instance.agents());
    assert_eq!(one(&combined).plan, one(&whole).plan);
}

#[test]
fn variants_are_the_same_plan() {
    let text = data("plans/small-paths.txt");
    let expected = anywhere(plan(&text));
    let variants = [
        text.replace('\n', "\r\n"),
        text.trim_end().to_owned(),
        format!("\u{feff}{text}\n\n"),
        text.replace("->\n", "\n"),
        text.replace("->", " -> ").replace(',', ", "),
        text.replace("Agent 2", "Agent 3")
            .replace("Agent 1", "Agent 2")
            .replace("Agent 0", "Agent 1"),
    ];
    for variant in variants {
        assert_eq!(anywhere(plan(&variant)), expected, "{variant}");
    }
}

#[test]
fn mapf_lns2_writes_no_blank_and_columns_first() {
    let read = plan("Agent 0:(0,1)->(0,2)->\nAgent 1:(3,1)->\n");
    assert_eq!(read.documented.cells, CellOrder::ColumnRow);
    let read = plan("Agent 0: (0,1)->(0,2)->\nAgent 1: (3,1)->\n");
    assert_eq!(read.documented.cells, CellOrder::RowColumn);
}

#[test]
fn faults_have_their_places() {
    let cell = "a cell, such as (3,1)";
    for (text, at, found, expected) in [
        ("Agent 0: (0,1)->(0;2)->", (1, 19), "\";2)->\"", "\",\""),
        ("Agent 0: x", (1, 10), "\"x\"", cell),
        (
            "Agent 0: (0,1)->\nAgent 2: (0,1)->",
            (2, 7),
            "no path of robot 1",
            "a path of each robot, numbered from 0 or 1 without a gap",
        ),
        (
            "Agent 0: (0,1)->\nAgent 1: (0,99999999999)->\n",
            (2, 13),
            "\"99999999999)->\"",
            "a number of at most 2147483647",
        ),
        ("Agent 0: (0,1", (1, 14), "the end of the file", "\")\""),
        (
            "Agent 0: (0,1) (0,2)",
            (1, 16),
            "\"(0,2)\"",
            "\"->\" and a cell, or the end of the line",
        ),
    ] {
        assert_fault(text, at, found, expected);
    }
}
