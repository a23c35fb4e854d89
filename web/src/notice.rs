//! What a person must be told: it stays until it is dismissed.

use giveway_model::tr;
use giveway_page::{Action, Notice, ViewAction};
use yew::prelude::*;

use crate::icon;

/// The notice, over the page, so that nothing moves when it comes or goes.
pub(crate) fn show(notice: Option<&Notice>, send: &Callback<Action>) -> Html {
    let dismiss = send.reform(|_: MouseEvent| Action::View(ViewAction::DismissNotice));
    // The region is there before its text: some readers hear it only so.
    html! {
        <div role="alert">
            if let Some(notice) = notice {
                <div class="notice">
                    { icon::show("warning") }
                    <div>
                        <b>{ notice.sentence.clone() }</b>
                        <ul>{ for notice.details.iter().map(|line| html! { <li>{ line }</li> }) }</ul>
                    </div>
                    <button class="btn ghost round" title={tr!("Dismiss (Escape)")} onclick={dismiss}>
                        { icon::show("cancel") }<span class="vh">{ tr!("Dismiss") }</span>
                    </button>
                </div>
            }
        </div>
    }
}
