//! The page broke down: what there is gets kept, a person is told, and can load the
//! page again. Nothing here relies on what broke: the sentence is put up by hand.

use std::cell::Cell;
use std::panic::PanicHookInfo;

use giveway_model::tr;
use gloo::events::EventListener;
use gloo::file::{Blob, ObjectUrl};
use js_sys::{Function, Reflect, WebAssembly};
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Element, ErrorEvent};
use yew::set_custom_panic_hook;

use crate::embed::is_embedded;
use crate::keep::{Rescued, rescue};

thread_local! {
    static BROKEN: Cell<bool> = const { Cell::new(false) };
}

/// Whether the page broke down: what it shows must not be kept any more.
pub(crate) fn is_broken() -> bool {
    BROKEN.get()
}

/// Watches for panics, and for what breaks the program off without one: no memory,
/// no stack.
pub fn watch() {
    // Yew would set a hook of its own in the place of any other.
    set_custom_panic_hook(Box::new(|panic: &PanicHookInfo<'_>| {
        tell(&panic.to_string());
    }));
    let window = gloo::utils::window();
    let listening = EventListener::new(&window, "error", |event| {
        let event = event.dyn_ref::<ErrorEvent>();
        let error = event.map(ErrorEvent::error).unwrap_or_default();
        if error.is_instance_of::<WebAssembly::RuntimeError>()
            || error.is_instance_of::<js_sys::RangeError>()
        {
            tell(&String::from(js_sys::Error::from(error).message()));
        }
    });
    // It listens as long as the page is there.
    listening.forget();
}

/// Keeps what there is, then tells; once.
fn tell(message: &str) {
    if BROKEN.replace(true) {
        return;
    }
    // First, so that it is there whatever happens next.
    let said = overlay(message);
    let rescued = rescue();
    if let Ok(said) = said {
        // The page is broken anyway: what cannot be shown is left out.
        let _ = tell_rescue(&said, rescued);
    }
}

/// The places of the overlay that depend on what could be kept.
struct Said {
    sentence: Element,
    buttons: Element,
}

fn overlay(message: &str) -> Result<Said, JsValue> {
    let document = gloo::utils::document();
    let body = document.body().ok_or(JsValue::NULL)?;
    let overlay = element("div", "broke")?;
    overlay.set_attribute("role", "alertdialog")?;
    overlay.set_attribute("aria-modal", "true")?;
    overlay.set_attribute("aria-labelledby", "broke-title")?;
    let card = element("div", "broke-card")?;
    let title = said("h2", "", tr!("Something went wrong in the page."))?;
    title.set_id("broke-title");
    // Should what is done next fail, too.
    let sentence = said("p", "", tr!("Your work up to a moment ago is saved."))?;
    let buttons = element("div", "broke-acts")?;
    let reload = said("button", "btn primary", tr!("Reload the page"))?;
    // The browser's own function: nothing of this program has to run for it.
    let location = gloo::utils::window().location();
    let press: Function = Reflect::get(&location, &"reload".into())?.dyn_into()?;
    reload.add_event_listener_with_callback("click", &press.bind0(&location))?;
    buttons.append_child(&reload)?;
    let details = element("details", "")?;
    details.append_child(&*said("summary", "", tr!("What happened"))?)?;
    details.append_child(&*said("pre", "", message)?)?;
    for part in [&title, &sentence, &buttons, &details] {
        card.append_child(part)?;
    }
    overlay.append_child(&card)?;
    if let Some(page) = document.get_element_by_id("page") {
        page.set_attribute("inert", "")?;
    }
    body.append_child(&overlay)?;
    if let Some(reload) = reload.dyn_ref::<web_sys::HtmlElement>() {
        reload.focus()?;
    }
    Ok(Said { sentence, buttons })
}

fn tell_rescue(said_so: &Said, rescued: Rescued) -> Result<(), JsValue> {
    let sentence = match &rescued {
        _ if is_embedded() => tr!("Load it again to go on."),
        Rescued::Kept => tr!("Your work is saved."),
        Rescued::Nothing => tr!("Nothing of yours was lost."),
        Rescued::Only(_) => {
            tr!("This browser does not keep your work. Download it before you load the page again.")
        }
    };
    said_so.sentence.set_text_content(Some(sentence));
    if let Rescued::Only(text) = rescued {
        let link = said("a", "btn outline", tr!("Download it"))?;
        let url = ObjectUrl::from(Blob::new(text.as_str()));
        link.set_attribute("href", &url)?;
        link.set_attribute("download", "rescued.giveway")?;
        said_so.buttons.append_child(&link)?;
        // The browser reads it when it is pressed.
        std::mem::forget(url);
    }
    Ok(())
}

fn element(name: &str, class: &str) -> Result<Element, JsValue> {
    let element = gloo::utils::document().create_element(name)?;
    if !class.is_empty() {
        element.set_attribute("class", class)?;
    }
    Ok(element)
}

fn said(name: &str, class: &str, text: &str) -> Result<Element, JsValue> {
    let element = element(name, class)?;
    element.set_text_content(Some(text));
    Ok(element)
}
