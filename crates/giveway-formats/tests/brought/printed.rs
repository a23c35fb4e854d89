//! What clingo prints.

use giveway_formats::{Format, recognise};
use giveway_model::check::check;

use super::{brought, opened, refused};

const NODES: &str = "init(object(node,1),value(at,(1,1))) init(object(node,2),value(at,(2,1)))";
const ROBOT: &str = "init(object(robot,1),value(at,(1,1)))";
const MOVE: &str = "occurs(object(robot,1),action(move,(1,0)),1)";

#[test]
fn the_facts_of_an_answer_are_an_instance() {
    let combined = opened(&[("clingo.txt", &brought("clingo.txt"))]).unwrap();
    assert_eq!(combined.instance.grid().rows(), [".."]);
    assert_eq!(recognise(&brought("clingo.txt")), Ok(Format::Asprilo));
}

#[test]
fn the_last_answer_counts() {
    let text = format!(
        "clingo version 5.8.0 (abc)\nReading from m.lp ...\nm.lp:3:1-9: info: atom does not occur\n\
         Solving...\nAnswer: 1 (Time: 0.010s)\n{ROBOT}\nOptimization: 9\nAnswer: 2 (Time: 0.020s)\n\
         {NODES} {ROBOT} {MOVE}\nOptimization: 1\nOPTIMUM FOUND\n\nModels       : 2\n  Optimum    : yes\n\
         Calls        : 1\nTime         : 0.021s (Solving: 0.00s)\nCPU Time     : 0.020s\n"
    );
    for text in [text.clone(), text.replace('\n', "\r\n")] {
        let combined = opened(&[("out.txt", &text)]).unwrap();
        let plan = &combined.plans[0].plan;
        assert_eq!(plan.paths.values().next().unwrap().len(), 2);
    }
}

#[test]
fn a_plan_without_its_instance_is_read_with_that() {
    let instance = format!("{NODES} {ROBOT}").replace(") i", "). i") + ".";
    let plan = format!("Solving...\nAnswer: 1\n{MOVE}\nSATISFIABLE\n");
    let combined = opened(&[("m.lp", &instance), ("out.txt", &plan)]).unwrap();
    let paths = &combined.plans[0].plan.paths;
    assert_eq!(paths.values().next().unwrap().len(), 2, "{paths:?}");
    let _ = check(&combined.instance, &combined.plans[0].plan);
}

#[test]
fn no_answer_is_told_as_such() {
    let check = |text: &str, expected: &str| {
        let told = refused(text);
        assert!(told.contains(expected), "{told}");
    };
    check(
        "clingo version 5.7.1\nSolving...\nUNSATISFIABLE\n",
        "line 3, column 1: found UNSATISFIABLE: clingo found that there is no answer",
    );
    check(
        "clingo version 5.7.1\nSolving...\nUNKNOWN\n",
        "UNKNOWN: clingo stopped before",
    );
    check(
        "clingo version 5.7.1\nSolving...\n",
        "ends before its first answer",
    );
    check(
        "clingo version 5.7.1\nSolving...\nSATISFIABLE\n",
        "does not show its answer",
    );
    check(
        "Answer: 1\n\nSATISFIABLE\n",
        "an answer of clingo without facts",
    );
}

#[test]
fn a_fault_in_an_answer_keeps_its_place() {
    let text = format!(
        "clingo version 5.7.1\nAnswer: 1\n{NODES} init(object(robot,1),value(at,(0,1)))\nSATISFIABLE\n"
    );
    assert!(
        refused(&text).starts_with("line 3, column 105"),
        "{}",
        refused(&text)
    );
}

#[test]
fn facts_in_one_line_are_read() {
    let text = format!("{NODES} {ROBOT} {MOVE}");
    assert_eq!(opened(&[("Pasted text", &text)]).unwrap().plans.len(), 1);
}
