//! Files that are opened by the page itself, some of which need what is on the board: a
//! scenario alone is used with its map.

use giveway_model::tr_data;

use super::{Kind, Opened, Reading, read_here, scenario, text};
use crate::{Notice, State, intake};

/// The text of a file that is a lesson by a look at it. The course reads it.
fn lesson(files: &[Opened]) -> Option<String> {
    let [file] = files else {
        return None;
    };
    let text = text(file).ok()?;
    let keys = ["\"giveway\"", "\"title\"", "\"steps\""];
    let is_lesson = keys.iter().all(|key| text.contains(key));
    is_lesson.then(|| text.into_owned())
}

/// Whether some of the files is a hand-in of a lesson, or a list of links to such, by a look at
/// it: the course reads them all.
///
/// ```
/// use giveway_page::files::{Opened, are_hand_ins};
/// let file = |text: &str| Opened { name: "a.txt".into(), bytes: text.into() };
/// assert!(are_hand_ins(&[file("{}"), file("> { \"giveway\": 1, \"hand-in\": {} }")]));
/// assert!(are_hand_ins(&[file("https://example.org/#hand-in=~Xy")]));
/// assert!(!are_hand_ins(&[file(r#"{ "giveway": 1, "name": "hand-in" }"#)]));
/// ```
pub fn are_hand_ins(files: &[Opened]) -> bool {
    let is_one = |text: &str| text.contains("\"hand-in\":") || text.contains("hand-in=~");
    files
        .iter()
        .any(|file| text(file).is_ok_and(|text| is_one(&text)))
}

/// Reads files that the page reads by itself; a scenario that lacks its map takes that
/// of the board, where it fits. `None` where the files are for the reader.
///
/// ```
/// use giveway_page::files::{Opened, Reading, blank, read_beside};
/// use giveway_page::{Draft, State};
/// let state = State::new(Draft::new(blank("hall", 8, 8)).unwrap());
/// let file = |name: &str, text: &str| Opened { name: name.into(), bytes: text.into() };
/// let scenario = file("hall.scen", "version 1\n0 hall.map 8 8 0 0 7 7 14\n");
/// assert!(matches!(read_beside(&state, &[scenario]), Some(Ok(Reading::Scenario(_)))));
/// assert_eq!(read_beside(&state, &[file("a.json", "{}")]), None);
/// let lesson = file("a.json", r#"{ "giveway": 1, "title": "T", "steps": [] }"#);
/// assert!(matches!(read_beside(&state, &[lesson]), Some(Ok(Reading::Lesson(_)))));
/// ```
pub fn read_beside(state: &State, files: &[Opened]) -> Option<Result<Reading, Notice>> {
    if let Some(lesson) = lesson(files) {
        return Some(Ok(Reading::Lesson(lesson)));
    }
    if intake::is_for_reader(state, files) {
        return None;
    }
    let [file] = files else {
        return read_here(files);
    };
    let content = match text(file) {
        Ok(content) => content,
        Err(notice) => return Some(Err(notice)),
    };
    if Kind::of(&file.name, &content) != Kind::Scenario {
        return read_here(files);
    }
    let grid = state.document.draft.grid().clone();
    let size = tr_data!(
        "the map on the board is {width} x {height}",
        width = grid.width(),
        height = grid.height()
    );
    let read = scenario::on(grid, (file, &content)).map_err(|unfit| {
        // What is wrong with the file itself is told as such.
        let alone = read_here(files).and_then(Result::err);
        alone.unwrap_or(unfit).with([size])
    });
    Some(read)
}
