//! Plans beside plain formulas.

use giveway_model::{Cell, Instance, Plan};
use giveway_proof::plain::{Cnf, Lit, Name};
use giveway_proof::{Budget, Outcome, prove};

/// Whether a formula allows just this plan.
///
/// # Panics
/// When the formula is too large to solve.
pub fn allows(formula: &Cnf, instance: &Instance, plan: &Plan) -> bool {
    let mut with = formula.clone();
    for (variable, name) in (1..).zip(formula.names()) {
        let lit = |holds: bool| -> Lit { if holds { variable } else { -variable } };
        match *name {
            Name::At(agent, cell, time) => {
                with.clause([lit(place(instance, plan, agent, time) == Some(cell))]);
            }
            Name::Charge(agent, time) => {
                let charges = plan.charges(&instance.agents()[agent].name);
                with.clause([lit(charges.contains(&time))]);
            }
            _ => {}
        }
    }
    match prove(&with, &Budget::default()) {
        Outcome::Satisfiable => true,
        Outcome::Proof(_) => false,
        Outcome::Stopped => panic!("too large"),
    }
}

/// Where an agent is at a time, if it is at a vertex.
fn place(instance: &Instance, plan: &Plan, agent: usize, time: u32) -> Option<Cell> {
    let path = plan.path(&instance.agents()[agent].name);
    match path.get(time as usize) {
        Some(place) => *place,
        None if instance.stays() => path.last().copied().flatten(),
        None => None,
    }
}

/// Whether every place and charge of a plan has a variable, and what is no
/// place is half of a slow move.
pub fn names_all(formula: &Cnf, instance: &Instance, plan: &Plan) -> bool {
    instance.agents().iter().enumerate().all(|(i, agent)| {
        let mut places = plan.path(&agent.name).iter().zip(0..);
        let at = |time: u32, cell: Cell| formula.names().contains(&Name::At(i, cell, time));
        let charges = plan.charges(&agent.name);
        places.all(|(place, time)| place.is_none_or(|cell| at(time, cell)))
            && charges
                .iter()
                .all(|&time| formula.names().contains(&Name::Charge(i, time)))
            && plan.path(&agent.name).last() == Some(&agent.goal)
    })
}
