//! Whether a task fits the step that it stands in.

use giveway_model::{Cost, Instance, Objective, check, tr};

use super::bounds::{Faults, MAX_ANSWERS, MAX_ORDERED};
use super::links::Targets;
use crate::lesson::task::{Change, Choose, Lead, OrderAim, Predict};
use crate::lesson::{Condition, Quantity, Step, Task, Value};

pub(super) fn check(
    place: &str,
    step: &Step,
    task: &Task,
    targets: &Targets<'_>,
    faults: &mut Faults,
) {
    let at = |part: &str| format!("{place}.task.{part}");
    targets.check(&at("say"), task.say(), faults);
    match task {
        Task::Paint(paint) => {
            if step.tools.is_empty() {
                faults.add(
                    place,
                    tr!("a \"paint\" task without tools"),
                    tr!("at least one tool"),
                );
            }
            condition(&at("until"), &paint.until, step, targets, faults);
        }
        Task::Lead(lead) => self::lead(place, lead, targets, faults),
        Task::Predict(predict) => self::predict(place, predict, step, targets, faults),
        Task::Spot(_) => spot(place, step, targets, faults),
        Task::Choose(choose) => self::choose(place, choose, step, targets, faults),
        Task::Order(order) => {
            let robots = targets.scene.map_or(0, |scene| scene.agents.len());
            if order.find == OrderAim::None {
                faults.few(&at("find"), robots, MAX_ORDERED, tr!("counted" => "robots"));
            }
        }
        Task::Change(change) => self::change(place, change, step, targets, faults),
    }
}

fn lead(place: &str, lead: &Lead, targets: &Targets<'_>, faults: &mut Faults) {
    let at = format!("{place}.task.robots");
    if lead.robots.is_empty() {
        faults.add(&at, tr!("no robots"), tr!("at least one"));
    }
    for (index, name) in lead.robots.iter().enumerate() {
        robot(&format!("{at}[{index}]"), name, targets, faults);
    }
    let robots = targets.scene.map_or(0, |scene| scene.agents.len());
    faults.few(&at, lead.robots.len(), robots, tr!("counted" => "robots"));
}

fn predict(
    place: &str,
    predict: &Predict,
    step: &Step,
    targets: &Targets<'_>,
    faults: &mut Faults,
) {
    quantity(
        &format!("{place}.task.what"),
        &predict.what,
        step,
        targets,
        faults,
    );
    let at = format!("{place}.task.answers");
    let answers = tr!("counted" => "answers");
    faults.few(&at, predict.answers.len(), MAX_ANSWERS, answers);
    if predict.answers.len() == 1 {
        faults.add(&at, tr!("one answer"), tr!("none, or at least two"));
    }
    for (index, guess) in predict.answers.iter().enumerate() {
        let at = format!("{at}[{index}]");
        targets.check(&format!("{at}.text"), &guess.text, faults);
        targets.check(&format!("{at}.reply"), &guess.reply, faults);
        let value = format!("{at}.value");
        if guess.value.kind() != predict.what.kind() {
            let found = format!("{:?}", guess.value.to_string());
            faults.add(&value, found, tr!("a value of what is asked for"));
        }
        match &guess.value {
            Value::Robot(name) => robot(&value, name, targets, faults),
            Value::Cell(cell) if !targets.has_cell(*cell) => {
                faults.add(
                    &value,
                    tr!("the cell {cell}", cell),
                    tr!("a cell of the map"),
                );
            }
            Value::Cell(_) | Value::Number(_) => {}
        }
        let mut before = predict.answers.iter().take(index);
        if before.any(|other| other.value == guess.value) {
            faults.add(
                &value,
                tr!("{what} twice", what = guess.value),
                tr!("each value once"),
            );
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
                let found = tr!("{n} costs", n = costs.len());
                faults.add(
                    format!("{place}.costs"),
                    found,
                    tr!("two or three different costs"),
                );
            }
        }
        Quantity::Planner { order, .. } => {
            for (index, name) in order.iter().flatten().enumerate() {
                robot(&format!("{place}.order[{index}]"), name, targets, faults);
            }
        }
        Quantity::Changed { .. } => planned(place, step, faults),
        Quantity::Waits {} | Quantity::Plans {} | Quantity::Node { .. } => {}
    }
}

fn spot(place: &str, step: &Step, targets: &Targets<'_>, faults: &mut Faults) {
    let Some(plan) = &step.plan else {
        return planned(place, step, faults);
    };
    let instance = targets
        .scene
        .and_then(|scene| Instance::new(scene.clone()).ok());
    let is_legal = instance.is_some_and(|it| check::check(&it, plan).is_valid());
    if is_legal {
        faults.add(
            format!("{place}.plan"),
            tr!("a plan that breaks no rule"),
            tr!("one with conflicts"),
        );
    }
}

fn choose(place: &str, choose: &Choose, step: &Step, targets: &Targets<'_>, faults: &mut Faults) {
    let at = format!("{place}.task.answers");
    if choose.answers.len() < 2 {
        faults.add(
            &at,
            tr!("{n} answers", n = choose.answers.len()),
            tr!("at least two"),
        );
    }
    let answers = tr!("counted" => "answers");
    faults.few(&at, choose.answers.len(), MAX_ANSWERS, answers);
    if !choose.answers.iter().any(|choice| choice.right) {
        faults.add(
            &at,
            tr!("no answer with \"right\": true"),
            tr!("at least one"),
        );
    }
    for (index, choice) in choose.answers.iter().enumerate() {
        let at = format!("{at}[{index}]");
        targets.check(&format!("{at}.text"), &choice.text, faults);
        targets.check(&format!("{at}.reply"), &choice.reply, faults);
        if let Some(claim) = &choice.claim {
            condition(&format!("{at}.claim"), claim, step, targets, faults);
        }
    }
}

fn change(place: &str, change: &Change, step: &Step, targets: &Targets<'_>, faults: &mut Faults) {
    planned(place, step, faults);
    let methods = format!("{place}.task.methods");
    if change.methods.is_empty() {
        faults.add(&methods, tr!("no methods"), tr!("at least one"));
    }
    let things = tr!("counted" => "methods");
    faults.few(&methods, change.methods.len(), MAX_ANSWERS, things);
    if change.cost.is_none() && change.kept.is_none() {
        let task = format!("{place}.task");
        faults.add(
            task,
            tr!("neither \"cost\" nor \"kept\""),
            tr!("what must be reached"),
        );
    }
    let robots = targets.scene.map_or(0, |scene| scene.agents.len()) as u32;
    faults.range(
        &format!("{place}.task.kept"),
        change.kept.unwrap_or(0),
        0,
        robots,
    );
}

fn condition(
    place: &str,
    condition: &Condition,
    step: &Step,
    targets: &Targets<'_>,
    faults: &mut Faults,
) {
    match condition {
        Condition::Cost { cost, .. } | Condition::Raised { cost, .. } => {
            optimised(place, *cost, targets, faults);
        }
        Condition::Verdict { question, .. } => {
            for name in question.agents() {
                robot(&format!("{place}.question"), name, targets, faults);
            }
        }
        Condition::Apart {
            costs: [one, other],
        } if one == other => {
            faults.add(
                format!("{place}.costs"),
                tr!("a cost twice"),
                tr!("two different costs"),
            );
        }
        Condition::Legal {} | Condition::Best {} | Condition::Beaten {} => {
            planned(place, step, faults);
        }
        Condition::Apart { .. } | Condition::Impossible { .. } | Condition::Solvable {} => {}
    }
}

fn robot(place: &str, name: &str, targets: &Targets<'_>, faults: &mut Faults) {
    if !targets.has_robot(name) {
        faults.add(
            place,
            tr!("the robot {name}", name = format!("{name:?}")),
            tr!("a robot of the scene"),
        );
    }
}

/// A cost must be one that the scene's objective makes least: only then is it that of
/// every best plan.
fn optimised(place: &str, cost: Cost, targets: &Targets<'_>, faults: &mut Faults) {
    let costs = targets.scene.map(|scene| scene.objective.costs());
    if costs.is_some_and(|costs| !costs.contains(&cost)) {
        let found = tr!("the cost {cost}", cost);
        faults.add(
            format!("{place}.cost"),
            found,
            tr!("a cost of the scene's objective"),
        );
    }
}

fn planned(place: &str, step: &Step, faults: &mut Faults) {
    if step.plan.is_none() {
        faults.add(place, tr!("no plan"), tr!("a plan that the task is about"));
    }
}
