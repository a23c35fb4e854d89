//! Two plans compared, and what files claim of their costs.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use giveway_model::compare::{
    Claimed, ClaimedBounds, Definition, Difference, claimed_bounds, claimed_loss, claims, compare,
};
use giveway_model::format::native;
use giveway_model::{Cell, Cost, Instance, Plan};

/// Two robots on a map of 3 x 2; with `vanish` they are gone on arrival.
fn instance(at_goal: &str) -> Instance {
    native::read_instance(&format!(
        r#"{{ "giveway": 1, "map": ["...", "..."], "rules": {{ "at_goal": "{at_goal}" }},
            "agents": [
                {{ "name": "A1", "start": [0, 0], "goal": [2, 0] }},
                {{ "name": "A2", "start": [0, 1], "goal": [1, 1] }} ] }}"#
    ))
    .unwrap()
}

fn plan(one: &str, other: &str) -> Plan {
    let text = format!(r#"{{ "giveway": 1, "paths": {{ "A1": {one}, "A2": {other} }} }}"#);
    native::read_plan(&text).unwrap()
}

const STRAIGHT: &str = "[[0,0],[1,0],[2,0]]";
const LATER: &str = "[[0,0],[1,0],[1,0],[2,0]]";
const ROUND: &str = "[[0,0],[0,1],[1,1],[2,1],[2,0]]";
const SHORT: &str = "[[0,1],[1,1]]";

#[test]
fn robots_are_the_same_retimed_or_rerouted() {
    let instance = instance("stay");
    for (other, difference, arrival, time) in [
        (STRAIGHT, Difference::Same, 2, None),
        ("[[0,0],[1,0],[2,0],[2,0]]", Difference::Same, 2, None),
        (LATER, Difference::Retimed, 3, Some(2)),
        (ROUND, Difference::Rerouted, 4, Some(1)),
    ] {
        let compared = compare(&instance, &plan(STRAIGHT, SHORT), &plan(other, SHORT));
        let agent = &compared.agents[0];
        assert_eq!(agent.difference, difference, "{other}");
        assert_eq!(agent.arrivals, [Some(2), Some(arrival)], "{other}");
        assert_eq!(agent.first.map(|first| first.time), time, "{other}");
        assert_eq!(compared.agents[1].difference, Difference::Same);
        let delta = i64::from(arrival) - 2;
        assert_eq!(compared.deltas[&Cost::SumOfCosts], delta);
        assert_eq!(compared.with(difference).next(), Some(agent));
    }
}

#[test]
fn where_they_part_is_told_for_both() {
    let compared = compare(
        &instance("stay"),
        &plan(STRAIGHT, SHORT),
        &plan(LATER, SHORT),
    );
    let first = compared.agents[0].first.unwrap();
    assert_eq!(first.cells, [Some(Cell::new(2, 0)), Some(Cell::new(1, 0))]);
    // One that is gone is not where one is that stays.
    let stays = "[[0,0],[1,0],[2,0],[2,1],[2,0]]";
    let compared = compare(
        &instance("vanish"),
        &plan(STRAIGHT, SHORT),
        &plan(stays, SHORT),
    );
    let first = compared.agents[0].first.unwrap();
    assert_eq!(
        (first.time, first.cells),
        (3, [None, Some(Cell::new(2, 1))])
    );
}

#[test]
fn other_charges_are_other_times() {
    let instance = instance("stay");
    let (one, mut other) = (plan(STRAIGHT, SHORT), plan(STRAIGHT, SHORT));
    other.charges.insert("A1".to_owned(), vec![1]);
    let agent = &compare(&instance, &one, &other).agents[0];
    assert_eq!(agent.difference, Difference::Retimed);
    assert_eq!(agent.first.unwrap().time, 1);
}

#[test]
fn a_robot_without_a_path_is_elsewhere() {
    let instance = instance("stay");
    let (one, mut other) = (plan(STRAIGHT, SHORT), plan(STRAIGHT, SHORT));
    other.paths.remove("A2");
    let compared = compare(&instance, &one, &other);
    assert_eq!(compared.costs[1], None);
    assert!(compared.deltas.is_empty());
    let agent = &compared.agents[1];
    assert_eq!(
        (agent.difference, agent.arrivals),
        (Difference::Rerouted, [Some(1), None])
    );
    assert_eq!(agent.first.unwrap().cells, [Some(Cell::new(0, 1)), None]);
}

/// The definition that explains a sum of costs of the plan with a detour, which is 8
/// here: A1 rests at its goal and leaves it again.
fn explained(claimed: u64, written: u64) -> Option<Definition> {
    let rests = "[[0,0],[1,0],[2,0],[2,0],[2,1],[2,1],[2,0]]";
    let plan = plan(rests, "[[0,1],[0,1],[1,1]]");
    let of = |sum| Claimed {
        sum_of_costs: Some(sum),
        makespan: None,
    };
    let claims = claims(&instance("stay"), &plan, of(claimed), of(written));
    assert_eq!(claims[0].counted, Some(8));
    assert_eq!(claims[0].agrees(), claimed == 8);
    claims[0].definition
}

#[test]
fn why_a_file_claims_another_cost_is_found_out() {
    assert_eq!(explained(8, 20), None);
    assert_eq!(explained(20, 20), Some(Definition::WrittenSteps));
    assert_eq!(explained(12, 20), Some(Definition::MakespanForAll));
    assert_eq!(explained(10, 20), Some(Definition::Cells));
    assert_eq!(explained(5, 20), Some(Definition::Moves));
    assert_eq!(explained(7, 20), Some(Definition::AwayFromGoal));
    assert_eq!(explained(99, 20), None);
    let makespan = |n| Claimed {
        makespan: Some(n),
        sum_of_costs: None,
    };
    let plan = plan(STRAIGHT, SHORT);
    for (claimed, definition) in [
        (2, None),
        (3, Some(Definition::Times)),
        (7, Some(Definition::WrittenSteps)),
        (99, None),
    ] {
        let claims = claims(&instance("stay"), &plan, makespan(claimed), makespan(7));
        assert_eq!((claims.len(), claims[0].definition), (1, definition));
    }
}

#[test]
fn an_illegal_plan_and_a_missing_path_explain_no_number() {
    let instance = instance("stay");
    let of = |plan: &Plan| {
        let claimed = Claimed {
            sum_of_costs: Some(5),
            makespan: Some(3),
        };
        let claims = claims(&instance, plan, claimed, claimed);
        assert!(claims.iter().all(|claim| !claim.agrees()));
        claims
            .iter()
            .filter(|claim| claim.definition.is_some())
            .count()
    };
    assert_eq!(of(&plan(STRAIGHT, SHORT)), 2);
    // A jump; a path that is missing.
    assert_eq!(of(&plan("[[0,0],[2,0]]", SHORT)), 0);
    let mut missing = plan(STRAIGHT, SHORT);
    missing.paths.remove("A2");
    assert_eq!(of(&missing), 0);
}

#[test]
fn a_bound_that_a_legal_plan_disproves_is_wrong() {
    let instance = instance("stay");
    let (best, illegal) = (plan(STRAIGHT, SHORT), plan("[[0,0],[2,0]]", SHORT));
    let claimed = ClaimedBounds {
        makespan: Some(2),
        sum_of_costs: Some(4),
        sum_of_loss: Some(3),
        loss: Some(4),
    };
    let proved = [(Cost::SumOfCosts, 3)].into();
    let told = claimed_bounds(&instance, &[&best], claimed, &proved);
    let wrong: Vec<bool> = told.iter().map(|bound| bound.is_wrong).collect();
    assert_eq!(wrong, [true, false, false]);
    assert_eq!(
        told[0].sentence(),
        "The file says that every plan has a sum of costs of at least 4. That is wrong as it is counted here: a legal plan has 3."
    );
    assert_eq!(
        told[1].sentence(),
        "The file says that every plan has a makespan of at least 2; that is not proved here."
    );
    // A plan that is not legal disproves nothing; what is proved is said.
    let told = claimed_bounds(&instance, &[&illegal], claimed, &proved);
    assert!(told.iter().all(|bound| !bound.is_wrong));
    assert!(told[0].sentence().ends_with("; at least 3 is proved here."));
    let loss = claimed_loss(&instance, &best, claimed).unwrap();
    assert_eq!(
        loss,
        "The file says that its sum of loss is 4; it is 3 here."
    );
    assert_eq!(claimed_loss(&instance, &illegal, claimed), None);
}
