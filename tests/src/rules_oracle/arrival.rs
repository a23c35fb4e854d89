//! What an agent has done by being at a cell, and whether it may have arrived there.

use super::agent::Mind;
use super::scene::{Kind, RuleScene};

impl RuleScene {
    /// What an agent has become by being where it is: on its way, and arrived where it may.
    pub(super) fn be_there(
        &self,
        agent: usize,
        mut mind: Mind,
        time: i64,
        entered: bool,
    ) -> Vec<Mind> {
        if mind.level.is_some_and(|level| level < self.floor) {
            return Vec::new();
        }
        let here = self.cell(agent, &mind);
        let task = &self.agents[agent];
        mind.seen
            .extend(here.filter(|spot| task.waypoints.contains(spot)));
        let (mut sequence, mut visit) = (0, 0);
        for (number, rule) in self.numbered(agent) {
            match &rule.kind {
                Kind::Closed(zone) | Kind::Capacity(zone, _) => {
                    if !self.is_in(zone, agent, &mind) {
                        mind.uncounted.remove(&number);
                    } else if matches!(rule.kind, Kind::Closed(_))
                        && rule.is_about(time)
                        && !mind.uncounted.contains(&number)
                    {
                        return Vec::new();
                    }
                }
                Kind::Sequence(cells) => {
                    let done = &mut mind.done[sequence];
                    while here.is_some() && cells.get(*done).copied() == here {
                        *done += 1;
                    }
                    sequence += 1;
                }
                Kind::Visit(cell, stay) => {
                    let run = &mut mind.stays[visit];
                    if *run <= *stay {
                        let there = here == Some(*cell) && rule.is_about(time);
                        *run = if there { *run + 1 } else { 0 };
                    }
                    visit += 1;
                }
                _ => {}
            }
        }
        let arrives =
            entered && here == Some(task.goal) && self.may_arrive(agent, &mind, time, false);
        let home = mind.home();
        [mind].into_iter().chain(arrives.then_some(home)).collect()
    }

    /// Whether an agent at its goal may have arrived; `rested` where it arrived before, which
    /// no rule about arrivals looks at here.
    pub(super) fn may_arrive(&self, agent: usize, mind: &Mind, time: i64, rested: bool) -> bool {
        let task = &self.agents[agent];
        let (mut sequence, mut visit) = (0, 0);
        mind.seen == task.waypoints
            && task
                .path
                .as_ref()
                .is_none_or(|path| mind.progress + 1 == path.len())
            && self.numbered(agent).all(|(number, rule)| match &rule.kind {
                Kind::Sequence(cells) => {
                    sequence += 1;
                    mind.done[sequence - 1] == cells.len()
                }
                Kind::Visit(cell, stay) => {
                    visit += 1;
                    let run = mind.stays[visit - 1];
                    let since = if run > 0 {
                        time + 1 - run
                    } else {
                        time.max(rule.from)
                    };
                    run > *stay || !self.vanish && *cell == task.goal && since + stay <= rule.to
                }
                Kind::Arrive => rested || rule.is_about(time),
                Kind::Closed(zone) => {
                    self.vanish
                        || !zone.contains(&task.goal)
                        || rule.to < time
                        || mind.uncounted.contains(&number)
                }
                _ => true,
            })
    }
}
