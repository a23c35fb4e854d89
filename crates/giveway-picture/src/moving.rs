//! A plan that moves, as SVG.

use giveway_model::{Instance, Plan};

use crate::Look;
use crate::draw::{Motion, Stage};

/// The picture of a plan that moves by itself, again and again, with a rest at the end;
/// it stands still at the start for those who want less motion.
///
/// Its motion is style alone, without any script: an animation for each thing that
/// changes, with a key only where it turns or waits.
pub fn moving(instance: &Instance, plan: &Plan, look: &Look) -> String {
    let stage = Stage::new(instance, plan, look);
    let mut motion = Motion::new(stage.prefix(), stage.steps);
    let shapes = [
        stage.floor(),
        stage.whole_ways(),
        stage.in_motion(&mut motion),
    ];
    let title = stage.title();
    stage.svg(
        &title,
        &stage.moving_words(),
        &motion.style(),
        &shapes.concat(),
    )
}
