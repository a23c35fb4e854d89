//! A scene and its plans as one line of text, the part of a link behind `#`, as the
//! page reads and writes it.
//!
//! ```text
//! giveway=1&map=10.2f6s2f...&name=warehouse&rules=0.0&costs=012&agents=A1.0.0.9.2!10.10;...
//! &audit=1-AQ...!l2rR...;...
//! ```

pub mod audit;
pub mod message;
pub mod plan;
pub mod scene;
pub mod text;

use super::foreign::ForeignPlan;
use crate::Scene;

/// The longest text that the page reads, in bytes.
pub const LONGEST: usize = 1_000_000;
/// The largest side of a map that the page takes, in cells.
pub const MAX_SIDE: u32 = 512;
/// The most agents that the page takes.
pub const MAX_AGENTS: usize = 1000;

/// A text that opens a plan of elsewhere on its scene, with `notes` about the scene;
/// `None` where the page does not take them: the map is too large, there are too many
/// agents, or the text would be too long.
///
/// ```
/// use giveway_model::format::foreign::{Options, Source, gather};
/// use giveway_model::format::link;
/// let map = Source { name: "a.map", text: "type octile\nheight 1\nwidth 3\nmap\n...\n" };
/// let plan = Source { name: "a.txt", text: "Agent 0: (0,0)->(0,1)->\n" };
/// let read = gather(&[map, plan], &Options::default()).unwrap();
/// let scene = read.instance.to_scene();
/// let text = link::audited(&scene, &read.plans[0], &read.notes).unwrap();
/// assert!(text.starts_with("giveway=1&map=3.3f&name=a&"));
/// ```
pub fn audited(scene: &Scene, plan: &ForeignPlan, notes: &[String]) -> Option<String> {
    let rows = scene.map.iter();
    let side = rows.map(|row| row.chars().count()).chain([scene.map.len()]);
    let is_large = side.max() > Some(MAX_SIDE as usize);
    if is_large || scene.agents.len() > MAX_AGENTS {
        return None;
    }
    let told = audit::Told {
        files: vec![plan.clone()],
        notes: notes.to_vec(),
        chosen: 0,
        beside: 0,
    };
    let mut text = scene::write(scene);
    text += "&audit=";
    text += &audit::write(&scene.agents, told, None);
    (text.len() <= LONGEST).then_some(text)
}
