//! What of a plan of elsewhere goes wrong where it can be seen: on the board and
//! on the lanes.

use std::collections::BTreeMap;

use giveway_model::check::{Rule, Violation};

use super::Audit;
use crate::State;

/// The most agents whose ways are drawn because something goes wrong with them.
const MOST: usize = 24;

/// The middle of a violation in time: of a swap, between two times.
fn middle(violation: &Violation) -> f64 {
    let half = match violation.rule {
        Rule::Swap => 0.5,
        Rule::SlowSwap => 1.0,
        _ => 0.0,
    };
    f64::from(violation.time) + half
}

/// The times at which something goes wrong with each agent, by its name.
pub(super) fn bursts(violations: &[Violation]) -> BTreeMap<String, Vec<f64>> {
    let mut bursts: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for violation in violations {
        let time = middle(violation);
        for agent in &violation.agents {
            let times = bursts.entry(agent.clone()).or_default();
            if times.last() != Some(&time) {
                times.push(time);
            }
        }
    }
    bursts
}

/// The times at which something goes wrong with an agent of the plan shown.
pub fn bursts_of(state: &State, name: &str) -> Vec<f64> {
    let audit = state.audited();
    let times = audit.and_then(|audit| audit.plan.bursts.get(name));
    times.cloned().unwrap_or_default()
}

/// Whose ways ahead are drawn: of a plan that breaks rules only those of robots
/// that have a part in it. `None` draws all.
pub fn ahead(state: &State) -> Option<Vec<usize>> {
    state.audited()?.concerned(state.view.playback.time)
}

impl Audit {
    /// Whom something goes wrong with, by their indices: those of the time shown
    /// and of the times nearest to it. `None` where nothing goes wrong, or with too
    /// many to tell apart.
    fn concerned(&self, time: u32) -> Option<Vec<usize>> {
        let violations = &self.plan.violations;
        let agents = self.plan.answer.draft.agents();
        let index = |name: &String| agents.iter().position(|agent| agent.name == *name);
        let of = |some: &mut dyn Iterator<Item = &Violation>| {
            let mut found: Vec<usize> = some
                .flat_map(|violation| &violation.agents)
                .filter_map(index)
                .collect();
            found.sort_unstable();
            found.dedup();
            found
        };
        if violations.is_empty() {
            return None;
        }
        let all = of(&mut violations.iter().take(10 * MOST));
        if all.len() <= MOST {
            return Some(all);
        }
        Some(of(&mut self.plan.now(time).take(MOST)))
    }
}
