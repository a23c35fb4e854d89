//! The column of the lesson that is open: where one is in it, the text, what there is
//! to do, the way on.

use std::rc::Rc;

use giveway_course::learner::{Action, Open};
use giveway_model::tr;
use yew::prelude::*;

use super::author::AuthorMsg;
use super::contents::Page;
use super::exercise;
use super::handin::{self, HandMsg};
use super::proof;
use super::prose::Reader;
use super::rules;
use super::shelf::Shelf;
use super::sight::once;
use super::third;
use super::tutor::{Msg, Tutor};
use crate::icon;

pub(super) fn show(tutor: &Tutor, open: &Open, shelf: &Rc<Shelf>, send: &Callback<Msg>) -> Html {
    let Some(step) = open.step() else {
        return html! {};
    };
    if let Some(handing) = &tutor.handing {
        let column = handin::show(tutor, handing, open, send);
        return html! { <aside class="insp lesson" aria-label={tr!("Lesson")}>{ column }</aside> };
    }
    let robots = open.robots();
    let reader = Reader {
        agents: &robots,
        shelf,
        send,
    };
    // The next step begins at its top.
    let key = format!("{}.{}", open.id, open.index());
    html! {
        <aside class="insp lesson" aria-label={tr!("Lesson")}>
            <div class="scroll" {key}>
                <header class="qh">
                    { way_out(open, send) }
                    { progress(open, send) }
                    <h2 tabindex="-1" ref={tutor.title.clone()}>{ step.title.clone() }</h2>
                </header>
                <div class="prose">{ reader.paragraphs(&step.text) }</div>
                { rules::show(open) }
                { proof::show(open, send) }
                if let Some(task) = &step.task {
                    { exercise::show(tutor, open, task, reader) }
                }
                { elsewhere(open, send) }
            </div>
            { foot(tutor, open, send) }
            { third::show(tutor, open, step, reader) }
        </aside>
    }
}

fn way_out(open: &Open, send: &Callback<Msg>) -> Html {
    let is_tried = open.is_tried();
    let contents = send.reform(move |_: MouseEvent| {
        if is_tried {
            Msg::Do(Action::Close)
        } else {
            Msg::Show(Some(Page::Lessons))
        }
    });
    let course = if is_tried {
        tr!("Go on writing")
    } else {
        tr!("Course")
    };
    let leave = send.reform(|_: MouseEvent| Msg::Do(Action::Close));
    html! {
        <div class="lrow">
            <button type="button" class="crumb" onclick={contents}>{ icon::show("back") }{ course }</button>
            <span class="grow"></span>
            <button type="button" class="btn ghost round sm" title={tr!("Leave the lesson")} onclick={leave}>
                { icon::show("cancel") }<span class="vh">{ tr!("Leave the lesson") }</span>
            </button>
        </div>
    }
}

/// The lesson before a room, on paper, and for a lecturer.
fn elsewhere(open: &Open, send: &Callback<Msg>) -> Html {
    let press = |msg: fn() -> Msg| send.reform(move |_: MouseEvent| msg());
    html! {
        <div class="exa elsewhere">
            <button type="button" class="btn ghost" title={tr!("The board full screen, before a room (P)")} onclick={press(|| Msg::Present)}>
                { icon::show("fit") }<span>{ tr!("Present") }</span>
            </button>
            <button type="button" class="btn ghost" title={tr!("The lesson on paper, its answers apart")} onclick={press(|| Msg::Print)}>
                { icon::show("file") }<span>{ tr!("Print") }</span>
            </button>
            if !open.is_tried() {
                <button type="button" class="btn ghost" title={tr!("A lesson of your own, which begins as a copy of this one")} onclick={press(|| Msg::Author(AuthorMsg::Adapt))}>
                    { icon::show("edit") }<span>{ tr!("a lesson" => "Change it") }</span>
                </button>
            }
            // After the last step it stands beside the way on.
            if !open.is_last() { { hand_in("btn ghost", open, send) } }
        </div>
    }
}

/// The way to hand the lesson in, where it can be.
fn hand_in(class: &'static str, open: &Open, send: &Callback<Msg>) -> Html {
    if !handin::can_begin(open) {
        return Html::default();
    }
    let onclick = once(send, || Msg::Hand(HandMsg::Begin));
    html! {
        <button type="button" {class} title={tr!("Save your answers for your lecturer")} {onclick}>
            { icon::show("share") }<span>{ tr!("Hand in") }</span>
        </button>
    }
}

/// A bar for each step, which opens it.
fn progress(open: &Open, send: &Callback<Msg>) -> Html {
    let (at, steps) = (open.index(), open.lesson.steps.len());
    let bar = |(index, step): (usize, &giveway_course::lesson::Step)| {
        let class = match index.cmp(&at) {
            std::cmp::Ordering::Less => "did",
            std::cmp::Ordering::Equal => "cur",
            std::cmp::Ordering::Greater => "",
        };
        let onclick = send.reform(move |_: MouseEvent| Msg::Do(Action::Go(index)));
        html! {
            <li {class}><button type="button" title={step.title.clone()} aria-current={(index == at).then_some("step")} {onclick}>
                <span class="vh">{ tr!("Step {n}: {title}", n = index + 1, title = step.title) }</span>
            </button></li>
        }
    };
    html! {
        <div class="lp">
            <span>{ open.lesson.title.clone() }</span>
            <ol aria-label={tr!("Step {step} of {steps}", step = at + 1, steps)}>
                { for open.lesson.steps.iter().enumerate().map(bar) }
            </ol>
            <span class="num">{ tr!("{step} of {steps}", step = at + 1, steps) }</span>
        </div>
    }
}

fn foot(tutor: &Tutor, open: &Open, send: &Callback<Msg>) -> Html {
    let back = send.reform(|_: MouseEvent| Msg::Do(Action::Back));
    // The second press of two is not for the step that has just come.
    let next = once(send, || Msg::Do(Action::Next));
    let has_task = open.step().is_some_and(|step| step.task.is_some());
    // It goes on in any case; where there is something to do, that comes first.
    let is_next = !has_task || open.is_solved() || open.was_solved() || exercise::is_answered(open);
    let class = classes!("btn", if is_next { "primary" } else { "outline" });
    let word = if open.is_last() {
        tr!("a lesson" => "Finish")
    } else {
        tr!("a step" => "Next")
    };
    html! {
        <footer class="foot">
            <button type="button" class="btn outline" disabled={open.index() == 0} data-turn="PageUp" onclick={back}>
                { icon::show("back") }<span>{ tr!("a step" => "Back") }</span>
            </button>
            if open.is_last() { { hand_in("btn outline", open, send) } }
            // A clicker does not end the lesson.
            <button type="button" {class} ref={tutor.next.clone()} data-turn={(!open.is_last()).then_some("PageDown")} onclick={next}><span>{ word }</span></button>
        </footer>
    }
}
