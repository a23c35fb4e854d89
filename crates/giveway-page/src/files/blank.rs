//! A new scene: a free map, and nobody on it.

use giveway_model::Scene;

use crate::MAX_SIDE;

/// An empty scene of a size that the page takes.
///
/// ```
/// use giveway_page::files::blank;
/// assert_eq!(blank("hall", 3, 2).map, ["...", "..."]);
/// assert_eq!(blank("hall", 0, 9999).map.len(), 2048);
/// ```
pub fn blank(name: &str, columns: u32, rows: u32) -> Scene {
    let side = |cells: u32| cells.clamp(1, MAX_SIDE) as usize;
    Scene {
        name: name.trim().to_owned(),
        map: vec![".".repeat(side(columns)); side(rows)],
        ..Scene::default()
    }
}
