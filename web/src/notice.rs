//! What a person must be told: it stays until it is dismissed.

use giveway_model::tr;
use giveway_page::{Action, Notice, NoticeKind, ViewAction};
use yew::prelude::*;

use crate::icon;

/// The notice, over the page, so that nothing moves when it comes or goes.
pub(crate) fn show(notice: Option<&Notice>, send: &Callback<Action>) -> Html {
    // The regions are there before their text: some readers hear it only so.
    let region = |kind: NoticeKind| {
        let notice = notice.filter(|notice| notice.kind == kind);
        html! { <div role={kind.role()}>{ for notice.map(|notice| card(notice, send)) }</div> }
    };
    html! {
        <div class="notices">
            { region(NoticeKind::Information) }
            { region(NoticeKind::Refusal) }
        </div>
    }
}

fn card(notice: &Notice, send: &Callback<Action>) -> Html {
    let dismiss = send.reform(|_: MouseEvent| Action::View(ViewAction::DismissNotice));
    html! {
        <div class={classes!("notice", notice.kind.class())}>
            { icon::show(notice.kind.icon()) }
            <div>
                <b>{ notice.sentence() }</b>
                <ul>{ for notice.details().iter().map(|line| html! { <li>{ said(line) }</li> }) }</ul>
            </div>
            <button class="btn ghost round" title={tr!("Dismiss (Escape)")} onclick={dismiss}>
                { icon::show("cancel") }<span class="vh">{ tr!("Dismiss") }</span>
            </button>
        </div>
    }
}

/// A line; an address is a link.
fn said(line: &str) -> Html {
    if line.starts_with("https://") || line.starts_with("http://") {
        html! { <a href={line.to_owned()} target="_blank" rel="noopener">{ line }</a> }
    } else {
        html! { { line } }
    }
}
