//! Files that need what is on the board: a plan alone is judged against the scene, a
//! scenario alone is used with the map.

use super::{Kind, Opened, Reading, course, read, scenario, scene_file, text};
use crate::{Notice, State};

/// Reads files as [`read`] does; one that lacks its scene or its map takes it from
/// the board, where it fits.
///
/// # Errors
/// As [`read`].
///
/// ```
/// use giveway_page::files::{Opened, Reading, blank, read_beside};
/// use giveway_page::{Draft, State};
/// let state = State::new(Draft::new(blank("hall", 8, 8)).unwrap());
/// let line = "version 1\n0 hall.map 8 8 0 0 7 7 14\n";
/// let file = Opened { name: "hall.scen".into(), bytes: line.into() };
/// assert!(matches!(read_beside(&state, &[file]), Ok(Reading::Scenario(_))));
/// ```
pub fn read_beside(state: &State, files: &[Opened]) -> Result<Reading, Notice> {
    let [file] = files else { return read(files) };
    let content = text(file)?;
    match Kind::of(&file.name, content) {
        Kind::Json if course::is_plan(content) => {
            let scene = scene_file(state);
            let scene = Opened {
                name: scene.name,
                bytes: scene.text.into_bytes(),
            };
            read(&[scene, file.clone()])
        }
        Kind::Scenario => {
            let grid = state.document.draft.grid().clone();
            let size = format!(
                "the map on the board is {} x {}",
                grid.width(),
                grid.height()
            );
            scenario::on(grid, (file, content)).map_err(|unfit| {
                // What is wrong with the file itself is told as such.
                let mut alone = read(files).err().unwrap_or(unfit);
                alone.details.push(size);
                alone
            })
        }
        _ => read(files),
    }
}
