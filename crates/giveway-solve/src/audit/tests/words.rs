//! What is said of a plan.

use std::collections::BTreeMap;

use giveway_model::{Cost, Costs, Objective, Plan, Version};

use crate::audit::words::{headline, notes};
use crate::audit::{AuditAnswer, AuditStatus, gap};
use crate::budget::Stop;
use crate::{Reach, Stats, Status};

fn costs(makespan: u32, sum_of_costs: u32) -> Costs {
    Costs {
        makespan,
        sum_of_costs,
        ..Costs::default()
    }
}

/// A plan with a sum of costs of 85 and a makespan of 12, about which this is proved.
fn answer(status: AuditStatus, bounds: &[(Cost, u32)], better: Option<Costs>) -> AuditAnswer {
    let objective = Objective::new(vec![Cost::SumOfCosts, Cost::Makespan]).unwrap();
    let bounds: BTreeMap<Cost, u32> = bounds.iter().copied().collect();
    let own = costs(12, 85);
    AuditAnswer {
        giveway: Version,
        legal: status != AuditStatus::Illegal,
        violations: Vec::new(),
        gap: gap(&objective, &own, &bounds),
        objective,
        costs: Some(own),
        bounds,
        reach: Reach::unproved(None),
        status,
        better: better.map(|_| Plan::default()),
        better_costs: better,
        search: Status::Feasible,
        reason: None,
        stats: Stats::default(),
    }
}

#[track_caller]
fn says(answer: &AuditAnswer, expected: &str) {
    let mut said = vec![headline(answer).to_string()];
    said.extend(notes(answer));
    assert_eq!(said.join(" "), expected);
}

#[test]
fn a_legal_plan_is_at_most_so_far_from_the_best() {
    let sum = |bound| [(Cost::SumOfCosts, bound)];
    let mut one = answer(AuditStatus::Feasible, &sum(84), None);
    one.reason = Some(Stop::Time.into());
    says(
        &one,
        "At most 1.2 % above the best: its sum of costs is 85, and no plan has less than 84. \
         The time limit was reached.",
    );
    one.reason = None;
    one.reach = Reach::unproved(Some(40));
    says(
        &one,
        "At most 1.2 % above the best: its sum of costs is 85, and no plan of makespan at most \
         40 has less than 84.",
    );
    says(
        &answer(AuditStatus::Feasible, &sum(0), None),
        "At most 85 above the best: its sum of costs is 85, and no plan has less than 0.",
    );
    says(
        &answer(AuditStatus::Feasible, &sum(85), None),
        "The best sum of costs: proved. Of its makespan, 12, nothing is proved yet.",
    );
    let both = [(Cost::SumOfCosts, 85), (Cost::Makespan, 11)];
    says(
        &answer(AuditStatus::Feasible, &both, None),
        "The best sum of costs: proved. Its makespan is 12, and of those plans none has less \
         than 11.",
    );
}

#[test]
fn a_plan_better_in_a_later_cost_is_told_of() {
    let both = [(Cost::SumOfCosts, 85), (Cost::Makespan, 11)];
    let mut one = answer(AuditStatus::Feasible, &both, Some(costs(11, 85)));
    one.search = Status::Optimal;
    says(
        &one,
        "The best sum of costs: proved. Its makespan is 12, and the least of those plans 11. A \
         better plan was found: sum of costs 85, makespan 11; it is the best: proved.",
    );
}

#[test]
fn a_better_plan_is_named() {
    let mut one = answer(
        AuditStatus::Feasible,
        &[(Cost::SumOfCosts, 84), (Cost::Makespan, 13)],
        Some(costs(13, 84)),
    );
    one.search = Status::Optimal;
    says(
        &one,
        "1.2 % above the best: its sum of costs is 85, and the least is 84. A better plan was \
         found: sum of costs 84, makespan 13; it is the best: proved.",
    );
}

#[test]
fn the_best_plan_is_proved_to_be_it() {
    let both = [(Cost::SumOfCosts, 85), (Cost::Makespan, 12)];
    let mut one = answer(AuditStatus::Optimal, &both, None);
    says(&one, "The best: proved.");
    one.reach = Reach::unproved(Some(40));
    says(
        &one,
        "The best: proved, among plans of makespan at most 40.",
    );
}

#[test]
fn a_plan_below_every_legal_one_had_to_break_a_rule() {
    let one = answer(AuditStatus::Illegal, &[(Cost::SumOfCosts, 90)], None);
    says(
        &one,
        "Illegal: 0 violations of the rules. Its sum of costs is 85, and every legal plan has at \
         least 90. So it had to break a rule.",
    );
    let mut none = answer(AuditStatus::Illegal, &[], None);
    none.search = Status::Impossible;
    says(
        &none,
        "Illegal: 0 violations of the rules. There is no legal plan, no matter how many steps \
         you allow.",
    );
    let legal = answer(
        AuditStatus::Illegal,
        &[(Cost::SumOfCosts, 80)],
        Some(costs(13, 84)),
    );
    says(
        &legal,
        "Illegal: 0 violations of the rules. A legal plan was found: sum of costs 84, makespan \
         13.",
    );
}

#[test]
fn nothing_known_is_no_verdict() {
    says(
        &answer(AuditStatus::Unknown, &[], None),
        "Legal. Nothing is known yet of how good it is.",
    );
}
