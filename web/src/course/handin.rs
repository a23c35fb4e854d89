//! Handing in: the column that makes a file or a link of what was done in a lesson.

use giveway_course::handin::{HandIn, Work, answer_words, hand_in, link, write};
use giveway_course::learner::{Action, Open, Progress};
use giveway_course::lesson::Lesson;
use giveway_model::tr;
use gloo::file::Blob;
use web_sys::HtmlInputElement;
use yew::prelude::*;

use super::sight::once;
use super::tutor::{Msg, Tutor};
use crate::{copy, files, icon};

/// What is typed and told while a lesson is handed in.
#[derive(Clone, Default)]
pub(super) struct Handing {
    /// The name of who hands it in.
    name: String,
    /// What became of the file or the link.
    told: String,
}

/// What happens while a lesson is handed in.
#[derive(Clone)]
pub(super) enum HandMsg {
    /// It begins.
    Begin,
    /// The lesson goes on.
    End,
    /// The lesson goes on at a step, from 0.
    Go(usize),
    /// A name is typed.
    Name(String),
    /// The file is saved.
    Save,
    /// The link is copied.
    Copy,
    /// What became of the link.
    Told(String),
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
                self.handing.get_or_insert_default().told.clear();
                self.is_new = true;
            }
            HandMsg::End => {
                self.handing = None;
                self.is_new = true;
            }
            HandMsg::Go(step) => {
                self.handing = None;
                self.is_new = true;
                self.act(ctx, Action::Go(step));
            }
            HandMsg::Name(name) => self.handing.get_or_insert_default().name = name,
            HandMsg::Save => {
                if let Some(made) = self.made() {
                    let name = made.file_name();
                    let text = write(&made);
                    let blob = Blob::new_with_options(text.as_str(), Some("application/json"));
                    files::save_as(&name, blob);
                    let told = tr!("Saved as {name}. Give the file to your lecturer.", name);
                    self.handing.get_or_insert_default().told = told;
                }
            }
            HandMsg::Copy => {
                let letters = self.made().and_then(|made| link::write(&made));
                if let Some(letters) = letters {
                    copy_link(&letters, ctx.link().callback(Msg::Hand));
                }
            }
            HandMsg::Told(told) => self.handing.get_or_insert_default().told = told,
        }
    }

    fn made(&self) -> Option<HandIn> {
        let open = self.learner.open.as_ref()?;
        let handing = self.handing.as_ref()?;
        let progress = &self.learner.progress;
        Some(hand_in(progress, &open.id, &open.lesson, &handing.name))
    }
}

fn copy_link(letters: &str, send: Callback<HandMsg>) {
    let location = gloo::utils::window().location();
    let origin = location.origin().unwrap_or_default();
    let path = location.pathname().unwrap_or_default();
    let text = format!("{origin}{path}#{}{letters}", link::KEY);
    copy::text(tr!("link"), &text, move |done| {
        send.emit(HandMsg::Told(match done {
            Ok(()) => tr!("Link copied. Give it to your lecturer.").to_owned(),
            Err(notice) => {
                let details = notice.details().join(" ");
                format!("{} {details}", notice.sentence())
            }
        }));
    });
}

/// The column, below its way out.
pub(super) fn show(
    tutor: &Tutor,
    handing: &Handing,
    open: &Open,
    progress: &Progress,
    send: &Callback<Msg>,
) -> Html {
    let made = hand_in(progress, &open.id, &open.lesson, &handing.name);
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
                { name(handing, &made, send) }
                <p class="private">
                    { icon::show("lock") }
                    <span><b>{ tr!("Nothing is sent.") }</b>{ " " }{ tr!("The work stays in this browser until you pass it on.") }</span>
                </p>
                { content() }
                { tasks(&made, &open.lesson, send) }
                <p class="quiet">{ tr!("Hand in as often as you like. The latest file counts.") }</p>
            </div>
            { foot(handing, &made, send) }
        </>
    }
}

fn name(handing: &Handing, made: &HandIn, send: &Callback<Msg>) -> Html {
    let oninput = send.reform(|event: InputEvent| {
        let field: HtmlInputElement = event.target_unchecked_into();
        Msg::Hand(HandMsg::Name(field.value()))
    });
    let is_nameless = made.name.is_none();
    html! {
        <label class="field-of">
            <span>{ tr!("Your name, as your lecturer knows you") }</span>
            <input class="field" value={handing.name.clone()} autocomplete="name" {oninput} />
            <small>
                if is_nameless { { tr!("Your lecturer will not know whose it is.") }{ " " } }
                { tr!("The file is called {name}", name = made.file_name()) }
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
                tr!("your last answer to each task, and what you changed on the board"),
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

/// A card for each task, which goes to its step.
fn tasks(made: &HandIn, lesson: &Lesson, send: &Callback<Msg>) -> Html {
    let steps = lesson.steps.iter().enumerate();
    let steps = steps.filter(|(_, step)| step.task.is_some());
    let card = |(n, (index, step)): (usize, (usize, &giveway_course::lesson::Step))| {
        let work = made.work(index);
        let (class, sign, state) = state(work);
        let answer = work.and_then(|work| work.answer.as_ref());
        let answer = answer.map(|answer| answer_words(answer, index, lesson));
        let onclick = once(send, move || Msg::Hand(HandMsg::Go(index)));
        html! {
            <li><button type="button" class="hand-card" {onclick}>
                <b>{ tr!("a task with its number" => "{n} {title}", n = n + 1, title = step.title) }</b>
                <small class={class}>{ icon::show(sign) }{ state }</small>
                if let Some(answer) = answer { <small>{ tr!("Your answer: {answer}", answer) }</small> }
            </button></li>
        }
    };
    html! {
        <section aria-labelledby="lecturer-sees">
            <h3 id="lecturer-sees">{ tr!("What your lecturer sees") }</h3>
            <ol class="hand-cards">{ for steps.enumerate().map(card) }</ol>
        </section>
    }
}

/// Whether a task is taken as solved, as a class, a sign and words.
fn state(work: Option<&Work>) -> (&'static str, &'static str, String) {
    let tries = |work: &Work| tr!("{n} try" | "{n} tries" % work.tries);
    match work {
        Some(work) if work.solved => {
            let tries = tries(work);
            ("sign ok", "check", tr!("solved, {tries}", tries))
        }
        Some(work) if work.answer.is_some() => {
            let tries = tries(work);
            ("sign un", "todo", tr!("not solved, {tries}", tries))
        }
        Some(_) | None => ("sign nil", "minus", tr!("not tried").to_owned()),
    }
}

fn foot(handing: &Handing, made: &HandIn, send: &Callback<Msg>) -> Html {
    let has_link = link::write(made).is_some();
    let save = once(send, || Msg::Hand(HandMsg::Save));
    let copy = once(send, || Msg::Hand(HandMsg::Copy));
    html! {
        <footer class="foot hands">
            <p role="status">
                { handing.told.clone() }
                if handing.told.is_empty() && !has_link { { tr!("The work is too long for a link: save the file.") } }
            </p>
            <button type="button" class="btn primary" onclick={save}>{ icon::show("save") }<span>{ tr!("Save file") }</span></button>
            <button type="button" class="btn outline" disabled={!has_link} onclick={copy}>{ icon::show("link") }<span>{ tr!("Copy link") }</span></button>
        </footer>
    }
}
