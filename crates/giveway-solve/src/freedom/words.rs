//! What must be so, in sentences: one text for the page and the command.

use giveway_model::words::{count, grouped, name, value, values};
use giveway_model::{Cost, Objective};

use super::{
    About, Closed, CriticalCell, Farthest, FreedomAnswer, Hold, Known, Later, Need, PlanCount,
    Slack, Visit, same_steps,
};
use crate::Status;
use crate::words::{FOR_EVER, Headline};

/// What is known of the plan in one sentence, with the number of best plans.
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
            say("Optimal", format!(": {costs}.{plans}"))
        }
        Status::Feasible => say(
            "Not proved best",
            format!(": {costs}. What must be so is only known of best plans."),
        ),
        Status::Impossible => say(
            "No plan",
            match answer.within.filter(|_| !answer.complete) {
                Some(within) => format!(" within makespan {within}."),
                None => format!(" exists, {FOR_EVER}."),
            },
        ),
        Status::Unknown => say("No plan yet", ": time ran out.".to_owned()),
    }
}

/// That the plan is not the one that was handed in, where it is not.
pub fn about(answer: &FreedomAnswer) -> Option<&'static str> {
    let better = answer.about == About::Better && answer.status == Status::Optimal;
    better.then_some("Your plan is not the best. This is about a better one.")
}

/// `There are 15 best plans.`
pub fn plans_found(number: PlanCount) -> String {
    match number {
        PlanCount::Exactly(1) => "There is no other best plan.".to_owned(),
        PlanCount::Exactly(n) => format!("There are {} best plans.", grouped(n.into())),
        PlanCount::MoreThan(n) => format!("There are more than {} best plans.", grouped(n.into())),
        PlanCount::AtLeast(n) => {
            let plans = count(n, "best plan");
            format!("{plans} found so far. There may be more.")
        }
    }
}

/// `3 ways`, `1 way`, `more than 100 ways`.
pub fn ways(number: PlanCount) -> String {
    match number {
        PlanCount::Exactly(n) => count(n, "way"),
        PlanCount::MoreThan(n) => format!("more than {}", count(n, "way")),
        PlanCount::AtLeast(n) => format!("at least {}", count(n, "way")),
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
    Some(format!("{} = {total} best plans", factors.join(" × ")))
}

/// `11 of 19 steps are the same in every best plan.`
pub fn backbone(answer: &FreedomAnswer) -> Option<String> {
    let backbone = answer.backbone.as_ref()?;
    let each = backbone.values().map(|visits| same_steps(visits));
    let (same, all) = each.fold((0, 0), |(same, all), (s, a)| (same + s, all + a));
    let open = backbone.values().flatten().any(is_open);
    Some(if all == 0 {
        "No robot has to do anything.".to_owned()
    } else if same == all {
        "Every step is the same in every best plan.".to_owned()
    } else if open {
        format!("At least {same} of {all} steps are the same in every best plan.")
    } else {
        format!("{same} of {all} steps are the same in every best plan.")
    })
}

fn is_open(visit: &Visit) -> bool {
    visit.always == Known::Open
}

/// How late a robot could be: `A1 could be 3 steps late without harm`.
pub fn late(agent: &str, slack: &Slack) -> String {
    match slack.late() {
        None => format!("{agent} has nothing to do"),
        Some(Hold::Steps(0)) => format!("{agent} has no step to spare somewhere on its way"),
        Some(Hold::Steps(steps)) => {
            let steps = count(steps, "step");
            format!("{agent} could be {steps} late without harm")
        }
        Some(_) => format!("{agent} can be as late as it likes without harm"),
    }
}

/// How much later a robot could arrive if the others planned anew.
pub fn later(slack: &Slack) -> String {
    match slack.arrival {
        Later::Exactly(0) => "arrives no later in any best plan".to_owned(),
        Later::Exactly(steps) => {
            let steps = count(steps, "step");
            format!("arrives up to {steps} later in other best plans")
        }
        Later::AtLeast(0) => "may arrive later in other best plans; that is open".to_owned(),
        Later::AtLeast(steps) => {
            let steps = count(steps, "step");
            format!("arrives at least {steps} later in some best plan")
        }
    }
}

/// What closing a cell would do: `Close (5, 2): makespan 10, not 8`.
pub fn closed(it: &CriticalCell, objective: &Objective) -> String {
    let cell = it.cell;
    match &it.closed {
        Closed::Impossible { needed, .. } => {
            let needed = match needed {
                None => "no plan is left",
                Some(Need::Start) => "a robot starts there",
                Some(Need::Goal) => "a robot has to arrive there",
                Some(Need::Waypoint) => "a robot has to visit it",
            };
            format!("Close {cell}: {needed}")
        }
        Closed::Optimal { costs, deltas, .. } => {
            let changed = objective.costs().iter().find_map(|cost| {
                let delta = *deltas.get(cost)?;
                (delta != 0).then_some((*cost, delta))
            });
            match changed {
                None => format!("Close {cell}: nothing is lost"),
                Some((cost, delta)) => {
                    let now = costs.get(cost);
                    let before = i64::from(now) - delta;
                    format!("Close {cell}: {}, not {before}", value(cost, now))
                }
            }
        }
        Closed::Unknown { worse: true } => {
            format!("Close {cell}: no plan stays as good; how much it costs is open")
        }
        Closed::Unknown { worse: false } => format!("Close {cell}: open"),
    }
}

/// What is written on a critical cell: `+2` for the first cost, `sum +2` for another,
/// `no plan`; nothing where closing it costs nothing, or somebody needs the very cell.
pub fn mark(it: &CriticalCell, objective: &Objective) -> Option<String> {
    match &it.closed {
        Closed::Impossible { needed: None, .. } => Some("no plan".to_owned()),
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

const fn short(cost: Cost) -> &'static str {
    match cost {
        Cost::SumOfCosts => "sum",
        cost => name(cost),
    }
}

/// How different another best plan is.
pub fn farthest(farthest: &Farthest) -> String {
    match farthest {
        Farthest::Only => "There is no other best plan.".to_owned(),
        Farthest::Unknown => "Whether there is another best plan is open.".to_owned(),
        Farthest::Found { differs, most, .. } => {
            let places = count(*differs, "place");
            if most.is_proved() {
                format!("Another best plan differs in {places}. No best plan differs in more.")
            } else {
                format!("Another best plan differs in {places}. There may be a more different one.")
            }
        }
    }
}
