//! The button in the contents that turns the page to another language: the contents lie
//! over the top bar, which has one, too.

use std::cell::Cell;
use std::rc::Rc;

use web_sys::HtmlDialogElement;
use yew::prelude::*;

use super::sight::focus;
use super::tutor::Msg;
use crate::language::button;

/// The button that turns to the next language. The page moves the course when it turns,
/// which takes the dialog from above the page: it is opened there again.
#[hook]
pub(super) fn use_language_button(node: &NodeRef, spoken: &str, send: &Callback<Msg>) -> Html {
    let tongue = use_node_ref();
    let pressed = use_memo((), |()| Cell::new(false));
    {
        let (node, tongue, pressed) = (node.clone(), tongue.clone(), Rc::clone(&pressed));
        use_effect_with(spoken.to_owned(), move |_| {
            if let Some(dialog) = node.cast::<HtmlDialogElement>()
                && dialog.matches(":modal") == Ok(false)
            {
                // Both work on a dialog that is on the page and not open.
                let _ = dialog.remove_attribute("open");
                let _ = dialog.show_modal();
            }
            if pressed.take() {
                focus(&tongue);
            }
        });
    }
    let choose = send.reform(move |tag| {
        pressed.set(true);
        Msg::Speak(tag)
    });
    button(spoken, "btn ghost round tongue", tongue, choose)
}
