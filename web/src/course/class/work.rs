//! The column beside the board that shows a student's work.

use giveway_course::grade::{Claim, Graded};
use giveway_course::handin::answer_words;
use giveway_course::lesson::Step;
use giveway_model::tr;
use yew::prelude::*;

use super::choice::{Chosen, Looked};
use super::table::state;
use super::{ClassMsg, Collected};
use crate::course::sight::once;
use crate::course::tutor::{Msg, Tutor};
use crate::icon;

/// The column; nothing where no work is chosen.
pub(in crate::course) fn show(tutor: &Tutor, class: &Collected, send: &Callback<Msg>) -> Html {
    let chosen = class.chosen;
    let Some((chosen, looked)) = chosen.and_then(|it| Some((it, class.looked(it)?))) else {
        return html! {};
    };
    let back = once(send, || Msg::Class(ClassMsg::Back));
    let who = looked.file.hand_in().and_then(|it| it.name.clone());
    let who = who.unwrap_or_else(|| looked.file.file.clone());
    html! {
        <aside class="insp lesson" aria-label={tr!("A student's work")}>
            <div class="scroll" key={format!("{}.{}", chosen.file, chosen.task)}>
                <header class="qh">
                    <div class="lrow"><button type="button" class="crumb" onclick={back}>{ icon::show("back") }{ tr!("Class") }</button></div>
                    <h2 tabindex="-1" ref={tutor.title.clone()}><bdi>{ who }</bdi></h2>
                    <p class="lead">{ looked.given.lesson.title.clone() }</p>
                </header>
                { verdict(&looked) }
                { tasks(&looked, chosen, send) }
                { others(class, chosen) }
            </div>
            { foot(class, send) }
        </aside>
    }
}

/// How the task is judged, and what was answered.
fn verdict(looked: &Looked<'_>) -> Html {
    let graded = looked.graded;
    let (class, sign, words) = state(graded);
    let reason = match (graded.judgement(), looked.step) {
        (Some(judgement), Some(step)) => judgement.reason(step),
        (Some(judgement), None) => judgement.reason(&Step::default()),
        (None, _) => String::new(),
    };
    let work = graded.work.as_ref();
    let lesson = &looked.given.lesson;
    let words_of = |answer| answer_words(answer, graded.step, lesson);
    let answer = work.and_then(|work| work.answer.as_ref()).map(words_of);
    let first = work.and_then(|work| work.first.as_ref()).map(words_of);
    let tries = graded.tries();
    html! {
        <section class={classes!("ex", "work", class)} role="status">
            <p class="exk">{ icon::show(sign) }{ words }</p>
            <h3>{ looked.step.map(|step| step.title.clone()) }</h3>
            if !reason.is_empty() { <p>{ reason }</p> }
            if graded.claim() == Claim::False { <p>{ tr!("The file says that it is solved.") }</p> }
            if let Some(answer) = answer { <p><b>{ tr!("Answer") }</b>{ ": " }<bdi>{ answer }</bdi></p> }
            if let Some(first) = first { <p><b>{ tr!("First answer") }</b>{ ": " }<bdi>{ first }</bdi></p> }
            if tries > 0 { <p class="quiet">{ tr!("{n} try, as the file says" | "{n} tries, as the file says" % tries) }</p> }
        </section>
    }
}

/// The tasks of this student.
fn tasks(looked: &Looked<'_>, chosen: Chosen, send: &Callback<Msg>) -> Html {
    let card = |(task, graded): (usize, &Graded)| {
        let (class, sign, words) = state(graded);
        let title = looked.given.lesson.steps.get(graded.step);
        let title = title.map_or("", |step| &step.title);
        let next = Chosen { task, ..chosen };
        let press = once(send, move || Msg::Class(ClassMsg::Choose(next)));
        html! {
            <li><button type="button" class="hand-card" aria-pressed={(next == chosen).to_string()} onclick={press}>
                <b>{ tr!("a task with its number" => "{n} {title}", n = task + 1, title) }</b>
                <small class={classes!("sign", class)}>{ icon::show(sign) }{ words }</small>
            </button></li>
        }
    };
    html! {
        <section aria-labelledby="work-tasks">
            <h3 id="work-tasks">{ tr!("All tasks") }</h3>
            <ol class="hand-cards">{ for looked.file.tasks().iter().enumerate().map(card) }</ol>
        </section>
    }
}

/// Other files of the same name, which do not count.
fn others(class: &Collected, chosen: Chosen) -> Html {
    let rows = class.class.rows(class.lesson(), class.order);
    let row = rows.iter().find(|row| row.place() == chosen.file);
    let places = row.map_or(&[][..], |row| row.files());
    let others = places.iter().filter(|place| **place != chosen.file);
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
    let is_there = class.to_look_at(true).is_some();
    let look = |on: bool| once(send, move || Msg::Class(ClassMsg::Look(on)));
    html! {
        <footer class="foot">
            <button type="button" class="btn outline" disabled={!is_there} onclick={look(false)}>{ icon::show("back") }<span>{ tr!("Before") }</span></button>
            <button type="button" class="btn primary" disabled={!is_there} onclick={look(true)}><span>{ tr!("Next to look at") }</span></button>
        </footer>
    }
}
