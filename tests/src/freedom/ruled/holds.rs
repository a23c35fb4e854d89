//! For how long agents can stand still, tried with the judge.

use giveway_model::check::check;
use giveway_model::{Cell, Instance, Objective, Plan};
use giveway_solve::freedom::{FreedomAnswer, Hold};

/// For how long agents can stand still at each time, by trying with the judge.
pub(super) fn holds(
    instance: &Instance,
    plan: &Plan,
    (objective, answer): (&Objective, &FreedomAnswer),
) -> Vec<String> {
    let first = objective.costs()[0];
    let most = check(instance, plan).costs.unwrap().get(first);
    let longest = plan.paths.values().map(Vec::len).max().unwrap_or(0);
    let long = longest as u32 + 40;
    let mut faults = Vec::new();
    for agent in instance.agents() {
        let name = &agent.name;
        let path = plan.path(name).to_vec();
        let mut expected = Vec::new();
        for time in 0..path.len() - 1 {
            let Some(here) = path[time] else {
                expected.push(Hold::InTransit);
                continue;
            };
            let passes = |steps: u32| {
                let mut moved: Vec<Option<Cell>> = path[..time].to_vec();
                moved.extend((0..steps).map(|_| Some(here)));
                moved.extend(&path[time..]);
                [0, steps].into_iter().any(|at_once| {
                    let mut later = plan.clone();
                    later.paths.insert(name.clone(), moved.clone());
                    let charges = plan.charges(name).iter();
                    let charges = charges.map(|&at| match at.cmp(&(time as u32)) {
                        std::cmp::Ordering::Less => at,
                        std::cmp::Ordering::Equal => at + at_once,
                        std::cmp::Ordering::Greater => at + steps,
                    });
                    let charges: Vec<u32> = charges.collect();
                    if !charges.is_empty() {
                        later.charges.insert(name.clone(), charges);
                    }
                    let report = check(instance, &later);
                    let cost = report.costs.map(|costs| costs.get(first));
                    report.violations.is_empty() && cost.is_some_and(|cost| cost <= most)
                })
            };
            let steps = (1..=long).take_while(|&steps| passes(steps)).count() as u32;
            expected.push(if steps == long {
                Hold::Unlimited
            } else {
                Hold::Steps(steps)
            });
        }
        let slack = answer.slack.as_ref().and_then(|all| all.get(name));
        let said = slack.map(|slack| &slack.hold);
        if said != Some(&expected) {
            faults.push(format!("{name} holds {said:?}, not {expected:?}"));
        }
    }
    faults
}
