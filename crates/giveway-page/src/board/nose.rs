//! Noses: where robots face under a rule about turns, and the one by which a start is turned.

use giveway_model::constraint::{Heading, quarter_turn};
use giveway_model::{Agent, Cell, Scene};

use crate::{Draft, Phase, State, Tool};

/// The nose of the robot that is selected, at its start, where a hand can turn it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Nose {
    /// The robot, by its index in the scene.
    pub agent: usize,
    /// Where it starts.
    pub at: Cell,
    /// Where it faces there; `None` is open.
    pub heading: Option<Heading>,
}

/// In degrees from the right, clockwise.
pub const fn degrees(heading: Heading) -> f64 {
    match heading {
        Heading::East => 0.0,
        Heading::South => 90.0,
        Heading::West => 180.0,
        Heading::North => 270.0,
    }
}

/// The steps of a quarter turn of a robot; 0 where no rule is about that.
pub fn quarter(scene: &Scene, agent: &Agent) -> u32 {
    quarter_turn(&scene.constraints, &agent.name)
}

/// The steps of a quarter turn of each agent.
pub(super) fn quarters(draft: &Draft) -> Vec<u32> {
    let agents = draft.agents().iter();
    agents.map(|agent| quarter(draft.scene(), agent)).collect()
}

/// The nose that can be turned; nothing where turns are free, or something else is done.
pub fn nose(state: &State) -> Option<Nose> {
    let agent = state.selected_agent()?;
    let scene = state.document.draft.scene();
    let who = scene.agents.get(agent)?;
    let at_start = state.view.playback.time == 0 || state.playing().is_none();
    let is_edited = state.can_write_rules()
        && state.lesson().is_none()
        && state.view.tool == Tool::Select
        && state.phase() != Phase::Asking;
    (is_edited && at_start && quarter(scene, who) > 0).then_some(Nose {
        agent,
        at: who.start,
        heading: who.heading,
    })
}

/// Where a robot faces at each time, in degrees: it turns right before it goes on, as many steps as
/// the rule asks for. Nothing where it never faces anywhere, or turns are free.
pub(super) fn headings(scene: &Scene, agent: &Agent, path: &[Option<Cell>]) -> Option<Vec<f64>> {
    let quarter = quarter(scene, agent) as usize;
    if quarter == 0 {
        return None;
    }
    let stops = path.iter().enumerate();
    let stops: Vec<(usize, Cell)> = stops
        .filter_map(|(at, cell)| Some((at, (*cell)?)))
        .collect();
    let moves = stops.windows(2).filter_map(|pair| match pair {
        [(from, one), (to, other)] => Some((*from, *to, Heading::of(*one, *other)?)),
        _ => None,
    });
    let moves: Vec<(usize, usize, Heading)> = moves.collect();
    let mut facing = agent.heading.or(moves.first().map(|first| first.2))?;
    let mut all = vec![degrees(facing); path.len().max(1)];
    let mut stands = 0;
    for (from, to, heading) in moves {
        let steps = quarter * facing.quarters_to(heading) as usize;
        let begins = from.saturating_sub(steps).max(stands);
        let (before, after) = (degrees(facing), degrees(heading));
        // The shorter way round.
        let turn = (after - before + 540.0).rem_euclid(360.0) - 180.0;
        for (time, shown) in all.iter_mut().enumerate().skip(stands) {
            let share = if time >= from {
                1.0
            } else {
                time.saturating_sub(begins) as f64 / (from - begins).max(1) as f64
            };
            *shown = before + turn * share;
        }
        facing = heading;
        stands = to;
    }
    Some(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(quarter: u32, heading: Option<Heading>) -> Scene {
        let rules = format!(
            r#"{{ "giveway": 1, "map": ["...", "...", "..."],
                 "agents": [{{ "name": "A1", "start": [0, 0], "goal": [1, 1] }}],
                 "constraints": [{{ "kind": "turns", "quarter": {quarter} }}] }}"#
        );
        let mut scene: Scene = serde_json::from_str(&rules).unwrap();
        scene.agents[0].heading = heading;
        scene
    }

    /// Cells from words like `00 10 10 11`.
    fn path(cells: &str) -> Vec<Option<Cell>> {
        let cell = |at: &str| {
            let digit = |n: usize| u32::from(at.as_bytes()[n] - b'0');
            Cell::new(digit(0), digit(1))
        };
        cells.split(' ').map(|at| Some(cell(at))).collect()
    }

    fn faces(quarter: u32, heading: Option<Heading>, cells: &str) -> Option<Vec<f64>> {
        let scene = scene(quarter, heading);
        headings(&scene, &scene.agents[0], &path(cells))
    }

    #[test]
    fn it_turns_right_before_it_goes_on() {
        // East, then two steps for a quarter turn to the south.
        let shown = faces(2, None, "00 10 10 10 11").unwrap();
        assert_eq!(shown, [0.0, 0.0, 45.0, 90.0, 90.0]);
        // It waits first, and turns as late as it can.
        let shown = faces(1, None, "00 10 10 10 11").unwrap();
        assert_eq!(shown, [0.0, 0.0, 0.0, 90.0, 90.0]);
    }

    #[test]
    fn at_its_start_it_faces_as_it_was_set() {
        let north = Some(Heading::North);
        assert_eq!(faces(1, north, "00 00 10").unwrap(), [270.0, 360.0, 360.0]);
        assert_eq!(faces(1, north, "00").unwrap(), [270.0]);
        // Without a heading its first move decides, and without one nothing is shown.
        assert_eq!(faces(1, None, "00 00 01").unwrap(), [90.0, 90.0, 90.0]);
        assert_eq!(faces(1, None, "00"), None);
    }
}
