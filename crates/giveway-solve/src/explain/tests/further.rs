//! Facts that help the whole scene, further sets, and repairs by two edits.

use giveway_model::Cell;

use super::unsolvable::why;
use crate::{
    explain::{Core, Edit, ExplainAnswer, Fact, FactKind, Helps, edited_instance, facts_claim},
    tests::instance,
};

/// Kind, cell and mark of each fact of a set.
fn marks(core: &Core) -> Vec<(FactKind, Option<Cell>, Helps)> {
    let mark = |fact: &Fact| (fact.kind, fact.cell, fact.helps);
    core.facts.iter().map(mark).collect()
}

fn further(answer: &ExplainAnswer) -> &[Core] {
    answer.core.as_ref().map_or(&[], |core| &core.further)
}

fn edits(answer: &ExplainAnswer) -> Vec<Vec<Edit>> {
    let edits = answer.repairs.iter().map(|repair| repair.edits.clone());
    edits.collect()
}

fn remove(x: u32) -> Edit {
    Edit::RemoveObstacle {
        cell: Cell::new(x, 0),
    }
}

#[test]
fn two_walls_rule_a_plan_out_each_by_itself_and_go_together() {
    let answer = why(&instance("a . # # . A"), None);
    let [first, second] = [answer.core.as_ref(), further(&answer).first()].map(Option::unwrap);
    let wall = |x| (FactKind::Obstacle, Some(Cell::new(x, 0)), Helps::No);
    let task = (FactKind::Task, None, Helps::Yes);
    assert_eq!(marks(first), [task, wall(3)]);
    assert_eq!(marks(second), [task, wall(2)]);
    assert_eq!(further(&answer).len(), 1);
    let leave_out = Edit::LeaveOut {
        agent: "a".to_owned(),
    };
    assert_eq!(
        edits(&answer),
        [vec![leave_out], vec![remove(2), remove(3)]]
    );
    assert!(answer.exhaustive && answer.further_repairs == 0);
    assert!(
        answer.words.contains(
            "remove the obstacle at (2, 0) and remove the obstacle at (3, 0), or to leave a out"
        ),
        "{}",
        answer.words
    );
}

#[test]
fn three_walls_are_three_causes_and_no_pair_of_them_helps() {
    let answer = why(&instance("a # # # A"), None);
    assert_eq!(further(&answer).len(), 2);
    assert_eq!(edits(&answer).len(), 1, "{:?}", edits(&answer));
    assert!(answer.exhaustive);
}

#[test]
fn where_two_robots_are_blocked_apart_nobody_alone_helps() {
    let answer = why(
        &instance(
            "a # A
             # # #
             b # B",
        ),
        None,
    );
    let core = answer.core.as_ref().unwrap();
    assert!(core.facts.iter().all(|fact| fact.helps == Helps::No));
    let claim = facts_claim(&answer.question, answer.verdict, core);
    assert!(
        claim.ends_with(
            "Leaving out only one of them does not help, since other facts rule it out, too."
        ),
        "{claim}"
    );
    let [further] = further(&answer) else {
        panic!("{:?}", answer.core)
    };
    let shared = further.facts.iter().any(|fact| core.facts.contains(fact));
    assert!(!shared, "{further:?}");
    // Each of the two is helped by a wall that goes, or by leaving it out; to leave out
    // both repairs nothing.
    assert_eq!(answer.repairs.len() + answer.further_repairs as usize, 3);
    assert!(answer.repairs.iter().all(|repair| repair.edits.len() == 2));
    assert!(answer.exhaustive);
}

#[test]
fn a_floor_is_a_fact_and_the_highest_that_helps_a_repair() {
    let scene = instance(
        "a . . . A
         floor 3
         battery a 5/5",
    );
    let answer = why(&scene, None);
    let core = answer.core.as_ref().unwrap();
    let kinds: Vec<FactKind> = core.facts.iter().map(|fact| fact.kind).collect();
    assert_eq!(kinds, [FactKind::Task, FactKind::Battery, FactKind::Floor]);
    assert!(core.facts.iter().all(|fact| fact.helps == Helps::Yes));
    let floor = Edit::BatteryFloor { floor: 1 };
    assert!(edits(&answer).contains(&vec![floor.clone()]));
    assert_eq!(edited_instance(&scene, &[floor]).rules().battery_floor, 1);
    assert!(answer.repairs.iter().all(|repair| repair.least));
}

#[test]
fn a_battery_is_made_fuller_before_it_is_made_larger() {
    let battery = |capacity, initial| Edit::Battery {
        agent: "a".to_owned(),
        capacity,
        initial,
    };
    for (picture, least) in [
        ("a . . . A\nbattery a 2/9", battery(9, 4)),
        ("a . . . A\nbattery a 3/3", battery(4, 4)),
    ] {
        let answer = why(&instance(picture), None);
        assert!(
            edits(&answer).contains(&vec![least.clone()]),
            "{picture}: {answer:?}"
        );
    }
}

#[test]
fn the_best_of_each_kind_comes_first_and_the_rest_is_counted() {
    let answer = why(
        &instance(
            "a . . . . . A
             . . . . . . .
             . . . . . . .
             battery a 5/6",
        ),
        None,
    );
    let all = edits(&answer);
    assert!(all.len() == 12 && answer.further_repairs > 0, "{all:?}");
    assert!(matches!(
        all[0][..],
        [Edit::AddCharger { .. } | Edit::Battery { .. }]
    ));
    let single = |test: fn(&Edit) -> bool| {
        all.iter()
            .position(|edits| matches!(&edits[..], [one] if test(one)))
    };
    let battery = single(|edit| matches!(edit, Edit::Battery { .. })).unwrap();
    let out = single(|edit| matches!(edit, Edit::LeaveOut { .. })).unwrap();
    assert!(battery < out && out <= 2, "{all:?}");
}
