//! The plain formula beside the judges: a plan satisfies it exactly where
//! `check` finds no violation and `holds` says that the question's contrast
//! holds. Plans are the oracle's best ones for many objectives, and broken ones.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;

use giveway_model::check::check;
use giveway_model::question::holds;
use giveway_model::{Cell, Cost, Instance, Objective, Plan, Question};
use giveway_proof::{Budget, Claim, plain};
use giveway_tests::formula::{allows, names_all};
use giveway_tests::{oracle, random};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Beyond the arrivals of all plans here.
const LAST: u32 = 24;

/// Plans that are best for one cost or another.
fn plans(instance: &Instance) -> Vec<Plan> {
    let mut plans = Vec::new();
    for costs in [
        vec![Cost::Makespan, Cost::Moves],
        vec![Cost::Charges, Cost::Makespan],
        vec![Cost::Moves, Cost::Charges, Cost::Makespan],
        vec![Cost::Waits, Cost::SumOfCosts],
    ] {
        let instance = instance
            .clone()
            .with_objective(Objective::new(costs).unwrap());
        let question = oracle::Question {
            instance: &instance,
            within: Some(LAST),
            cap: 60_000,
        };
        if let oracle::Verdict::Best(point) = question.best()
            && !plans.contains(&point.plan)
        {
            plans.push(point.plan);
        }
    }
    let late = plans.first().map(|plan| later(instance, plan));
    plans.extend(late.filter(|late| check(instance, late).is_valid() && !plans.contains(late)));
    plans
}

/// The same plan, begun a step later.
fn later(instance: &Instance, plan: &Plan) -> Plan {
    let mut late = plan.clone();
    for path in late.paths.values_mut() {
        path.insert(0, path[0]);
    }
    for time in late.charges.values_mut().flatten() {
        *time += 1;
    }
    late.cut_trailing_goals(instance);
    late
}

/// Some agents' paths from one plan, the others' from another; perhaps an entry
/// of it changed, or a charge more or less.
fn mixed(plans: &[Plan], random: &mut ChaCha8Rng) -> Plan {
    let mut plan = plans.choose(random).unwrap().clone();
    let other = plans.choose(random).unwrap();
    let names: Vec<String> = plan.paths.keys().cloned().collect();
    let Some(name) = names.choose(random).cloned() else {
        return plan;
    };
    match random.random_range(0..4) {
        0 => {
            plan.paths.insert(name.clone(), other.path(&name).to_vec());
            plan.charges
                .insert(name.clone(), other.charges(&name).to_vec());
        }
        1 => {
            let path = plan.paths.get_mut(&name).unwrap();
            let place = random.random_range(0..path.len());
            path.insert(place, path[place]);
        }
        2 => {
            let path = plan.paths.get_mut(&name).unwrap();
            if path.len() > 1 {
                path.remove(random.random_range(0..path.len()));
            }
        }
        _ => {
            let charges = plan.charges.entry(name).or_default();
            if charges.pop().is_none() {
                charges.push(random.random_range(0..6));
            }
        }
    }
    plan
}

#[test]
fn a_plan_satisfies_the_formula_exactly_where_it_breaks_no_rule() {
    let (mut valid, mut broken) = (0, 0);
    for number in 0..60 {
        let instance = random::small(21, number);
        let random = &mut ChaCha8Rng::seed_from_u64(number);
        let plans = plans(&instance);
        if plans.is_empty() {
            continue;
        }
        let claim = Claim::default().within(Some(LAST));
        let formula = plain::formula(&instance, &claim, &Budget::default()).unwrap();
        let mut judged = plans.clone();
        judged.extend((0..6).map(|_| mixed(&plans, random)));
        for mut plan in judged {
            plan.cut_trailing_goals(&instance);
            let report = check(&instance, &plan);
            let is_valid = report.violations.is_empty();
            if report.costs.is_none_or(|costs| costs.makespan > LAST) {
                continue;
            }
            // What the formula has no variable for cannot be in a plan.
            let known = is_valid || names_all(&formula, &instance, &plan);
            let allowed = known && allows(&formula, &instance, &plan);
            assert_eq!(
                allowed,
                is_valid,
                "{:?} {:?} {:?}",
                report.violations,
                plan,
                instance.to_scene()
            );
            *(if is_valid { &mut valid } else { &mut broken }) += 1;
        }
    }
    println!("{valid} valid, {broken} broken");
    assert!(valid >= 80 && broken >= 60, "{valid} {broken}");
}

/// Whether an instance has what the number's kind of question is about.
fn suits(number: u64, instance: &Instance) -> bool {
    let grid = instance.grid();
    let mut agents = instance.agents().iter();
    match number % 18 {
        2 | 3 | 13 => {
            grid.cells().any(|(_, ground)| ground.is_charger())
                && agents.any(|agent| agent.battery.is_some_and(|b| b.initial <= 4))
        }
        9 => agents.any(|agent| {
            let mut near = grid.neighbours(agent.start);
            near.any(|next| grid.is_slow_edge(agent.start, next))
        }),
        _ => true,
    }
}

/// A question of the number's kind, about something that may well be so.
fn question(number: u64, instance: &Instance, plan: &Plan, random: &mut ChaCha8Rng) -> Question {
    let name = || plan.paths.keys().next().cloned().unwrap();
    let names: Vec<String> = plan.paths.keys().cloned().collect();
    let agent = names.choose(random).cloned().unwrap_or_else(name);
    let to = names.choose(random).cloned().unwrap_or_else(name);
    let path: Vec<Cell> = plan.path(&agent).iter().flatten().copied().collect();
    let cell = *path.choose(random).unwrap();
    let grid = instance.grid();
    let near: Vec<Cell> = grid.neighbours(cell).chain([cell]).collect();
    let next = *near.choose(random).unwrap();
    let chargers = grid.cells().filter(|(_, ground)| ground.is_charger());
    let chargers: Vec<Cell> = chargers.map(|(cell, _)| cell).collect();
    let charger = chargers.choose(random).copied();
    let mut some = |n: u32| random.random_bool(0.5).then(|| random.random_range(0..n));
    let time = some(8);
    match number % 18 {
        0 | 1 => Question::Wait {
            agent,
            at: (number % 4 < 2).then_some(cell),
            from: some(4),
            to: some(9),
            at_least: some(3),
        },
        2 => Question::Charge {
            agent,
            at: charger.filter(|_| number % 4 == 2),
            time,
        },
        3 => Question::NoCharge {
            agent,
            at: charger.unwrap_or(cell),
        },
        4 => Question::Visit {
            agent,
            at: cell,
            time: time.map(|t| t * 4),
        },
        5 => Question::NoVisit {
            agent: Some(agent),
            at: next,
        },
        6 => Question::NoVisit {
            agent: None,
            at: next,
        },
        7 => Question::Move {
            agent,
            from_cell: cell,
            to_cell: next,
            time,
        },
        8 => Question::NoMove {
            agent,
            from_cell: cell,
            to_cell: next,
            time,
        },
        9 => Question::Slow {
            agent,
            from_cell: time.map(|_| cell),
            to_cell: time.map(|_| next),
        },
        10 => Question::Order {
            agent,
            first: cell,
            second: *path.choose(random).unwrap(),
        },
        11 => Question::Arrival { agent },
        12 => Question::Length {
            agent,
            fewer_than: time,
        },
        13 => Question::Charges { agent: Some(agent) },
        14 => Question::Moves { agent: Some(agent) },
        15 => Question::Waits {
            agent: time.map(|_| agent),
        },
        16 => Question::Yield {
            agent,
            to,
            at: cell,
        },
        _ => [Question::SumOfCosts, Question::Makespan][number as usize / 18 % 2].clone(),
    }
}

#[test]
fn a_plan_satisfies_the_formula_of_a_question_exactly_where_its_contrast_holds() {
    let mut counts: BTreeMap<&str, [u32; 2]> = BTreeMap::new();
    for number in 0..360 {
        let mut instances = (number * 1000..).map(|n| random::small(22, n));
        let instance = instances.find(|i| suits(number, i)).unwrap();
        let random = &mut ChaCha8Rng::seed_from_u64(number);
        let plans = plans(&instance);
        if plans.is_empty() || instance.agents().is_empty() {
            continue;
        }
        let cost = |plan: &&Plan, cost| check(&instance, plan).costs.unwrap().get(cost);
        let asked = match number % 18 {
            11 => plans.iter().max_by_key(|p| cost(p, Cost::SumOfCosts)),
            13 => plans.iter().max_by_key(|p| cost(p, Cost::Charges)),
            14 => plans.iter().max_by_key(|p| cost(p, Cost::Moves)),
            15 => plans.iter().max_by_key(|p| cost(p, Cost::Waits)),
            _ => plans.choose(random),
        };
        let asked = asked.unwrap();
        let question = question(number, &instance, asked, random);
        let Some(claim) = Claim::contrast(&question, &instance, asked) else {
            // There is less than nothing to ask for.
            for other in &plans {
                assert_eq!(holds(&question, &instance, asked, other), Some(false));
            }
            continue;
        };
        let claim = claim.within(Some(LAST));
        let formula = plain::formula(&instance, &claim, &Budget::default()).unwrap();
        let last = claim.horizon(&instance).unwrap();
        for other in &plans {
            let makespan = check(&instance, other).costs.unwrap().makespan;
            let allowed = makespan <= last
                && names_all(&formula, &instance, other)
                && allows(&formula, &instance, other);
            let expected = holds(&question, &instance, asked, other).unwrap();
            assert_eq!(
                allowed,
                expected,
                "{question:?}\nof {asked:?}\nother {other:?}\nin {:?}",
                instance.to_scene()
            );
            counts.entry(question.kind()).or_default()[usize::from(expected)] += 1;
        }
    }
    println!("{counts:?}");
    assert_eq!(counts.len(), 16 + 1, "{counts:?}");
    assert!(counts.values().all(|[no, yes]| no + yes >= 8), "{counts:?}");
}
