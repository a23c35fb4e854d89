//! Light or dark: an attribute of the root, which the style sheets read.

use giveway_page::Theme;
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
