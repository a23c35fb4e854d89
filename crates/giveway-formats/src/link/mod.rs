//! Links that open a plan of elsewhere on its scene.

pub mod audit;

use giveway_model::format::link::{LONGEST, MAX_AGENTS, MAX_SIDE, plan, scene, seal};
use giveway_model::{Plan, Scene};

use crate::ForeignPlan;

/// A text that opens a plan of elsewhere on its scene, with `notes` about the scene;
/// `None` where the page does not take them: the map is too large, there are too many
/// agents, or the text would be too long.
///
/// ```
/// use giveway_formats::{Options, Source, combine};
/// use giveway_formats::link;
/// let map = Source { name: "a.map", text: "type octile\nheight 1\nwidth 3\nmap\n...\n" };
/// let plan = Source { name: "a.txt", text: "Agent 0: (0,0)->(0,1)->\n" };
/// let read = combine(&[map, plan], &Options::default()).unwrap();
/// let scene = read.instance.to_scene();
/// let text = link::audited(&scene, &read.plans[0], &read.notes).unwrap();
/// assert!(text.starts_with("giveway=1&check=") && text.contains("&map=3.3f&name=a&"));
/// ```
pub fn audited(scene: &Scene, plan: &ForeignPlan, notes: &[String]) -> Option<String> {
    if is_large(scene) {
        return None;
    }
    let audited = audit::AuditedPlans {
        files: vec![plan.clone()],
        notes: notes.to_vec(),
        chosen: 0,
        beside: 0,
    };
    let mut text = scene::write(scene);
    text += "&audit=";
    text += &audit::write(&scene.agents, audited, None);
    let text = seal::write(&text);
    (text.len() <= LONGEST).then_some(text)
}

/// A text that opens a plan of the scene's own; `None` where the page does not take it.
pub fn planned(scene: &Scene, plan: &Plan) -> Option<String> {
    if is_large(scene) {
        return None;
    }
    let plan = plan::write(&scene.agents, plan)?;
    let text = seal::write(&format!("{}&plan={plan}", scene::write(scene)));
    (text.len() <= LONGEST).then_some(text)
}

/// Whether the page takes no such map, or not so many agents.
fn is_large(scene: &Scene) -> bool {
    let rows = scene.map.iter();
    let side = rows.map(|row| row.chars().count()).chain([scene.map.len()]);
    side.max() > Some(MAX_SIDE as usize) || scene.agents.len() > MAX_AGENTS
}
