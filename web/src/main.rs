//! The page's Wasm: all that is shown. The solver is another program
//! (`worker.rs`), which arrives later.

fn main() {
    giveway_web::watch();
    let place = gloo::utils::document().get_element_by_id("page");
    let place = place.unwrap_or_else(|| gloo::utils::body().into());
    yew::Renderer::<giveway_web::App>::with_root(place).render();
}
