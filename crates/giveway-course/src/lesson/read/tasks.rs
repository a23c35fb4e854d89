//! Whether a task fits the step that it stands in.

use giveway_model::{Cost, Instance, Objective, check};

use super::bounds::{Faults, MAX_ANSWERS, MAX_FIRST, MAX_ORDERED};
use super::links::Targets;
use super::{Flaw, Things};
use crate::lesson::task::{Change, Choose, Lead, OrderAim, Predict};
use crate::lesson::{Quantity, Statement, Step, Task, Value};

pub(super) fn check(step: &Step, task: &Task, targets: &Targets<'_>, faults: &mut Faults) {
    targets.check("task.say", task.say(), faults);
    match task {
        Task::Paint(paint) => {
            if step.tools.is_empty() {
                faults.add("tools", Flaw::NoTools);
            }
            statement("task.until", &paint.until, step, targets, faults);
        }
        Task::Lead(lead) => self::lead(lead, targets, faults),
        Task::Predict(predict) => self::predict(predict, step, targets, faults),
        Task::Spot(_) => spot(step, targets, faults),
        Task::Choose(choose) => self::choose(choose, step, targets, faults),
        Task::Order(order) => {
            let robots = targets.scene.map_or(0, |scene| scene.agents.len());
            if order.find == OrderAim::None {
                faults.few("task.find", robots, MAX_ORDERED, Things::Robots);
            }
        }
        Task::Change(change) => self::change(change, step, targets, faults),
    }
}

fn lead(lead: &Lead, targets: &Targets<'_>, faults: &mut Faults) {
    let at = "task.robots";
    if lead.robots.is_empty() {
        faults.add(at, Flaw::NoRobots);
    }
    for (index, name) in lead.robots.iter().enumerate() {
        robot(&format!("{at}[{index}]"), name, targets, faults);
    }
    let robots = targets.scene.map_or(0, |scene| scene.agents.len());
    faults.few(at, lead.robots.len(), robots, Things::Robots);
}

fn predict(predict: &Predict, step: &Step, targets: &Targets<'_>, faults: &mut Faults) {
    quantity("task.what", &predict.what, step, targets, faults);
    let at = "task.answers";
    faults.few(at, predict.answers.len(), MAX_ANSWERS, Things::Answers);
    if predict.answers.len() == 1 {
        faults.add(at, Flaw::OneAnswer);
    }
    for (index, guess) in predict.answers.iter().enumerate() {
        let at = format!("{at}[{index}]");
        targets.check(&format!("{at}.text"), &guess.text, faults);
        targets.check(&format!("{at}.reply"), &guess.reply, faults);
        let value = format!("{at}.value");
        if guess.value.kind() != predict.what.kind() {
            faults.add(&value, Flaw::OtherKind(guess.value.to_string()));
        }
        match &guess.value {
            Value::Robot(name) => robot(&value, name, targets, faults),
            Value::Cell(cell) if !targets.has_cell(*cell) => {
                faults.add(&value, Flaw::UnknownCell(*cell));
            }
            Value::Rule { rule: number } => self::rule(&value, *number, targets, faults),
            Value::Cell(_) | Value::Number(_) => {}
        }
        let mut before = predict.answers.iter().take(index);
        if before.any(|other| other.value == guess.value) {
            faults.add(&value, Flaw::Twice(guess.value.to_string()));
        }
    }
}

fn quantity(
    place: &str,
    quantity: &Quantity,
    step: &Step,
    targets: &Targets<'_>,
    faults: &mut Faults,
) {
    match quantity {
        Quantity::Cost { cost } => optimised(place, *cost, targets, faults),
        Quantity::Arrival { robot: name }
        | Quantity::Place { robot: name, .. }
        | Quantity::FirstWaypoint { robot: name } => {
            robot(&format!("{place}.robot"), name, targets, faults);
        }
        Quantity::Points { costs } => {
            let is_front = (2..=3).contains(&costs.len()) && Objective::new(costs.clone()).is_ok();
            if !is_front {
                faults.add(format!("{place}.costs"), Flaw::NoFront(costs.len()));
            }
        }
        Quantity::Planner { order, .. } => {
            for (index, name) in order.iter().flatten().enumerate() {
                robot(&format!("{place}.order[{index}]"), name, targets, faults);
            }
        }
        Quantity::Changed { .. } | Quantity::LosesMost {} | Quantity::CostsMost {} => {
            planned(step, faults);
        }
        Quantity::Price { rule: number } => {
            rule(&format!("{place}.rule"), *number, targets, faults);
        }
        Quantity::Decides {} => {
            let rules = targets.scene.map_or(0, |scene| scene.constraints.len());
            faults.few(&format!("{place}.is"), rules, MAX_ANSWERS, Things::Rules);
        }
        Quantity::FirstAt { cell } => {
            if !targets.has_cell(*cell) {
                faults.add(format!("{place}.cell"), Flaw::UnknownCell(*cell));
            }
            let robots = targets.scene.map_or(0, |scene| scene.agents.len());
            faults.few(&format!("{place}.is"), robots, MAX_FIRST, Things::Robots);
        }
        Quantity::Delay {
            robot: name,
            because,
        } => {
            robot(&format!("{place}.robot"), name, targets, faults);
            if let Some(other) = because {
                robot(&format!("{place}.because"), other, targets, faults);
            }
            planned(step, faults);
        }
        Quantity::Waits {} | Quantity::Plans {} | Quantity::Node { .. } => {}
    }
}

fn spot(step: &Step, targets: &Targets<'_>, faults: &mut Faults) {
    let Some(plan) = &step.plan else {
        return planned(step, faults);
    };
    let instance = targets
        .scene
        .and_then(|scene| Instance::new(scene.clone()).ok());
    let is_legal = instance.is_some_and(|it| check::check(&it, plan).is_valid());
    if is_legal {
        faults.add("plan", Flaw::LegalPlan);
    }
}

fn choose(choose: &Choose, step: &Step, targets: &Targets<'_>, faults: &mut Faults) {
    let at = "task.answers";
    let count = choose.answers.len();
    if count < 2 {
        faults.add(at, Flaw::FewAnswers(count));
    }
    faults.few(at, count, MAX_ANSWERS, Things::Answers);
    if !choose.answers.iter().any(|choice| choice.right) {
        faults.add(at, Flaw::NoRightAnswer);
    }
    for (index, choice) in choose.answers.iter().enumerate() {
        let at = format!("{at}[{index}]");
        targets.check(&format!("{at}.text"), &choice.text, faults);
        targets.check(&format!("{at}.reply"), &choice.reply, faults);
        if let Some(claim) = &choice.claim {
            statement(&format!("{at}.claim"), claim, step, targets, faults);
        }
    }
}

fn change(change: &Change, step: &Step, targets: &Targets<'_>, faults: &mut Faults) {
    planned(step, faults);
    let methods = "task.methods";
    if change.methods.is_empty() {
        faults.add(methods, Flaw::NoMethods);
    }
    faults.few(methods, change.methods.len(), MAX_ANSWERS, Things::Methods);
    if change.cost.is_none() && change.kept.is_none() {
        faults.add("task.cost", Flaw::NoAim);
    }
    let robots = targets.scene.map_or(0, |scene| scene.agents.len()) as u32;
    faults.range("task.kept", change.kept.unwrap_or(0), 0, robots);
}

fn statement(
    place: &str,
    statement: &Statement,
    step: &Step,
    targets: &Targets<'_>,
    faults: &mut Faults,
) {
    match statement {
        Statement::Cost { cost, .. } | Statement::Raised { cost, .. } => {
            optimised(place, *cost, targets, faults);
        }
        Statement::Verdict { question, .. } => {
            for name in question.agents() {
                robot(&format!("{place}.question"), name, targets, faults);
            }
        }
        Statement::Apart {
            costs: [one, other],
        } if one == other => {
            faults.add(format!("{place}.costs"), Flaw::SameCosts);
        }
        Statement::Price { rule: number, .. } => {
            rule(&format!("{place}.rule"), *number, targets, faults);
        }
        Statement::Broken { rule: number } => {
            rule(&format!("{place}.rule"), *number, targets, faults);
            planned(step, faults);
        }
        Statement::Legal {} | Statement::Best {} | Statement::Beaten {} => {
            planned(step, faults);
        }
        Statement::Apart { .. } | Statement::Impossible { .. } | Statement::Solvable {} => {}
    }
}

fn robot(place: &str, name: &str, targets: &Targets<'_>, faults: &mut Faults) {
    if !targets.has_robot(name) {
        faults.add(place, Flaw::UnknownRobot(name.to_owned()));
    }
}

/// A rule of the scene's own that is in force, by its number.
fn rule(place: &str, number: u32, targets: &Targets<'_>, faults: &mut Faults) {
    let Some(scene) = targets.scene else {
        return;
    };
    let index = number as usize;
    let rule = scene.constraints.get(index);
    if rule
        .and_then(|rule| rule.in_force(index, &scene.agents))
        .is_none()
    {
        faults.add(place, Flaw::UnknownRule(number));
    }
}

/// A cost must be one that the scene's objective makes least: only then is it that of
/// every best plan.
fn optimised(place: &str, cost: Cost, targets: &Targets<'_>, faults: &mut Faults) {
    let costs = targets.scene.map(|scene| scene.objective.costs());
    if costs.is_some_and(|costs| !costs.contains(&cost)) {
        faults.add(format!("{place}.cost"), Flaw::NotOptimised(cost));
    }
}

fn planned(step: &Step, faults: &mut Faults) {
    if step.plan.is_none() {
        faults.add("plan", Flaw::NoPlan);
    }
}
