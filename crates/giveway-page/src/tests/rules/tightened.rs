//! A bound stays proved when rules are added, and goes where one is taken away.

use giveway_model::Cost;

use super::{act, fresh, marked, solved};
use crate::reduce::tests::{after, stroke};
use crate::rules::RuleAction;
use crate::{Action, SolveAction, State, Tool};

/// What is known of the makespan as a search begins.
fn at_least(state: &State) -> Option<u32> {
    let begun = after(state, [Action::Solve(SolveAction::Solve)]);
    let solving = begun.work.solving().unwrap();
    solving.bounds.get(&Cost::Makespan).copied()
}

#[test]
fn a_bound_holds_with_more_rules_too() {
    assert_eq!(at_least(&fresh()), None, "nothing was proved");
    let added = after(&marked(), [act(RuleAction::Add)]);
    assert!(added.document.is_stale());
    assert_eq!(at_least(&added), Some(8), "the makespan without the rule");
    let begun = after(&added, [Action::Solve(SolveAction::Solve)]);
    assert_eq!(begun.work.solving().unwrap().bounds.len(), 1);

    let with_rule = solved(&added);
    let costs = with_rule.document.answer.as_ref().unwrap().solved.costs;
    assert_eq!(costs.unwrap().makespan, 10);
    let without = after(&with_rule, [act(RuleAction::Switch(1))]);
    assert_eq!(at_least(&without), None, "a plan without it may be better");
    let edited = after(&added, stroke(Tool::Obstacle, &[(6, 0)]));
    assert_eq!(at_least(&edited), None, "the floor is another one");
}
