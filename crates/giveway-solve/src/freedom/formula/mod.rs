//! One formula whose models are the best plans: all of them, each once.
//!
//! The costs of the best plan are known, so each agent has a latest arrival, and no
//! clause needs to be guarded. Everything that is asked of all best plans is a call
//! under assumptions.

mod agent;
mod caps;
mod costs;
mod layers;
mod rules;
mod succession;
mod way;

use std::rc::Rc;

use giveway_model::{Costs, Objective};

use crate::{
    budget::{Budget, Stop},
    encode::collisions::Collisions,
    problem::Problem,
    sat::{Clauses, Lit, Outcome, Sat},
    single::Place,
    terrain::Vertex,
};
use agent::AgentCode;

pub(super) use caps::{Caps, caps};
pub(super) use layers::Spot;
pub(super) use succession::Succession;
pub(super) use way::{Way, names, plan_of, ways_of};

/// The formula.
pub(super) struct BestPlans<'h> {
    sat: Sat<'h>,
    agents: Vec<AgentCode>,
    /// The latest arrival of any agent.
    latest: u32,
}

impl<'h> BestPlans<'h> {
    /// Writes the formula of all plans that cost no more than the best one.
    pub(super) fn new(
        problem: &Problem,
        caps: &Caps,
        best: (&Objective, &Costs),
        budget: &Rc<Budget<'h>>,
    ) -> Result<Self, Stop> {
        let mut sat = Sat::new(Rc::clone(budget));
        let truth = sat.fresh();
        sat.clause(&[truth]);
        let each = caps.latest.iter().enumerate();
        let agents: Result<Vec<AgentCode>, Stop> = each
            .map(|(agent, &cap)| AgentCode::new(problem, agent, (cap, truth), budget, &mut sat))
            .collect();
        let mut all = Self {
            sat,
            agents: agents?,
            latest: caps.latest.iter().copied().max().unwrap_or(0),
        };
        all.write_collisions(problem, budget)?;
        all.keep_rules(problem, budget)?;
        costs::limit(problem, &all.agents, best, &mut all.sat)?;
        budget.check()?;
        Ok(all)
    }

    fn write_collisions(&mut self, problem: &Problem, budget: &Budget) -> Result<(), Stop> {
        let Self {
            sat,
            agents,
            latest,
        } = self;
        let mut collisions = Collisions::new(problem.relaxed.ignored.clone());
        let terrain = &problem.terrain;
        for (agent, code) in agents.iter().enumerate() {
            budget.check()?;
            for time in 0..=*latest {
                for (place, lit) in code.places_at(time) {
                    match place {
                        Place::At(v) => collisions.occupy(time, v, agent, lit, sat),
                        Place::Along(id) => {
                            let (from, _) = terrain.ends(id);
                            let arc = terrain.arcs(from).iter().find(|arc| arc.id == id);
                            if let (Some(&arc), Some(before)) = (arc, time.checked_sub(1)) {
                                collisions.cross(before, arc, agent, [lit, lit], sat);
                                collisions.cross(time, arc, agent, [lit, lit], sat);
                            }
                            continue;
                        }
                    }
                    let Place::At(u) = place else { continue };
                    for &arc in terrain.arcs(u).iter().filter(|arc| !arc.slow) {
                        if let Some(there) = code.at(time + 1, Place::At(arc.to)) {
                            collisions.cross(time, arc, agent, [lit, there], sat);
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// A best plan under assumptions, as ways agent by agent; `None` where it is
    /// proved that there is none.
    pub(super) fn find(&mut self, assumptions: &[Lit]) -> Result<Option<Vec<Way>>, Stop> {
        match self.sat.solve(assumptions)? {
            Outcome::Unsat(_) => Ok(None),
            Outcome::Sat => {
                let is_true = |lit| self.sat.is_true(lit);
                Ok(Some(
                    self.agents.iter().map(|code| code.way(is_true)).collect(),
                ))
            }
        }
    }

    /// A literal under which one of these holds.
    pub(super) fn some(&mut self, lits: impl IntoIterator<Item = Lit>) -> Lit {
        let selector = self.sat.fresh();
        let mut clause = vec![!selector];
        clause.extend(lits);
        self.sat.clause(&clause);
        selector
    }

    /// Says that a literal of [`BestPlans::some`] is not assumed any more.
    pub(super) fn retire(&mut self, selector: Lit) {
        self.sat.clause(&[!selector]);
    }

    /// Adds a clause that holds under a literal.
    pub(super) fn under(&mut self, selector: Lit, lits: impl IntoIterator<Item = Lit>) {
        let mut clause = vec![!selector];
        clause.extend(lits);
        self.sat.clause(&clause);
    }

    /// A new literal.
    pub(super) fn fresh(&mut self) -> Lit {
        self.sat.fresh()
    }

    /// The collector of clauses, for sums.
    pub(super) fn clauses(&mut self) -> &mut Sat<'h> {
        &mut self.sat
    }

    /// The latest arrival of an agent that is looked at.
    pub(super) fn cap(&self, agent: usize) -> u32 {
        self.agents[agent].cap
    }

    /// "Arrived by a time".
    pub(super) fn by(&self, agent: usize, time: u32) -> Lit {
        self.agents[agent].by(time)
    }

    /// "At this place at this time"; `None` where that cannot be.
    pub(super) fn at(&self, agent: usize, time: u32, place: Place) -> Option<Lit> {
        self.agents[agent].at(time, place)
    }

    /// Where an agent may be at a time.
    pub(super) fn places(&self, agent: usize, time: u32) -> Vec<Place> {
        let places = self.agents[agent].places_at(time);
        places.into_iter().map(|(place, _)| place).collect()
    }

    /// The literals of an agent's charges, by time.
    pub(super) fn charges(&self, agent: usize) -> impl Iterator<Item = (u32, Lit)> + '_ {
        let charges = self.agents[agent].charges.iter();
        charges.map(|(&time, &lit)| (time, lit))
    }

    /// Literals one of which fails in every model with another way of an agent.
    pub(super) fn marks(&self, agent: usize, way: &Way) -> Vec<Lit> {
        let code = &self.agents[agent];
        let open = (0..=code.cap).filter(|&time| !code.is_fixed(time));
        let mut marks: Vec<Lit> = open.filter_map(|time| code.entry(way, time)).collect();
        for (&time, &charge) in &code.charges {
            let charges = way.charges.contains(&time);
            marks.push(if charges { charge } else { !charge });
        }
        marks
    }

    /// A literal for each of some vertices that holds whenever anybody is there.
    pub(super) fn uses(
        &mut self,
        vertices: impl IntoIterator<Item = Vertex>,
    ) -> Vec<(Vertex, Lit)> {
        let each = vertices.into_iter();
        let uses: Vec<(Vertex, Lit)> = each.map(|v| (v, self.sat.fresh())).collect();
        for code in &self.agents {
            for time in 0..=code.cap {
                for &(v, used) in &uses {
                    if let Some(at) = code.at(time, Place::At(v)) {
                        self.sat.clause(&[!at, used]);
                    }
                }
            }
        }
        uses
    }
}
