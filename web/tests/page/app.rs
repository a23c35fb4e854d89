//! The page as a whole, in a document that has no solver to offer.

use giveway_web::App;
use wasm_bindgen_test::wasm_bindgen_test;
use web_sys::Element;

use crate::stage::{click, find, place, press, until};

fn text(place: &Element, selector: &str) -> String {
    let found = place.query_selector(selector).ok().flatten();
    let text = found.and_then(|element| element.text_content());
    text.unwrap_or_default()
}

#[wasm_bindgen_test]
async fn tells_that_it_has_no_solver_and_stays_usable() {
    let place = place();
    let app = yew::Renderer::<App>::with_root(place.clone()).render();
    // The scene that it opens on comes with its plan.
    until("the status", || {
        text(&place, "[role=status]").starts_with("Optimal: ")
    })
    .await;
    // It says so at once, and again when something is to be solved.
    let says_so = || text(&place, ".notice").contains("nothing can be solved");
    until("a notice at the beginning", says_so).await;
    click(&find(&place, ".notice button").await);
    until("it to go", || text(&place, ".notice").is_empty()).await;
    click(&find(&place, "[title^=Solve]").await);
    until("a notice", says_so).await;
    until("the plan that there was", || {
        text(&place, "[role=status]").starts_with("Optimal: ")
    })
    .await;
    click(&find(&place, ".notice button").await);
    until("the notice to go", || text(&place, ".notice").is_empty()).await;

    assert!(text(&place, "h1").starts_with("warehouse"));
    press(&find(&place, "[role=grid]").await, "o");
    find(&place, "[aria-label=Obstacle][aria-pressed=true]").await;
    app.destroy();
    place.remove();
}
