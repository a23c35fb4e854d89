//! Writes a `.map` and a `.scen`.

use crate::limits::refuse;
use std::fmt::Write as _;

use crate::loss::{self, Loss};
use giveway_model::format::text::shorten;
use giveway_model::{Fault, Grid, Instance, tr, tr_later};

/// Writes a map: vertices as `.`, obstacles as `@`.
///
/// ```
/// use giveway_formats::movingai::{read_map, write_map};
/// use giveway_model::Grid;
/// let grid = Grid::from_rows(&[".#.", "..."]).unwrap();
/// let text = write_map(&grid);
/// assert_eq!(text, "type octile\nheight 2\nwidth 3\nmap\n.@.\n...\n");
/// assert_eq!(read_map(&text), Ok(grid));
/// ```
pub fn write_map(grid: &Grid) -> String {
    let mut text = format!(
        "type octile\nheight {}\nwidth {}\nmap\n",
        grid.height(),
        grid.width()
    );
    let width = grid.width() as usize;
    for (i, (_, ground)) in grid.cells().enumerate() {
        text.push(if ground.is_vertex() { '.' } else { '@' });
        if (i + 1) % width == 0 {
            text.push('\n');
        }
    }
    text
}

/// Writes a scenario, an agent a line; `map_name` is the map's file name.
///
/// Bucket and length are written as 0: they are octile, of a map with
/// diagonals, and readers of multi-agent scenarios skip them. What is lost
/// besides, [`losses`] tells.
///
/// # Errors
/// When the map's name is empty or holds a tab or a line break, which no reader
/// could tell from the end of the column.
pub fn write_scenario(map_name: &str, instance: &Instance) -> Result<String, Fault> {
    if map_name.trim().is_empty() || map_name.contains(char::is_control) {
        let found = tr!("the map name \"{map_name}\"", map_name = shorten(map_name));
        return refuse(found, tr_later!("a name without tabs or line breaks"));
    }
    let grid = instance.grid();
    let mut text = String::from("version 1\n");
    for agent in instance.agents() {
        let goal = agent.goal_or_start();
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "0\t{map_name}\t{}\t{}\t{}\t{}\t{}\t{}\t0",
            grid.width(),
            grid.height(),
            agent.start.x,
            agent.start.y,
            goal.x,
            goal.y,
        );
    }
    Ok(text)
}

/// The parts of an instance that are lost in MovingAI files. The name of the instance is that of the files.
pub fn losses(instance: &Instance) -> Vec<Loss> {
    loss::losses(&[], Some(instance), None)
}
