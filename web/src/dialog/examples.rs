//! The examples that come with the page.

use giveway_model::tr;
use giveway_page::examples::{Example, read};
use giveway_page::{Action, FileAction, SolveAction};
use yew::platform::spawn_local;
use yew::prelude::*;

use super::frame::Frame;
use crate::{files, icon};

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct ExamplesProps {
    /// Takes the scene that was chosen.
    pub(crate) send: Callback<Action>,
    /// Called when it was closed.
    pub(crate) on_close: Callback<()>,
}

/// The list, and why there is none.
type List = Option<Result<Vec<Example>, String>>;

/// A list of examples; the one that is chosen is opened and solved.
#[component]
pub(crate) fn Examples(props: &ExamplesProps) -> Html {
    let ExamplesProps { send, on_close } = props;
    let list = use_state(|| List::None);
    {
        let list = list.clone();
        use_effect_with((), move |()| {
            spawn_local(async move {
                let text = files::fetch("examples.txt").await;
                list.set(Some(text.and_then(|text| read(&text))));
            });
        });
    }
    let choose = {
        let (send, on_close) = (send.clone(), on_close.clone());
        Callback::from(move |example: Example| {
            on_close.emit(());
            open(&example, &send);
        })
    };
    let body = match &*list {
        None => html! { <p>{ tr!("Loading\u{2026}") }</p> },
        Some(Err(error)) => html! { <p>{ tr!("The list did not arrive: {error}", error) }</p> },
        Some(Ok(list)) => html! {
            <>
                { for list.chunk_by(|one, next| one.group == next.group).map(|group| section(group, &choose)) }
            </>
        },
    };
    html! { <Frame title={tr!("Examples")} on_close={on_close.clone()}>{ body }</Frame> }
}

/// The examples of one group below its heading.
fn section(group: &[Example], choose: &Callback<Example>) -> Html {
    let heading = group.first().map_or("", |example| &example.group);
    html! {
        <>
            if !heading.is_empty() {
                <h3>{ heading }</h3>
            }
            <ul class="picks">
                { for group.iter().map(|example| pick(example, choose)) }
            </ul>
        </>
    }
}

fn pick(example: &Example, choose: &Callback<Example>) -> Html {
    let chosen = example.clone();
    let choose = choose.reform(move |_| chosen.clone());
    html! {
        <li key={example.title.clone()}>
            <button class="pick" onclick={choose}>
                <b>{ example.title.clone() }</b>
                <span>{ example.line.clone() }</span>
                { icon::show("chevron") }
            </button>
        </li>
    }
}

fn open(example: &Example, send: &Callback<Action>) {
    match example.scene() {
        Ok(scene) => {
            send.emit(Action::File(FileAction::Open(Box::new(scene))));
            send.emit(Action::Solve(SolveAction::Begin));
        }
        Err(notice) => send.emit(Action::File(FileAction::Tell(notice))),
    }
}
