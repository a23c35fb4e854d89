//! An instance with less in it, or with more room: changes that keep every
//! promise of an instance, so that nothing has to be checked again.
//!
//! Questions are answered by asking about hundreds of variants of one instance.
//! What is left out or opened here can break no promise: names, starts and goals
//! of fewer agents are as different as before, and a vertex stays a vertex.

use super::{Instance, MAX_CAPACITY};
use crate::{Agent, AtGoal, Battery, Cell, Constraint, Ground, constraint::ConstraintKind};

impl Instance {
    /// Keeps some of the agents, and their order.
    ///
    /// ```
    /// use giveway_model::format::native;
    /// let mut instance = native::read_instance(r#"{ "giveway": 1, "map": [".#."],
    ///     "agents": [{ "name": "a", "start": [0, 0], "goal": [0, 0] },
    ///                { "name": "b", "start": [2, 0], "goal": [2, 0] }] }"#).unwrap();
    /// instance.retain_agents(|agent| agent.name == "b");
    /// assert_eq!(instance.agents().len(), 1);
    /// ```
    pub fn retain_agents(&mut self, keep: impl FnMut(&Agent) -> bool) {
        self.agents.retain(keep);
    }

    /// Keeps the first agents only, so many of them.
    pub fn truncate_agents(&mut self, count: usize) {
        self.agents.truncate(count);
        self.keep_rules_of_agents();
    }

    /// Leaves an agent out, and with it the rules that bind nobody any more.
    pub fn leave_out(&mut self, name: &str) {
        self.agents.retain(|agent| agent.name != name);
        self.keep_rules_of_agents();
    }

    /// Leaves out rules that bind nobody any more; the others get new numbers.
    fn keep_rules_of_agents(&mut self) {
        let agents = &self.agents;
        let kept = self.constraints.iter_mut();
        let kept: Vec<bool> = kept.map(|rule| rule.keep_agents(agents)).collect();
        let is_kept = |rule: usize| kept.get(rule).copied().unwrap_or(true);
        let number = |rule: usize| {
            let before = (0..rule).filter(|&other| is_kept(other)).count();
            is_kept(rule).then_some(before)
        };
        self.renumber_rules(number);
        let mut rules = 0..;
        self.constraints
            .retain(|_| rules.next().is_some_and(is_kept));
        if kept.contains(&false) {
            let written = self.as_written.iter().enumerate();
            let written = written.filter(|(rule, _)| is_kept(*rule));
            self.as_written = written.map(|(_, timed)| timed.clone()).collect();
        }
    }

    fn renumber_rules(&mut self, number: impl Fn(usize) -> Option<usize>) {
        for state in self.start_states.values_mut() {
            state.renumber(&number);
        }
    }

    /// The same instance with one agent only; `None` where nobody has the name.
    #[must_use]
    pub fn alone(&self, name: &str) -> Option<Self> {
        let agent = self.agents.iter().find(|agent| agent.name == name)?;
        Some(Self {
            name: self.name.clone(),
            grid: self.grid.clone(),
            rules: self.rules,
            objective: self.objective.clone(),
            assumptions: self.assumptions.clone(),
            agents: vec![agent.clone()],
            zones: self.zones.clone(),
            units: self.units,
            constraints: self.constraints.clone(),
            as_written: self.as_written.clone(),
            start_states: self.start_states.clone(),
        })
    }

    /// Leaves out a waypoint of an agent, by its number.
    pub fn drop_waypoint(&mut self, agent: usize, cell: Cell) {
        if let Some(agent) = self.agents.get_mut(agent) {
            agent.waypoints.retain(|&waypoint| waypoint != cell);
        }
    }

    /// Takes away the limit on an agent's battery, by its number.
    pub fn drop_battery(&mut self, agent: usize) {
        if let Some(agent) = self.agents.get_mut(agent) {
            agent.battery = None;
        }
    }

    /// Gives an agent another battery, by its number: of the largest capacity
    /// that is accepted where it would have more, and full where it would be
    /// fuller than that.
    pub fn replace_battery(&mut self, agent: usize, battery: Battery) {
        if let Some(agent) = self.agents.get_mut(agent) {
            let capacity = battery.capacity.min(MAX_CAPACITY);
            agent.battery = Some(Battery {
                capacity,
                initial: battery.initial.min(capacity),
            });
        }
    }

    /// The same instance with another battery floor: the level below which no
    /// battery may fall.
    ///
    /// ```
    /// use giveway_model::format::native;
    /// let instance = native::read_instance(r#"{ "giveway": 1, "map": [".."],
    ///     "rules": { "battery_floor": 2 }, "agents": [] }"#).unwrap();
    /// assert_eq!(instance.with_battery_floor(0).rules().battery_floor, 0);
    /// ```
    #[must_use]
    pub const fn with_battery_floor(mut self, level: u32) -> Self {
        self.rules.battery_floor = level;
        self
    }

    /// Lets agents vanish at their goals.
    pub const fn let_agents_vanish(&mut self) {
        self.rules.at_goal = AtGoal::Vanish;
    }

    /// Gives a rule of the scene's own another kind, which asks for less, by its number.
    pub fn weaken_rule(&mut self, rule: usize, kind: ConstraintKind) {
        if let Some(rule) = self.constraints.get_mut(rule) {
            rule.kind = kind;
        }
    }

    /// The same instance with one more rule, which fits it. What start states count for a rule
    /// of the next number counts for it.
    #[must_use]
    pub fn with_rule(mut self, rule: &Constraint) -> Self {
        self.constraints.push(Constraint {
            off: false,
            ..rule.clone()
        });
        self
    }

    /// Takes away the last rule. What start states count for it stays, so that
    /// [`Self::with_rule`] adds it again as it was.
    pub fn pop_rule(&mut self) -> Option<Constraint> {
        let rule = self.constraints.pop()?;
        let count = self.constraints.len();
        self.as_written = self.as_written.iter().take(count).cloned().collect();
        Some(rule)
    }

    /// The same instance with this rule, which fits it, as its only one.
    #[must_use]
    pub fn with_only_rule(&self, rule: &Constraint) -> Self {
        let mut alone = self.clone();
        let next = alone.constraints.len();
        alone.renumber_rules(|rule| (rule == next).then_some(0));
        alone.constraints.clear();
        alone.as_written = std::sync::Arc::default();
        alone.with_rule(rule)
    }

    /// Leaves out rules of its own, by number, and what they count of the time before.
    pub fn switch_off(&mut self, is_off: impl Fn(usize) -> bool) {
        for (index, rule) in self.constraints.iter_mut().enumerate() {
            rule.off |= is_off(index);
        }
        for state in self.start_states.values_mut() {
            state.closed_cells.retain(|closed| !is_off(closed.rule));
            state.must_go_on.retain(|&rule| !is_off(rule));
        }
    }

    /// Takes obstacles away.
    pub fn remove_obstacles(&mut self, is_removed: impl Fn(Cell) -> bool) {
        self.grid.change(|cell, ground| match ground {
            Ground::Obstacle if is_removed(cell) => Ground::Free,
            ground => ground,
        });
    }

    /// Takes cells out of the slow zone.
    pub fn make_normal(&mut self, is_normal: impl Fn(Cell) -> bool) {
        self.grid.change(|cell, ground| match ground {
            Ground::Slow if is_normal(cell) => Ground::Free,
            Ground::SlowCharger if is_normal(cell) => Ground::Charger,
            ground => ground,
        });
    }

    /// Puts chargers on cells that are vertices.
    pub fn add_chargers(&mut self, is_charger: impl Fn(Cell) -> bool) {
        self.grid.change(|cell, ground| match ground {
            Ground::Free if is_charger(cell) => Ground::Charger,
            Ground::Slow if is_charger(cell) => Ground::SlowCharger,
            ground => ground,
        });
    }
}
