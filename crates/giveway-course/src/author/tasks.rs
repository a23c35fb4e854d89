//! The fields of each kind of task.

use giveway_model::tr;

use super::choices::{
    aims, claims, comparisons, costs, costs_or, finds, methods, objective, planners, quantities,
    robots, robots_or, rules, statements, verdicts,
};
use super::field::Shape;
use super::form::Form;
use super::{Input, Pick};

/// The fields of a task, but for what it asks.
pub(super) fn task(form: &mut Form<'_>, kind: &str, answers: usize) {
    match kind {
        "paint" => {
            let until = tr!("Done when");
            statement(form, "task.until", until, statements());
        }
        "lead" => lead(form),
        "predict" => {
            quantity(form);
            form.answers(answers, guess);
        }
        "choose" => form.answers(answers, choice),
        "order" => form.one("task.find", tr!("What the order must do"), finds()),
        "change" => change(form),
        _ => {}
    }
}

fn statement(form: &mut Form<'_>, at: &str, label: &'static str, picks: Vec<Pick>) {
    let part = |part: &str| format!("{at}.{part}");
    let costs = objective(form.scene);
    match form.chosen(&part("is"), label, picks).as_str() {
        "impossible" => form.add(
            &part("each-alone"),
            tr!("Each robot alone must still have one"),
            Input::Switch,
            Shape::Flag,
            false,
        ),
        "cost" => {
            form.one(&part("cost"), tr!("Cost"), costs);
            form.one(&part("compare"), tr!("Compared"), comparisons());
            form.number(&part("value"), tr!("Number"), true);
        }
        "raised" => {
            form.one(&part("cost"), tr!("Cost"), costs);
            form.number(&part("by"), tr!("More by"), true);
        }
        "price" => {
            rule(form, &part("rule"));
            form.one(&part("compare"), tr!("Compared"), comparisons());
            form.number(&part("value"), tr!("Number"), true);
        }
        "broken" => rule(form, &part("rule")),
        "verdict" => {
            let question = tr!("Question, such as: wait A2 --at 3,1");
            form.line(&part("question"), question, Shape::Question, true);
            form.one(&part("verdict"), tr!("Answer"), verdicts());
        }
        "apart" => {
            form.one(&part("costs[0]"), tr!("One cost"), self::costs());
            let mut others = self::costs();
            others.rotate_left(1);
            form.one(&part("costs[1]"), tr!("The other cost"), others);
        }
        _ => {}
    }
}

/// A rule of the scene's own.
fn rule(form: &mut Form<'_>, name: &str) {
    let rules = Input::One(rules(form.scene));
    form.add(name, tr!("Rule"), rules, Shape::Number, true);
}

fn lead(form: &mut Form<'_>) {
    let who = Input::Many(robots(form.scene));
    form.add(
        "task.robots",
        tr!("Who may be led"),
        who,
        Shape::Words,
        true,
    );
    let aim = form.chosen("task.aim.is", tr!("The plan must"), aims());
    match aim.as_str() {
        "cost" => {
            form.one("task.aim.cost", tr!("Cost"), costs());
            form.number("task.aim.at-most", tr!("At most"), true);
        }
        "best" => form.add(
            "task.aim.objective",
            tr!("Best in"),
            Input::One(costs_or(tr!("what the scene says"))),
            Shape::Words,
            false,
        ),
        _ => {}
    }
}

fn quantity(form: &mut Form<'_>) {
    let robot = |form: &mut Form<'_>| {
        let robots = robots(form.scene);
        form.one("task.what.robot", tr!("Robot"), robots);
    };
    let what = form.chosen("task.what.is", tr!("To be said"), quantities());
    match what.as_str() {
        "cost" => {
            let costs = objective(form.scene);
            form.one("task.what.cost", tr!("Cost"), costs);
        }
        "arrival" | "first-waypoint" => robot(form),
        "place" => {
            robot(form);
            form.number("task.what.time", tr!("Time"), true);
        }
        "points" => form.add(
            "task.what.costs",
            tr!("Costs, two or three"),
            Input::Many(costs()),
            Shape::Words,
            true,
        ),
        "planner" => {
            let planner = form.chosen("task.what.planner", tr!("Planner"), planners());
            if planner == "prioritised" {
                let order = tr!("Order of the robots, a line each");
                let order = (order, Input::Area);
                form.add("task.what.order", order.0, order.1, Shape::Words, false);
            }
            form.one("task.what.cost", tr!("Cost"), costs());
        }
        "price" => rule(form, "task.what.rule"),
        "first-at" => form.line("task.what.cell", tr!("Cell"), Shape::Cell, true),
        "delay" => {
            robot(form);
            let all = tr!("anybody: all that it loses");
            let others = robots_or(form.scene, all);
            form.one("task.what.because", tr!("Because of"), others);
        }
        "node" => form.number(
            "task.what.number",
            tr!("Number of the node, 0 is the root"),
            true,
        ),
        "changed" => {
            changes(form, "task.what.changes");
            form.one("task.what.method", tr!("How it goes on"), methods());
            let kept = tr!("none: how many robots keep their path");
            form.one("task.what.cost", tr!("Cost"), costs_or(kept));
        }
        _ => {}
    }
}

fn guess(form: &mut Form<'_>, at: &str) {
    let what = form
        .words
        .get("task.what.is")
        .map_or("cost", String::as_str);
    let value = format!("{at}.value");
    match what {
        "waits" | "first-at" | "loses-most" | "costs-most" => {
            let robots = robots(form.scene);
            form.one(&value, tr!("Robot"), robots);
        }
        "decides" => rule(form, &format!("{value}.rule")),
        "place" | "first-waypoint" => form.line(&value, tr!("Cell"), Shape::Cell, true),
        _ => form.number(&value, tr!("Number"), true),
    }
    form.line(&format!("{at}.text"), tr!("In words"), Shape::Text, true);
    form.line(&format!("{at}.reply"), tr!("Reply"), Shape::Text, true);
}

fn choice(form: &mut Form<'_>, at: &str) {
    form.line(&format!("{at}.text"), tr!("Answer"), Shape::Text, true);
    form.add(
        &format!("{at}.right"),
        tr!("It is right"),
        Input::Switch,
        Shape::Flag,
        false,
    );
    form.line(&format!("{at}.reply"), tr!("Reply"), Shape::Text, true);
    statement(form, &format!("{at}.claim"), tr!("It says that"), claims());
}

fn change(form: &mut Form<'_>) {
    changes(form, "task.changes");
    let methods = Input::Many(methods());
    form.add(
        "task.methods",
        tr!("Methods to pick from"),
        methods,
        Shape::Words,
        true,
    );
    let none = costs_or(tr!("no cost"));
    let cost = form.chosen("task.cost.cost", tr!("To be reached"), none);
    if !cost.is_empty() {
        form.number("task.cost.at-most", tr!("At most"), true);
    }
    form.number(
        "task.kept",
        tr!("Robots that keep their path, at least"),
        false,
    );
}

fn changes(form: &mut Form<'_>, name: &str) {
    let label = tr!("Changes, as the page saves them");
    form.add(name, label, Input::Area, Shape::Changes, true);
}
