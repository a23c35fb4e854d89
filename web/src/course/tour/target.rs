//! The things of the page that the tour points at.

use giveway_course::tour::Target;
use web_sys::{DomRect, Element};

/// Where a target is on the page: the first of these that is seen. On a phone some things
/// are behind a tab or in a menu; then that comes first.
fn places(target: Target) -> Vec<String> {
    let places: &[&str] = match target {
        Target::Play => &[".dock .playb"],
        Target::Cell(cell) => return vec![format!("#Board-{}-{}", cell.x, cell.y)],
        Target::Question => &[
            "#inspector section:not(.must-be-told) > h3 + .asks .ask",
            "[role=tab][aria-controls=inspector]",
        ],
        // While an answer is read a phone folds the tools away.
        Target::Obstacle => &[".tools [aria-keyshortcuts=o]", "#inspector .crumb"],
        Target::Solve => &[".solve > .btn"],
        Target::Zone => &[".tools [aria-keyshortcuts=z]", "#inspector .crumb"],
        Target::AddRule => &[
            "#inspector .foot .primary",
            "[role=tab][aria-controls=inspector]",
        ],
        Target::Price => &[
            "#inspector .ask-price",
            "#inspector .crumb",
            "[role=tab][aria-controls=inspector]",
        ],
        Target::Course => &[
            ".acts > .menu > button",
            ".acts > .wide",
            ".acts > .only-ph",
        ],
    };
    places.iter().map(|&place| place.to_owned()).collect()
}

/// The thing on the page, with its box on the screen; `None` where it is not there.
pub(in crate::course) fn find(target: Target) -> Option<(Element, DomRect)> {
    let document = gloo::utils::document();
    let found = places(target).into_iter().filter_map(|place| {
        let element = document.query_selector(&place).ok()??;
        let area = element.get_bounding_client_rect();
        (area.width() > 0.0).then_some((element, area))
    });
    found.into_iter().next()
}
