//! The table of a class, over the page: who handed in, and what each task is worth.

use giveway_course::grade::{
    Came, Chosen, Claim, Given, Graded, Judgement, LookAction, Order, Row,
};
use giveway_model::tr;
use web_sys::wasm_bindgen::JsCast;
use web_sys::{ClipboardEvent, Element, HtmlElement};
use yew::prelude::*;

use super::{ClassMsg, Collected, keys, side};
use crate::course::contents::use_modal;
use crate::course::sight::{is_again, once};
use crate::course::tutor::Msg;
use crate::icon;

#[derive(Clone, Properties)]
pub(in crate::course) struct ClassProps {
    /// The dialog's content, and its number: it changes with all that is shown.
    pub(in crate::course) content: Html,
    pub(in crate::course) version: (u32, String),
    pub(in crate::course) send: Callback<Msg>,
}

impl PartialEq for ClassProps {
    fn eq(&self, other: &Self) -> bool {
        self.version == other.version && self.send == other.send
    }
}

/// The table; open as long as it is there.
#[component]
pub(in crate::course) fn ClassTable(props: &ClassProps) -> Html {
    let node = use_node_ref();
    let close = use_callback(props.send.clone(), |(), send| {
        send.emit(Msg::Class(ClassMsg::Close));
    });
    use_modal(&node, &close);
    {
        // Back from a student's work, one goes on from the cell.
        let node = node.clone();
        use_effect_with((), move |()| {
            let dialog = node.cast::<Element>();
            let cell = dialog.and_then(|dialog| dialog.query_selector(".cl.sel button").ok()?);
            if let Some(Ok(cell)) = cell.map(JsCast::dyn_into::<HtmlElement>) {
                // It fails only where the browser lets nothing be focused.
                let _ = cell.focus();
            }
        });
    }
    let beside = {
        let (node, close) = (node.clone(), close.clone());
        move |event: MouseEvent| {
            if !is_again(&event) && event.target() == node.get().map(Into::into) {
                close.emit(());
            }
        }
    };
    let send = props.send.clone();
    let onkeydown = move |event: KeyboardEvent| keys::pressed(&event, &send);
    let send = props.send.clone();
    let onpaste = move |event: Event| {
        let data = event.dyn_ref().and_then(ClipboardEvent::clipboard_data);
        let text = data.and_then(|data| data.get_data("text").ok());
        let files = Came::all(&text.unwrap_or_default());
        if !files.is_empty() {
            event.prevent_default();
            event.stop_propagation();
            send.emit(Msg::Class(ClassMsg::Came(files)));
        }
    };
    html! {
        <dialog ref={node} class="sheet class" aria-labelledby="class-title" onmousedown={beside} {onkeydown} {onpaste}>
            { props.content.clone() }
        </dialog>
    }
}

impl Collected {
    /// What tells one content of the table from another.
    pub(in crate::course) const fn version(&self) -> u32 {
        self.version
    }

    /// What is in the table's dialog.
    pub(in crate::course) fn content(&self, send: &Callback<Msg>) -> Html {
        let has_files = !self.class.files().is_empty();
        html! {
            <div class="sheet-in">
                { self.head(send) }
                if has_files {
                    <div class="sbody class-body">
                        <div class="class-main">
                            { self.above(send) }
                            { self.table(send) }
                        </div>
                        { side::show(self) }
                    </div>
                } else {
                    <div class="sbody"><div class="class-none">
                        <p>{ tr!("Drop the files of your class anywhere on this page, or choose them here. Links can be pasted, one a line.") }</p>
                        <p>{ tr!("Files of one student's name: the latest counts. Lessons of your own are dropped along with the files.") }</p>
                    </div></div>
                }
                { self.foot(send) }
            </div>
        }
    }

    fn head(&self, send: &Callback<Msg>) -> Html {
        let count = self
            .class
            .rows(self.looking.lesson, self.looking.order)
            .len();
        let close = once(send, || Msg::Class(ClassMsg::Close));
        html! {
            <header class="sh">
                <div>
                    <h2 id="class-title">
                        if self.class.files().is_empty() { { tr!("Hand-ins of a class") } }
                        else { { tr!("{n} hand-in" | "{n} hand-ins" % count) } }
                        if let Some(given) = self.class.lessons().get(self.looking.lesson) { { ": " }{ given.lesson.title.clone() } }
                    </h2>
                    <p>
                        { tr!("What a file claims is not believed: every answer is judged again here. A name cannot be checked.") }{ " " }
                        { tr!("Nothing of it is kept when the page is closed: save the table.") }
                    </p>
                </div>
                <span class="grow"></span>
                <button type="button" class="btn ghost round" title={tr!("Close (Escape)")} onclick={close}>
                    { icon::show("cancel") }<span class="vh">{ tr!("Close") }</span>
                </button>
            </header>
        }
    }

    /// The lessons, where there are several, and the order of the rows.
    fn above(&self, send: &Callback<Msg>) -> Html {
        let tables = self.class.tables();
        let shown = self.looking.lesson;
        let tab = |lesson: usize| {
            let title = self
                .class
                .lessons()
                .get(lesson)
                .map(|it| it.lesson.title.clone());
            let press = once(send, move || {
                Msg::Class(ClassMsg::Look(LookAction::Lesson(lesson)))
            });
            html! { <button type="button" aria-pressed={(lesson == shown).to_string()} onclick={press}>{ title }</button> }
        };
        let order = |order: Order, words: &'static str| {
            let press = once(send, move || {
                Msg::Class(ClassMsg::Look(LookAction::Order(order)))
            });
            html! { <button type="button" aria-pressed={(order == self.looking.order).to_string()} onclick={press}>{ words }</button> }
        };
        html! {
            <div class="class-above">
                if tables.len() > 1 {
                    <div class="seg" role="group" aria-label={tr!("Lesson")}>{ for tables.iter().copied().map(tab) }</div>
                }
                <span class="quiet">{ tr!("A number is how often they tried. Press a cell to see the work.") }</span>
                <span class="grow"></span>
                <div class="seg" role="group" aria-label={tr!("In which order the rows stand")}>
                    { order(Order::LookAtFirst, tr!("Look at first")) }
                    { order(Order::Name, tr!("Name")) }
                </div>
            </div>
        }
    }

    fn table(&self, send: &Callback<Msg>) -> Html {
        let Some(given) = self.class.lessons().get(self.looking.lesson) else {
            return html! {};
        };
        let rows = self.class.rows(self.looking.lesson, self.looking.order);
        let title = |step: usize| html! { <th scope="col">{ given.task_words(step) }</th> };
        html! {
            <div class="class-rows"><table class="ktab">
                <thead><tr>
                    <th scope="col">{ tr!("Who") }</th>
                    { for given.tasks().map(title) }
                    <th scope="col" class="r">{ tr!("Solved") }</th>
                </tr></thead>
                <tbody>{ for rows.iter().enumerate().map(|(at, row)| self.row(at, row, given, send)) }</tbody>
            </table></div>
        }
    }

    fn row(&self, at: usize, row: &Row<'_>, given: &Given, send: &Callback<Msg>) -> Html {
        let file = row.place();
        let cells = row.tasks().iter().enumerate();
        // What a file says of a step without a task has no column.
        let count = given.tasks().count();
        let cells = cells.take(count);
        let cell = |(task, graded): (usize, &Graded)| {
            let step = graded.step;
            let chosen = Some(Chosen { file, step });
            let press = once(send, move || {
                Msg::Class(ClassMsg::Look(LookAction::Choose(chosen)))
            });
            let (class, sign, words) = state(graded);
            let is_chosen = self.looking.chosen == chosen;
            let label = match graded.tries() {
                0 => words.to_owned(),
                n => tr!("{words}, {n} try" | "{words}, {n} tries" % n, words),
            };
            let tries = graded.tries();
            html! {
                <td class={classes!("cl", class, is_chosen.then_some("sel"))}>
                    <button type="button" data-at={format!("{at}.{task}")} aria-label={label} onclick={press}>
                        { icon::show(sign) }if tries > 0 { <span>{ tries }</span> }
                    </button>
                </td>
            }
        };
        let files = row.files().len();
        html! {
            <tr key={file} class={classes!(self.looking.chosen.is_some_and(|it| it.file == file).then_some("cur"))}>
                <th scope="row">
                    <bdi>{ row.title().to_owned() }</bdi>
                    if files > 1 { <small>{ tr!("the latest of {n} files", n = files) }</small> }
                </th>
                { for cells.map(cell) }
                <td class="r">{ tr!("{n} of {all}", n = row.solved(), all = count) }</td>
            </tr>
        }
    }
}

/// What a task is worth: a class, a sign, and words.
pub(super) fn state(graded: &Graded) -> (&'static str, &'static str, &'static str) {
    if graded.claim() == Claim::False {
        return ("lie", "warning", tr!("says solved, is not"));
    }
    match graded.judgement() {
        Some(judgement @ Judgement::Solved(_)) => ("ok", "check", judgement.word()),
        Some(judgement @ Judgement::NotSolved(_)) => ("un", "todo", judgement.word()),
        Some(judgement @ Judgement::NotTried) => ("nil", "minus", judgement.word()),
        Some(judgement @ Judgement::Undecided(_)) => ("open", "search", judgement.word()),
        None => ("wait", "clock", tr!("not judged yet")),
    }
}
