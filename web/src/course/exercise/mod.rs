//! What there is to do in a step: the task, what the judge says of it, hints.

pub(super) mod answers;
mod change;
pub(super) mod free;
mod judge;
mod order;
mod price;
mod solved;
mod spot;

use giveway_course::learner::{Action, Judge, Open};
use giveway_course::lesson::task::Lead;
use giveway_course::lesson::{Task, Text};
use giveway_model::tr;
use yew::prelude::*;

use super::prose::Reader;
use super::tutor::{Msg, Tutor};
use crate::icon;

/// Whether the answer to a question is on the table, right or not.
pub(super) fn is_answered(open: &Open) -> bool {
    let verdict = open.judge().verdict();
    verdict.is_some_and(|verdict| verdict.truth().is_some())
}

/// The exercise.
pub(super) fn show(tutor: &Tutor, open: &Open, task: &Task, reader: Reader<'_>) -> Html {
    let is_solved = open.is_solved();
    match task {
        task if open.was_solved() => html! {
            <section class="ex solved" aria-labelledby="ex-h">{ solved::before(open, task, reader) }</section>
        },
        Task::Predict(task) => answers::predict(tutor, open, task, reader),
        Task::Choose(task) => answers::choose(tutor, open, task, reader),
        _ if is_solved => html! {
            <section class="ex solved" aria-labelledby="ex-h">{ solved::show(open, reader) }</section>
        },
        task => html! {
            <section class="ex" aria-labelledby="ex-h">
                <p class="exk" id="ex-h">{ icon::show("edit") }{ tr!("Your turn") }</p>
                <p class="exq">{ reader.show(task.say()) }</p>
                { before(open) }
                { tools(tutor, open, task, reader) }
                { judge::show(tutor, open, reader) }
                { hints(open.hints(), reader) }
                { actions(open, reader.send) }
            </section>
        },
    }
}

/// What was answered when the step was open before.
fn before(open: &Open) -> Html {
    let answer = open.answer_before();
    answer.map_or_else(Html::default, |answer| {
        html! { <p class="quiet">{ tr!("Your last answer: {answer}", answer) }</p> }
    })
}

/// What is done beside the board.
fn tools(tutor: &Tutor, open: &Open, task: &Task, reader: Reader<'_>) -> Html {
    match task {
        Task::Spot(_) => spot::show(open, reader),
        Task::Order(_) => order::show(&tutor.order(), reader),
        Task::Change(task) => change::show(open, task, reader.send),
        Task::Lead(task) => lead(open, task, reader),
        Task::Paint(_) | Task::Predict(_) | Task::Choose(_) => html! {},
    }
}

/// How robots are led; all but to wait and to choose one is done on the board.
fn lead(open: &Open, task: &Lead, reader: Reader<'_>) -> Html {
    let wait = reader.send.reform(|_: MouseEvent| Msg::Do(Action::Wait));
    let one = |(place, name): (usize, &String)| {
        let key = (place + 1).to_string();
        let is_led = open.leads() == Some(name.as_str());
        let led = name.clone();
        let press = reader
            .send
            .reform(move |_: MouseEvent| Msg::Do(Action::Lead(led.clone())));
        html! {
            <li><button type="button" class="opt" data-key={key.clone()} title={tr!("Key {number}", number = key)}
                aria-pressed={is_led.to_string()} onclick={press}>{ reader.robot(name) }</button></li>
        }
    };
    html! {
        <div class="leads">
            // Two robots may be in each other's way on the board: here each can be chosen.
            if task.robots.len() > 1 {
                <ul class="opts few" aria-label={tr!("The robot that you lead")}>{ for task.robots.iter().enumerate().map(one) }</ul>
            }
            <p class="quiet">{ tr!("Press the cell that it goes to, or use the arrow keys.") }</p>
            <button type="button" class="btn outline" title={tr!("Wait (w)")} onclick={wait}>{ icon::show("pause") }<span>{ tr!("Wait a step") }</span></button>
        </div>
    }
}

fn hints(hints: &[Text], reader: Reader<'_>) -> Html {
    if hints.is_empty() {
        return html! {};
    }
    html! {
        <ol class="hints" aria-label={tr!("Hints")} aria-live="polite">
            { for hints.iter().map(|hint| html! { <li>{ icon::show("hint") }<p>{ reader.show(hint) }</p></li> }) }
        </ol>
    }
}

/// What takes back, begins anew, helps.
fn actions(open: &Open, send: &Callback<Msg>) -> Html {
    let act = |action: Action| send.reform(move |_: MouseEvent| Msg::Do(action.clone()));
    let has_done = open.has_done();
    html! {
        <div class="exa">
            if has_done {
                <button type="button" class="btn outline" onclick={act(Action::TakeBack)}>
                    { icon::show("undo") }<span>{ tr!("Take it back") }</span>
                </button>
            }
            { hint(open, send) }
            if has_done && open.attempts() > 1 {
                <button type="button" class="btn ghost" onclick={act(Action::Afresh)}><span>{ tr!("Start afresh") }</span></button>
            }
        </div>
    }
}

/// The next hint; the last one is the answer.
fn hint(open: &Open, send: &Callback<Msg>) -> Html {
    let all = open.step().map_or(0, |step| step.hints.len());
    let left = all.saturating_sub(open.hints().len());
    let word = match left {
        _ if open.hides_answers() => return html! {},
        0 => return html! {},
        1 if all > 1 => tr!("Show me how"),
        _ if left < all => tr!("Next hint"),
        _ => tr!("Hint"),
    };
    html! {
        <button type="button" class="btn ghost" onclick={send.reform(|_: MouseEvent| Msg::Do(Action::Hint))}>
            { icon::show("hint") }<span>{ word }</span>
        </button>
    }
}

/// Whether the judge is at work.
fn is_looking(open: &Open) -> bool {
    matches!(open.judge(), Judge::Looking(_))
}
