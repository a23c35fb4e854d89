//! The check of a task to edit the scene: a search over single edits of cells.

use giveway_model::{Ground, Instance, Scene};

use super::examine::{Asked, Next};
use super::{Finding, Problem};
use crate::judge::condition::{self, Held};
use crate::judge::{Did, Situation};
use crate::lesson::Tool;
use crate::lesson::task::Paint;

/// The most edits that are tried.
const MOST: usize = 120;

/// The start must not be solved, and one edit must solve it, else the author has to.
pub(super) fn search(
    task: &Paint,
    start: Situation<'_>,
    is_tried: bool,
    asked: &mut Asked<'_>,
) -> Next {
    let outcome = match condition::requests(&task.until, start) {
        Ok(requests) => condition::decide(&task.until, start, asked.all(requests)?),
        Err(why) => return Ok(Finding::of(why)),
    };
    match outcome.held {
        Held::Yes => return Ok(Problem::StartSolved.into()),
        Held::Unknown => return Ok(Finding::of(outcome.why)),
        Held::No if is_tried => return Ok(Finding::Passed),
        Held::No => {}
    }
    for scene in edited(start).take(MOST) {
        let now = Situation {
            scene: &scene,
            ..start
        };
        if asked.judge(now, &Did::Edits)?.is_solved() {
            return Ok(Finding::Passed);
        }
    }
    Ok(Problem::Unsolved.into())
}

/// The scenes that one edit of a cell makes, where the step allows the tool and the cell.
fn edited(start: Situation<'_>) -> impl Iterator<Item = Scene> {
    let Situation { step, scene, .. } = start;
    let rows = scene.map.iter().enumerate();
    let cells = rows.flat_map(|(y, row)| {
        let cells = row.chars().enumerate();
        cells.map(move |(x, c)| (x, y, c))
    });
    let allowed = cells.filter(move |(x, y, _)| {
        let is_here = |x: usize, at: u32| u32::try_from(x) == Ok(at);
        let mut cells = step.cells.iter().flatten();
        step.cells.is_none() || cells.any(|cell| is_here(*x, cell.x) && is_here(*y, cell.y))
    });
    let edits = allowed.flat_map(move |(x, y, c)| {
        let tools = step.tools.iter().flat_map(move |tool| made(*tool, c));
        tools.map(move |c| (x, y, c))
    });
    edits.filter_map(move |(x, y, c)| {
        let mut scene = scene.clone();
        let row = scene.map.get_mut(y)?;
        *row = (row.chars().enumerate())
            .map(|(at, old)| if at == x { c } else { old })
            .collect();
        Instance::new(scene.clone()).is_ok().then_some(scene)
    })
}

/// What a tool makes of a cell with this letter.
fn made(tool: Tool, c: char) -> Option<char> {
    let was = Ground::from_char(c)?;
    let is = match tool {
        Tool::Obstacle if was == Ground::Obstacle => Ground::Free,
        Tool::Obstacle => Ground::Obstacle,
        Tool::Charger if was == Ground::Slow => Ground::SlowCharger,
        Tool::Charger => Ground::Charger,
        Tool::SlowZone if was == Ground::Charger => Ground::SlowCharger,
        Tool::SlowZone => Ground::Slow,
        Tool::Erase => Ground::Free,
        // Robots and what belongs to them have too many places for a search.
        Tool::Move | Tool::Robot | Tool::Goal | Tool::Waypoint => return None,
    };
    (is != was).then(|| is.to_char())
}
