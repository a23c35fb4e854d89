//! Handing in: the column that makes a file or a link of what was done in a lesson.

use std::rc::Rc;

use giveway_course::handin::{
    Card, CardState, Form, FormAction, FormEffect, HandIn, Subject, cards, summary,
};
use giveway_course::learner::{Action, Open};
use giveway_course::lesson::Picture;
use giveway_model::tr;
use gloo::file::Blob;
use web_sys::HtmlInputElement;
use yew::prelude::*;

use super::sight::once;
use super::tutor::{Msg, Tutor};
use crate::board::{Film, Thumb, ThumbProps};
use crate::part::part;
use crate::{copy, files, icon};

/// What happens while a lesson is handed in.
#[derive(Clone)]
pub(super) enum HandMsg {
    /// It begins.
    Begin,
    /// The lesson goes on.
    End,
    /// The lesson goes on at a step, from 0.
    Go(usize),
    /// Something is done in the form.
    Form(FormAction),
    /// Why the link was not copied.
    Refused(String),
}

/// The form that is open.
#[derive(Clone, Default)]
pub(super) struct Handing {
    form: Form,
    /// Why the link was not copied.
    refused: String,
}

impl Handing {
    /// A form that begins with a name.
    fn of(name: &str) -> Self {
        let mut handing = Self::default();
        name.clone_into(&mut handing.form.name);
        handing
    }
}

/// Whether a lesson can be handed in: it has tasks, and is not one that is being written.
pub(super) fn can_begin(open: &Open) -> bool {
    !open.is_tried() && open.lesson.steps.iter().any(|step| step.task.is_some())
}

impl Tutor {
    /// What happens while a lesson is handed in.
    pub(super) fn hand(&mut self, ctx: &Context<Self>, msg: HandMsg) {
        match msg {
            HandMsg::Begin => {
                self.handing = Some(Handing::of(&self.hand_name));
                self.is_new = true;
            }
            HandMsg::End => {
                self.put_away();
                self.is_new = true;
            }
            HandMsg::Go(step) => {
                self.put_away();
                self.is_new = true;
                self.act(ctx, Action::Go(step));
            }
            HandMsg::Form(action) => self.fill_in(ctx, action),
            HandMsg::Refused(why) => {
                if let Some(handing) = &mut self.handing {
                    (handing.form.done, handing.refused) = (None, why);
                }
            }
        }
    }

    /// The form is closed; the name is there again in the next one.
    pub(super) fn put_away(&mut self) {
        if let Some(handing) = self.handing.take() {
            self.hand_name = handing.form.name;
        }
    }

    fn fill_in(&mut self, ctx: &Context<Self>, action: FormAction) {
        let (Some(open), Some(handing)) = (&self.learner.open, self.handing.take()) else {
            return;
        };
        let of = subject(self, open);
        let (form, effect) = handing.form.reduce(action, of);
        self.handing = Some(Handing {
            form,
            refused: String::new(),
        });
        match effect {
            Some(FormEffect::Save { name, text }) => {
                let blob = Blob::new_with_options(text.as_str(), Some("application/json"));
                files::save_as(&name, blob);
            }
            Some(FormEffect::Copy(letters)) => copy_link(&letters, ctx.link().callback(Msg::Hand)),
            None => {}
        }
    }
}

fn subject<'a>(tutor: &'a Tutor, open: &'a Open) -> Subject<'a> {
    Subject {
        progress: &tutor.learner.progress,
        id: &open.id,
        lesson: &open.lesson,
    }
}

fn copy_link(letters: &str, send: Callback<HandMsg>) {
    let location = gloo::utils::window().location();
    let origin = location.origin().unwrap_or_default();
    let path = location.pathname().unwrap_or_default();
    let text = format!("{origin}{path}#{letters}");
    copy::text(tr!("link"), &text, move |done| {
        if let Err(notice) = done {
            let details = notice.details().join(" ");
            send.emit(HandMsg::Refused(format!("{} {details}", notice.sentence())));
        }
    });
}

/// The column.
pub(super) fn show(tutor: &Tutor, handing: &Handing, open: &Open, send: &Callback<Msg>) -> Html {
    let of = subject(tutor, open);
    let made = handing.form.made(of);
    let cards = cards(&made, &open.lesson);
    html! {
        <>
            <div class="scroll" key="hand-in">
                <header class="qh">
                    <div class="lrow">
                        <button type="button" class="crumb" onclick={send.reform(|_: MouseEvent| Msg::Hand(HandMsg::End))}>
                            { icon::show("back") }{ open.lesson.title.clone() }
                        </button>
                    </div>
                    <h2 tabindex="-1" ref={tutor.title.clone()}>{ tr!("Hand in your work") }</h2>
                    <p class="lead">{ tr!("Save a file or copy a link, and give it to your lecturer yourself.") }</p>
                </header>
                { name(handing, &made, handing.form.name_hint(of), send) }
                <p class="private">
                    { icon::show("lock") }
                    <span><b>{ tr!("Nothing is sent.") }</b>{ " " }{ tr!("The work stays in this browser until you pass it on.") }</span>
                </p>
                { content() }
                <section aria-labelledby="lecturer-sees">
                    <h3 id="lecturer-sees">{ tr!("What your lecturer sees") }</h3>
                    <p class="quiet">{ summary(&cards) }</p>
                    <ol class="hand-cards">{ for cards.iter().map(|card| self::card(card, send)) }</ol>
                </section>
                <p class="quiet">{ tr!("Hand in as often as you like. The latest file counts.") }</p>
            </div>
            { foot(handing, of, send) }
        </>
    }
}

fn name(handing: &Handing, made: &HandIn, hint: Option<String>, send: &Callback<Msg>) -> Html {
    let oninput = send.reform(|event: InputEvent| {
        let field: HtmlInputElement = event.target_unchecked_into();
        Msg::Hand(HandMsg::Form(FormAction::Name(field.value())))
    });
    html! {
        <label class="field-of">
            <span>{ tr!("Your name, as your lecturer knows you") }</span>
            <input class="field" value={handing.form.name.clone()} autocomplete="name" {oninput} />
            <small>
                if let Some(hint) = hint { { hint }{ " " } }
                { tr!("The file is called {name}.", name = made.file_name()) }
            </small>
        </label>
    }
}

/// What is in the file, and what is not.
fn content() -> Html {
    let list = |title: &'static str, icon: &'static str, items: [&'static str; 3]| {
        html! {
            <div>
                <h3>{ title }</h3>
                <ul>{ for items.into_iter().map(|item| html! { <li>{ icon::show(icon) }<span>{ item }</span></li> }) }</ul>
            </div>
        }
    };
    html! {
        <section class="in-out" aria-label={tr!("What is in the file")}>
            { list(tr!("In the file"), "check", [
                tr!("your name and the lesson"),
                tr!("your first and last answer to each question, and what you last did on the board"),
                tr!("how often you tried"),
            ]) }
            { list(tr!("Not in it"), "cancel", [
                tr!("hints you asked for"),
                tr!("how long you took"),
                tr!("your own scenes"),
            ]) }
        </section>
    }
}

/// The small board of what was done.
fn film(card: &Card) -> Option<Rc<Film>> {
    let shown = card.shown.as_ref()?;
    Film::of(&Picture {
        scene: shown.scene.clone(),
        plan: shown.plan.clone(),
        time: 0,
    })
}

/// A card for a task, which goes to its step.
fn card(card: &Card, send: &Callback<Msg>) -> Html {
    let (class, sign) = match card.state {
        CardState::Solved => ("sign ok", "check"),
        CardState::NotSolved => ("sign un", "todo"),
        CardState::NotTried => ("sign nil", "minus"),
    };
    let step = card.step;
    let onclick = once(send, move || Msg::Hand(HandMsg::Go(step)));
    html! {
        <li><button type="button" class="hand-card" {onclick}>
            if let Some(film) = film(card) {
                <span class="thumb2">{ part::<Thumb>(ThumbProps { film, plays: false }) }</span>
            }
            <b>{ card.number }{ " " }{ card.title.clone() }</b>
            <small {class}>{ icon::show(sign) }{ card.state_words() }</small>
            if !card.first.is_empty() { <small>{ tr!("First answer: {answer}", answer = card.first) }</small> }
            if !card.answer.is_empty() { <small>{ tr!("Your answer: {answer}", answer = card.answer) }</small> }
        </button></li>
    }
}

fn foot(handing: &Handing, of: Subject<'_>, send: &Callback<Msg>) -> Html {
    let no_link = handing.form.no_link(of);
    let press = |action: fn() -> FormAction| once(send, move || Msg::Hand(HandMsg::Form(action())));
    let said = handing.form.done_words().or(no_link).unwrap_or_default();
    html! {
        <footer class="foot hands">
            <p role="status">{ said }{ handing.refused.clone() }</p>
            <button type="button" class="btn primary" onclick={press(|| FormAction::Save)}>{ icon::show("save") }<span>{ tr!("Save file") }</span></button>
            <button type="button" class="btn outline" disabled={no_link.is_some()} onclick={press(|| FormAction::Copy)}>{ icon::show("link") }<span>{ tr!("Copy link") }</span></button>
        </footer>
    }
}
