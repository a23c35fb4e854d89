//! What is fetched when it is needed first: begun by a script of its own, which the page
//! adds.

use giveway_model::tr;
use gloo::events::{EventListener, EventListenerOptions};
use wasm_bindgen::JsCast as _;
use web_sys::HtmlScriptElement;

use crate::worker_client::written;

/// Adds the script whose address the page's head has under this name; tells where that
/// fails. A browser runs a script of one address only once: what is to be tried again has
/// another number each time.
///
/// # Errors
/// Why there is no script, as a sentence.
pub(crate) fn start(
    name: &str,
    number: u32,
    failed: impl FnOnce(String) + 'static,
) -> Result<(), String> {
    let address = written(name)?;
    let document = gloo::utils::document();
    let script = document.create_element("script");
    let script = script
        .ok()
        .and_then(|script| script.dyn_into::<HtmlScriptElement>().ok())
        .ok_or(tr!("This part of the page could not be loaded."))?;
    script.set_type("module");
    script.set_src(&format!("{address}#{number}"));
    let options = EventListenerOptions::default();
    let gone = script.clone();
    let said = tr!("{address} did not arrive.", address);
    EventListener::once_with_options(&script, "error", options, move |_| {
        gone.remove();
        failed(said);
    })
    .forget();
    let added = document.head().map(|head| head.append_child(&script));
    match added {
        Some(Ok(_)) => Ok(()),
        _ => Err(tr!("The browser takes no script.").to_owned()),
    }
}
