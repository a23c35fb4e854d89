//! Scenes by name: each a whole document.

use giveway_model::{sorting, tr, tr_data};
use giveway_page::link::{self, Kin};
use giveway_page::{Action, FileAction, Moment, State};

use super::storage;

const SCENE: &str = "scene.";
/// The most scenes that are kept by name.
const MOST: usize = 100;

/// The names of the scenes that are kept, in order.
pub(crate) fn scenes() -> Vec<String> {
    let mut names = storage::names(SCENE);
    sorting::sort(&mut names);
    names
}

/// Keeps the scene under its name, in the place of one of that name; whether that
/// could be done.
pub(crate) fn keep_scene(state: &State) -> bool {
    let name = &state.document.draft.scene().name;
    let names = scenes();
    let has_room = names.len() < MOST || names.contains(name);
    // What a newer version of the page wrote is not overwritten.
    let is_newer = load(name).is_some_and(|text| link::is_newer(&text));
    has_room && !is_newer && store(name, &link::keep_moment(&state.moment()))
}

/// Keeps a document beside all others, under its name with a remark; whether it is
/// kept there now.
pub(super) fn keep_beside(moment: &Moment, remark: &str) -> bool {
    let text = link::keep_moment(moment);
    let title = moment.document.draft.scene().name.trim();
    let title = if title.is_empty() {
        tr!("Untitled")
    } else {
        title
    };
    for number in 1..=MOST {
        let name = match number {
            1 => format!("{title} ({remark})"),
            _ => format!("{title} ({remark} {number})"),
        };
        match load(&name) {
            Some(other) if link::kin(&text, &other) == Kin::Same => return true,
            Some(_) => {}
            None => return scenes().len() < MOST && store(&name, &text),
        }
    }
    false
}

/// Opens a scene that was kept.
pub(crate) fn scene(name: &str) -> Action {
    open(&load(name).unwrap_or_default())
}

/// Opens a document that was kept.
pub(super) fn open(text: &str) -> Action {
    Action::File(match link::kept_moment(text) {
        Ok(moment) => FileAction::Resume(Box::new(moment)),
        Err(notice) => FileAction::Tell(notice.under(tr_data!(
            "The scene cannot be opened. It stays where it is."
        ))),
    })
}

/// Forgets a scene that was kept.
pub(crate) fn forget_scene(name: &str) {
    storage::forget(&format!("{SCENE}{name}"));
}

fn load(name: &str) -> Option<String> {
    storage::load(&format!("{SCENE}{name}"))
}

fn store(name: &str, text: &str) -> bool {
    storage::store(&format!("{SCENE}{name}"), text).is_ok()
}
