//! What a lesson says before a room: its step in a few words, in the lower third of the
//! page. Elsewhere it is not shown.

use giveway_course::judge::words::said;
use giveway_course::judge::{Did, Verdict};
use giveway_course::learner::{Action, Open};
use giveway_course::lesson::quantity::ValueKind;
use giveway_course::lesson::{Step, Task, Text};
use giveway_model::tr;
use yew::prelude::*;

use super::exercise::{answers, free, is_answered};
use super::prose::{Reader, first_sentence};
use super::tutor::{Msg, Tutor};

/// The most sentences that are read from the last row.
const SENTENCES: usize = 2;

/// The title, then the task or what the text begins with, then what is judged.
pub(super) fn show(tutor: &Tutor, open: &Open, step: &Step, reader: Reader<'_>) -> Html {
    let text = match &step.task {
        Some(task) => task.say().clone(),
        None => Text::opening(&step.text, SENTENCES),
    };
    let verdict = open.judge().verdict();
    // Where answers are hidden from the room, what is judged is, too (`static/css/present.css`).
    let judged = verdict.map(|verdict| {
        let said = said(verdict, step);
        let reason = step.reason.as_ref().filter(|_| verdict.is_solved());
        // What the judge says goes on behind its head.
        let sign = if reason.is_some() { ". " } else { ": " };
        let words = Text::opening(&[reason.cloned().unwrap_or(said.text)], SENTENCES);
        html! { <p class="judged"><b>{ format!("{}{sign}", said.head) }</b>{ reader.still(words.spans()) }</p> }
    });
    html! {
        <section class="third" aria-live="polite">
            <h2>{ step.title.clone() }{ " " }<small>{ tr!("{step} of {steps}", step = open.index() + 1, steps = open.lesson.steps.len()) }</small></h2>
            <p>{ reader.still(text.spans()) }</p>
            { listed(open, step.task.as_ref(), reader) }
            { to_say(tutor, open, step.task.as_ref(), reader) }
            { judged.unwrap_or_default() }
        </section>
    }
}

/// The answers to choose from, by their keys; one that was solved before is asked anew.
fn listed(open: &Open, task: Option<&Task>, reader: Reader<'_>) -> Html {
    let texts: Vec<&Text> = match task {
        Some(Task::Predict(task)) => task.answers.iter().map(|answer| &answer.text).collect(),
        Some(Task::Choose(task)) => task.answers.iter().map(|answer| &answer.text).collect(),
        _ => Vec::new(),
    };
    let are_short = are_told_apart(&texts);
    let is_over = open.is_solved() || is_answered(open);
    let one = |place: usize, text: &Text, is_right: bool, act: Action| {
        let (title, _) = first_sentence(text);
        let said = if are_short { &title[..] } else { text.spans() };
        let key = (place + 1).to_string();
        let press = reader
            .send
            .reform(move |_: MouseEvent| Msg::Do(act.clone()));
        html! {
            <li class={is_right.then_some("right")}>
                <button type="button" data-room-key={key.clone()} disabled={is_over} onclick={press}><kbd>{ key }</kbd><span>{ reader.still(said) }</span></button>
            </li>
        }
    };
    let list: Vec<Html> = match task {
        Some(Task::Predict(task)) => {
            let truth = open.judge().verdict().and_then(Verdict::truth);
            let answers = task.answers.iter().enumerate();
            answers
                .map(|(place, answer)| {
                    let guess = Action::Guess(answer.value.clone());
                    one(place, &answer.text, truth == Some(&answer.value), guess)
                })
                .collect()
        }
        Some(Task::Choose(task)) => {
            let chosen = match open.did() {
                Did::Chose(place) if open.is_solved() => Some(*place),
                _ => None,
            };
            let answers = task.answers.iter().enumerate();
            answers
                .map(|(place, answer)| {
                    let choose = Action::Choose(place);
                    one(place, &answer.text, chosen == Some(place), choose)
                })
                .collect()
        }
        _ => Vec::new(),
    };
    if list.is_empty() {
        return html! {};
    }
    html! { <ol>{ for list }</ol> }
}

/// What a prediction without answers to pick from is said by: a field, or the robots or rules by
/// their keys. What takes a wrong one back.
fn to_say(tutor: &Tutor, open: &Open, task: Option<&Task>, reader: Reader<'_>) -> Html {
    let Some(Task::Predict(task)) = task else {
        return html! {};
    };
    if is_answered(open) {
        return html! { if !open.is_solved() { <p>{ answers::again(reader) }</p> } };
    }
    if !task.answers.is_empty() {
        return html! {};
    }
    let row = |place: usize, words: Html| html! { <li><kbd>{ place + 1 }</kbd><span>{ words }</span></li> };
    let scene = open.scene();
    match task.what.kind() {
        ValueKind::Number => free::number(tutor, reader),
        ValueKind::Robot => {
            let robots = scene.agents.iter().enumerate();
            html! { <ol>{ for robots.map(|(place, agent)| row(place, reader.robot(&agent.name))) }</ol> }
        }
        ValueKind::Rule => {
            let rules = scene.constraints_in_force();
            html! { <ol>{ for rules.map(|rule| row(rule.index, html! { { rule.constraint.sentence() } })) }</ol> }
        }
        // It is pressed on the board.
        ValueKind::Cell => html! {},
    }
}

/// Whether answers differ in their first sentences already.
fn are_told_apart(texts: &[&Text]) -> bool {
    let titles: Vec<_> = texts.iter().map(|text| first_sentence(text).0).collect();
    let is_new = |(place, title)| !titles[..place].contains(title);
    titles.iter().enumerate().all(is_new)
}
