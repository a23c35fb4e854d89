//! Where a battery is lowest, told in the group of its agent.

use giveway_model::{Cell, check::levels, tr};

use super::FactGroupKind;
use crate::explain::{answer::Core, answer::FactKind, fitting::FittingQuestion};

/// The lowest level of a battery in a plan, when and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Tightest {
    /// In steps of the instance's plan.
    time: u32,
    cell: Cell,
    left: u32,
}

/// Adds to each group about one agent with a limited battery where that is lowest in the plan.
pub(crate) fn tell_tightest(case: &FittingQuestion, core: &mut Core) {
    let batteries = core.facts.iter().enumerate();
    let batteries = batteries.filter(|(_, fact)| fact.kind == FactKind::Battery);
    let batteries: Vec<u32> = batteries.map(|(place, _)| place as u32).collect();
    for group in &mut core.groups {
        let ([agent], FactGroupKind::Agent) = (group.agents.as_slice(), group.kind) else {
            continue;
        };
        let has_battery = group.facts.iter().any(|fact| batteries.contains(fact));
        let Some(lowest) = tightest(case, agent).filter(|_| has_battery) else {
            continue;
        };
        let Tightest { time, cell, left } = lowest;
        group.text = tr!(
            "{group} (in this plan the battery is lowest at time {time} at {cell}: {left} left)",
            group = group.text,
            time = case.whole.time(time),
            cell,
            left
        );
    }
}

/// The first time at which the battery of an agent is lowest, those apart at which it is half way
/// along a slow move.
fn tightest(case: &FittingQuestion, name: &str) -> Option<Tightest> {
    let agents = case.instance.agents();
    let agent = agents.iter().position(|agent| agent.name == name)?;
    let levels = levels(case.instance, agent, case.plan);
    let path = case.plan.path(name);
    let goal = agents.get(agent)?.goal;
    let each = levels.iter().enumerate().filter_map(|(time, &level)| {
        Some(Tightest {
            time: time as u32,
            cell: path.get(time).copied().unwrap_or(goal)?,
            left: u32::try_from(level).ok()?,
        })
    });
    each.min_by_key(|it| it.left)
}

#[cfg(test)]
mod tests {
    use giveway_model::{Question, check::costs, format::native};

    use super::*;
    use crate::explain::whole::WholePlan;

    #[test]
    fn a_battery_is_lowest_before_it_is_charged_or_at_the_end() {
        let instance = native::read_instance(
            r#"{ "giveway": 1, "map": ["..+.."], "agents": [
                { "name": "A1", "start": [0, 0], "goal": [4, 0],
                  "battery": { "capacity": 9, "initial": 3 } },
                { "name": "A2", "start": [1, 0] }] }"#,
        );
        let instance = instance.unwrap();
        let lowest = |plan: &str| {
            let plan = native::read_plan(plan).unwrap();
            let costs = costs(&instance, &plan).unwrap_or_default();
            let whole = WholePlan::default();
            let case =
                FittingQuestion::new(&instance, &Question::Makespan, &plan, costs, None, whole);
            (tightest(&case, "A1"), tightest(&case, "A2"))
        };
        let at = |time, x, left| {
            Some(Tightest {
                time,
                cell: Cell::new(x, 0),
                left,
            })
        };
        let charged = r#"{ "giveway": 1, "charges": { "A1": [2] }, "paths": {
            "A1": [[0, 0], [1, 0], [2, 0], [2, 0], [3, 0], [4, 0]], "A2": [[1, 0]] } }"#;
        assert_eq!(lowest(charged), (at(2, 2, 1), None), "A2 has none");
        let longer = r#"{ "giveway": 1, "charges": {}, "paths": {
            "A1": [[0, 0], [1, 0], [2, 0], [3, 0]], "A2": [[1, 0]] } }"#;
        assert_eq!(lowest(longer).0, at(3, 3, 0));
    }
}
