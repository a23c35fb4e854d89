//! The planners of the textbook against the oracle and the judge, on random small instances.
//!
//! `GIVEWAY_LONG=1` looks at 2,000 of them, 200 otherwise; `GIVEWAY_RANDOM_SEED`
//! sets the seed.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::{Cost, Costs, Instance, Objective, check::check};
use giveway_planners::{
    planner::{Outcome, Planner, Report},
    problem::Problem,
};
use giveway_tests::oracle::{Question, Verdict};
use giveway_tests::textbook::{self, Steps};
use giveway_tests::{environment, random};

/// What the oracle may make before it gives up.
const CAP: usize = 200_000;

/// How many instances are looked at.
fn count() -> u64 {
    match environment::number("GIVEWAY_LONG", 0) {
        0 => 200,
        _ => 2_000,
    }
}

/// An instance with one of the two costs that CBS knows as its first.
fn instance(number: u64) -> Instance {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let cost = [Cost::Makespan, Cost::SumOfCosts][(number % 2) as usize];
    let objective = Objective::new(vec![cost]).unwrap();
    random::crowded(seed, number).with_objective(objective)
}

/// The least cost, where there is a plan, and the oracle can tell.
enum Truth {
    Least(u32),
    Impossible,
    TooLarge,
}

fn truth(instance: &Instance) -> Truth {
    let question = Question {
        instance,
        within: None,
        cap: CAP,
    };
    match question.best() {
        Verdict::Best(point) => Truth::Least(point.vector[0]),
        Verdict::Impossible => Truth::Impossible,
        Verdict::Capped => Truth::TooLarge,
    }
}

/// The plan of a report, passed by the judge with the costs that it has.
fn judged(instance: &Instance, problem: &Problem, report: &Report) -> Option<Costs> {
    let walks = report.outcome.walks()?;
    let plan = textbook::plan_of(instance, problem, walks);
    let verdict = check(instance, &plan);
    let scene = serde_json::to_string(&instance.to_scene()).unwrap();
    assert!(verdict.is_valid(), "{:?}\n{scene}", verdict.violations);
    assert_eq!(
        verdict.costs,
        Some(textbook::costs(problem, walks)),
        "{scene}"
    );
    verdict.costs
}

/// The first cost of the plan of a report.
fn cost_of(instance: &Instance, problem: &Problem, report: &Report) -> Option<u32> {
    let first = instance.objective().costs()[0];
    judged(instance, problem, report).map(|costs| costs.get(first))
}

#[test]
fn cbs_finds_what_is_best_and_prioritised_planning_nothing_better() {
    let (mut best, mut cut_off, mut impossible) = (0, 0, 0);
    let (mut found, mut failed) = (0, 0);
    for number in 0..count() {
        let instance = instance(number);
        let truth = truth(&instance);
        let Ok(problem) = textbook::problem(&instance) else {
            assert!(!matches!(truth, Truth::Least(_)), "one alone can do it");
            continue;
        };
        let scene = serde_json::to_string(&instance.to_scene()).unwrap();
        let first = instance.objective().costs()[0];
        let cbs = textbook::plan(Planner::Cbs, &instance, &problem, Steps(400_000));
        let cost = cost_of(&instance, &problem, &cbs);
        let bound = cbs.outcome.bound().unwrap();
        assert_eq!(bound.cost(), first);
        match (&truth, &cbs.outcome) {
            (Truth::Least(least), Outcome::Best { proved, .. }) => {
                assert_eq!(
                    (cost, proved.within()),
                    (Some(*least), None),
                    "{number}: {scene}"
                );
                assert_eq!(bound.at_least(), *least, "{number}: {scene}");
                best += 1;
            }
            // Scenes as tight as a sliding puzzle take trees of millions of nodes.
            (Truth::Least(least), Outcome::Stopped { walks: None, .. }) => {
                assert!(bound.at_least() <= *least, "{number}: {scene}");
                cut_off += 1;
            }
            (Truth::Impossible, Outcome::Stopped { walks: None, .. }) => impossible += 1,
            (Truth::TooLarge, _) => {}
            (_, outcome) => panic!("{number}: {outcome:?}\n{scene}"),
        }
        let report = textbook::plan(Planner::Prioritised, &instance, &problem, Steps(u64::MAX));
        match (&truth, &report.outcome) {
            (Truth::Least(least), Outcome::Found { .. }) => {
                assert!(
                    cost_of(&instance, &problem, &report) >= Some(*least),
                    "{number}: {scene}"
                );
                found += 1;
            }
            (Truth::TooLarge, _) => {}
            (_, Outcome::NoOrderWorks { .. }) => failed += 1,
            (_, outcome) => panic!("{number}: {outcome:?}\n{scene}"),
        }
    }
    println!("CBS: {best} best, {cut_off} cut off, {impossible} impossible");
    println!("prioritised planning: {found} found, {failed} not");
    let share = |n: u64, percent: u64| n * 100 >= count() * percent;
    assert!(
        share(best, 60) && share(found, 50),
        "too few plans to compare"
    );
    assert!(!share(cut_off, 5), "too many scenes without an end");
}

/// The same instance with nothing but starts and goals, which is all that the
/// planners of crowds know.
fn plain(instance: &Instance) -> Instance {
    let mut scene = instance.to_scene();
    for row in &mut scene.map {
        *row = row.replace(['~', '*', '+'], ".");
    }
    for agent in &mut scene.agents {
        agent.waypoints.clear();
        agent.battery = None;
    }
    Instance::new(scene).unwrap()
}

/// How often plans were found, none was, and a planner refused.
#[derive(Debug, Default)]
struct Tally {
    found: u64,
    none: u64,
    refused: u64,
}

impl Tally {
    fn add(&mut self, planner: Planner, instance: &Instance) {
        let Ok(problem) = textbook::problem(instance) else {
            return;
        };
        let scene = serde_json::to_string(&instance.to_scene()).unwrap();
        let report = textbook::plan(planner, instance, &problem, Steps(50_000));
        let cost = cost_of(instance, &problem, &report);
        match (truth(instance), &report.outcome, cost) {
            (Truth::Least(least), Outcome::Found { .. } | Outcome::Stopped { .. }, Some(cost)) => {
                assert!(cost >= least, "{planner}: {scene}");
                self.found += 1;
            }
            (Truth::TooLarge, ..) => {}
            (_, Outcome::Stopped { .. }, None) => self.none += 1,
            (_, Outcome::Refused { .. }, None) => self.refused += 1,
            (_, outcome, _) => panic!("{planner}: {outcome:?}\n{scene}"),
        }
    }
}

#[test]
fn crowds_and_neighbourhoods_are_legal_and_never_below_the_best() {
    let [mut pibt, mut lacam, mut lns] = [(); 3].map(|()| Tally::default());
    for number in 0..count() {
        let instance = instance(number);
        lns.add(Planner::Lns, &instance);
        let plain = plain(&instance);
        pibt.add(Planner::Pibt, &plain);
        lacam.add(Planner::Lacam, &plain);
    }
    println!("PIBT {pibt:?}; LaCAM {lacam:?}; LNS {lns:?}");
    for (tally, percent) in [(pibt, 40), (lacam, 50), (lns, 60)] {
        assert!(tally.found * 100 >= count() * percent, "{tally:?}");
    }
}
