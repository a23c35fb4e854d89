//! A line for each time step, as lacam, pibt2 and mapf-visualizer have it.

use giveway_formats::{CellOrder, Format, recognise};
use giveway_model::check::costs;
use giveway_model::compare::Claimed;

use crate::support::{
    anywhere, assert_comes_back, assert_fault, data, faulty, one, opened, plan, violations,
    with_small,
};

#[test]
fn a_plan_is_read_columns_first_and_is_legal() {
    let text = data("plans/small-result.txt");
    assert_eq!(recognise(&text), Ok(Format::Result));
    let combined = with_small("out.log", &text);
    let read = one(&combined);
    assert_eq!(read.conventions.cells, CellOrder::ColumnRow);
    assert_eq!(violations(&combined), []);
    let costs = costs(&combined.instance, &read.plan).unwrap();
    let claimed = Claimed {
        makespan: Some(u64::from(costs.makespan)),
        sum_of_costs: Some(u64::from(costs.sum_of_costs)),
    };
    assert_eq!(read.claimed, claimed);
    assert_comes_back(Format::Result, &combined);
}

#[test]
fn a_faulty_plan_is_read_as_it_is_and_every_violation_is_found() {
    let combined = with_small("result.txt", &data("plans/small-faulty-result.txt"));
    assert_eq!(violations(&combined), faulty());
}

#[test]
fn starts_and_goals_of_the_file_need_no_scenario() {
    let (map, text) = (data("plans/small.map"), data("plans/small-result.txt"));
    let combined = opened(&[("small.map", &map), ("result.txt", &text)]);
    let whole = with_small("result.txt", &text);
    assert_eq!(combined.instance.agents(), whole.instance.agents());
    assert_eq!(plan(&text).map.as_deref(), Some("small.map"));
}

#[test]
fn rows_first_are_found_out() {
    let text = data("plans/small-result.txt");
    let turned: String = text
        .split_inclusive('(')
        .map(|part| match part.split_once(')') {
            Some((cell, rest)) if cell.contains(',') => {
                let (x, y) = cell.split_once(',').unwrap();
                format!("{y},{x}){rest}")
            }
            _ => part.to_owned(),
        })
        .collect();
    let combined = with_small("result.txt", &turned);
    assert_eq!(one(&combined).conventions.cells, CellOrder::RowColumn);
    let expected = with_small("result.txt", &text);
    assert_eq!(one(&combined).plan, one(&expected).plan);
}

#[test]
fn variants_are_the_same_plan() {
    let text = data("plans/small-result.txt");
    let expected = anywhere(plan(&text));
    let head = "soc=11\nsoc_lb=11\nlb_makespan=5\nsum_of_loss=11\nsum_of_loss_lb=11\nmakespan=5\ngoals=(3,0),(0,2),(3,1),\nstarts=(0,0),(3,2),(0,1)\n";
    let (_, steps) = text.split_once("\nsolution=").unwrap();
    let variants = [
        text.replace('\n', "\r\n"),
        text.trim_end().to_owned(),
        format!("\u{feff}{text}\n\n"),
        text.replace("),\n", ")\n"),
        format!("{head}random_seed=9\nmap_file=small.map\nagents=3\nsolution={steps}"),
    ];
    for variant in variants {
        assert_eq!(anywhere(plan(&variant)), expected, "{variant}");
    }
}

#[test]
fn a_file_without_a_header_is_read_and_so_are_headings() {
    let read = plan("0:(0,0,Y_MINUS),\n1:(0,0,X_PLUS),\n2:(1,0,X_PLUS),\n");
    assert_eq!(read.agents.len(), 1);
    assert_eq!(read.notes, ["Where the robots look is not read."]);
}

#[test]
fn pickups_and_deliveries_are_read_as_walks() {
    let text = "instance=x.txt\nagents=2\nmap_file=m.map\nsolver=PIBT\nsolved=1\nmakespan=1\n\
        starts=(0,0),(3,1),\ntask=\n0:129->113,appear=0,finished=23\n\
        4:342->256,appear=4,finished=24\nsolution=\n\
        0:(0,0)->(2,3):-1,(3,1)->(2,3):4,\n1:(1,0)->(2,3):-1,(2,1)->(2,3):4,\n";
    let read = plan(text);
    assert_eq!(read.agents.len(), 2);
    assert!(read.notes[0].contains("pickups"), "{:?}", read.notes);
}

#[test]
fn a_run_that_found_nothing_says_so() {
    let head = "agents=2\nmap_file=m.map\nsolver=planner\nsolved=0\nsoc=0\nmakespan=0\n\
        starts=(0,0),(3,1),\ngoals=(3,1),(0,0),\nsolution=\n";
    assert_fault(
        head,
        (10, 1),
        "a run in which the other program found no plan (solved=0)",
        "a run with a plan: here is nothing to judge",
    );
    let read = plan(&format!("{head}0:(0,0),(3,1),\n"));
    assert!(read.notes[0].contains("solved=0"), "{:?}", read.notes);
}

#[test]
fn faults_have_their_places() {
    let steps = "\"solution=\" and a line for each time step";
    for (text, at, found, expected) in [
        ("agents=2\nsoc=3\n", (3, 1), "the end of the file", steps),
        ("agents=two\n", (1, 8), "\"two\"", "a number from 0"),
        (
            "agents=2\nsolution=\n0:(0,0),\n",
            (3, 1),
            "1 cell at time 0",
            "2, one for each robot",
        ),
        ("0:(0,0),\n2:(0,0),\n", (2, 1), "2", "1, the next time step"),
        (
            "0:(0,0),\n1:(0,0),(1,0),\n",
            (2, 9),
            "\"(1,0),\"",
            "the end of the line after 1 robot",
        ),
        ("0:(0,0),\n1:(0,),\n", (2, 6), "\"),\"", "a number"),
        (
            "agents=1\nstarts=(0,0),(1,0),\nsolution=\n0:(0,0),\n",
            (4, 1),
            "2 starts before the steps",
            "1, one of each robot",
        ),
    ] {
        assert_fault(text, at, found, expected);
    }
}
