//! Traces looked at from outside: whether they replay, and the claims of their cores as
//! limits for the oracle.

use std::collections::BTreeMap;

use giveway_model::{Cost, Costs, Instance, Objective};
use giveway_solve::trace::{Core, Scope, SearchEvent, SearchTrace};
use giveway_solve::{SolveAnswer, Status};

use crate::oracle::AtMost;

/// What is wrong with a trace beside its answer: nothing where bounds rise, plans become
/// better, and the last event says what the answer says.
pub fn replay(answer: &SolveAnswer) -> Vec<String> {
    let Some(trace) = &answer.trace else {
        return vec!["there is no trace".to_owned()];
    };
    let mut replay = Replay {
        objective: &trace.objective,
        ..Replay::default()
    };
    let mut number = 0;
    let mut conflicts = 0;
    for event in &trace.events {
        if event.number != number && (trace.left_out == 0 || event.number < number) {
            replay.complain(format!("{} comes after {number}", event.number));
        }
        if event.conflicts < conflicts {
            replay.complain(format!("{} has fewer conflicts", event.number));
        }
        (number, conflicts) = (event.number + 1, event.conflicts);
        if event.text.is_empty() || !event.text.ends_with('.') {
            replay.complain(format!("{} is no sentence", event.number));
        }
        replay.take(&event.event);
    }
    if number != trace.events.len() as u64 + trace.left_out {
        replay.complain("events are missing".to_owned());
    }
    if answer.stats.conflicts < conflicts {
        replay.complain("the answer took fewer conflicts".to_owned());
    }
    replay.end(answer, trace);
    replay.faults
}

/// What is known by an event.
struct Replay<'a> {
    objective: &'a Objective,
    best: Option<Costs>,
    /// The bound of each cost in the proof under way, and the greatest of all.
    bounds: BTreeMap<Cost, u32>,
    greatest: BTreeMap<Cost, u32>,
    faults: Vec<String>,
}

static EMPTY: std::sync::LazyLock<Objective> = std::sync::LazyLock::new(Objective::default);

impl Default for Replay<'_> {
    fn default() -> Self {
        Self {
            objective: &EMPTY,
            best: None,
            bounds: BTreeMap::new(),
            greatest: BTreeMap::new(),
            faults: Vec::new(),
        }
    }
}

impl Replay<'_> {
    fn complain(&mut self, fault: String) {
        self.faults.push(fault);
    }

    fn vector(&self, costs: Option<Costs>) -> Option<Vec<u32>> {
        costs.map(|costs| costs.vector(self.objective))
    }

    fn take(&mut self, event: &SearchEvent) {
        match event {
            SearchEvent::Alone {
                cost,
                agents,
                at_least,
            } => {
                let least = agents.iter().map(|agent| agent.least);
                let bound = match cost {
                    Cost::Makespan => least.max().unwrap_or(0),
                    _ => least.sum(),
                };
                if bound != *at_least {
                    self.complain(format!("{at_least} is not what {cost:?} alone make"));
                }
                self.bounds.insert(*cost, *at_least);
                self.raise(*cost, *at_least);
            }
            SearchEvent::Plan { costs, .. } => {
                let (new, old) = (self.vector(Some(*costs)), self.vector(self.best));
                if old.is_some() && new >= old {
                    self.complain(format!("{new:?} is no better than {old:?}"));
                }
                self.best = Some(*costs);
            }
            SearchEvent::Core(core) => {
                if core.to != core.from + 1 {
                    self.complain(format!("a core raises {} to {}", core.from, core.to));
                }
                let literals = core.literals;
                if literals.after > literals.before {
                    self.complain(format!("a core became larger: {literals:?}"));
                }
                if literals.after as usize != core.limits.len() + core.sums.len() {
                    self.complain(format!("a core of {literals:?} has other limits"));
                }
                self.rise(core.cost, core.from, core.to);
            }
            SearchEvent::Counted { cost, at_least, .. } => {
                // (Cores of a sum go on counting without it.)
                if *cost == Cost::Makespan {
                    self.bounds.insert(*cost, *at_least);
                }
                self.raise(*cost, *at_least);
            }
            SearchEvent::Closed { cost, from, to, .. } => self.rise(*cost, *from, *to),
            SearchEvent::Exhausted { bounds } => {
                for (&cost, &bound) in bounds {
                    self.bounds.insert(cost, bound);
                    self.raise(cost, bound);
                }
            }
            SearchEvent::Restarted { .. } => {
                let trace = &self.greatest;
                self.bounds = trace.keys().map(|&cost| (cost, 0)).collect();
            }
            SearchEvent::Met { costs, .. } => {
                for (&cost, &value) in costs {
                    if self.best.map(|best| best.get(cost)) != Some(value) {
                        self.complain(format!("no plan has {cost:?} {value}"));
                    }
                    if self.greatest.get(&cost) != Some(&value) {
                        self.complain(format!("nothing proves {cost:?} {value}"));
                    }
                }
            }
            SearchEvent::Phase { given, .. } => {
                for (&cost, &value) in given {
                    if self.greatest.get(&cost) != Some(&value) {
                        self.complain(format!("nothing proves {cost:?} {value}"));
                    }
                }
            }
            SearchEvent::Round { .. }
            | SearchEvent::Entered { .. }
            | SearchEvent::Impossible(_)
            | SearchEvent::Stopped(_) => {}
        }
    }

    /// The bound of a cost rises in the proof under way.
    fn rise(&mut self, cost: Cost, from: u32, to: u32) {
        let known = self.bounds.get(&cost).copied();
        // After a new beginning it begins with what agents need alone.
        if known.is_none_or(|known| known != 0 && known != from) {
            self.complain(format!("{cost:?} is {known:?}, but rises from {from}"));
        }
        if to <= from {
            self.complain(format!("{cost:?} falls from {from} to {to}"));
        }
        self.bounds.insert(cost, to);
        self.raise(cost, to);
        let best = self.best.map(|best| best.get(cost));
        let is_first = self.objective.costs().first() == Some(&cost);
        if is_first && best.is_some_and(|best| to > best) {
            self.complain(format!("{cost:?} {to} is above the best plan"));
        }
    }

    fn raise(&mut self, cost: Cost, to: u32) {
        let greatest = self.greatest.entry(cost).or_insert(to);
        *greatest = to.max(*greatest);
    }

    fn end(&mut self, answer: &SolveAnswer, trace: &SearchTrace) {
        let last = trace.events.last().map(|event| &event.event);
        let agrees = match (answer.status, last) {
            (Status::Optimal, Some(SearchEvent::Met { costs, within })) => {
                let vector: Vec<u32> = trace
                    .objective
                    .costs()
                    .iter()
                    .filter_map(|c| costs.get(c).copied())
                    .collect();
                Some(vector) == self.vector(answer.costs) && *within == answer.reach.within()
            }
            (Status::Impossible, Some(SearchEvent::Impossible(cannot))) => {
                cannot.within == answer.reach.within()
            }
            (Status::Feasible | Status::Unknown, Some(SearchEvent::Stopped(stopped))) => {
                stopped.costs == answer.costs && stopped.bounds == answer.bounds
            }
            _ => false,
        };
        if !agrees {
            self.complain(format!("the end is {last:?}"));
        }
        // (A calm plan of the same costs in the objective may differ in others.)
        if self.vector(self.best) != self.vector(answer.costs) {
            self.complain(format!("the best plan is {:?}", self.best));
        }
        let is_end = |event: &SearchEvent| {
            matches!(event, SearchEvent::Impossible(_) | SearchEvent::Stopped(_))
        };
        let ends = trace.events.iter().filter(|event| is_end(&event.event));
        let last_is_end = last.is_some_and(is_end);
        if ends.count() != usize::from(last_is_end) {
            self.complain("it ends before the end".to_owned());
        }
    }
}

/// The claims of a core, each as limits that no plan keeps: the core itself, where it is
/// about agents alone, and what its agents need together.
pub fn claims(core: &Core) -> Vec<Vec<AtMost>> {
    let mut claims = Vec::new();
    if core.sums.is_empty() {
        let mut limits = limits(&core.scope, core.cost);
        for limit in &core.limits {
            limits.push(AtMost {
                cost: core.cost,
                agents: Some(vec![limit.agent.clone()]),
                most: limit.at_most,
            });
        }
        claims.push(limits);
    }
    if let Some(together) = &core.together {
        let mut limits = limits(&core.scope, core.cost);
        let least: u32 = together.agents.iter().map(|agent| agent.least).sum();
        limits.push(AtMost {
            cost: core.cost,
            agents: Some(together.agents.iter().map(|a| a.agent.clone()).collect()),
            most: least + together.more - 1,
        });
        claims.push(limits);
    }
    claims
}

/// The plans that a claim is about.
pub fn limits(scope: &Scope, cost: Cost) -> Vec<AtMost> {
    let given = scope.given.iter().map(|(&cost, &most)| (cost, most));
    let better = scope.at_most.map(|most| (cost, most));
    let within = scope.within.map(|most| (Cost::Makespan, most));
    let all = given.chain(better).chain(within);
    all.map(|(cost, most)| AtMost {
        cost,
        agents: None,
        most,
    })
    .collect()
}

/// The instance with the agents alone that a core names.
pub fn alone(instance: &Instance, core: &Core) -> Instance {
    let mut scene = instance.to_scene();
    let is_named = |name: &String| {
        let own = core.limits.iter().any(|limit| limit.agent == *name);
        let others = core.together.iter().flat_map(|together| &together.agents);
        own || !core.sums.is_empty() && others.map(|a| &a.agent).any(|agent| agent == name)
    };
    scene.agents.retain(|agent| is_named(&agent.name));
    Instance::new(scene).expect("fewer agents are as valid")
}
