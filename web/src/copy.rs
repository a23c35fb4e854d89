//! Text to the clipboard.

use giveway_model::{tr, tr_data};
use giveway_page::{Action, FileAction, Notice};
use wasm_bindgen_futures::JsFuture;
use yew::Callback;
use yew::platform::spawn_local;

use crate::support;

/// Puts a table into the clipboard, and tells how that went.
pub(crate) fn table(rows: &str, send: &Callback<Action>) {
    let send = send.clone();
    text(tr!("table"), rows, move |done| {
        let notice = match done {
            Ok(()) => Notice::information(tr_data!("Table copied.")),
            Err(notice) => notice,
        };
        send.emit(Action::File(FileAction::Tell(notice)));
    });
}

/// Puts a text into the clipboard, then tells how that went; `what` is in the
/// sentence where it did not go well.
pub(crate) fn text(
    what: &'static str,
    text: &str,
    done: impl FnOnce(Result<(), Notice>) + 'static,
) {
    let refused = move |why: &str| {
        Notice::refusal(tr_data!("The {what} could not be copied.", what)).with([why.to_owned()])
    };
    let Some(clipboard) = support::clipboard("writeText") else {
        done(Err(refused(tr!(
            "A page may write to the clipboard only over https or on this machine."
        ))));
        return;
    };
    let written = clipboard.write_text(text);
    spawn_local(async move {
        let written = JsFuture::from(written).await;
        done(written.map(|_| ()).map_err(|_| {
            refused(tr!(
                "The browser did not let the page write to the clipboard."
            ))
        }));
    });
}
