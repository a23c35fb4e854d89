//! What a person must be told: it stays until it is dismissed.

use giveway_page::{Action, Notice};
use yew::prelude::*;

use crate::Icon;

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct NoticesProps {
    /// What is told, if there is something.
    pub(crate) notice: Option<Notice>,
    /// Takes the dismissal.
    pub(crate) send: Callback<Action>,
}

/// The notice, over the page, so that nothing moves when it comes or goes.
#[component]
pub(crate) fn Notices(props: &NoticesProps) -> Html {
    let dismiss = props.send.reform(|_: MouseEvent| Action::DismissNotice);
    // The region is there before its text: some readers hear it only so.
    html! {
        <div role="alert">
            if let Some(notice) = &props.notice {
                <div class="notice">
                    <Icon name="warning" />
                    <div>
                        <b>{ notice.sentence.clone() }</b>
                        <ul>{ for notice.details.iter().map(|line| html! { <li>{ line }</li> }) }</ul>
                    </div>
                    <button class="btn ghost round" title="Dismiss (Escape)" onclick={dismiss}>
                        <Icon name="cancel" /><span class="vh">{ "Dismiss" }</span>
                    </button>
                </div>
            }
        </div>
    }
}
