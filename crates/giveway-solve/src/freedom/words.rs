//! The answer about all best plans in sentences: one text for the page and the command.

use giveway_model::words::{grouped, name, value, values};
use giveway_model::{Cost, Objective, tr};

use super::{
    About, Closed, CriticalCell, Farthest, FreedomAnswer, Hold, Known, Later, Need, PlanCount,
    Slack, Visit, same_steps,
};
use crate::Status;
use crate::words::Headline;

/// The status of the plan in one sentence, with the number of best plans.
pub fn headline(answer: &FreedomAnswer) -> Headline {
    let say = |word: &str, rest: String| Headline {
        word: word.to_owned(),
        rest,
    };
    let costs = answer.costs.unwrap_or_default();
    let costs = values(answer.objective.costs(), &costs);
    match answer.status {
        Status::Optimal => {
            let plans = answer.plans.as_ref();
            let plans = plans.map_or_else(String::new, |it| format!(" {}", plans_found(it.number)));
            say(tr!("an answer" => "Optimal"), format!(": {costs}.{plans}"))
        }
        Status::Feasible => say(
            tr!("Not proved best"),
            tr!(
                ": {costs}. What all best plans share is only known of best plans.",
                costs
            ),
        ),
        Status::Impossible => match answer.reach.within() {
            Some(n) => say(
                tr!("an answer" => "No plan"),
                tr!("behind: No plan" => " within makespan {n}.", n),
            ),
            None => say(
                tr!("an answer, before: exists" => "No plan"),
                tr!("behind: No plan" => " exists, no matter how many steps you allow.").to_owned(),
            ),
        },
        Status::Unknown => say(tr!("No plan yet"), tr!(": time ran out.").to_owned()),
    }
}

/// The remark that the plan is not the one that was handed in, where it is not.
pub fn about(answer: &FreedomAnswer) -> Option<&'static str> {
    let better = answer.about == About::Better && answer.status == Status::Optimal;
    better.then_some(tr!(
        "Your plan is not the best. This is about a better one."
    ))
}

/// `There are 15 best plans.`
pub fn plans_found(number: PlanCount) -> String {
    match number {
        PlanCount::Exactly(1) => tr!("There is no other best plan.").to_owned(),
        PlanCount::Exactly(n) => tr!("There are {many} best plans.", many = grouped(n.into())),
        PlanCount::MoreThan(n) => tr!(
            "There are more than {many} best plans.",
            many = grouped(n.into())
        ),
        PlanCount::AtLeast(n) => {
            tr!("{n} best plan found so far. There may be more."
                | "{n} best plans found so far. There may be more." % n)
        }
    }
}

/// `3 ways`, `1 way`, `more than 100 ways`.
pub fn ways(number: PlanCount) -> String {
    match number {
        PlanCount::Exactly(n) => tr!("{n} way" | "{n} ways" % n),
        PlanCount::MoreThan(n) => tr!("more than {n} way" | "more than {n} ways" % n),
        PlanCount::AtLeast(n) => tr!("at least {n} way" | "at least {n} ways" % n),
    }
}

/// `3 × 1 × 5 = 15 best plans`, where each choice is free of all others and there is
/// a choice; nothing otherwise.
pub fn product(answer: &FreedomAnswer) -> Option<String> {
    let plans = answer.plans.as_ref()?;
    let PlanCount::Exactly(total) = plans.number else {
        return None;
    };
    let mut factors = Vec::new();
    for ways in plans.ways.values() {
        let PlanCount::Exactly(ways) = ways.number else {
            return None;
        };
        factors.push(ways);
    }
    let product = factors.iter().try_fold(1u32, |all, &n| all.checked_mul(n));
    if total < 2 || factors.len() < 2 || product != Some(total) {
        return None;
    }
    let factors: Vec<String> = factors.iter().map(u32::to_string).collect();
    Some(tr!(
        "{factors} = {total} best plans",
        factors = factors.join(" × "),
        total
    ))
}

/// `11 of 19 steps are the same in every best plan.`
pub fn backbone(answer: &FreedomAnswer) -> Option<String> {
    let backbone = answer.backbone.as_ref()?;
    let each = backbone.values().map(|visits| same_steps(visits));
    let (same, all) = each.fold((0, 0), |(same, all), (s, a)| (same + s, all + a));
    let open = backbone.values().flatten().any(is_open);
    Some(if all == 0 {
        tr!("No robot has to do anything.").to_owned()
    } else if same == all {
        tr!("Every step is the same in every best plan.").to_owned()
    } else if open {
        tr!(
            "At least {same} of {all} steps are the same in every best plan.",
            same,
            all
        )
    } else {
        tr!(
            "{same} of {all} steps are the same in every best plan.",
            same,
            all
        )
    })
}

fn is_open(visit: &Visit) -> bool {
    visit.always == Known::Open
}

/// How late a robot could be: `A1 could be 3 steps late without harm`.
pub fn late(agent: &str, slack: &Slack) -> String {
    match slack.late() {
        None => tr!("{agent} has nothing to do", agent),
        Some(Hold::Steps(0)) => tr!("{agent} has no step to spare somewhere on its way", agent),
        Some(Hold::Steps(steps)) => {
            tr!(
                "{agent} could be {n} step late without harm"
                    | "{agent} could be {n} steps late without harm" % steps,
                agent
            )
        }
        Some(_) => tr!("{agent} can be as late as it likes without harm", agent),
    }
}

/// How much later a robot could arrive if the others planned anew.
pub fn later(slack: &Slack) -> String {
    match slack.arrival {
        Later::Exactly(0) => tr!("arrives no later in any best plan").to_owned(),
        Later::Exactly(steps) => {
            tr!("arrives up to {n} step later in other best plans"
                | "arrives up to {n} steps later in other best plans" % steps)
        }
        Later::AtLeast(0) => tr!("may arrive later in other best plans; that is open").to_owned(),
        Later::AtLeast(steps) => {
            tr!("arrives at least {n} step later in some best plan"
                | "arrives at least {n} steps later in some best plan" % steps)
        }
    }
}

/// The cost of closing a cell: `Close (5, 2): makespan 10, not 8`.
pub fn closed(it: &CriticalCell, objective: &Objective) -> String {
    let cell = it.cell;
    match &it.closed {
        Closed::Impossible { needed, reach } => {
            let needed = match (needed, reach.within()) {
                (None, None) => tr!("no plan is left").to_owned(),
                (None, Some(n)) => tr!("no plan of makespan at most {n} is left", n),
                (Some(Need::Start), _) => tr!("a robot starts there").to_owned(),
                (Some(Need::Goal), _) => tr!("a robot has to arrive there").to_owned(),
                (Some(Need::Waypoint), _) => tr!("a robot has to visit it").to_owned(),
                (Some(Need::Rule), _) => tr!("a rule wants a robot there").to_owned(),
            };
            tr!("Close {cell}: {outcome}", cell, outcome = needed)
        }
        Closed::Optimal { costs, deltas, .. } => {
            let changed = objective.costs().iter().find_map(|cost| {
                let delta = *deltas.get(cost)?;
                (delta != 0).then_some((*cost, delta))
            });
            match changed {
                None => tr!("Close {cell}: nothing is lost", cell),
                Some((cost, delta)) => {
                    let now = costs.get(cost);
                    let before = i64::from(now) - delta;
                    tr!(
                        "Close {cell}: {cost}, not {before}",
                        cell,
                        cost = value(cost, now),
                        before
                    )
                }
            }
        }
        Closed::Unknown { worse: true } => {
            tr!(
                "Close {cell}: no plan stays as good; how much it costs is open",
                cell
            )
        }
        Closed::Unknown { worse: false } => tr!("Close {cell}: open", cell),
    }
}

/// The mark on a critical cell: `+2` for the first cost, `sum +2` for another, `no plan`; none where closing
/// it costs nothing, or an agent needs this very cell.
pub fn mark(it: &CriticalCell, objective: &Objective) -> Option<String> {
    match &it.closed {
        Closed::Impossible { needed: None, .. } => Some(tr!("no plan").to_owned()),
        Closed::Impossible { .. } => None,
        Closed::Unknown { worse } => worse.then(|| "?".to_owned()),
        Closed::Optimal { deltas, .. } => {
            let mut costs = objective.costs().iter().enumerate();
            costs.find_map(|(place, cost)| match deltas.get(cost) {
                None | Some(0) => None,
                Some(delta) if place == 0 => Some(format!("{delta:+}")),
                Some(delta) => Some(format!("{} {delta:+}", short(*cost))),
            })
        }
    }
}

fn short(cost: Cost) -> &'static str {
    match cost {
        Cost::SumOfCosts => tr!("sum of costs, in short" => "sum"),
        cost => name(cost),
    }
}

/// How different another best plan is.
pub fn farthest(farthest: &Farthest) -> String {
    match farthest {
        Farthest::Only => tr!("There is no other best plan.").to_owned(),
        Farthest::Unknown => tr!("Whether there is another best plan is open.").to_owned(),
        Farthest::Found { differs, most, .. } => {
            if most.is_proved() {
                tr!(
                    "Another best plan differs in {n} place. No best plan differs in more."
                        | "Another best plan differs in {n} places. No best plan differs in more."
                            % *differs
                )
            } else {
                tr!(
                    "Another best plan differs in {n} place. There may be a more different one."
                        | "Another best plan differs in {n} places. There may be a more different one."
                            % *differs
                )
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use giveway_model::format::native;

    use super::*;
    use crate::{Request, Response, SilentHost, freedom::FreedomRequest, serve};

    #[test]
    fn no_plan_is_left_up_to_the_horizon() {
        let scene = r#"{ "giveway": 1, "map": ["...", ".#.", ".#.", "..."],
            "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }] }"#;
        let request = FreedomRequest {
            scene: native::read_scene(scene).unwrap(),
            within: Some(5),
            ..FreedomRequest::default()
        };
        let Response::Freedom(answer) = serve(&Request::Freedom(request), &SilentHost) else {
            panic!("a plan of two steps");
        };
        let cells = answer.critical.unwrap();
        let middle = cells
            .iter()
            .find(|it| it.cell == giveway_model::Cell::new(1, 0))
            .unwrap();
        assert_eq!(
            closed(middle, &answer.objective),
            "Close (1, 0): no plan of makespan at most 5 is left"
        );
    }
}
