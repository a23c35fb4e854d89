//! A lesson as pages for paper: boards as vectors, texts, tasks with room for an answer,
//! and the answers apart on the last page.

use std::fmt::Write as _;

use giveway_course::lesson::{Id, Lesson, Step, Task, Text};
use giveway_model::constraint::InForce;
use giveway_model::{Cell, Instance, Plan, tr};
use giveway_picture::{Look, on_paper};
use gloo::events::EventListener;
use wasm_bindgen::JsCast as _;
use wasm_bindgen_futures::JsFuture;
use web_sys::{Element, HtmlImageElement};
use yew::platform::spawn_local;
use yew::prelude::*;

use super::tutor::Msg;

/// The longest side of a board, in pixels.
const LONGEST_PX: u32 = 560;
/// The most steps of a plan that fit beside each other.
const MOST_TIMES: usize = 14;
/// The most robots beside each other in the table of a longer plan.
const MOST_ROBOTS: usize = 10;
/// How many lines there are to write an answer on.
const LINES: usize = 3;

/// Where the pages stand while they are printed: beside the page, which is not.
pub(super) struct Sheet {
    host: Element,
    is_new: bool,
    _printed: EventListener,
}

impl Sheet {
    /// A place on the page; nothing where the browser has none.
    pub(super) fn new(send: Callback<Msg>) -> Option<Self> {
        let document = gloo::utils::document();
        let body = document.body()?;
        let host = document.create_element("div").ok()?;
        host.set_id("print");
        body.append_child(&host).ok()?;
        // It cannot fail: the name of the attribute is valid.
        let _ = body.set_attribute("data-prints", "");
        let window = gloo::utils::window();
        let printed = EventListener::new(&window, "afterprint", move |_| send.emit(Msg::Printed));
        Some(Self {
            host,
            is_new: true,
            _printed: printed,
        })
    }

    /// The pages, in their place.
    pub(super) fn show(&self, id: &Id, lesson: &Lesson) -> Html {
        create_portal(pages(id, lesson), self.host.clone())
    }

    /// Opens the browser's own dialog once the pages are there, with their pictures.
    pub(super) fn print(&mut self) {
        if !std::mem::take(&mut self.is_new) {
            return;
        }
        let Ok(pictures) = self.host.query_selector_all("img") else {
            return;
        };
        spawn_local(async move {
            for index in 0..pictures.length() {
                let picture = pictures.get(index);
                let picture = picture.and_then(|it| it.dyn_into::<HtmlImageElement>().ok());
                if let Some(picture) = picture {
                    // One that cannot be drawn is missing on paper, too.
                    let _ = JsFuture::from(picture.decode()).await;
                }
            }
            // A browser may print nothing; then nothing happens.
            let _ = gloo::utils::window().print();
        });
    }
}

impl Drop for Sheet {
    fn drop(&mut self) {
        self.host.remove();
        if let Some(body) = gloo::utils::document().body() {
            let _ = body.remove_attribute("data-prints");
        }
    }
}

fn pages(id: &Id, lesson: &Lesson) -> Html {
    let step = |(index, step): (usize, &Step)| part(lesson, index, step);
    html! {
        <>
            <header>
                <h1>{ lesson.title.clone() }</h1>
                <p>{ plain(&lesson.about) }</p>
                <p class="where">{ tr!("Giveway, a lesson of {n} minute" | "Giveway, a lesson of {n} minutes" % lesson.minutes) }
                    // One's own lesson is in a file, or in a link that nobody types.
                    if !id.is_own() { { ": " }{ address(id) } }
                </p>
            </header>
            { for lesson.steps.iter().enumerate().map(step) }
            if !lesson.hides_answers {
                <section class="answers">
                    <h1>{ tr!("Answers") }</h1>
                    { for lesson.steps.iter().enumerate().map(answer) }
                </section>
            }
        </>
    }
}

/// Where the lesson is on the page.
fn address(id: &Id) -> String {
    let address = gloo::utils::window().location().href().unwrap_or_default();
    let page = address.split('#').next().unwrap_or_default();
    format!("{page}#lesson={id}")
}

/// A step: its board where that is another one, its text, its task.
fn part(lesson: &Lesson, index: usize, step: &Step) -> Html {
    let paragraph = |text: &Text| html! { <p>{ plain(text) }</p> };
    html! {
        <section>
            <h2>{ format!("{} {}", index + 1, step.title) }</h2>
            if let Some(svg) = board(lesson, index, step) {
                <img src={format!("data:image/svg+xml,{}", js_sys::encode_uri_component(&svg))}
                    alt={tr!("The board of this step")} />
            }
            { for step.text.iter().map(paragraph) }
            { rules(step) }
            if let Some(plan) = plan_on_paper(step) { { times(&plan) } }
            if let Some(task) = &step.task { { exercise(task) } }
        </section>
    }
}

/// The plan of a step; who leads a robot finds its way.
fn plan_on_paper(step: &Step) -> Option<Plan> {
    let mut plan = step.plan.clone()?;
    if let Some(Task::Lead(task)) = &step.task {
        plan.paths.retain(|name, _| !task.robots.contains(name));
    }
    Some(plan)
}

/// The rules of a new board.
fn rules(step: &Step) -> Html {
    let Some(scene) = &step.scene else {
        return Html::default();
    };
    let row = |rule: InForce| {
        let number = tr!("Rule {n}", n = rule.index + 1);
        html! { <p><b>{ number }</b>{ format!(": {}", rule.constraint.sentence()) }</p> }
    };
    html! { <>{ for scene.constraints_in_force().map(row) }</> }
}

fn board(lesson: &Lesson, index: usize, step: &Step) -> Option<String> {
    let is_new = step.scene.is_some() || step.plan.is_some();
    let scene = lesson.scene(index).filter(|_| is_new)?;
    let instance = Instance::new(scene.clone()).ok()?;
    let plan = plan_on_paper(step).unwrap_or_default();
    let look = Look::fitting(instance.grid(), LONGEST_PX);
    Some(on_paper(&instance, &plan, f64::from(step.time), &look))
}

/// Where a robot is at a time: on paper nothing plays.
fn cell(path: &[Option<Cell>], time: usize) -> Html {
    // Who has arrived stays.
    let cell = path.get(time).or(path.last()).copied().flatten();
    let words = cell.map(|cell| format!("{}, {}", cell.x, cell.y));
    html! { <td>{ words.unwrap_or_default() }</td> }
}

/// The plan with a row a time and a column a robot, some robots beside each other.
fn long(plan: &Plan, steps: usize) -> Html {
    let robots: Vec<(&String, &Vec<Option<Cell>>)> = plan.paths.iter().collect();
    let part = |robots: &[(&String, &Vec<Option<Cell>>)]| {
        html! {
            <table>
                <thead><tr><th scope="col">{ tr!("Time") }</th>{ for robots.iter().map(|(name, _)| html! { <th scope="col">{ (*name).clone() }</th> }) }</tr></thead>
                <tbody>{ for (0..steps).map(|time| html! {
                    <tr><th scope="row">{ time }</th>{ for robots.iter().map(|(_, path)| cell(path, time)) }</tr>
                }) }</tbody>
            </table>
        }
    };
    html! { <>{ for robots.chunks(MOST_ROBOTS).map(part) }</> }
}

/// Where each robot is at each time.
fn times(plan: &Plan) -> Html {
    let steps = plan.paths.values().map(Vec::len).max().unwrap_or_default();
    if steps > MOST_TIMES {
        return long(plan, steps);
    }
    let row = |(name, path): (&String, &Vec<Option<Cell>>)| {
        let cell = |time: usize| cell(path, time);
        html! { <tr><th scope="row">{ name.clone() }</th>{ for (0..steps).map(cell) }</tr> }
    };
    html! {
        <table>
            <thead><tr><th scope="col">{ tr!("Time") }</th>{ for (0..steps).map(|time| html! { <th scope="col">{ time }</th> }) }</tr></thead>
            <tbody>{ for plan.paths.iter().map(row) }</tbody>
        </table>
    }
}

/// The task, with boxes to tick or lines to write on.
fn exercise(task: &Task) -> Html {
    let answers: Vec<&Text> = match task {
        Task::Predict(task) => task.answers.iter().map(|answer| &answer.text).collect(),
        Task::Choose(task) => task.answers.iter().map(|answer| &answer.text).collect(),
        _ => Vec::new(),
    };
    let tick = |text: &&Text| html! { <li>{ plain(text) }</li> };
    html! {
        <div class="task">
            <p><b>{ tr!("Your turn") }{ ": " }</b>{ plain(task.say()) }</p>
            if answers.is_empty() {
                { for (0..LINES).map(|_| html! { <hr /> }) }
            } else {
                <ul>{ for answers.iter().map(tick) }</ul>
            }
        </div>
    }
}

/// What is right, how it is done, why it is so.
fn answer((index, step): (usize, &Step)) -> Html {
    let Some(task) = &step.task else {
        return html! {};
    };
    let mut all = Vec::new();
    if let Task::Choose(task) = task {
        let right = task.answers.iter().filter(|answer| answer.right);
        all.extend(right.map(|answer| &answer.text));
    }
    all.extend(step.hints.last());
    all.extend(&step.reason);
    let mut words = String::new();
    for text in all {
        // Writing to a string cannot fail.
        let _ = write!(words, "{} ", plain(text));
    }
    html! {
        <p><b>{ format!("{} {}", index + 1, step.title) }{ if step.title.ends_with(['?', '!', '.']) { " " } else { ": " } }</b>{ words }</p>
    }
}

fn plain(text: &Text) -> String {
    text.plain()
}
