//! What would help on a large floor: what the agents that decide could do without is told first.

use std::collections::BTreeSet;

use super::{
    crossing_among_lanes,
    layers::{asked, explain},
};
use crate::explain::{Edit, Helps, Layer, Part, Verdict, edited_instance};
use giveway_model::check::costs;

#[test]
fn leaving_out_those_who_decide_is_told_before_all_else_that_helps() {
    let (instance, plan) = crossing_among_lanes();
    let (answer, told) = explain(&instance, &plan, &asked("makespan"), &[Layer::Help]);
    assert_eq!(answer.verdict, Verdict::Necessary);
    let pending = told.iter().filter(|it| it.pending.contains(&Part::Repairs));
    let first = pending.into_iter().find(|it| !it.repairs.is_empty());
    let first = first.expect("something that helps is told before all was tried");
    let left_out: BTreeSet<&str> = first
        .repairs
        .iter()
        .map(|repair| match &repair.edits[..] {
            [Edit::LeaveOut { agent }] => agent.as_str(),
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(left_out, ["a", "b"].into());
    // What is told later has these, too, and each was solved.
    for repair in &first.repairs {
        assert!(answer.repairs.iter().any(|it| it.edits == repair.edits));
    }
    for repair in &answer.repairs {
        let edited = edited_instance(&instance, &repair.edits);
        assert_eq!(costs(&edited, &repair.plan), Some(repair.costs));
        assert!(repair.costs.makespan < 5);
    }
    // And is a price in the reason.
    let core = answer.core.expect("two agents decide");
    let prices = core.prices.iter().map(|it| (it.fact, it.costs.makespan));
    for (fact, makespan) in prices {
        assert_eq!((core.facts[fact as usize].helps, makespan), (Helps::Yes, 3));
    }
    assert_eq!(core.prices.len(), 3);
}
