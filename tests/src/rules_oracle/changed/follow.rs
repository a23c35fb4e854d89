//! A plan followed step by step: whether it breaks a rule.

use giveway_model::Plan;

use super::{ChangedRules, ends_at, on};
use crate::rules_oracle::agent::{Mind, Where};
use crate::rules_oracle::scene::Spot;

impl ChangedRules {
    /// Whether the rest of a plan breaks no rule. It is one of the problem without rules.
    ///
    /// # Panics
    /// When the plan lacks an agent.
    pub fn allows(&self, plan: &Plan) -> bool {
        let stays = !self.after.vanish;
        let mut been = self.been.clone();
        let paths = self.agents.iter().map(|running| {
            let from = plan.from.get(&running.name).copied().unwrap_or(0);
            let path = plan.path(&running.name).iter();
            let path = path.map(|entry| entry.map(|it| (i64::from(it.x), i64::from(it.y))));
            let before = std::iter::repeat_n(None, from as usize);
            before.chain(path).collect()
        });
        let paths: Vec<Vec<Option<Spot>>> = paths.collect();
        let arrival = |agent: usize| ends_at(&paths[agent]);
        let last = (0..paths.len())
            .map(arrival)
            .max()
            .unwrap_or(0)
            .max(self.at);
        // Each agent's states that do as the plan does, some of which differ in their batteries.
        let is_there = |agent: usize, mind: &Mind, time: i64| {
            let here = on(&paths[agent], time, stays);
            match mind.place {
                Where::Gone => true,
                Where::Home => time >= arrival(agent),
                Where::At(spot) => time < arrival(agent) && here == Some(spot),
                Where::On(..) => time < arrival(agent) && here.is_none(),
            }
        };
        let each = self.agents.iter().enumerate().map(|(agent, running)| {
            let minds = running.states.iter().map(|(mind, _)| mind);
            let minds = minds.filter(|mind| is_there(agent, mind, self.at));
            minds.cloned().collect()
        });
        let mut minds: Vec<Vec<Mind>> = each.collect();
        for time in self.at..=last {
            let Some(now) = minds
                .iter()
                .map(|each| each.first())
                .collect::<Option<Vec<&Mind>>>()
            else {
                return false;
            };
            if !self.after.may_be(&now, time, &been) {
                return false;
            }
            been = self.after.been(&now, &been);
            if time == last {
                let now: Vec<Mind> = now.into_iter().cloned().collect();
                return self.after.is_over(&now, time);
            }
            let after = minds.iter().enumerate().map(|(agent, each)| {
                let name = &self.agents[agent].name;
                let charges = plan.charges(name).iter().any(|&it| i64::from(it) == time);
                let ways = each
                    .iter()
                    .flat_map(|mind| self.after.ways(agent, mind, time));
                let ways = ways.filter(|way| (way.costs[0] > 0) == charges);
                let next = ways.map(|way| way.to);
                next.filter(|mind| is_there(agent, mind, time + 1))
                    .collect()
            });
            minds = after.collect();
        }
        true
    }
}
