//! Text to the clipboard.

use giveway_model::{tr, tr_data};
use giveway_page::Notice;
use wasm_bindgen_futures::JsFuture;
use yew::platform::spawn_local;

use crate::support;

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
