//! Light or dark: an attribute of the root, which the style sheets read.

use giveway_page::form::LOOKS;
use giveway_page::{Colours, Theme};
use wasm_bindgen::JsCast as _;
use web_sys::HtmlElement;
use yew::prelude::*;

/// Gives the page its colours; without an attribute the system decides.
#[hook]
pub(crate) fn use_theme(theme: Theme) {
    use_effect_with(theme, |theme| {
        let Some(root) = gloo::utils::document().document_element() else {
            return;
        };
        // Neither can fail: the name of the attribute is valid.
        let _ = match theme {
            Theme::System => root.remove_attribute("data-theme"),
            Theme::Light => root.set_attribute("data-theme", "light"),
            Theme::Dark => root.set_attribute("data-theme", "dark"),
        };
    });
}

/// Gives agents the colours that a person chose for them: properties of the root,
/// which the style sheet takes before those of the design.
#[hook]
pub(crate) fn use_colours(colours: Colours) {
    use_effect_with(colours, |colours| {
        let root = gloo::utils::document().document_element();
        let Some(root) = root.and_then(|root| root.dyn_into::<HtmlElement>().ok()) else {
            return;
        };
        for look in 0..LOOKS {
            let (own, colour) = (look + 1, colours.of(look) + 1);
            for part in ["", "-on"] {
                let name = format!("--own-{own}{part}");
                // Neither can fail: names and values are valid.
                let _ = if own == colour {
                    root.style().remove_property(&name).map(drop)
                } else {
                    root.style()
                        .set_property(&name, &format!("var(--agent-{colour}{part})"))
                };
            }
        }
    });
}

/// What a picture has of a theme: light or dark.
pub(crate) fn drawn(theme: Theme) -> giveway_page::DrawnTheme {
    let is_dark = match theme {
        Theme::System => system_is_dark(),
        Theme::Light => false,
        Theme::Dark => true,
    };
    if is_dark {
        giveway_page::DrawnTheme::Dark
    } else {
        giveway_page::DrawnTheme::Light
    }
}

/// Whether the system is dark now.
pub(crate) fn system_is_dark() -> bool {
    matches("(prefers-color-scheme: dark)")
}

/// Whether a person asked the system for less motion.
pub(crate) fn wants_less_motion() -> bool {
    matches("(prefers-reduced-motion: reduce)")
}

fn matches(query: &str) -> bool {
    let query = gloo::utils::window().match_media(query);
    query.ok().flatten().is_some_and(|query| query.matches())
}
