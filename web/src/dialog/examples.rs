//! The examples that come with the page.

use giveway_page::examples::{Example, read};
use giveway_page::{Action, FileAction, Notice, SolveAction};
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
                let text = files::fetch("index.json").await;
                list.set(Some(text.and_then(|text| read(&text))));
            });
        });
    }
    let choose = {
        let (send, on_close) = (send.clone(), on_close.clone());
        Callback::from(move |file: String| {
            on_close.emit(());
            let send = send.clone();
            spawn_local(async move { open(&file, &send).await });
        })
    };
    let body = match &*list {
        None => html! { <p>{ "Loading\u{2026}" }</p> },
        Some(Err(error)) => html! { <p>{ format!("The list did not arrive: {error}") }</p> },
        Some(Ok(list)) => html! {
            <ul class="picks">
                { for list.iter().map(|example| pick(example, &choose)) }
            </ul>
        },
    };
    html! { <Frame title="Examples" on_close={on_close.clone()}>{ body }</Frame> }
}

fn pick(example: &Example, choose: &Callback<String>) -> Html {
    let file = example.file.clone();
    let choose = choose.reform(move |_| file.clone());
    html! {
        <li key={example.file.clone()}>
            <button class="pick" onclick={choose}>
                <b>{ example.title.clone() }</b>
                <span>{ example.line.clone() }</span>
                { icon::show("chevron") }
            </button>
        </li>
    }
}

async fn open(file: &str, send: &Callback<Action>) {
    match files::example(file).await {
        Ok(scene) => {
            send.emit(Action::File(FileAction::Open(Box::new(scene))));
            send.emit(Action::Solve(SolveAction::Begin));
        }
        Err(error) => send.emit(Action::File(FileAction::Refuse(Notice {
            sentence: "The example did not arrive; the scene stays as it is.".to_owned(),
            details: vec![error],
        }))),
    }
}
