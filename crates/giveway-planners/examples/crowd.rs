//! How long LaCAM takes for a crowd, from the files to a judged plan.
//!
//! ```sh
//! cargo run --release -p giveway-planners --example crowd -- MAP SCENARIO AGENTS [STEPS]
//! ```

#![expect(
    clippy::print_stdout,
    reason = "it is run by hand, and what it prints is read"
)]

use std::{env, error::Error, fs};

use cpu_time::ProcessTime;
use giveway_model::{
    Instance,
    check::check,
    format::movingai::{read_map, read_scenario, to_scene},
};
use giveway_planners::{
    budget::{Budget, Unlimited},
    lacam::{Options, lacam},
    pibt::{self, pibt},
    problem::Problem,
    walk::{costs, to_plan},
};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [map, scenario, agents, rest @ ..] = arguments.as_slice() else {
        return Err("MAP SCENARIO AGENTS [STEPS]".into());
    };
    let begin = ProcessTime::now();
    let spent = || begin.elapsed().as_secs_f64();
    let grid = read_map(&fs::read_to_string(map)?).map_err(|fault| format!("{fault:?}"))?;
    let scenario =
        read_scenario(&fs::read_to_string(scenario)?).map_err(|fault| format!("{fault:?}"))?;
    let scene = to_scene("crowd", &grid, &scenario, Some(agents.parse()?))
        .map_err(|fault| format!("{fault:?}"))?;
    let instance = Instance::new(scene).map_err(|faults| format!("{faults:?}"))?;
    println!("{:.3} read", spent());
    let budget = Unlimited::default();
    let Ok(problem) = Problem::new(&instance, &budget) else {
        return Err("an agent alone has no plan".into());
    };
    let optima: u32 = problem.optima.iter().sum();
    let held = budget.held_bytes().get() / 1_000_000;
    println!("{:.3} tables, {held} MB, bound {optima}", spent());
    let names: Vec<String> = instance.agents().iter().map(|a| a.name.clone()).collect();
    let options = Options {
        step_limit: rest.first().map_or(Ok(1_000_000), |steps| steps.parse())?,
        guided: env::var_os("UNGUIDED").is_none(),
        first_only: rest.is_empty(),
        told: 0,
    };
    let report = lacam(&problem, options, &budget, &mut |found| {
        let costs = costs(&problem, &found.walks);
        let (sum, makespan, loss) = (costs.sum_of_costs, costs.makespan, found.loss);
        let (time, steps) = (spent(), found.steps);
        println!("{time:.3} sum {sum}, loss {loss}, makespan {makespan}, {steps} steps");
    });
    let report = report.map_err(|unsupported| format!("{unsupported:?}"))?;
    println!("{:.3} {:?}, {} steps", spent(), report.ended, report.steps);
    if let Some(best) = report.best {
        let judged = check(&instance, &to_plan(&problem, &names, &best.walks));
        println!("{:.3} judged, {:?}", spent(), judged.violations);
    }
    let options = pibt::Options {
        step_limit: 5_000,
        told: 0,
    };
    let begin = ProcessTime::now();
    let report = pibt(&problem, options, &budget).map_err(|u| format!("{u:?}"))?;
    let sum = match &report.outcome {
        pibt::Outcome::Plan(walks) => format!("sum {}", costs(&problem, walks).sum_of_costs),
        other => format!("{other:?}"),
    };
    let time = begin.elapsed().as_secs_f64();
    println!("{time:.3} PIBT alone: {sum}, {} steps", report.steps);
    Ok(())
}
