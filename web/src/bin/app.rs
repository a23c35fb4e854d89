//! The page's own part of the Wasm: shows the page.

fn main() {
    let place = gloo::utils::document().get_element_by_id("page");
    let place = place.unwrap_or_else(|| gloo::utils::body().into());
    yew::Renderer::<giveway_web::App>::with_root(place).render();
}
