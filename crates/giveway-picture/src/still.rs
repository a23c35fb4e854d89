//! A plan at a time, as SVG.

use giveway_model::{Instance, Plan};

use crate::Look;
use crate::draw::Stage;

/// The picture of a plan at a time, which need not be whole: the map, where each agent
/// is, the way behind it and ahead. After its end a plan stands still.
///
/// The plan may break rules; agents that it does not know stand at their starts.
///
/// ```
/// use giveway_model::format::native;
/// use giveway_picture::{Look, still};
/// let instance = native::read_instance(r#"{
///     "giveway": 1,
///     "map": ["..."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }]
/// }"#).unwrap();
/// let plan = native::read_plan(r#"{
///     "giveway": 1,
///     "paths": { "A1": [[0, 0], [1, 0], [2, 0]] }
/// }"#).unwrap();
/// let svg = still(&instance, &plan, 1.0, &Look::fitting(instance.grid(), 500));
/// assert!(svg.starts_with("<svg") && svg.contains(">A1<"));
/// ```
pub fn still(instance: &Instance, plan: &Plan, time: f64, look: &Look) -> String {
    let stage = Stage::new(instance, plan, look);
    let time = within(&stage, time);
    let shapes = [stage.floor(), stage.ways_at(time), stage.at(time)].concat();
    let title = format!("{}, step {time}", stage.title());
    stage.svg(&title, &stage.at_words(time), "", &shapes)
}

/// The same for paper: with the numbers of columns and rows, and without the line of the
/// time, which nobody can move there.
pub fn on_paper(instance: &Instance, plan: &Plan, time: f64, look: &Look) -> String {
    let stage = Stage::new(instance, plan, look);
    let time = within(&stage, time);
    let shapes = [
        stage.floor(),
        stage.ways_at(time),
        stage.things_at(time),
        stage.numbers(),
    ]
    .concat();
    let title = format!("{}, step {time}", stage.title());
    stage.svg(&title, &stage.at_words(time), "", &shapes)
}

/// A time of the plan.
fn within(stage: &Stage, time: f64) -> f64 {
    let time = if time.is_finite() { time.max(0.0) } else { 0.0 };
    time.min(f64::from(stage.steps))
}
