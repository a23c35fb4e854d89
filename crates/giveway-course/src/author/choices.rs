//! What can be chosen in fields: costs, robots, planners, tools.

use giveway_model::words::name;
use giveway_model::{Cost, Scene, tr};
use giveway_solve::plan::Planner;

use super::Pick;

/// Costs that the best plan of a scene makes least; all, where there is no scene.
pub(super) fn objective(scene: Option<&Scene>) -> Vec<Pick> {
    let costs = scene.map_or(&Cost::USUAL[..], |scene| scene.objective.costs());
    costs.iter().map(|cost| self::cost(*cost)).collect()
}

/// All costs.
pub(super) fn costs() -> Vec<Pick> {
    Cost::USUAL.into_iter().map(cost).collect()
}

/// All costs, or none.
pub(super) fn costs_or(none: &str) -> Vec<Pick> {
    let mut picks = vec![Pick::new("", none)];
    picks.extend(costs());
    picks
}

fn cost(cost: Cost) -> Pick {
    Pick::new(cost.name(), name(cost))
}

/// The robots on the board.
pub(super) fn robots(scene: Option<&Scene>) -> Vec<Pick> {
    let agents = scene.iter().flat_map(|scene| &scene.agents);
    agents
        .map(|agent| Pick::new(&agent.name, &agent.name))
        .collect()
}

/// The rules of the scene's own that are on, by their numbers.
pub(super) fn rules(scene: Option<&Scene>) -> Vec<Pick> {
    let Some(scene) = scene else {
        return Vec::new();
    };
    let rules = scene.constraints_in_force();
    rules
        .map(|rule| Pick::new(rule.index.to_string(), rule.constraint.called()))
        .collect()
}

/// All robots on the board, or none.
pub(super) fn robots_or(scene: Option<&Scene>, none: &str) -> Vec<Pick> {
    let mut picks = vec![Pick::new("", none)];
    picks.extend(robots(scene));
    picks
}

/// The planners of the textbook.
pub(super) fn planners() -> Vec<Pick> {
    let planners = Planner::ALL.into_iter();
    planners
        .map(|planner| Pick::new(planner.name(), planner.title()))
        .collect()
}

/// Ways to go on after a change.
pub(super) fn methods() -> Vec<Pick> {
    vec![
        Pick::new("revise", tr!("Revise: other times, same cells")),
        Pick::new("tunnel=1", tr!("Tunnel of 1: near the old path")),
        Pick::new("tunnel=2", tr!("Tunnel of 2: near the old path")),
        Pick::new("replan", tr!("Replan: everyone anew")),
    ]
}

/// Tools that may be live.
pub(super) fn tools() -> Vec<Pick> {
    vec![
        Pick::new("move", tr!("Move by hand")),
        Pick::new("obstacle", tr!("Obstacle")),
        Pick::new("charger", tr!("Charger")),
        Pick::new("slow-zone", tr!("Slow zone")),
        Pick::new("erase", tr!("Erase")),
        Pick::new("robot", tr!("Robot")),
        Pick::new("goal", tr!("Goal")),
        Pick::new("waypoint", tr!("Waypoint")),
    ]
}

/// What may be shown beside the map.
pub(super) fn layers() -> Vec<Pick> {
    vec![
        Pick::new("trails", tr!("Trails")),
        Pick::new("heat", tr!("Heat map")),
        Pick::new("lanes", tr!("Timeline")),
        Pick::new("table", tr!("Table")),
        Pick::new("inside", tr!("How it was proved")),
        Pick::new("freedom", tr!("What all best plans share")),
        Pick::new("proof", tr!("The proof, to be checked")),
    ]
}

/// The kinds of task.
pub(super) fn kinds() -> Vec<Pick> {
    vec![
        Pick::new("", tr!("Nothing, only read")),
        Pick::new("paint", tr!("Edit the scene")),
        Pick::new("lead", tr!("Lead robots by hand")),
        Pick::new("predict", tr!("Predict something")),
        Pick::new("spot", tr!("Find the conflicts")),
        Pick::new("choose", tr!("Pick an answer")),
        Pick::new("order", tr!("Put the robots in an order")),
        Pick::new("change", tr!("Go on after a change")),
    ]
}

/// What can hold of a scene.
pub(super) fn statements() -> Vec<Pick> {
    vec![
        Pick::new("impossible", tr!("no plan exists")),
        Pick::new("solvable", tr!("a plan exists")),
        Pick::new("cost", tr!("the best plan costs")),
        Pick::new("raised", tr!("the best plan costs more than at first")),
        Pick::new("price", tr!("a rule costs")),
        Pick::new("verdict", tr!("a question has this answer")),
        Pick::new("apart", tr!("no plan is best in both costs")),
    ]
}

/// What can hold of a scene or of the step's plan.
pub(super) fn claims() -> Vec<Pick> {
    let mut picks = vec![Pick::new("", tr!("nothing that can be judged"))];
    picks.extend(statements());
    picks.extend([
        Pick::new("legal", tr!("the plan breaks no rule")),
        Pick::new("broken", tr!("the plan breaks this rule")),
        Pick::new("best", tr!("no plan is better")),
        Pick::new("beaten", tr!("another plan is better")),
    ]);
    picks
}

/// How a number compares.
pub(super) fn comparisons() -> Vec<Pick> {
    vec![
        Pick::new("=", tr!("exactly")),
        Pick::new("<=", tr!("at most")),
        Pick::new(">=", tr!("at least")),
    ]
}

/// Answers to a question.
pub(super) fn verdicts() -> Vec<Pick> {
    vec![
        Pick::new("needless", tr!("Another plan avoids it")),
        Pick::new("costly", tr!("Otherwise it costs more")),
        Pick::new("necessary", tr!("It must be so")),
    ]
}

/// What can be predicted.
pub(super) fn quantities() -> Vec<Pick> {
    vec![
        Pick::new("cost", tr!("what the best plan costs")),
        Pick::new("arrival", tr!("when a robot arrives")),
        Pick::new("place", tr!("where a robot is at a time")),
        Pick::new("waits", tr!("which robot waits")),
        Pick::new("first-waypoint", tr!("which waypoint a robot visits first")),
        Pick::new("plans", tr!("how many best plans there are")),
        Pick::new("points", tr!("how many plans the Pareto front has")),
        Pick::new("planner", tr!("what the plan of a planner costs")),
        Pick::new("node", tr!("what a node of CBS costs")),
        Pick::new("changed", tr!("what comes of a change")),
        Pick::new("price", tr!("what a rule costs")),
        Pick::new("decides", tr!("which rule leaves no plan")),
        Pick::new("first-at", tr!("which robot is first at a cell")),
        Pick::new("delay", tr!("how many steps a robot loses")),
        Pick::new("loses-most", tr!("which robot loses most")),
        Pick::new("costs-most", tr!("which robot costs the others most")),
    ]
}

/// What a plan made by hand must reach.
pub(super) fn aims() -> Vec<Pick> {
    vec![
        Pick::new("legal", tr!("break no rule")),
        Pick::new("cost", tr!("cost at most")),
        Pick::new("best", tr!("be the best")),
    ]
}

/// What an order must do.
pub(super) fn finds() -> Vec<Pick> {
    vec![
        Pick::new("works", tr!("It gives a plan")),
        Pick::new("best", tr!("It gives a best plan")),
        Pick::new("worse", tr!("It gives a plan that is not best")),
        Pick::new("none", tr!("There is none: no order gives a plan")),
    ]
}

/// What the board shows of a plan.
pub(super) fn plans(has_plan: bool) -> Vec<Pick> {
    let mut picks = vec![
        Pick::new("none", tr!("No plan")),
        Pick::new("best", tr!("The best plan, found by the solver")),
    ];
    if has_plan {
        picks.push(Pick::new("given", tr!("The plan that was taken")));
    }
    picks
}
