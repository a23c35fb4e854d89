//! The editor: steps, the form of the step that is shown, and beside it what the learner
//! sees.

use std::rc::Rc;

use giveway_course::author::{Action, Draft, Field, FormFault, Looked, Part, Whose, form, head};
use giveway_model::tr;
use yew::prelude::*;

use super::super::contents::use_modal;
use super::super::prose::Reader;
use super::super::shelf::Shelf;
use super::super::tutor::Msg;
use super::fields::{Form, rest};
use super::preview::{SmallBoard, prose};
use super::{AuthorMsg, Notes, steps, todo, top};
use crate::board::Film;
use crate::course::author::preview::BoardProps;
use crate::icon;
use crate::part::part;

#[derive(Clone, Properties)]
pub(in crate::course) struct DeskProps {
    /// What is written.
    pub(super) draft: Rc<Draft>,
    /// What it comes to.
    pub(super) looked: Rc<Looked>,
    /// The board of the step.
    pub(super) film: Option<Rc<Film>>,
    /// The terms.
    pub(super) shelf: Rc<Shelf>,
    /// What is told beside it.
    pub(super) notes: Notes,
    /// Takes what is done.
    pub(super) send: Callback<Msg>,
}

impl PartialEq for DeskProps {
    fn eq(&self, other: &Self) -> bool {
        let film = |props: &Self| props.film.as_ref().map(Rc::as_ptr);
        Rc::ptr_eq(&self.draft, &other.draft)
            && Rc::ptr_eq(&self.looked, &other.looked)
            && film(self) == film(other)
            && self.notes == other.notes
            && self.send == other.send
    }
}

/// The editor, over the page; open as long as it is there.
#[component]
pub(in crate::course) fn Desk(props: &DeskProps) -> Html {
    let node = use_node_ref();
    let write = props.send.reform(Msg::Author);
    let close = use_callback(props.send.clone(), |(), send| {
        send.emit(Msg::Author(AuthorMsg::Close));
    });
    use_modal(&node, &close);
    let act = write.reform(AuthorMsg::Act);
    html! {
        <dialog ref={node} class="sheet author" aria-labelledby="author-title">
            <div class="sheet-in">
                { top::show(props, &write) }
                <div class="abody">
                    { steps::list(&props.draft, &props.looked, &props.notes, &act) }
                    <div class="aform">
                        { lesson(props, &act) }
                        { step(props, &act, &write) }
                    </div>
                    { preview(props) }
                </div>
                { todo::list(&props.draft, &props.looked, &props.notes.check, &act) }
                { foot(props, &write) }
            </div>
        </dialog>
    }
}

/// The lesson as a whole.
fn lesson(props: &DeskProps, act: &Callback<Action>) -> Html {
    let fields = head();
    let faults = props.looked.of(None);
    let form = Form {
        whose: Whose::Lesson,
        words: props.draft.words(),
        fields: &fields,
        faults: &faults,
        is_strict: props.notes.is_strict,
        send: act,
    };
    let shown = fields.iter().filter(|field| field.name != "hides-answers");
    html! {
        <section class="apart lede" aria-label={tr!("Lesson")}>{ for shown.map(|field| form.show(field)) }</section>
    }
}

/// The step that is shown.
fn step(props: &DeskProps, act: &Callback<Action>, write: &Callback<AuthorMsg>) -> Html {
    let draft = &props.draft;
    let Some(step) = draft.step() else {
        return html! {};
    };
    let at = draft.at();
    let fields = form(step, draft.scene(at));
    let faults = props.looked.of(Some(at));
    let form = Form {
        whose: Whose::Step,
        words: step.words(),
        fields: &fields,
        faults: &faults,
        is_strict: props.notes.is_strict,
        send: act,
    };
    let part = |part: Part| {
        let own = fields.iter().filter(move |field| field.part == part);
        own.map(|field| form.show(field)).collect::<Html>()
    };
    let asks = !step.word("task.kind").is_empty();
    let has_answers = matches!(step.word("task.kind"), "choose" | "predict");
    let answers = 0..if has_answers { step.answers() } else { 0 };
    // Nothing of one step stays in the fields of another one.
    html! {
        <div class="astep" key={step.key()}>
            { steps::tools(draft, act) }
            <section class="apart" aria-label={tr!("Text")}>
                { part(Part::Text) }
                <p class="quiet">{ tr!("An empty line begins a paragraph. *Words* are stressed; [A1](robot:A1), [here](cell:3,1), [then](time:3) and [makespan](term:makespan) are links.") }</p>
            </section>
            <section class="apart" aria-label={tr!("Board")}>
                <h4>{ tr!("Board") }</h4>
                { board(props, write, &fields, &faults) }
                { part(Part::Board) }
            </section>
            <section class="apart" aria-label={tr!("Task")}>
                <h4>{ tr!("Task") }</h4>
                { part(Part::Task) }
                { rest(&fields, &faults, true) }
                { props.notes.check.beside(at) }
                { for answers.map(|index| answer(index, part(Part::Answer(index)), act)) }
                if has_answers {
                    <button type="button" class="btn outline" onclick={act.reform(|_: MouseEvent| Action::AddAnswer)}>
                        { icon::show("plus") }<span>{ tr!("Add an answer") }</span>
                    </button>
                }
                { part(Part::Tools) }
                if asks { { part(Part::Help) } }
            </section>
        </div>
    }
}

fn answer(index: usize, fields: Html, act: &Callback<Action>) -> Html {
    let number = index + 1;
    let name = tr!("Answer {number}", number);
    let remove = tr!("Remove answer {number}", number);
    let onclick = act.reform(move |_: MouseEvent| Action::RemoveAnswer(index));
    html! {
        <fieldset class="aanswer">
            <legend>{ name }</legend>
            { fields }
            <button type="button" class="btn ghost" {onclick}>{ icon::show("erase") }<span>{ remove }</span></button>
        </fieldset>
    }
}

/// Where the board comes from, and what is wrong with it.
fn board(
    props: &DeskProps,
    write: &Callback<AuthorMsg>,
    fields: &[Field],
    faults: &[FormFault],
) -> Html {
    let draft = &props.draft;
    let take = write.reform(|_: MouseEvent| AuthorMsg::Take);
    let to_page = write.reform(|_: MouseEvent| AuthorMsg::ToPage);
    let drop_it = write.reform(|_: MouseEvent| AuthorMsg::Act(Action::DropBoard));
    let scene = draft.scene(draft.at());
    let own = draft.step().and_then(|step| step.scene());
    let line = match (own, scene) {
        (Some(scene), _) => {
            let name = match &*scene.name {
                "" => tr!("Untitled"),
                name => name,
            };
            let robots = tr!("{n} robot" | "{n} robots" % scene.agents.len());
            format!("{name}: {robots}")
        }
        (None, Some(_)) => tr!("As the step before leaves it.").to_owned(),
        (None, None) => tr!("There is none yet. Take your own, as it is on the page.").to_owned(),
    };
    let is_strict = props.notes.is_strict || scene.is_some();
    html! {
        <>
            <p class="quiet">{ line }</p>
            <div class="arow">
                <button type="button" class="btn outline" onclick={take}>{ icon::show("copy") }<span>{ tr!("Take the board as it is now") }</span></button>
                if scene.is_some() {
                    <button type="button" class="btn ghost" title={tr!("Opens it on the page. Come back by Course, Write your own, and take it.")} onclick={to_page}>
                        { icon::show("edit") }<span>{ tr!("Change it on the page") }</span></button>
                }
                if own.is_some() && draft.at() > 0 {
                    <button type="button" class="btn ghost" onclick={drop_it}><span>{ tr!("As the step before leaves it") }</span></button>
                }
            </div>
            if is_strict { { rest(fields, faults, false) } }
        </>
    }
}

fn preview(props: &DeskProps) -> Html {
    let at = props.draft.at();
    let agents = props.draft.scene(at).map_or(&[][..], |scene| &scene.agents);
    let reader = Reader {
        agents,
        shelf: &props.shelf,
        send: &props.send,
    };
    html! {
        <section class="apreview lesson" aria-label={tr!("As the learner sees it")}>
            <p class="quiet">{ tr!("As the learner sees it") }</p>
            if let Some(film) = &props.film { { part::<SmallBoard>(BoardProps { film: Rc::clone(film) }) } }
            if let Some(step) = props.looked.step(at) { { prose(step, reader) } }
        </section>
    }
}

fn foot(props: &DeskProps, write: &Callback<AuthorMsg>) -> Html {
    let check = &props.notes.check;
    let state = match &*props.notes.told {
        "" if props.looked.faults().is_empty() && !check.has_wrong() => {
            tr!("Ready to share.")
        }
        told => told,
    };
    let state = check.progress().unwrap_or_else(|| state.to_owned());
    let press = |msg: AuthorMsg| write.reform(move |_: MouseEvent| msg.clone());
    let fields = head();
    let act = write.reform(AuthorMsg::Act);
    let form = Form {
        whose: Whose::Lesson,
        words: props.draft.words(),
        fields: &fields,
        faults: &[],
        is_strict: false,
        send: &act,
    };
    let hides = fields.iter().find(|field| field.name == "hides-answers");
    html! {
        <footer class="sf">
            <span class="prog" role="status">{ state }</span>
            <span class="grow"></span>
            if let Some(hides) = hides { { form.show(hides) } }
            <button type="button" class="btn outline" onclick={press(AuthorMsg::Save)}>{ icon::show("save") }<span>{ tr!("Save as a file") }</span></button>
            { check.buttons(write) }
            <button type="button" class="btn primary" onclick={press(AuthorMsg::Try)}>{ icon::show("play") }<span>{ tr!("Try it") }</span></button>
        </footer>
    }
}
