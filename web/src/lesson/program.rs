//! The course's program: begun by a script of its own, which the page adds.

use giveway_model::tr;
use gloo::events::{EventListener, EventListenerOptions};
use wasm_bindgen::JsCast as _;
use web_sys::HtmlScriptElement;

use crate::solver::written;

/// Adds the script that fetches the program and runs it; tells where that fails. No
/// two starts have one number: a browser runs a script of one address only once.
///
/// # Errors
/// Why there is no script, as a sentence.
pub(super) fn start(number: u32, failed: impl FnOnce(String) + 'static) -> Result<(), String> {
    let address = written("giveway-course-start")?;
    let document = gloo::utils::document();
    let script = document.create_element("script");
    let script = script
        .ok()
        .and_then(|script| script.dyn_into::<HtmlScriptElement>().ok())
        .ok_or(tr!("The browser makes no script."))?;
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
