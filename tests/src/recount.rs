//! The five costs, counted anew from the paths of a plan.

use giveway_model::{Costs, Plan};

/// The costs of a plan whose paths begin at time 0 and end at the arrivals.
pub fn costs(plan: &Plan) -> Costs {
    let mut costs = Costs::default();
    for path in plan.paths.values() {
        let arrival = path.len() as u32 - 1;
        costs.makespan = costs.makespan.max(arrival);
        costs.sum_of_costs += arrival;
        let mut last = path[0];
        for pair in path.windows(2) {
            if pair[0].is_some() && pair[0] == pair[1] {
                costs.waits += 1;
            }
            if pair[1].is_some() {
                // (A move that had begun before time 0 was counted then.)
                costs.moves += u32::from(last.is_some() && pair[1] != last);
                last = pair[1];
            }
        }
    }
    costs.charges = plan.charges.values().map(|times| times.len() as u32).sum();
    costs
}
