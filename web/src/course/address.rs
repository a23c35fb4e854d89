//! The address while a lesson is open: it names the lesson and its step, so that a page
//! that is loaded anew opens them again.

use giveway_course::learner::Open;
use giveway_course::lesson::link;
use wasm_bindgen::JsValue;

/// How the part of the address begins that names a lesson.
const LESSON: &str = "#lesson=";
/// The most letters of a whole lesson in an address; a longer one is found by its name.
const MOST: usize = 8000;

/// Names the lesson that is open; one that is tried while it is written has no name.
pub(super) fn show(open: Option<&Open>) {
    let window = gloo::utils::window();
    let location = window.location();
    let hash = match open.filter(|open| !open.is_tried()) {
        Some(open) => place(open),
        None if location.hash().is_ok_and(|hash| hash.starts_with(LESSON)) => String::new(),
        // What stands there is none of ours.
        None => return,
    };
    if let (Ok(path), Ok(query), Ok(history)) =
        (location.pathname(), location.search(), window.history())
    {
        let address = path + &query + &hash;
        // Where it is refused a page that is loaded anew opens without the lesson.
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
    }
}

fn place(open: &Open) -> String {
    let at = open.index();
    if open.id.is_own() {
        let letters = link::write(&open.lesson, Some(at));
        if letters.len() <= MOST {
            return format!("{LESSON}{letters}");
        }
    }
    format!("{LESSON}{}.{}", open.id, at + 1)
}
