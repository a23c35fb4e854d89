//! What would help: edits after which there is a plan, each tried.
//!
//! A minimal set of facts tells what is worth trying. Where an edit weakens no
//! fact of the set, the set excludes a plan after the edit as before; so single
//! edits outside of it cannot help. One fact is an exception: a slow zone that
//! becomes normal is no mere relaxation (see `group_mus.rs`), so where a set holds
//! without the slow zones, edits outside of it may still help.

mod told;

use giveway_model::{Cell, Costs, Instance, MAX_CAPACITY, Objective, Plan};

use super::{
    answer::{Edit, Repair},
    edits::edited,
    group::{Group, Variant, has_slow_edge},
    group_mus::{Inquiry, Tried},
    words,
};
use giveway_model::sorting::sort_by_key;
use told::{at_most, rank};

/// Cells beyond which new chargers and normal cells are not all tried.
const MOST_CELLS: usize = 64;

/// A question that can also be answered by the best plan.
pub(crate) trait Solver: Inquiry {
    /// The best plan that can be had in time.
    fn best(&mut self, variant: &Variant) -> Option<Best>;
}

/// A plan of an edited instance.
pub(crate) struct Best {
    pub(crate) plan: Plan,
    pub(crate) costs: Costs,
    /// Whether it is proved that none is better, as far as is looked.
    pub(crate) proved: bool,
}

/// What would help.
pub(crate) struct Repairs {
    pub(crate) repairs: Vec<Repair>,
    /// Whether every single edit was tried that could help, each with its best
    /// plan.
    pub(crate) exhaustive: bool,
}

/// Finds repairs, where these facts exclude a plan. `asked` agents stay.
pub(crate) fn repairs(
    instance: &Instance,
    within: Option<u32>,
    facts: &[Group],
    asked: &[usize],
    objective: &Objective,
    solver: &mut dyn Solver,
) -> Repairs {
    let mut search = RepairSearch {
        instance,
        within,
        objective,
        solver,
        exhaustive: facts.contains(&Group::Slow) || !has_slow_edge(instance.grid()),
        found: Vec::new(),
    };
    let singles = search.candidates(facts, asked);
    for candidate in &singles {
        search.attempt(&[candidate]);
    }
    if search.found.is_empty() {
        for (i, first) in singles.iter().enumerate() {
            for second in &singles[i + 1..] {
                search.attempt(&[first, second]);
            }
        }
        // The second edit of a pair may be about a fact outside of this set.
        search.exhaustive = false;
    }
    let mut found = search.found;
    let exhaustive = search.exhaustive;
    sort_by_key(&mut found, |repair| {
        let kinds: Vec<u8> = repair.edits.iter().map(rank).collect();
        let costs = repair.costs.vector(objective);
        (repair.edits.len(), kinds, costs, repair.edits.clone())
    });
    Repairs {
        repairs: at_most(found),
        exhaustive,
    }
}

/// An edit to try; a battery or a deadline as large as is needed.
#[derive(Clone, Debug)]
enum Candidate {
    Edit(Edit),
    Battery(usize),
    Deadline,
}

struct RepairSearch<'a> {
    instance: &'a Instance,
    within: Option<u32>,
    objective: &'a Objective,
    solver: &'a mut dyn Solver,
    exhaustive: bool,
    found: Vec<Repair>,
}

impl RepairSearch<'_> {
    /// Every edit that weakens one of the facts.
    fn candidates(&mut self, facts: &[Group], asked: &[usize]) -> Vec<Candidate> {
        let agents = self.instance.agents();
        let name = |a: usize| agents.get(a).map_or_else(String::new, |a| a.name.clone());
        let mut candidates = Vec::new();
        let any = |test: fn(&Group) -> bool| facts.iter().any(test);
        for &fact in facts {
            match fact {
                Group::Obstacle(cell) => {
                    candidates.push(Candidate::Edit(Edit::RemoveObstacle { cell }));
                }
                Group::Battery(a) => candidates.push(Candidate::Battery(a)),
                Group::Deadline => candidates.push(Candidate::Deadline),
                Group::Waypoint(a, cell) => {
                    let agent = name(a);
                    candidates.push(Candidate::Edit(Edit::DropWaypoint { agent, cell }));
                }
                Group::Task(a) if !asked.contains(&a) => {
                    candidates.push(Candidate::Edit(Edit::LeaveOut { agent: name(a) }));
                }
                Group::Task(_)
                | Group::Collision(..)
                | Group::Stay(_)
                | Group::Slow
                | Group::Floor => {}
            }
        }
        if any(|fact| matches!(fact, Group::Battery(_))) {
            let grid = self.instance.grid();
            let cells = grid.cells();
            let free = cells.filter(|(_, ground)| ground.is_vertex() && !ground.is_charger());
            let cells = self.limited(free.map(|(cell, _)| cell).collect());
            let edits = cells.into_iter().map(|cell| Edit::AddCharger { cell });
            candidates.extend(edits.map(Candidate::Edit));
        }
        if any(|fact| matches!(fact, Group::Slow)) {
            let cells = self.instance.grid().cells();
            let slow = cells.filter(|(_, ground)| ground.is_slow());
            let cells = self.limited(slow.map(|(cell, _)| cell).collect());
            let edits = cells.into_iter().map(|cell| Edit::MakeNormal { cell });
            candidates.extend(edits.map(Candidate::Edit));
        }
        if any(|fact| matches!(fact, Group::Stay(_))) {
            candidates.push(Candidate::Edit(Edit::Vanish));
        }
        candidates
    }

    fn limited(&mut self, mut cells: Vec<Cell>) -> Vec<Cell> {
        self.exhaustive &= cells.len() <= MOST_CELLS;
        cells.truncate(MOST_CELLS);
        cells
    }

    /// Tries edits together; keeps them if they help.
    fn attempt(&mut self, candidates: &[&Candidate]) {
        let mut edits = Vec::new();
        for candidate in candidates {
            match candidate {
                Candidate::Edit(edit) => edits.push(edit.clone()),
                // With the largest battery first, and no deadline.
                Candidate::Battery(agent) => edits.extend(self.battery(*agent, MAX_CAPACITY)),
                Candidate::Deadline => {}
            }
        }
        let no_deadline = candidates.iter().any(|c| matches!(c, Candidate::Deadline));
        let within = self.within.filter(|_| !no_deadline);
        if !self.helps(&edits, within) {
            return;
        }
        if let [Candidate::Battery(agent)] = candidates {
            edits = self.least_battery(*agent);
        }
        let Some(mut best) = self.solver.best(&edited(self.instance, &edits, within)) else {
            self.exhaustive = false;
            return;
        };
        if no_deadline && let Some(within) = self.within {
            let within = self.least_deadline(&edits, within, best.costs.makespan);
            edits.push(Edit::Deadline { within });
            let variant = edited(self.instance, &edits, self.within);
            let Some(sooner) = self.solver.best(&variant) else {
                self.exhaustive = false;
                return;
            };
            // The least deadline is told; with a later one it may cost less.
            let [now, later] = [&sooner, &best].map(|best| best.costs.vector(self.objective));
            self.exhaustive &= now <= later;
            best = sooner;
        }
        let Best {
            plan,
            costs,
            proved,
        } = best;
        self.exhaustive &= proved;
        sort_by_key(&mut edits, rank);
        self.found.push(Repair {
            text: words::repair(&edits, &costs),
            edits,
            costs,
            plan,
        });
    }

    /// The least deadline that helps with some edits, between one that does not
    /// and one that does.
    fn least_deadline(&mut self, edits: &[Edit], mut less: u32, mut enough: u32) -> u32 {
        while enough.saturating_sub(less) > 1 {
            let middle = less + (enough - less) / 2;
            if self.helps(edits, Some(middle)) {
                enough = middle;
            } else {
                less = middle;
            }
        }
        enough
    }

    fn helps(&mut self, edits: &[Edit], within: Option<u32>) -> bool {
        match self.solver.search(&edited(self.instance, edits, within)) {
            Tried::Plan(_) => true,
            Tried::None { .. } => false,
            Tried::Unknown => {
                self.exhaustive = false;
                false
            }
        }
    }

    /// A battery that is larger and fuller by some steps.
    fn battery(&self, agent: usize, by: u32) -> Option<Edit> {
        let agent = self.instance.agents().get(agent)?;
        let battery = agent.battery?;
        let by = by.min(MAX_CAPACITY - battery.capacity);
        Some(Edit::Battery {
            agent: agent.name.clone(),
            capacity: battery.capacity + by,
            initial: battery.initial + by,
        })
    }

    /// The least larger battery that helps, where the largest does.
    fn least_battery(&mut self, agent: usize) -> Vec<Edit> {
        // Twice as much each time, then halving: batteries that help are small.
        let (mut less, mut enough) = (0, 1);
        while enough < MAX_CAPACITY {
            let edits: Vec<Edit> = self.battery(agent, enough).into_iter().collect();
            if self.helps(&edits, self.within) {
                break;
            }
            less = enough;
            enough *= 2;
        }
        while enough - less > 1 {
            let middle = less + (enough - less) / 2;
            let edits: Vec<Edit> = self.battery(agent, middle).into_iter().collect();
            if self.helps(&edits, self.within) {
                enough = middle;
            } else {
                less = middle;
            }
        }
        self.battery(agent, enough).into_iter().collect()
    }
}
