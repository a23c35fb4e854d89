//! The column beside the board that shows a student's work.

use giveway_course::grade::{Chosen, Claim, Given, Graded, LookAction, Row};
use giveway_course::handin::answer_words;
use giveway_model::tr;
use yew::prelude::*;

use super::table::state;
use super::{ClassMsg, Collected};
use crate::course::sight::once;
use crate::course::tutor::{Msg, Tutor};
use crate::icon;

/// The column; nothing where no work is chosen.
pub(in crate::course) fn show(tutor: &Tutor, class: &Collected, send: &Callback<Msg>) -> Html {
    let Some((row, task)) = class.looking.task(&class.class) else {
        return html! {};
    };
    let place = row.file().lesson();
    let Some(given) = place.and_then(|place| class.class.lessons().get(place)) else {
        return html! {};
    };
    let back = once(send, || Msg::Class(ClassMsg::Back));
    html! {
        <aside class="insp lesson" aria-label={tr!("A student's work")}>
            <div class="scroll" key={format!("{}.{}", row.place(), task.step)}>
                <header class="qh">
                    <div class="lrow"><button type="button" class="crumb" onclick={back}>{ icon::show("back") }{ tr!("Class") }</button></div>
                    <h2 tabindex="-1" ref={tutor.title.clone()}><bdi>{ row.title().to_owned() }</bdi></h2>
                    <p class="lead">{ given.lesson.title.clone() }</p>
                </header>
                { verdict(class, task, given) }
                { tasks(row, task, given, send) }
                { give_back(class, send) }
                { others(class, row) }
            </div>
            { foot(class, send) }
        </aside>
    }
}

/// How the task is judged, and what was answered.
fn verdict(class: &Collected, task: &Graded, given: &Given) -> Html {
    let Some(said) = class.looking.said(&class.class) else {
        return html! {};
    };
    let (class, sign, _) = state(task);
    let first = task.work.as_ref().and_then(|work| work.first.as_ref());
    let first = first.map(|answer| answer_words(answer, task.step, &given.lesson));
    let tries = task.tries();
    html! {
        <section class={classes!("ex", "work", class)} role="status">
            <p class="exk">{ icon::show(sign) }{ said.head }</p>
            <h3>{ given.task_words(task.step) }</h3>
            if let Some(asked) = given.asked(task.step) { <p class="quiet">{ asked.plain() }</p> }
            if !said.reason.is_empty() { <p>{ said.reason }</p> }
            if task.claim() == Claim::False { <p>{ tr!("The file says that it is solved.") }</p> }
            if !said.answer.is_empty() { <p><b>{ tr!("Answer") }</b>{ ": " }<bdi>{ said.answer }</bdi></p> }
            if let Some(first) = first { <p><b>{ tr!("First answer") }</b>{ ": " }<bdi>{ first }</bdi></p> }
            if tries > 0 { <p class="quiet">{ tr!("{n} try, as the file says" | "{n} tries, as the file says" % tries) }</p> }
        </section>
    }
}

/// The tasks of this student.
fn tasks(row: Row<'_>, shown: &Graded, given: &Given, send: &Callback<Msg>) -> Html {
    let card = |task: &Graded| {
        let (class, sign, words) = state(task);
        let next = Some(Chosen {
            file: row.place(),
            step: task.step,
        });
        let press = once(send, move || {
            Msg::Class(ClassMsg::Look(LookAction::Choose(next)))
        });
        html! {
            <li><button type="button" class="hand-card" aria-pressed={(task.step == shown.step).to_string()} onclick={press}>
                <b>{ given.task_words(task.step) }</b>
                <small class={classes!("sign", class)}>{ icon::show(sign) }{ words }</small>
            </button></li>
        }
    };
    html! {
        <section aria-labelledby="work-tasks">
            <h3 id="work-tasks">{ tr!("All tasks") }</h3>
            <ol class="hand-cards">{ for row.tasks().iter().map(card) }</ol>
        </section>
    }
}

/// What is told to the student, as a text for a mail.
fn give_back(class: &Collected, send: &Callback<Msg>) -> Html {
    let copy = once(send, || Msg::Class(ClassMsg::CopyWork));
    html! {
        <div class="exa">
            <button type="button" class="btn outline" title={tr!("Each task, how it is judged, and why, as a text for a mail")} onclick={copy}>
                { icon::show("copy") }<span>{ tr!("Copy for the student") }</span>
            </button>
            <span class="quiet" role="status">{ class.told.clone() }</span>
        </div>
    }
}

/// Other files of the same name, which do not count.
fn others(class: &Collected, row: Row<'_>) -> Html {
    let others = row.files().iter().filter(|place| **place != row.place());
    let names: Vec<&str> = others
        .filter_map(|place| Some(class.class.files().get(*place)?.file.as_str()))
        .collect();
    if names.is_empty() {
        return html! {};
    }
    html! {
        <section aria-labelledby="work-others">
            <h3 id="work-others">{ tr!("Earlier files of this name") }</h3>
            <ul class="unr">{ for names.iter().map(|name| html! { <li>{ icon::show("file") }<bdi>{ (*name).to_owned() }</bdi></li> }) }</ul>
            <p class="quiet">{ tr!("The latest counts.") }</p>
        </section>
    }
}

fn foot(class: &Collected, send: &Callback<Msg>) -> Html {
    let all = class.looking.to_look_at(&class.class);
    let is_none = all.is_empty();
    let place = all.iter().position(|it| Some(*it) == class.looking.chosen);
    let next = match place {
        Some(place) => tr!(
            "Next to look at ({n} of {all})",
            n = place + 1,
            all = all.len()
        ),
        None => tr!("Next to look at").to_owned(),
    };
    let look = |on: bool| {
        once(send, move || {
            Msg::Class(ClassMsg::Look(LookAction::LookAt(on)))
        })
    };
    html! {
        <footer class="foot">
            <button type="button" class="btn outline" disabled={is_none} onclick={look(false)}>{ icon::show("back") }<span>{ tr!("the one before" => "Before") }</span></button>
            <button type="button" class="btn primary" disabled={is_none} onclick={look(true)}><span>{ next }</span></button>
        </footer>
    }
}
