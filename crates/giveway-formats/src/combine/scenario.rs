//! The scene of a map and a scenario, some lines of which may be no task on the map.
//!
//! LaCAM leaves out lines whose start or goal is an obstacle. Where a plan lies beside such a
//! scenario, so does this reader, or it takes the tasks from the plan; without a plan all
//! such lines are faults.

use super::Refused;
use super::scene::First;
use crate::movingai::{Scenario, to_scene};
use giveway_model::format::stem;
use giveway_model::{Fault, Grid, Scene, tr};

/// The tasks of a scenario.
pub(super) enum Tasks {
    /// A scene, with sentences about it.
    Scene(Scene, Vec<String>),
    /// The plan beside it has to say the tasks; a sentence why.
    FromPlan(String),
}

/// The scene of a scenario for so many agents as the plan has, else `agents`.
///
/// # Errors
/// Every line that is no task, where no plan helps.
pub(super) fn tasks(
    file: &str,
    grid: &Grid,
    scenario: &Scenario,
    plan: Option<First<'_>>,
    agents: Option<usize>,
) -> Result<Tasks, Refused> {
    let name = stem(file);
    let wanted = plan.map(|it| it.plan.agents.len()).or(agents);
    let fault = match to_scene(name, grid, scenario, wanted) {
        Ok(scene) => return Ok(Tasks::Scene(scene, Vec::new())),
        Err(fault) => fault,
    };
    let mut good = Scenario::default();
    let (mut lines, mut faults) = (Vec::new(), Vec::new());
    let looked_at = plan.map_or_else(|| agents.unwrap_or(usize::MAX), |_| usize::MAX);
    for route in scenario.routes.iter().take(looked_at) {
        if wanted == Some(good.routes.len()) {
            break;
        }
        match alone(grid, route) {
            None => good.routes.push(route.clone()),
            Some(fault) => {
                lines.push(route.line.to_string());
                faults.push(fault);
            }
        }
    }
    if good.routes.is_empty() {
        // All lines at once are wrong where the map is another one.
        faults.clear();
    }
    let refused = Refused::File {
        file: file.to_owned(),
        faults: if faults.is_empty() {
            vec![fault]
        } else {
            faults
        },
    };
    let Some(First { plan, .. }) = plan else {
        return Err(refused);
    };
    let has_tasks = |agent: &crate::WrittenAgent| agent.start.is_some() && agent.goal.is_some();
    if !lines.is_empty() && plan.agents.iter().all(has_tasks) {
        return Ok(Tasks::FromPlan(tr!(
            "Starts and goals are those of the plan's file, since lines of {file} are no tasks on the map: {lines}.",
            file,
            lines = lines.join(", ")
        )));
    }
    let scene = to_scene(name, grid, &good, wanted).map_err(|_| refused)?;
    let note = tr!(
        "Lines of {file} whose start or goal is not free are left out, as LaCAM does: {lines}.",
        file,
        lines = lines.join(", ")
    );
    Ok(Tasks::Scene(scene, vec![note]))
}

/// The fault of a line by itself.
fn alone(grid: &Grid, route: &crate::movingai::Route) -> Option<Fault> {
    let one = Scenario {
        routes: vec![route.clone()],
        lacks_version: false,
    };
    to_scene("", grid, &one, Some(1)).err()
}
