//! All of the Wasm: the page, and in a worker the solver.
//!
//! One file for both, since much of it is the same: so it is fetched and
//! compiled once, and a worker starts with what the page has compiled.

fn main() {
    if web_sys::window().is_none() {
        giveway_wasm::serve_messages();
        return;
    }
    giveway_web::watch();
    let place = gloo::utils::document().get_element_by_id("page");
    let place = place.unwrap_or_else(|| gloo::utils::body().into());
    yew::Renderer::<giveway_web::App>::with_root(place).render();
}
