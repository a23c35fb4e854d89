//! Files dropped onto the page.

use std::rc::Rc;

use giveway_model::tr;
use giveway_page::Action;
use gloo::events::{EventListener, EventListenerOptions};
use wasm_bindgen::JsCast as _;
use web_sys::{DataTransfer, Event};
use yew::prelude::*;

use crate::dialog::Panel;
use crate::files;
use crate::held::{Held, use_held};
use crate::newest::Newest;

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct DropProps {
    /// The state, whose scene or map a file may need.
    pub(crate) newest: Newest,
    /// Takes the scene.
    pub(crate) send: Callback<Action>,
    /// Opens the question that some files ask.
    pub(crate) show: Callback<Panel>,
}

/// Takes files dropped anywhere; seen only while some are held over the page.
#[component]
pub(crate) fn Drop(props: &DropProps) -> Html {
    let over = use_state_eq(|| false);
    let latest = use_held(|| props.clone());
    latest.set(props.clone());
    {
        let over = over.clone();
        use_effect_with((), move |()| {
            let listening = listen(latest, move |held| over.set(held));
            move || drop(listening)
        });
    }
    html! {
        if *over { <div class="drop" aria-hidden="true">{ tr!("Drop to open") }</div> }
    }
}

/// What is done with files that are over the page.
type Handle = Box<dyn Fn(&Event, DataTransfer)>;

fn listen(
    latest: Rc<Held<DropProps>>,
    set_over: impl Fn(bool) + Clone + 'static,
) -> [EventListener; 3] {
    let window = gloo::utils::window();
    let on = |kind, handle: Handle| {
        let options = EventListenerOptions::enable_prevent_default();
        EventListener::new_with_options(&window, kind, options, move |event| {
            let data = event.dyn_ref().and_then(web_sys::DragEvent::data_transfer);
            if let Some(data) = data.filter(holds_files) {
                handle(event, data);
            }
        })
    };
    let (held, gone) = (set_over.clone(), set_over.clone());
    [
        on(
            "dragover",
            Box::new(move |event, _| {
                event.prevent_default();
                held(true);
            }),
        ),
        on(
            "dragleave",
            Box::new(move |event, _| {
                // From one element to the next it stays over the page.
                let to = event.dyn_ref().and_then(MouseEvent::related_target);
                gone(to.is_some());
            }),
        ),
        on(
            "drop",
            Box::new(move |event, data| {
                event.prevent_default();
                set_over(false);
                let props = latest.get();
                files::open(&props.newest.get(), data.files(), props.send, props.show);
            }),
        ),
    ]
}

fn holds_files(data: &DataTransfer) -> bool {
    data.types().includes(&"Files".into(), 0)
}
