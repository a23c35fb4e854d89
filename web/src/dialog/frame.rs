//! A dialog: the browser's own, so that focus stays inside and comes back
//! afterwards, and Escape closes it.

use giveway_model::tr;
use gloo::events::EventListener;
use web_sys::{HtmlDialogElement, HtmlElement};
use yew::prelude::*;

use crate::icon;

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct FrameProps {
    /// The title, which is its name.
    pub(crate) title: AttrValue,
    /// Whether it holds little.
    #[prop_or_default]
    pub(crate) narrow: bool,
    /// Whether nothing in it takes the focus: then keys must be able to scroll it.
    #[prop_or_default]
    pub(crate) reads: bool,
    /// Called when it was closed.
    pub(crate) on_close: Callback<()>,
    /// What is in it.
    pub(crate) children: Html,
}

/// The frame of a dialog; open as long as it is there.
#[component]
pub(crate) fn Frame(props: &FrameProps) -> Html {
    let FrameProps {
        title,
        narrow,
        reads,
        on_close,
        children,
    } = props;
    let node = use_node_ref();
    let body = use_node_ref();
    {
        let (node, on_close) = (node.clone(), on_close.clone());
        let read = reads.then(|| body.clone());
        use_effect_with((), move |()| {
            let dialog = node.cast::<HtmlDialogElement>();
            let listening = dialog.as_ref().map(|dialog| {
                // It can only fail for a dialog that is open or not on the page.
                let _ = dialog.show_modal();
                // Keys scroll it at once.
                if let Some(body) = read.and_then(|body| body.cast::<HtmlElement>()) {
                    let _ = body.focus();
                }
                EventListener::new(dialog, "close", move |_| on_close.emit(()))
            });
            move || {
                drop(listening);
                if let Some(dialog) = dialog {
                    dialog.close();
                }
            }
        });
    }
    let close = on_close.reform(|_: MouseEvent| ());
    // A press on the dialog itself, and not in it, is one beside it.
    let beside = {
        let (node, on_close) = (node.clone(), on_close.clone());
        Callback::from(move |event: MouseEvent| {
            if event.target() == node.get().map(Into::into) {
                on_close.emit(());
            }
        })
    };
    html! {
        <dialog ref={node} class={classes!("dialog", narrow.then_some("narrow"))}
            aria-labelledby="dialog-title" onmousedown={beside}>
            <header>
                <h2 id="dialog-title">{ title }</h2>
                <button class="btn ghost round" title={tr!("Close (Escape)")} onclick={close}>
                    { icon::show("cancel") }<span class="vh">{ tr!("Close") }</span>
                </button>
            </header>
            <div class="dialog-body" ref={body} tabindex={reads.then_some("0")} role={reads.then_some("group")}
                aria-labelledby={reads.then_some("dialog-title")}>{ children.clone() }</div>
        </dialog>
    }
}
